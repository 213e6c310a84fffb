//! Targets of every size and format, and the mesh drawn into them.

use crate::scenes::{
    DEPTH_FORMATS, DIRECTIONS, PERSPECTIVE, difference, draw_direct, empty_mesh, fill, framed, upload, view_for,
};
use glam::{DVec2, Vec3};
use silhouette_core::mesh::TriangleMesh;
use silhouette_core::shapes::{Cuboid, Torus};
use silhouette_core::view::{Camera, Projection};
use silhouette_gpu::{Color, Cull, FillStyle, Polylines, Shade, StrokeStyle, TargetFormats};
use silhouette_render::{DEFAULT_FORMATS, Gpu, Image, Load, Target};
use silhouette_testing::gpu_or_skip;

const BLACK: FillStyle = FillStyle { shade: Shade::Flat(Color::BLACK), cull: Cull::None };

const GREY: Color = Color { srgb: [0.5; 3], alpha: 1.0 };

fn filled(gpu: &Gpu, mesh: &TriangleMesh, camera: &Camera, style: FillStyle, formats: TargetFormats) -> Image {
    let mesh = upload(gpu, mesh);
    fill(gpu, &mesh, &view_for(camera, &mesh, formats), style, formats).read_color(gpu).unwrap()
}

#[test]
fn every_size_is_read_back_without_padding() {
    let Some(gpu) = gpu_or_skip("every_size_is_read_back_without_padding") else { return };
    for size in [[1, 1], [3, 2], [64, 1], [65, 33], [1, 300]] {
        let target = Target::new(gpu, size, DEFAULT_FORMATS).unwrap();
        let time = gpu.draw(&target, Load::Clear([0.2, 0.4, 0.6, 1.0]), |_| {}).unwrap();
        assert_eq!(time.gpu_ms.is_some(), gpu.adapter().timestamps);
        assert!(time.wall_ms > 0.0 && time.gpu_ms.is_none_or(|ms| ms >= 0.0));
        let image = target.read_color(gpu).unwrap();
        assert_eq!(image.rgba, [51, 102, 153, 255].repeat((size[0] * size[1]) as usize));
        assert_eq!(target.read_depth(gpu).unwrap().values, vec![0.0; (size[0] * size[1]) as usize]);
    }
}

#[test]
fn one_pixel_sees_the_mesh() {
    let Some(gpu) = gpu_or_skip("one_pixel_sees_the_mesh") else { return };
    let cube = Cuboid::default().mesh().unwrap();
    let image = filled(gpu, &cube, &framed(&cube, PERSPECTIVE, [1, 1]), BLACK, DEFAULT_FORMATS);
    assert_eq!(image.rgba, [0, 0, 0, 255]);
}

#[test]
fn depth_is_read_back_in_every_format() {
    let Some(gpu) = gpu_or_skip("depth_is_read_back_in_every_format") else { return };
    let cube = Cuboid::default().mesh().unwrap();
    let buffers = upload(gpu, &cube);
    for projection in [Projection::Perspective { fov_y_rad: 0.7 }, Projection::Orthographic { height: 4.0 }] {
        let camera = Camera::new(Vec3::new(0.1, 0.2, 5.0), Vec3::new(0.1, 0.2, 0.0), Vec3::Y, projection, [33; 2]);
        let camera = camera.unwrap();
        for depth in DEPTH_FORMATS {
            for depth_direction in DIRECTIONS {
                let formats = TargetFormats { depth, depth_direction, ..DEFAULT_FORMATS };
                let view = view_for(&camera, &buffers, formats);
                let target = fill(gpu, &buffers, &view, FillStyle::DEPTH, formats);
                assert_eq!(target.read_color(gpu).unwrap().pixel(16, 16), [255; 4], "no colour is written");
                let image = target.read_depth(gpu).unwrap();
                assert_eq!(image.value(0, 0).to_bits(), formats.clear_depth().to_bits());
                let found = view.depth_law().depth_of_value(f64::from(image.value(16, 16)));
                assert!((found - 4.0).abs() < 1e-3, "{formats:?}: the front side is 4 units away, not {found}");
            }
        }
    }
}

#[test]
fn culling_changes_nothing_on_a_closed_mesh_and_halves_an_open_one() {
    let Some(gpu) = gpu_or_skip("culling_changes_nothing_on_a_closed_mesh_and_halves_an_open_one") else { return };
    let torus = Torus::default().mesh(48, 24).unwrap();
    let camera = framed(&torus, PERSPECTIVE, [96; 2]);
    for shade in [BLACK.shade, Shade::Lit(Color { srgb: [0.9, 0.5, 0.2], alpha: 1.0 })] {
        let all = filled(gpu, &torus, &camera, FillStyle { shade, cull: Cull::None }, DEFAULT_FORMATS);
        let front = filled(gpu, &torus, &camera, FillStyle { shade, cull: Cull::Back }, DEFAULT_FORMATS);
        assert_eq!(difference(&all, &front), 0, "{shade:?}");
    }
    let triangle = |corners| TriangleMesh::new(vec![Vec3::ZERO, Vec3::X, Vec3::Y], vec![corners]).unwrap();
    let from_front = Camera::new(Vec3::Z * 2.0, Vec3::ZERO, Vec3::Y, camera.projection(), [32; 2]).unwrap();
    let culled = FillStyle { cull: Cull::Back, ..BLACK };
    let dark = |mesh| filled(gpu, &mesh, &from_front, culled, DEFAULT_FORMATS).rgba.contains(&0);
    assert!(dark(triangle([0, 1, 2])), "counter-clockwise is front");
    assert!(!dark(triangle([0, 2, 1])));
}

