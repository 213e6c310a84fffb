//! The layers that cut the sight line to a point of a stroke.
//!
//! The point is `a + t (b - a)` for a given `f64` `t`, not the rounded place: whether a face cuts the sight line is a
//! matter of determinants that are affine in the point, so that each follows from its values at `a` and `b`, whose signs are
//! exact. Where the sight line passes through an edge of a face the stroke is moved by less than any number: first along
//! itself, then towards its surface side. Every edge is judged in one direction whatever face asks, so that of the faces
//! around a sight line exactly one is cut: no sight line slips between two faces or is stopped twice.

use crate::contours::Layers;
use crate::events::Depth;
use crate::face_tree::FaceTree;
use crate::stroke::Stroke;
use crate::vertex_faces::VertexFace;
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::orientation::{RELATIVE_ERROR, orientation, turn};
use silhouette_core::{FaceId, Facing, TriangleMesh, Viewpoint};

/// Casts sight lines.
#[derive(Clone, Copy)]
pub struct Sight<'a> {
    /// The mesh.
    pub mesh: &'a TriangleMesh,
    /// Its faces by place.
    pub tree: &'a FaceTree,
    /// From where.
    pub viewpoint: Viewpoint,
    /// Which layers count: those in front of a stroke, or all that the line of sight meets.
    pub depth: Depth,
}

/// What a sight line yields.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Seen {
    /// Layers that cut it.
    pub layers: Layers,
    /// Whether every decision was certain. One that was not lies within `2^-28` of the stroke's length from a place where a
    /// determinant vanishes; another `t` will do better.
    pub certain: bool,
    /// Faces that were looked at.
    pub faces: u64,
}

/// A point of a stroke, ready to be judged.
struct Target<'a> {
    stroke: &'a Stroke,
    t: f64,
    place: DVec3,
    toward_viewer: DVec3,
    /// How far the rounded place may be from the point, on any axis.
    error: f64,
}

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

/// A determinant that is affine in the point of the stroke.
#[derive(Debug, Clone, Copy)]
struct Affine {
    at_a: f64,
    at_b: f64,
}

impl Affine {
    /// The sign at `t`, or just beyond it where it vanishes there; 0 only where it vanishes everywhere. And whether rounding
    /// had no part in it.
    fn sign(self, t: f64) -> (i32, bool) {
        let (from_a, from_b) = ((1.0 - t) * self.at_a, t * self.at_b);
        let (value, magnitude) = (from_a + from_b, from_a.abs() + from_b.abs());
        if value == 0.0 {
            return (sign(self.at_b - self.at_a), magnitude == 0.0);
        }
        (sign(value), value.abs() > 4.0 * RELATIVE_ERROR * magnitude)
    }

    /// The sign just inside of an end, 0 for the first and 1 for the second; 0 only where it vanishes everywhere.
    fn sign_near(self, end: usize) -> i32 {
        let [here, there] = if end == 0 { [self.at_a, self.at_b] } else { [self.at_b, self.at_a] };
        if here == 0.0 { sign(there) } else { sign(here) }
    }
}

fn sign(value: f64) -> i32 {
    i32::from(value > 0.0) - i32::from(value < 0.0)
}

