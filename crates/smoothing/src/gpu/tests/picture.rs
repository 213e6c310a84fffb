//! The pictures of both paths, and of meshes that move.

use super::scene::{SHAPES, Scene, cameras, method, picture, pipelines};
use crate::SmoothingOptions;
use crate::gpu::Room;
use crate::options::Path;
use crate::tests::smoothing;
use silhouette_core::TriangleMesh;
use silhouette_core::glam::Vec3;
use silhouette_gpu::{FillsImage as _, MeshBuffers};
use silhouette_render::{DEFAULT_FORMATS, Image, view_of_mesh};
use silhouette_testing::{builtin, gpu_or_skip, zoo};
use std::sync::Arc;

/// Pixels that only one of two pictures covers, and those whose shade differs by more than 8 of 255.
fn differences(a: &Image, b: &Image) -> [usize; 2] {
    let pixels = || a.rgba.chunks_exact(4).zip(b.rgba.chunks_exact(4));
    let covers_differ = pixels().filter(|(a, b)| (a[3] > 0) != (b[3] > 0)).count();
    [covers_differ, pixels().filter(|(a, b)| a[0].abs_diff(b[0]) > 8).count()]
}

fn covered(image: &Image) -> usize {
    image.rgba.chunks_exact(4).filter(|pixel| pixel[3] > 0).count()
}

#[test]
fn both_paths_give_the_same_picture() {
    let Some(gpu) = gpu_or_skip("both_paths_give_the_same_picture") else { return };
    for name in SHAPES {
        let mesh = builtin(name);
        let buffers = Arc::new(MeshBuffers::new(gpu.device(), gpu.queue(), &mesh).unwrap());
        let mut renderers = [Path::Gpu, Path::Cpu].map(|path| {
            let method = method(name, SmoothingOptions { path, ..Default::default() });
            let pipelines = Arc::new(method.pipelines(gpu.device(), DEFAULT_FORMATS).unwrap());
            method.renderer(gpu.device(), gpu.queue(), &pipelines, &buffers).unwrap()
        });
        for camera in cameras(&mesh, 4) {
            let view = view_of_mesh(&camera, &buffers).unwrap();
            let [on_gpu, on_cpu] = renderers.each_mut().map(|renderer| picture(gpu, renderer, &view));
            let [cover, shade] = differences(&on_gpu, &on_cpu);
            assert!(covered(&on_cpu) > 300, "{name}");
            assert!(cover <= 2 && shade <= 4, "{name}: {cover} and {shade} pixels differ");
        }
    }
}

/// Bent, so that normals and feature curves change too.
fn bent(mesh: &TriangleMesh) -> Vec<Vec3> {
    let bend = |p: &Vec3| Vec3::new(p.x + 0.3 * p.y * p.y, p.y * (1.0 + 0.2 * p.z), p.z + 0.2 * (2.0 * p.x).sin());
    mesh.positions().iter().map(bend).collect()
}

#[test]
fn a_mesh_that_moved_looks_like_a_new_mesh_there() {
    let Some(gpu) = gpu_or_skip("a_mesh_that_moved_looks_like_a_new_mesh_there") else { return };
    let pipelines = pipelines(gpu);
    for name in ["icosphere:1", "torus:16,10", "cylinder", "grid:4,4"] {
        // The chains of feature edges are those at rest: turns must not decide.
        let options = SmoothingOptions { corner_deg: 180.0, ..Default::default() };
        let rest = method(name, options);
        let positions = bent(rest.shading_mesh().mesh());
        let triangles = rest.shading_mesh().mesh().triangles().to_vec();
        let moved_mesh = TriangleMesh::new(positions.clone(), triangles.clone()).unwrap();
        let fresh = smoothing(moved_mesh.clone(), options);
        assert_eq!(rest.features().edges(), fresh.features().edges(), "{name}: the same feature edges");
        let usage = wgpu::BufferUsages::VERTEX | wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST;
        let own = gpu.device().create_buffer(&wgpu::BufferDescriptor {
            label: Some("the caller's positions"),
            size: size_of_val(&positions[..]) as u64,
            usage,
            mapped_at_creation: false,
        });
        gpu.queue().write_buffer(&own, 0, bytemuck::cast_slice(&positions));
        let bounds = moved_mesh.bounds().unwrap();
        let own = MeshBuffers::from_position_buffer(gpu.device(), gpu.queue(), own, &triangles, bounds).unwrap();
        let room = Room::for_mesh(&rest);
        let mut own = Scene::of_buffers(gpu, &pipelines, &rest, &Arc::new(own), room);
        let mut moved = Scene::new(gpu, &pipelines, &rest);
        let mut expected = Scene::new(gpu, &pipelines, &fresh);
        let at_rest: Vec<Image> = cameras(&moved_mesh, 4).iter().map(|camera| moved.picture(camera)).collect();
        moved.mesh.set_positions(gpu.queue(), &positions).unwrap();
        for (camera, at_rest) in cameras(&moved_mesh, 4).iter().zip(at_rest) {
            let expected = expected.picture(camera);
            for scene in [&mut moved, &mut own] {
                let [cover, shade] = differences(&scene.picture(camera), &expected);
                assert!(cover <= 4 && shade <= 12, "{name}: {cover} and {shade} pixels differ");
            }
            assert!(differences(&at_rest, &expected)[0] > 100, "{name}: the move shows");
        }
    }
}

#[test]
fn a_mesh_without_triangles_draws_nothing() {
    let Some(gpu) = gpu_or_skip("a_mesh_without_triangles_draws_nothing") else { return };
    let method = smoothing(zoo::empty(), SmoothingOptions::default());
    let mut scene = Scene::new(gpu, &pipelines(gpu), &method);
    let camera = &cameras(&builtin("cube"), 1)[0];
    assert_eq!(covered(&scene.picture(camera)), 0);
}
