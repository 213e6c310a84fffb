//! Meshes made of others.

use crate::random::Random;
use silhouette_core::TriangleMesh;
use silhouette_core::glam::{DVec3, Vec3};

/// The same faces over other positions.
pub fn with_positions(mesh: &TriangleMesh, positions: Vec<Vec3>) -> TriangleMesh {
    TriangleMesh::new(positions, mesh.triangles().to_vec()).unwrap()
}

/// Other faces over the same positions.
pub fn with_triangles(mesh: &TriangleMesh, triangles: Vec<[u32; 3]>) -> TriangleMesh {
    TriangleMesh::new(mesh.positions().to_vec(), triangles).unwrap()
}

/// The mesh with each position replaced.
pub fn mapped(mesh: &TriangleMesh, map: impl FnMut(Vec3) -> Vec3) -> TriangleMesh {
    with_positions(mesh, mesh.positions().iter().copied().map(map).collect())
}

/// The mesh elsewhere.
pub fn moved(mesh: &TriangleMesh, by: Vec3) -> TriangleMesh {
    mapped(mesh, |position| position + by)
}

/// The mesh scaled, then moved, and rounded once.
pub fn transformed(mesh: &TriangleMesh, scale: f64, offset: DVec3) -> TriangleMesh {
    mapped(mesh, |position| (position.as_dvec3() * scale + offset).as_vec3())
}

/// Positions of a twist about the y axis: each height is turned by `time` radians per unit, and heights are stretched by
/// `1 + stretch * time`.
pub fn twisted(mesh: &TriangleMesh, time: f32, stretch: f32) -> Vec<Vec3> {
    let twist = |p: &Vec3| {
        let (sin, cos) = (p.y * time).sin_cos();
        Vec3::new(p.x * cos - p.z * sin, p.y * (1.0 + stretch * time), p.x * sin + p.z * cos)
    };
    mesh.positions().iter().map(twist).collect()
}

/// The mesh with every vertex moved by up to `amount` along each axis, differently for each seed.
pub fn shaken(mesh: &TriangleMesh, amount: f32, seed: u64) -> TriangleMesh {
    let mut random = Random::new(seed);
    mapped(mesh, |position| position + random.vector().as_vec3() * amount)
}

/// The mesh with vertices and faces in another order, and each face beginning at another corner; and the new number of each
/// vertex.
pub fn permuted(mesh: &TriangleMesh, random: &mut Random) -> (TriangleMesh, Vec<u32>) {
    let mut order: Vec<u32> = (0..mesh.vertex_count() as u32).collect();
    random.shuffle(&mut order);
    let mut positions = vec![Vec3::ZERO; order.len()];
    for (&to, &position) in order.iter().zip(mesh.positions()) {
        positions[to as usize] = position;
    }
    let mut triangles: Vec<[u32; 3]> =
        mesh.triangles().iter().map(|triangle| triangle.map(|vertex| order[vertex as usize])).collect();
    triangles.iter_mut().for_each(|triangle| triangle.rotate_left(random.below(3)));
    random.shuffle(&mut triangles);
    (TriangleMesh::new(positions, triangles).unwrap(), order)
}

/// Several meshes as one. Vertices and faces of the first come first.
pub fn joined(meshes: &[&TriangleMesh]) -> TriangleMesh {
    let (mut positions, mut triangles) = (Vec::new(), Vec::new());
    for mesh in meshes {
        let first = positions.len() as u32;
        positions.extend_from_slice(mesh.positions());
        triangles.extend(mesh.triangles().iter().map(|triangle| triangle.map(|vertex| vertex + first)));
    }
    TriangleMesh::new(positions, triangles).unwrap()
}

/// The mesh with only the faces that `is_kept` names by their index.
pub fn keeping(mesh: &TriangleMesh, is_kept: impl Fn(usize) -> bool) -> TriangleMesh {
    let kept = mesh.triangles().iter().enumerate().filter(|(face, _)| is_kept(*face));
    with_triangles(mesh, kept.map(|(_, &triangle)| triangle).collect())
}

/// The mesh with the winding of some faces reversed.
pub fn turned_over(mesh: &TriangleMesh, is_turned: impl Fn(usize) -> bool) -> TriangleMesh {
    let turn = |(face, &[a, b, c]): (usize, &[u32; 3])| if is_turned(face) { [a, c, b] } else { [a, b, c] };
    with_triangles(mesh, mesh.triangles().iter().enumerate().map(turn).collect())
}

/// The mesh with the winding of all faces reversed.
pub fn inside_out(mesh: &TriangleMesh) -> TriangleMesh {
    turned_over(mesh, |_| true)
}
