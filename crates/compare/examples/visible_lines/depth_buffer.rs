//! What a supersampled depth picture decides in place of exact visibility, and how often it is wrong.
//!
//! A depth buffer holds one depth per sample, and a visible contour lies between two samples of which either may show what it
//! bounds. So a line counts as visible where the sample beside it lets it through, and with it count all hidden lines that run
//! within a sample of the contour that hides them. The silhouette of a fine mesh is full of such lines: its contour edges zigzag
//! over each other, hidden and visible by turns, within a fraction of a pixel.

use crate::nearness::Nearness;
use crate::stretches::Stretches;
use silhouette_compare::truth::SPACING_PX;
use silhouette_core::glam::DVec2;
use silhouette_core::{Topology, TriangleMesh};
use silhouette_gpu::ScreenSegment;
use silhouette_render::ReferenceDepth;
use silhouette_visibility::{Chain, Lines, SegmentSource};

/// A hidden line that is called visible this close to a line that is visible hardly shows in a picture.
pub const NEAR_PX: f64 = 1.0;

/// Lengths of line in pixels, visible and hidden.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Disagreement {
    /// All lines.
    pub length_px: f64,
    /// Lines that are visible.
    pub visible_px: f64,
    /// Hidden lines that the depth picture calls visible.
    pub wrongly_visible_px: f64,
    /// Visible lines that it calls hidden.
    pub wrongly_hidden_px: f64,
    /// Hidden lines that it calls visible farther than [`NEAR_PX`] from all that is visible.
    pub far_off_px: f64,
}

impl Disagreement {
    /// Share of the length, 0 to 1, on which exact and sampled visibility differ.
    pub fn share(&self) -> f64 {
        let wrong = self.wrongly_visible_px + self.wrongly_hidden_px;
        if self.length_px > 0.0 { wrong / self.length_px } else { 0.0 }
    }

    /// Adds the lengths of another view.
    pub fn add(&mut self, other: &Self) {
        self.length_px += other.length_px;
        self.visible_px += other.visible_px;
        self.wrongly_visible_px += other.wrongly_visible_px;
        self.wrongly_hidden_px += other.wrongly_hidden_px;
        self.far_off_px += other.far_off_px;
    }
}

/// Compares exact lines, of any invisibility, with what the depth picture of the same view says, every [`SPACING_PX`].
/// O(length in pixels).
///
/// # Panics
/// If lines and depth are of different meshes.
pub fn disagreement(lines: &Lines, depth: &ReferenceDepth, mesh: &TriangleMesh, topology: &Topology) -> Disagreement {
    let mut total = Disagreement::default();
    let visible = Nearness::new(&Stretches::visible(&lines.chains, mesh, topology), NEAR_PX);
    for chain in lines.chains.iter() {
        total.add(&along(&chain, depth, &visible, mesh, topology));
    }
    total
}

fn along(
    chain: &Chain<'_>,
    depth: &ReferenceDepth,
    visible: &Nearness,
    mesh: &TriangleMesh,
    topology: &Topology,
) -> Disagreement {
    let scale = f64::from(depth.samples_per_side());
    let is_visible = chain.style.invisibility == 0;
    let mut seen = Disagreement::default();
    for (segment, source) in chain.sources.iter().enumerate() {
        let [from, to] = chain.segment_pixels(segment);
        let length = from.distance(to);
        let SegmentSource::Edge(edge) = *source else { continue };
        let [a, b] = topology.end_points(edge).map(|vertex| mesh.positions()[vertex.index()].as_dvec3());
        let projected = depth.project(a, b);
        let count = (length / SPACING_PX).ceil();
        for part in 0..count as u32 {
            let share = (f64::from(part) + 0.5) / count;
            let place = from.lerp(to, share);
            let at = place * scale;
            let called_visible =
                projected.is_some_and(|projected| depth.visible_at(&projected, share_along(&projected, at)));
            let step = length / count;
            seen.length_px += step;
            seen.visible_px += if is_visible { step } else { 0.0 };
            match (called_visible, is_visible) {
                (true, false) => {
                    seen.wrongly_visible_px += step;
                    seen.far_off_px += if visible.is_near(place) { 0.0 } else { step };
                }
                (false, true) => seen.wrongly_hidden_px += step,
                _ => {}
            }
        }
    }
    seen
}

