//! The edges of a mesh for every view as GLB: the mesh itself, its hard edges and where it can have a silhouette.

use crate::failure::Failure;
use crate::progress::TerminalProgress;
use silhouette_compare::runner::NamedMesh;
use silhouette_core::Topology;
use silhouette_core::feature_edges::feature_edges;
use silhouette_core::save::write_glb;

/// The dihedral angle from which an edge is hard where none is given, as smoothing has it.
pub const DEFAULT_CREASE_DEG: f64 = 75.0;

/// The file.
pub fn write(
    NamedMesh { name, mesh }: &NamedMesh,
    crease_deg: f64,
    progress: &TerminalProgress,
) -> Result<Vec<u8>, Failure> {
    let topology = mesh.artefact::<Topology>("extract", progress)?;
    let is_hard = feature_edges(mesh.mesh(), &topology, mesh.feature_edges(), crease_deg);
    let mut bytes = Vec::new();
    write_glb(mesh.mesh(), &topology, &is_hard, &mut bytes)
        .map_err(|error| Failure::Input(format!("{name}: {error}; split the mesh")))?;
    Ok(bytes)
}
