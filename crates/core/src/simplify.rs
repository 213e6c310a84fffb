//! Simplification: a mesh of fewer faces that stays close to the original and keeps its topology. Cargo feature
//! `simplify`; needs a C++ compiler.
//!
//! The simplifier is [meshoptimizer](https://meshoptimizer.org)'s, which collapses edges in the order of their quadric
//! error (M. Garland and P. S. Heckbert, "Surface Simplification Using Quadric Error Metrics", SIGGRAPH 1997), onto one of
//! their ends, so that every vertex left is one of the mesh. It refuses collapses that turn a face by more than about 75
//! degrees, but not those that pinch the surface: where it is thin, collapses join its two sides at an edge, and a closed
//! manifold ends with edges of four faces. Hence this module:
//!
//! 1. Vertices of equal position are merged and faces that then name a vertex twice left out. Positions go to meshoptimizer
//!    relative to the mesh's box, scaled to a largest extent of 1 in 64-bit arithmetic, so that neither the distance to the
//!    origin nor the unit of length matters.
//! 2. The mesh is simplified in passes that at most halve it.
//! 3. After each pass `topology_kept` compares the topology with that before. If it has changed, the vertices at fault are
//!    locked, then their neighbours, and the pass is repeated; where no vertex is to blame, it is repeated with half
//!    the reduction, down to the single collapse, whose vertex is then locked too.
//!
//! A pass starts from the mesh that the last one left, and so do its quadrics, as in memoryless simplification (P. Lindstrom
//! and G. Turk, "Fast and Memory Efficient Polygonal Simplification", Visualization 1998).
//!
//! Faces may still fold: at thin parts, neighbours can end at a sharp angle back to back, which the check of single
//! collapses does not see.

mod topology_kept;

use self::topology_kept::{Change, change, neighbours, on_short_boundaries};
use crate::inspect::{Inspection, inspect_with_progress};
use crate::mesh::TriangleMesh;
use crate::progress::{Cancelled, NoProgress, Progress, Quiet};
use crate::topology::Topology;
use crate::weld::weld_exact;
use glam::Vec3;
use meshopt::SimplifyOptions;

/// Why a mesh is not simplified.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SimplifyError {
    /// No face is to be left.
    #[error("a mesh of 0 faces was asked for; ask for 1 or more")]
    NoneWanted,
    /// The mesh has no face that names three different positions.
    #[error("the mesh has no faces, or only ones that have shrunk to lines and points")]
    NoFaces,
    /// Fewer faces would be another topology.
    #[error(
        "{wanted} faces cannot be reached, only {reached}: fewer would change the mesh's topology or turn faces over"
    )]
    OutOfReach {
        /// How many were asked for.
        wanted: usize,
        /// With how many the mesh was left.
        reached: usize,
    },
    /// The work was stopped.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

/// Share of its faces that one pass leaves at least, as a divisor.
///
/// Locks last for one pass, so that shorter passes hold fewer vertices, and fewer collapses lie between a fault and the
/// vertices to lock against it. Longer ones rank collapses by the quadrics of an earlier mesh for longer. On models
/// simplified to 500 faces, a single pass left 0.94 to 1.25 times the root mean square distance that passes of a half
/// leave, and up to 4 times where it met many faults.
const PASS: usize = 2;

/// A mesh of at most `faces` faces that approximates `mesh`, in its coordinates.
///
/// It has as many components, boundary loops and handles (its Euler characteristic), no non-manifold edge or vertex and no
/// two faces over the same vertices, except those that `mesh` has once vertices of equal position are merged. Its vertices
/// are vertices of `mesh` to the last bit, in their order, those that no face uses left out; its faces are wound alike and
/// follow the order of those that they come from. A mesh with few enough faces is returned as merged.
///
/// The same bits for any number of threads. O(F log F) expected; a mesh of many parts too small to simplify takes up to that
/// for each of them.
///
/// # Errors
/// [`SimplifyError`]: no face is asked for or there, or so few are out of reach.
pub fn simplify(mesh: &TriangleMesh, faces: usize) -> Result<TriangleMesh, SimplifyError> {
    simplify_with_progress(mesh, faces, &NoProgress)
}

