//! Reference images and depths: tiles fit together, numbers mean what they say.

use crate::scenes::{PERSPECTIVE, draw_direct, framed, silhouette, upload};
use glam::{DVec3, Vec3};
use silhouette_core::shapes::{Cuboid, Torus};
use silhouette_core::view::{Camera, Framing, Projection};
use silhouette_gpu::{Color, FillStyle, Pen, PenPlacement, StrokeStyle};
use silhouette_render::{DEFAULT_FORMATS, GpuError, ReferencePicture, ReferenceRenderer};
use silhouette_testing::gpu_or_skip;

#[test]
fn tiles_are_invisible() {
    let Some(gpu) = gpu_or_skip("tiles_are_invisible") else { return };
    let mesh = Torus::default().mesh(48, 24).unwrap();
    let buffers = upload(gpu, &mesh);
    // At 16 samples along a pixel's side a tile is at most 128 pixels wide: four tiles.
    let (n, size) = (16, [170, 150]);
    let camera = framed(&mesh, PERSPECTIVE, size);
    let lines = silhouette(&mesh, &camera);
    let pen = Pen { width_px: 9.0, placement: PenPlacement::Centred };
    let style = StrokeStyle { pen, ..StrokeStyle::default() };
    let fill = FillStyle::PAPER;
    let picture = ReferencePicture { mesh: &buffers, fill, lines: &lines, style, camera, ground: Color::WHITE };
    let mut renderer = ReferenceRenderer::new(gpu).unwrap();
    let tiled = renderer.image(gpu, &picture, n).unwrap();
    assert_eq!(renderer.image(gpu, &picture, n).unwrap(), tiled, "a repeat");

    // The same in one piece, averaged here.
    let wide = StrokeStyle { pen: Pen { width_px: pen.width_px * f64::from(n), ..pen }, ..style };
    let large = camera.with_size(size.map(|side| side * n)).unwrap();
    let samples = draw_direct(gpu, &buffers, &large, &lines, &wide, DEFAULT_FORMATS);
    for y in 0..size[1] {
        for x in 0..size[0] {
            let square = (0..n * n).map(|i| samples.pixel(x * n + i % n, y * n + i / n)[0]);
            let mean = square.map(f64::from).sum::<f64>() / f64::from(n * n);
            let drawn = f64::from(tiled.pixel(x, y)[0]);
            // Eight samples of 256 may fall to the other side of an edge by rounding.
            assert!((drawn - mean).abs() < 8.5, "pixel {x},{y}: {drawn} in tiles, {mean} in one piece");
        }
    }
}

#[test]
fn reference_depth_is_the_distance_along_the_axis() {
    let Some(gpu) = gpu_or_skip("reference_depth_is_the_distance_along_the_axis") else { return };
    let mesh = Cuboid::default().mesh().unwrap();
    let buffers = upload(gpu, &mesh);
    let mut renderer = ReferenceRenderer::new(gpu).unwrap();
    for projection in [Projection::Perspective { fov_y_rad: 0.6 }, Projection::Orthographic { height: 5.0 }] {
        // 700 pixels at 4 samples need several tiles.
        let camera = Camera::new(Vec3::new(0.0, 0.0, 6.0), Vec3::ZERO, Vec3::Y, projection, [700, 40]).unwrap();
        let depth = renderer.depth(gpu, &buffers, &camera, 4).unwrap();
        assert_eq!((depth.values().width, depth.values().height), (2800, 160));
        for world in [DVec3::new(0.9, 0.5, 1.0), DVec3::new(-0.9, -0.2, 1.0), DVec3::new(0.0, 0.0, 1.0)] {
            let pixel = camera.project(world).unwrap().pixel * 4.0;
            let found = depth.view_depth_at(pixel.x, pixel.y).unwrap();
            assert!((found - 5.0).abs() < 1e-4, "{world}: {found}");
            let beside = depth.project(world, world + DVec3::X * 0.01).unwrap();
            assert!((beside.a.truncate() - pixel).length() < 1e-6);
            assert!(depth.visible_at(&beside, 0.0));
            let behind = depth.project(world - DVec3::Z, world - DVec3::Z + DVec3::X * 0.01).unwrap();
            assert!(!depth.visible_at(&behind, 0.5));
        }
        assert_eq!(depth.view_depth_at(3.0, 3.0), None);
        assert_eq!(depth.view_depth_at(-1.0, 80.0), None);
        assert_eq!(depth.view_depth_at(1e9, 80.0), None);
    }
}

#[test]
fn impossible_references_are_refused() {
    let Some(gpu) = gpu_or_skip("impossible_references_are_refused") else { return };
    let mesh = Cuboid::default().mesh().unwrap();
    let buffers = upload(gpu, &mesh);
    let mut renderer = ReferenceRenderer::new(gpu).unwrap();
    let mut depth = |size, n| renderer.depth(gpu, &buffers, &framed(&mesh, Framing::Orthographic, size), n);
    for n in [0, 17] {
        assert!(matches!(depth([8, 8], n), Err(GpuError::Samples { .. })));
    }
    assert!(matches!(depth([16_384, 16_384], 16), Err(GpuError::OverBudget { .. })));
}
