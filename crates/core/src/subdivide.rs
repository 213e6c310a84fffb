//! Loop subdivision: a finer mesh whose limit is a smooth surface.
//!
//! C. Loop, "Smooth Subdivision Surfaces Based on Triangles", master's thesis, University of Utah, 1987. One level:
//!
//! 1. `corners`: the corners at each vertex, so that vertices can be worked on alone.
//! 2. `rules`: where vertices go and where the new point of each edge lies.
//! 3. Every face is split in four.
//!
//! # Departures from the thesis
//!
//! 1. The weight w of each of a vertex's n neighbours is Warren's, 3/(8n) and 3/16 for n = 3 (J. Warren, "Subdivision
//!    Methods for Geometric Design", Rice University, 1995), instead of Loop's with its cosine. Both limits have a
//!    continuous tangent plane at such vertices, and for n = 6 and n = 3 the weights are equal; Warren's are rational, so
//!    the mesh is the same bits on every machine. n below 3, which only closed fans of one or two faces have, takes 3/16
//!    as well: no weight is ever negative.
//! 2. The thesis treats closed surfaces. Here an edge is *sharp* unless it has exactly two incident half-edges and two
//!    different ends: boundary edges, non-manifold edges, and sides of a face from a vertex to itself.
//!
//! | element | new position |
//! |---|---|
//! | edge (a, b), not sharp, across from c and d | 3/8 (a + b) + 1/8 (c + d) |
//! | sharp edge (a, b) | 1/2 (a + b) |
//! | vertex without a sharp edge, its faces one closed fan | (1 - n w) v + w (sum of the n neighbours), w as above |
//! | vertex with exactly two sharp edges, to a and b | 3/4 v + 1/8 (a + b) |
//! | any other vertex | where it was |
//!
//! So a boundary loop converges to its own uniform cubic B-spline, whatever the faces beside it (a corner of a sheet is
//! rounded like any other vertex of the boundary), and so does a chain of non-manifold edges, where the sheets
//! keep meeting. The last row holds vertices in which curves meet or end, in which closed fans touch, which no face uses,
//! and which a degenerate face names twice. Winding plays no part in the rules; children are wound as their parent.
//!
//! Two faces over the same three vertices share the points of all three edges, so their inner edges coincide and are
//! non-manifold from the first level on. Elsewhere a closed mesh stays closed and the Euler characteristic is kept.

mod corners;
mod rules;
#[cfg(test)]
mod tests;

use self::corners::Corners;
use crate::mesh::{MAX_FACES, MAX_VERTICES, TriangleMesh};
use crate::topology::Topology;
use glam::{DVec3, Vec3};
use rayon::prelude::*;

/// Why a mesh is not subdivided. Nothing was built then.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SubdivisionError {
    /// More elements than 32-bit ids can name.
    #[error("{levels} levels of subdivision make more than {limit} {what}; at most {most} are possible")]
    TooLarge {
        /// `"faces"` or `"vertices"`.
        what: &'static str,
        /// How many there may be.
        limit: usize,
        /// Levels asked for.
        levels: u32,
        /// Levels that stay within all limits.
        most: u32,
    },
}

/// `mesh` after `levels` steps of Loop's scheme, by the rules of the [module](self); `topology` is that of `mesh`.
///
/// A level makes 4 F faces and V + E vertices. Vertices keep their ids and are followed by one per edge, in the order of
/// edge ids; the children of face f are 4f to 4f + 2 at its corners and 4f + 3 in its middle. Positions are 64-bit
/// until they are rounded at the end, in the mesh's own units, and stay within its bounding box. The same bits for any
/// number of threads. Without faces, or with 0 levels, the result is the mesh itself.
///
/// O(V + F) in what the last level holds, which takes some 55 bytes a face at the peak and 18 afterwards.
///
/// # Errors
/// [`SubdivisionError`] before any work where ids could run out: beyond [`MAX_FACES`], or [`MAX_VERTICES`] counted as if
/// no edges coincided.
///
/// # Panics
/// If `topology` belongs to a mesh with another number of faces.
pub fn loop_subdivision(
    mesh: &TriangleMesh,
    topology: &Topology,
    levels: u32,
) -> Result<TriangleMesh, SubdivisionError> {
    assert_eq!(topology.half_edge_count(), 3 * mesh.face_count(), "the topology belongs to another mesh");
    if levels == 0 || mesh.face_count() == 0 {
        return Ok(mesh.clone());
    }
    check_counts([mesh.vertex_count(), topology.edge_count(), mesh.face_count()], levels)?;
    let positions: Vec<DVec3> = mesh.positions().par_iter().map(|position| position.as_dvec3()).collect();
    let (mut positions, mut fine) = refine(mesh, &positions, topology);
    for _ in 1..levels {
        let topology = Topology::new(&fine);
        (positions, fine) = refine(&fine, &positions, &topology);
    }
    Ok(fine)
}

/// One level. `positions` are those of `mesh` before rounding.
fn refine(mesh: &TriangleMesh, positions: &[DVec3], topology: &Topology) -> (Vec<DVec3>, TriangleMesh) {
    let corners = Corners::of(mesh);
    let edge_ids = topology.edges().ids();
    let mut fine = Vec::with_capacity(positions.len() + edge_ids.len());
    fine.par_extend(
        (0..positions.len()).into_par_iter().map(|v| rules::vertex(mesh, topology, &corners, positions, v)),
    );
    fine.par_extend((0..edge_ids.len()).into_par_iter().map(|e| rules::edge(mesh, topology, positions, e)));

    let triangles = split_faces(mesh, topology);
    let rounded: Vec<Vec3> = fine.par_iter().map(|position| position.as_vec3()).collect();
    let finer = TriangleMesh::new(rounded, triangles).expect("averages of finite positions are finite, counts checked");
    (fine, finer.with_origin(mesh.origin()))
}

/// The four children of every face.
fn split_faces(mesh: &TriangleMesh, topology: &Topology) -> Vec<[u32; 3]> {
    let vertices = mesh.vertex_count() as u32;
    let mut children = vec![[0; 3]; 4 * mesh.face_count()];
    children.par_chunks_exact_mut(4).zip(mesh.triangles()).enumerate().for_each(|(face, (children, &[a, b, c]))| {
        let [ab, bc, ca] = corners::sides(face).map(|half_edge| vertices + topology.edge_of(half_edge).get());
        children.copy_from_slice(&[[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]);
    });
    children
}

/// Refuses counts of vertices, edges and faces that outgrow ids within `levels`.
fn check_counts(counts: [usize; 3], levels: u32) -> Result<(), SubdivisionError> {
    let [mut vertices, mut edges, mut faces] = counts.map(|count| count as u64);
    for most in 0..levels {
        // Both halves of each edge, and three edges within each face.
        [vertices, edges, faces] = [vertices + edges, 2 * edges + 3 * faces, 4 * faces];
        for (what, count, limit) in [("faces", faces, MAX_FACES), ("vertices", vertices, MAX_VERTICES)] {
            if count > limit as u64 {
                return Err(SubdivisionError::TooLarge { what, limit, levels, most });
            }
        }
    }
    Ok(())
}
