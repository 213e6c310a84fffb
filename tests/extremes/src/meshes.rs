//! The meshes of the matrix: small, each bad in one way.

use silhouette_core::TriangleMesh;
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_testing::builtin;
use silhouette_testing::edits::{mapped, with_triangles};

/// Steps per unit of the lattice on which the torus lies.
pub const LATTICE: f32 = 256.0;

/// The plain mesh: a torus of 768 faces with its vertices on a lattice of 1/256, so that points in the planes of its faces can be
/// written down without rounding.
pub fn torus() -> TriangleMesh {
    mapped(&builtin("torus:24,16"), |p| (p * LATTICE).round() / LATTICE)
}

/// The torus with each face split at a point that lies 1/aspect of the face's height from an edge, as far as 32 bits can tell.
pub fn slivers(aspect: f64) -> TriangleMesh {
    let mesh = torus();
    let mut positions = mesh.positions().to_vec();
    let mut triangles = Vec::new();
    for &[a, b, c] in mesh.triangles() {
        let [p, q, r] = [a, b, c].map(|vertex| mesh.positions()[vertex as usize].as_dvec3());
        let on_edge = p.lerp(q, 0.375);
        let new = positions.len() as u32;
        positions.push(on_edge.lerp(r, 1.0 / aspect).as_vec3());
        triangles.extend([[a, b, new], [b, c, new], [c, a, new]]);
    }
    TriangleMesh::new(positions, triangles).expect("indices are in range")
}

/// A rod 2 long and 2e-8 thick: 1e8 is the aspect of its faces.
pub fn rod() -> TriangleMesh {
    mapped(&builtin("cylinder"), |p| Vec3::new(p.x * 1e-8, p.y, p.z * 1e-8))
}

/// The torus listed with every face twice.
pub fn listed_twice() -> TriangleMesh {
    let mesh = torus();
    with_triangles(&mesh, [mesh.triangles(), mesh.triangles()].concat())
}

/// The torus with, to each face, one along an edge and back and one that is a point.
pub fn with_flat_faces() -> TriangleMesh {
    let mesh = torus();
    let flat = mesh.triangles().iter().flat_map(|&[a, b, c]| [[a, b, a], [c, c, c], [a, b, c]]).collect();
    with_triangles(&mesh, flat)
}

/// The torus with three vertices of its own for each face.
pub fn unwelded() -> TriangleMesh {
    let mesh = torus();
    let positions = mesh.triangles().iter().flatten().map(|&vertex| mesh.positions()[vertex as usize]).collect();
    let triangles = (0..mesh.face_count() as u32).map(|face| [3 * face, 3 * face + 1, 3 * face + 2]).collect();
    TriangleMesh::new(positions, triangles).expect("indices are in range")
}

/// The torus with vertices that no face names, some of them far away.
pub fn with_loose_vertices() -> TriangleMesh {
    let mesh = torus();
    let loose = [Vec3::splat(1e30), Vec3::ZERO, Vec3::splat(-1e30)];
    TriangleMesh::new([mesh.positions(), &loose].concat(), mesh.triangles().to_vec()).expect("indices are in range")
}

/// A triangle whose outer side faces z.
pub fn triangle() -> TriangleMesh {
    TriangleMesh::new(vec![Vec3::ZERO, Vec3::X, Vec3::Y], vec![[0, 1, 2]]).expect("indices are in range")
}

/// Corners of a face of the torus, in 64 bits.
pub fn corners(mesh: &TriangleMesh, face: usize) -> [DVec3; 3] {
    mesh.triangles()[face].map(|vertex| mesh.positions()[vertex as usize].as_dvec3())
}
