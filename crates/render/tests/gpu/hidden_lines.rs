//! Lines are hidden by what is in front of them, whole and by nothing else.

use crate::scenes::{
    DEPTH_FORMATS, DIRECTIONS, PERSPECTIVE, difference, draw_direct, draw_on_paper, fill, framed, ink, silhouette,
    strokes, upload,
};
use glam::{DVec3, Vec3};
use silhouette_core::mesh::TriangleMesh;
use silhouette_core::shapes::{Cuboid, Sphere, Torus};
use silhouette_core::view::{Camera, ClipRange, Framing, Projection};
use silhouette_gpu::{Cap, FillStyle, FrameView, Hidden, Pen, PenPlacement, Polylines, StrokeStyle, TargetFormats};
use silhouette_render::{DEFAULT_FORMATS, ReferenceRenderer};
use silhouette_testing::gpu_or_skip;

fn pen(width_px: f64) -> StrokeStyle {
    StrokeStyle { pen: Pen { width_px, placement: PenPlacement::Centred }, ..StrokeStyle::default() }
}

fn drawn_too(style: StrokeStyle) -> StrokeStyle {
    StrokeStyle { hidden: Hidden::Drawn, ..style }
}

#[test]
fn the_outline_of_a_convex_mesh_has_no_gaps() {
    let Some(gpu) = gpu_or_skip("the_outline_of_a_convex_mesh_has_no_gaps") else { return };
    let meshes = [Cuboid::default().mesh().unwrap(), Sphere::default().icosphere(3).unwrap()];
    for mesh in meshes {
        let buffers = upload(gpu, &mesh);
        for framing in [PERSPECTIVE, Framing::Orthographic] {
            let camera = framed(&mesh, framing, [150, 120]);
            let lines = silhouette(&mesh, &camera);
            for depth in DEPTH_FORMATS {
                for depth_direction in DIRECTIONS {
                    let formats = TargetFormats { depth, depth_direction, ..DEFAULT_FORMATS };
                    let draw = |style: &StrokeStyle| draw_direct(gpu, &buffers, &camera, &lines, style, formats);
                    let (visible, all) = (draw(&pen(2.0)), draw(&drawn_too(pen(2.0))));
                    assert!(ink(&all) > 500.0);
                    assert_eq!(difference(&visible, &all), 0, "{formats:?} {framing:?}");
                }
            }
        }
    }
}

#[test]
fn a_cube_behind_a_plate_leaves_no_ink() {
    let Some(gpu) = gpu_or_skip("a_cube_behind_a_plate_leaves_no_ink") else { return };
    let cube = Cuboid::default().mesh().unwrap();
    let plate = Cuboid { size: [8.0, 8.0, 0.02] }.mesh().unwrap();
    let plate_at = Vec3::Z * 1.1;
    let mut positions = cube.positions().to_vec();
    positions.extend(plate.positions().iter().map(|&p| p + plate_at));
    let mut triangles = cube.triangles().to_vec();
    triangles.extend(plate.triangles().iter().map(|t| t.map(|vertex| vertex + 8)));
    let both = upload(gpu, &TriangleMesh::new(positions, triangles).unwrap());
    for projection in [Projection::Perspective { fov_y_rad: 0.5 }, Projection::Orthographic { height: 4.0 }] {
        let camera = Camera::new(Vec3::new(0.3, 0.2, 9.0), Vec3::ZERO, Vec3::Y, projection, [128; 2]).unwrap();
        let mut lines = silhouette(&cube, &camera);
        // The plate's own far side, just behind it.
        let corner = |x, y| DVec3::new(x, y, 1.09);
        lines.push([corner(-3.0, -3.0), corner(3.0, -2.0), corner(-1.0, 3.0)], true);
        for depth in DEPTH_FORMATS {
            for depth_direction in DIRECTIONS {
                let formats = TargetFormats { depth, depth_direction, ..DEFAULT_FORMATS };
                let hidden = draw_direct(gpu, &both, &camera, &lines, &pen(3.0), formats);
                let all = draw_direct(gpu, &both, &camera, &lines, &drawn_too(pen(3.0)), formats);
                assert!(ink(&all) > 500.0);
                assert!(ink(&hidden) < 1e-9, "{formats:?} {projection:?}: {} px", ink(&hidden));
            }
        }
    }
}

