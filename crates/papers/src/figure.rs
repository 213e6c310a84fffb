//! Figures of a paper beside ours: the cells of tables as rows of a file, in JSON Lines and in CSV.
//!
//! ```json
//! {"method","table","row","metric","unit","paper","ours","ratio","comparable","note"}
//! ```
//!
//! | key | holds |
//! |---|---|
//! | `method` | name of the paper on the command line |
//! | `table` | which table or section of the paper, as printed there |
//! | `row`, `metric`, `unit` | what is measured; a range has three rows: `METRIC` for its median, `METRIC, least`, `METRIC, most` |
//! | `paper` | the printed value, null where there is none |
//! | `ours` | the measured value, null where it was not measured |
//! | `ratio` | ours / paper; null unless `comparable` |
//! | `comparable` | whether both values exist, and only the method differs between them |
//! | `note` | why a printed value is not comparable; what else has to be known |
//!
//! In CSV the keys are the names of the columns, in this order, and what is null is empty.

use crate::table::{Cell, Comparable, Ours, Printed, Table};
use serde::Serialize;
use std::io::{self, Write};

/// One figure: a row of the file.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Figure {
    /// Name of the paper on the command line.
    pub method: String,
    /// Which table or section of the paper, as printed there.
    pub table: String,
    /// Which row of it.
    pub row: String,
    /// What is measured.
    pub metric: String,
    /// Unit of both values; × for ratios.
    pub unit: String,
    /// The paper's value; `None` where it prints none.
    pub paper: Option<f64>,
    /// Our value; `None` where it was not measured.
    pub ours: Option<f64>,
    /// `ours / paper` where the two are comparable.
    pub ratio: Option<f64>,
    /// Whether both values exist and only the method differs between them.
    pub comparable: bool,
    /// Why a printed value is not comparable, and what else has to be known.
    pub note: String,
}

/// The keys of a row, in the order of [`Figure`]'s fields.
pub const COLUMNS: [&str; 10] =
    ["method", "table", "row", "metric", "unit", "paper", "ours", "ratio", "comparable", "note"];

/// Every figure of some tables, in their order.
pub fn figures(method: &str, tables: &[Table]) -> Vec<Figure> {
    tables.iter().flat_map(|table| of_table(method, table)).collect()
}

fn of_table(method: &str, table: &Table) -> Vec<Figure> {
    let mut figures = Vec::new();
    for row in &table.rows {
        for (column, cell) in table.columns.iter().zip(&row.cells) {
            if cell.ours.is_none() && cell.paper.is_none() {
                continue;
            }
            let middle = Figure {
                method: method.to_owned(),
                table: table.name.to_owned(),
                row: table.row_name(row),
                metric: column.metric.to_owned(),
                unit: column.unit.to_owned(),
                paper: cell.paper.as_ref().map(|printed| printed.value),
                ours: cell.ours.map(Ours::middle),
                ratio: ratio(cell),
                comparable: is_comparable(cell),
                note: note(cell, row.remark),
            };
            let Some(Ours::Range(range)) = cell.ours else {
                figures.push(middle);
                continue;
            };
            let end = |name: &str, value: f64| Figure {
                metric: format!("{}, {name}", column.metric),
                paper: None,
                ours: Some(value),
                ratio: None,
                comparable: false,
                note: format!("{name} over {}", range.over),
                ..middle.clone()
            };
            let ends = [end("least", range.least), end("most", range.most)];
            figures.push(middle);
            figures.extend(ends);
        }
    }
    figures
}

fn is_comparable(cell: &Cell) -> bool {
    matches!((cell.ours, &cell.paper), (Some(_), Some(Printed { comparable: Comparable::Yes, .. })))
}

fn ratio(cell: &Cell) -> Option<f64> {
    let (ours, printed) = (cell.ours?, cell.paper.as_ref()?);
    let ratio = ours.middle() / printed.value;
    (is_comparable(cell) && ratio.is_finite()).then_some(ratio)
}

fn note(cell: &Cell, remark: &str) -> String {
    let mut parts = Vec::new();
    if let (Some(_), Some(Printed { comparable: Comparable::No(reason), .. })) = (cell.ours, &cell.paper) {
        parts.push(format!("not comparable: {reason}"));
    }
    if let Some(Ours::Range(range)) = cell.ours {
        parts.push(format!("median over {}", range.over));
    }
    parts.extend([cell.note.as_str(), remark].into_iter().filter(|part| !part.is_empty()).map(str::to_owned));
    parts.join("; ")
}

