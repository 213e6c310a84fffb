//! [`RayCaster`]: where a ray meets a mesh.
//!
//! S. Woop, C. Benthin and I. Wald, "Watertight Ray/Triangle Intersection", Journal of Computer Graphics Techniques 2 (1), 2013.
//!
//! The ray's space is sheared so that the ray runs along an axis. Three products of two sheared coordinates then say on which
//! side of each edge it passes; where one is zero they are taken again in `f64`, in which they are exact. Two faces with a common
//! edge see the same sheared coordinates and the same sign, so that no ray slips through between them.
//!
//! Departures from the paper:
//!
//! 1. Coordinates are first moved and scaled so that the mesh spans -1 to 1, and a ray that begins far away begins where it comes
//!    near the mesh. Both in `f64`.
//! 2. Boxes are grown once, by 1e-5 of half the extent, instead of rounding every test of a box.
//! 3. The sign of the determinant is kept: it says whether the ray enters by the face or leaves by it.
//!
//! # Why grown boxes lose nothing
//!
//! Local coordinates stay below 3, parameters along a ray of unit direction below 6. A sheared coordinate is wrong by at most
//! `3 x 2^-24 x 3`, a slab's parameter by as much as if its plane were moved by `3 x 2^-24 x 6`, and the stand-in for components
//! of the direction below `2^-23` moves the ray by `6 x 2^-23`. In all below `48 x 2^-24`, a third of the growth.

mod flat;

pub use flat::FlatNode;

use crate::hierarchy::{Boxed, build_with_progress};
use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;
use obvhs::ray::{Ray, RayHit};
use silhouette_core::glam::{DVec3, Vec3, Vec3A};
use silhouette_core::{Cancelled, FaceId, NoProgress, Progress, TriangleMesh};

/// By how much boxes are grown on every side, in units of half the mesh's largest extent. See the [module](self).
const GROWTH: f32 = 1.0e-5;

/// Distance from the middle of the mesh beyond which a ray begins later, in the same units. The mesh reaches to sqrt(3).
const NEAR: f64 = 2.0;

/// A hierarchy over the faces of a mesh, for rays.
///
/// 40 bytes per face and 48 per node, of which there are up to 2 per face.
pub struct RayCaster {
    center: DVec3,
    /// Local units per unit of the mesh's space.
    scale: f64,
    bvh: Bvh2,
    /// In the order of leaves, in local coordinates.
    corners: Vec<[[f32; 3]; 3]>,
    /// In the order of leaves.
    faces: Vec<FaceId>,
}

/// Where a ray meets a face.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hit {
    /// The face. Where the ray passes through an edge or a vertex, one of those around it.
    pub face: FaceId,
    /// Distance from the ray's origin, in units of the mesh's space.
    pub distance: f64,
    /// Weights of the three corners. They are 0 or positive and sum to 1 up to rounding.
    pub weights: Vec3,
    /// Whether the ray runs along the face's normal, and so leaves a mesh that is wound outwards.
    pub is_exit: bool,
}

/// A ray in local coordinates with the shear that makes it an axis.
struct Cast {
    ray: Ray,
    origin: [f32; 3],
    axes: [usize; 3],
    shear: [f32; 3],
    /// Local distance from where the caller's ray begins to where this one does.
    skipped: f64,
}

struct Crossing {
    distance: f32,
    edges: [f32; 3],
    determinant: f32,
}

impl RayCaster {
    /// The hierarchy of a mesh. Expected O(F log F), parallel.
    #[expect(clippy::missing_panics_doc, reason = "nobody cancels")]
    pub fn new(mesh: &TriangleMesh) -> Self {
        Self::with_progress(mesh, &NoProgress).expect("nobody cancels")
    }

