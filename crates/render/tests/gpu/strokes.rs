//! The shape of strokes, against areas and distances in closed form.

use crate::scenes::{PERSPECTIVE, at_pixel, darkness, empty_mesh, framed, ink, pixel_camera, upload};
use glam::{DVec2, DVec3};
use silhouette_core::shapes::Cuboid;
use silhouette_core::view::Camera;
use silhouette_gpu::{Cap, Color, FillStyle, Hidden, Join, Pen, PenPlacement, Polylines, StrokeStyle};
use silhouette_render::{Gpu, Image, ReferencePicture, ReferenceRenderer};
use silhouette_testing::gpu_or_skip;

fn draw(gpu: &Gpu, camera: Camera, lines: &[(Vec<DVec3>, bool)], style: StrokeStyle) -> Image {
    let mut polylines = Polylines::new();
    for (points, closed) in lines {
        polylines.push(points.iter().copied(), *closed);
    }
    let mesh = upload(gpu, &empty_mesh());
    let picture = ReferencePicture {
        mesh: &mesh,
        fill: FillStyle::PAPER,
        lines: &polylines,
        style,
        camera,
        ground: Color::WHITE,
    };
    ReferenceRenderer::new(gpu).unwrap().image(gpu, &picture, 8).unwrap()
}

fn style(width_px: f64, join: Join, cap: Cap) -> StrokeStyle {
    StrokeStyle { pen: Pen { width_px, placement: PenPlacement::Centred }, join, cap, ..StrokeStyle::default() }
}

fn in_pixels(points: &[DVec2]) -> Vec<DVec3> {
    points.iter().copied().map(at_pixel).collect()
}

#[test]
fn lines_are_as_wide_as_asked_at_every_angle() {
    let Some(gpu) = gpu_or_skip("lines_are_as_wide_as_asked_at_every_angle") else { return };
    let middle = DVec2::splat(100.3);
    for degrees in (0..180).step_by(15).chain([7, 83, 91]) {
        let along = DVec2::from_angle(f64::from(degrees).to_radians());
        let line = in_pixels(&[middle - along * 80.0, middle + along * 80.0]);
        for width_px in [0.75, 1.5, 4.2] {
            for placement in [PenPlacement::Centred, PenPlacement::Inside, PenPlacement::Outside] {
                let style = StrokeStyle { pen: Pen { width_px, placement }, cap: Cap::Butt, ..StrokeStyle::default() };
                let image = draw(gpu, pixel_camera([200; 2]), &[(line.clone(), false)], style);
                let drawn = ink(&image) / 160.0;
                // Along the samples' rows and diagonals, sides round to a whole row: an eighth of a pixel.
                let allowed = if degrees % 45 == 0 { 0.125 } else { 0.02 * width_px };
                assert!(
                    (drawn - width_px).abs() <= allowed,
                    "{degrees} degrees, {placement:?}: {drawn}, not {width_px}"
                );
            }
        }
    }
}

#[test]
fn ink_lies_on_the_side_that_the_placement_says() {
    let Some(gpu) = gpu_or_skip("ink_lies_on_the_side_that_the_placement_says") else { return };
    let line = in_pixels(&[DVec2::new(5.0, 20.0), DVec2::new(35.0, 20.0)]);
    let rows = |placement| {
        let style = StrokeStyle { pen: Pen { width_px: 4.0, placement }, ..StrokeStyle::default() };
        let image = draw(gpu, pixel_camera([40; 2]), &[(line.clone(), false)], style);
        (0..40).filter(|&y| image.pixel(20, y)[0] == 0).collect::<Vec<_>>()
    };
    // Drawn from left to right, the left side is up.
    assert_eq!(rows(PenPlacement::Inside), [16, 17, 18, 19]);
    assert_eq!(rows(PenPlacement::Centred), [18, 19, 20, 21]);
    assert_eq!(rows(PenPlacement::Outside), [20, 21, 22, 23]);
}

#[test]
fn joins_and_caps_have_the_area_of_their_shape() {
    let Some(gpu) = gpu_or_skip("joins_and_caps_have_the_area_of_their_shape") else { return };
    let (side, width) = (60.0, 12.0);
    let square = [(20.0, 20.0), (80.0, 20.0), (80.0, 80.0), (20.0, 80.0)].map(|(x, y)| DVec2::new(x, y));
    let corner = 0.25 * width * width;
    let quarter_disc = std::f64::consts::FRAC_PI_4 * corner;
    for reversed in [false, true] {
        let mut points = in_pixels(&square);
        if reversed {
            points.reverse();
        }
        for (join, at_corner) in [
            (Join::Miter { limit: 4.0 }, corner),
            (Join::Miter { limit: 1.2 }, corner * 0.5),
            (Join::Bevel, corner * 0.5),
            (Join::Round, quarter_disc),
        ] {
            let image = draw(gpu, pixel_camera([100; 2]), &[(points.clone(), true)], style(width, join, Cap::Butt));
            let expected = 4.0 * (side * width - corner + at_corner);
            assert!((ink(&image) - expected).abs() < 4.0, "{join:?}: {} px, not {expected}", ink(&image));
        }
    }
    let line = in_pixels(&[DVec2::new(20.0, 30.0), DVec2::new(80.0, 44.0)]);
    let length = DVec2::new(60.0, 14.0).length();
    for (cap, ends) in [(Cap::Butt, 0.0), (Cap::Round, 4.0 * quarter_disc)] {
        let image = draw(gpu, pixel_camera([100; 2]), &[(line.clone(), false)], style(width, Join::Round, cap));
        let expected = length * width + ends;
        assert!((ink(&image) - expected).abs() < 4.0, "{cap:?}: {} px, not {expected}", ink(&image));
    }
}

