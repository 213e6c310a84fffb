//! What one would write without thinking: facing by plane equations in 32 bits, and one 32-bit matrix from the mesh's own space to clip
//! space.

use crate::scene::Scene;
use silhouette_core::glam::{DVec2, Vec3};
use silhouette_core::{FaceFacings, SilhouetteEdges, Topology, Viewpoint};
use silhouette_gpu::{FrameView, LocalFrame};
use silhouette_testing::prepare::artefact;
use std::sync::Arc;

/// Silhouette edges by `n . P + d > 0` in 32 bits.
pub fn edges(scene: &Scene) -> SilhouetteEdges {
    let mesh = scene.mesh.mesh();
    let topology: Arc<Topology> = artefact(&scene.mesh);
    let facings = FaceFacings::from_fn(mesh.face_count(), |face| {
        let [a, b, c] = mesh.corners(face);
        let normal = (b - a).cross(c - a);
        match scene.camera.viewpoint() {
            Viewpoint::Perspective { eye } => normal.dot(eye) - normal.dot(a) > 0.0,
            Viewpoint::Orthographic { toward_viewer } => normal.dot(toward_viewer) > 0.0,
        }
    });
    SilhouetteEdges::of(&topology, &facings)
}

/// How far the farthest vertex is from where it should be in the picture, in pixels: by one 32-bit matrix, and as it is drawn here.
pub fn displacements_px(scene: &Scene, view: &FrameView) -> [f64; 2] {
    let mesh = scene.mesh.mesh();
    let size = scene.camera.size().map(f64::from);
    let frame = LocalFrame::new(mesh.bounds().as_ref());
    let (naive, local) = (view.object_to_clip().as_mat4(), frame.to_clip(view).as_mat4());
    let farthest = |place: &dyn Fn(Vec3) -> silhouette_core::glam::Vec4| {
        let distance = |position: &Vec3| {
            let clip = place(*position);
            let pixel = DVec2::new(f64::from(clip.x / clip.w), -f64::from(clip.y / clip.w));
            let pixel = (pixel + 1.0) * 0.5 * DVec2::from(size);
            let exact = scene.camera.project(position.as_dvec3()).map_or(pixel, |seen| seen.pixel);
            // What is no number is anywhere in the picture.
            if pixel.is_finite() { pixel.distance(exact).min(size[0]) } else { size[0] }
        };
        mesh.positions().iter().map(distance).fold(0.0, f64::max)
    };
    [farthest(&|p| naive * p.extend(1.0)), farthest(&|p| local * frame.to_local(p.as_dvec3()).extend(1.0))]
}
