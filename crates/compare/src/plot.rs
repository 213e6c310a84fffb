//! What charts as SVG are made of: paper, logarithmic axes, lines and words in one style.

use std::ops::Range;
use svg::Document;
use svg::node::element::{Line, Rectangle, Text};

/// Colour of what is read first.
pub const INK: &str = "#1c2127";
/// Colour of numbers at axes and of remarks.
pub const SOFT: &str = "#5b6570";
/// Colour of a line of the grid with a label.
pub const GRID: &str = "#c9ced4";
/// Colour of a line of the grid without one.
pub const FAINT_GRID: &str = "#eceef0";

/// A white page of this size in pixels.
pub fn paper([width, height]: [f64; 2]) -> Document {
    Document::new()
        .set("xmlns", "http://www.w3.org/2000/svg")
        .set("viewBox", (0, 0, width, height))
        .set("width", width)
        .set("height", height)
        .set("font-family", "system-ui, sans-serif")
        .set("font-size", 13)
        .add(Rectangle::new().set("width", "100%").set("height", "100%").set("fill", "#ffffff"))
}

/// A line without a colour.
pub fn line(from: [f64; 2], to: [f64; 2]) -> Line {
    Line::new().set("x1", from[0]).set("y1", from[1]).set("x2", to[0]).set("y2", to[1])
}

/// Words; `anchor` is `start`, `middle` or `end`.
pub fn text(words: impl Into<String>, [x, y]: [f64; 2], anchor: &str) -> Text {
    Text::new(words).set("x", x).set("y", y).set("text-anchor", anchor).set("fill", SOFT)
}

/// A coordinate as it is written: to a hundredth of a pixel.
pub fn rounded(pixel: f64) -> f64 {
    (pixel * 100.0).round() / 100.0
}

/// A logarithmic axis.
#[derive(Debug, Clone, PartialEq)]
pub struct LogAxis {
    decades: Range<i32>,
    pixels: Range<f64>,
}

impl LogAxis {
    /// Whole decades around positive values, at least one; from the first pixel to the last, which may be the smaller.
    pub fn around(values: impl Iterator<Item = f64>, pixels: Range<f64>) -> Self {
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for log in values.map(f64::log10) {
            (low, high) = (low.min(log), high.max(log));
        }
        let decades =
            if low <= high { low.floor() as i32..(high.ceil() as i32).max(low.floor() as i32 + 1) } else { 0..1 };
        Self { decades, pixels }
    }

    /// Where a positive value is.
    pub fn pixel(&self, value: f64) -> f64 {
        let share = (value.log10() - f64::from(self.decades.start)) / f64::from(self.decades.end - self.decades.start);
        rounded(self.pixels.start + share * (self.pixels.end - self.pixels.start))
    }

    /// Values at which a line is drawn, with a label where a decade begins.
    pub fn ticks(&self) -> impl Iterator<Item = (f64, Option<String>)> {
        let steps = self.decades.clone().flat_map(|decade| [1.0, 2.0, 5.0].map(|digit| (decade, digit)));
        steps.chain([(self.decades.end, 1.0)]).map(|(decade, digit)| {
            let label = (digit < 1.5).then(|| label(decade));
            (digit * 10.0_f64.powi(decade), label)
        })
    }
}

/// `10 k` for 4, `0.01` for -2.
fn label(decade: i32) -> String {
    match decade {
        ..0 => format!("{:.*}", decade.unsigned_abs() as usize, 10.0_f64.powi(decade)),
        0..3 => format!("{}", 10_u32.pow(decade.unsigned_abs())),
        3..6 => format!("{} k", 10_u32.pow(decade.unsigned_abs() - 3)),
        6..9 => format!("{} M", 10_u32.pow(decade.unsigned_abs() - 6)),
        _ => format!("1e{decade}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decades_hold_all_values_and_are_labelled() {
        let axis = LogAxis::around([30.0, 2000.0].into_iter(), 300.0..0.0);
        assert_eq!([10.0, 100.0, 10_000.0].map(|value| axis.pixel(value) as i32), [300, 200, 0]);
        let labels: Vec<String> = axis.ticks().filter_map(|(_, label)| label).collect();
        assert_eq!(labels, ["10", "100", "1 k", "10 k"]);
        assert_eq!(axis.ticks().count(), 10);
    }

    #[test]
    fn an_axis_without_values_or_with_one_has_a_decade() {
        assert_eq!(LogAxis::around(std::iter::empty(), 0.0..1.0).ticks().count(), 4);
        assert_eq!(LogAxis::around([1.0].into_iter(), 0.0..1.0).ticks().last().unwrap().1.as_deref(), Some("10"));
    }

    #[test]
    fn small_and_large_decades_are_written_out() {
        assert_eq!([-2, 0, 2, 4, 7, 12].map(label), ["0.01", "1", "100", "10 k", "10 M", "1e12"]);
    }
}
