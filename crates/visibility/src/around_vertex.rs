//! What the faces around a vertex add in front of the strokes that end there.

use crate::layers::Layers;
use crate::sight::Sight;
use crate::stroke::Stroke;
use crate::vertex_faces::VertexFace;
use silhouette_core::FaceId;
use silhouette_core::glam::{DVec3, Vec3};

/// The direction in which a stroke leaves one of its ends.
struct Departure {
    corner: DVec3,
    toward_viewer: DVec3,
    /// Across the stroke and the line of sight.
    across: DVec3,
    /// How far rounding may move a product with `across`.
    error: f64,
    /// How far rounding may move a product of two edges and the direction towards the viewer.
    angle_error: f64,
}

impl Departure {
    fn new(sight: &Sight<'_>, stroke: &Stroke, end: usize) -> Self {
        let corner = stroke.ends[end].as_dvec3();
        let toward_viewer = sight.toward_viewer(corner);
        let along = stroke.ends[1 - end].as_dvec3() - corner;
        // Differences and products round alike wherever the mesh lies: within `9u` of six products each.
        let size = |v: DVec3| v.abs().max_element();
        let scale = 64.0 * f64::EPSILON * sight.tree.extent() * size(toward_viewer);
        let (error, angle_error) = (scale * size(along), scale * sight.tree.extent());
        Self { corner, toward_viewer, across: toward_viewer.cross(along), error, angle_error }
    }

    /// Whether the stroke certainly leaves a corner of a face outside of the face's angle there, in the picture. `others` are
    /// the face's other corners in order.
    #[inline]
    fn leaves_beside(&self, others: [Vec3; 2]) -> bool {
        let [next, last] = others.map(|other| other.as_dvec3() - self.corner);
        // Most faces lie on one side of the stroke's line.
        let (left, right) = (self.across.dot(next), self.across.dot(last));
        if left.min(right) > self.error || left.max(right) < -self.error {
            return true;
        }
        // Of the rest, the stroke leaves one half backwards.
        let sides = [left, right].map(|value| certain_sign(value, self.error));
        let angle = certain_sign(next.cross(last).dot(self.toward_viewer), self.angle_error);
        sides[0] * sides[1] < 0 && angle == sides[0]
    }
}

/// The sign of a value that errs by at most `error`, or 0 where that is not certain.
fn certain_sign(value: f64, error: f64) -> i32 {
    i32::from(value > error) - i32::from(value < -error)
}

impl Sight<'_> {
    /// The layers that the faces around a stroke's end add in front of the stroke infinitesimally inside of that end, faces for
    /// which `is_own` holds left out. Exact. O(faces).
    pub fn layers_near_end(
        &self,
        stroke: &Stroke,
        end: usize,
        faces: &[VertexFace],
        is_own: impl Fn(FaceId) -> bool,
    ) -> Layers {
        let departure = Departure::new(self, stroke, end);
        let mut layers = Layers::NONE;
        for &VertexFace { face, others } in faces {
            if !is_own(face) && !departure.leaves_beside(others.map(|other| self.view.position(other))) {
                layers.add(self.near_end(stroke, end, face), 1);
            }
        }
        layers
    }
}
