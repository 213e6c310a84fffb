//! [`Correspondence`]: the object's colour and normal that a hull point is drawn with (sections 3.1 and 3.2, the point q of p).
//!
//! q is where the ray from p along the hull's inward normal, interpolated between vertices, first meets the object. Where it misses,
//! q is where the ray along the lobe's centre does; where that misses too, p is drawn with the hull's normal and in white.
//!
//! Normals of the object are interpolated between corners. The normal at a corner is the mean of those of the faces around the
//! vertex, weighted by their angles, among faces that meet the corner's own at less than the crease angle: sharp edges stay sharp.

use crate::centers::{angle_at, normals};
use crate::hull::Hull;
use glam::{DVec3, Vec3};
use silhouette_core::{FaceId, TriangleMesh, glam};
use silhouette_rays::ray::{Hit, RayCaster};

/// Colour of the object at a point, given by a face and the weights of its corners: sRGB and alpha.
pub type ColorAt<'a> = dyn Fn(FaceId, Vec3) -> [u8; 4] + Sync + 'a;

/// The colour of objects without one.
pub const WHITE: [u8; 4] = [255; 4];

/// What of the object is drawn at points of the hull.
pub struct Correspondence<'a> {
    object: &'a RayCaster,
    /// Normals of the object, per corner.
    corners: Vec<[Vec3; 3]>,
    /// Normals of the hull, per vertex.
    hull: Vec<Vec3>,
    colors: Option<&'a ColorAt<'a>>,
}

impl<'a> Correspondence<'a> {
    /// Prepares the normals of both meshes. O(F d) for vertex degree d.
    pub fn new(
        mesh: &TriangleMesh,
        object: &'a RayCaster,
        hull: &Hull,
        crease_deg: f64,
        colors: Option<&'a ColorAt<'a>>,
    ) -> Self {
        Self { object, corners: corner_normals(mesh, crease_deg), hull: normals(hull.mesh()), colors }
    }

    /// Colour and unit normal at a point of the hull: its position, the hull's vertices around it with their weights, and the
    /// centre of its lobe. Expected O(log F).
    pub fn at(&self, position: DVec3, vertices: [u32; 3], weights: Vec3, center: Vec3) -> ([u8; 4], Vec3) {
        let outward: Vec3 = (0..3).map(|at| weights[at] * self.hull[vertices[at] as usize]).sum();
        let outward = outward.try_normalize().unwrap_or(-center);
        let meet = |direction| self.object.first(position, direction, f64::INFINITY);
        let Some(hit) = meet(-outward).or_else(|| meet(center)) else { return (WHITE, outward) };
        (self.colors.map_or(WHITE, |color| color(hit.face, hit.weights)), self.normal(&hit).unwrap_or(outward))
    }

    fn normal(&self, hit: &Hit) -> Option<Vec3> {
        let [a, b, c] = self.corners[hit.face.index()];
        (hit.weights.x * a + hit.weights.y * b + hit.weights.z * c).try_normalize()
    }
}

/// Unit normals at the corners of faces, smooth across edges below the crease angle.
fn corner_normals(mesh: &TriangleMesh, crease_deg: f64) -> Vec<[Vec3; 3]> {
    let faces = || (0..mesh.face_count()).map(FaceId::from_usize);
    let normal = |face| {
        let [a, b, c] = mesh.corners(face).map(Vec3::as_dvec3);
        (b - a).cross(c - a).normalize_or_zero()
    };
    let flat: Vec<DVec3> = faces().map(normal).collect();
    // Corners by vertex: those of vertex v are order[first[v]..first[v + 1]].
    let mut first = vec![0_usize; mesh.vertex_count() + 1];
    for &vertex in mesh.triangles().iter().flatten() {
        first[vertex as usize + 1] += 1;
    }
    for vertex in 0..mesh.vertex_count() {
        first[vertex + 1] += first[vertex];
    }
    let mut next = first.clone();
    let mut order = vec![(FaceId::new(0), 0_usize); mesh.face_count() * 3];
    for face in faces() {
        for (slot, &vertex) in mesh.triangles()[face.index()].iter().enumerate() {
            order[next[vertex as usize]] = (face, slot);
            next[vertex as usize] += 1;
        }
    }
    let least = crease_deg.to_radians().cos();
    let corner = |face: FaceId, vertex: u32| {
        let around = &order[first[vertex as usize]..first[vertex as usize + 1]];
        let smooth =
            around.iter().filter(|(other, _)| *other == face || flat[other.index()].dot(flat[face.index()]) > least);
        let sum: DVec3 = smooth.map(|&(other, slot)| angle_at(mesh, other, slot) * flat[other.index()]).sum();
        sum.normalize_or(flat[face.index()]).as_vec3()
    };
    faces().map(|face| mesh.triangles()[face.index()].map(|vertex| corner(face, vertex))).collect()
}
