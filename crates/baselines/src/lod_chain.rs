//! [`chain`]: the levels of a mesh, each with its distance from the full mesh.

use rayon::prelude::*;
use silhouette_core::glam::Vec3;
use silhouette_core::method::PrepareError;
use silhouette_core::simplify::{SimplifyError, simplify_with_progress};
use silhouette_core::{Cancelled, Progress, TriangleMesh};
use silhouette_rays::MeshHierarchy;
use std::sync::Arc;

/// Vertices that one task measures: enough that its largest distance so far spares most searches.
const PER_TASK: usize = 1024;

/// One level of detail.
#[derive(Debug, Clone, PartialEq)]
pub struct LodLevel {
    /// Its mesh, in the coordinates of the full mesh. Each vertex is one of the full mesh.
    pub mesh: Arc<TriangleMesh>,
    /// Largest distance from a vertex of the full mesh to this one's surface, in object units; 0 for the full mesh itself.
    ///
    /// Points inside faces of either mesh may be farther from the other.
    pub error: f64,
}

impl LodLevel {
    /// Bytes as engines store a level: 12 per position, 4 per normal, and per triangle 6 or, beyond 65 536 vertices, 12.
    pub fn bytes(&self) -> usize {
        let vertices = self.mesh.vertex_count();
        let per_index = if vertices <= 1 << 16 { size_of::<u16>() } else { size_of::<u32>() };
        let (position, normal) = (size_of::<[f32; 3]>(), size_of::<u32>());
        (position + normal) * vertices + 3 * per_index * self.mesh.face_count()
    }
}

/// The levels of `full` from the finest to the coarsest, each with half the faces of the one before; the last has as few as can
/// be reached.
///
/// The finest is `full` itself where it has at most `most_faces`, and otherwise `full` simplified to that many. Each of the
/// others is simplified from the one before. The same for any number of threads. O(F log F) expected.
///
/// # Errors
/// [`PrepareError::Cancelled`], or [`PrepareError::Mesh`] with the [`SimplifyError`] of the finest level.
pub(crate) fn chain(
    full: &Arc<TriangleMesh>,
    most_faces: usize,
    progress: &dyn Progress,
) -> Result<Vec<LodLevel>, PrepareError> {
    progress.stage("simplify to levels of detail", 0);
    let vertices = used(full);
    let level = |mesh: TriangleMesh| -> Result<LodLevel, Cancelled> {
        Ok(LodLevel { error: farthest(&vertices, &mesh, progress)?, mesh: Arc::new(mesh) })
    };
    let mut finest = if full.face_count() <= most_faces {
        LodLevel { mesh: Arc::clone(full), error: 0.0 }
    } else {
        level(simplify_with_progress(full, most_faces, progress).map_err(|error| match error {
            SimplifyError::Cancelled(cancelled) => cancelled.into(),
            error => PrepareError::Mesh(Box::new(error)),
        })?)?
    };
    let mut levels = Vec::new();
    loop {
        progress.check()?;
        progress.advance(1);
        let half = finest.mesh.face_count() / 2;
        let coarser = halved(&finest.mesh, progress)?.map(level).transpose()?;
        levels.push(finest);
        let Some(coarser) = coarser else { return Ok(levels) };
        if coarser.mesh.face_count() > half {
            levels.push(coarser);
            return Ok(levels);
        }
        finest = coarser;
    }
}

/// The mesh with half its faces, or as few as can be reached; `None` where those are all.
fn halved(mesh: &TriangleMesh, progress: &dyn Progress) -> Result<Option<TriangleMesh>, Cancelled> {
    let faces = mesh.face_count();
    let coarser = match simplify_with_progress(mesh, faces / 2, progress) {
        Err(SimplifyError::OutOfReach { reached, .. }) if reached < faces => {
            simplify_with_progress(mesh, reached, progress)
        }
        coarser => coarser,
    };
    match coarser {
        Err(SimplifyError::Cancelled(cancelled)) => Err(cancelled),
        coarser => Ok(coarser.ok().filter(|coarser| coarser.face_count() < faces)),
    }
}

/// The vertices that faces use.
fn used(mesh: &TriangleMesh) -> Vec<Vec3> {
    let mut is_used = vec![false; mesh.vertex_count()];
    for &vertex in mesh.triangles().as_flattened() {
        is_used[vertex as usize] = true;
    }
    mesh.positions().iter().zip(is_used).filter_map(|(&position, is_used)| is_used.then_some(position)).collect()
}

