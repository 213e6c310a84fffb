//! The figures: the paper's with ours, and ours that it lacks.

use super::measure::{MeshResult, Reproduction, VariantResult};
use super::paper::{PaperRow, ROWS};
use super::predicted;
use super::variants::VARIANTS;
use crate::reproduce::Figure;

/// The section of the paper that holds its frame rates.
const PERFORMANCE: &str = "5. Performance";
/// What the paper does not measure.
const QUALITY: &str = "pictures";
/// What the geometry predicts.
const PREDICTED: &str = "spheres";

/// Every figure.
pub fn figures(reproduction: &Reproduction) -> Vec<Figure> {
    let mut figures: Vec<Figure> = ROWS.iter().map(|row| printed(row, reproduction)).collect();
    for mesh in &reproduction.meshes {
        figures.extend(mesh.variants.iter().chain(&mesh.shuffled).flat_map(|result| quality(mesh, result)));
        figures.extend(times(mesh, &reproduction.adapter));
        figures.extend(mesh.sphere_level.into_iter().flat_map(|level| sphere(mesh, level)));
    }
    figures
}

fn figure(table: &str, row: String, metric: &str, unit: &str) -> Figure {
    Figure {
        method: "image-precision".to_owned(),
        table: table.to_owned(),
        row,
        metric: metric.to_owned(),
        unit: unit.to_owned(),
        paper: None,
        ours: None,
        comparable: true,
        note: String::new(),
    }
}

/// Frame rate with silhouettes over the rate without, of a row of the paper and of the mesh that stands in for its model.
fn printed(row: &PaperRow, reproduction: &Reproduction) -> Figure {
    let name = row.stand_in.trim_start_matches("builtin:");
    let mesh = reproduction.meshes.iter().find(|mesh| mesh.name.trim_start_matches("builtin:") == name);
    let ours = mesh.and_then(|mesh| rate_kept(mesh, row.variant));
    let adapter = &reproduction.adapter;
    Figure {
        paper: Some(row.rate_kept()),
        ours,
        note: match ours {
            Some(_) => {
                format!("the model cannot be had: {} stands in for its {} triangles; {adapter}", name, row.triangles)
            }
            None => format!("not measured: name {}", row.stand_in),
        },
        ..figure(PERFORMANCE, format!("{}, {}", row.model, row.variant), "frame rate over plain rendering", "")
    }
}

/// Plain rendering's time over that of a variant; `None` for meshes that were not timed.
pub(super) fn rate_kept(mesh: &MeshResult, label: &str) -> Option<f64> {
    let times = mesh.times.as_ref()?;
    let at = VARIANTS.iter().position(|variant| variant.label == label)?;
    Some(times.plain_ms / times.variants_ms[at]).filter(|rate| rate.is_finite())
}

fn quality(mesh: &MeshResult, result: &VariantResult) -> Vec<Figure> {
    let row = format!("{}, {}", mesh.name, result.variant.label);
    let (score, metrics) = (&result.score, &result.score.metrics);
    let of = |metric: &str, unit: &str, ours: f64| Figure {
        ours: Some(ours),
        note: format!("expected: {}", result.variant.expected),
        ..figure(QUALITY, row.clone(), metric, unit)
    };
    vec![
        of("mean width", "px", metrics.width_mean_px),
        of("deviation of width", "px", metrics.width_deviation_px),
        of("ink over length", "px", score.ink_over_length_px),
        of("missed at 1 px", "%", 100.0 * metrics.missed_1px),
        of("spurious at 1 px", "%", 100.0 * metrics.spurious_1px),
        of("stray", "%", 100.0 * score.stray),
        of("gaps", "per 1000 px", metrics.gaps_per_1000px),
        of("shows through", "%", 100.0 * score.bleed),
        of("farthest ink", "px", score.farthest_px),
    ]
}

fn times(mesh: &MeshResult, adapter: &str) -> Vec<Figure> {
    let Some(times) = &mesh.times else { return Vec::new() };
    let of = |label: &str, metric: &str, ours: f64| Figure {
        ours: Some(ours).filter(|ratio| ratio.is_finite()),
        note: format!("same run, median; {adapter}"),
        ..figure(PERFORMANCE, format!("{}, {label}", mesh.name), metric, "")
    };
    let rows = VARIANTS.iter().zip(&times.variants_ms).flat_map(|(variant, ms)| {
        [
            of(variant.label, "frame time over plain rendering", ms / times.plain_ms),
            of(variant.label, "frame time over plain rendering of front faces", ms / times.plain_culled_ms),
        ]
    });
    rows.collect()
}

/// Predicted values as rows of their own, beside the measured ones of the same name.
fn sphere(mesh: &MeshResult, level: u32) -> Vec<Figure> {
    let of = |label: &str, metric: &str, predicted: f64, note: &str| Figure {
        ours: Some(predicted),
        note: note.to_owned(),
        ..figure(PREDICTED, format!("{}, {label}", mesh.name), metric, "px")
    };
    let geometry = "from the smooth sphere's geometry";
    let mut figures: Vec<Figure> = [("scale 0.99", 0.99), ("scale 0.95", 0.95)]
        .map(|(label, k)| of(label, "ink over length, predicted", predicted::scaled_width_px(k), geometry))
        .into();
    if let Some((_, mean, farthest)) = predicted::FATTENED.into_iter().find(|row| row.0 == level) {
        let earlier = "measured by an earlier experiment";
        figures.push(of("fatten, as printed", "ink over length, predicted", mean, earlier));
        figures.push(of("fatten, as printed", "farthest ink, predicted", farthest, earlier));
    }
    figures
}