/// Like [`simplify`], but stops when `progress` asks to: before and after each call of meshoptimizer, which itself cannot be stopped,
/// and between the steps of what checks its result.
///
/// # Errors
/// As [`simplify`]; [`SimplifyError::Cancelled`] when `progress` says so.
pub fn simplify_with_progress(
    mesh: &TriangleMesh,
    faces: usize,
    progress: &dyn Progress,
) -> Result<TriangleMesh, SimplifyError> {
    if faces == 0 {
        return Err(SimplifyError::NoneWanted);
    }
    progress.check()?;
    let mut current = Stage::new(without_degenerate_faces(&weld_exact(mesh).mesh), progress)?;
    let unit = in_unit_box(&current.mesh).ok_or(SimplifyError::NoFaces)?;
    while current.mesh.face_count() > faces {
        let reached = current.mesh.face_count();
        let goal = faces.max(reached / PASS);
        current = pass(&current, &unit, goal, progress)?.ok_or(SimplifyError::OutOfReach { wanted: faces, reached })?;
    }
    Ok(compacted(&current.mesh))
}

/// A mesh between two passes, over all vertices of the welded one.
struct Stage {
    mesh: TriangleMesh,
    topology: Topology,
    inspection: Inspection,
}

impl Stage {
    fn new(mesh: TriangleMesh, progress: &dyn Progress) -> Result<Self, Cancelled> {
        progress.check()?;
        let topology = Topology::new(&mesh);
        progress.check()?;
        let inspection = inspect_with_progress(&mesh, &topology, &Quiet(progress))?;
        Ok(Self { mesh, topology, inspection })
    }
}

/// Collapses edges until about `goal` faces are left, or fewer edges where others change the topology; `None` if every
/// collapse does.
fn pass(before: &Stage, unit: &[[f32; 3]], goal: usize, progress: &dyn Progress) -> Result<Option<Stage>, Cancelled> {
    let faces = before.mesh.face_count();
    let mut locked = vec![false; unit.len()];
    lock(&mut locked, on_short_boundaries(&before.topology, &before.mesh));
    let mut nearer = goal;
    loop {
        progress.check()?;
        let triangles = collapsed(before.mesh.triangles(), unit, &locked, nearer);
        if triangles.len() == faces {
            return Ok(None);
        }
        let after = Stage::new(over_same_vertices(&before.mesh, triangles), progress)?;
        let at_fault = match change(&before.inspection, &after.inspection, &after.mesh) {
            Change::None => return Ok(Some(after)),
            Change::At(vertices) => vertices,
            Change::Somewhere => Vec::new(),
        };
        let is_new = lock(&mut locked, at_fault.clone()) || lock(&mut locked, neighbours(&before.topology, &at_fault));
        if !is_new && nearer + 1 < faces {
            nearer = nearer.midpoint(faces);
        } else if !is_new {
            // A single collapse is at fault.
            lock(&mut locked, vanished(before, &after));
            nearer = goal;
        }
    }
}

/// The vertices that collapses have moved onto others.
fn vanished(before: &Stage, after: &Stage) -> Vec<u32> {
    let (was_used, is_used) = (used(&before.mesh), used(&after.mesh));
    let vertices = 0..before.mesh.vertex_count();
    vertices.filter(|&vertex| was_used[vertex] && !is_used[vertex]).map(|vertex| vertex as u32).collect()
}

/// Whether a face uses it, for each vertex.
fn used(mesh: &TriangleMesh) -> Vec<bool> {
    let mut is_used = vec![false; mesh.vertex_count()];
    for &vertex in mesh.triangles().as_flattened() {
        is_used[vertex as usize] = true;
    }
    is_used
}

/// Locks vertices; whether one of them was not yet.
fn lock(locked: &mut [bool], vertices: Vec<u32>) -> bool {
    let mut is_new = false;
    for vertex in vertices {
        is_new |= !std::mem::replace(&mut locked[vertex as usize], true);
    }
    is_new
}

