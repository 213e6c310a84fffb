//! The figures: the paper's with ours, and ours that it lacks.

use super::derived;
use super::lost::Lost;
use super::measure::{MeshResult, Reproduction, VariantResult};
use super::printed::{PaperRow, ROWS};
use super::soup::SoupResult;
use super::variants::{AS_PRINTED, UNORIENTED, VARIANTS};
use crate::Figure;

/// The section of the paper that holds its frame rates.
const PERFORMANCE: &str = "5. Performance";
/// What the paper does not measure.
const QUALITY: &str = "pictures";
/// The same, as the command line draws where nothing else is asked.
const SMOOTH: &str = "pictures, 4 samples a pixel";
/// Faces whose number is not read back.
const LOST: &str = "lost faces";
/// Triangles whose winding says nothing.
const SOUP: &str = "soup of a million triangles";
/// What the geometry predicts.
const PREDICTED: &str = "spheres";

/// Every figure.
pub fn figures(reproduction: &Reproduction) -> Vec<Figure> {
    let mut figures: Vec<Figure> = ROWS.iter().map(|row| printed(row, reproduction)).collect();
    for mesh in &reproduction.meshes {
        let single = mesh.variants.iter().chain(&mesh.shuffled);
        figures.extend(single.flat_map(|result| quality(QUALITY, mesh, result)));
        figures.extend(mesh.smooth.iter().flat_map(|result| quality(SMOOTH, mesh, result)));
        figures.extend(mesh.lost.iter().enumerate().flat_map(|(at, lost)| lost_faces(mesh, at, lost)));
        figures.extend(times(mesh, &reproduction.adapter));
        figures.extend(mesh.sphere_level.into_iter().flat_map(|level| sphere(mesh, level)));
    }
    figures.extend(reproduction.soup.iter().flat_map(soup));
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

fn quality(table: &str, mesh: &MeshResult, result: &VariantResult) -> Vec<Figure> {
    let row = format!("{}, {}", mesh.name, result.variant.label);
    let (score, metrics) = (&result.score, &result.score.metrics);
    let of = |metric: &str, unit: &str, ours: f64| Figure {
        ours: Some(ours),
        note: format!("expected: {}", result.variant.expected),
        ..figure(table, row.clone(), metric, unit)
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

fn lost_faces(mesh: &MeshResult, at: usize, lost: &Lost) -> Vec<Figure> {
    let row = format!("{}, {} x {}", mesh.name, lost.size_px, lost.size_px);
    let of = |metric: &str, unit: &str, ours: f64, note: &str| Figure {
        ours: Some(ours),
        note: note.to_owned(),
        ..figure(LOST, row.clone(), metric, unit)
    };
    let visible = format!("of the front faces visible at {} x {}", super::lost::FINE_PX, super::lost::FINE_PX);
    let mut figures = vec![of("faces whose number is not read back", "%", 100.0 * lost.share, &visible)];
    for (variant, extra) in UNORIENTED.iter().zip(lost.extra_px) {
        figures.push(of(&format!("extra ink, {}", variant.label), "px", extra as f64, "beside the oriented variant's"));
    }
    let mut add = |suffix: &str, share: f64, note: &str| {
        figures.push(of(&format!("faces whose number is not read back, {suffix}"), "%", share, note));
    };
    if let Some(shares) = derived::lost(&mesh.name) {
        add("predicted", shares[at], "measured by an earlier experiment in a view that is not known");
    }
    if let Some(views) = mesh.views.and_then(|views| views.lost) {
        let degrees = derived::LOST_FOV_Y_RAD.to_degrees();
        let note = format!("{} views spread evenly, {degrees:.0} degrees", super::spheres::VIEWS);
        add("mean of views", 100.0 * views.mean[at], &note);
        add("least of views", 100.0 * views.least[at], &note);
        add("most of views", 100.0 * views.most[at], &note);
    }
    figures
}

fn soup(result: &SoupResult) -> Vec<Figure> {
    let share = |count: usize, all: usize| 100.0 * count as f64 / all.max(1) as f64;
    let of = |metric: &str, unit: &str, ours: f64| Figure {
        ours: Some(ours),
        note: format!(
            "{} triangles in a random order, half of them turned, beside the oriented mesh",
            result.triangles
        ),
        ..figure(SOUP, result.variant.label.to_owned(), metric, unit)
    };
    vec![
        of("ink", "px", result.ink_px as f64),
        of("false ink", "%", share(result.false_px, result.ink_px)),
        of("ink that lacks", "%", share(result.lacking_px, result.expected_px)),
    ]
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
        .map(|(label, k)| of(label, "ink over length, predicted", derived::scaled_width_px(k), geometry))
        .into();
    if let Some((_, mean, farthest)) = derived::FATTENED.into_iter().find(|row| row.0 == level) {
        let earlier = "measured by an earlier experiment in a view of its own";
        figures.push(of(AS_PRINTED.label, "ink over length, predicted", mean, earlier));
        figures.push(of(AS_PRINTED.label, "farthest ink, predicted", farthest, earlier));
    }
    if let Some(views) = mesh.views {
        let note = format!("{} views spread evenly", super::spheres::VIEWS);
        figures.push(of(AS_PRINTED.label, "ink over length, mean of views", views.mean_width_px, &note));
        figures.push(of(AS_PRINTED.label, "farthest ink, least of views", views.farthest_px[0], &note));
        figures.push(of(AS_PRINTED.label, "farthest ink, most of views", views.farthest_px[1], &note));
    }
    figures
}
