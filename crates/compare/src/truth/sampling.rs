//! Silhouette edges projected, clipped to the viewport and sampled.

use super::strokes::Stroke;
use super::{TrueLines, TrueSample};
use glam::{DVec2, DVec3};
use silhouette_core::view::{Camera, Projected, Projection};
use silhouette_core::{EdgeId, TriangleMesh};

/// Distance between samples along a line in the picture, at most.
pub const SPACING_PX: f64 = 0.25;

/// Part of the distance to the target in front of which a perspective edge is cut off: what is closer to the eye's plane
/// projects to infinity.
const NEAR_SHARE: f64 = 1e-6;

/// A point of an edge on its way to becoming a [`TrueSample`]: what decides whether it is visible.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EdgePoint {
    /// The edge.
    pub edge: EdgeId,
    /// The point in object space.
    pub world: DVec3,
    /// Where it appears, inside the viewport, and its depth.
    pub seen: Projected,
}

/// Samples `strokes` as `camera` sees them, keeping those samples for which `is_visible` holds. O(S + length in pixels).
///
/// # Panics
/// If the strokes are of another mesh.
pub fn sample_lines(
    mesh: &TriangleMesh,
    strokes: &[Stroke],
    camera: &Camera,
    mut is_visible: impl FnMut(&EdgePoint) -> bool,
) -> TrueLines {
    let projector = Projector::new(camera);
    let mut lines = TrueLines::default();
    let mut line = Vec::new();
    for stroke in strokes {
        line.clear();
        for segment in &stroke.segments {
            let ends = segment.ends.map(|vertex| mesh.positions()[vertex.index()].as_dvec3());
            projector.sample_edge(segment.edge, ends, &mut is_visible, &mut line);
        }
        lines.push_line(&line, stroke.closed);
    }
    lines
}

struct Projector {
    camera: Camera,
    view: glam::DMat4,
    perspective: bool,
    near: f64,
    size: DVec2,
}

impl Projector {
    fn new(camera: &Camera) -> Self {
        let near = camera.eye().as_dvec3().distance(camera.target().as_dvec3()) * NEAR_SHARE;
        Self {
            camera: *camera,
            view: camera.view_matrix(),
            perspective: matches!(camera.projection(), Projection::Perspective { .. }),
            near,
            size: DVec2::from(camera.size().map(f64::from)),
        }
    }

    /// Appends the samples of the edge from `ends[0]` to `ends[1]`: `None` for what is hidden, and one `None` for each
    /// part that lies outside of the viewport.
    fn sample_edge(
        &self,
        edge: EdgeId,
        ends: [DVec3; 2],
        is_visible: &mut impl FnMut(&EdgePoint) -> bool,
        line: &mut Vec<Option<TrueSample>>,
    ) {
        let Some([from, to]) = self.clip_near(ends.map(|end| (end, self.view.transform_point3(end)))) else {
            line.push(None);
            return;
        };
        let seen = [from, to].map(|(_, view)| self.camera.view_to_pixel(view));
        let Some([begin, end]) = clip_to_rectangle(seen.map(|seen| seen.pixel), self.size) else {
            line.push(None);
            return;
        };
        if begin > 0.0 || from.0 != ends[0] {
            line.push(None);
        }
        let along = seen[1].pixel - seen[0].pixel;
        let length = along.length() * (end - begin);
        // An edge seen end on has no length and no direction: nothing of it is drawn.
        if let Some(tangent) = along.try_normalize() {
            let count = (length / SPACING_PX).ceil().max(1.0);
            for step in 0..count as u32 {
                let share = begin + (end - begin) * (f64::from(step) + 0.5) / count;
                let point = self.point_at(edge, [from.0, to.0], seen, share);
                let sample = TrueSample { pixel: point.seen.pixel, tangent, length_px: length / count, edge };
                line.push(is_visible(&point).then_some(sample));
            }
        }
        if end < 1.0 || to.0 != ends[1] {
            line.push(None);
        }
    }

    /// Cuts off what is behind the eye or nearly so; `None` where nothing remains. Pairs are world and view space.
    fn clip_near(&self, mut ends: [(DVec3, DVec3); 2]) -> Option<[(DVec3, DVec3); 2]> {
        if !self.perspective {
            return Some(ends);
        }
        let depth = ends.map(|(_, view)| -view.z);
        if depth[0] < self.near && depth[1] < self.near {
            return None;
        }
        let original = ends;
        for (this, other) in [(0, 1), (1, 0)] {
            if depth[this] < self.near {
                let share = (self.near - depth[this]) / (depth[other] - depth[this]);
                let cut = |a: DVec3, b: DVec3| a.lerp(b, share);
                ends[this] = (cut(original[this].0, original[other].0), cut(original[this].1, original[other].1));
            }
        }
        Some(ends)
    }

