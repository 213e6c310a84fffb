//! Meshes placed by a model matrix, in part of a target, or moved by new positions are drawn as meshes that are there.

use crate::scene::{self, count, framed, ink, torus};
use silhouette_core::glam::{DMat4, DQuat, DVec3, Vec3};
use silhouette_core::mesh::TriangleMesh;
use silhouette_core::view::Camera;
use silhouette_gpu::{FrameRenderer, FrameView, TargetFormats, Viewport};
use silhouette_render::{DEFAULT_FORMATS, Gpu, Image, Load, Target};
use silhouette_testing::gpu_or_skip;

const VARIANTS: [&[&str]; 8] = [
    &["variant=screen"],
    &["variant=screen", "extra-edges=boundary-and-creases", "width-unit=world", "width=0.02"],
    &["variant=wireframe"],
    &["variant=scale", "scale=0.95"],
    &["variant=fixed-pull", "pull=0.05"],
    &["variant=fatten"],
    &["variant=charcoal", "interior=gooch"],
    &["variant=unoriented", "scale=0.95"],
];

/// A rotation with a non-uniform scale, and one that mirrors.
fn models() -> [DMat4; 2] {
    [DVec3::new(1.2, 0.5, 0.9), DVec3::new(0.8, 0.7, -1.1)].map(|scale| {
        DMat4::from_scale_rotation_translation(scale, DQuat::from_rotation_x(0.6), DVec3::new(0.1, -0.2, 0.05))
    })
}

/// The mesh where a matrix puts it, its faces outward again where that mirrors.
fn placed(mesh: &TriangleMesh, model: DMat4) -> TriangleMesh {
    let positions = mesh.positions().iter().map(|p| model.transform_point3(p.as_dvec3()).as_vec3()).collect();
    let turn = |[a, b, c]: [u32; 3]| if model.determinant() < 0.0 { [a, c, b] } else { [a, b, c] };
    TriangleMesh::new(positions, mesh.triangles().iter().copied().map(turn).collect()).unwrap()
}

fn differing(a: &Image, b: &Image) -> usize {
    let close = |a: &[u8], b: &[u8]| a.iter().zip(b).all(|(a, b)| a.abs_diff(*b) < 24);
    a.rgba.chunks_exact(4).zip(b.rgba.chunks_exact(4)).filter(|(a, b)| !close(a, b)).count()
}

/// The view of a mesh that was placed, for a renderer of one that was not.
fn view_of_placed(mesh: &TriangleMesh, camera: &Camera) -> FrameView {
    let bounds = mesh.bounds().unwrap();
    let mut range = camera.clip_range(&bounds);
    range.near *= 0.8;
    FrameView::from_camera(camera, range, DEFAULT_FORMATS.depth_direction).unwrap()
}

fn picture(gpu: &Gpu, mesh: &TriangleMesh, words: &[&str], view: &FrameView) -> Image {
    let mut renderer = scene::renderer(gpu, mesh, words, DEFAULT_FORMATS).unwrap();
    renderer.prepare(gpu.device(), gpu.queue(), view).unwrap();
    scene::draw_with(gpu, &renderer, view.viewport().size_px, DEFAULT_FORMATS)
}

#[test]
fn a_model_matrix_draws_what_the_moved_mesh_draws() {
    let Some(gpu) = gpu_or_skip("a_model_matrix_draws_what_the_moved_mesh_draws") else { return };
    let mesh = torus();
    for model in models() {
        let moved = placed(&mesh, model);
        let camera = framed(&moved, 200);
        let view = view_of_placed(&moved, &camera);
        for words in VARIANTS {
            let expected = picture(gpu, &moved, words, &view);
            let found = picture(gpu, &mesh, words, &view.with_model(model).unwrap());
            let differing = differing(&expected, &found);
            assert!(count(&expected, |value| value < 100) > 150, "{words:?}: lines are drawn");
            assert!(differing < 60, "{words:?}, determinant {}: {differing} pixels", model.determinant());
            // The control: without the matrix the mesh is elsewhere.
            assert!(self::differing(&expected, &picture(gpu, &mesh, words, &view)) > 1000, "{words:?}");
        }
    }
}

#[test]
fn a_viewport_draws_within_its_rectangle_what_a_whole_target_shows() {
    let Some(gpu) = gpu_or_skip("a_viewport_draws_within_its_rectangle_what_a_whole_target_shows") else { return };
    let mesh = torus();
    let camera = framed(&mesh, 100);
    let view = view_of_placed(&mesh, &camera);
    for words in VARIANTS {
        let whole = picture(gpu, &mesh, words, &view);
        let within = view.with_viewport(Viewport { origin_px: [60, 30], size_px: [100; 2] }).unwrap();
        let mut renderer = scene::renderer(gpu, &mesh, words, DEFAULT_FORMATS).unwrap();
        renderer.prepare(gpu.device(), gpu.queue(), &within).unwrap();
        let large = scene::draw_with(gpu, &renderer, [200; 2], DEFAULT_FORMATS);
        let rows = (30..130).flat_map(|y| (60..160).map(move |x| (x, y)));
        let inside = Image { width: 100, height: 100, rgba: rows.flat_map(|(x, y)| large.pixel(x, y)).collect() };
        let differing = differing(&whole, &inside);
        assert!(differing < 20, "{words:?}: {differing} pixels");
        let drawn = |image: &Image| count(image, |value| value != 128);
        assert_eq!(drawn(&large), drawn(&inside), "{words:?}: nothing outside of the rectangle");
    }
}

