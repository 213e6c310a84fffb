//! Tables as text.

use crate::paper::Reproduction;
use crate::table::{Cell, Column, Comparable, Ours, Printed, Table};
use std::io::{self, Write};

/// Writes every table, with what has to be known of the run.
///
/// # Errors
/// Those of `out`.
pub fn write_tables(reproduction: &Reproduction, mut out: impl Write) -> io::Result<()> {
    let Reproduction { paper, machine, program, adapter, measured, .. } = reproduction;
    writeln!(out, "{}", paper.citation())?;
    let adapter = adapter.iter().map(|adapter| format!("; {adapter}")).collect::<String>();
    writeln!(out, "{program}; {machine}{adapter}")?;
    writeln!(out, "{}", measured.setting)?;
    for note in &measured.notes {
        writeln!(out, "{note}")?;
    }
    writeln!(
        out,
        "In brackets what the paper prints, with * where the two are not comparable; in parentheses a range."
    )?;
    measured.tables.iter().try_for_each(|table| write_table(table, &mut out))
}

fn write_table(table: &Table, out: &mut impl Write) -> io::Result<()> {
    write!(out, "\n{}", table.heading())?;
    if !table.about.is_empty() {
        write!(out, " ({})", table.about)?;
    }
    writeln!(out)?;
    let head = |text: fn(&Column) -> &str| table.columns.iter().map(|column| text(column).to_owned()).collect();
    let mut lines: Vec<(&str, Vec<String>)> = vec![("", head(|column| column.title)), ("", head(|column| column.unit))];
    for row in &table.rows {
        let cells = table.columns.iter().zip(&row.cells);
        lines.push((&row.label, cells.map(|(column, cell)| cell_text(column, cell)).collect()));
    }
    let width = |text: &str| text.chars().count();
    let label_width = lines.iter().map(|(label, _)| width(label)).max().unwrap_or(0);
    let widths: Vec<usize> = (0..table.columns.len())
        .map(|at| lines.iter().map(|(_, cells)| width(&cells[at])).max().unwrap_or(0))
        .collect();
    for (label, cells) in lines {
        let mut line = format!("{label:<label_width$}");
        for (cell, width) in cells.iter().zip(&widths) {
            line.push_str(&format!("  {cell:>width$}"));
        }
        writeln!(out, "{}", line.trim_end())?;
    }
    for reason in table.incomparable() {
        writeln!(out, "* {reason}")?;
    }
    Ok(())
}

/// Ours, the range in parentheses, the paper's in brackets; a dash where nothing was measured.
fn cell_text(column: &Column, cell: &Cell) -> String {
    let mut text = cell.ours.map_or_else(|| "–".to_owned(), |ours| column.text(ours.middle()));
    if let Some(Ours::Range(range)) = cell.ours {
        text.extend(column.range_text(range).map(|range| format!(" ({range})")));
    }
    if let Some(Printed { value, comparable }) = &cell.paper {
        let star = if *comparable == Comparable::Yes { "" } else { "*" };
        text.push_str(&format!(" [{}]{star}", column.text(*value)));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::paper::tests::reproduction;

    #[test]
    fn every_row_is_a_line_of_aligned_cells() {
        let mut out = Vec::new();
        write_tables(&reproduction(), &mut out).unwrap();
        let text = String::from_utf8(out).unwrap();
        let line = |start: &str| text.lines().find(|line| line.starts_with(start)).unwrap_or_else(|| panic!("{text}"));
        assert!(line("printed row").ends_with("2.00 (1.00 to 3.00) [2.50]  10 [20]*"), "{text}");
        assert!(line("our row").contains("< 0.01") && line("our row").ends_with('–'), "{text}");
        assert_eq!(line("printed row").chars().count(), line("our row").chars().count());
        assert_eq!(line("<b>mesh</b>: Table 1"), "<b>mesh</b>: Table 1 (12 faces)");
        assert_eq!(line("* time"), "* time: another <machine>");
        assert!(line("the model is not among").contains("these meshes") && line("a setting").len() > 5);
    }
}
