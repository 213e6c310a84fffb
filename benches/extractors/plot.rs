//! Time over faces, both logarithmic, as SVG.

use silhouette_compare::report::COLORS;
use silhouette_compare::scaling::{ExtractionRow, Series, series};
use std::ops::Range;
use svg::Document;
use svg::node::element::{Circle, Group, Line, Rectangle, Text};

/// Size of the picture, in pixels.
const SIZE: [f64; 2] = [960.0, 560.0];

/// Where the axes are, in pixels: left, right, top, bottom. The legend stands right of them.
const LEFT: f64 = 72.0;
const RIGHT: f64 = 600.0;
const TOP: f64 = 24.0;
const BOTTOM: f64 = 504.0;

const INK: &str = "#1c2127";
const SOFT: &str = "#5b6570";

/// The plot of all rows: a dot a row, a line a law, a legend with exponents. Series in the order of their rows.
pub fn times_over_faces(rows: &[ExtractionRow]) -> String {
    let all = series(rows);
    let [x, y] =
        [Axis::new(rows, |row| row.faces as f64, LEFT..RIGHT), Axis::new(rows, |row| row.median_ms, BOTTOM..TOP)];
    let mut document = Document::new()
        .set("xmlns", "http://www.w3.org/2000/svg")
        .set("viewBox", (0, 0, SIZE[0], SIZE[1]))
        .set("width", SIZE[0])
        .set("height", SIZE[1])
        .set("font-family", "system-ui, sans-serif")
        .set("font-size", 13)
        .add(Rectangle::new().set("width", "100%").set("height", "100%").set("fill", "#ffffff"))
        .add(grid(&x, &y));
    for (index, series) in all.iter().enumerate() {
        document = document.add(drawn(series, COLORS[index % COLORS.len()], &x, &y));
    }
    document = document.add(legend(&all));
    format!("{document}\n")
}

/// A logarithmic axis.
struct Axis {
    decades: Range<i32>,
    pixels: Range<f64>,
}

impl Axis {
    /// Whole decades around the values of all rows.
    fn new(rows: &[ExtractionRow], value: fn(&ExtractionRow) -> f64, pixels: Range<f64>) -> Self {
        let logs = || rows.iter().map(|row| value(row).log10());
        let low = logs().fold(f64::INFINITY, f64::min);
        let high = logs().fold(f64::NEG_INFINITY, f64::max);
        let decades =
            if low <= high { low.floor() as i32..(high.ceil() as i32).max(low.floor() as i32 + 1) } else { 0..1 };
        Self { decades, pixels }
    }

    fn pixel(&self, value: f64) -> f64 {
        let share = (value.log10() - f64::from(self.decades.start)) / f64::from(self.decades.end - self.decades.start);
        rounded(self.pixels.start + share * (self.pixels.end - self.pixels.start))
    }

    /// Values at which a line is drawn, with a label where a decade begins.
    fn ticks(&self) -> impl Iterator<Item = (f64, Option<String>)> {
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

fn rounded(pixel: f64) -> f64 {
    (pixel * 100.0).round() / 100.0
}

fn line(from: [f64; 2], to: [f64; 2]) -> Line {
    Line::new().set("x1", from[0]).set("y1", from[1]).set("x2", to[0]).set("y2", to[1])
}

fn text(words: impl Into<String>, [x, y]: [f64; 2], anchor: &str) -> Text {
    Text::new(words).set("x", x).set("y", y).set("text-anchor", anchor).set("fill", SOFT)
}

fn grid(x: &Axis, y: &Axis) -> Group {
    let mut group = Group::new();
    let stroke = |label: &Option<String>| if label.is_some() { "#c9ced4" } else { "#eceef0" };
    for (value, label) in x.ticks() {
        let at = x.pixel(value);
        group = group.add(line([at, TOP], [at, BOTTOM]).set("stroke", stroke(&label)));
        if let Some(label) = label {
            group = group.add(text(label, [at, BOTTOM + 20.0], "middle"));
        }
    }
    for (value, label) in y.ticks() {
        let at = y.pixel(value);
        group = group.add(line([LEFT, at], [RIGHT, at]).set("stroke", stroke(&label)));
        if let Some(label) = label {
            group = group.add(text(label, [LEFT - 8.0, at + 4.0], "end"));
        }
    }
    let middle = [(LEFT + RIGHT) * 0.5, (TOP + BOTTOM) * 0.5];
    let turned = format!("rotate(-90 18 {})", middle[1]);
    group.add(text("faces", [middle[0], BOTTOM + 44.0], "middle").set("fill", INK)).add(
        text("median time of an extraction in ms", [18.0, middle[1]], "middle")
            .set("fill", INK)
            .set("transform", turned),
    )
}

fn drawn(series: &Series<'_>, color: &str, x: &Axis, y: &Axis) -> Group {
    let mut group = Group::new().set("stroke", color).set("fill", color).set("stroke-width", 1.5);
    if let Some(growth) = series.growth() {
        let [from, to] =
            growth.faces.map(|faces| faces as f64).map(|faces| [x.pixel(faces), y.pixel(growth.law.at(faces))]);
        group = group.add(line(from, to));
    }
    for row in &series.rows {
        let at = [x.pixel(row.faces as f64), y.pixel(row.median_ms)];
        // A dot of one of several sizes of a built-in shape is filled, one of a file is a ring.
        let fill = if row.mesh.starts_with("builtin:") { color } else { "#ffffff" };
        group = group.add(Circle::new().set("cx", at[0]).set("cy", at[1]).set("r", 4).set("fill", fill));
    }
    group
}

/// The series from slow to fast: by their last row, so that the legend stands in the order of the lines' right ends.
fn legend(all: &[Series<'_>]) -> Group {
    let mut entries: Vec<(usize, &Series<'_>)> = all.iter().enumerate().collect();
    let per_face = |series: &Series<'_>| series.rows.last().map_or(0.0, |row| row.median_ms / row.faces as f64);
    entries.sort_by(|a, b| per_face(b.1).total_cmp(&per_face(a.1)));
    let mut group = Group::new();
    for (place, (index, series)) in entries.into_iter().enumerate() {
        let top = TOP + 16.0 + 40.0 * place as f64;
        let color = COLORS[index % COLORS.len()];
        let dot = Circle::new().set("cx", RIGHT + 24.0).set("cy", top - 4.0).set("r", 5).set("fill", color);
        group = group.add(dot).add(text(&series.label, [RIGHT + 38.0, top], "start").set("fill", INK));
        let Some(growth) = series.growth() else { continue };
        let shape = growth.shape.as_deref().unwrap_or("all meshes");
        let words = format!("faces^{:.2} on {shape}, r² {:.3}", growth.law.exponent, growth.law.r2);
        group = group.add(text(words, [RIGHT + 38.0, top + 16.0], "start").set("font-size", 12));
    }
    let key = "filled: built-in shape; ring: model";
    group.add(text(key, [RIGHT + 24.0, BOTTOM], "start").set("font-size", 12))
}
