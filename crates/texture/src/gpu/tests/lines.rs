//! Widths of lines on balls, whose outlines are circles.

use super::scene::{Ball, PLAIN, Scene, Shot};
use super::{renderer, volume};
use crate::gpu::{Drawing, Edge, Filtering, OutlineStyle, OutlineWidth, TextureStyle};
use silhouette_core::glam::Vec3;
use silhouette_gpu::{Color, Interior, Viewport};
use silhouette_render::{Gpu, Image};
use silhouette_testing::gpu_or_skip;
use std::f64::consts::TAU;

const SECTORS: usize = 24;

fn outlines(width: OutlineWidth, interior: Interior) -> TextureStyle {
    TextureStyle::new(Drawing::Outlines(OutlineStyle { width, ink: Color::BLACK, interior }))
}

/// Shots in which balls about the origin are large circles about the middle.
fn large(is_perspective: bool) -> Shot {
    Shot { is_perspective, viewport: Viewport { origin_px: [0, 0], size_px: [360, 360] }, ..PLAIN }
}

/// A ball in the middle of a unit hull, at a distance of `gap` radii from it.
fn within(gap: f32, level: u32) -> Scene {
    let ball = Ball { center: Vec3::ZERO, radius: 1.0 / (1.0 + gap) };
    Scene::new(ball, level)
}

/// Mean and standard deviation over sectors of the width of what is drawn, in pixels, and of the place of its middle: the share
/// that lies outside of the outline.
fn widths(picture: &Image, shot: &Shot, ball: &Ball) -> [f64; 3] {
    let view = shot.view();
    let middle = 0.5 * f64::from(picture.width);
    let (mut areas, mut radii, mut outside) = ([0.0; SECTORS], vec![], 0.0);
    for (x, y) in (0..picture.height).flat_map(|y| (0..picture.width).map(move |x| (x, y))) {
        let px = super::scene::outside_px(&view, ball, x, y);
        let (dx, dy) = (f64::from(x) + 0.5 - middle, f64::from(y) + 0.5 - middle);
        if px.abs() < 0.1 {
            radii.push(dx.hypot(dy));
        }
        let ink = f64::from(picture.pixel(x, y)[3]) / 255.0;
        if ink > 0.0 {
            let sector = ((dy.atan2(dx) / TAU + 1.0) * SECTORS as f64) as usize % SECTORS;
            areas[sector] += ink;
            outside += if px > 0.0 { ink } else { 0.0 };
        }
    }
    let arc = TAU / SECTORS as f64 * radii.iter().sum::<f64>() / radii.len() as f64;
    let total: f64 = areas.iter().sum();
    let mean = total / SECTORS as f64 / arc;
    let variance = areas.iter().map(|area| (area / arc - mean).powi(2)).sum::<f64>() / SECTORS as f64;
    [mean, variance.sqrt(), outside / total]
}

fn measured(gpu: &Gpu, shot: &Shot, gap: f32, level: u32, width: OutlineWidth) -> [f64; 3] {
    let scene = within(gap, level).seen_by(shot);
    let volume = volume(gpu, &scene.texture(), Filtering::Float16);
    let style = TextureStyle { edge: Edge::Coverage, ..outlines(width, Interior::DepthOnly) };
    let shot = Shot { samples: 4, ..*shot };
    let picture = shot.draw(gpu, &mut [&mut renderer(gpu, shot.formats(), style, &volume)]);
    widths(&picture, &shot, &scene.balls[0])
}

#[test]
fn lines_are_as_wide_as_asked_for_whatever_the_gap() {
    let Some(gpu) = gpu_or_skip("lines_are_as_wide_as_asked_for_whatever_the_gap") else { return };
    let mut printed = vec![];
    for is_perspective in [true, false] {
        for (gap, level) in [(0.02, 3), (0.3, 2)] {
            let of = |width| measured(gpu, &large(is_perspective), gap, level, width);
            let [by_gap, by_gradient] = [OutlineWidth::Gap { px: 3.0 }, OutlineWidth::Gradient { px: 3.0 }].map(of);
            let text = format!("gap {gap}, perspective {is_perspective}: {by_gap:?}, by gradient {by_gradient:?}");
            assert!((by_gap[0] - 3.0).abs() < 0.15 && by_gap[1] < 0.1, "{text}");
            // Wider where pixels straddle sides of facets, of which the finer hull has many.
            assert!((by_gradient[0] - 3.0).abs() < 0.8 && by_gradient[1] < 0.3, "{text}");
            assert!([by_gap, by_gradient].iter().all(|[.., outside]| (0.4..0.65).contains(outside)), "{text}");
            if is_perspective {
                printed.push(of(OutlineWidth::AsPrinted { sigma: 0.03 })[0]);
            }
        }
    }
    assert!(printed[1] > 2.5 * printed[0], "as printed, lines widen with the gap: {printed:?}");
}

#[test]
fn nearer_paper_hides_lines_whatever_the_interior() {
    let Some(gpu) = gpu_or_skip("nearer_paper_hides_lines_whatever_the_interior") else { return };
    // The first is nearer to the eye and covers parts of the second's outline.
    let balls = [
        Ball { center: Vec3::new(0.15, 0.3, 0.5), radius: 0.3 },
        Ball { center: Vec3::new(-0.1, 0.05, -0.2), radius: 0.35 },
    ];
    let width = OutlineWidth::Gap { px: 2.0 };
    let translucent = Color { alpha: 0.5, ..Color::WHITE };
    let inks = [Interior::Paper(Color::WHITE), Interior::Paper(translucent), Interior::DepthOnly].map(|interior| {
        let pictures = [false, true].map(|reversed| {
            let volume = volume(gpu, &Scene::many(&balls, 0.5, reversed).texture(), Filtering::Float16);
            let mut lines = renderer(gpu, PLAIN.formats(), outlines(width, interior), &volume);
            PLAIN.draw(gpu, &mut [&mut lines])
        });
        assert_eq!(pictures[0], pictures[1], "{interior:?}, in any order of triangles");
        let is_ink = |pixel: &[u8]| pixel[3] == 255 && pixel[0] == 0;
        pictures[0].rgba.chunks_exact(4).map(is_ink).collect::<Vec<bool>>()
    });
    assert!(inks[0] == inks[1] && inks[0] == inks[2]);
    let count = inks[0].iter().filter(|&&is_ink| is_ink).count();
    // Over a surface that is drawn before, the same lines without an interior of their own.
    let volume = volume(gpu, &Scene::many(&balls, 0.5, false).texture(), Filtering::Float16);
    let mut surface = renderer(gpu, PLAIN.formats(), super::flat(), &volume);
    let mut alone = renderer(gpu, PLAIN.formats(), outlines(width, Interior::None), &volume);
    let picture = PLAIN.draw(gpu, &mut [&mut surface, &mut alone]);
    let over: Vec<bool> = picture.rgba.chunks_exact(4).map(|pixel| pixel[3] == 255 && pixel[0] == 0).collect();
    assert!(count > 200 && over == inks[0], "{count}");
}
