//! Brute force that shares no code with the crate: every face against a sight line, in integers, as the displaced viewer
//! sees it. Nothing is skipped: ties follow the rules that the crate states.
//!
//! A point is four integers, its coordinates and a weight above 0; the viewer is five such points, one for each power of
//! the infinitesimal: the eye (or a direction, of weight 0), the middle of the scene, and the three axes.

use num_bigint::BigInt;
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::{TriangleMesh, Viewpoint};
use std::ops::{Add, Mul, Sub};

/// A parameter along an edge is a multiple of this, so that points of the edge are exact.
pub const STEPS: i64 = 1 << 20;

/// The parameter next to `t` at which the oracle can look, strictly between 0 and 1.
pub fn nearest_step(t: f64) -> i64 {
    ((t * STEPS as f64).round() as i64).clamp(1, STEPS - 1)
}

/// Integers wide enough for a scene.
pub trait Whole:
    Clone + Default + PartialOrd + From<i64> + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self>
{
}

impl<T> Whole for T where
    T: Clone + Default + PartialOrd + From<i64> + Add<Output = T> + Sub<Output = T> + Mul<Output = T>
{
}

type Point<T> = [T; 4];

fn sign<T: Whole>(value: &T) -> i32 {
    let zero = T::default();
    i32::from(*value > zero) - i32::from(*value < zero)
}

/// Six times the volume of the tetrahedron, times all weights: above 0 where `a b c` run counter-clockwise as seen from `d`.
fn volume<T: Whole>([a, b, c, d]: [&Point<T>; 4]) -> T {
    let minor = |rows: [&Point<T>; 3]| {
        let [p, q, r] = rows;
        let product = |i: usize, j: usize, k: usize| p[i].clone() * q[j].clone() * r[k].clone();
        product(0, 1, 2) + product(1, 2, 0) + product(2, 0, 1) - product(2, 1, 0) - product(1, 0, 2) - product(0, 2, 1)
    };
    // Along the column of weights.
    let (of_a, of_b) = (a[3].clone() * minor([b, c, d]), b[3].clone() * minor([a, c, d]));
    let (of_c, of_d) = (c[3].clone() * minor([a, b, d]), d[3].clone() * minor([a, b, c]));
    of_a - of_b + of_c - of_d
}

/// A face at an edge, as the place of the corner that the edge does not have, and its index.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Wing {
    face: usize,
    apex: u32,
}

/// A mesh and a viewer in integers.
pub struct Oracle<T> {
    points: Vec<Point<T>>,
    triangles: Vec<[u32; 3]>,
    viewer: [Point<T>; 5],
    /// Facing of each face: 1 for front, -1 for back, 0 without area.
    facings: Vec<i32>,
    rounded: Rounded,
}

/// The scene in floats, for what is far from any tie.
struct Rounded {
    positions: Vec<Vec3>,
    viewpoint: Viewpoint,
}

/// Any finite `f32` as a multiple of `2^-149`.
fn multiple_of_the_least(value: f32) -> BigInt {
    let bits = value.to_bits();
    let (exponent, fraction) = ((bits >> 23 & 0xff) as i32, i64::from(bits & 0x7f_ffff));
    let significand = if exponent == 0 { fraction } else { fraction | 1 << 23 };
    BigInt::from(if bits >> 31 == 1 { -significand } else { significand }) << (exponent.max(1) - 1)
}

impl Oracle<BigInt> {
    /// Of any mesh.
    pub fn new(mesh: &TriangleMesh, viewpoint: &Viewpoint) -> Self {
        // Coordinates and weights are multiples of the same: only signs matter.
        let one = BigInt::from(1) << 149;
        Self::of(mesh, viewpoint, &multiple_of_the_least, &one)
    }
}

impl Oracle<i128> {
    /// Of a mesh and a viewer at whole coordinates of a few digits.
    pub fn of_whole(mesh: &TriangleMesh, viewpoint: &Viewpoint) -> Self {
        // The middle of the scene may have halves.
        let twice = |value: f32| {
            assert!((value * 2.0).fract() == 0.0 && value.abs() < 1000.0, "{value}");
            (value * 2.0) as i128
        };
        Self::of(mesh, viewpoint, &twice, &2)
    }
}

impl<T: Whole> Oracle<T> {
    fn of(mesh: &TriangleMesh, viewpoint: &Viewpoint, whole: &dyn Fn(f32) -> T, one: &T) -> Self {
        let at = |p: Vec3, weight: T| [whole(p.x), whole(p.y), whole(p.z), weight];
        let zero = T::default;
        let eye = match *viewpoint {
            Viewpoint::Perspective { eye } => at(eye, one.clone()),
            Viewpoint::Orthographic { toward_viewer } => at(toward_viewer, zero()),
        };
        let center = at(mesh.bounds().map_or(Vec3::ZERO, |bounds| bounds.center.as_vec3()), one.clone());
        let axes = [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| at(axis, zero()));
        let [x, y, z] = axes;
        let mut oracle = Self {
            points: mesh.positions().iter().map(|&position| at(position, one.clone())).collect(),
            triangles: mesh.triangles().to_vec(),
            viewer: [eye, center, x, y, z],
            facings: Vec::new(),
            rounded: Rounded { positions: mesh.positions().to_vec(), viewpoint: *viewpoint },
        };
        let corners = |triangle: &[u32; 3]| triangle.map(|vertex| oracle.point(vertex));
        oracle.facings = mesh.triangles().iter().map(|triangle| oracle.turn(corners(triangle)).0).collect();
        oracle
    }

