//! Curves, against the silhouette edges of the mesh that they smooth.

use crate::cell::{Found, Outcome};
use crate::truth::Truth;
use silhouette_compare::registry::Entry;
use silhouette_core::NoProgress;
use silhouette_core::curves::{CurveKind, SilhouetteCurves};
use silhouette_core::glam::DVec2;

/// Points on each piece that are compared.
const POINTS: u32 = 8;

/// How far a method's curves and the mesh's silhouette edges, hidden ones too, lie apart in the picture: the distance, in pixels, that
/// 95 % of the points of either keep to the other.
///
/// # Errors
/// A refusal, a fault, or that there is no curve.
pub fn distance_px(entry: &Entry, truth: &Truth<'_>) -> Result<f64, Found> {
    let scene = truth.scene;
    let options = scene.options_of(entry.info().options).map_err(|error| Found::refused(&error))?;
    let mut method = entry.prepare(&scene.mesh, &options, &NoProgress).map_err(|error| Found::refused(&error))?;
    let mut curves = SilhouetteCurves::default();
    let viewpoint = scene.viewpoint()?;
    method.curves().expect("it extracts curves").extract_curves(&viewpoint, &mut curves);
    let pieces = curves.pieces();
    if let Some(piece) = pieces.iter().find(|piece| !piece.control.iter().all(|point| point.is_finite())) {
        return Err(Found::fault(format!("a curve is not finite: {piece:?}")));
    }
    for chain in curves.iter() {
        let joints = chain.pieces.windows(2).map(|pair| [pair[0].control[3], pair[1].control[0]]);
        let ends = chain.closed.then(|| [chain.pieces[chain.pieces.len() - 1].control[3], chain.pieces[0].control[0]]);
        if let Some([end, start]) = joints.chain(ends).find(|[end, start]| end != start) {
            return Err(Found::fault(format!("a chain is interrupted between {end} and {start}")));
        }
    }
    let size = scene.camera.size().map(f64::from);
    let in_picture = |pixel: &DVec2| (0.0..=size[0]).contains(&pixel.x) && (0.0..=size[1]).contains(&pixel.y);
    let drawn: Vec<DVec2> = pieces
        .iter()
        .filter(|piece| piece.kind != CurveKind::Crease)
        .flat_map(|piece| (0..POINTS).map(move |step| piece.point(f64::from(step) / f64::from(POINTS - 1))))
        .filter_map(|point| Some(scene.camera.project(scene.model.transform_point3(point))?.pixel))
        .filter(in_picture)
        .collect();
    if drawn.is_empty() {
        return Err(Found::new(Outcome::Empty, ""));
    }
    let lines = truth.all_lines().map_err(Found::fault)?;
    let truth: Vec<DVec2> = lines.samples.iter().map(|sample| sample.pixel).filter(in_picture).collect();
    if truth.is_empty() {
        return Ok(size[0].hypot(size[1]));
    }
    Ok(farthest_px(&drawn, &truth).max(farthest_px(&truth, &drawn)))
}

/// The distance that 95 % of the points keep to the others.
fn farthest_px(points: &[DVec2], others: &[DVec2]) -> f64 {
    let nearest = |point: &DVec2| others.iter().map(|other| point.distance_squared(*other)).fold(f64::MAX, f64::min);
    let mut distances: Vec<f64> = points.iter().map(nearest).collect();
    distances.sort_by(f64::total_cmp);
    distances[(distances.len() - 1) * 95 / 100].sqrt()
}