impl Sight<'_> {
    /// From a place to the viewer, or a direction towards the viewer where the viewer is at infinity.
    fn toward_viewer(&self, place: DVec3) -> DVec3 {
        match self.viewpoint {
            Viewpoint::Perspective { eye } => eye.as_dvec3() - place,
            Viewpoint::Orthographic { toward_viewer } => toward_viewer.as_dvec3(),
        }
    }

    /// Layers that cut the sight line to the point at `t` of `stroke`, faces for which `is_own` holds left out.
    ///
    /// O(log F + faces along the sight line), times what `is_own` costs.
    pub fn look(&self, stroke: &Stroke, t: f64, is_own: impl Fn(FaceId) -> bool) -> Seen {
        let place = stroke.at(t);
        let toward_viewer = self.toward_viewer(place);
        let error = 4.0 * f64::EPSILON * f64::from(stroke.ends[0].abs().max(stroke.ends[1].abs()).max_element());
        let target = Target { stroke, t, place, toward_viewer, error };
        let mut seen = Seen { layers: Layers::default(), certain: true, faces: 0 };
        let visit = |face| {
            seen.faces += 1;
            if let Some((facing, certain)) = self.cut(&target, face).filter(|_| !is_own(face)) {
                seen.certain &= certain;
                seen.layers.add(facing, 1);
            }
        };
        match self.depth {
            Depth::Nearer => self.tree.faces_toward(&self.viewpoint, place, visit),
            Depth::Any => self.tree.faces_on_line(place, toward_viewer, visit),
        }
        seen
    }

    /// The layers that the faces around a stroke's end add in front of the stroke just inside of that end, faces for which
    /// `is_own` holds left out. Exact. O(faces).
    pub fn near_end(
        &self,
        stroke: &Stroke,
        end: usize,
        faces: &[VertexFace],
        is_own: impl Fn(FaceId) -> bool,
    ) -> Layers {
        let departure = self.departure(stroke, end);
        let positions = self.mesh.positions();
        let mut layers = Layers::default();
        for &VertexFace { face, others } in faces {
            if !departure.leaves_beside(others.map(|other| positions[other as usize])) && !is_own(face) {
                layers.add(self.covers_near_end(stroke, end, face), 1);
            }
        }
        layers
    }

    /// What one face adds there, by exact predicates.
    fn covers_near_end(&self, stroke: &Stroke, end: usize, face: FaceId) -> Layers {
        let (vertices, corners) = (self.mesh.triangles()[face.index()], self.mesh.corners(face));
        let facing = sign(turn(&self.viewpoint, corners[0], corners[1], corners[2]));
        let covers = facing != 0
            && (0..3).all(|slot| {
                let side = self.side(stroke, vertices, corners, slot);
                let near_side = side.affine.sign_near(end) * side.direction;
                facing == if near_side == 0 { self.covering_side(stroke, facing, corners, slot) } else { near_side }
            });
        let counts = || self.depth == Depth::Any || self.height(stroke, corners).sign_near(end) == -facing;
        if covers && counts() { layer(facing) } else { Layers::default() }
    }

    fn departure(&self, stroke: &Stroke, end: usize) -> Departure {
        let corner = stroke.ends[end].as_dvec3();
        let toward_viewer = self.toward_viewer(corner);
        let along = stroke.ends[1 - end].as_dvec3() - corner;
        // Differences and products round alike wherever the mesh lies: within `9u` of six products each.
        let size = |v: DVec3| v.abs().max_element();
        let scale = 64.0 * f64::EPSILON * self.tree.extent() * size(toward_viewer);
        let (error, angle_error) = (scale * size(along), scale * self.tree.extent());
        Departure { corner, toward_viewer, across: toward_viewer.cross(along), error, angle_error }
    }

    /// What a face adds in front of the target, and whether that is certain; `None` for certainly nothing.
    fn cut(&self, target: &Target<'_>, face: FaceId) -> Option<(Layers, bool)> {
        let vertices = self.mesh.triangles()[face.index()];
        let corners = vertices.map(|vertex| self.mesh.positions()[vertex as usize]);
        let sides = rounded_sides(target, corners);
        if sides.contains(&1) && sides.contains(&-1) {
            return None;
        }
        let facing = sign(turn(&self.viewpoint, corners[0], corners[1], corners[2]));
        if facing == 0 {
            return None;
        }
        let mut certain = true;
        for (slot, rounded) in sides.into_iter().enumerate() {
            let mut side = rounded;
            if rounded == 0 {
                let exact = self.side(target.stroke, vertices, corners, slot);
                let (sign, is_certain) = exact.affine.sign(target.t);
                certain &= is_certain;
                side = sign * exact.direction;
                if sign == 0 {
                    side = self.covering_side(target.stroke, facing, corners, slot);
                }
            }
            if side != facing {
                return (!certain).then_some((Layers::default(), false));
            }
        }
        if self.depth == Depth::Any {
            return Some((layer(facing), certain));
        }
        let (above, is_certain) = self.height(target.stroke, corners).sign(target.t);
        certain &= is_certain;
        let layers = if above == -facing { layer(facing) } else { Layers::default() };
        Some((layers, certain))
    }

    /// The side on which a point of the stroke lies of the face's edge from corner `slot` to the next.
    fn side(&self, stroke: &Stroke, vertices: [u32; 3], corners: [Vec3; 3], slot: usize) -> DirectedSide {
        let next = (slot + 1) % 3;
        // One direction for all faces at the edge, so that rounding errs alike for all of them.
        let (low, high, direction) = if vertices[slot] < vertices[next] { (slot, next, 1) } else { (next, slot, -1) };
        let turn_to = |point| turn(&self.viewpoint, corners[low], corners[high], point);
        DirectedSide { affine: Affine { at_a: turn_to(stroke.ends[0]), at_b: turn_to(stroke.ends[1]) }, direction }
    }

    /// The same where the edge covers the stroke: the face's third corner, off their common line, tells which way the edge
    /// runs.
    fn covering_side(&self, stroke: &Stroke, facing: i32, corners: [Vec3; 3], slot: usize) -> i32 {
        let third = corners[(slot + 2) % 3];
        facing * sign(turn(&self.viewpoint, stroke.ends[0], stroke.ends[1], third)) * i32::from(stroke.side)
    }

    /// The height of a point of the stroke above the face's plane.
    fn height(&self, stroke: &Stroke, [u, v, w]: [Vec3; 3]) -> Affine {
        Affine { at_a: orientation(u, v, w, stroke.ends[0]), at_b: orientation(u, v, w, stroke.ends[1]) }
    }
}

/// A side of an edge that may be judged against the direction in which a face has it.
struct DirectedSide {
    affine: Affine,
    direction: i32,
}

fn layer(facing: i32) -> Layers {
    Layers::of(if facing > 0 { Facing::Front } else { Facing::Back })
}

/// For each side of a face, the side on which the sight line passes: 1 for left, -1 for right, and 0 where rounding may have
/// had a part in it.
///
/// `((p - X) x (q - X)) . D` for the rounded place X and the direction D towards the viewer, a sum of six products. In `f64`
/// it errs by at most `9u` times the sum of their magnitudes, and by what the errors of X and D amount to.
fn rounded_sides(target: &Target<'_>, corners: [Vec3; 3]) -> [i32; 3] {
    let [u, v, w] = corners.map(|corner| corner.as_dvec3() - target.place);
    let toward = target.toward_viewer;
    let spread = u.abs().max(v.abs()).max(w.abs()).max_element();
    let (reach, moved) = (toward.abs().max_element(), target.error);
    let rounding = 64.0 * f64::EPSILON * spread * spread * reach;
    let error = rounding + moved * 24.0 * ((spread + moved) * (reach + spread) + moved * moved);
    [u.cross(v), v.cross(w), w.cross(u)].map(|normal| {
        let value = normal.dot(toward);
        i32::from(value > error) - i32::from(value < -error)
    })
}
