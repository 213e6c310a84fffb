//! Meshes placed by a model matrix, in part of a target, in any format, or moved by new positions are drawn as meshes that are
//! there.

use crate::scene::{self, PATHS, any_view, count, differing, framed, ink, method, picture_of};
use silhouette_core::glam::{DMat4, DQuat, DVec3, Vec3};
use silhouette_core::mesh::Bounds;
use silhouette_core::view::{ClipRange, DepthDirection};
use silhouette_core::{MethodOptions, TriangleMesh};
use silhouette_edge_mesh::EdgeMeshOptions;
use silhouette_gpu::{DrawsLines, FrameRenderer, FrameView, MeshBuffers, TargetFormats, Viewport};
use silhouette_render::{DEFAULT_FORMATS, Gpu, Image, Load, Target};
use silhouette_testing::edits::{mapped, turned_over, twisted};
use silhouette_testing::{builtin, gpu_or_skip, views};
use std::sync::Arc;

/// Both paths, both facings, features, world widths.
const WORDS: [&[&str]; 5] = [
    &["path=compacted", "width=3"],
    &["path=vertex-stage", "width=3"],
    &["path=compacted", "facing=device", "ridge-angle=40", "valley-angle=40", "ridge-red=1", "width=3"],
    &["path=vertex-stage", "facing=device", "ridge-angle=40", "valley-angle=40", "ridge-red=1", "width=3"],
    &["path=compacted", "width=0.03", "width-unit=world", "ridge-angle=40", "ridge-width=0.03"],
];

fn models() -> [DMat4; 3] {
    [DVec3::new(1.2, 0.5, 0.9), DVec3::new(0.8, 0.7, -1.1), DVec3::new(1.0, 1.0, 10.0)].map(|scale| {
        DMat4::from_scale_rotation_translation(scale, DQuat::from_rotation_x(0.6), DVec3::new(0.1, -0.2, 0.05))
    })
}

/// The mesh where a matrix puts it, its faces outward again where that mirrors.
fn placed(mesh: &TriangleMesh, model: DMat4) -> TriangleMesh {
    let moved = mapped(mesh, |position| model.transform_point3(position.as_dvec3()).as_vec3());
    turned_over(&moved, |_| model.determinant() < 0.0)
}

#[test]
fn a_model_matrix_draws_what_the_moved_mesh_draws() {
    let Some(gpu) = gpu_or_skip("a_model_matrix_draws_what_the_moved_mesh_draws") else { return };
    let mesh = builtin("gear");
    for model in models() {
        let moved = placed(&mesh, model);
        let view = any_view(&moved, &framed(&moved, 200));
        // Ridges follow angles of the mesh's own space, which a scale changes; widths in the world do not.
        for words in WORDS.into_iter().filter(|words| !words.contains(&"facing=device")) {
            let words: Vec<&str> = words.iter().copied().filter(|word| !word.starts_with("ridge")).collect();
            let expected = picture_of(gpu, &moved, &words, &view);
            let found = picture_of(gpu, &mesh, &words, &view.with_model(model).unwrap());
            assert!(ink(&expected) > 150, "{words:?}: lines are drawn");
            let differing = differing(&expected, &found);
            assert!(differing < 40, "{words:?}, {model}: {differing} pixels of {}", ink(&expected));
            // The control: without the matrix the mesh is elsewhere.
            assert!(scene::differing(&expected, &picture_of(gpu, &mesh, &words, &view)) > 1000, "{words:?}");
        }
    }
}

#[test]
fn a_viewport_draws_within_its_rectangle_what_a_whole_target_shows() {
    let Some(gpu) = gpu_or_skip("a_viewport_draws_within_its_rectangle_what_a_whole_target_shows") else { return };
    let mesh = builtin("knot");
    let view = any_view(&mesh, &framed(&mesh, 100));
    for words in WORDS {
        let whole = picture_of(gpu, &mesh, words, &view);
        let within = view.with_viewport(Viewport { origin_px: [60, 30], size_px: [100; 2] }).unwrap();
        let mut renderer = scene::renderer(gpu, &mesh, words);
        renderer.prepare(gpu.device(), gpu.queue(), &within).unwrap();
        let large = scene::draw_with(gpu, &renderer, [200; 2], DEFAULT_FORMATS);
        let rows = (30..130).flat_map(|y| (60..160).map(move |x| (x, y)));
        let inside = Image { width: 100, height: 100, rgba: rows.flat_map(|(x, y)| large.pixel(x, y)).collect() };
        assert!(differing(&whole, &inside) < 20, "{words:?}: {} pixels", differing(&whole, &inside));
        let drawn = |image: &Image| count(image, |value| value != 128);
        assert_eq!(drawn(&large), drawn(&inside), "{words:?}: nothing outside of the rectangle");
    }
}