    fn point(&self, vertex: u32) -> &Point<T> {
        &self.points[vertex as usize]
    }

    /// How three points turn as the displaced viewer sees them, and by which power.
    fn turn(&self, [a, b, c]: [&Point<T>; 3]) -> (i32, usize) {
        let signs = self.viewer.iter().map(|eye| sign(&volume([a, b, c, eye])));
        signs.zip(0..).find(|(sign, _)| *sign != 0).unwrap_or((0, usize::MAX))
    }

    /// On which side of a face's plane a point lies.
    fn height(&self, face: usize, point: &Point<T>) -> i32 {
        let [u, v, w] = self.triangles[face].map(|vertex| self.point(vertex));
        sign(&volume([u, v, w, point]))
    }

    /// The faces that have both ends of an edge among their corners, with the third.
    fn faces_at(&self, [a, b]: [u32; 2]) -> impl Iterator<Item = Wing> + '_ {
        self.triangles.iter().enumerate().flat_map(move |(face, corners)| {
            (0..3).filter_map(move |slot| {
                let (from, to) = (corners[slot], corners[(slot + 1) % 3]);
                let is_edge = [from, to] == [a, b] || [from, to] == [b, a];
                is_edge.then_some(Wing { face, apex: corners[(slot + 2) % 3] })
            })
        })
    }

    /// The same, a face without area giving way to those across its longest side.
    fn wings(&self, edge: [u32; 2], most: u32) -> Vec<Wing> {
        let mut wings = Vec::new();
        for wing in self.faces_at(edge) {
            if self.facings[wing.face] != 0 {
                wings.push(wing);
            } else if most > 0 {
                let longest = self.longest_side(wing.face);
                let mut of_edge = edge;
                let mut sorted = longest;
                of_edge.sort_unstable();
                sorted.sort_unstable();
                if sorted != of_edge {
                    wings.extend(self.wings(longest, most - 1).into_iter().filter(|across| across.face != wing.face));
                }
            }
        }
        wings
    }

    fn longest_side(&self, face: usize) -> [u32; 2] {
        let corners = self.triangles[face];
        let side = |slot: usize| [corners[slot], corners[(slot + 1) % 3]];
        let length = |slot: usize| {
            let [a, b] = side(slot).map(|vertex| self.rounded.positions[vertex as usize].as_dvec3());
            a.distance_squared(b)
        };
        side((1..3).fold(0, |longest, slot| if length(slot) > length(longest) { slot } else { longest }))
    }

    /// Wings to the left and to the right of an edge.
    fn beside(&self, [a, b]: [u32; 2]) -> [Vec<Wing>; 2] {
        let side = |wing: &Wing| self.turn([self.point(a), self.point(b), self.point(wing.apex)]).0;
        self.wings([a, b], 8).into_iter().partition::<Vec<_>, _>(|wing| side(wing) >= 0).into()
    }

    /// The corner towards which an edge is moved where something touches it.
    fn surface(&self, edge: [u32; 2]) -> Option<u32> {
        let place = |vertex: u32| self.rounded.positions[vertex as usize].to_array();
        let [a, b] = if place(edge[1]) < place(edge[0]) { [edge[1], edge[0]] } else { edge };
        let [left, right] = self.beside([a, b]);
        let (wings, side) = if left.len() >= right.len() { (left, 1) } else { (right, -1) };
        let mut nearest: Option<u32> = None;
        for Wing { apex, .. } in wings {
            let is_nearer = nearest.is_none_or(|than| {
                let [a, b, than, apex] = [a, b, than, apex].map(|vertex| self.point(vertex));
                sign(&volume([a, b, than, apex])) * side > 0
            });
            nearest = if is_nearer { Some(apex) } else { nearest };
        }
        nearest
    }

    /// Whether an edge is a silhouette edge that is drawn: all wings on one side, or the near rim of a wall seen edge-on.
    pub fn is_silhouette(&self, [a, b]: [u32; 2]) -> bool {
        let [left, right] = self.beside([a, b]);
        if left.len() + right.len() >= 2 && (left.is_empty() || right.is_empty()) {
            return true;
        }
        let turn = |wing: &Wing| self.turn([self.point(a), self.point(b), self.point(wing.apex)]);
        let (walls, seen): (Vec<Wing>, Vec<Wing>) =
            [left, right].concat().into_iter().partition(|wing| turn(wing).1 > 0);
        // It recedes where it lies beyond the plane of a face beside it.
        let recedes = |wall: &Wing| {
            let [a, b, beside, apex] = [a, b, seen[0].apex, wall.apex].map(|vertex| self.point(vertex));
            sign(&volume([a, b, beside, apex])) * turn(&seen[0]).0 < 0
        };
        !walls.is_empty()
            && !seen.is_empty()
            && seen.iter().all(|wing| turn(wing).0 == turn(&seen[0]).0)
            && walls.iter().all(recedes)
    }

    /// Whether an edge has a single wing, and is not covered by the other sides of a face without area.
    pub fn is_boundary(&self, edge: [u32; 2]) -> bool {
        !self.is_covered(edge) && self.wings(edge, 8).len() == 1
    }

    /// Whether a face without area has an edge as its longest side.
    pub fn is_covered(&self, edge: [u32; 2]) -> bool {
        let is_longest = |wing: Wing| {
            let longest = self.longest_side(wing.face);
            self.facings[wing.face] == 0 && (longest == edge || longest == [edge[1], edge[0]])
        };
        self.faces_at(edge).any(is_longest)
    }

    /// Number of solids or sheets in front of the point `step / STEPS` of an edge, and whether a tie had to be broken.
    pub fn invisibility(&self, edge: [u32; 2], step: i64) -> (u32, bool) {
        let own: Vec<usize> = self.faces_at(edge).map(|wing| wing.face).collect();
        let mut surface = None;
        let (mut front, mut back, mut tie) = (0, 0, false);
        for face in (0..self.triangles.len()).filter(|face| !own.contains(face)) {
            let hides = match self.rounded.verdict(self.triangles[face], edge, step) {
                Verdict::Missed => false,
                Verdict::Cut => true,
                Verdict::Doubt => {
                    tie = true;
                    self.hides(face, edge, step, || *surface.get_or_insert_with(|| self.surface(edge)))
                }
            };
            if hides && self.facings[face] > 0 {
                front += 1;
            } else if hides {
                back += 1;
            }
        }
        (front.max(back), tie)
    }

    fn hides(&self, face: usize, [a, b]: [u32; 2], step: i64, mut surface: impl FnMut() -> Option<u32>) -> bool {
        let (facing, corners) = (self.facings[face], self.triangles[face]);
        if facing == 0 {
            return false;
        }
        let [from, to] = [a, b].map(|vertex| self.point(vertex));
        let blend = |at: usize| from[at].clone() * T::from(STEPS - step) + to[at].clone() * T::from(step);
        let place: Point<T> = [0, 1, 2, 3].map(blend);
        let is_inside = (0..3).all(|slot| {
            let [p, q] = [corners[slot], corners[(slot + 1) % 3]].map(|vertex| self.point(vertex));
            let side = self.turn([p, q, &place]).0;
            let of_surface = |apex| self.turn([p, q, self.point(apex)]).0;
            (if side == 0 { surface().map_or(0, of_surface) } else { side }) == facing
        });
        if !is_inside {
            return false;
        }
        let height = self.height(face, &place);
        let height = if height == 0 { surface().map_or(0, |apex| self.height(face, self.point(apex))) } else { height };
        height == -facing
    }
}

