//! What a frame allocates, what instances share, what an edge takes.

use crate::scene::{self, PATHS, any_view, framed, method};
use allocation_counter::AllocationInfo;
use silhouette_core::glam::DMat4;
use silhouette_core::view::Viewpoint;
use silhouette_core::{ExtractsEdges, Method, SilhouetteEdges};
use silhouette_edge_mesh::as_printed::BYTES_PER_EDGE;
use silhouette_gpu::FrameRenderer;
use silhouette_testing::views::orbit;
use silhouette_testing::{builtin, gpu_or_skip, with_threads};

#[test]
fn a_steady_extraction_allocates_nothing() {
    let mesh = builtin("blob:5000");
    let viewpoints: Vec<Viewpoint> = orbit(&mesh, 23.0, 16).collect();
    let mut method = method(&mesh, &[]);
    let mut edges = SilhouetteEdges::default();
    let info = with_threads(1, || {
        let mut fly = || viewpoints.iter().map(|view| method.extract_edges(view, &mut edges).faces_tested).sum::<u64>();
        assert_eq!(fly(), 16 * 5000);
        allocation_counter::measure(|| {
            fly();
        })
    });
    assert_eq!(info.count_total, 0);
    let fresh = allocation_counter::measure(|| drop(vec![0; edges.len()]));
    assert_eq!(fresh.count_total, 1, "the counter counts");
}

/// What wgpu allocates for an upload does not depend on the mesh; nothing of ours is allocated beside it. The fewest of some frames count:
/// now and then wgpu has more to clear away.
#[test]
fn a_steady_frame_allocates_as_much_for_a_large_mesh_as_for_a_small_one() {
    let Some(gpu) = gpu_or_skip("a_steady_frame_allocates_as_much_for_a_large_mesh_as_for_a_small_one") else { return };
    for path in PATHS {
        for facing in ["facing=exact", "facing=device"] {
            let steady = |name: &str| {
                let mesh = builtin(name);
                let mut renderer = scene::renderer(gpu, &mesh, &[path, facing]);
                let view = any_view(&mesh, &framed(&mesh, 64));
                let mut frame = |turn: f64| {
                    let view = view.with_model(DMat4::from_rotation_y(turn)).unwrap();
                    renderer.prepare(gpu.device(), gpu.queue(), &view).unwrap();
                };
                with_threads(1, || {
                    (1..4).for_each(|step| frame(0.1 * f64::from(step)));
                    gpu.queue().submit([]);
                    let infos = [0.5, 0.6, 0.7, 0.8].map(|turn| allocation_counter::measure(|| frame(turn)));
                    let least = |of: fn(&AllocationInfo) -> u64| infos.iter().map(of).min().unwrap();
                    (least(|info| info.count_total), least(|info| info.bytes_total))
                })
            };
            let [small, large] = [steady("blob:600"), steady("blob:60000")];
            assert!(large.0 <= small.0 + 2 && large.1 < small.1 + 4096, "{path} {facing}: {small:?} {large:?}");
        }
    }
}

#[test]
fn an_edge_takes_at_most_32_bytes() {
    for mesh in [builtin("blob:3000"), builtin("grid:20,14")] {
        let plain = method(&mesh, &["path=vertex-stage"]).bytes_per_edge();
        let listed = method(&mesh, &[]).bytes_per_edge();
        let most = method(&mesh, &["ridge-angle=30", "valley-angle=30"]).bytes_per_edge();
        assert!(16.0 < plain && plain < listed && listed < most && most <= 32.0, "{plain} {listed} {most}");
        assert!(most * 5.0 < BYTES_PER_EDGE as f64);
    }
    assert!(method(&silhouette_testing::zoo::empty(), &[]).bytes_per_edge().abs() < 1e-9);
    let mesh = builtin("cube");
    assert_eq!(method(&mesh, &[]).bytes(), 18 * 16);
}