/// A renderer of a mesh at rest whose positions are then replaced, or come from a buffer, draws what one of the moved mesh draws.
#[test]
fn a_moving_mesh_is_drawn_as_a_mesh_with_those_positions() {
    let Some(gpu) = gpu_or_skip("a_moving_mesh_is_drawn_as_a_mesh_with_those_positions") else { return };
    let mesh = builtin("gear");
    let positions = twisted(&mesh, 0.9, 0.3);
    let moved = TriangleMesh::new(positions.clone(), mesh.triangles().to_vec()).unwrap();
    let camera = framed(&moved, 200);
    let view = any_view(&moved, &camera);
    for words in WORDS {
        let expected = picture_of(gpu, &moved, words, &view);
        assert!(ink(&expected) > 1000);
        let method = method(&mesh, words);
        let set = scene::buffers(gpu, &mesh);
        set.set_positions(gpu.queue(), &positions).unwrap();
        let own = position_buffer(gpu, &positions, &mesh, moved.bounds().unwrap());
        for buffers in [set, own] {
            let mut renderer = scene::renderer_of(gpu, &method, &buffers, DEFAULT_FORMATS);
            renderer.prepare(gpu.device(), gpu.queue(), &view).unwrap();
            let found = scene::draw_with(gpu, &renderer, camera.size(), DEFAULT_FORMATS);
            // A face within rounding of edge-on, and an angle within that of the threshold, may go either way.
            let differing = differing(&expected, &found);
            assert!(differing < 60, "{words:?}: {differing} pixels of {}", ink(&expected));
        }
        // The control: at rest the mesh is drawn otherwise.
        assert!(differing(&expected, &picture_of(gpu, &mesh, words, &view)) > 1000);
    }
}

