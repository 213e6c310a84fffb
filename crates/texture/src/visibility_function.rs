//! [`VisibilityFunction`]: whether a hull point shows the object in a direction (section 3.2, equations 1 and 2).
//!
//! Departures from the paper:
//!
//! 1. A direction must enter the hull by the point's own face; the paper evaluates its functions all around. An eye sees a point
//!    of a front face in no other direction.
//! 2. Equation 2 takes the distance to the nearest hull face "not including the one containing p itself". Here it is the distance
//!    to the nearest face by which the ray *leaves* the hull. Inside a face both agree. On an edge or a vertex of the hull, the
//!    neighbours are met at distance 0, and the paper's rule calls between 7 and 17 % of directions wrong.
//! 3. A point on the border of a face is moved into the face by [`INSET`] of its extent, so that a ray that leaves by a neighbour
//!    at a convex edge is seen to leave.
//!
//! # Why equation 2 shows exactly the object
//!
//! Let a ray from outside first meet the object at m, and let the hull enclose the object without crossing itself. The last hull
//! face met before m is then an entry, at a point p. From p the object is met at m, before the hull is left: p shows it. Every
//! other entry p' before m is followed by an exit before m, and does not. A ray that misses the object is shown by no point.

use crate::hull::Hull;
use crate::silhouette_texture::VisibilityRule;
use glam::{DVec3, Vec3};
use silhouette_core::{Cancelled, FaceId, NoProgress, Progress, TriangleMesh, glam};
use silhouette_rays::ray::RayCaster;
use std::sync::Arc;

/// The least weight that each corner of a face keeps at a point of it.
pub const INSET: f64 = 1.0 / 1024.0;

/// Share of the hull's radius within which exits do not count: rounding may put them at the ray's own origin. Below what
/// [`INSET`] leaves between a point and the border of a face, unless the face is a thousandth of the hull across.
const BEYOND: f64 = 1.0e-6;

/// An object and a hull, to be asked about rays.
#[derive(Clone)]
pub struct VisibilityFunction {
    object: Arc<RayCaster>,
    hull: Arc<RayCaster>,
    corners: Vec<[DVec3; 3]>,
    normals: Vec<Vec3>,
    beyond: f64,
    rule: VisibilityRule,
}

/// A point strictly inside a hull face.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HullPoint {
    /// In the object's space.
    pub position: DVec3,
    /// The face's outward unit normal; zero for a face without area, which no direction enters.
    pub normal: Vec3,
}

impl VisibilityFunction {
    /// Builds a hierarchy for each mesh. Expected O(F log F).
    #[expect(clippy::missing_panics_doc, reason = "nobody cancels")]
    pub fn new(object: &TriangleMesh, hull: &Hull, rule: VisibilityRule) -> Self {
        Self::with_progress(object, hull, rule, &NoProgress).expect("nobody cancels")
    }

    /// Like [`new`](Self::new), but stops between its steps when `progress` asks to.
    ///
    /// # Errors
    /// [`Cancelled`] when `progress` says so.
    pub fn with_progress(
        object: &TriangleMesh,
        hull: &Hull,
        rule: VisibilityRule,
        progress: &dyn Progress,
    ) -> Result<Self, Cancelled> {
        let mesh = hull.mesh();
        let corners: Vec<[DVec3; 3]> =
            (0..mesh.face_count()).map(|face| mesh.corners(FaceId::from_usize(face)).map(Vec3::as_dvec3)).collect();
        let normal = |[a, b, c]: &[DVec3; 3]| (b - a).cross(c - a).normalize_or_zero().as_vec3();
        Ok(Self {
            object: Arc::new(RayCaster::with_progress(object, progress)?),
            hull: Arc::new(RayCaster::with_progress(mesh, progress)?),
            normals: corners.iter().map(normal).collect(),
            corners,
            beyond: mesh.bounds().map_or(0.0, |bounds| bounds.radius) * BEYOND,
            rule,
        })
    }

    /// The rule.
    pub fn rule(&self) -> VisibilityRule {
        self.rule
    }

    /// Distance within which exits do not count, in units of the object's space.
    pub fn beyond(&self) -> f64 {
        self.beyond
    }

    /// The object, for rays.
    pub fn object(&self) -> &RayCaster {
        &self.object
    }

    /// The hull, for rays.
    pub fn hull(&self) -> &RayCaster {
        &self.hull
    }

    /// The point of a face with these weights of its corners, moved inside by [`INSET`] where it lies on the face's border.
    ///
    /// # Panics
    /// If the hull has no such face.
    pub fn point(&self, face: FaceId, weights: Vec3) -> HullPoint {
        let weights = weights.as_dvec3().max(DVec3::splat(INSET));
        let [a, b, c] = self.corners[face.index()];
        let position = (weights.x * a + weights.y * b + weights.z * c) / weights.element_sum();
        HullPoint { position, normal: self.normals[face.index()] }
    }

    /// Whether the point shows the object in a unit direction, from the eye into the object. Expected O(log F).
    pub fn shows(&self, point: &HullPoint, direction: Vec3) -> bool {
        match self.rule {
            VisibilityRule::Interior => self.distance(point, direction).is_some(),
            VisibilityRule::Exterior => {
                point.normal.dot(direction) < 0.0 && self.object.meets(point.position, direction, f64::INFINITY)
            }
        }
    }

    /// How far from the point the object is met in a unit direction; `None` where the point does not show it. Expected O(log F).
    pub fn distance(&self, point: &HullPoint, direction: Vec3) -> Option<f64> {
        if point.normal.dot(direction) >= 0.0 {
            return None;
        }
        let distance = self.object.first(point.position, direction, f64::INFINITY)?.distance;
        let is_shown =
            self.rule == VisibilityRule::Exterior || !self.hull.exits(point.position, direction, self.beyond, distance);
        is_shown.then_some(distance)
    }
}
