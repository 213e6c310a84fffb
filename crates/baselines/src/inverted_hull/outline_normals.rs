//! [`OutlineNormals`]: normals for pushing vertices outwards, one per place.
//!
//! Vertices that lie at one place move together, whatever their numbers: what is welded is kept apart from the mesh and its
//! triangles, which stay as they are. Twin, for vertices that move on the device: `shaders/baselines/outline_normals.wgsl`.

use rayon::prelude::*;
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::mesh::TriangleMesh;
use silhouette_core::weld::weld_exact;
use silhouette_core::{Cancelled, NoProgress, Progress};

/// A sum of normals below this share of its weights is cancellation.
const LEAST_SHARE: f64 = 1e-5;

/// Fewest places per task: about 0.2 ms of work.
const PLACES_PER_TASK: usize = 1024;

/// The places where vertices of a mesh lie, the corners there, and a normal for each.
///
/// A normal is the mean of the corners' unit face normals, weighted by the corners' angles (Grit Thürmer and Charles A. Wüthrich,
/// "Computing vertex normals from polygonal facets", Journal of Graphics Tools, 1998), so that it does not depend on how a surface
/// is cut into triangles. It is zero where the normals cancel, as on a sheet with a face on either side, and where no face with an
/// area is.
#[derive(Debug, Clone, PartialEq)]
pub struct OutlineNormals {
    place_of: Vec<u32>,
    first_corners: Vec<u32>,
    corners: Vec<u32>,
    normals: Vec<Vec3>,
}

impl OutlineNormals {
    /// Those of a mesh. O(V + F) expected, parallel.
    #[expect(clippy::missing_panics_doc, reason = "nobody cancels")]
    pub fn new(mesh: &TriangleMesh) -> Self {
        Self::with_progress(mesh, &NoProgress).expect("nobody cancels")
    }

    /// Like [`new`](Self::new), but stops between its steps when `progress` asks to.
    ///
    /// # Errors
    /// [`Cancelled`] when `progress` says so.
    pub fn with_progress(mesh: &TriangleMesh, progress: &dyn Progress) -> Result<Self, Cancelled> {
        progress.check()?;
        let welded = weld_exact(mesh);
        progress.check()?;
        let places = welded.mesh.vertex_count();
        let place_of_corner: Vec<u32> = welded.mesh.triangles().iter().flatten().copied().collect();
        // A counting sort: how many corners each place has, where they begin, and then which.
        let mut first_corners = vec![0_u32; places + 1];
        for &place in &place_of_corner {
            first_corners[place as usize + 1] += 1;
        }
        for place in 0..places {
            first_corners[place + 1] += first_corners[place];
        }
        let mut next = first_corners.clone();
        let mut corners = vec![0; place_of_corner.len()];
        for (corner, &place) in (0..).zip(&place_of_corner) {
            let at = &mut next[place as usize];
            corners[*at as usize] = corner;
            *at += 1;
        }
        let mut normals = Self { place_of: welded.vertex_of, first_corners, corners, normals: Vec::new() };
        progress.check()?;
        normals.normals = normals.of_positions(mesh.positions(), mesh.triangles());
        Ok(normals)
    }

    /// Number of vertices of the mesh.
    pub fn vertex_count(&self) -> usize {
        self.place_of.len()
    }

    /// The normal of each place for other positions of the same vertices; the places stay those of the mesh at rest. O(F), parallel.
    ///
    /// # Panics
    /// If `positions` or `triangles` are not those of a mesh with the same triangles.
    pub fn of_positions(&self, positions: &[Vec3], triangles: &[[u32; 3]]) -> Vec<Vec3> {
        let position = |corner: u32| positions[triangles[corner as usize / 3][corner as usize % 3] as usize].as_dvec3();
        let normal = |range: &[u32]| {
            let (mut sum, mut weights) = (DVec3::ZERO, 0.0);
            for &corner in &self.corners[range[0] as usize..range[1] as usize] {
                let other = |by: u32| position(corner / 3 * 3 + (corner % 3 + by) % 3);
                let [a, b] = [1, 2].map(|by| (other(by) - position(corner)).normalize_or_zero());
                let across = a.cross(b);
                let angle = across.length().atan2(a.dot(b));
                if let Some(normal) = across.try_normalize() {
                    sum += angle * normal;
                    weights += angle;
                }
            }
            if sum.length() > LEAST_SHARE * weights { sum.normalize_or_zero().as_vec3() } else { Vec3::ZERO }
        };
        self.first_corners.par_windows(2).with_min_len(PLACES_PER_TASK).map(normal).collect()
    }

