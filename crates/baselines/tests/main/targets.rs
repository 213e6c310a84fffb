//! Targets of every kind, meshes at their limits.

use crate::scene::{
    self, Lines, buffers, camera, count, draw_passes, ink, sphere_view, square, three_quarter, torus, view,
};
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::mesh::TriangleMesh;
use silhouette_core::shapes::Cuboid;
use silhouette_core::view::{Camera, DepthDirection, Projection};
use silhouette_gpu::{
    FillPipelines, FillRenderer, FillStyle, FrameRenderer, FrameView, RendererError, TargetFormats, Viewport,
};
use silhouette_render::{DEFAULT_FORMATS, Image, Load, Target};
use silhouette_testing::{gpu_or_skip, zoo};
use std::sync::Arc;

#[test]
fn every_depth_format_and_direction_draws_the_same_lines() {
    let Some(gpu) = gpu_or_skip("every_depth_format_and_direction_draws_the_same_lines") else { return };
    let mesh = torus();
    let camera = three_quarter(4.0, 200);
    use wgpu::TextureFormat::{Depth16Unorm, Depth24Plus, Depth32Float};
    for lines in Lines::ALL {
        let expected = ink(&lines.seen(gpu, &mesh, &["width=4"], &camera)) as f64;
        for depth in [Depth16Unorm, Depth24Plus, Depth32Float] {
            for depth_direction in [DepthDirection::Standard, DepthDirection::Reversed] {
                for samples in [1, 4] {
                    let formats = TargetFormats { depth, depth_direction, samples, ..DEFAULT_FORMATS };
                    let mut renderer = lines.renderer(gpu, &mesh, &["width=4"], formats, &buffers(gpu, &mesh));
                    renderer.prepare(gpu.device(), gpu.queue(), &view(&mesh, &camera, formats)).unwrap();
                    let image = scene::draw_with(gpu, &*renderer, [200; 2], formats);
                    // A rim of ink and white, or of ink and ground, is as dark as the ink's share of it.
                    let dark = count(&image, |value| value < 90) as f64;
                    assert!((dark / expected - 1.0).abs() < 0.08, "{lines:?} {formats:?}: {dark} of {expected}");
                }
            }
        }
    }
}

#[test]
fn orthographic_views_have_the_same_lines_as_a_distant_eye() {
    let Some(gpu) = gpu_or_skip("orthographic_views_have_the_same_lines_as_a_distant_eye") else { return };
    let mesh = torus();
    let toward = DVec3::new(0.55, 0.35, 1.0).normalize();
    let height = 200.0 * 2.0 * (0.5_f64.to_radians()).tan();
    let near = camera(200.0 * toward, 1.0, [200; 2]);
    let projection = Projection::Orthographic { height };
    let flat = Camera::new((200.0 * toward).as_vec3(), Vec3::ZERO, Vec3::Y, projection, [200; 2]).unwrap();
    for lines in Lines::ALL {
        let [near, flat] = [&near, &flat].map(|camera| lines.seen(gpu, &mesh, &["width=3"], camera));
        let differs = scene::differing(&near, &flat);
        assert!(ink(&flat) > 1000 && differs < 300, "{lines:?}: {differs} px of {}", ink(&flat));
    }
}

#[test]
fn ink_is_the_same_colour_on_encoded_and_on_linear_targets() {
    let Some(gpu) = gpu_or_skip("ink_is_the_same_colour_on_encoded_and_on_linear_targets") else { return };
    let mesh = torus();
    let view = view(&mesh, &three_quarter(4.0, 128), DEFAULT_FORMATS);
    let words = ["ink-red=0.75", "ink-green=0.5", "ink-blue=0.25", "width=4"];
    for lines in Lines::ALL {
        let [encoded, linear] = [wgpu::TextureFormat::Rgba8Unorm, wgpu::TextureFormat::Rgba8UnormSrgb].map(|color| {
            let formats = TargetFormats { color, ..DEFAULT_FORMATS };
            let mut renderer = lines.renderer(gpu, &mesh, &words, formats, &buffers(gpu, &mesh));
            renderer.prepare(gpu.device(), gpu.queue(), &view).unwrap();
            let target = Target::new(gpu, [128; 2], formats).unwrap();
            let renderer = &*renderer;
            gpu.draw_after(&target, Load::Clear([0.0; 4]), |e| renderer.encode(e), |pass| renderer.draw(pass)).unwrap();
            target.read_color(gpu).unwrap()
        });
        let worst = encoded.rgba.iter().zip(&linear.rgba).map(|(a, b)| a.abs_diff(*b)).max();
        assert!(worst <= Some(1), "{lines:?}: {worst:?}");
        let is_ink = |pixel: &[u8]| pixel.iter().zip([191, 128, 64, 255]).all(|(a, b): (&u8, u8)| a.abs_diff(b) <= 1);
        assert!(encoded.rgba.chunks_exact(4).filter(|pixel| is_ink(pixel)).count() > 500, "{lines:?}");
    }
}

