//! Saving: what a GLB file with the visibility of edges holds, and that it is read back.

mod extension_facts;
mod facts;
mod round_trip;
mod silhouettes;

use silhouette_core::feature_edges::feature_edges;
use silhouette_core::id::PerEdge;
use silhouette_core::save::write_glb;
use silhouette_core::{Topology, TriangleMesh};

/// The dihedral angle from which edges of these tests are hard, in degrees.
const CREASE_DEG: f64 = 30.0;

/// The hard edges of a mesh: by dihedral angle, and where the surface ends or branches.
fn hard_edges(mesh: &TriangleMesh, topology: &Topology) -> PerEdge<bool> {
    feature_edges(mesh, topology, &[], CREASE_DEG)
}

/// A mesh as a file.
fn glb(mesh: &TriangleMesh) -> Vec<u8> {
    let topology = Topology::new(mesh);
    let mut bytes = Vec::new();
    write_glb(mesh, &topology, &hard_edges(mesh, &topology), &mut bytes).unwrap();
    bytes
}
