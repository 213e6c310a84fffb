//! Time over faces, both logarithmic, as SVG.

use silhouette_compare::plot::{FAINT_GRID, GRID, INK, LogAxis, line, paper, text};
use silhouette_compare::report::COLORS;
use silhouette_compare::scaling::{ExtractionRow, Series, series};
use svg::node::element::{Circle, Group};

/// Size of the picture, in pixels.
const SIZE: [f64; 2] = [960.0, 560.0];

/// Where the axes are, in pixels: left, right, top, bottom. The legend stands right of them.
const LEFT: f64 = 72.0;
const RIGHT: f64 = 600.0;
const TOP: f64 = 24.0;
const BOTTOM: f64 = 504.0;

/// The plot of all rows: a dot a row, a line a law, a legend with exponents. Series in the order of their rows.
pub fn times_over_faces(rows: &[ExtractionRow]) -> String {
    let all = series(rows);
    let x = LogAxis::around(rows.iter().map(|row| row.faces as f64), LEFT..RIGHT);
    let y = LogAxis::around(rows.iter().map(|row| row.median_ms), BOTTOM..TOP);
    let mut document = paper(SIZE).add(grid(&x, &y));
    for (index, series) in all.iter().enumerate() {
        document = document.add(drawn(series, COLORS[index % COLORS.len()], &x, &y));
    }
    document = document.add(legend(&all));
    format!("{document}\n")
}

fn grid(x: &LogAxis, y: &LogAxis) -> Group {
    let mut group = Group::new();
    let stroke = |label: &Option<String>| if label.is_some() { GRID } else { FAINT_GRID };
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

fn drawn(series: &Series<'_>, color: &str, x: &LogAxis, y: &LogAxis) -> Group {
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
