//! [`Correspondence`]: the object's colour and normal that a hull point is drawn with (sections 3.1 and 3.2, the point q of p).
//!
//! q is where the ray from p along the hull's inward normal, interpolated between vertices, first meets the object. Where it misses
//! or goes farther than [`MOST_DETOUR`] times the distance to the nearest point of the object, as it does past a thin part, q is
//! that nearest point.
//!
//! Normals of the object are interpolated between corners. The normal at a corner is the mean of those of the faces around the
//! vertex, weighted by their angles, among faces that meet the corner's own at less than the crease angle: sharp edges stay sharp.

use crate::centers::{angle_at, normals};
use crate::hull::Hull;
use glam::{DVec3, Vec3};
use rayon::prelude::*;
use silhouette_core::{Cancelled, FaceId, Progress, TriangleMesh, glam};
use silhouette_rays::{MeshHierarchy, RayCaster};

/// Colour of the object at a point, given by a face and the weights of its corners: sRGB and alpha.
pub type ColorAt<'a> = dyn Fn(FaceId, Vec3) -> [u8; 4] + Sync + 'a;

/// The colour of objects without one.
pub const WHITE: [u8; 4] = [255; 4];

/// How much farther than the nearest point q may lie. A ray at 75 degrees to a plane goes about 4 times as far as its foot.
pub const MOST_DETOUR: f64 = 4.0;

/// Faces per task, before each of which cancellation is checked: about 3 ms of work.
const FACES_PER_TASK: usize = 4096;

/// What of the object is drawn at points of the hull.
pub struct Correspondence<'a> {
    mesh: &'a TriangleMesh,
    rays: &'a RayCaster,
    distances: MeshHierarchy,
    /// Normals of the object, per corner.
    corners: Vec<[Vec3; 3]>,
    /// Normals of the hull, per vertex.
    hull: Vec<Vec3>,
    colors: Option<&'a ColorAt<'a>>,
}

impl<'a> Correspondence<'a> {
    /// Prepares the normals of both meshes, and a hierarchy for distances. Expected O(F log F).
    ///
    /// # Errors
    /// [`Cancelled`] when `progress` says so.
    pub fn new(
        mesh: &'a TriangleMesh,
        rays: &'a RayCaster,
        hull: &Hull,
        crease_deg: f64,
        colors: Option<&'a ColorAt<'a>>,
        progress: &dyn Progress,
    ) -> Result<Self, Cancelled> {
        let corners = corner_normals(mesh, crease_deg, progress)?;
        let hull = normals(hull.mesh());
        let distances = MeshHierarchy::with_progress(mesh, progress)?;
        Ok(Self { mesh, rays, distances, corners, hull, colors })
    }

    /// Colour and unit normal at a point of the hull: its position, and the hull's vertices around it with their weights. Expected
    /// O(log F).
    pub fn at(&self, position: DVec3, vertices: [u32; 3], weights: Vec3) -> ([u8; 4], Vec3) {
        let outward: Vec3 = (0..3).map(|at| weights[at] * self.hull[vertices[at] as usize]).sum();
        let outward = outward.try_normalize().unwrap_or(Vec3::Z);
        let Some((face, weights)) = self.corresponding(position, -outward) else { return (WHITE, outward) };
        let [a, b, c] = self.corners[face.index()];
        let normal = (weights.x * a + weights.y * b + weights.z * c).try_normalize();
        (self.colors.map_or(WHITE, |color| color(face, weights)), normal.unwrap_or(outward))
    }

    /// The point q: a face of the object and weights of its corners.
    fn corresponding(&self, position: DVec3, inward: Vec3) -> Option<(FaceId, Vec3)> {
        let nearest = self.distances.nearest(position, f64::INFINITY)?;
        let hit = self.rays.first(position, inward, nearest.distance * MOST_DETOUR);
        Some(hit.map_or_else(
            || (nearest.face, weights_at(self.mesh.corners(nearest.face), nearest.place)),
            |hit| (hit.face, hit.weights),
        ))
    }
}

/// The weights of a triangle's corners at a point of it; those of its first corner where it has no area.
fn weights_at(corners: [Vec3; 3], point: DVec3) -> Vec3 {
    let [a, b, c] = corners.map(Vec3::as_dvec3);
    let normal = (b - a).cross(c - a);
    let area = normal.length_squared();
    if area <= 0.0 {
        return Vec3::X;
    }
    let share = |from: DVec3, to: DVec3| ((to - from).cross(point - from).dot(normal) / area).clamp(0.0, 1.0);
    DVec3::new(share(b, c), share(c, a), share(a, b)).as_vec3()
}

/// Unit normals at the corners of faces, smooth across edges below the crease angle.
///
/// # Errors
/// [`Cancelled`] when `progress` says so.
fn corner_normals(mesh: &TriangleMesh, crease_deg: f64, progress: &dyn Progress) -> Result<Vec<[Vec3; 3]>, Cancelled> {
    let normal = |face| {
        let [a, b, c] = mesh.corners(FaceId::from_usize(face)).map(Vec3::as_dvec3);
        (b - a).cross(c - a).normalize_or_zero()
    };
    let flat: Vec<DVec3> = (0..mesh.face_count()).into_par_iter().map(normal).collect();
    progress.check()?;
    // Corners by vertex, three per face: those of vertex v are order[first[v]..first[v + 1]].
    let mut first = vec![0_u32; mesh.vertex_count() + 1];
    for &vertex in mesh.triangles().iter().flatten() {
        first[vertex as usize + 1] += 1;
    }
    for vertex in 0..mesh.vertex_count() {
        first[vertex + 1] += first[vertex];
    }
    let mut next = first.clone();
    let mut order = vec![0_u32; mesh.face_count() * 3];
    for (corner, &vertex) in (0..).zip(mesh.triangles().as_flattened()) {
        order[next[vertex as usize] as usize] = corner;
        next[vertex as usize] += 1;
    }
    progress.check()?;
    let least = crease_deg.to_radians().cos();
    let corner = |face: usize, vertex: u32| {
        let around = &order[first[vertex as usize] as usize..first[vertex as usize + 1] as usize];
        let corners = around.iter().map(|&corner| (corner as usize / 3, corner as usize % 3));
        let smooth = corners.filter(|&(other, _)| other == face || flat[other].dot(flat[face]) > least);
        let sum: DVec3 =
            smooth.map(|(other, slot)| angle_at(mesh, FaceId::from_usize(other), slot) * flat[other]).sum();
        sum.normalize_or(flat[face]).as_vec3()
    };
    let mut normals = vec![[Vec3::ZERO; 3]; mesh.face_count()];
    normals.par_chunks_mut(FACES_PER_TASK).enumerate().try_for_each(|(run, normals)| {
        progress.check()?;
        for (face, normals) in (run * FACES_PER_TASK..).zip(normals) {
            *normals = mesh.triangles()[face].map(|vertex| corner(face, vertex));
        }
        Ok(())
    })?;
    Ok(normals)
}