#[test]
fn new_positions_draw_what_a_new_mesh_draws() {
    let Some(gpu) = gpu_or_skip("new_positions_draw_what_a_new_mesh_draws") else { return };
    let mesh = torus();
    let bent = |p: &Vec3| Vec3::new(p.x, p.y + 0.3 * p.x * p.x, p.z);
    let positions: Vec<Vec3> = mesh.positions().iter().map(bent).collect();
    let moved = TriangleMesh::new(positions.clone(), mesh.triangles().to_vec()).unwrap();
    let camera = framed(&moved, 200);
    let view = view_of_placed(&moved, &camera);
    for words in VARIANTS {
        let expected = picture(gpu, &moved, words, &view);
        let buffers = scene::buffers(gpu, &mesh);
        let mut renderer = scene::renderer_of(gpu, &mesh, words, DEFAULT_FORMATS, &buffers).unwrap();
        buffers.set_positions(gpu.queue(), &positions).unwrap();
        renderer.prepare(gpu.device(), gpu.queue(), &view).unwrap();
        let found = scene::draw_with(gpu, &renderer, camera.size(), DEFAULT_FORMATS);
        // Pulls are in radii of the mesh, which the bent one has others of.
        assert!(differing(&expected, &found) < 60, "{words:?}: {} pixels", differing(&expected, &found));
    }
    let buffers = scene::buffers(gpu, &mesh);
    assert!(buffers.set_positions(gpu.queue(), &positions[1..]).is_err());
    assert!(buffers.set_positions(gpu.queue(), &vec![Vec3::NAN; positions.len()]).is_err());
    assert!(buffers.is_at_rest() && buffers.bounds() == mesh.bounds(), "what is refused changes nothing");
}

#[test]
fn ink_is_the_same_colour_on_encoded_and_on_linear_targets() {
    let Some(gpu) = gpu_or_skip("ink_is_the_same_colour_on_encoded_and_on_linear_targets") else { return };
    let mesh = torus();
    let camera = framed(&mesh, 128);
    let view = view_of_placed(&mesh, &camera);
    let words = ["ink-red=0.75", "ink-green=0.5", "ink-blue=0.25", "interior=grey", "width=4"];
    let [encoded, linear] = [wgpu::TextureFormat::Rgba8Unorm, wgpu::TextureFormat::Rgba8UnormSrgb].map(|color| {
        let formats = TargetFormats { color, ..DEFAULT_FORMATS };
        let mut renderer = scene::renderer(gpu, &mesh, &words, formats).unwrap();
        renderer.prepare(gpu.device(), gpu.queue(), &view).unwrap();
        let target = Target::new(gpu, camera.size(), formats).unwrap();
        let renderer = &renderer;
        gpu.draw_after(&target, Load::Clear([0.0; 4]), |e| renderer.encode(e), |pass| renderer.draw(pass)).unwrap();
        target.read_color(gpu).unwrap()
    });
    let worst = encoded.rgba.iter().zip(&linear.rgba).map(|(a, b)| a.abs_diff(*b)).max();
    assert!(worst <= Some(1), "{worst:?}");
    let is_ink = |pixel: &[u8]| pixel.iter().zip([191, 128, 64, 255]).all(|(a, b): (&u8, u8)| a.abs_diff(b) <= 1);
    assert!(encoded.rgba.chunks_exact(4).filter(|pixel| is_ink(pixel)).count() > 500);
}

#[test]
fn translucent_ink_lets_the_ground_through() {
    let Some(gpu) = gpu_or_skip("translucent_ink_lets_the_ground_through") else { return };
    let mesh = torus();
    let camera = framed(&mesh, 128);
    let opaque = scene::draw(gpu, &mesh, &camera, &["width=4"], DEFAULT_FORMATS).image;
    let half = scene::draw(gpu, &mesh, &camera, &["width=4", "ink-alpha=0.5"], DEFAULT_FORMATS).image;
    let inked = ink(&opaque);
    // The ground is 128 and the interior white: half of either, and less where strokes overlap, but never as dark as ink.
    let once = count(&half, |value| matches!(value, 63 | 64 | 127));
    assert!(once * 3 > inked && ink(&half) == 0, "{once} of {inked}");
    for value in [128, 255] {
        assert_eq!(count(&half, |v| v == value), count(&opaque, |v| v == value), "beside the ink nothing changes");
    }
    assert!(half.rgba.chunks_exact(4).all(|pixel| pixel[3] == 255), "over an opaque ground nothing is transparent");
}