/// The largest distance of a point from the surface of a mesh that has faces. O(n log F) expected.
fn farthest(points: &[Vec3], mesh: &TriangleMesh, progress: &dyn Progress) -> Result<f64, Cancelled> {
    let hierarchy = MeshHierarchy::with_progress(mesh, progress)?;
    let farther = |worst: f64, point: &Vec3| {
        let point = point.as_dvec3();
        if hierarchy.is_within(point, worst) {
            return worst;
        }
        hierarchy.nearest(point, f64::INFINITY).map_or(worst, |nearest| worst.max(nearest.distance))
    };
    let of_task = |points: &[Vec3]| {
        progress.check()?;
        Ok(points.iter().fold(0.0, farther))
    };
    points.par_chunks(PER_TASK).map(of_task).try_reduce(|| 0.0, |one, other| Ok(one.max(other)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::NoProgress;
    use silhouette_testing::{Cancelling, zoo};

    fn levels(mesh: TriangleMesh, most_faces: usize) -> Vec<LodLevel> {
        chain(&Arc::new(mesh), most_faces, &NoProgress).unwrap()
    }

    /// Of no mesh with its topology are there fewer faces.
    fn tetrahedron() -> TriangleMesh {
        let triangles = vec![[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]];
        TriangleMesh::new(vec![Vec3::ZERO, Vec3::Y, Vec3::X, Vec3::Z], triangles).unwrap()
    }

    /// Largest distance of a vertex of `full` from a mesh, by all faces.
    fn farthest_by_all(full: &TriangleMesh, mesh: &TriangleMesh) -> f64 {
        let faces = |point: &Vec3| {
            let single = |&triangle: &[u32; 3]| {
                let face = TriangleMesh::new(mesh.positions().to_vec(), vec![triangle]).unwrap();
                MeshHierarchy::new(&face).nearest(point.as_dvec3(), f64::INFINITY).unwrap().distance
            };
            mesh.triangles().iter().map(single).fold(f64::INFINITY, f64::min)
        };
        full.positions().iter().map(faces).fold(0.0, f64::max)
    }

    #[test]
    fn levels_halve_down_to_a_few_faces() {
        for (name, mesh) in zoo::closed() {
            let levels = levels(mesh.clone(), usize::MAX);
            assert_eq!((&*levels[0].mesh, levels[0].error), (&mesh, 0.0), "{name}");
            for (index, pair) in levels.windows(2).enumerate() {
                let [finer, coarser] = [&pair[0], &pair[1]].map(|level| level.mesh.face_count());
                let is_last = index + 2 == levels.len();
                assert!(coarser < finer && (coarser <= finer / 2 || is_last), "{name}: {coarser}");
                assert!(pair[1].bytes() < pair[0].bytes());
            }
        }
        let blob = levels(zoo::builtin("blob:5000"), usize::MAX);
        assert!(blob.len() > 8 && blob.last().unwrap().mesh.face_count() < 20);
    }

    #[test]
    fn every_vertex_is_as_near_as_the_error_says_and_one_no_nearer() {
        let full = zoo::builtin("blob:600");
        let levels = levels(full.clone(), usize::MAX);
        for level in &levels[1..] {
            assert_eq!(level.error.to_bits(), farthest_by_all(&full, &level.mesh).to_bits());
            let hierarchy = MeshHierarchy::new(&level.mesh);
            let is_within = |bound: f64| full.positions().iter().all(|p| hierarchy.is_within(p.as_dvec3(), bound));
            assert!(is_within(level.error * (1.0 + 1e-9)) && !is_within(0.999 * level.error), "{}", level.error);
        }
        let errors: Vec<f64> = levels.iter().map(|level| level.error).collect();
        assert!(errors[1] > 0.0 && errors[1] < 0.1 * errors[levels.len() - 1], "{errors:?}");
    }

    #[test]
    fn the_finest_level_keeps_to_a_limit() {
        let full = zoo::builtin("blob:2000");
        let capped = levels(full.clone(), 300);
        assert!((250..=300).contains(&capped[0].mesh.face_count()) && capped[0].error > 0.0);
        assert!(capped[1].mesh.face_count() <= 150);
        let tetrahedron = Arc::new(tetrahedron());
        let refused = chain(&tetrahedron, 2, &NoProgress).unwrap_err();
        assert!(matches!(&refused, PrepareError::Mesh(_)) && refused.to_string().contains("2 faces"), "{refused}");
    }

    #[test]
    fn what_cannot_be_simplified_is_one_level() {
        for mesh in [zoo::empty(), tetrahedron()] {
            let levels = levels(mesh.clone(), usize::MAX);
            assert!(levels.len() == 1 && *levels[0].mesh == mesh && levels[0].error == 0.0);
        }
    }

    #[test]
    fn bytes_are_those_of_short_indices_where_they_do() {
        let [small, large] = [1 << 16, (1 << 16) + 1].map(|vertices| {
            let mesh = TriangleMesh::new(vec![Vec3::ZERO; vertices], vec![[0, 1, 2]; 10]).unwrap();
            LodLevel { mesh: Arc::new(mesh), error: 0.0 }.bytes() - 16 * vertices
        });
        assert_eq!([small, large], [60, 120]);
    }

    #[test]
    fn a_chain_can_be_cancelled() {
        let blob = Arc::new(zoo::builtin("blob:2000"));
        for progress in [Cancelling::at_once(), Cancelling::at_poll(3)] {
            assert!(matches!(chain(&blob, usize::MAX, &progress), Err(PrepareError::Cancelled(_))));
        }
    }
}