    /// Like [`new`](Self::new), but stops between its steps when `progress` asks to.
    ///
    /// # Errors
    /// [`Cancelled`] when `progress` says so.
    pub fn with_progress(mesh: &TriangleMesh, progress: &dyn Progress) -> Result<Self, Cancelled> {
        let (center, extent) = mesh
            .bounds()
            .map_or((DVec3::ZERO, 0.0), |bounds| (bounds.center, (bounds.max - bounds.min).max_element() * 0.5));
        let scale = if extent > 0.0 { extent.recip() } else { 1.0 };
        let local = |vertex: u32| ((mesh.positions()[vertex as usize].as_dvec3() - center) * scale).as_vec3();
        let boxed = |triangle: &[u32; 3]| {
            let [a, b, c] = triangle.map(local);
            let (min, max) = (a.min(b).min(c) - GROWTH, a.max(b).max(c) + GROWTH);
            Boxed(Aabb::new(min.into(), max.into()))
        };
        let bvh = build_with_progress(&mesh.triangles().iter().map(boxed).collect::<Vec<_>>(), progress)?;
        let faces: Vec<FaceId> = bvh.primitive_indices.iter().map(|&index| FaceId::new(index)).collect();
        let corners =
            faces.iter().map(|face| mesh.triangles()[face.index()].map(|vertex| local(vertex).to_array())).collect();
        Ok(Self { center, scale, bvh, corners, faces })
    }

    /// Whether a ray meets the mesh before `within`. The direction is of unit length, the origin anywhere; faces count from both
    /// sides. Expected O(log F).
    pub fn meets(&self, origin: DVec3, direction: Vec3, within: f64) -> bool {
        self.any(origin, direction, 0.0, within, |_| true)
    }

    /// Whether a ray leaves by a face farther away than `beyond` and nearer than `within`. As [`meets`](Self::meets).
    pub fn exits(&self, origin: DVec3, direction: Vec3, beyond: f64, within: f64) -> bool {
        self.any(origin, direction, beyond, within, |crossing| crossing.determinant < 0.0)
    }

    /// The nearest face that a ray meets before `within`. As [`meets`](Self::meets).
    pub fn first(&self, origin: DVec3, direction: Vec3, within: f64) -> Option<Hit> {
        self.nearest(origin, direction, 0.0, within, |_| true)
    }

    /// The nearest face by which a ray leaves, farther away than `beyond`. As [`meets`](Self::meets).
    pub fn first_exit(&self, origin: DVec3, direction: Vec3, beyond: f64) -> Option<Hit> {
        self.nearest(origin, direction, beyond, f64::INFINITY, |crossing| crossing.determinant < 0.0)
    }

    /// All places where a ray meets the mesh, nearest first. A ray through an edge meets all faces around it.
    pub fn all(&self, origin: DVec3, direction: Vec3) -> Vec<Hit> {
        let mut hits = Vec::new();
        if let Some(cast) = self.cast(origin, direction, f64::INFINITY) {
            self.bvh.ray_traverse_anyhit(cast.ray, |_, place| {
                if let Some(crossing) = cast.cross(&self.corners[place]) {
                    hits.push(self.hit(&cast, place, &crossing));
                }
            });
        }
        hits.sort_by(|a, b| a.distance.total_cmp(&b.distance).then(a.face.cmp(&b.face)));
        hits
    }

    fn any(
        &self,
        origin: DVec3,
        direction: Vec3,
        beyond: f64,
        within: f64,
        counts: impl Fn(&Crossing) -> bool,
    ) -> bool {
        let Some(cast) = self.cast(origin, direction, within) else { return false };
        let beyond = cast.beyond(beyond * self.scale);
        !self.bvh.ray_traverse_miss(cast.ray, |_, place| match cast.cross(&self.corners[place]) {
            Some(crossing) if crossing.distance > beyond && counts(&crossing) => crossing.distance,
            _ => f32::INFINITY,
        })
    }