/// Positions in a buffer of the caller's.
fn position_buffer(gpu: &Gpu, positions: &[Vec3], mesh: &TriangleMesh, bounds: Bounds) -> Arc<MeshBuffers> {
    let bytes: Vec<u8> = positions.iter().flat_map(Vec3::to_array).flat_map(f32::to_le_bytes).collect();
    let buffer = gpu.device().create_buffer(&wgpu::BufferDescriptor {
        label: None,
        size: bytes.len() as u64,
        usage: wgpu::BufferUsages::VERTEX | wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    gpu.queue().write_buffer(&buffer, 0, &bytes);
    let made = MeshBuffers::from_position_buffer(gpu.device(), gpu.queue(), buffer, mesh.triangles(), bounds);
    Arc::new(made.unwrap())
}

#[test]
fn every_depth_direction_format_and_sample_count_draws_the_same() {
    let Some(gpu) = gpu_or_skip("every_depth_direction_format_and_sample_count_draws_the_same") else { return };
    let mesh = builtin("knot");
    let camera = framed(&mesh, 200);
    let bounds = mesh.bounds().unwrap();
    let words = ["width=4", "ink-red=0.75", "ink-green=0.5", "ink-blue=0.25", "ridge-angle=60"];
    let mut pictures = Vec::new();
    for path in PATHS {
        for color in [wgpu::TextureFormat::Rgba8Unorm, wgpu::TextureFormat::Rgba8UnormSrgb] {
            for depth_direction in [DepthDirection::Reversed, DepthDirection::Standard] {
                for samples in [1, 4] {
                    let formats = TargetFormats { color, depth_direction, samples, ..DEFAULT_FORMATS };
                    let words: Vec<&str> = words.into_iter().chain([path]).collect();
                    let mut renderer =
                        scene::renderer_of(gpu, &method(&mesh, &words), &scene::buffers(gpu, &mesh), formats);
                    let view = FrameView::from_camera(&camera, camera.clip_range(&bounds), depth_direction).unwrap();
                    renderer.prepare(gpu.device(), gpu.queue(), &view).unwrap();
                    let target = Target::new(gpu, camera.size(), formats).unwrap();
                    let renderer = &renderer;
                    gpu.draw_after(&target, Load::Clear([0.0; 4]), |e| renderer.encode(e), |pass| renderer.draw(pass))
                        .unwrap();
                    pictures.push((formats, target.read_color(gpu).unwrap()));
                }
            }
        }
    }
    let is_ink = |pixel: &[u8]| pixel.iter().zip([191, 128, 64, 255]).all(|(a, b): (&u8, u8)| a.abs_diff(b) <= 1);
    let inked = |image: &Image| image.rgba.chunks_exact(4).filter(|pixel| is_ink(pixel)).count();
    let first = inked(&pictures[0].1);
    assert!(first > 2000);
    for (formats, image) in &pictures {
        // Where several samples are averaged, the pixels along the sides of lines are mixed.
        let least = if formats.samples == 1 { first - first / 100 } else { first / 2 };
        assert!((least..=first + first / 100).contains(&inked(image)), "{formats:?}: {} of {first}", inked(image));
    }
    // A view for the other depth is refused.
    let mut renderer = scene::renderer(gpu, &mesh, &[]);
    let range = ClipRange { near: 0.1, far: 10.0 };
    let view = FrameView::from_camera(&camera, range, DepthDirection::Standard).unwrap();
    assert!(renderer.prepare(gpu.device(), gpu.queue(), &view).is_err());
}

#[test]
fn interiors_and_translucent_ink_leave_the_ground_as_they_should() {
    let Some(gpu) = gpu_or_skip("interiors_and_translucent_ink_leave_the_ground_as_they_should") else { return };
    let mesh = builtin("knot");
    let view = any_view(&mesh, &framed(&mesh, 200));
    for path in PATHS {
        let of = |words: &[&str]| picture_of(gpu, &mesh, &[&[path, "width=3"], words].concat(), &view);
        let [paper, depth, none] = ["paper", "depth-only", "none"].map(|kind| of(&[&format!("interior={kind}")]));
        let lines = |image: &Image| image.rgba.chunks_exact(4).map(|pixel| pixel[0] == 0).collect::<Vec<_>>();
        assert_eq!(lines(&paper), lines(&depth), "{path}: depth alone hides the same lines");
        assert!(count(&depth, |value| value == 255) == 0 && count(&paper, |value| value == 255) > 3000);
        assert!(ink(&none) > ink(&depth), "{path}: nothing hides lines");
        for cull in ["cull=none", "cull=back"] {
            assert_eq!(of(&[cull]), paper, "{path}, {cull}: back faces of a closed mesh are hidden");
        }
        let half = of(&["ink-alpha=0.5"]);
        let once = count(&half, |value| matches!(value, 63 | 64 | 127));
        assert_eq!(count(&half, |value| !matches!(value, 128 | 255)), ink(&paper), "{path}");
        assert!(
            once > 100 && ink(&half) * 10 < ink(&paper),
            "{path}: {once} pixels are inked once, {} black",
            ink(&half)
        );
        for value in [128, 255] {
            assert_eq!(count(&half, |v| v == value), count(&paper, |v| v == value), "beside the ink nothing changes");
        }
    }
}

#[test]
fn a_renderer_for_the_buffers_of_another_mesh_is_refused() {
    let Some(gpu) = gpu_or_skip("a_renderer_for_the_buffers_of_another_mesh_is_refused") else { return };
    let method = method(&builtin("cube"), &[]);
    let pipelines = Arc::new(method.pipelines(gpu.device(), DEFAULT_FORMATS).unwrap());
    let other = scene::buffers(gpu, &builtin("cone"));
    assert!(method.renderer(gpu.device(), gpu.queue(), &pipelines, &other).is_err());
    assert!(EdgeMeshOptions::parse(["width=-1"]).is_err() && EdgeMeshOptions::parse(["ridge-angle=0"]).is_err());
}

/// Seen from inside, through the near plane, or on a mesh that is inside out, back faces are what there is to see.
#[test]
fn back_faces_that_can_be_seen_hide_lines_and_show_features() {
    let test = "back_faces_that_can_be_seen_hide_lines_and_show_features";
    let Some(gpu) = gpu_or_skip(test) else { return };
    let cube = builtin("cube");
    let inside_out = turned_over(&cube, |_| true);
    let outside = views::look(Vec3::new(2.0, 1.5, 2.5), Vec3::ZERO, 40.0, [160; 2]);
    let inside = views::look(Vec3::new(0.1, 0.05, 0.2), Vec3::new(5.0, 4.0, 6.0), 110.0, [160; 2]);
    let cut = FrameView::from_camera(&outside, ClipRange { near: 3.2, far: 9.0 }, DEFAULT_FORMATS.depth_direction);
    let views = [
        ("outside", &cube, any_view(&cube, &outside), true),
        ("inside", &cube, any_view(&cube, &inside), false),
        ("cut", &cube, cut.unwrap(), false),
        ("inside out", &inside_out, any_view(&inside_out, &outside), false),
    ];
    for (name, mesh, view, hides) in views {
        let mut renderer = scene::renderer(gpu, mesh, &["ridge-angle=30", "valley-angle=30", "width=0"]);
        renderer.prepare(gpu.device(), gpu.queue(), &view).unwrap();
        assert_eq!(renderer.hides_back_faces(), hides, "{name}");
        let words = |cull| picture_of(gpu, mesh, &["ridge-angle=30", "valley-angle=30", "width=3", cull], &view);
        assert_eq!(words("cull=auto"), words("cull=none"), "{name}");
        let features = picture_of(gpu, mesh, &["ridge-angle=30", "valley-angle=30", "width=0"], &view);
        assert!(ink(&features) > 50, "{name}: its edges are in sight");
    }
}
