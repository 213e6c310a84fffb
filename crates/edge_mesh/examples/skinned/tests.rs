//! The pictures are those of meshes that were skinned on the CPU.

use crate::beam::beam;
use crate::{Scene, bends_rad, skin};
use silhouette_core::glam::Vec3;
use silhouette_testing::gpu_or_skip;

#[test]
fn the_beam_is_closed_and_points_outwards() {
    let mesh = beam().unwrap();
    let topology = silhouette_core::Topology::new(&mesh);
    let found = silhouette_core::inspect::inspect(&mesh, &topology);
    assert!(found.is_closed && found.is_manifold && found.is_consistently_wound);
    let volume: f32 = mesh
        .triangles()
        .iter()
        .map(|t| {
            let [a, b, c] = t.map(|vertex| mesh.positions()[vertex as usize]);
            a.dot(b.cross(c)) / 6.0
        })
        .sum();
    assert!((volume - 0.72).abs() < 1e-4, "{volume}");
}

#[test]
fn frames_follow_the_joints() {
    let Some(gpu) = gpu_or_skip("frames_follow_the_joints") else { return };
    let mut scene = Scene::new(gpu).unwrap();
    let [first, again, later] = [0.3, 0.3, 0.9].map(|seconds| scene.draw(gpu, seconds).unwrap());
    assert!(first == again, "the same joints draw the same picture");
    let differing = |a: &silhouette_render::Image, b: &silhouette_render::Image| {
        a.rgba.chunks_exact(4).zip(b.rgba.chunks_exact(4)).filter(|(a, b)| a != b).count()
    };
    let ink = first.rgba.chunks_exact(4).filter(|pixel| pixel[..3] == [0, 0, 0]).count();
    let ridges = first.rgba.chunks_exact(4).filter(|pixel| pixel[0] > 150 && pixel[1] == 0).count();
    assert!(ink > 3000 && ridges > 500 && differing(&first, &later) > 1000, "{ink} {ridges}");

    // The same positions from the CPU.
    let mesh = beam().unwrap();
    for (pose, bend_rad) in scene.poses.iter().zip(bends_rad(0.3)) {
        let joints = skin::joints(bend_rad);
        let bent: Vec<Vec3> = mesh.positions().iter().map(|&position| skin::skinned(position, &joints)).collect();
        gpu.queue().write_buffer(pose.positions(), 0, bytemuck::cast_slice(&bent));
    }
    let expected = scene.instances.draw(gpu, |_| {}).unwrap();
    assert!(differing(&first, &expected) < 30, "{} pixels differ", differing(&first, &expected));
}
