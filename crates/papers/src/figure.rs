//! Figures of a paper beside ours: one row a figure.

use serde::{Deserialize, Serialize};
use std::io::{self, BufRead, Write};

/// One figure that a paper prints, with the same figure measured here. `ratio` is always `ours / paper`: it is computed
/// when the row is made or read, so it cannot disagree.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(from = "StoredFigure", into = "StoredFigure")]
pub struct Figure {
    /// Name of the method.
    pub method: String,
    /// Which table or figure of the paper, as printed there.
    pub table: String,
    /// Which row of it.
    pub row: String,
    /// What is measured.
    pub metric: String,
    /// Unit of both values.
    pub unit: String,
    /// The paper's value; `None` where it prints none.
    pub paper: Option<f64>,
    /// Our value; `None` where it could not be measured.
    pub ours: Option<f64>,
    /// Whether the two may be compared: a time on other hardware may not.
    pub comparable: bool,
    /// What a reader has to know: another model, another machine, a guess.
    pub note: String,
}

impl Figure {
    /// `ours / paper`; `None` where a value is missing or the quotient is not finite.
    pub fn ratio(&self) -> Option<f64> {
        let ratio = self.ours? / self.paper?;
        ratio.is_finite().then_some(ratio)
    }
}

/// [`Figure`] as a row of a file.
#[derive(Debug, Clone, Serialize, Deserialize)]
struct StoredFigure {
    method: String,
    table: String,
    row: String,
    metric: String,
    unit: String,
    paper: Option<f64>,
    ours: Option<f64>,
    #[serde(default)]
    ratio: Option<f64>,
    comparable: bool,
    note: String,
}

impl From<StoredFigure> for Figure {
    fn from(stored: StoredFigure) -> Self {
        let StoredFigure { method, table, row, metric, unit, paper, ours, ratio: _, comparable, note } = stored;
        Self { method, table, row, metric, unit, paper, ours, comparable, note }
    }
}

impl From<Figure> for StoredFigure {
    fn from(figure: Figure) -> Self {
        let ratio = figure.ratio();
        let Figure { method, table, row, metric, unit, paper, ours, comparable, note } = figure;
        Self { method, table, row, metric, unit, paper, ours, ratio, comparable, note }
    }
}

/// Why a table of figures could not be read.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum TableError {
    /// The file could not be read.
    #[error(transparent)]
    Io(#[from] io::Error),
    /// A line is no figure.
    #[error("line {line}: {source}")]
    Line {
        /// The line, from 1.
        line: usize,
        /// What is wrong with it.
        source: serde_json::Error,
    },
}

/// Writes figures as JSON Lines.
///
/// # Errors
/// Whatever `out` reports.
pub fn write_figures(figures: &[Figure], mut out: impl Write) -> io::Result<()> {
    for figure in figures {
        serde_json::to_writer(&mut out, figure)?;
        out.write_all(b"\n")?;
    }
    Ok(())
}

/// Reads figures from JSON Lines; empty lines are skipped, a stored ratio is ignored.
///
/// # Errors
/// [`TableError`] names the first line that is no figure.
pub fn read_figures(input: impl BufRead) -> Result<Vec<Figure>, TableError> {
    let mut figures = Vec::new();
    for (index, line) in input.lines().enumerate() {
        let line = line?;
        if !line.trim().is_empty() {
            let figure = serde_json::from_str(&line).map_err(|source| TableError::Line { line: index + 1, source })?;
            figures.push(figure);
        }
    }
    Ok(figures)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn figure(paper: Option<f64>, ours: Option<f64>) -> Figure {
        let text = |text: &str| text.to_owned();
        Figure {
            method: text("brute-force"),
            table: text("Table 1"),
            row: text("sphere, 320 faces"),
            metric: text("edges tested"),
            unit: text("edges"),
            paper,
            ours,
            comparable: true,
            note: String::new(),
        }
    }

    #[test]
    fn figures_survive_a_file() {
        let figures = [figure(Some(4.0), Some(6.0)), figure(None, Some(1.0)), figure(Some(0.0), Some(1.0))];
        let mut file = Vec::new();
        write_figures(&figures, &mut file).unwrap();
        assert_eq!(read_figures(&file[..]).unwrap(), figures);
        let text = String::from_utf8(file).unwrap();
        let row: serde_json::Value = serde_json::from_str(text.lines().next().unwrap()).unwrap();
        let keys = ["method", "table", "row", "metric", "unit", "paper", "ours", "ratio", "comparable", "note"];
        assert!(keys.iter().all(|key| row.get(key).is_some()) && row.as_object().unwrap().len() == keys.len());
        assert_eq!(row["ratio"], 1.5);
    }

    #[test]
    fn a_wrong_stored_ratio_is_not_believed() {
        let mut row = serde_json::to_value(figure(Some(2.0), Some(1.0))).unwrap();
        row["ratio"] = 99.0.into();
        let read = read_figures(row.to_string().as_bytes()).unwrap();
        assert_eq!(read[0].ratio(), Some(0.5));
        assert_eq!(figure(Some(0.0), Some(1.0)).ratio(), None);
    }

    #[test]
    fn a_bad_line_is_named() {
        let text = format!("{}\n\nnonsense\n", serde_json::to_string(&figure(None, None)).unwrap());
        assert!(read_figures(text.as_bytes()).unwrap_err().to_string().starts_with("line 3: "));
    }
}
