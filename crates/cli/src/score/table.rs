//! A score as a table for people: what `results.csv` holds, under the same names.

use silhouette_compare::Cell;
use silhouette_compare::metrics::PictureMetrics;
use silhouette_compare::metrics::table::find;
use silhouette_compare::record::View;
use silhouette_compare::report::sentence;
use std::fmt::Write;

/// Metrics that are shown, by their names in results.
const SHOWN: [&str; 6] =
    ["missed_1px", "spurious_1px", "chamfer_px", "hausdorff_95_px", "gaps_per_1000px", "width_mean_px"];

/// The table, its average, and where the drawing errs.
pub fn of(cell: &Cell) -> String {
    let has_edges = cell.views.iter().any(|view| view.edges.is_some());
    let mut names = vec!["frame", "visible_length_px"];
    names.extend(SHOWN);
    if has_edges {
        names.extend(["edges_found", "edge_precision", "edge_recall"]);
    }
    let mut rows: Vec<Vec<String>> = vec![names.into_iter().map(str::to_owned).collect()];
    rows.extend(cell.views.iter().map(|view| row(view, has_edges)));
    if cell.views.len() > 1 {
        rows.extend(cell.mean_metrics().map(|metrics| {
            let mut row = vec!["mean".to_owned(), String::new()];
            row.extend(shown(&metrics));
            if has_edges {
                row.extend([String::new(), String::new(), cell.recall().map(number).unwrap_or_default()]);
            }
            row
        }));
    }
    let width = |column: usize| rows.iter().map(|row| row[column].len()).max().unwrap_or_default();
    let widths: Vec<usize> = (0..rows[0].len()).map(width).collect();
    let pen = cell.pen.as_ref().map_or(0.0, |pen| pen.width_px);
    let mut text = format!("{} on {}, pen of {pen} px\n", cell.method, cell.mesh.name);
    for row in &rows {
        let fields: Vec<String> = row.iter().zip(&widths).map(|(field, &width)| format!("{field:>width$}")).collect();
        // A String takes whatever is written to it.
        let _ = writeln!(text, "{}", fields.join("  "));
    }
    if let Some(errors) = cell.mean_errors() {
        let _ = writeln!(text, "{}", sentence(&errors));
    }
    text
}

fn row(view: &View, has_edges: bool) -> Vec<String> {
    let mut row = vec![view.frame.to_string(), number(view.truth.visible_length_px)];
    row.extend(shown(&view.metrics));
    if has_edges {
        let of = |value: Option<String>| value.unwrap_or_default();
        row.extend([
            of(view.edges.map(|edges| edges.found.to_string())),
            of(view.edges.map(|edges| number(edges.precision))),
            of(view.edges.map(|edges| number(edges.recall))),
        ]);
    }
    row
}

fn shown(metrics: &PictureMetrics) -> impl Iterator<Item = String> {
    SHOWN.into_iter().map(|name| find(name).and_then(|metric| (metric.value)(metrics)).map(number).unwrap_or_default())
}

/// Four digits after the point, as many as tell a pixel of a line from none; whole numbers without.
fn number(value: f64) -> String {
    if value.fract() == 0.0 { format!("{value}") } else { format!("{value:.4}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_metric_that_is_shown_exists() {
        assert!(SHOWN.iter().all(|name| find(name).is_some()));
        assert_eq!([0.0, 0.12345, 512.0].map(number), ["0", "0.1235", "512"]);
    }
}