#[test]
fn lit_faces_differ_and_flat_ones_do_not() {
    let Some(gpu) = gpu_or_skip("lit_faces_differ_and_flat_ones_do_not") else { return };
    let cube = Cuboid::default().mesh().unwrap();
    let camera = framed(&cube, PERSPECTIVE, [64; 2]);
    let shades = |shade| {
        let image = filled(gpu, &cube, &camera, FillStyle { shade, cull: Cull::Back }, DEFAULT_FORMATS);
        let mut shades: Vec<u8> = image.rgba.chunks_exact(4).map(|pixel| pixel[0]).collect();
        shades.sort_unstable();
        shades.dedup();
        shades.len()
    };
    assert_eq!(shades(Shade::Flat(GREY)), 2);
    assert!(shades(Shade::Lit(GREY)) >= 4, "three sides and the paper");
}

#[test]
fn four_samples_smooth_edges() {
    let Some(gpu) = gpu_or_skip("four_samples_smooth_edges") else { return };
    let cube = Cuboid::default().mesh().unwrap();
    let camera = framed(&cube, PERSPECTIVE, [64; 2]);
    let greys = |samples| {
        let image = filled(gpu, &cube, &camera, BLACK, TargetFormats { samples, ..DEFAULT_FORMATS });
        image.rgba.chunks_exact(4).filter(|pixel| (1..255).contains(&pixel[0])).count()
    };
    assert_eq!(greys(1), 0);
    assert!(greys(4) > 50);
}

#[test]
fn far_from_the_origin_the_picture_is_the_same() {
    let Some(gpu) = gpu_or_skip("far_from_the_origin_the_picture_is_the_same") else { return };
    let cube = Cuboid::default().mesh().unwrap();
    // At 2^20 floats are 1/16 apart: the cube's corners and the eye are exact.
    let offset = Vec3::new(1_048_576.0, -1_048_576.0, 524_288.0);
    let moved = cube.positions().iter().map(|&p| p + offset).collect();
    let moved = TriangleMesh::new(moved, cube.triangles().to_vec()).unwrap();
    let projection = Projection::Perspective { fov_y_rad: 0.7 };
    let camera = |at: Vec3| Camera::new(at + Vec3::new(2.0, 1.5, 5.25), at, Vec3::Y, projection, [128; 2]).unwrap();
    let lit = FillStyle { shade: Shade::Lit(Color::WHITE), cull: Cull::None };
    let near = filled(gpu, &cube, &camera(Vec3::ZERO), lit, DEFAULT_FORMATS);
    let far = filled(gpu, &moved, &camera(offset), lit, DEFAULT_FORMATS);
    assert!(difference(&near, &far) <= 2, "{} pixels differ", difference(&near, &far));
}

#[test]
fn any_unit_of_length_gives_the_same_picture() {
    let Some(gpu) = gpu_or_skip("any_unit_of_length_gives_the_same_picture") else { return };
    let cube = Cuboid::default().mesh().unwrap();
    let picture = |scale: f32| {
        let scaled = cube.positions().iter().map(|&p| p * scale).collect();
        let scaled = TriangleMesh::new(scaled, cube.triangles().to_vec()).unwrap();
        let camera = framed(&scaled, PERSPECTIVE, [64; 2]);
        let mut lines = Polylines::new();
        let corners = [0, 1, 3, 2].map(|corner: usize| scaled.positions()[corner].as_dvec3());
        lines.push(corners, true);
        let style = StrokeStyle::default();
        draw_direct(gpu, &upload(gpu, &scaled), &camera, &lines, &style, DEFAULT_FORMATS)
    };
    let unit = picture(1.0);
    assert!(unit.rgba.contains(&0));
    for exponent in [-60, -20, 20, 60] {
        assert!(difference(&unit, &picture(2.0_f32.powi(exponent))) <= 2, "2^{exponent}");
    }
}

#[test]
fn an_empty_mesh_is_a_blank_page() {
    let Some(gpu) = gpu_or_skip("an_empty_mesh_is_a_blank_page") else { return };
    let cube = Cuboid::default().mesh().unwrap();
    let camera = framed(&cube, PERSPECTIVE, [16; 2]);
    let buffers = upload(gpu, &empty_mesh());
    let style = StrokeStyle::default();
    let image = draw_direct(gpu, &buffers, &camera, &Polylines::new(), &style, DEFAULT_FORMATS);
    assert!(image.rgba.iter().all(|&value| value == 255));
    assert_eq!(buffers.bytes(), 0);
}

#[test]
fn positions_are_where_the_camera_says() {
    let Some(gpu) = gpu_or_skip("positions_are_where_the_camera_says") else { return };
    let p = [Vec3::new(-1.0, -0.5, 0.0), Vec3::new(1.0, -0.5, 0.3), Vec3::new(0.2, 0.9, -0.4)];
    let mesh = TriangleMesh::new(p.to_vec(), vec![[0, 1, 2]]).unwrap();
    let camera = framed(&mesh, PERSPECTIVE, [80, 60]);
    let image = filled(gpu, &mesh, &camera, BLACK, DEFAULT_FORMATS);
    let corners = p.map(|corner| camera.project(corner.as_dvec3()).unwrap().pixel);
    for y in 0..60 {
        for x in 0..80 {
            let q = DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
            // Signed distances to the sides, positive inside (pixel rows run down).
            let inside = (0..3).map(|i| {
                let (a, b) = (corners[i], corners[(i + 1) % 3]);
                -(b - a).normalize().perp_dot(q - a)
            });
            let least = inside.fold(f64::INFINITY, f64::min);
            if least.abs() > 0.02 {
                assert_eq!(image.pixel(x, y)[0] == 0, least > 0.0, "pixel {x},{y}");
            }
        }
    }
}
