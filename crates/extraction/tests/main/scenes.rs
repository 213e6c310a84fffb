//! Meshes of every kind and viewpoints that are hard to get right.

use proptest::prelude::*;
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::shapes::by_name;
use silhouette_core::{FaceId, Method, PreparedMesh, TriangleMesh, Viewpoint};
use std::sync::Arc;

/// A method prepared with its defaults.
pub fn prepare<M: Method>(mesh: &Arc<PreparedMesh>) -> M {
    M::new(mesh, M::Options::default()).unwrap()
}

/// The same mesh, scaled, then moved.
pub fn transformed(mesh: &TriangleMesh, scale: f64, offset: DVec3) -> TriangleMesh {
    let positions = mesh.positions().iter().map(|p| (p.as_dvec3() * scale + offset).as_vec3()).collect();
    TriangleMesh::new(positions, mesh.triangles().to_vec()).unwrap()
}

/// Closed, open, with creases, not orientable, and empty.
pub fn zoo() -> Vec<(&'static str, TriangleMesh)> {
    ["blob:3000", "torus:40,24", "cube", "gear", "grid:12,9", "moebius", "cylinder"]
        .into_iter()
        .map(|name| (name, by_name(name).unwrap_or_else(|error| panic!("{name}: {error}"))))
        .chain([("empty", TriangleMesh::new(vec![], vec![]).unwrap())])
        .collect()
}

/// Triangles over few vertices on a coarse grid: edges of many faces, faces without area, coplanar faces and viewpoints
/// in their planes are all common.
pub fn soup() -> impl Strategy<Value = TriangleMesh> {
    let positions = prop::collection::vec(prop::array::uniform3(-3_i8..=3), 12);
    let triangles = prop::collection::vec(prop::array::uniform3(0_u32..12), 0..150);
    (positions, triangles).prop_map(|(positions, triangles)| {
        let positions = positions.into_iter().map(|p| Vec3::from(p.map(f32::from))).collect();
        TriangleMesh::new(positions, triangles).unwrap()
    })
}

/// Viewpoints around and inside the grid of [`soup`], mostly in the plane of some face.
pub fn viewpoint() -> impl Strategy<Value = Viewpoint> {
    (prop::array::uniform3(-4_i8..=4), any::<bool>()).prop_map(|(point, is_eye)| {
        let point = Vec3::from(point.map(f32::from));
        if is_eye { Viewpoint::Perspective { eye: point } } else { Viewpoint::Orthographic { toward_viewer: point } }
    })
}

/// Viewpoints in a face's plane, on an edge, on a vertex, inside, around and far away, `count` of each.
pub fn adversarial(mesh: &TriangleMesh, count: usize) -> Vec<Viewpoint> {
    let Some(bounds) = mesh.bounds() else { return vec![Viewpoint::Perspective { eye: Vec3::ONE }] };
    let mut views = Vec::new();
    for index in 0..count {
        let face = FaceId::from_usize(index * 7919 % mesh.face_count());
        let [a, b, c] = mesh.corners(face).map(Vec3::as_dvec3);
        let (s, t) = (f64::from(index as u32 % 7) * 0.9 - 2.0, f64::from(index as u32 % 11) * 0.7 - 3.0);
        let direction = DVec3::new((index as f64).sin(), (index as f64 * 1.7).cos(), (index as f64 * 0.3).sin());
        let around = |radii: f64| bounds.center + direction.normalize() * (radii * bounds.radius);
        let eyes = [a + (b - a) * s + (c - a) * t, (a + b) * 0.5, a, around(0.1), around(3.0), around(1e7)];
        views.extend(eyes.map(|eye| Viewpoint::Perspective { eye: eye.as_vec3() }));
        let directions = [b - a, a - c, direction, (b - a).cross(c - a)];
        views.extend(directions.map(|d| Viewpoint::Orthographic { toward_viewer: d.as_vec3() }));
    }
    views
}
