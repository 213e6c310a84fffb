//! A surface of few vertices in place of one of many.

use silhouette_core::simplify::{SimplifyError, simplify_with_progress};
use silhouette_core::{Cancelled, Progress, TriangleMesh};

/// A closed manifold of at most `vertices` vertices that approximates a closed manifold, of the same topology. Vertices are
/// some of the surface's.
///
/// A closed manifold of F faces and Euler characteristic X has F / 2 + X vertices, and simplification keeps X: the number of
/// faces to ask for follows.
///
/// The inner error says with how many vertices the surface is left where fewer would change its topology, or turn faces over.
///
/// # Errors
/// [`Cancelled`] when `progress` says so.
pub(super) fn coarsened(
    surface: &TriangleMesh,
    vertices: usize,
    progress: &dyn Progress,
) -> Result<Result<TriangleMesh, usize>, Cancelled> {
    let euler_characteristic = surface.vertex_count() as i64 - surface.face_count() as i64 / 2;
    let faces = 2 * (vertices as i64 - euler_characteristic);
    match simplify_with_progress(surface, faces.max(1) as usize, progress) {
        Ok(coarse) => Ok(Ok(coarse)),
        Err(SimplifyError::Cancelled(cancelled)) => Err(cancelled),
        Err(SimplifyError::OutOfReach { reached, .. }) => Ok(Err((reached as i64 / 2 + euler_characteristic) as usize)),
        Err(_) => Ok(Err(surface.vertex_count())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::{NoProgress, shapes};
    use silhouette_testing::edits::{joined, moved};

    fn coarsened(surface: &TriangleMesh, vertices: usize) -> Result<TriangleMesh, usize> {
        super::coarsened(surface, vertices, &NoProgress).unwrap()
    }

    #[test]
    fn as_many_vertices_are_left_as_were_asked_for_whatever_the_topology() {
        let ball = shapes::by_name("icosphere:4").unwrap();
        let torus = shapes::by_name("torus:60,40").unwrap();
        let two = joined(&[&ball, &moved(&torus, 9.0 * silhouette_core::glam::Vec3::X)]);
        for (mesh, wanted) in [(&ball, 40), (&torus, 60), (&two, 90), (&ball, 5000)] {
            let left = coarsened(mesh, wanted).unwrap().vertex_count();
            assert!(left <= wanted && left + 2 >= wanted.min(mesh.vertex_count()), "{left} for {wanted}");
        }
        assert!(coarsened(&torus, 4).unwrap_err() > 4);
        assert!(coarsened(&two, 2).unwrap_err() >= 8);
    }
}
