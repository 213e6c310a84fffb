//! Pictures against the closed form of a ball's outline.

use super::scene::{Ball, ECCENTRIC, PLAIN, Scene, Shot, Stored, outside_px};
use super::{flat, renderer, volume};
use crate::gpu::{Filtering, TextureStyle};
use crate::lookup::AzimuthRule;
use glam::{DMat4, DQuat, DVec3};
use silhouette_core::glam;
use silhouette_core::view::DepthDirection;
use silhouette_gpu::Viewport;
use silhouette_render::{Gpu, Image};
use silhouette_testing::gpu_or_skip;

/// How far from the outline the farthest pixel lies that is on the wrong side of it, in pixels; and how many pixels are drawn.
fn worst_px(picture: &Image, shot: &Shot, ball: &Ball) -> (f64, usize) {
    let view = shot.view();
    let (mut worst, mut drawn) = (0.0_f64, 0);
    for (x, y) in (0..picture.height).flat_map(|y| (0..picture.width).map(move |x| (x, y))) {
        let is_drawn = picture.pixel(x, y)[3] > 0;
        drawn += usize::from(is_drawn);
        let outside = outside_px(&view, ball, x, y);
        if is_drawn != (outside <= 0.0) {
            worst = worst.max(outside.abs());
        }
    }
    (worst, drawn)
}

fn draw(gpu: &Gpu, scene: &Scene, shot: &Shot, style: TextureStyle, filtering: Filtering) -> Image {
    let volume = volume(gpu, &scene.texture(), filtering);
    shot.draw(gpu, &mut [&mut renderer(gpu, shot.formats(), style, &volume)])
}

#[test]
fn the_outline_of_a_ball_is_where_it_should_be() {
    let Some(gpu) = gpu_or_skip("the_outline_of_a_ball_is_where_it_should_be") else { return };
    let turned = DQuat::from_rotation_x(0.6);
    let moved = DVec3::new(0.1, -0.15, 0.05);
    let offset = Viewport { origin_px: [13, 21], ..PLAIN.viewport };
    let standard = DepthDirection::Standard;
    let stretched = DMat4::from_scale_rotation_translation(DVec3::new(1.1, 0.4, 0.9), turned, moved);
    let mirrored = DMat4::from_scale_rotation_translation(DVec3::new(0.8, 0.7, -1.05), turned, moved);
    for (name, shot) in [
        ("perspective", PLAIN),
        ("orthographic", Shot { is_perspective: false, ..PLAIN }),
        ("standard depth", Shot { direction: standard, ..PLAIN }),
        ("stretched", Shot { model: stretched, viewport: offset, ..PLAIN }),
        ("mirrored", Shot { model: mirrored, ..PLAIN }),
        ("mirrored in parallel", Shot { model: mirrored, is_perspective: false, direction: standard, ..PLAIN }),
    ] {
        for (pages, has_texel_centers) in [(1, false), (2, true)] {
            let scene = Scene { pages, has_texel_centers, ..Scene::new(ECCENTRIC, 2).seen_by(&shot) };
            let picture = draw(gpu, &scene, &shot, flat(), Filtering::Native);
            let (worst, drawn) = worst_px(&picture, &shot, &ECCENTRIC);
            assert!(worst < 0.05 && drawn > 1000, "{name}, {pages} pages: {worst} px, {drawn} drawn");
        }
    }
}

#[test]
fn azimuths_as_printed_turn_lobes() {
    let Some(gpu) = gpu_or_skip("azimuths_as_printed_turn_lobes") else { return };
    let scene = Scene { azimuths: 16, ..Scene::new(ECCENTRIC, 2) };
    let [aligned, printed] = [AzimuthRule::Aligned, AzimuthRule::AsPrinted].map(|azimuths| {
        let style = TextureStyle { azimuths, ..flat() };
        worst_px(&draw(gpu, &scene, &PLAIN, style, Filtering::Native), &PLAIN, &ECCENTRIC).0
    });
    assert!(aligned < 0.1 && printed > 10.0 * aligned, "{aligned} {printed}");
}

#[test]
fn a_layer_that_shows_nothing_hides_nothing() {
    let Some(gpu) = gpu_or_skip("a_layer_that_shows_nothing_hides_nothing") else { return };
    // The first is nearer to the eye; its hull covers parts of the second.
    let balls = [
        Ball { center: glam::Vec3::new(0.15, 0.3, 0.5), radius: 0.3 },
        Ball { center: glam::Vec3::new(-0.3, -0.1, -0.2), radius: 0.35 },
    ];
    let pictures = [false, true].map(|reversed| {
        let scene = Scene::many(&balls, 0.5, reversed);
        draw(gpu, &scene, &PLAIN, flat(), Filtering::Native)
    });
    assert_eq!(pictures[0], pictures[1], "in any order of triangles");
    let view = PLAIN.view();
    let (mut behind, mut wrong) = (0, 0);
    for (x, y) in (0..120).flat_map(|y| (0..160).map(move |x| (x, y))) {
        let outside = balls.map(|ball| outside_px(&view, &ball, x, y));
        let is_drawn = pictures[0].pixel(x, y)[3] > 0;
        let hull = Ball { radius: 0.47, ..balls[0] };
        behind += usize::from(outside_px(&view, &hull, x, y) < 0.0 && outside[0] > 0.0 && outside[1] < 0.0);
        wrong +=
            usize::from(is_drawn != (outside[0].min(outside[1]) <= 0.0) && outside.iter().all(|px| px.abs() > 0.5));
    }
    assert!(behind > 100 && wrong == 0, "{behind} behind the first hull, {wrong} wrong");
}

#[test]
fn all_forms_draw_the_same_outline() {
    let Some(gpu) = gpu_or_skip("all_forms_draw_the_same_outline") else { return };
    for stored in [Stored::Unorm8, Stored::Float16, Stored::Terms(5), Stored::Terms(9)] {
        for filtering in [Filtering::Native, Filtering::Float16, Filtering::Manual] {
            let scene = Scene { stored, pages: 2, ..Scene::new(ECCENTRIC, 2) };
            let (worst, _) = worst_px(&draw(gpu, &scene, &PLAIN, flat(), filtering), &PLAIN, &ECCENTRIC);
            assert!(worst < 1.0, "{stored:?} {filtering:?}: {worst}");
        }
    }
}
