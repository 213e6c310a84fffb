//! Edges, shadings, the whole hull, and instances.

use super::scene::{Ball, ECCENTRIC, PLAIN, Scene, Shot, outside_px};
use super::{flat, renderer, volume};
use crate::gpu::{Drawing, Edge, Filtering, Shading, TexturePipelines, TextureRenderer, TextureStyle};
use crate::{Hull, SilhouetteTexture};
use glam::{DMat4, DVec3};
use silhouette_core::{TriangleMesh, glam};
use silhouette_gpu::{FrameRenderer, RendererError};
use silhouette_render::{Gpu, Load, Target};
use silhouette_testing::gpu_or_skip;
use std::sync::Arc;

/// Root mean square of the error of alpha at pixels within one pixel of the outline.
fn edge_error(gpu: &Gpu, edge: Edge) -> f64 {
    let shot = Shot { samples: 4, ..PLAIN };
    let scene = Scene::new(ECCENTRIC, 2);
    let style = TextureStyle { edge, ..flat() };
    let mut renderer = renderer(gpu, shot.formats(), style, &volume(gpu, &scene.texture(), Filtering::Float16));
    let picture = shot.draw(gpu, &mut [&mut renderer]);
    assert_eq!(renderer.warning(), None);
    let view = shot.view();
    let (mut squares, mut count) = (0.0, 0.0);
    for (x, y) in (0..picture.height).flat_map(|y| (0..picture.width).map(move |x| (x, y))) {
        let outside = outside_px(&view, &ECCENTRIC, x, y);
        if outside.abs() < 1.0 {
            // The share of a pixel that a straight edge leaves, within 0.1 for any direction of the edge.
            let expected = (0.5 - outside).clamp(0.0, 1.0);
            squares += (f64::from(picture.pixel(x, y)[3]) / 255.0 - expected).powi(2);
            count += 1.0;
        }
    }
    (squares / count).sqrt()
}

#[test]
fn soft_edges_cover_parts_of_pixels() {
    let Some(gpu) = gpu_or_skip("soft_edges_cover_parts_of_pixels") else { return };
    let [hard, soft] = [Edge::Hard, Edge::Coverage].map(|edge| edge_error(gpu, edge));
    assert!(soft < 0.12 && hard > 0.2, "{soft} {hard}");
    let volume = volume(gpu, &Scene::new(ECCENTRIC, 1).texture(), Filtering::Float16);
    let style = TextureStyle { edge: Edge::Coverage, ..flat() };
    let single = renderer(gpu, PLAIN.formats(), style, &volume);
    assert!(single.warning().is_some_and(|text| text.contains("4 samples")));
}

#[test]
fn surfaces_are_lit_as_a_ball_is() {
    let Some(gpu) = gpu_or_skip("surfaces_are_lit_as_a_ball_is") else { return };
    let volume = volume(gpu, &Scene::new(ECCENTRIC, 2).texture(), Filtering::Float16);
    let draw = |shading| {
        let style = TextureStyle::new(Drawing::Surface(shading));
        PLAIN.draw(gpu, &mut [&mut renderer(gpu, PLAIN.formats(), style, &volume)])
    };
    let lit = draw(Shading::Lit);
    let brightness = |x: u32, y: u32| u32::from(lit.pixel(x, y)[0]);
    let [upper_left, lower_right] = [brightness(65, 42), brightness(100, 78)];
    assert!(upper_left > lower_right + 60, "{upper_left} {lower_right}");
    // The caller's own stage does the same as the built-in one.
    let own = "@fragment fn custom(in: HullVertex) -> Drawn {
        let samples = carve(in);
        if samples == 0u { discard; }
        return Drawn(for_target(0.5 + 0.5 * normalize(baked_normal(in)), 1.0, surface.is_linear), samples);
    }";
    assert_eq!(draw(Shading::Custom(own.into())), draw(Shading::Normals));
}

