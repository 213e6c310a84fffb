//! Needles, slivers, faces without area, and vertices that are there twice, never used, or no numbers.

use crate::cell::Found;
use crate::meshes::{listed_twice, rod, slivers, torus, unwelded, with_flat_faces, with_loose_vertices};
use crate::row::Row;
use crate::scene::Scene;
use silhouette_core::TriangleMesh;
use silhouette_core::glam::Vec3;
use silhouette_testing::builtin;
use silhouette_testing::edits::mapped;

/// The torus with a coordinate of its vertex 7 replaced.
fn with_coordinate(value: f32) -> Result<Scene, Found> {
    let mut positions = torus().positions().to_vec();
    positions[7].y = value;
    let mesh = TriangleMesh::new(positions, torus().triangles().to_vec());
    mesh.map(Scene::of).map_err(|error| Found::refused(&error))
}

/// The rod, thick enough to be seen.
fn thick_rod() -> Scene {
    Scene::of(mapped(&builtin("cylinder"), |p| Vec3::new(p.x * 0.02, p.y, p.z * 0.02)))
}

/// The rows.
pub fn rows() -> Vec<Row> {
    vec![
        Row::new("needles", "a cylinder 2 long and 2e-8 thick: faces of aspect 1e8", || Scene::of(rod()))
            .beside("rod", thick_rod),
        Row::new("slivers", "each face split at a point as close to an edge as 32 bits allow, 1e-8 of its length", || {
            Scene::of(slivers())
        }),
        Row::new("zero-area faces", "a face along an edge and back, and one that is a point, to each face", || {
            Scene::of(with_flat_faces())
        }),
        Row::new("duplicate faces", "every face listed twice", || Scene::of(listed_twice())),
        Row::new("duplicate vertices", "three vertices of its own for each face", || Scene::of(unwelded())),
        Row::new("loose vertices", "vertices that no face names, two of them 1e30 away", || {
            Scene::of(with_loose_vertices())
        }),
        Row::fallible("NaN vertex", "a coordinate of vertex 7 is NaN", || with_coordinate(f32::NAN)),
        Row::fallible("infinite vertex", "a coordinate of vertex 7 is infinite", || with_coordinate(f32::INFINITY)),
    ]
}
