//! What the tests of all formats share.

use silhouette_core::glam::Vec3;
use silhouette_core::load::{Format, LabelledMesh, LoadError, read, read_labelled};
use silhouette_core::{NoProgress, TriangleMesh};

/// Reads bytes that should be a mesh.
pub fn accepted(format: Format, bytes: impl AsRef<[u8]>) -> TriangleMesh {
    read(format, "test", bytes.as_ref(), &NoProgress).unwrap_or_else(|error| panic!("{error}"))
}

/// The same, with all that the file says about the mesh.
pub fn labelled(format: Format, bytes: impl AsRef<[u8]>) -> LabelledMesh {
    read_labelled(format, "test", bytes.as_ref(), &NoProgress).unwrap_or_else(|error| panic!("{error}"))
}

/// The labels of the faces of bytes that should be a mesh.
pub fn labels(format: Format, bytes: impl AsRef<[u8]>) -> Option<Vec<u32>> {
    labelled(format, bytes).labels
}

/// The feature edges of bytes that should be a mesh.
pub fn feature_edges(format: Format, bytes: impl AsRef<[u8]>) -> Vec<[u32; 2]> {
    labelled(format, bytes).feature_edges
}

/// Reads bytes that should be refused.
pub fn refused(format: Format, bytes: impl AsRef<[u8]>) -> LoadError {
    let error = match read(format, "test", bytes.as_ref(), &NoProgress) {
        Ok(mesh) => panic!("{} vertices and {} faces were taken", mesh.vertex_count(), mesh.face_count()),
        Err(error) => error,
    };
    let line = error.to_string();
    assert!(line.starts_with("test") && !line.contains('\n'), "not one line that names the file: {line}");
    error
}

/// Asserts that the bytes are refused at `place` with a line that contains each of `parts`.
#[track_caller]
pub fn assert_refused(format: Format, bytes: impl AsRef<[u8]>, place: &str, parts: &[&str]) {
    let line = refused(format, bytes).to_string();
    assert!(line.starts_with(&format!("test{place}: ")), "{line}");
    for part in parts {
        assert!(line.contains(part), "{part:?} is not in: {line}");
    }
}

/// Positions as arrays, for comparison with literals.
pub fn positions(mesh: &TriangleMesh) -> Vec<[f32; 3]> {
    mesh.positions().iter().map(Vec3::to_array).collect()
}

/// The corners of the unit square in the plane z = 0, counter-clockwise from the origin.
pub const SQUARE: [[f32; 3]; 4] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];

/// The fan of a square.
pub const SQUARE_FAN: [[u32; 3]; 2] = [[0, 1, 2], [0, 2, 3]];

/// The square's corners as rows of text, each behind `prefix`.
pub fn square_rows(prefix: &str) -> String {
    SQUARE.iter().map(|[x, y, z]| format!("{prefix}{x} {y} {z}\n")).collect()
}

/// Asserts that the mesh is the square, fanned from its first corner.
#[track_caller]
pub fn assert_square(mesh: &TriangleMesh) {
    assert_eq!(positions(mesh), SQUARE);
    assert_eq!(mesh.triangles(), SQUARE_FAN);
}