#[test]
fn the_whole_hull_covers_more_than_the_object() {
    let Some(gpu) = gpu_or_skip("the_whole_hull_covers_more_than_the_object") else { return };
    let volume = volume(gpu, &Scene::new(ECCENTRIC, 2).texture(), Filtering::Float16);
    let [object, hull] = [Drawing::Surface(Shading::Lit), Drawing::Hull(Shading::Lit)].map(|drawing| {
        PLAIN.draw(gpu, &mut [&mut renderer(gpu, PLAIN.formats(), TextureStyle::new(drawing), &volume)])
    });
    let mut counts = [0; 2];
    for (a, b) in object.rgba.chunks_exact(4).zip(hull.rgba.chunks_exact(4)) {
        assert!(a[3] == 0 || a == b, "the same where the object is");
        counts[0] += u32::from(a[3] > 0);
        counts[1] += u32::from(b[3] > 0);
    }
    assert!(counts[1] > counts[0] * 5 / 4, "{counts:?}");
}

#[test]
fn instances_share_what_is_on_the_device() {
    let Some(gpu) = gpu_or_skip("instances_share_what_is_on_the_device") else { return };
    let volume = volume(gpu, &Scene::new(ECCENTRIC, 1).texture(), Filtering::Native);
    let pipelines = Arc::new(TexturePipelines::new(gpu.device(), PLAIN.formats(), flat(), volume.form()));
    let place =
        |x: f64, scale: f64| DMat4::from_translation(DVec3::new(x, 0.0, 0.0)) * DMat4::from_scale(DVec3::splat(scale));
    let models = [place(-0.6, 0.5), place(0.6, 0.4)];
    let mut renderers: Vec<TextureRenderer> =
        models.iter().map(|_| TextureRenderer::new(gpu.device(), &pipelines, &volume, None).unwrap()).collect();
    let target = Target::new(gpu, PLAIN.viewport.size_px, PLAIN.formats()).unwrap();
    for (renderer, model) in renderers.iter_mut().zip(models) {
        renderer.prepare(gpu.device(), gpu.queue(), &PLAIN.view().with_model(model).unwrap()).unwrap();
    }
    gpu.draw(&target, Load::Clear([0.0; 4]), |pass| renderers.iter().for_each(|renderer| renderer.draw(pass))).unwrap();
    let both = target.read_color(gpu).unwrap();
    let mut each = models.map(|model| {
        let shot = Shot { model, ..PLAIN };
        shot.draw(gpu, &mut [&mut renderer(gpu, PLAIN.formats(), flat(), &volume)]).rgba
    });
    let [first, second] = &mut each;
    first.iter_mut().zip(second).for_each(|(a, b)| *a = (*a).max(*b));
    assert_eq!(both.rgba, *first);
}

#[test]
fn what_does_not_fit_is_refused() {
    let Some(gpu) = gpu_or_skip("what_does_not_fit_is_refused") else { return };
    let scene = Scene::new(ECCENTRIC, 0);
    let texture = scene.texture();
    let native = volume(gpu, &texture, Filtering::Native);
    let manual = volume(gpu, &texture, Filtering::Manual);
    let pipelines = Arc::new(TexturePipelines::new(gpu.device(), PLAIN.formats(), flat(), native.form()));
    let refused = TextureRenderer::new(gpu.device(), &pipelines, &manual, None).err();
    assert_eq!(refused, Some(RendererError::OtherForm { what: "silhouette textures" }));
    let limits = wgpu::Limits { max_texture_dimension_3d: 40, ..gpu.device().limits() };
    let error = super::super::volume::check_sides(&limits, &texture).unwrap_err();
    assert!(matches!(error, RendererError::TextureTooLarge { limit: 40, .. }));
    assert!(error.to_string().ends_with("bake more and smaller pages"), "{error}");
    let samples = texture.parts().size.samples();
    let float = volume(gpu, &texture, Filtering::Float16);
    assert!(native.bytes() == manual.bytes() && float.bytes() >= native.bytes(), "{samples}");
}