    /// The normal at each vertex of the mesh at rest: unit, or zero.
    pub fn vertex_normals(&self) -> impl Iterator<Item = Vec3> {
        self.place_of.iter().map(|&place| self.normals[place as usize])
    }

    /// Number of places.
    pub fn places(&self) -> usize {
        self.normals.len()
    }

    /// Bytes it holds.
    pub fn bytes(&self) -> usize {
        let numbers = self.place_of.len() + self.first_corners.len() + self.corners.len();
        size_of::<u32>() * numbers + size_of::<Vec3>() * self.normals.len()
    }

    /// The place of each vertex.
    #[cfg(feature = "gpu")]
    pub(super) fn place_of(&self) -> &[u32] {
        &self.place_of
    }

    /// Where the corners of each place begin in [`corners`](Self::corners), and their number.
    #[cfg(feature = "gpu")]
    pub(super) fn first_corners(&self) -> &[u32] {
        &self.first_corners
    }

    /// Corners, place by place.
    #[cfg(feature = "gpu")]
    pub(super) fn corners(&self) -> &[u32] {
        &self.corners
    }

    /// The normal of each place at rest.
    #[cfg(feature = "gpu")]
    pub(super) fn normals(&self) -> &[Vec3] {
        &self.normals
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::shapes::{Cuboid, Sphere};
    use silhouette_testing::edits::{inside_out, joined};

    /// The same surface with three vertices of its own for each face.
    fn split(mesh: &TriangleMesh) -> TriangleMesh {
        let positions = mesh.triangles().iter().flatten().map(|&vertex| mesh.positions()[vertex as usize]).collect();
        let triangles = (0..mesh.face_count() as u32).map(|face| [3 * face, 3 * face + 1, 3 * face + 2]).collect();
        TriangleMesh::new(positions, triangles).unwrap()
    }

    #[test]
    fn corners_of_a_cube_point_along_its_diagonals_however_its_vertices_are_numbered() {
        let cube = Cuboid::default().mesh().unwrap();
        for mesh in [split(&cube), cube] {
            let normals = OutlineNormals::new(&mesh);
            assert_eq!(normals.places(), 8);
            for (position, normal) in mesh.positions().iter().zip(normals.vertex_normals()) {
                // Weights by angle do not depend on which way the sides are cut in two.
                assert!(normal.distance(position.normalize()) < 1e-6, "{position}: {normal}");
            }
        }
    }

    #[test]
    fn normals_of_a_sphere_are_radial_and_follow_positions() {
        let sphere = Sphere::default().icosphere(4).unwrap();
        let normals = OutlineNormals::new(&sphere);
        for (position, normal) in sphere.positions().iter().zip(normals.vertex_normals()) {
            assert!(normal.dot(position.normalize()) > 0.999, "{position}: {normal}");
        }
        let turned: Vec<Vec3> = sphere.positions().iter().map(|p| Vec3::new(-p.y, p.x, 3.0 + p.z)).collect();
        let moved = normals.of_positions(&turned, sphere.triangles());
        for (rest, moved) in normals.normals.iter().zip(moved) {
            assert!(moved.distance(Vec3::new(-rest.y, rest.x, rest.z)) < 1e-5);
        }
    }

    #[test]
    fn a_sheet_with_two_sides_has_no_normal() {
        let side = TriangleMesh::new(vec![Vec3::ZERO, Vec3::X, Vec3::Y], vec![[0, 1, 2]]).unwrap();
        let sheet = joined(&[&side, &inside_out(&side)]);
        let normals = OutlineNormals::new(&sheet);
        assert_eq!(normals.places(), 3);
        assert!(normals.vertex_normals().all(|normal| normal == Vec3::ZERO));
        let flat = TriangleMesh::new(vec![Vec3::ZERO, Vec3::X, Vec3::X * 2.0, Vec3::Y], vec![[0, 1, 2]]).unwrap();
        assert!(OutlineNormals::new(&flat).vertex_normals().all(|normal| normal == Vec3::ZERO), "no area, no face");
    }
}
