//! One metric against another: a panel per table, a mark per row.

use super::place::Extent;
use crate::table::{Mark, Table};
use silhouette_compare::plot::{FAINT_GRID, GRID, INK, LogAxis, line, paper, rounded, text};
use std::f64::consts::TAU;
use svg::node::element::{Group, Polyline, Text};

/// Panels side by side.
const PER_ROW: usize = 3;

/// Size of a panel with the words of its axes, in pixels; one alone is as wide as two.
const PANEL: [f64; 2] = [420.0, 420.0];

/// Height of a line of the legend, and the space around it.
const LEGEND_LINE: f64 = 22.0;
const LEGEND_MARGIN: f64 = 10.0;

/// Where the plot is in its panel: left, from the panel's right end, top, bottom.
const LEFT: f64 = 64.0;
const RIGHT_MARGIN: f64 = 16.0;
const TOP: f64 = 36.0;
const BOTTOM: f64 = 364.0;

/// Radius of a mark in pixels.
const MARK: f64 = 6.0;

/// Marks nearer to each other than this, in pixels, share their words.
const NEAR: f64 = 5.0;

/// What is drawn alike.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Series {
    /// What the legend calls it.
    pub label: &'static str,
    /// Colour of its marks.
    pub color: &'static str,
    /// Corners of its marks, so that colour alone distinguishes no two series.
    pub corners: u32,
    /// By how many degrees marks are turned; at 0 a corner points down.
    pub turned_deg: u32,
    /// Whether marks are drawn as outlines.
    pub is_hollow: bool,
    /// Whether a line joins its marks in the order of the rows.
    pub is_joined: bool,
}

impl Series {
    /// A series of filled marks that no line joins.
    pub const fn new(label: &'static str, color: &'static str, corners: u32, turned_deg: u32) -> Self {
        Self { label, color, corners, turned_deg, is_hollow: false, is_joined: false }
    }
}

/// What is drawn against what.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Axes {
    /// Metric from left to right, from 0, and the words below it.
    pub x: [&'static str; 2],
    /// Metric from bottom to top, logarithmic, and the words beside it.
    pub y: [&'static str; 2],
}

/// The chart, as SVG: the rows of `tables` that have a mark and both metrics.
pub fn draw(tables: &[Table], axes: Axes, series: &[Series]) -> String {
    let columns = tables.len().clamp(1, PER_ROW);
    let rows = tables.len().div_ceil(PER_ROW).max(1);
    let width = (PANEL[0] * columns as f64).max(2.0 * PANEL[0]);
    let (legend, legend_height) = legend(series, width);
    let mut document = paper([width, legend_height + PANEL[1] * rows as f64]).add(legend);
    let panel_width = width / columns as f64;
    for (index, table) in tables.iter().enumerate() {
        let at = [panel_width * (index % PER_ROW) as f64, legend_height + PANEL[1] * (index / PER_ROW) as f64];
        let panel = panel(table, axes, series, panel_width - RIGHT_MARGIN);
        document = document.add(panel.set("transform", format!("translate({} {})", at[0], at[1])));
    }
    format!("{document}\n")
}

fn mark(series: &Series, [x, y]: [f64; 2]) -> Polyline {
    let corner = |index: u32| {
        let turn = TAU * f64::from(index) / f64::from(series.corners) + f64::from(series.turned_deg).to_radians();
        format!("{},{}", rounded(x + MARK * turn.sin()), rounded(y + MARK * turn.cos()))
    };
    Polyline::new()
        .set("points", (0..=series.corners).map(corner).collect::<Vec<_>>().join(" "))
        .set("stroke", series.color)
        .set("stroke-width", 1.5)
        .set("fill", if series.is_hollow { "#ffffff" } else { series.color })
}

fn small(words: impl Into<String>, at: [f64; 2], anchor: &str) -> Text {
    text(words, at, anchor).set("font-size", 12).set("fill", INK)
}

/// The legend and its height.
fn legend(series: &[Series], width: f64) -> (Group, f64) {
    let columns = if width > 1000.0 { 5 } else { 3 };
    let column = (width - 48.0) / columns as f64;
    let mut group = Group::new();
    for (index, series) in series.iter().enumerate() {
        let line = (index / columns) as f64;
        let at = [24.0 + column * (index % columns) as f64, 2.0 * LEGEND_MARGIN + LEGEND_LINE * line];
        group = group.add(mark(series, at)).add(small(series.label, [at[0] + 14.0, at[1] + 4.0], "start"));
    }
    (group, LEGEND_LINE * series.len().div_ceil(columns) as f64 + LEGEND_MARGIN)
}

/// Values from 0 to a round number that holds them all.
struct FromZero {
    end: f64,
    step: f64,
    /// Right end of the plot in pixels.
    right: f64,
}

impl FromZero {
    fn new(values: impl Iterator<Item = f64>, right: f64) -> Self {
        let largest = values.fold(0.0, f64::max);
        let steps = [0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0];
        let step = steps.into_iter().find(|step| largest <= 5.0 * step).unwrap_or(20.0);
        Self { end: (largest / step).ceil().max(1.0) * step, step, right }
    }

    /// 0 is a little right of the left end, so that marks stand clear of the axis.
    fn pixel(&self, value: f64) -> f64 {
        rounded(LEFT + 16.0 + value / self.end * (self.right - LEFT - 44.0))
    }

    fn ticks(&self) -> impl Iterator<Item = f64> {
        let count = (self.end / self.step).round() as u32;
        (0..=count).map(|index| f64::from(index) * self.step)
    }
}

/// A row in the plot.
struct Point<'a> {
    mark: &'a Mark,
    values: [f64; 2],
}