#[test]
fn hulls_without_faces_or_pages_draw_nothing() {
    let Some(gpu) = gpu_or_skip("hulls_without_faces_or_pages_draw_nothing") else { return };
    let mut no_pages = Scene::new(ECCENTRIC, 0).texture().into_parts();
    let mut no_faces = no_pages.clone();
    no_pages.places.iter_mut().for_each(|place| place.page = 7);
    let positions = no_faces.hull.mesh().positions().to_vec();
    no_faces.hull = Hull::trusted(TriangleMesh::new(positions, vec![]).unwrap());
    no_faces.places.clear();
    for parts in [no_pages, no_faces] {
        let volume = volume(gpu, &SilhouetteTexture::new(parts).unwrap(), Filtering::Native);
        let picture = PLAIN.draw(gpu, &mut [&mut renderer(gpu, PLAIN.formats(), flat(), &volume)]);
        assert!(picture.rgba.iter().all(|&byte| byte == 0));
    }
}

#[test]
fn near_views_show_the_fine_mesh() {
    let Some(gpu) = gpu_or_skip("near_views_show_the_fine_mesh") else { return };
    let ball = Ball { center: glam::Vec3::ZERO, radius: 0.8 };
    let volume = volume(gpu, &Scene::new(ball, 1).texture(), Filtering::Native);
    let fine = silhouette_testing::builtin("icosphere:3");
    let mesh = Arc::new(silhouette_gpu::MeshBuffers::new(gpu.device(), gpu.queue(), &fine).unwrap());
    let style = TextureStyle::new(Drawing::Surface(Shading::Lit));
    let pipelines = Arc::new(TexturePipelines::new(gpu.device(), PLAIN.formats(), style, volume.form()));
    // A camera's depths for the fine mesh are widened to hold the hull.
    let camera = silhouette_testing::views::three_quarter(&fine, silhouette_testing::views::PERSPECTIVE, [64, 64]);
    let small = camera.clip_range(&silhouette_core::mesh::Bounds { radius: 0.1, ..fine.bounds().unwrap() });
    let mut wide = TextureRenderer::new(gpu.device(), &pipelines, &volume, Some(&mesh)).unwrap();
    for (range, is_near) in [(small, true), (wide.clip_range(&camera, small), false)] {
        let view = silhouette_gpu::FrameView::from_camera(&camera, range, PLAIN.direction).unwrap();
        wide.prepare(gpu.device(), gpu.queue(), &view).unwrap();
        assert_eq!(wide.is_near(), is_near);
    }
    // Towards the eye, until the near plane cuts the hull. The fine mesh is scaled to lie within.
    let toward = DMat4::from_translation(DVec3::new(1.0, 1.7, 2.9) * 0.7);
    for (model, is_near) in [(DMat4::IDENTITY, false), (toward, true)] {
        let shot = Shot { model, ..PLAIN };
        let mut with_mesh = TextureRenderer::new(gpu.device(), &pipelines, &volume, Some(&mesh)).unwrap();
        let mut without = TextureRenderer::new(gpu.device(), &pipelines, &volume, None).unwrap();
        let [whole, holed] = [&mut with_mesh, &mut without].map(|renderer| shot.draw(gpu, &mut [renderer]));
        let drawn =
            |picture: &silhouette_render::Image| picture.rgba.chunks_exact(4).filter(|pixel| pixel[3] > 0).count();
        assert_eq!((with_mesh.is_near(), without.is_near()), (is_near, is_near));
        if is_near {
            assert!(with_mesh.warning().is_some_and(|text| text.contains("fine mesh is drawn")));
            assert!(without.warning().is_some_and(|text| text.contains("holes")));
            assert!(drawn(&whole) > drawn(&holed) + 100, "{} {}", drawn(&whole), drawn(&holed));
        } else {
            assert!(whole == holed && with_mesh.warning().is_none());
        }
    }
}