#[test]
fn translucent_ink_lets_the_ground_through_and_darkens_nothing_twice() {
    let Some(gpu) = gpu_or_skip("translucent_ink_lets_the_ground_through_and_darkens_nothing_twice") else { return };
    let (mesh, camera) = (torus(), three_quarter(4.0, 128));
    // Hulls of the torus overlap themselves in the image; the others ink each pixel once.
    for lines in [Lines::Filter, Lines::Flood] {
        let [opaque, half] = ["ink-alpha=1", "ink-alpha=0.5"].map(|a| lines.seen(gpu, &mesh, &["width=4", a], &camera));
        let once = count(&half, |value| matches!(value, 63..=65 | 127));
        assert!(ink(&half) == 0 && once >= ink(&opaque), "{lines:?}: {once} of {}", ink(&opaque));
        assert!(half.rgba.chunks_exact(4).all(|pixel| pixel[3] == 255), "{lines:?}");
        assert_eq!(count(&lines.seen(gpu, &mesh, &["width=0"], &camera), |value| value == 0), 0, "{lines:?}: no width");
    }
}

#[test]
fn what_stands_before_a_mesh_hides_its_lines() {
    let Some(gpu) = gpu_or_skip("what_stands_before_a_mesh_hides_its_lines") else { return };
    let mesh = torus();
    let camera = camera(DVec3::Z * 5.0, 40.0, [128; 2]);
    // To the right of the middle of the picture, before or behind the mesh.
    let wall = |z: f32| silhouette_testing::edits::mapped(&square(z), |p| Vec3::new(1.5 + 1.5 * p.x, 2.0 * p.y, p.z));
    let view = FrameView::from_camera(
        &camera,
        silhouette_core::view::ClipRange { near: 0.5, far: 20.0 },
        DEFAULT_FORMATS.depth_direction,
    );
    let view = view.unwrap();
    let right = |image: &Image| {
        let pixels = (0..128).flat_map(|y| (67..128).map(move |x| [x, y]));
        pixels.filter(|&[x, y]| image.pixel(x, y)[0] == 0).count()
    };
    for lines in Lines::ALL {
        for interior in ["interior=paper", "interior=none"] {
            let inked = [2.5, -2.5].map(|z| {
                let wall = wall(z);
                let pipelines = Arc::new(FillPipelines::new(gpu.device(), DEFAULT_FORMATS, FillStyle::PAPER));
                let mut occluder = FillRenderer::new(gpu.device(), &pipelines, &buffers(gpu, &wall));
                occluder.prepare(gpu.device(), gpu.queue(), &view).unwrap();
                let words = ["width=6", interior];
                let mut renderer = lines.renderer(gpu, &mesh, &words, DEFAULT_FORMATS, &buffers(gpu, &mesh));
                renderer.prepare(gpu.device(), gpu.queue(), &view).unwrap();
                let draw = |pass: &mut wgpu::RenderPass<'_>| {
                    occluder.draw(pass);
                    renderer.draw(pass);
                };
                right(&draw_passes(gpu, |e| renderer.encode(e), draw, [128; 2], DEFAULT_FORMATS))
            });
            assert!(inked[0] == 0 && inked[1] > 400, "{lines:?} {interior}: {inked:?} px before and behind");
        }
    }
}

#[test]
fn an_empty_mesh_draws_nothing() {
    let Some(gpu) = gpu_or_skip("an_empty_mesh_draws_nothing") else { return };
    let empty = TriangleMesh::new(vec![Vec3::ONE], vec![]).unwrap();
    let view = view(&torus(), &three_quarter(4.0, 16), DEFAULT_FORMATS);
    for lines in Lines::ALL {
        let image = lines.picture(gpu, &empty, &[], &view);
        assert_eq!(count(&image, |value| value == scene::GROUND_VALUE), 16 * 16, "{lines:?}");
    }
}