/// The rows that have a mark and both metrics.
fn points(table: &Table, axes: Axes) -> Vec<Point<'_>> {
    let heights: Vec<_> = table.values(axes.y[0]).collect();
    let point = |(row, x): (&'_ crate::table::Row, f64)| {
        let &(row, y) = heights.iter().find(|(other, _)| std::ptr::eq(*other, row))?;
        Some(Point { mark: row.mark.as_ref()?, values: [x, y] })
    };
    table.values(axes.x[0]).filter_map(point).collect()
}

fn panel(table: &Table, axes: Axes, series: &[Series], right: f64) -> Group {
    let points = points(table, axes);
    let x = FromZero::new(points.iter().map(|point| point.values[0]), right);
    let y = LogAxis::around(points.iter().map(|point| point.values[1]), BOTTOM..TOP);
    let at = |point: &Point<'_>| [x.pixel(point.values[0]), y.pixel(point.values[1])];

    let mut group = Group::new().add(grid(&x, &y, axes));
    let title = text(table.subject.clone(), [LEFT, TOP - 14.0], "start");
    group = group.add(title.set("fill", INK).set("font-weight", 600));
    let mut taken: Vec<Extent> = Vec::new();
    for (index, joined) in series.iter().enumerate().filter(|(_, series)| series.is_joined) {
        let corners: Vec<_> = points.iter().filter(|point| point.mark.series == index).map(at).collect();
        taken.extend(corners.windows(2).flat_map(|ends| Extent::along(ends[0], ends[1])));
        let corners: Vec<String> = corners.iter().map(|[x, y]| format!("{x},{y}")).collect();
        let way = Polyline::new().set("points", corners.join(" ")).set("fill", "none");
        group = group.add(way.set("stroke", joined.color).set("stroke-width", 1.5));
    }
    for point in &points {
        let [x, y] = at(point);
        group = group.add(mark(&series[point.mark.series], [x, y]));
        taken.push(Extent { from: [x - MARK, y - MARK], to: [x + MARK, y + MARK] });
    }
    for Label { series: of, mark, label } in labels(points.iter().map(|point| (point.mark, at(point)))) {
        let place = Extent::free_beside(mark, &label, LEFT, &taken);
        let words = small(label, [place.from[0], place.to[1] - 3.0], "start");
        group = group.add(words.set("fill", series[of].color));
        taken.push(place);
    }
    group
}

/// Words for a mark, or for several that nearly coincide.
#[derive(Debug, Clone, PartialEq)]
struct Label {
    series: usize,
    mark: [f64; 2],
    label: String,
}

/// The words of all marks that have some.
fn labels<'a>(marks: impl Iterator<Item = (&'a Mark, [f64; 2])>) -> Vec<Label> {
    let mut labels: Vec<Label> = Vec::new();
    for (mark, at) in marks.filter(|(mark, _)| !mark.label.is_empty()) {
        let is_near = |last: &Label| (last.mark[0] - at[0]).hypot(last.mark[1] - at[1]) < NEAR;
        match labels.last_mut().filter(|last| last.series == mark.series && is_near(last)) {
            Some(last) => last.label = format!("{}, {}", last.label, mark.label),
            None => labels.push(Label { series: mark.series, mark: at, label: mark.label.clone() }),
        }
    }
    labels
}