enum Verdict {
    Missed,
    Doubt,
    Cut,
}

impl Rounded {
    /// In floats, with a wide margin.
    fn verdict(&self, triangle: [u32; 3], edge: [u32; 2], step: i64) -> Verdict {
        const MARGIN: f64 = 1e-9;
        let position = |vertex: u32| self.positions[vertex as usize];
        let (corners, [a, b]) = (triangle.map(position), edge.map(position));
        let place = a.as_dvec3() + (b.as_dvec3() - a.as_dvec3()) * (step as f64 / STEPS as f64);
        let toward = match self.viewpoint {
            Viewpoint::Perspective { eye } => eye.as_dvec3() - place,
            Viewpoint::Orthographic { toward_viewer } => toward_viewer.as_dvec3(),
        };
        let [u, v, w]: [DVec3; 3] = corners.map(|corner| corner.as_dvec3() - place);
        let reach = u.length() + v.length() + w.length() + f64::from(a.abs().max(b.abs()).max_element());
        let margin = MARGIN * reach * reach * toward.length();
        let sides = [u.cross(v).dot(toward), v.cross(w).dot(toward), w.cross(u).dot(toward)];
        if sides.iter().any(|&side| side > margin) && sides.iter().any(|&side| side < -margin) {
            return Verdict::Missed;
        }
        if sides.iter().any(|side| side.abs() <= margin) {
            return Verdict::Doubt;
        }
        let facing = if sides[0] > 0.0 { 1.0 } else { -1.0 };
        let normal = (v - u).cross(w - u);
        let above_point = -normal.dot(u) * facing;
        let above_eye = match self.viewpoint {
            Viewpoint::Perspective { .. } => normal.dot(toward - u) * facing,
            Viewpoint::Orthographic { .. } => f64::INFINITY,
        };
        let margin = MARGIN * reach * reach * (reach + toward.length());
        if above_point > margin || above_eye < -margin {
            Verdict::Missed
        } else if above_point < -margin && above_eye > margin {
            Verdict::Cut
        } else {
            Verdict::Doubt
        }
    }
}