#[test]
fn defective_meshes_are_drawn() {
    let Some(gpu) = gpu_or_skip("defective_meshes_are_drawn") else { return };
    for (name, mesh) in zoo::defective().into_iter().chain(zoo::with_boundary()) {
        let Some(bounds) = mesh.bounds().filter(|bounds| bounds.radius > 0.0) else { continue };
        let framing = silhouette_core::view::Framing::Perspective { fov_y_rad: 0.7 };
        let toward = DVec3::new(0.4, 0.3, 1.0);
        let camera = Camera::framing(&bounds, toward, Vec3::Y, framing, [64; 2]).unwrap();
        for lines in [Lines::Filter, Lines::Flood] {
            assert!(ink(&lines.seen(gpu, &mesh, &[], &camera)) > 20, "{lines:?} {name}");
        }
        let hull = Lines::Hull.seen(gpu, &mesh, &[], &camera);
        assert!(count(&hull, |value| value != scene::GROUND_VALUE) > 0, "{name}");
    }
}

#[test]
fn from_inside_a_closed_mesh_a_hull_is_ink_all_over_and_says_so() {
    let Some(gpu) = gpu_or_skip("from_inside_a_closed_mesh_a_hull_is_ink_all_over_and_says_so") else { return };
    let cube = Cuboid::default().mesh().unwrap();
    let camera =
        Camera::new(Vec3::ZERO, Vec3::Z, Vec3::Y, Projection::Perspective { fov_y_rad: 1.0 }, [64; 2]).unwrap();
    let range = silhouette_core::view::ClipRange { near: 0.01, far: 10.0 };
    let view = FrameView::from_camera(&camera, range, DEFAULT_FORMATS.depth_direction).unwrap();
    for lines in Lines::ALL {
        // Lines as wide as 0.1 units are at the depth of a near plane at 0.01 are wider than the picture.
        for words in [&["width=3"][..], &["width=0.1", "width-unit=world"]] {
            let mut renderer = lines.renderer(gpu, &cube, words, DEFAULT_FORMATS, &buffers(gpu, &cube));
            renderer.prepare(gpu.device(), gpu.queue(), &view).unwrap();
            let inked = ink(&scene::draw_with(gpu, &*renderer, [64; 2], DEFAULT_FORMATS));
            if lines == Lines::Hull {
                assert!(inked > 64 * 60 && renderer.warning().is_some_and(|warning| warning.contains("inside")));
            } else {
                assert!(inked == 0 && renderer.warning().is_none(), "{lines:?} {words:?}: {inked}");
            }
        }
    }
}

#[test]
fn a_mesh_just_outside_of_the_view_has_its_line_within() {
    let Some(gpu) = gpu_or_skip("a_mesh_just_outside_of_the_view_has_its_line_within") else { return };
    let (camera, radius_px) = sphere_view(40.0, 0.2, 256);
    let mesh = scene::sphere();
    let whole = view(&mesh, &camera, DEFAULT_FORMATS);
    // The right part of the picture, from 3 px beyond the sphere on.
    let from = (128.0 + radius_px).ceil() as i32 + 3;
    let part = whole.tile([from, 0], [(256 - from) as u32, 256], 1).unwrap();
    let beyond = [(Lines::Flood, "width=8"), (Lines::Filter, "width=16"), (Lines::Hull, "width=8")];
    for (lines, width) in beyond {
        assert!(ink(&lines.picture(gpu, &mesh, &[width], &part)) > 50, "{lines:?}");
        assert_eq!(ink(&lines.picture(gpu, &mesh, &["width=2"], &part)), 0, "{lines:?}: the control");
    }
}

#[test]
fn a_view_larger_than_any_texture_is_refused() {
    let Some(gpu) = gpu_or_skip("a_view_larger_than_any_texture_is_refused") else { return };
    let mesh = torus();
    let side = gpu.device().limits().max_texture_dimension_2d;
    let view = view(&mesh, &three_quarter(4.0, 64), DEFAULT_FORMATS);
    let view = view.with_viewport(Viewport::whole([side, 4])).unwrap();
    for lines in [Lines::Filter, Lines::Flood] {
        let mut renderer = lines.renderer(gpu, &mesh, &[], DEFAULT_FORMATS, &buffers(gpu, &mesh));
        let error = renderer.prepare(gpu.device(), gpu.queue(), &view).unwrap_err();
        assert!(matches!(error, RendererError::TextureTooLarge { .. }), "{lines:?}: {error}");
        let wrong = TargetFormats { depth_direction: DepthDirection::Standard, ..DEFAULT_FORMATS };
        let mut renderer = lines.renderer(gpu, &mesh, &[], wrong, &buffers(gpu, &mesh));
        let error = renderer.prepare(gpu.device(), gpu.queue(), &view).unwrap_err();
        assert!(matches!(error, RendererError::DepthDirection { .. }), "{lines:?}: {error}");
    }
}
