//! Section III-E, perturbation: vertices that stay above the plane of a concave segment, by the printed maximum and by the
//! minimum.
//!
//! Planes are counted that a vertex of the same arc may stand above: up to [`SAME_ARC`] times the height of the segment. Those
//! farther below belong to other parts of the surface, and both laws leave them out.

use super::growth::VIEWS;
use super::subjects::Subject;
use super::window::{Kind, Window};
use crate::directions::spread;
use crate::error::Cause;
use silhouette_core::glam::DVec3;
use silhouette_core::{Method, Progress};
use silhouette_smoothing::concavity::{BlockingPlane, blocking_plane, is_concave};
use silhouette_smoothing::perturbation::{Perturbation, SAME_ARC};
use silhouette_smoothing::{Smoothing, SmoothingOptions, SmoothingView, ViewMesh};
use std::collections::{BTreeMap, BTreeSet};

/// A vertex is above a plane if it is farther from it than this share of the mesh's radius: 32-bit positions are not exact.
const ROUNDING: f64 = 1e-5;

/// What a law does to the vertices near concave segments, over all views.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Lowered {
    /// Vertices near concave segments, averaged over views.
    pub vertices: f64,
    /// Share of them that some plane lies below before they are moved.
    pub above_before: f64,
    /// The same share afterwards.
    pub above: f64,
    /// Share of them that were below all planes and are above one afterwards.
    pub raised: f64,
}

/// Perturbs by a law in every view, seen in perspective.
///
/// # Errors
/// [`Cause`]: cancelled.
pub fn measure(
    subject: &Subject,
    window: &Window,
    perturbation: Perturbation,
    progress: &dyn Progress,
) -> Result<Lowered, Cause> {
    let mut smoothing = Smoothing::new(&subject.mesh, SmoothingOptions { perturbation, ..subject.options() })?;
    let around = around(subject);
    let radius = subject.mesh.mesh().bounds().map_or(1.0, |bounds| bounds.radius);
    let mut out = ViewMesh::default();
    let [mut vertices, mut above_before, mut above, mut raised] = [0_u32; 4];
    for direction in spread(VIEWS) {
        progress.check()?;
        let view = SmoothingView::from_camera(&window.camera(direction, Kind::Perspective)?);
        smoothing.find_silhouette(view.eye());
        smoothing.sample(&view);
        let planes = planes(&smoothing, &view, subject, &around);
        smoothing.perturb(view.eye());
        smoothing.local_remeshing(None, &mut out);
        for (at, &vertex) in smoothing.shading_mesh().vertices().iter().enumerate() {
            let position = smoothing.shading_mesh().positions()[at].as_dvec3();
            let height = |plane: &BlockingPlane, point: DVec3| (point - plane.middle).dot(plane.normal);
            let is_near = |plane: &&BlockingPlane| height(plane, position) <= SAME_ARC * plane.height;
            let near: Vec<&BlockingPlane> = planes.get(&vertex).into_iter().flatten().filter(is_near).collect();
            if near.is_empty() {
                continue;
            }
            let is_above = |point: DVec3| near.iter().any(|plane| height(plane, point) > ROUNDING * radius);
            let [before, after] = [position, out.positions[at].as_dvec3()].map(is_above);
            vertices += 1;
            above_before += u32::from(before);
            above += u32::from(after);
            raised += u32::from(after && !before);
        }
    }
    let share = |count: u32| f64::from(count) / f64::from(vertices.max(1));
    Ok(Lowered {
        vertices: f64::from(vertices) / f64::from(VIEWS),
        above_before: share(above_before),
        above: share(above),
        raised: share(raised),
    })
}

/// The vertices that edges join to each vertex, and itself.
fn around(subject: &Subject) -> BTreeMap<u32, BTreeSet<u32>> {
    let mut around: BTreeMap<u32, BTreeSet<u32>> = BTreeMap::new();
    for corners in subject.mesh.mesh().triangles() {
        corners.iter().for_each(|&corner| around.entry(corner).or_default().extend(corners));
    }
    around
}

/// The planes that each vertex neighbours.
fn planes(
    smoothing: &Smoothing,
    view: &SmoothingView,
    subject: &Subject,
    around: &BTreeMap<u32, BTreeSet<u32>>,
) -> BTreeMap<u32, Vec<BlockingPlane>> {
    let mut of_vertex: BTreeMap<u32, Vec<BlockingPlane>> = BTreeMap::new();
    let silhouette = smoothing.silhouette();
    for segment in silhouette.segments() {
        let ends = segment.points.map(|point| &silhouette.points()[point as usize]);
        let plane = is_concave(ends).then(|| blocking_plane(segment, ends, view.eye())).flatten();
        let Some(plane) = plane else { continue };
        let corners = subject.mesh.mesh().triangles()[segment.triangle.face.index()];
        let near: BTreeSet<u32> = corners.iter().flat_map(|corner| &around[corner]).copied().collect();
        near.into_iter().for_each(|vertex| of_vertex.entry(vertex).or_default().push(plane));
    }
    of_vertex
}

#[cfg(test)]
mod tests {
    use super::super::subjects::subjects;
    use super::*;
    use silhouette_compare::NamedMesh;
    use silhouette_core::{NoProgress, PreparedMesh, shapes};

    #[test]
    fn the_printed_maximum_raises_vertices_and_the_minimum_raises_none() {
        let mesh = std::sync::Arc::new(PreparedMesh::new(shapes::by_name("torus:24,12").unwrap()));
        let window = Window::unmagnified(mesh.mesh().bounds().unwrap());
        let subject = &subjects(&[NamedMesh { name: "builtin:torus:24,12".to_owned(), mesh }]).unwrap().0[0];
        let of = |law| measure(subject, &window, law, &NoProgress).unwrap();
        let [off, lowered, printed] = [Perturbation::Off, Perturbation::Lowered, Perturbation::AsPrinted].map(of);
        assert!(off.vertices > 10.0 && (off.above - off.above_before).abs() < 1e-12 && off.raised <= 0.0, "{off:?}");
        assert!(lowered.above < 0.2 * off.above && lowered.raised <= 0.0, "{lowered:?}");
        assert!(printed.above > off.above && printed.raised > 0.1, "{printed:?}");
    }
}
