//! The middle of the lobe, C, at each vertex of the hull (section 3.3).
//!
//! The paper takes the mean of all directions in which the point shows the object. At a vertex of the hull the rule that a
//! direction must enter by the point's own face leaves open which face that is: here each face around the vertex gives the mean
//! at its corner, [`INSET`](crate::visibility_function::INSET) inside, and these are weighted by the face's angle at the vertex,
//! so that C does not depend on how the hull is cut into triangles.
//!
//! Where no direction shows the object, or all do so that the mean vanishes, C is the inward normal of the hull.

use crate::directions::spread;
use crate::hull::Hull;
use crate::visibility_function::VisibilityFunction;
use glam::{DVec3, Vec3};
use rayon::prelude::*;
use silhouette_core::{Cancelled, FaceId, Progress, TriangleMesh, glam};

/// Directions that are tried at each corner. The mean of a lobe of 30 degrees around its middle is then right to about a degree,
/// far below what C varies by between vertices; phi is baked about whatever C is.
pub const DIRECTIONS: u32 = 1024;

/// Corners between two reports of progress, before each of which cancellation is checked: some 5 ms at a million faces.
const CHUNK: usize = 16;

/// C for each vertex of the hull, unit. Vertices without a face get +z. O(corners x [`DIRECTIONS`]) rays, in parallel.
///
/// # Errors
/// [`Cancelled`] by the progress.
pub fn centers(hull: &Hull, visibility: &VisibilityFunction, progress: &dyn Progress) -> Result<Vec<Vec3>, Cancelled> {
    let mesh = hull.mesh();
    let directions: Vec<Vec3> = spread(DIRECTIONS, 0.0).collect();
    let corners: Vec<usize> = (0..mesh.face_count() * 3).collect();
    progress.stage("centres of lobes", corners.len() as u64);
    let chunk_means = |chunk: &[usize]| {
        progress.check()?;
        let means: Vec<DVec3> = chunk
            .iter()
            .map(|&corner| mean(visibility, FaceId::from_usize(corner / 3), corner % 3, &directions))
            .collect();
        progress.advance(chunk.len() as u64);
        Ok(means)
    };
    let means: Vec<Vec<DVec3>> = corners.par_chunks(CHUNK).map(chunk_means).collect::<Result<_, Cancelled>>()?;
    let mut sums = vec![DVec3::ZERO; mesh.vertex_count()];
    for (corner, mean) in means.into_iter().flatten().enumerate() {
        let (face, slot) = (FaceId::from_usize(corner / 3), corner % 3);
        sums[mesh.triangles()[face.index()][slot] as usize] += angle_at(mesh, face, slot) * mean;
    }
    let inward = normals(mesh);
    Ok(sums
        .into_iter()
        .zip(inward)
        .map(|(sum, normal)| {
            let least = 1e-3;
            if sum.length() > least { sum.normalize().as_vec3() } else { (-normal).try_normalize().unwrap_or(Vec3::Z) }
        })
        .collect())
}

/// The mean over all directions in which a corner of a face shows the object, counting others as zero.
fn mean(visibility: &VisibilityFunction, face: FaceId, slot: usize, directions: &[Vec3]) -> DVec3 {
    let point = visibility.point(face, Vec3::AXES[slot]);
    let shown = directions.iter().filter(|&&direction| visibility.shows(&point, direction));
    shown.map(|direction| direction.as_dvec3()).sum::<DVec3>() / directions.len() as f64
}

/// Outward unit normals at vertices, the mean of the faces' weighted by angle; zero where that vanishes. O(F).
pub fn normals(mesh: &TriangleMesh) -> Vec<Vec3> {
    let mut sums = vec![DVec3::ZERO; mesh.vertex_count()];
    for face in (0..mesh.face_count()).map(FaceId::from_usize) {
        let [a, b, c] = mesh.corners(face).map(Vec3::as_dvec3);
        let normal = (b - a).cross(c - a).normalize_or_zero();
        for slot in 0..3 {
            sums[mesh.triangles()[face.index()][slot] as usize] += angle_at(mesh, face, slot) * normal;
        }
    }
    sums.into_iter().map(|sum| sum.normalize_or_zero().as_vec3()).collect()
}

/// The angle of a face at one of its corners, in radians; 0 for a face that has none.
pub(crate) fn angle_at(mesh: &TriangleMesh, face: FaceId, slot: usize) -> f64 {
    let corners = mesh.corners(face).map(Vec3::as_dvec3);
    let [to_next, to_last] = [1, 2].map(|step| corners[(slot + step) % 3] - corners[slot]);
    to_next.cross(to_last).length().atan2(to_next.dot(to_last))
}