    /// The point at a share of the way from end to end *in the picture*.
    fn point_at(&self, edge: EdgeId, world: [DVec3; 2], seen: [Projected; 2], share: f64) -> EdgePoint {
        let pixel = seen[0].pixel.lerp(seen[1].pixel, share);
        // In a perspective, one over depth is linear in the picture.
        let in_space = if self.perspective {
            share * seen[0].depth / ((1.0 - share) * seen[1].depth + share * seen[0].depth)
        } else {
            share
        };
        let depth = seen[0].depth + (seen[1].depth - seen[0].depth) * in_space;
        EdgePoint { edge, world: world[0].lerp(world[1], in_space), seen: Projected { pixel, depth } }
    }
}

/// Shares of the way between two points at which the line between them enters and leaves the rectangle from the origin
/// to `size` (Liang and Barsky's clipping); `None` where it misses it.
fn clip_to_rectangle([from, to]: [DVec2; 2], size: DVec2) -> Option<[f64; 2]> {
    let along = to - from;
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    for axis in 0..2 {
        for (distance, speed) in [(from[axis], -along[axis]), (size[axis] - from[axis], along[axis])] {
            if speed > 0.0 {
                leave = leave.min(distance / speed);
            } else if speed < 0.0 {
                enter = enter.max(distance / speed);
            } else if distance < 0.0 {
                return None;
            }
        }
    }
    (enter < leave).then_some([enter, leave])
}

#[cfg(test)]
mod tests {
    use super::super::strokes::Segment;
    use super::*;
    use silhouette_core::VertexId;
    use silhouette_core::glam::Vec3;

    fn square_camera(projection: Projection) -> Camera {
        Camera::new(Vec3::new(0.0, 0.0, 4.0), Vec3::ZERO, Vec3::Y, projection, [100, 100]).unwrap()
    }

    /// A triangle and its outline.
    fn outline(positions: [Vec3; 3]) -> (TriangleMesh, Vec<Stroke>) {
        let mesh = TriangleMesh::new(positions.to_vec(), vec![[0, 1, 2]]).unwrap();
        let segment =
            |slot: u32| Segment { edge: EdgeId::new(slot), ends: [VertexId::new(slot), VertexId::new((slot + 1) % 3)] };
        (mesh, vec![Stroke { segments: vec![segment(0), segment(1), segment(2)], closed: true }])
    }

    fn triangle() -> (TriangleMesh, Vec<Stroke>) {
        outline([Vec3::new(-1.0, -1.0, 0.5), Vec3::new(1.0, -1.0, -1.0), Vec3::new(0.0, 1.0, 0.0)])
    }

    #[test]
    fn samples_lie_on_their_edges_in_the_picture_and_in_space() {
        let (mesh, strokes) = triangle();
        for projection in [Projection::Perspective { fov_y_rad: 1.0 }, Projection::Orthographic { height: 4.0 }] {
            let camera = square_camera(projection);
            let mut length = 0.0;
            let lines = sample_lines(&mesh, &strokes, &camera, |point| {
                let seen = camera.project(point.world).unwrap();
                assert!(seen.pixel.distance(point.seen.pixel) < 1e-9 && (seen.depth - point.seen.depth).abs() < 1e-9);
                true
            });
            for segment in &strokes[0].segments {
                let [a, b] = segment
                    .ends
                    .map(|vertex| camera.project(mesh.positions()[vertex.index()].as_dvec3()).unwrap().pixel);
                length += a.distance(b);
            }
            assert!((lines.total_length_px() - length).abs() < 1e-9);
            assert!(lines.samples.iter().all(|sample| sample.length_px <= SPACING_PX));
            assert_eq!((lines.runs.len(), lines.runs[0].closed), (1, true));
            let jumps = lines.samples.windows(2).map(|pair| pair[0].pixel.distance(pair[1].pixel));
            assert!(jumps.fold(0.0, f64::max) < 2.0 * SPACING_PX);
        }
    }

    #[test]
    fn what_is_outside_of_the_viewport_or_behind_the_eye_is_left_out() {
        let (mesh, strokes) = outline([Vec3::new(-1e6, 0.0, 0.0), Vec3::new(1e6, 0.0, 0.0), Vec3::new(0.1, 0.2, 9.0)]);
        let camera = square_camera(Projection::Perspective { fov_y_rad: 1.0 });
        let lines = sample_lines(&mesh, &strokes, &camera, |_| true);
        let inside = |p: DVec2| p.cmpge(DVec2::splat(-1e-9)).all() && p.cmple(DVec2::splat(100.0 + 1e-9)).all();
        assert!(lines.samples.iter().all(|sample| inside(sample.pixel)));
        let horizontal = lines.samples.iter().filter(|sample| sample.edge == EdgeId::new(0));
        assert!((horizontal.map(|sample| sample.length_px).sum::<f64>() - 100.0).abs() < 1e-6);
        assert!(lines.runs.iter().all(|run| !run.closed));
    }

    #[test]
    fn hidden_points_are_left_out() {
        let (mesh, strokes) = triangle();
        let camera = square_camera(Projection::Orthographic { height: 4.0 });
        let lines = sample_lines(&mesh, &strokes, &camera, |point| point.seen.pixel.x < 50.0);
        assert!(!lines.samples.is_empty() && lines.samples.iter().all(|sample| sample.pixel.x < 50.0));
        assert_eq!((lines.runs.len(), lines.runs[0].closed), (1, false));
    }
}
