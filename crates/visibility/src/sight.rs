//! Step 6: the layers that cut the sight line to a point of a stroke.
//!
//! The point is `a + t (b - a)` for a given `f64` `t`, not the rounded place: whether a face cuts the sight line is a
//! matter of determinants that are affine in the point, so that each follows from its values at `a` and `b`, whose signs are
//! exact. Where the sight line passes through an edge of a face the stroke is moved by less than any number: first along
//! itself, then towards its surface side. Every edge is judged in one direction whatever face asks, so that of the faces
//! around a sight line exactly one is cut: no sight line slips between two faces or is stopped twice.

use crate::contours::Layers;
use crate::face_tree::FaceTree;
use crate::stroke::Stroke;
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
}

/// What a sight line yields.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Seen {
    /// Layers that cut it.
    pub layers: Layers,
    /// Whether every decision was certain. One that was not lies within `2^-28` of the stroke's length from a place where a
    /// determinant vanishes; another `t` will do better.
    pub certain: bool,
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
}

fn sign(value: f64) -> i32 {
    i32::from(value > 0.0) - i32::from(value < 0.0)
}

impl Sight<'_> {
    /// Layers that cut the sight line to the point at `t` of `stroke`, faces for which `is_own` holds left out. With
    /// `any` the search ends at the first.
    ///
    /// O(log F + faces along the sight line).
    pub fn look(&self, stroke: &Stroke, t: f64, is_own: impl Fn(FaceId) -> bool, any: bool) -> Seen {
        let place = stroke.at(t);
        let toward_viewer = match self.viewpoint {
            Viewpoint::Perspective { eye } => eye.as_dvec3() - place,
            Viewpoint::Orthographic { toward_viewer } => toward_viewer.as_dvec3(),
        };
        let error = 4.0 * f64::EPSILON * stroke.ends[0].abs().max(stroke.ends[1].abs()).max_element() as f64;
        let target = Target { stroke, t, place, toward_viewer, error };
        let mut seen = Seen { layers: Layers::default(), certain: true };
        self.tree.faces_toward(&self.viewpoint, place, |face| {
            if !is_own(face) {
                let (cut, certain) = self.cut(&target, face);
                seen.certain &= certain;
                if let Some(facing) = cut {
                    seen.layers.add(Layers::of(facing), 1);
                    return !any;
                }
            }
            true
        });
        seen
    }

    /// The facing with which a face cuts the sight line, if it does, and whether that is certain.
    fn cut(&self, target: &Target<'_>, face: FaceId) -> (Option<Facing>, bool) {
        let vertices = self.mesh.triangles()[face.index()];
        let corners = vertices.map(|vertex| self.mesh.positions()[vertex as usize]);
        let sides = [0, 1, 2].map(|slot| rounded_side(target, corners[slot], corners[(slot + 1) % 3]));
        if sides.contains(&1) && sides.contains(&-1) {
            return (None, true);
        }
        let facing = sign(turn(&self.viewpoint, corners[0], corners[1], corners[2]));
        if facing == 0 {
            return (None, true);
        }
        let mut certain = true;
        for slot in 0..3 {
            let mut side = sides[slot];
            if side == 0 {
                let next = (slot + 1) % 3;
                let (exact, is_certain) = self.exact_side(target, facing, vertices, corners, [slot, next]);
                (side, certain) = (exact, certain && is_certain);
            }
            if side != facing {
                return (None, certain);
            }
        }
        let [u, v, w] = corners;
        let ends = target.stroke.ends;
        let above = Affine { at_a: orientation(u, v, w, ends[0]), at_b: orientation(u, v, w, ends[1]) };
        let (above, is_certain) = above.sign(target.t);
        let facing_kind = if facing > 0 { Facing::Front } else { Facing::Back };
        ((above == -facing).then_some(facing_kind), certain && is_certain)
    }

    /// The side of the face's edge, from one corner to another, on which the sight line passes.
    fn exact_side(
        &self,
        target: &Target<'_>,
        facing: i32,
        vertices: [u32; 3],
        corners: [Vec3; 3],
        [from, to]: [usize; 2],
    ) -> (i32, bool) {
        // One direction for all faces at the edge, so that rounding errs alike for all of them.
        let (low, high, direction) = if vertices[from] < vertices[to] { (from, to, 1) } else { (to, from, -1) };
        let [a, b] = target.stroke.ends;
        let turn_to = |point| turn(&self.viewpoint, corners[low], corners[high], point);
        let (side, certain) = Affine { at_a: turn_to(a), at_b: turn_to(b) }.sign(target.t);
        if side != 0 {
            return (side * direction, certain);
        }
        // The edge covers the stroke. The face's third corner, off their common line, tells which way the edge runs.
        let third = corners[3 - from - to];
        let third_of_stroke = sign(turn(&self.viewpoint, a, b, third));
        (facing * third_of_stroke * i32::from(target.stroke.side), true)
    }
}

/// The side of the edge from `p` to `q` on which the sight line passes: 1 for left, -1 for right, and 0 where rounding may
/// have had a part in it.
///
/// `((p - X) x (q - X)) . D` for the rounded place X and the direction D towards the viewer. In `f64` it errs by at most `9u`
/// times the sum of the products' magnitudes, and by what the errors of X and D amount to.
fn rounded_side(target: &Target<'_>, p: Vec3, q: Vec3) -> i32 {
    let (x, y, z) = (p.as_dvec3() - target.place, q.as_dvec3() - target.place, target.toward_viewer);
    let (positive, negative) =
        (DVec3::new(x.y * y.z, x.z * y.x, x.x * y.y), DVec3::new(x.z * y.y, x.x * y.z, x.y * y.x));
    let value = (positive - negative).dot(z);
    let magnitude = (positive.abs() + negative.abs()).dot(z.abs());
    let (spread, reach) = (x.abs().max_element() + y.abs().max_element(), z.abs().max_element());
    let moved = target.error * 12.0 * (spread * (reach + spread) + target.error * (spread + reach + target.error));
    let error = 16.0 * f64::EPSILON * magnitude + moved;
    if value > error {
        1
    } else if value < -error {
        -1
    } else {
        0
    }
}
