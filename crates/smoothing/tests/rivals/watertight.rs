//! Surfaces of closed meshes are closed, whatever is split; meshes of any kind yield finite numbers, and a steady frame allocates
//! nothing.

use crate::surfaces::{CLOSED, NAMES, remesher, surface, view};
use proptest::prelude::*;
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::view::Viewpoint;
use silhouette_core::{TriangleMesh, glam};
use silhouette_smoothing::{Eye, SmoothingView, ViewMesh};
use silhouette_testing::{builtin, directions, strategies, zoo};
use std::collections::HashMap;

/// Directed edges that are not passed as often the other way, of the welded mesh.
fn open_edges(surface: &ViewMesh) -> usize {
    let mut balance: HashMap<[u32; 2], i32> = HashMap::new();
    for [a, b, c] in surface.to_mesh().unwrap().triangles() {
        for [from, to] in [[*a, *b], [*b, *c], [*c, *a]] {
            *balance.entry([from.min(to), from.max(to)]).or_default() += if from < to { 1 } else { -1 };
        }
    }
    balance.values().filter(|sum| **sum != 0).count()
}

fn is_sound(surface: &ViewMesh, mesh: &TriangleMesh) -> bool {
    let vertices = surface.positions.len();
    let are_finite = surface.positions.iter().all(|position| position.is_finite())
        && surface.normals.iter().all(|normal| normal.length() < 1e-3 || (normal.length() - 1.0).abs() < 1e-5);
    let are_from = surface.origins.len() == vertices
        && surface.origins.iter().all(|origin| {
            origin.face.index() < mesh.face_count() && (origin.weights.iter().sum::<f32>() - 1.0).abs() < 1e-5
        });
    let are_corners = surface.triangles.iter().flatten().all(|&corner| (corner as usize) < vertices);
    are_finite && surface.normals.len() == vertices && are_from && are_corners
}

#[test]
fn surfaces_of_closed_meshes_are_closed_at_feature_edges_too() {
    for (name, mesh) in zoo::closed() {
        for method in CLOSED {
            for crease in ["crease=20", "crease=75"] {
                let mut remesher = remesher(method, &mesh, &[crease]);
                for direction in directions::spread(3) {
                    let mut surface = ViewMesh::default();
                    remesher.remesh(&view(direction.as_vec3(), None).1, &mut surface);
                    assert!(is_sound(&surface, &mesh), "{method} {name}");
                    assert_eq!(open_edges(&surface), 0, "{method} {name} {crease}");
                }
            }
        }
    }
}

/// The control: a vertex of one face of a cube, off by the last bit, parts from its neighbours.
#[test]
fn the_check_sees_cracks() {
    let mut surface = surface(&mut *remesher("pn-triangles", &builtin("cube"), &[]), &view(Vec3::X, None).1);
    assert_eq!(open_edges(&surface), 0);
    surface.positions[0].x = f32::from_bits(surface.positions[0].x.to_bits() ^ 1);
    assert!(open_edges(&surface) >= 4);
}

#[test]
fn levels_make_as_many_triangles_as_they_say_through_the_mesh_vertices() {
    let mesh = builtin("icosphere:1");
    for method in ["pn-triangles", "phong-tessellation"] {
        for level in [0, 1, 2, 3, 15] {
            let words = format!("level={level}");
            let mut remesher = remesher(method, &mesh, &[&words]);
            let mut surface = surface(&mut *remesher, &view(Vec3::X, None).1);
            assert!(!remesher.remesh(&view(Vec3::Y, Some(2.0)).1, &mut surface), "the same for every view");
            let parts = level + 1;
            assert_eq!(surface.triangles.len(), 80 * parts * parts);
            // Closed and of genus 0, so that vertices follow from triangles.
            assert_eq!(surface.positions.len(), 2 + 40 * parts * parts);
            let is_there = |position: &Vec3| surface.positions.contains(position);
            assert!(mesh.positions().iter().all(is_there));
        }
    }
}

#[test]
fn origins_say_where_points_lie() {
    let mesh = builtin("cube");
    for method in CLOSED {
        let surface = surface(&mut *remesher(method, &mesh, &[]), &view(Vec3::new(1.0, 2.0, 3.0), None).1);
        let positions = surface.interpolate(|face, corner| mesh.corners(face)[corner as usize].to_array());
        // The faces of a cube stay flat.
        let worst = surface.positions.iter().zip(positions).map(|(a, b)| a.distance(Vec3::from(b))).fold(0.0, f32::max);
        assert!(worst < 1e-5, "{method}: {worst}");
    }
}

#[test]
fn a_steady_frame_allocates_nothing() {
    let mesh = builtin("knot");
    for method in NAMES {
        let mut remesher = remesher(method, &mesh, &[]);
        let mut surface = ViewMesh::default();
        let turned = |step: u32| view(Vec3::new((0.03 * step as f32).cos(), 0.4, (0.03 * step as f32).sin()), None).1;
        (0..200).for_each(|step| _ = remesher.remesh(&turned(step), &mut surface));
        let views = [turned(20), turned(21)];
        let frames = || views.iter().for_each(|view| _ = remesher.remesh(view, &mut surface));
        assert_eq!(allocation_counter::measure(frames).count_total, 0, "{method}");
    }
}

fn seen_from(viewpoint: Viewpoint) -> SmoothingView {
    let to_clip = glam::DMat4::from_scale(DVec3::splat(0.3));
    SmoothingView::new(Eye::from(viewpoint), to_clip, [400, 300])
}

#[test]
fn defective_meshes_yield_finite_numbers() {
    for (name, mesh) in zoo::defective().into_iter().chain([("nothing", zoo::empty())]) {
        for method in NAMES {
            let surface = surface(&mut *remesher(method, &mesh, &[]), &view(Vec3::ONE, Some(2.0)).1);
            assert!(is_sound(&surface, &mesh), "{method} {name}");
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn soups_yield_finite_numbers(
        mesh in strategies::soup(30), viewpoint in strategies::viewpoint(), crease in 0_u32..180,
    ) {
        for method in NAMES {
            let crease = format!("crease={crease}");
            let surface = surface(&mut *remesher(method, &mesh, &[&crease]), &seen_from(viewpoint));
            prop_assert!(is_sound(&surface, &mesh), "{method}");
        }
    }

    #[test]
    fn shaken_meshes_stay_closed(
        mesh in strategies::closed_mesh(), viewpoint in strategies::viewpoint(), crease in 0_u32..180,
    ) {
        for method in CLOSED {
            let crease = format!("crease={crease}");
            let surface = surface(&mut *remesher(method, &mesh, &[&crease]), &seen_from(viewpoint));
            prop_assert!(is_sound(&surface, &mesh), "{method}");
            prop_assert_eq!(open_edges(&surface), 0, "{}", method);
        }
    }
}