/// Share of each pixel that is nearer than `radius` to the polyline.
fn covered(points: &[DVec2], closed: bool, radius: f64, size: u32) -> Vec<f64> {
    let steps = if closed { points.len() } else { points.len() - 1 };
    let is_near = |p: DVec2| {
        (0..steps).any(|i| {
            let (a, b) = (points[i], points[(i + 1) % points.len()]);
            let t = ((p - a).dot(b - a) / (b - a).length_squared().max(1e-12)).clamp(0.0, 1.0);
            p.distance_squared(a.lerp(b, t)) <= radius * radius
        })
    };
    let samples = |x: u32, y: u32| {
        let inside = (0..64).filter(|i| {
            let sample = DVec2::new(f64::from(i % 8) + 0.5, f64::from(i / 8) + 0.5) / 8.0;
            is_near(DVec2::new(f64::from(x), f64::from(y)) + sample)
        });
        inside.count() as f64 / 64.0
    };
    (0..size * size).map(|i| samples(i % size, i / size)).collect()
}

#[test]
fn a_round_stroke_is_all_that_is_near_its_line() {
    let Some(gpu) = gpu_or_skip("a_round_stroke_is_all_that_is_near_its_line") else { return };
    let at = |x: f64, y: f64| DVec2::new(x, y);
    let circle = |corners: u32| -> Vec<DVec2> {
        let angle = |i: u32| std::f64::consts::TAU * f64::from(i) / f64::from(corners);
        (0..corners).map(|i| at(32.0, 32.0) + DVec2::from_angle(angle(i)) * 20.3).collect()
    };
    // A fixed walk with turns of every angle, and steps down to a thousandth of a pixel.
    let walk: Vec<DVec2> = (0..40)
        .scan(at(32.0, 32.0), |p, i| {
            let i = f64::from(i);
            *p += DVec2::from_angle(i * i * 0.37) * (0.001 + 6.0 * (i * 1.7).sin().powi(8));
            Some(*p)
        })
        .collect();
    let reversal = vec![at(10.0, 10.0), at(50.0, 30.0), at(10.0, 10.0), at(20.0, 55.0)];
    let spike = vec![at(8.0, 50.0), at(56.0, 32.0), at(8.0, 46.0), at(56.0, 20.0)];
    let shapes = [
        (circle(3), true),
        (circle(7), true),
        (circle(200), true),
        (circle(2000), true),
        (walk.clone(), false),
        (walk, true),
        (reversal, false),
        (spike, false),
    ];
    for (i, (points, closed)) in shapes.into_iter().enumerate() {
        for width in [1.0, 5.0, 11.0] {
            let image = draw(
                gpu,
                pixel_camera([64; 2]),
                &[(in_pixels(&points), closed)],
                style(width, Join::Round, Cap::Round),
            );
            let expected = covered(&points, closed, 0.5 * width, 64);
            let errors: Vec<_> = darkness(&image).zip(&expected).map(|(drawn, near)| (drawn - near).abs()).collect();
            let worst = errors.iter().copied().fold(0.0, f64::max);
            let share = errors.iter().sum::<f64>() / expected.iter().sum::<f64>();
            assert!(worst < 0.15 && share < 0.01, "shape {i}, width {width}: worst {worst}, share {share}");
        }
    }
}

#[test]
fn a_line_past_the_eye_is_not_stretched() {
    let Some(gpu) = gpu_or_skip("a_line_past_the_eye_is_not_stretched") else { return };
    let cube = Cuboid::default().mesh().unwrap();
    let camera = framed(&cube, PERSPECTIVE, [100; 2]);
    let (eye, target) = (camera.eye().as_dvec3(), camera.target().as_dvec3());
    // From the target past the eye, to the right of it by a little: it must leave through one side of the picture.
    let right = (target - eye).cross(DVec3::Y).normalize();
    let beyond = eye + (eye - target) * 3.0 + right * 40.0;
    let image = draw(gpu, camera, &[(vec![target, beyond], false)], style(2.0, Join::Round, Cap::Butt));
    assert!((ink(&image) - 100.0).abs() < 4.0, "half the width, two pixels thick: {}", ink(&image));
    assert!((0..100).all(|y| (0..48).all(|x| image.pixel(x, y)[0] == 255)), "nothing on the other side");
    // Wholly behind the eye, and through the eye itself.
    let behind = draw(gpu, camera, &[(vec![eye + (eye - target), beyond], false)], StrokeStyle::default());
    assert!(ink(&behind) < 1e-9);
    let through = draw(gpu, camera, &[(vec![target, eye, beyond], true)], StrokeStyle::default());
    assert!(ink(&through) < 400.0);
}

#[test]
fn lines_that_are_none_draw_nothing() {
    let Some(gpu) = gpu_or_skip("lines_that_are_none_draw_nothing") else { return };
    let p = at_pixel(DVec2::splat(20.0));
    let lines =
        [(vec![], false), (vec![p], true), (vec![p; 4], true), (vec![p, DVec3::NAN, p], false), (vec![p, p], false)];
    let image =
        draw(gpu, pixel_camera([40; 2]), &lines, StrokeStyle { hidden: Hidden::Drawn, ..StrokeStyle::default() });
    assert!(ink(&image) < 1e-9);
    let line = in_pixels(&[DVec2::new(5.0, 5.0), DVec2::new(35.0, 30.0)]);
    for width_px in [0.0, -3.0, f64::NAN, f64::INFINITY] {
        let image =
            draw(gpu, pixel_camera([40; 2]), &[(line.clone(), false)], style(width_px, Join::Round, Cap::Round));
        assert!(ink(&image) < 1e-9, "width {width_px}");
    }
}
