//! Triangles join, whatever the view and however little room there is.

use super::scene::{Scene, cameras, method, pipelines, sized_cameras};
use crate::gpu::Room;
use crate::options::Invisible;
use crate::tests::smoothing;
use crate::{Remesher as _, SmoothingOptions, SmoothingView, ViewMesh};
use silhouette_core::{Topology, TriangleMesh};
use silhouette_testing::{gpu_or_skip, zoo};

fn boundary_edges(mesh: &TriangleMesh) -> usize {
    Topology::new(mesh).boundary_edge_count()
}

#[test]
fn closed_meshes_stay_closed() {
    let Some(gpu) = gpu_or_skip("closed_meshes_stay_closed") else { return };
    let pipelines = pipelines(gpu);
    for (name, mesh) in zoo::closed() {
        for (crease_deg, tolerance_px) in [(75.0, 1.0), (20.0, 0.1)] {
            let method = smoothing(
                mesh.clone(),
                SmoothingOptions { crease_deg, tolerance_px, invisible: Invisible::Kept, ..Default::default() },
            );
            let mut scene = Scene::new(gpu, &pipelines, &method);
            for camera in cameras(&mesh, 6) {
                let frame = scene.frame(&camera);
                assert!(frame.triangles.iter().flatten().all(|&vertex| (vertex as usize) < frame.local.len()));
                assert_eq!(boundary_edges(&frame.welded()), boundary_edges(&mesh), "{name} at {crease_deg} degrees");
            }
        }
    }
}

#[test]
fn no_mesh_makes_an_index_out_of_range_or_a_vertex_that_is_no_number() {
    let Some(gpu) = gpu_or_skip("no_mesh_makes_an_index_out_of_range") else { return };
    let pipelines = pipelines(gpu);
    for (name, mesh) in zoo::all() {
        let all = smoothing(mesh.clone(), SmoothingOptions::default());
        let mut scene = Scene::new(gpu, &pipelines, &all);
        let mut drawn = all.drawn();
        for camera in cameras(&mesh, 4) {
            let frame = scene.frame(&camera);
            let triangles = frame.proper_triangles();
            let vertices = triangles.iter().flatten().map(|&vertex| vertex as usize);
            assert!(vertices.clone().all(|vertex| vertex < frame.local.len()), "{name}");
            assert!(vertices.clone().all(|vertex| frame.local[vertex].is_finite()), "{name}");
            assert!(vertices.clone().all(|vertex| frame.normals[vertex].is_finite()), "{name}");
            let mut out = ViewMesh::default();
            drawn.remesh(&SmoothingView::from_camera(&camera), &mut out);
            let (found, expected) = (triangles.len() as f64, out.triangles.len() as f64);
            assert!((found - expected).abs() <= 0.02 * expected + 2.0, "{name}: {found} for {expected}");
        }
    }
}

#[test]
fn without_room_every_curve_is_one_piece_and_the_mesh_is_as_closed() {
    let Some(gpu) = gpu_or_skip("without_room_every_curve_is_one_piece") else { return };
    let pipelines = pipelines(gpu);
    for name in ["icosphere:2", "cylinder", "gear", "torus:16,10"] {
        let options = SmoothingOptions { tolerance_px: 0.01, invisible: Invisible::Kept, ..Default::default() };
        let method = method(name, options);
        let mesh = method.shading_mesh().mesh();
        let least = Room::worst(&method, 1);
        assert!(least.triangles < Room::for_mesh(&method).triangles);
        let mut wide = Scene::new(gpu, &pipelines, &method);
        let mut narrow = Scene::with_room(gpu, &pipelines, &method, Room { triangles: 0, vertices: 0 });
        let mut any_fewer = false;
        for camera in sized_cameras(mesh, 6, 8192) {
            let [all, few] = [&mut wide, &mut narrow].map(|scene| scene.frame(&camera));
            assert!(few.triangles.len() as u64 <= least.triangles, "{name}");
            any_fewer |= few.triangles.len() < all.triangles.len();
            for frame in [&all, &few] {
                assert_eq!(boundary_edges(&frame.welded()), boundary_edges(mesh), "{name}");
            }
        }
        assert!(any_fewer, "{name}: the room is used");
    }
}