/// Triangles after meshoptimizer has collapsed edges, but none onto their other end that starts at a locked vertex.
fn collapsed(triangles: &[[u32; 3]], unit: &[[f32; 3]], locked: &[bool], goal: usize) -> Vec<[u32; 3]> {
    let indices = triangles.as_flattened();
    // The number of faces decides, whatever the error.
    let most_error = f32::MAX;
    let options = SimplifyOptions::None;
    let left = meshopt::simplify_with_locks_decoder(indices, unit, locked, 3 * goal, most_error, options, None);
    left.as_chunks().0.to_vec()
}

fn without_degenerate_faces(mesh: &TriangleMesh) -> TriangleMesh {
    let whole = mesh.triangles().iter().copied().filter(|[a, b, c]| a != b && b != c && c != a).collect();
    over_same_vertices(mesh, whole)
}

fn over_same_vertices(mesh: &TriangleMesh, triangles: Vec<[u32; 3]>) -> TriangleMesh {
    let fewer = TriangleMesh::new(mesh.positions().to_vec(), triangles);
    fewer.expect("fewer triangles over the vertices of a valid mesh are a valid mesh").with_origin(mesh.origin())
}

/// Positions relative to the box around the faces, whose largest extent becomes 1; `None` without faces.
fn in_unit_box(mesh: &TriangleMesh) -> Option<Vec<[f32; 3]>> {
    let bounds = mesh.bounds()?;
    let extent = (bounds.max - bounds.min).max_element();
    let place = |position: &Vec3| ((position.as_dvec3() - bounds.min) / extent).as_vec3().to_array();
    Some(mesh.positions().iter().map(place).collect())
}

/// The mesh without the vertices that no face uses.
fn compacted(mesh: &TriangleMesh) -> TriangleMesh {
    let (mut positions, mut renumbered) = (Vec::new(), Vec::with_capacity(mesh.vertex_count()));
    for (&position, is_used) in mesh.positions().iter().zip(used(mesh)) {
        renumbered.push(positions.len() as u32);
        if is_used {
            positions.push(position);
        }
    }
    let triangles = mesh.triangles().iter().map(|triangle| triangle.map(|vertex| renumbered[vertex as usize]));
    let compacted = TriangleMesh::new(positions, triangles.collect());
    compacted.expect("every vertex that a triangle names is kept").with_origin(mesh.origin())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes;

    fn stage(mesh: TriangleMesh) -> Stage {
        Stage::new(mesh, &NoProgress).unwrap()
    }

    /// The control of the test that simplified meshes keep their topology: without locks, the knot is pinched.
    #[test]
    fn without_locks_thin_parts_are_pinched() {
        let knot = stage(shapes::by_name("knot").unwrap());
        let unit = in_unit_box(&knot.mesh).unwrap();
        let triangles = collapsed(knot.mesh.triangles(), &unit, &vec![false; unit.len()], 50);
        let pinched = stage(over_same_vertices(&knot.mesh, triangles));
        assert!(!pinched.inspection.is_manifold);
        assert!(matches!(change(&knot.inspection, &pinched.inspection, &pinched.mesh), Change::At(_)));
    }

    #[test]
    fn a_part_that_vanishes_is_a_change() {
        let [ball, cube] = ["icosphere:1", "cube"].map(|name| shapes::by_name(name).unwrap());
        let place = |p: &Vec3| *p + Vec3::X * 9.0;
        let positions = ball.positions().iter().copied().chain(cube.positions().iter().map(place)).collect();
        let first = ball.vertex_count() as u32;
        let of_cube = cube.triangles().iter().map(|triangle| triangle.map(|vertex| vertex + first));
        let both =
            stage(TriangleMesh::new(positions, ball.triangles().iter().copied().chain(of_cube).collect()).unwrap());
        let one = stage(over_same_vertices(&both.mesh, ball.triangles().to_vec()));
        assert!(matches!(change(&both.inspection, &one.inspection, &one.mesh), Change::Somewhere));
        assert!(matches!(change(&both.inspection, &both.inspection, &both.mesh), Change::None));
        assert_eq!(vanished(&both, &one).len(), cube.vertex_count());
    }
}
