//! A mesh with the visibility of its edges as a GLB file.

use super::arrays::GltfArrays;
use super::container::write_container;
use super::edge_codes::EdgeCodes;
use crate::edge_visibility::{NAME, pack};
use crate::id::PerEdge;
use crate::mesh::TriangleMesh;
use crate::topology::Topology;
use glam::DVec3;
use serde_json::{Value, json};
use std::io::{self, Write};

/// `mode` of a primitive of triangles.
const TRIANGLES: u32 = 4;

/// Writes a mesh as glTF 2.0 in a GLB container, with the visibility of its edges by the extension
/// `EXT_mesh_primitive_edge_visibility`.
///
/// The file holds one node, mesh and primitive with the vertices and triangles of `mesh`, to the last bit; the node is moved to
/// the mesh's origin, if it has one. Viewers draw an edge
///
/// - always if `is_hard` says so, which [`feature_edges`](crate::feature_edges::feature_edges) yields;
/// - otherwise from where one of its two faces is front and the other back, by the normals of the faces, which are stored within
///   1/65534 per component;
/// - never if its faces go on in one plane, exactly or as far as stored normals show, or if it does not join two consistently
///   wound faces that have an area.
///
/// A mesh without an edge to draw is written without the extension, one without faces as an empty document. O(F); memory:
/// the bytes of the file.
///
/// # Errors
/// Those of `out`; [`io::ErrorKind::InvalidInput`], before anything is written, beyond the 4 GiB that the format can hold.
///
/// # Panics
/// If `topology` or `is_hard` are of a mesh with fewer edges.
pub fn write_glb(
    mesh: &TriangleMesh,
    topology: &Topology,
    is_hard: &PerEdge<bool>,
    out: &mut dyn Write,
) -> io::Result<()> {
    let mut document = json!({ "asset": { "version": "2.0", "generator": "silhouettes" } });
    let mut arrays = GltfArrays::default();
    if mesh.face_count() > 0 {
        let mut primitive = json!({
            "attributes": { "POSITION": arrays.positions(mesh.positions()) },
            "indices": arrays.indices(mesh.triangles().as_flattened()),
            "mode": TRIANGLES,
        });
        let edges = EdgeCodes::new(mesh, topology, is_hard);
        if edges.draw_anything() {
            primitive["extensions"] = json!({ NAME: extension(&edges, &mut arrays) });
            document["extensionsUsed"] = json!([NAME]);
        }
        document["scene"] = 0.into();
        document["scenes"] = json!([{ "nodes": [0] }]);
        document["nodes"] = json!([{ "mesh": 0 }]);
        if mesh.origin() != DVec3::ZERO {
            document["nodes"][0]["translation"] = json!(mesh.origin());
        }
        document["meshes"] = json!([{ "primitives": [primitive] }]);
        arrays.describe(None, &mut document);
    }
    write_container(&document, arrays.buffer(), out)
}

/// The extension's object.
fn extension(edges: &EdgeCodes, arrays: &mut GltfArrays) -> Value {
    let mut extension = json!({ "visibility": arrays.bytes(&pack(edges.codes.as_slice())) });
    if !edges.normals.is_empty() {
        extension["silhouetteNormals"] = arrays.normals(&edges.normals).into();
    }
    extension
}
