//! Pictures of levels beside those of the mesh.

use super::*;
use crate::lod_mesh::LodMeshOptions;
use crate::shading::Shading;
use crate::{FineMesh, FineMeshOptions};
use silhouette_core::glam::{DMat4, DVec3, Vec3};
use silhouette_core::method::Method;
use silhouette_core::view::{Camera, Projection};
use silhouette_core::{PreparedMesh, TriangleMesh};
use silhouette_render::{DEFAULT_FORMATS, Gpu, Image, Load, Target, view_of_mesh};
use silhouette_testing::prepare::prepared;
use silhouette_testing::{gpu_or_skip, zoo};

const SIZE: [u32; 2] = [240, 200];

/// From this many units away.
fn camera(distance: f32) -> Camera {
    let eye = distance * Vec3::new(0.48, 0.36, 0.8);
    Camera::new(eye, Vec3::ZERO, Vec3::Y, Projection::Perspective { fov_y_rad: 0.7 }, SIZE).unwrap()
}

fn picture<M: FillsImage>(gpu: &Gpu, method: &M, mesh: &TriangleMesh, distance: f32) -> (Image, M::Renderer) {
    let (device, queue) = (gpu.device(), gpu.queue());
    let buffers = Arc::new(MeshBuffers::new(device, queue, mesh).unwrap());
    let pipelines = Arc::new(method.pipelines(device, DEFAULT_FORMATS).unwrap());
    let mut renderer = method.renderer(device, queue, &pipelines, &buffers).unwrap();
    renderer.prepare(device, queue, &view_of_mesh(&camera(distance), &buffers).unwrap()).unwrap();
    let target = Target::new(gpu, SIZE, DEFAULT_FORMATS).unwrap();
    gpu.draw(&target, Load::Clear([0.0; 4]), |pass| renderer.draw(pass)).unwrap();
    (target.read_color(gpu).unwrap(), renderer)
}

fn fine(mesh: &Arc<PreparedMesh>) -> FineMesh {
    FineMesh::new(mesh, FineMeshOptions { shading: Shading::Flat, ..FineMeshOptions::default() }).unwrap()
}

fn lod(mesh: &Arc<PreparedMesh>, max_error: f64) -> LodMesh {
    LodMesh::new(mesh, LodMeshOptions { max_error, shading: Shading::Flat, ..LodMeshOptions::default() }).unwrap()
}

/// How far a pixel that differs is from the nearest pixel of `truth` that is as `other` has it, at most: in pixels.
fn farthest_wrong_px(truth: &Image, other: &Image) -> f64 {
    let pixels = || (0..SIZE[1]).flat_map(|y| (0..SIZE[0]).map(move |x| [x, y]));
    let is_drawn = |image: &Image, [x, y]: [u32; 2]| image.pixel(x, y)[3] > 0;
    let wrong = pixels().filter(|&at| is_drawn(truth, at) != is_drawn(other, at));
    let distance = |from: [u32; 2]| {
        let alike = pixels().filter(|&to| is_drawn(truth, to) == is_drawn(other, from));
        alike
            .map(|to| f64::from(from[0].abs_diff(to[0])).hypot(f64::from(from[1].abs_diff(to[1]))))
            .fold(999.0, f64::min)
    };
    wrong.map(distance).fold(0.0, f64::max)
}

#[test]
fn outlines_keep_to_the_error_that_is_allowed() {
    let Some(gpu) = gpu_or_skip("outlines_keep_to_the_error_that_is_allowed") else { return };
    let mesh = prepared(zoo::builtin("blob:5000"));
    let (truth, _) = picture(gpu, &fine(&mesh), mesh.mesh(), 4.0);
    assert!(truth.rgba.as_chunks::<4>().0.iter().filter(|pixel| pixel[3] > 0).count() > 5000);
    for max_error in [1.0, 2.0, 4.0] {
        let (drawn, renderer) = picture(gpu, &lod(&mesh, max_error), mesh.mesh(), 4.0);
        // A pixel more, as pixels are drawn where their middles are covered.
        let farthest = farthest_wrong_px(&truth, &drawn);
        assert!(renderer.level() > 0 && farthest <= max_error + 1.0, "{max_error}: {farthest}");
    }
    let (coarse, _) = picture(gpu, &lod(&mesh, 30.0), mesh.mesh(), 4.0);
    assert!(farthest_wrong_px(&truth, &coarse) > 3.0, "the check sees a level too coarse");
}

#[test]
fn without_an_error_allowed_the_mesh_itself_is_drawn() {
    let Some(gpu) = gpu_or_skip("without_an_error_allowed_the_mesh_itself_is_drawn") else { return };
    for (name, mesh) in zoo::edge_manifold().into_iter().take(3) {
        let mesh = prepared(mesh);
        let (drawn, renderer) = picture(gpu, &lod(&mesh, 0.0), mesh.mesh(), 4.0);
        assert!(renderer.levels[renderer.level()].error == 0.0, "{name}");
        assert_eq!(drawn, picture(gpu, &fine(&mesh), mesh.mesh(), 4.0).0, "{name}");
    }
}

#[test]
fn far_views_draw_coarse_levels() {
    let Some(gpu) = gpu_or_skip("far_views_draw_coarse_levels") else { return };
    let mesh = prepared(zoo::builtin("blob:5000"));
    let lod = lod(&mesh, 1.0);
    let levels = [3.0, 10.0, 40.0, 200.0].map(|distance| picture(gpu, &lod, mesh.mesh(), distance).1.level());
    assert!(levels.is_sorted() && levels[0] < levels[1] && levels[1] < levels[3], "{levels:?}");
}

#[test]
fn an_empty_mesh_draws_nothing() {
    let Some(gpu) = gpu_or_skip("an_empty_mesh_draws_nothing") else { return };
    let mesh = prepared(zoo::empty());
    let (drawn, _) = picture(gpu, &lod(&mesh, 1.0), mesh.mesh(), 4.0);
    assert!(drawn.rgba.iter().all(|&value| value == 0));
}

/// The error allowed is in pixels of the image, whatever the model matrix and the projection.
#[test]
fn a_unit_covers_most_pixels_at_the_nearest_corner() {
    let bounds = Bounds::of([Vec3::splat(-0.5), Vec3::splat(0.5)].into_iter()).unwrap();
    let eye = Vec3::new(0.0, 0.0, 4.0);
    let view = |projection| {
        let camera = Camera::new(eye, Vec3::ZERO, Vec3::Y, projection, SIZE).unwrap();
        FrameView::from_camera(&camera, camera.clip_range(&bounds), DEFAULT_FORMATS.depth_direction).unwrap()
    };
    let (fov_y_rad, height) = (0.7_f64, 5.0);
    let perspective = view(Projection::Perspective { fov_y_rad });
    let at_depth = |depth: f64| 0.5 * f64::from(SIZE[1]) / (0.5 * fov_y_rad).tan() / depth;
    assert!((largest_px_per_unit(&perspective, &bounds) / at_depth(3.5) - 1.0).abs() < 1e-6);
    let stretched = perspective.with_model(DMat4::from_scale(DVec3::new(3.0, 1.0, 1.2))).unwrap();
    assert!((largest_px_per_unit(&stretched, &bounds) / (3.0 * at_depth(3.4)) - 1.0).abs() < 0.01);
    let parallel = view(Projection::Orthographic { height });
    assert!((largest_px_per_unit(&parallel, &bounds) / (f64::from(SIZE[1]) / height) - 1.0).abs() < 1e-6);
}
