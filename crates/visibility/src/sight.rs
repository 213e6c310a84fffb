//! The layers that cut the sight line to a point of a stroke.
//!
//! The point is `a + t (b - a)` for a given `f64` `t`, not the rounded place: whether a face cuts the sight line is a
//! matter of determinants that are affine in the point, so that each follows from its values at `a` and `b`, whose signs are
//! exact for the displaced viewer. Those that vanish all along the stroke do so because the face touches it in space: then
//! the stroke is moved infinitesimally towards [its surface](crate::surface), so that an edge is as visible as the surface
//! beside it, and not hidden by a face in the plane of that surface. Every edge of a face is judged in one direction whatever
//! face asks, so that of the faces around a sight line exactly one is cut: no sight line slips between two faces or is
//! stopped twice.

use crate::chains::SegmentSource;
use crate::face_tree::FaceTree;
use crate::layers::Layers;
use crate::stroke::Stroke;
use crate::viewed_mesh::ViewedMesh;
use silhouette_core::displaced::{Turn, of_one_power};
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::orientation::{RELATIVE_ERROR, orientation};
use silhouette_core::{FaceId, Facing, FacingRule, Viewpoint};

/// Casts sight lines.
#[derive(Clone, Copy)]
pub struct Sight<'a> {
    /// The mesh and its viewer.
    pub view: ViewedMesh<'a>,
    /// Its faces by place.
    pub tree: &'a FaceTree,
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

/// Two signs of a determinant that is affine in the point of a stroke: at its ends.
#[derive(Debug, Clone, Copy)]
pub struct AlongStroke([Turn; 2]);

impl AlongStroke {
    /// The sign at `t`, or just beyond it where it vanishes there; 0 only where it vanishes everywhere. And whether rounding
    /// had no part in it.
    fn sign(self, t: f64) -> (i32, bool) {
        let [at_a, at_b] = of_one_power(self.0);
        let (from_a, from_b) = ((1.0 - t) * at_a, t * at_b);
        let (value, magnitude) = (from_a + from_b, from_a.abs() + from_b.abs());
        if value == 0.0 {
            return (sign(at_b - at_a), magnitude == 0.0);
        }
        (sign(value), value.abs() > 4.0 * RELATIVE_ERROR * magnitude)
    }

    /// The sign infinitesimally inside of an end, 0 for the first and 1 for the second; 0 only where it vanishes everywhere.
    pub fn sign_near(self, end: usize) -> i32 {
        let [here, there] = if end == 0 { self.0 } else { [self.0[1], self.0[0]] };
        if here.sign() == 0 { there.sign() } else { here.sign() }
    }
}

fn sign(value: f64) -> i32 {
    i32::from(value > 0.0) - i32::from(value < 0.0)
}

