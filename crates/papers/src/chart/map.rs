//! Two rivals over a grid: a panel per measure, a field per cell, coloured by who is better.

use silhouette_compare::plot::{GRID, INK, SOFT, paper, rounded, text};
use silhouette_compare::report::COLORS;
use svg::node::element::{Group, Rectangle};

/// Panels side by side.
const PER_ROW: usize = 2;

/// Size of a field in pixels.
const FIELD: [f64; 2] = [122.0, 46.0];

/// Width of the words beside rows, height of the words above columns, and the space between panels.
const LABELS: f64 = 140.0;
const HEAD: f64 = 68.0;
const BETWEEN: f64 = 28.0;

/// Height of the legend, and size of its boxes.
const LEGEND: f64 = 52.0;
const BOX: [f64; 2] = [46.0, 16.0];

/// Colours at either end: of the first rival ahead, and of the second. They differ for colour-blind readers too.
const ENDS: [&str; 2] = [COLORS[1], COLORS[0]];

/// The colour where neither is better, and where there is no value.
const EVEN: &str = "#ffffff";
const MISSING: &str = "#e4e6e8";

/// At this ratio, or its inverse, colours are full.
const FULL: f64 = 10.0;

/// From this share of the full colour on, words are white.
const DARK: f64 = 0.7;

/// Ratios of the legend.
const LEGEND_RATIOS: [f64; 7] = [0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0];

/// One field: what both rivals come to.
#[derive(Debug, Clone, PartialEq)]
pub struct Field {
    /// Above 1 the second rival of the legend is better, below 1 the first; NaN without a value.
    pub ratio: f64,
    /// Both values as words.
    pub words: String,
}

impl Field {
    /// A field with both values.
    pub fn new(ratio: f64, values: &[String; 2]) -> Self {
        Self { ratio, words: values.join(" | ") }
    }
}

/// One measure over the grid.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    /// What is compared.
    pub title: &'static str,
    /// Two lines above each column.
    pub columns: Vec<[String; 2]>,
    /// Two lines beside each row.
    pub rows: Vec<[String; 2]>,
    /// Row by row, one for each column.
    pub fields: Vec<Field>,
}

/// The chart, as SVG. `ends` says in the legend what ratios below and above 1 mean.
pub fn draw(panels: &[Panel], ends: [&str; 2]) -> String {
    let most = |count: fn(&Panel) -> usize| panels.iter().map(count).max().unwrap_or(0) as f64;
    let width = LABELS + FIELD[0] * most(|panel| panel.columns.len()) + BETWEEN;
    let height = HEAD + FIELD[1] * most(|panel| panel.rows.len()) + BETWEEN;
    let columns = panels.len().clamp(1, PER_ROW);
    let size = [(width * columns as f64).max(700.0), LEGEND + height * panels.len().div_ceil(PER_ROW) as f64];
    let mut document = paper(size).add(legend(ends, size[0]));
    for (index, panel) in panels.iter().enumerate() {
        let at = [width * (index % PER_ROW) as f64, LEGEND + height * (index / PER_ROW) as f64];
        document = document.add(drawn(panel).set("transform", format!("translate({} {})", at[0], at[1])));
    }
    format!("{document}\n")
}

fn drawn(panel: &Panel) -> Group {
    let title = text(panel.title, [LABELS, 20.0], "start").set("fill", INK).set("font-weight", 600);
    let mut group = Group::new().add(title);
    for (index, [first, second]) in panel.columns.iter().enumerate() {
        let middle = LABELS + FIELD[0] * (index as f64 + 0.5);
        group = group.add(text(first, [middle, HEAD - 24.0], "middle").set("fill", INK));
        group = group.add(text(second, [middle, HEAD - 8.0], "middle"));
    }
    for (index, [first, second]) in panel.rows.iter().enumerate() {
        let middle = HEAD + FIELD[1] * (index as f64 + 0.5);
        group = group.add(text(first, [LABELS - 10.0, middle - 3.0], "end").set("fill", INK));
        group = group.add(text(second, [LABELS - 10.0, middle + 13.0], "end"));
    }
    for (index, field) in panel.fields.iter().enumerate() {
        let (row, column) = (index / panel.columns.len(), index % panel.columns.len());
        let corner = [LABELS + FIELD[0] * column as f64, HEAD + FIELD[1] * row as f64];
        let [middle, center] = [corner[0] + 0.5 * FIELD[0], corner[1] + 0.5 * FIELD[1]];
        let ink = ink(field.ratio);
        group = group.add(filled(corner, FIELD, field.ratio));
        group = group.add(text(ratio_text(field.ratio), [middle, center - 3.0], "middle").set("fill", ink));
        if field.ratio.is_finite() {
            let words = text(&field.words, [middle, center + 13.0], "middle").set("font-size", 11);
            group = group.add(words.set("fill", if ink == INK { SOFT } else { ink }));
        }
    }
    group
}

