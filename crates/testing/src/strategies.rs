//! Meshes and viewpoints for proptest.

use crate::edits::{keeping, mapped, shaken};
use crate::zoo::builtin;
use proptest::prelude::*;
use silhouette_core::glam::Vec3;
use silhouette_core::shapes::{Sphere, Torus};
use silhouette_core::{TriangleMesh, Viewpoint};

/// A closed, consistently wound mesh: a sphere or torus, shaken up to self-intersection.
pub fn closed_mesh() -> impl Strategy<Value = TriangleMesh> {
    let base = prop_oneof![
        (0_u32..3).prop_map(|level| Sphere::default().icosphere(level).unwrap()),
        (3_u32..12, 3_u32..9).prop_map(|(around, across)| Torus::default().mesh(around, across).unwrap()),
    ];
    (base, 0.0_f32..0.6, any::<u64>()).prop_map(|(mesh, amount, seed)| shaken(&mesh, amount, seed))
}

/// A convex body around the origin, without faces in one plane but for a box: it holds the ball of radius 0.1, and the cube from -1 to 1
/// holds it.
pub fn convex_body() -> impl Strategy<Value = TriangleMesh> {
    let base = prop_oneof![
        (0_u32..3).prop_map(|level| Sphere { radius: 0.99 }.icosphere(level).unwrap()),
        Just(mapped(&builtin("cube"), |corner| corner * 0.5)),
    ];
    // Linear maps keep convex bodies convex.
    (base, prop::array::uniform3(0.2_f32..1.0)).prop_map(|(mesh, scale)| mapped(&mesh, |p| p * Vec3::from(scale)))
}

/// A closed mesh with some of its faces taken away.
pub fn open_mesh() -> impl Strategy<Value = TriangleMesh> {
    (closed_mesh(), any::<u64>()).prop_map(|(mesh, keep)| keeping(&mesh, |face| keep >> (face % 64) & 1 == 1))
}

/// Up to `most_faces - 1` triangles over twelve points of the lattice from -3 to 3: edges of many faces, faces without area and
/// coplanar faces are all common.
pub fn soup(most_faces: usize) -> impl Strategy<Value = TriangleMesh> {
    let positions = prop::collection::vec(prop::array::uniform3(-3_i8..=3), 12);
    let triangles = prop::collection::vec(prop::array::uniform3(0_u32..12), 0..most_faces);
    (positions, triangles).prop_map(|(positions, triangles)| {
        let positions = positions.into_iter().map(lattice_point).collect();
        TriangleMesh::new(positions, triangles).unwrap()
    })
}

/// Viewpoints at whole coordinates from `-reach` to `reach`. Around a [`soup`], most lie in the plane of some face.
pub fn lattice_viewpoint(reach: i8) -> impl Strategy<Value = Viewpoint> {
    (prop::array::uniform3(-reach..=reach), any::<bool>()).prop_map(|(point, is_eye)| at(lattice_point(point), is_eye))
}

/// Any viewpoint: near, far, inside, along axes.
pub fn viewpoint() -> impl Strategy<Value = Viewpoint> {
    let anywhere = (prop::array::uniform3(-3.0_f32..3.0), any::<bool>());
    prop_oneof![anywhere.prop_map(|(point, is_eye)| at(point.into(), is_eye)), lattice_viewpoint(2)]
}

fn lattice_point(point: [i8; 3]) -> Vec3 {
    Vec3::from(point.map(f32::from))
}

fn at(point: Vec3, is_eye: bool) -> Viewpoint {
    if is_eye { Viewpoint::Perspective { eye: point } } else { Viewpoint::Orthographic { toward_viewer: point } }
}
