//! Metrics side by side: a panel per table, a bar per row.

use crate::table::{Row, Table};
use silhouette_compare::plot::{FAINT_GRID, GRID, INK, line, paper, rounded, text};
use silhouette_compare::report::COLORS;
use svg::node::element::{Group, Rectangle};

/// Height of a row, of a panel's head and of its foot, in pixels.
const ROW: f64 = 18.0;
const HEAD: f64 = 56.0;
const FOOT: f64 = 24.0;

/// Width of labels, of a plot, and between plots.
const LABELS: f64 = 150.0;
const PLOT: f64 = 340.0;
const BETWEEN: f64 = 50.0;

/// One plot: what the lengths of its bars mean.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bar {
    /// The metric.
    pub metric: &'static str,
    /// The metric of its standard deviation, drawn as a whisker.
    pub deviation: Option<&'static str>,
    /// Words above the plot.
    pub title: &'static str,
    /// Where the plot ends; longer bars are cut there.
    pub end: f64,
    /// Distance between the lines of the grid.
    pub step: f64,
    /// The value that is asked for, whose line is darker.
    pub asked: Option<f64>,
}

/// The chart, as SVG: a bar of each of `bars` for every row that has its metric. The first row is in another colour.
pub fn draw<'a>(tables: impl IntoIterator<Item = &'a Table>, bars: &[Bar]) -> String {
    let mut panels = Vec::new();
    let mut top = 0.0;
    for table in tables {
        panels.push(panel(table, bars).set("transform", format!("translate(0 {})", rounded(top))));
        top += HEAD + ROW * table.rows.len() as f64 + FOOT;
    }
    let width = LABELS + (PLOT + BETWEEN) * bars.len() as f64;
    let mut document = paper([width, top.max(HEAD)]);
    for panel in panels {
        document = document.add(panel);
    }
    format!("{document}\n")
}

fn panel(table: &Table, bars: &[Bar]) -> Group {
    let title = text(table.heading(), [12.0, 20.0], "start").set("fill", INK).set("font-weight", 600);
    let mut group = Group::new().add(title);
    for (index, row) in table.rows.iter().enumerate() {
        let label = text(row.label.clone(), [LABELS - 12.0, middle(index) + 4.0], "end");
        group = group.add(label.set("fill", INK));
    }
    for (index, bar) in bars.iter().enumerate() {
        group = group.add(plot(table, bar, LABELS + (PLOT + BETWEEN) * index as f64));
    }
    group
}

/// Height of a row's middle.
fn middle(index: usize) -> f64 {
    HEAD + ROW * index as f64
}

fn plot(table: &Table, bar: &Bar, left: f64) -> Group {
    let bottom = HEAD + ROW * table.rows.len() as f64;
    let at = |value: f64| rounded(left + value.clamp(0.0, bar.end) / bar.end * PLOT);
    let mut group = Group::new().add(text(bar.title, [left, 38.0], "start"));
    for tick in 0..=(bar.end / bar.step).round() as u32 {
        let value = bar.step * f64::from(tick);
        let is_asked = bar.asked.is_some_and(|asked| (asked - value).abs() < 0.5 * bar.step);
        let stroke = if is_asked { GRID } else { FAINT_GRID };
        group = group.add(line([at(value), HEAD - 10.0], [at(value), bottom]).set("stroke", stroke));
        group = group.add(text(format!("{value}"), [at(value), bottom + 15.0], "middle"));
    }
    let deviations: Vec<(&Row, f64)> = bar.deviation.map_or_else(Vec::new, |metric| table.values(metric).collect());
    for (row, value) in table.values(bar.metric) {
        let Some(index) = table.rows.iter().position(|other| std::ptr::eq(other, row)) else { continue };
        let middle = middle(index);
        let rectangle = Rectangle::new()
            .set("x", left)
            .set("y", rounded(middle - 0.3 * ROW))
            .set("width", rounded((at(value) - left).max(0.5)))
            .set("height", rounded(0.6 * ROW))
            .set("fill", if index == 0 { COLORS[2] } else { COLORS[0] });
        group = group.add(rectangle);
        if let Some((_, deviation)) = deviations.iter().find(|(other, _)| std::ptr::eq(*other, row)) {
            let whisker = line([at(value - deviation), middle], [at(value + deviation), middle]);
            group = group.add(whisker.set("stroke", INK).set("stroke-width", 1.5));
        }
    }
    group
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::table::{Cell, Column};

    #[test]
    fn every_value_has_a_bar_and_long_ones_are_cut() {
        let column = |metric| Column::new("", metric, "", "");
        let row = |values: [f64; 3]| Row::new("<row>", values.map(Cell::one).to_vec());
        let table = Table {
            columns: ["width", "deviation", "share"].map(column).to_vec(),
            rows: vec![row([2.0, 0.5, 50.0]), row([f64::NAN, 1.0, 0.0]), row([99.0, 1.0, 100.0])],
            ..Table::default()
        };
        let bar =
            Bar { metric: "width", deviation: Some("deviation"), title: "", end: 6.0, step: 1.0, asked: Some(2.0) };
        let share = Bar { metric: "share", deviation: None, end: 100.0, step: 25.0, asked: None, ..bar };
        let chart = draw([&table, &table], &[bar, share]);
        let (ground, widths, shares) = (1, 2, 3);
        assert_eq!(chart.matches("<rect").count(), ground + 2 * (widths + shares));
        assert_eq!(chart.matches(&format!("stroke=\"{INK}\"")).count(), 2 * widths, "whiskers");
        assert_eq!(chart.matches(&format!("width=\"{PLOT}\"")).count(), 2 * 2, "one width is cut, one share is full");
        assert!(!chart.contains("NaN") && !chart.contains("<row>"));
    }
}