fn legend(ends: [&str; 2], width: f64) -> Group {
    let left = rounded(0.5 * (width - BOX[0] * LEGEND_RATIOS.len() as f64));
    let right = left + BOX[0] * LEGEND_RATIOS.len() as f64;
    let mut group = Group::new()
        .add(text(ends[0], [left - 10.0, 25.0], "end").set("fill", ENDS[0]).set("font-weight", 600))
        .add(text(ends[1], [right + 10.0, 25.0], "start").set("fill", ENDS[1]).set("font-weight", 600));
    for (index, ratio) in LEGEND_RATIOS.into_iter().enumerate() {
        let corner = [left + BOX[0] * index as f64, 12.0];
        group = group.add(filled(corner, BOX, ratio));
        group = group.add(text(format!("{ratio} ×"), [corner[0] + 0.5 * BOX[0], 44.0], "middle"));
    }
    group
}

fn filled([x, y]: [f64; 2], [width, height]: [f64; 2], ratio: f64) -> Rectangle {
    Rectangle::new()
        .set("x", rounded(x))
        .set("y", rounded(y))
        .set("width", width)
        .set("height", height)
        .set("fill", color(ratio))
        .set("stroke", GRID)
}

/// How full the colour of a ratio is, 0 to 1: its logarithm.
fn fullness(ratio: f64) -> f64 {
    (ratio.log10() / FULL.log10()).abs().min(1.0)
}

fn color(ratio: f64) -> String {
    if !ratio.is_finite() || ratio <= 0.0 {
        return MISSING.to_owned();
    }
    let share = fullness(ratio);
    let [even, end] = [EVEN, ENDS[usize::from(ratio > 1.0)]].map(channels);
    let [r, g, b] =
        std::array::from_fn(|channel| (even[channel] + share * (end[channel] - even[channel])).round() as u8);
    format!("#{r:02x}{g:02x}{b:02x}")
}

/// Red, green and blue of `#rrggbb`, 0 to 255.
fn channels(color: &str) -> [f64; 3] {
    let value = u32::from_str_radix(color.trim_start_matches('#'), 16).unwrap_or(0);
    [16, 8, 0].map(|shift| f64::from(value >> shift & 0xff))
}

fn ink(ratio: f64) -> &'static str {
    if ratio.is_finite() && fullness(ratio) > DARK { EVEN } else { INK }
}

/// `2.1 ×`, with two digits that count.
fn ratio_text(ratio: f64) -> String {
    match ratio {
        _ if !ratio.is_finite() => "–".to_owned(),
        ..0.1 => format!("{ratio:.3} ×"),
        ..1.0 => format!("{ratio:.2} ×"),
        ..10.0 => format!("{ratio:.1} ×"),
        _ => format!("{ratio:.0} ×"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn panel(ratios: [f64; 4]) -> Panel {
        let label = |name: &str| [format!("<{name}>"), "below".to_owned()];
        Panel {
            title: "A measure",
            columns: vec![label("near"), label("far")],
            rows: vec![label("small"), label("large")],
            fields: ratios.map(|ratio| Field::new(ratio, &["1 kB".to_owned(), "2 kB".to_owned()])).to_vec(),
        }
    }

    #[test]
    fn every_field_is_drawn_also_where_there_is_no_value() {
        let panel = panel([0.02, 1.0, 30.0, f64::NAN]);
        let chart = draw(&[panel.clone(), panel.clone(), panel], ["ours loses", "ours wins"]);
        let (ground, legend) = (1, LEGEND_RATIOS.len());
        assert_eq!(chart.matches("<rect").count(), ground + legend + 3 * 4);
        assert_eq!(chart.matches("1 kB | 2 kB").count(), 3 * 3);
        assert_eq!(chart.matches(MISSING).count(), 3);
        for words in ["0.020 ×", "1.0 ×", "30 ×", "&lt;near&gt;", "&lt;large&gt;", "ours loses", "ours wins"] {
            assert!(chart.contains(words), "{words}");
        }
        assert!(!chart.contains("NaN") && !chart.contains("<near>"));
    }

    #[test]
    fn colours_say_who_is_better_and_by_how_much() {
        assert_eq!([0.1, 0.001, 10.0, 500.0].map(color), [ENDS[0], ENDS[0], ENDS[1], ENDS[1]]);
        assert_eq!([1.0, f64::NAN, f64::INFINITY, 0.0].map(color), [EVEN, MISSING, MISSING, MISSING]);
        let red = |ratio| channels(&color(ratio))[0];
        assert!(red(1.0) > red(2.0) && red(2.0) > red(5.0), "blue is the fuller, the better the second");
        assert!((fullness(5.0) - fullness(0.2)).abs() < 1e-12, "alike in both directions");
        assert_eq!([1.0, 10.0, f64::NAN].map(ink), [INK, EVEN, INK]);
    }
}