#[test]
fn depth_formats_and_directions_agree_and_repeats_are_identical() {
    let Some(gpu) = gpu_or_skip("depth_formats_and_directions_agree_and_repeats_are_identical") else { return };
    let mesh = Torus::default().mesh(64, 32).unwrap();
    let buffers = upload(gpu, &mesh);
    let camera = framed(&mesh, PERSPECTIVE, [160; 2]);
    let lines = silhouette(&mesh, &camera);
    let draw = |formats| draw_direct(gpu, &buffers, &camera, &lines, &pen(2.0), formats);
    let expected = draw(DEFAULT_FORMATS);
    assert_eq!(draw(DEFAULT_FORMATS), expected);
    let all = draw_direct(gpu, &buffers, &camera, &lines, &drawn_too(pen(2.0)), DEFAULT_FORMATS);
    assert!(ink(&expected) > 300.0 && difference(&all, &expected) > 20, "some of a torus is hidden");
    for depth in DEPTH_FORMATS {
        for depth_direction in DIRECTIONS {
            let formats = TargetFormats { depth, depth_direction, ..DEFAULT_FORMATS };
            let differing = difference(&draw(formats), &expected) as f64;
            assert!(differing <= 0.02 * ink(&expected), "{formats:?}: {differing} px");
        }
    }
}

#[test]
fn lines_over_a_multisampled_picture_are_smooth() {
    let Some(gpu) = gpu_or_skip("lines_over_a_multisampled_picture_are_smooth") else { return };
    let mesh = Cuboid::default().mesh().unwrap();
    let buffers = upload(gpu, &mesh);
    let camera = framed(&mesh, PERSPECTIVE, [96; 2]);
    let lines = silhouette(&mesh, &camera);
    let formats = TargetFormats { samples: 4, ..DEFAULT_FORMATS };
    let image = draw_direct(gpu, &buffers, &camera, &lines, &pen(2.0), formats);
    let direct = draw_direct(gpu, &buffers, &camera, &lines, &pen(2.0), DEFAULT_FORMATS);
    assert!((ink(&image) / ink(&direct) - 1.0).abs() < 0.05, "{} {}", ink(&image), ink(&direct));
    assert!(image.rgba.chunks_exact(4).filter(|pixel| (1..255).contains(&pixel[0])).count() > 100);
}

/// The depth of the whole scene, drawn by the caller, hides lines as the renderer's own depth of its mesh does.
#[test]
fn a_depth_texture_of_the_caller_hides_lines() {
    let Some(gpu) = gpu_or_skip("a_depth_texture_of_the_caller_hides_lines") else { return };
    let cube = Cuboid::default().mesh().unwrap();
    let positions = cube.positions().iter().map(|&p| 3.0 * p - Vec3::Z * 6.0).collect();
    let [near, far] =
        [upload(gpu, &cube), upload(gpu, &TriangleMesh::new(positions, cube.triangles().to_vec()).unwrap())];
    let projection = Projection::Perspective { fov_y_rad: 0.5 };
    let camera = Camera::new(Vec3::new(0.3, 0.2, 9.0), Vec3::ZERO, Vec3::Y, projection, [128; 2]).unwrap();
    let mut lines = Polylines::new();
    // Behind the near cube, before the far one.
    lines.push([DVec3::new(-0.5, -0.5, -1.5), DVec3::new(0.5, 0.4, -1.5)], false);
    let range = ClipRange { near: 1.0, far: 40.0 };
    let view = FrameView::from_camera(&camera, range, DEFAULT_FORMATS.depth_direction).unwrap();
    let mut renderer = strokes(gpu, &far, &lines, &pen(3.0), DEFAULT_FORMATS);
    let mut draw = |depth| {
        renderer.set_scene_depth(depth);
        ink(&draw_on_paper(gpu, &mut renderer, &view, DEFAULT_FORMATS).read_color(gpu).unwrap())
    };
    let scene = fill(gpu, &near, &view, FillStyle::DEPTH, DEFAULT_FORMATS);
    assert!(draw(None) > 50.0, "before the far cube");
    assert!(draw(Some(scene.depth_view().clone())) < 1e-9, "behind the near cube");
    assert!(draw(None) > 50.0, "and back");
}

