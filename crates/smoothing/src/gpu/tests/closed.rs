//! Triangles join, whatever the view and however little room there is.

use super::scene::{Scene, cameras, method, pipelines, sized_cameras};
use crate::SmoothingOptions;
use crate::gpu::Room;
use crate::tests::smoothing;
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
            let method = smoothing(mesh.clone(), SmoothingOptions { crease_deg, tolerance_px, ..Default::default() });
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
fn without_room_every_curve_is_one_piece_and_the_mesh_is_as_closed() {
    let Some(gpu) = gpu_or_skip("without_room_every_curve_is_one_piece") else { return };
    let pipelines = pipelines(gpu);
    for name in ["icosphere:2", "cylinder", "gear", "torus:16,10"] {
        let options = SmoothingOptions { tolerance_px: 0.01, ..Default::default() };
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
