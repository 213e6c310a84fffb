//! The edge mesh beside the mesh, in bytes.

use super::printed::{TRIANGLES_PER_EDGE, VERTEX_BYTES, VERTICES_PER_EDGE};
use crate::error::{Cause, PaperError};
use crate::paper::Run;
use crate::table::{Cell, Column, Comparable, Row, Table};
use silhouette_compare::NamedMesh;
use silhouette_core::{Method, Progress, Topology};
use silhouette_edge_mesh::EdgeMesh;

/// A table of every mesh.
///
/// # Errors
/// [`PaperError`]: cancelled.
pub fn by_mesh(run: &Run<'_>) -> Result<Vec<Table>, PaperError> {
    let of = |named: &NamedMesh| of_mesh(named, run.progress).map_err(PaperError::of::<Cause>(&named.name));
    run.meshes.iter().map(of).collect()
}

fn of_mesh(named: &NamedMesh, progress: &dyn Progress) -> Result<Table, Cause> {
    let mesh = named.mesh.mesh();
    let edge_mesh = EdgeMesh::prepare(&named.mesh, &<EdgeMesh as Method>::Options::default(), progress)?;
    let edges = named.mesh.artefact::<Topology>("sizes", progress)?.edge_count() as f64;
    let faces = mesh.face_count() as f64;
    let mesh_bytes = 12.0 * (mesh.vertex_count() as f64 + faces);
    let article =
        [VERTICES_PER_EDGE, TRIANGLES_PER_EDGE, VERTICES_PER_EDGE * VERTEX_BYTES].map(|per_edge| per_edge as f64);
    let row = |label: &str, cells: [Cell; 4]| Row::new(label, cells.to_vec());
    let [vertices, triangles, bytes] = article;
    let printed = |per_face: f64, on_closed: f64| {
        Cell::one(per_face)
            .beside(Some(on_closed), Comparable::Yes)
            .noted("printed for closed meshes, which have 1.5 edges per face")
    };
    let ours = edge_mesh.bytes_per_edge();
    let rows = vec![
        row(
            "the article's",
            [
                printed(vertices * edges / faces, 6.0),
                printed(triangles * edges / faces, 3.0),
                Cell::one(bytes).beside(Some(160.0), Comparable::Yes),
                Cell::one(bytes * edges / mesh_bytes),
            ],
        ),
        row("ours", [Cell::default(), Cell::default(), Cell::one(ours), Cell::one(ours * edges / mesh_bytes)]),
    ];
    Ok(Table {
        name: "sizes",
        subject: named.name.clone(),
        about: format!(
            "{faces:.0} faces and {edges:.0} edges; positions and triangles take {:.2} MiB",
            mesh_bytes / 1_048_576.0
        ),
        columns: vec![
            Column::new(
                "vertices",
                "vertices per face",
                "",
                "vertices of the edge mesh per face of the mesh; ours fetches records",
            ),
            Column::new("triangles", "triangles per face", "", "triangles of the edge mesh per face of the mesh"),
            Column {
                digits: 1,
                ..Column::new("bytes", "bytes per edge", "B", "memory per edge, without the positions of the mesh")
            },
            Column::new(
                "over mesh",
                "bytes over mesh",
                "×",
                "memory over that of positions and triangles, 12 bytes each",
            ),
        ],
        rows,
        ..Table::default()
    })
}