    fn nearest(
        &self,
        origin: DVec3,
        direction: Vec3,
        beyond: f64,
        within: f64,
        counts: impl Fn(&Crossing) -> bool,
    ) -> Option<Hit> {
        let cast = self.cast(origin, direction, within)?;
        let beyond = cast.beyond(beyond * self.scale);
        let mut found = None;
        self.bvh.ray_traverse(cast.ray, &mut RayHit::none(), |ray, place| match cast.cross(&self.corners[place]) {
            Some(crossing) if crossing.distance > beyond && counts(&crossing) => {
                let distance = crossing.distance;
                if distance < ray.tmax {
                    found = Some((place, crossing));
                }
                distance
            }
            _ => f32::INFINITY,
        });
        found.map(|(place, crossing)| self.hit(&cast, place, &crossing))
    }

    fn hit(&self, cast: &Cast, place: usize, crossing: &Crossing) -> Hit {
        Hit {
            face: self.faces[place],
            distance: (f64::from(crossing.distance) + cast.skipped) / self.scale,
            weights: Vec3::from(crossing.edges) / crossing.determinant,
            is_exit: crossing.determinant < 0.0,
        }
    }

    /// `None` where the ray ends before it comes near the mesh, or has no direction.
    fn cast(&self, origin: DVec3, direction: Vec3, within: f64) -> Option<Cast> {
        let local = (origin - self.center) * self.scale;
        let along = direction.as_dvec3();
        let skipped = if local.length_squared() > NEAR * NEAR { (-local.dot(along) - NEAR).max(0.0) } else { 0.0 };
        let origin = (local + skipped * along).as_vec3();
        let farthest = (within * self.scale - skipped) as f32;
        let size = direction.abs();
        let z = if size.x >= size.y && size.x >= size.z {
            0
        } else if size.y >= size.z {
            1
        } else {
            2
        };
        let is_ray = farthest > 0.0 && origin.is_finite() && direction.is_finite() && size[z] > 0.0;
        is_ray.then(|| {
            let (mut x, mut y) = ((z + 1) % 3, (z + 2) % 3);
            if direction[z] < 0.0 {
                std::mem::swap(&mut x, &mut y);
            }
            Cast {
                ray: Ray::new(Vec3A::from(origin), Vec3A::from(direction), 0.0, farthest),
                origin: origin.to_array(),
                axes: [x, y, z],
                shear: [direction[x] / direction[z], direction[y] / direction[z], direction[z].recip()],
                skipped,
            }
        })
    }
}

impl Cast {
    /// The local distance beyond which hits count; at least 0, where the ray begins.
    fn beyond(&self, distance: f64) -> f32 {
        let beyond = (distance - self.skipped) as f32;
        // The origin itself counts unless the caller asks for more.
        if distance > 0.0 && beyond > 0.0 { beyond } else { -f32::MIN_POSITIVE }
    }