impl Sight<'_> {
    /// From a place to the viewer, or a direction towards the viewer where the viewer is at infinity.
    pub fn toward_viewer(&self, place: DVec3) -> DVec3 {
        match *self.view.viewer.viewpoint() {
            Viewpoint::Perspective { eye } => eye.as_dvec3() - place,
            Viewpoint::Orthographic { toward_viewer } => toward_viewer.as_dvec3(),
        }
    }

    /// The apex of the wing that a stroke belongs to; `None` for a stroke that is no mesh edge. O(1) after the first call.
    pub fn surface(&self, stroke: &Stroke) -> Option<Vec3> {
        let SegmentSource::Edge(edge) = stroke.source else { return None };
        *stroke.surface.get_or_init(|| self.view.surface_at(edge))
    }

    /// Layers that cut the sight line to the point at `t` of `stroke`, faces for which `is_own` holds left out.
    ///
    /// O(log F + faces along the sight line), times what `is_own` costs.
    pub fn look(&self, stroke: &Stroke, t: f64, is_own: impl Fn(FaceId) -> bool) -> Seen {
        let place = stroke.at(t);
        let toward_viewer = self.toward_viewer(place);
        let error = 4.0 * f64::EPSILON * f64::from(stroke.ends[0].abs().max(stroke.ends[1].abs()).max_element());
        let target = Target { stroke, t, place, toward_viewer, error };
        let mut seen = Seen { layers: Layers::NONE, certain: true, faces: 0 };
        self.tree.faces_toward(self.view.viewer.viewpoint(), place, |face| {
            seen.faces += 1;
            if let Some((facing, certain)) = self.cut(&target, face).filter(|_| !is_own(face)) {
                seen.certain &= certain;
                seen.layers.add(facing, 1);
            }
        });
        seen
    }

    /// What a face adds in front of the target, and whether that is certain; `None` for certainly nothing.
    #[inline]
    fn cut(&self, target: &Target<'_>, face: FaceId) -> Option<(Layers, bool)> {
        let vertices = self.view.mesh.triangles()[face.index()];
        let corners = vertices.map(|vertex| self.view.position(vertex));
        let sides = rounded_sides(target, corners);
        if sides.contains(&1) && sides.contains(&-1) {
            return None;
        }
        let facing = self.view.viewer.turn(corners[0], corners[1], corners[2]).sign();
        if facing == 0 {
            return None;
        }
        let mut certain = true;
        for (slot, rounded) in sides.into_iter().enumerate() {
            let mut side = rounded;
            if rounded == 0 {
                let exact = self.side(target.stroke, vertices, corners, slot);
                let (sign, is_certain) = exact.along.sign(target.t);
                certain &= is_certain;
                side = if sign == 0 { self.side_of_surface(target.stroke, corners, &exact) } else { sign }
                    * exact.direction;
            }
            if side != facing {
                return (!certain).then_some((Layers::NONE, false));
            }
        }
        let (mut above, is_certain) = self.height(target.stroke, corners).sign(target.t);
        certain &= is_certain;
        if above == 0 {
            above = self.height_of_surface(target.stroke, corners);
        }
        let layers = if above == -facing { layer(facing) } else { Layers::NONE };
        Some((layers, certain))
    }

    /// What one face adds in front of a stroke infinitesimally inside of an end. Exact. O(1).
    pub fn near_end(&self, stroke: &Stroke, end: usize, face: FaceId) -> Layers {
        let (vertices, corners) = (self.view.mesh.triangles()[face.index()], self.view.mesh.corners(face));
        let facing = self.view.viewer.turn(corners[0], corners[1], corners[2]).sign();
        let covers = facing != 0
            && (0..3).all(|slot| {
                let exact = self.side(stroke, vertices, corners, slot);
                let sign = exact.along.sign_near(end);
                let side = if sign == 0 { self.side_of_surface(stroke, corners, &exact) } else { sign };
                side * exact.direction == facing
            });
        if !covers {
            return Layers::NONE;
        }
        let above = self.height(stroke, corners).sign_near(end);
        let above = if above == 0 { self.height_of_surface(stroke, corners) } else { above };
        if above == -facing { layer(facing) } else { Layers::NONE }
    }

    /// On which side of the face's edge from corner `slot` to the next the points of the stroke lie.
    fn side(&self, stroke: &Stroke, vertices: [u32; 3], corners: [Vec3; 3], slot: usize) -> DirectedSide {
        let next = (slot + 1) % 3;
        // One direction for all faces at the edge, so that rounding errs alike for all of them.
        let (low, high, direction) = if vertices[slot] < vertices[next] { (slot, next, 1) } else { (next, slot, -1) };
        let turn_to = |point| self.view.viewer.turn(corners[low], corners[high], point);
        DirectedSide { along: AlongStroke(stroke.ends.map(turn_to)), edge: [low, high], direction }
    }

    /// On which side of an edge on the stroke's own line the stroke's surface lies. Without a surface, the same for all faces
    /// at the edge.
    #[cold]
    fn side_of_surface(&self, stroke: &Stroke, corners: [Vec3; 3], side: &DirectedSide) -> i32 {
        let [low, high] = side.edge;
        self.surface(stroke).map_or(1, |apex| self.view.viewer.turn(corners[low], corners[high], apex).sign())
    }

    /// The height of the points of the stroke above the face's plane.
    fn height(&self, stroke: &Stroke, [u, v, w]: [Vec3; 3]) -> AlongStroke {
        AlongStroke(stroke.ends.map(|end| Turn { power: 0, value: orientation(u, v, w, end) }))
    }

    /// On which side of a face in whose plane the stroke lies the stroke's surface is; 0 where it lies in the same plane.
    #[cold]
    fn height_of_surface(&self, stroke: &Stroke, [u, v, w]: [Vec3; 3]) -> i32 {
        self.surface(stroke).map_or(0, |apex| sign(orientation(u, v, w, apex)))
    }
}

/// A side of a face's edge, with the direction in which the edge is judged.
struct DirectedSide {
    along: AlongStroke,
    /// Slots of the corners from which and to which it is judged.
    edge: [usize; 2],
    /// 1 where the face has the edge in that direction, otherwise -1.
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
#[inline]
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