fn grid(x: &FromZero, y: &LogAxis, axes: Axes) -> Group {
    let mut group = Group::new();
    for (value, label) in y.ticks() {
        let at = y.pixel(value);
        let stroke = if label.is_some() { GRID } else { FAINT_GRID };
        group = group.add(line([LEFT, at], [x.right, at]).set("stroke", stroke));
        if let Some(label) = label {
            group = group.add(text(label, [LEFT - 8.0, at + 4.0], "end"));
        }
    }
    for value in x.ticks() {
        let at = x.pixel(value);
        group = group.add(line([at, TOP], [at, BOTTOM]).set("stroke", if value > 0.0 { FAINT_GRID } else { GRID }));
        let label = if x.step < 1.0 { format!("{value:.1}") } else { format!("{value:.0}") };
        group = group.add(text(label, [at, BOTTOM + 20.0], "middle"));
    }
    let middle = [(LEFT + x.right) * 0.5, (TOP + BOTTOM) * 0.5];
    let turned = format!("rotate(-90 16 {})", middle[1]);
    let below = text(axes.x[1], [middle[0], BOTTOM + 42.0], "middle").set("fill", INK);
    group.add(below).add(text(axes.y[1], [16.0, middle[1]], "middle").set("fill", INK).set("transform", turned))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::table::{Cell, Column, Row};

    const SERIES: [Series; 2] = [
        Series { is_joined: true, ..Series::new("joined", "#0000ff", 24, 0) },
        Series { is_hollow: true, ..Series::new("alone", "#ff0000", 4, 0) },
    ];

    /// Three marked rows, one without a mark and one without a time.
    fn table() -> Table {
        let column = |metric| Column::new("", metric, "", "");
        let row = |series: usize, label: &str, values: [f64; 2]| Row {
            mark: Some(Mark { series, label: label.to_owned() }),
            ..Row::new("row", values.map(Cell::one).to_vec())
        };
        let unmarked = Row { mark: None, ..row(0, "", [1.0, 1.0]) };
        Table {
            subject: "<b>mesh</b>".to_owned(),
            columns: vec![column("missed"), column("time")],
            rows: vec![
                row(0, "a", [0.0, 30.0]),
                row(0, "b", [7.9, 3.0]),
                row(1, "", [1.0, 10.0]),
                unmarked,
                row(1, "", [2.0, f64::NAN]),
            ],
            ..Table::default()
        }
    }

    #[test]
    fn every_marked_row_is_drawn_and_every_series_explained() {
        let axes = Axes { x: ["missed", "missed in %"], y: ["time", "time in µs"] };
        let chart = draw(&[table(), table()], axes, &SERIES);
        let (marks, way) = (3, 1);
        assert_eq!(chart.matches("<polyline").count(), 2 * (marks + way) + SERIES.len());
        for words in ["joined", "alone", "missed in %", "time in µs"] {
            assert!(chart.contains(words), "{words}");
        }
        assert!(!chart.contains("NaN") && !chart.contains("inf") && !chart.contains("<b>"));
    }

    #[test]
    fn values_have_round_steps_from_zero() {
        for (largest, end, count) in [(0.0, 0.1, 2), (0.43, 0.5, 6), (7.9, 8.0, 5), (28.0, 30.0, 4), (93.0, 100.0, 6)] {
            let axis = FromZero::new([0.0, largest].into_iter(), 400.0);
            assert!((axis.end - end).abs() < 1e-9 && axis.ticks().count() == count, "{largest}: {}", axis.end);
            assert!(axis.pixel(largest) <= 400.0 && axis.pixel(0.0) > LEFT);
        }
    }

    #[test]
    fn marks_that_nearly_coincide_share_their_words() {
        let marks = ["0", "0.01", "0.1"].map(|label| Mark { series: 0, label: label.to_owned() });
        let texts =
            |at: [[f64; 2]; 3]| labels(marks.iter().zip(at)).into_iter().map(|label| label.label).collect::<Vec<_>>();
        assert_eq!(texts([[0.0, 0.0], [3.0, 0.0], [90.0, 0.0]]), ["0, 0.01", "0.1"]);
        assert_eq!(texts([[0.0, 0.0], [0.0, 30.0], [0.0, 60.0]]), ["0", "0.01", "0.1"]);
    }
}
