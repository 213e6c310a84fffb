//! The triangles of a view as Wavefront OBJ.

use glam::DVec3;
use silhouette_core::origin::in_file;
use silhouette_core::weld::weld_exact;
use silhouette_core::{MeshError, TriangleMesh};
use silhouette_smoothing::ViewMesh;
use std::fmt::Write;

/// The file: each position once, so that triangles that meet have their vertices in common, and a normal for each vertex of
/// the view, so that sharp edges stay sharp. Coordinates are those of the mesh's file, for which positions count from `origin`; without
/// one they are the view's own, to the last bit. A triangle that has no three
/// positions is left out; its neighbours then have an edge in common.
///
/// # Errors
/// [`MeshError`] where a position is not finite.
pub fn write(view_mesh: &ViewMesh, origin: DVec3, title: &str) -> Result<Vec<u8>, MeshError> {
    let mesh = TriangleMesh::new(view_mesh.positions.clone(), view_mesh.triangles.clone())?;
    let welded = weld_exact(&mesh);
    let mut text = format!("# {}\n", title.split_whitespace().collect::<Vec<_>>().join(" "));
    for p in welded.mesh.positions().iter().map(|&position| in_file(origin, position)) {
        let _ = writeln!(text, "v {} {} {}", p.x, p.y, p.z);
    }
    for n in &view_mesh.normals {
        let _ = writeln!(text, "vn {} {} {}", n.x, n.y, n.z);
    }
    for (vertices, normals) in welded.mesh.triangles().iter().zip(&view_mesh.triangles) {
        let [a, b, c] = *vertices;
        if a != b && b != c && c != a {
            let corners = [0, 1, 2].map(|slot| format!("{}//{}", vertices[slot] + 1, normals[slot] + 1));
            let _ = writeln!(text, "f {}", corners.join(" "));
        }
    }
    Ok(text.into_bytes())
}