/// How far along a segment the point on it is that lies closest to `at`, 0 to 1.
fn share_along(segment: &ScreenSegment, at: DVec2) -> f64 {
    let (from, to) = (segment.at(0.0), segment.at(1.0));
    let along = to - from;
    let length_squared = along.length_squared();
    if length_squared > 0.0 { ((at - from).dot(along) / length_squared).clamp(0.0, 1.0) } else { 0.5 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_compare::truth::finder::silhouette_options;
    use silhouette_core::glam::{DVec3, Vec3};
    use silhouette_core::view::{Camera, Framing};
    use silhouette_core::{NoProgress, PreparedMesh, shapes};
    use silhouette_gpu::MeshBuffers;
    use silhouette_render::{DEFAULT_SUPERSAMPLING, ReferenceRenderer};
    use silhouette_testing::gpu_or_skip;
    use silhouette_visibility::{LineFinder, LineOptions, LineScene};
    use std::sync::Arc;

    #[test]
    fn a_depth_buffer_errs_beside_what_is_visible_and_a_missing_one_wherever_lines_are_hidden() {
        let test = "a_depth_buffer_errs_beside_what_is_visible_and_a_missing_one_wherever_lines_are_hidden";
        let Some(gpu) = gpu_or_skip(test) else { return };
        let mut renderer = ReferenceRenderer::new(gpu).unwrap();
        for shape in ["torus", "knot", "gear"] {
            let mesh = Arc::new(PreparedMesh::new(shapes::by_name(shape).unwrap()));
            let bounds = mesh.mesh().bounds().unwrap();
            let framing = Framing::Perspective { fov_y_rad: 0.8 };
            let camera = Camera::framing(&bounds, DVec3::new(0.3, 0.5, 1.0), Vec3::Y, framing, [256; 2]).unwrap();
            let options = LineOptions { max_invisibility: u32::MAX, ..silhouette_options() };
            let mut finder = LineFinder::new(LineScene::new(Arc::clone(&mesh)), &NoProgress).unwrap();
            let lines = finder.find(&camera, &options, &NoProgress).unwrap();
            let topology = Topology::new(mesh.mesh());
            let mut against = |buffers: &Arc<MeshBuffers>, n| {
                let depth = renderer.depth(gpu, buffers, &camera, n).unwrap();
                disagreement(&lines, &depth, mesh.mesh(), &topology)
            };
            let buffers = Arc::new(MeshBuffers::new(gpu.device(), gpu.queue(), mesh.mesh()).unwrap());
            let [fine, coarse] = [DEFAULT_SUPERSAMPLING, 1].map(|n| against(&buffers, n));
            assert!(fine.share() < coarse.share(), "{shape}: {fine:?}, {coarse:?}");
            let [wrongly_hidden, far_off] = [fine.wrongly_hidden_px, fine.far_off_px].map(|px| px / fine.visible_px);
            assert!(wrongly_hidden < 0.005 && far_off < 0.005, "{shape}: {fine:?}");
            let nothing = TriangleMesh::new(Vec::new(), Vec::new()).unwrap();
            let missing = against(&Arc::new(MeshBuffers::new(gpu.device(), gpu.queue(), &nothing).unwrap()), 1);
            let hidden = missing.length_px - missing.visible_px;
            assert!(hidden > 0.05 * missing.length_px, "{shape}: {missing:?}");
            // Lines are clipped alike up to rounding at the picture's border.
            assert!((missing.wrongly_visible_px - hidden).abs() < 1e-6 && missing.wrongly_hidden_px < 1e-6);
        }
    }
}
