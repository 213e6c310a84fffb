//! Filled pictures of the methods.
#![cfg(feature = "gpu")]

use crate::surfaces::method;
use silhouette_core::glam::Vec3;
use silhouette_core::view::{Camera, ClipRange};
use silhouette_core::{FaceId, PreparedMesh, TriangleMesh};
use silhouette_gpu::{FillsImage, FrameRenderer, FrameView, MeshBuffers};
use silhouette_render::{DEFAULT_FORMATS, Gpu, Image, Load, Target};
use silhouette_smoothing::{AdaptiveRefinement, BoundaryCurve, PhongTessellation, PnTriangles, Smoothing};
use silhouette_testing::views::{PERSPECTIVE, look, three_quarter};
use silhouette_testing::{builtin, gpu_or_skip, prepare};
use std::sync::Arc;

/// A picture within the depths that the renderer asks for, or others.
fn picture<M: FillsImage>(
    gpu: &Gpu,
    mesh: &TriangleMesh,
    words: &[&str],
    camera: &Camera,
    range: Option<ClipRange>,
) -> Image {
    let prepared: Arc<PreparedMesh> = prepare::prepared(mesh.clone());
    let filler: M = method(&prepared, words);
    let buffers = Arc::new(MeshBuffers::new(gpu.device(), gpu.queue(), mesh).unwrap());
    let pipelines = Arc::new(filler.pipelines(gpu.device(), DEFAULT_FORMATS).unwrap());
    let mut renderer = filler.renderer(gpu.device(), gpu.queue(), &pipelines, &buffers).unwrap();
    let tight = camera.clip_range(&mesh.bounds().unwrap());
    let range = range.unwrap_or_else(|| renderer.clip_range(camera, tight));
    let view = FrameView::from_camera(camera, range, DEFAULT_FORMATS.depth_direction).unwrap();
    renderer.prepare(gpu.device(), gpu.queue(), &view).unwrap();
    let target = Target::new(gpu, camera.size(), DEFAULT_FORMATS).unwrap();
    gpu.draw_after(&target, Load::Clear([0.0; 4]), |encoder| renderer.encode(encoder), |pass| renderer.draw(pass))
        .unwrap();
    target.read_color(gpu).unwrap()
}

/// Opaque pixels of a picture.
fn covered<M: FillsImage>(gpu: &Gpu, mesh: &TriangleMesh, words: &[&str], camera: &Camera) -> usize {
    picture::<M>(gpu, mesh, words, camera, None).rgba.chunks_exact(4).filter(|pixel| pixel[3] == 255).count()
}

#[test]
fn coarse_spheres_come_closer_to_disks_than_their_faces_do() {
    let Some(gpu) = gpu_or_skip("coarse_spheres_come_closer_to_disks_than_their_faces_do") else { return };
    let mesh = builtin("icosphere:1");
    let camera = three_quarter(&mesh, PERSPECTIVE, [300, 300]);
    let disk = covered::<PnTriangles>(gpu, &builtin("icosphere:5"), &["level=0"], &camera);
    let faces = covered::<PnTriangles>(gpu, &mesh, &["level=0"], &camera);
    let missing = |pixels: usize| disk.abs_diff(pixels);
    assert!(disk > 20_000 && missing(faces) > 1000, "{faces} of {disk}");
    for (name, pixels, share) in [
        ("smoothing", covered::<Smoothing>(gpu, &mesh, &[], &camera), 0.08),
        ("pn-triangles", covered::<PnTriangles>(gpu, &mesh, &[], &camera), 0.25),
        ("adaptive-refinement", covered::<AdaptiveRefinement>(gpu, &mesh, &[], &camera), 0.25),
        ("phong-tessellation", covered::<PhongTessellation>(gpu, &mesh, &[], &camera), 0.5),
        ("boundary-curve", covered::<BoundaryCurve>(gpu, &mesh, &[], &camera), 0.9),
    ] {
        assert!(missing(pixels) as f64 <= share * missing(faces) as f64, "{name}: {pixels} against {faces} of {disk}");
    }
}

/// Phong tessellation with an alpha of 1 reaches 0.05 radii beyond a sphere of 80 faces.
#[test]
fn surfaces_that_reach_beyond_their_mesh_are_not_clipped() {
    let Some(gpu) = gpu_or_skip("surfaces_that_reach_beyond_their_mesh_are_not_clipped") else { return };
    let mesh = builtin("icosphere:1");
    let toward = mesh.corners(FaceId::new(0)).into_iter().sum::<Vec3>().normalize();
    let camera = look(1.2 * toward, Vec3::ZERO, 20.0, [200, 200]);
    let drawn = |range| picture::<PhongTessellation>(gpu, &mesh, &["alpha=1"], &camera, range);
    let whole = drawn(Some(ClipRange { near: 0.01, far: 10.0 }));
    assert!(drawn(None) == whole);
    // The control: depths that hold no more than the faces.
    assert!(drawn(Some(camera.clip_range(&mesh.bounds().unwrap()))) != whole);
}
