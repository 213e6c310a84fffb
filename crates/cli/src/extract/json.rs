//! An extraction as JSON.

use super::Extraction;
use crate::failure::Failure;
use serde::Serialize;
use silhouette_core::method::ExtractionStats;
use silhouette_core::{VertexId, Viewpoint};

#[derive(Serialize)]
struct Document<'a> {
    method: &'static str,
    mesh: Counts,
    viewpoint: Viewpoint,
    edges: &'a [[VertexId; 2]],
    boundary: &'a [[VertexId; 2]],
    loops: &'a [Vec<VertexId>],
    stats: ExtractionStats,
}

#[derive(Serialize)]
struct Counts {
    vertices: usize,
    triangles: usize,
}

/// The document, with a line feed at its end.
pub fn write(found: &Extraction) -> Result<Vec<u8>, Failure> {
    let document = Document {
        method: found.method,
        mesh: Counts { vertices: found.mesh.vertex_count(), triangles: found.mesh.face_count() },
        viewpoint: found.viewpoint,
        edges: &found.edges,
        boundary: &found.boundary,
        loops: &found.loops,
        stats: found.stats,
    };
    let mut bytes = serde_json::to_vec(&document).map_err(Failure::run)?;
    bytes.push(b'\n');
    Ok(bytes)
}