    #[inline]
    fn cross(&self, corners: &[[f32; 3]; 3]) -> Option<Crossing> {
        let [x, y, z] = self.axes;
        let [a, b, c] = corners.map(|corner| {
            let along = corner[z] - self.origin[z];
            let across = corner[x] - self.origin[x] - self.shear[0] * along;
            [across, corner[y] - self.origin[y] - self.shear[1] * along, along]
        });
        let mut edges = [c[0] * b[1] - c[1] * b[0], a[0] * c[1] - a[1] * c[0], b[0] * a[1] - b[1] * a[0]];
        if edges.contains(&0.0) {
            let side = |p: [f32; 3], q: [f32; 3]| {
                (f64::from(p[0]) * f64::from(q[1]) - f64::from(p[1]) * f64::from(q[0])) as f32
            };
            edges = [side(c, b), side(a, c), side(b, a)];
        }
        let [u, v, w] = edges;
        if (u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0) {
            return None;
        }
        let determinant = u + v + w;
        let distance = self.shear[2] * (u * a[2] + v * b[2] + w * c[2]) / determinant;
        // Not a number where the determinant is 0.
        (distance >= 0.0).then_some(Crossing { distance, edges, determinant })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use silhouette_testing::strategies::soup;
    use silhouette_testing::{directions, edits, zoo};

    /// The textbook test in f64, without any tree.
    fn brute_force(mesh: &TriangleMesh, origin: DVec3, direction: DVec3) -> Vec<(FaceId, f64, f64)> {
        let mut hits = Vec::new();
        for face in (0..mesh.face_count()).map(FaceId::from_usize) {
            let [a, b, c] = mesh.corners(face).map(Vec3::as_dvec3);
            let normal = (b - a).cross(c - a);
            let facing = normal.dot(direction);
            let distance = normal.dot(a - origin) / facing;
            let point = origin + distance * direction;
            let sides = [(b, c), (c, a), (a, b)].map(|(from, to)| (to - from).cross(point - from).dot(normal));
            if distance > 0.0 && sides.iter().all(|&side| side >= 0.0) {
                hits.push((face, distance, facing));
            }
        }
        hits
    }

    #[test]
    fn entries_and_exits_alternate_through_a_closed_mesh() {
        let mesh = zoo::builtin("torus");
        let caster = RayCaster::new(&mesh);
        let bounds = mesh.bounds().unwrap();
        for direction in directions::spread(500) {
            let origin = bounds.center + DVec3::new(0.1, 0.2, 0.05) * bounds.radius - direction * 50.0 * bounds.radius;
            let hits = caster.all(origin, direction.as_vec3());
            assert!(hits.iter().enumerate().all(|(at, hit)| hit.is_exit == (at % 2 == 1)), "{hits:?}");
            assert_eq!(caster.first(origin, direction.as_vec3(), f64::INFINITY), hits.first().copied());
            assert_eq!(caster.first_exit(origin, direction.as_vec3(), 0.0), hits.get(1).copied());
            assert_eq!(caster.meets(origin, direction.as_vec3(), f64::INFINITY), !hits.is_empty());
            if let [first, second, ..] = hits[..] {
                let between = (first.distance + second.distance) * 0.5;
                assert!(caster.meets(origin, direction.as_vec3(), between));
                assert!(!caster.exits(origin, direction.as_vec3(), 0.0, between));
                assert!(caster.exits(origin, direction.as_vec3(), between, second.distance * 1.001));
                assert!(!caster.meets(origin, direction.as_vec3(), first.distance * 0.999));
            }
        }
    }

    /// Rays from inside aimed at vertices and at points of edges: none gets out unseen.
    #[test]
    fn no_ray_slips_through_an_edge_or_a_vertex() {
        let mesh = edits::shaken(&zoo::builtin("icosphere:4"), 0.01, 7);
        let caster = RayCaster::new(&mesh);
        let origin = DVec3::new(0.123, -0.211, 0.07);
        let mut rays = 0;
        for triangle in mesh.triangles() {
            let [a, b, _] = triangle.map(|vertex| mesh.positions()[vertex as usize].as_dvec3());
            for share in [0.0, 0.1, 0.25, 0.5, 0.77] {
                let direction = (a.lerp(b, share) - origin).normalize().as_vec3();
                assert!(caster.exits(origin, direction, 0.0, f64::INFINITY));
                rays += 1;
            }
        }
        assert!(rays > 5000);
    }

    proptest! {
        #[test]
        fn rays_meet_what_brute_force_meets(
            mesh in soup(40),
            origin in prop::array::uniform3(-30.0_f64..30.0),
            direction in prop::array::uniform3(-1.0_f64..1.0),
        ) {
            let direction = DVec3::from(direction);
            prop_assume!(direction.length() > 0.1);
            let (origin, direction) = (DVec3::from(origin), direction.normalize().as_vec3());
            let hits = RayCaster::new(&mesh).all(origin, direction);
            // Random rays pass no edge so closely that rounding matters, but for one in some hundred thousand.
            let expected = brute_force(&mesh, origin, direction.as_dvec3());
            prop_assert_eq!(hits.len(), expected.len());
            for hit in hits {
                let &(_, distance, facing) = expected.iter().find(|(face, ..)| *face == hit.face).unwrap();
                prop_assert!((hit.distance - distance).abs() < 1e-3 * (1.0 + distance));
                prop_assert_eq!(hit.is_exit, facing > 0.0);
                prop_assert!((hit.weights.element_sum() - 1.0).abs() < 1e-4);
            }
        }
    }
}