#[test]
fn the_cpu_decides_as_the_gpu_does() {
    let Some(gpu) = gpu_or_skip("the_cpu_decides_as_the_gpu_does") else { return };
    let mesh = Torus::default().mesh(48, 24).unwrap();
    let buffers = upload(gpu, &mesh);
    let (mut pixels, mut differing) = (0, 0);
    for framing in [PERSPECTIVE, Framing::Orthographic] {
        let camera = framed(&mesh, framing, [128; 2]);
        let reference = ReferenceRenderer::new(gpu).unwrap().depth(gpu, &buffers, &camera, 1).unwrap();
        for i in 0..12 {
            let end = |phase: f64| DVec3::new((phase * 1.7).sin(), (phase * 2.3).cos(), (phase * 3.1).sin()) * 1.4;
            let (a, b) = (end(f64::from(i)), end(f64::from(i) + 0.8));
            let mut line = Polylines::new();
            line.push([a, b], false);
            let style = StrokeStyle { cap: Cap::Butt, ..pen(3.0) };
            let draw = |style: &StrokeStyle| draw_direct(gpu, &buffers, &camera, &line, style, DEFAULT_FORMATS);
            let (visible, all) = (draw(&style), draw(&drawn_too(style)));
            let segment = reference.project(a, b).unwrap();
            let along = segment.b.truncate() - segment.a.truncate();
            for (index, pixel) in all.rgba.chunks_exact(4).enumerate().filter(|(_, pixel)| pixel[0] == 0) {
                assert_eq!(pixel[3], 255);
                let center = glam::DVec2::new((index % 128) as f64 + 0.5, (index / 128) as f64 + 0.5);
                let t = ((center - segment.a.truncate()).dot(along) / along.length_squared()).clamp(0.0, 1.0);
                let on_gpu = visible.rgba[4 * index] == 0;
                pixels += 1;
                differing += usize::from(reference.visible_at(&segment, t) != on_gpu);
            }
        }
    }
    assert!(pixels > 2000 && differing * 500 <= pixels, "{differing} of {pixels} pixels differ");
}

#[test]
fn an_eye_on_the_mesh_draws_bounded_strokes() {
    let Some(gpu) = gpu_or_skip("an_eye_on_the_mesh_draws_bounded_strokes") else { return };
    let mesh = Cuboid::default().mesh().unwrap();
    let buffers = upload(gpu, &mesh);
    for eye in [Vec3::ZERO, Vec3::Z, Vec3::ONE, Vec3::new(0.999, 0.2, 0.1)] {
        let projection = Projection::Perspective { fov_y_rad: 1.2 };
        let camera = Camera::new(eye, eye + Vec3::new(-0.3, -0.2, -1.0), Vec3::Y, projection, [64; 2]).unwrap();
        let mut lines = Polylines::new();
        for [a, b, c] in mesh.triangles().iter().map(|t| t.map(|v| mesh.positions()[v as usize].as_dvec3())) {
            lines.push([a, b, c], true);
        }
        let image = draw_direct(gpu, &buffers, &camera, &lines, &drawn_too(pen(1.0)), DEFAULT_FORMATS);
        // 18 edges of at most the diagonal each.
        assert!(ink(&image) < 18.0 * 91.0 * 1.5, "{eye}: {} px", ink(&image));
    }
}