/// Writes figures as JSON Lines.
///
/// # Errors
/// Those of `out`.
pub fn write_figures(figures: &[Figure], mut out: impl Write) -> io::Result<()> {
    for figure in figures {
        serde_json::to_writer(&mut out, figure)?;
        out.write_all(b"\n")?;
    }
    Ok(())
}

/// Writes figures as CSV, the names of the columns first, also where there is no figure.
///
/// # Errors
/// Those of `out`.
pub fn write_figures_csv(figures: &[Figure], out: impl Write) -> io::Result<()> {
    let mut out = csv::WriterBuilder::new().has_headers(false).from_writer(out);
    out.write_record(COLUMNS)?;
    for figure in figures {
        out.serialize(figure)?;
    }
    out.flush()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::table::tests::table;

    #[test]
    fn each_value_is_a_row_of_the_documented_keys() {
        let figures = figures("method", &[table()]);
        let mut file = Vec::new();
        write_figures(&figures, &mut file).unwrap();
        let text = String::from_utf8(file).unwrap();
        let rows: Vec<serde_json::Value> = text.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
        for row in &rows {
            assert!(COLUMNS.iter().all(|key| row.get(key).is_some()));
            assert_eq!(row.as_object().unwrap().len(), COLUMNS.len());
        }
        let metrics: Vec<_> = rows.iter().map(|row| row["metric"].as_str().unwrap()).collect();
        assert_eq!(metrics, ["width", "width, least", "width, most", "frame time", "width"]);
        assert_eq!(rows[0]["note"], "median over three views; a note; as printed");
        assert_eq!(rows[0]["row"], "<b>mesh</b>, printed row");
    }

    #[test]
    fn both_files_say_the_same() {
        let figures = figures("method", &[table()]);
        let (mut lines, mut table) = (Vec::new(), Vec::new());
        write_figures(&figures, &mut lines).unwrap();
        write_figures_csv(&figures, &mut table).unwrap();
        let lines = String::from_utf8(lines).unwrap();
        let objects: Vec<serde_json::Value> = lines.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
        let mut table = csv::Reader::from_reader(&table[..]);
        assert_eq!(table.headers().unwrap(), COLUMNS.as_slice());
        let rows: Vec<csv::StringRecord> = table.records().map(Result::unwrap).collect();
        assert_eq!(rows.len(), objects.len());
        for (row, object) in rows.iter().zip(&objects) {
            for (key, cell) in COLUMNS.iter().zip(row) {
                match &object[key] {
                    serde_json::Value::Null => assert_eq!(cell, "", "{key}"),
                    serde_json::Value::String(text) => assert_eq!(cell, text, "{key}"),
                    serde_json::Value::Number(number) => assert_eq!(cell.parse().ok(), number.as_f64(), "{key}"),
                    other => assert_eq!(cell, other.to_string(), "{key}"),
                }
            }
        }
        assert!(rows.iter().any(|row| row.iter().any(str::is_empty)) && rows[0][2].contains(','), "{rows:?}");
    }

    #[test]
    fn a_table_without_figures_still_names_its_columns() {
        let mut file = Vec::new();
        write_figures_csv(&[], &mut file).unwrap();
        assert_eq!(String::from_utf8(file).unwrap(), format!("{}\n", COLUMNS.join(",")));
    }

    #[test]
    fn a_ratio_stands_where_the_two_are_comparable_and_a_reason_elsewhere() {
        let figures = figures("method", &[table()]);
        let [median, least, _, time, ours] = &figures[..] else { panic!("{figures:?}") };
        assert_eq!((median.paper, median.ratio, median.comparable), (Some(2.5), Some(0.8), true));
        assert_eq!((least.paper, least.ours, least.comparable), (None, Some(1.0), false));
        assert_eq!((time.paper, time.ratio, time.comparable), (Some(20.0), None, false));
        assert!(time.note.starts_with("not comparable: another <machine>"), "{}", time.note);
        assert_eq!((ours.paper, ours.comparable, ours.note.as_str()), (None, false, ""));
    }

    #[test]
    fn what_was_not_measured_is_not_comparable() {
        let mut table = table();
        table.rows[0].cells[0].ours = None;
        let figure = &figures("method", &[table])[0];
        assert_eq!((figure.paper, figure.ours, figure.ratio, figure.comparable), (Some(2.5), None, None, false));
    }
}
