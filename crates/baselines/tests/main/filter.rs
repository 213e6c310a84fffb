//! The filter: what it takes for a line, and how wide it draws it.

use crate::scene::{Lines, camera, ink, is_ink, ring_width_px, sphere, sphere_view, square};
use silhouette_core::glam::{DQuat, DVec3, Vec3};
use silhouette_core::mesh::TriangleMesh;
use silhouette_core::shapes::Cuboid;
use silhouette_render::Image;
use silhouette_testing::edits::{joined, mapped};
use silhouette_testing::gpu_or_skip;

const OPERATORS: [&str; 2] = ["operator=roberts", "operator=sobel"];

#[test]
fn lines_around_spheres_are_as_wide_as_asked_in_every_view() {
    let Some(gpu) = gpu_or_skip("lines_around_spheres_are_as_wide_as_asked_in_every_view") else { return };
    let mesh = sphere();
    // Of one sample per pixel borders are staircases, whose steps lie on either side of the border.
    for (operator, wider_px) in OPERATORS.into_iter().zip([0.7, 1.0]) {
        for (fov_deg, size) in [(10.0, 512), (40.0, 256), (40.0, 512), (40.0, 1024), (90.0, 512), (120.0, 512)] {
            let (camera, radius_px) = sphere_view(fov_deg, 0.35, size);
            let words = [operator, "width=1.5", "width-unit=height-percent"];
            let found = ring_width_px(ink(&Lines::Filter.seen(gpu, &mesh, &words, &camera)) as f64, radius_px, 0.5);
            let asked = 0.015 * f64::from(size);
            assert!(found > asked && found < asked + wider_px, "{operator} {fov_deg} {size}: {found} px of {asked}");
        }
    }
}

/// Ink in the part of a picture between these shares of its width and height.
fn ink_within(image: &Image, [from, to]: [f64; 2]) -> usize {
    let side = |share: f64, of: u32| (share * f64::from(of)) as u32;
    let rows = side(from, image.height)..side(to, image.height);
    let pixels = rows.flat_map(|y| (side(from, image.width)..side(to, image.width)).map(move |x| (x, y)));
    pixels.filter(|&(x, y)| image.pixel(x, y)[0] == 0).count()
}

/// The square, large enough to fill a view however it is turned about y.
fn wall(turn_rad: f64, z: f32) -> TriangleMesh {
    let turn = DQuat::from_rotation_y(turn_rad).as_quat();
    mapped(&square(0.0), |p| turn * (8.0 * p) + Vec3::Z * z)
}

#[test]
fn a_plane_has_no_line_however_slanted() {
    let Some(gpu) = gpu_or_skip("a_plane_has_no_line_however_slanted") else { return };
    for operator in OPERATORS {
        for turn_deg in [0.0_f64, 30.0, 60.0, 75.0] {
            for fov_deg in [20.0, 60.0] {
                let camera = camera(DVec3::Z * 3.0, fov_deg, [128; 2]);
                let wall = wall(turn_deg.to_radians(), 0.0);
                let image = Lines::Filter.seen(gpu, &wall, &[operator, "edges=all", "depth-threshold=0.001"], &camera);
                assert_eq!(ink_within(&image, [0.4, 0.6]), 0, "{operator} {turn_deg} {fov_deg}");
            }
        }
    }
}

#[test]
fn a_step_is_a_line_from_the_threshold_on() {
    let Some(gpu) = gpu_or_skip("a_step_is_a_line_from_the_threshold_on") else { return };
    let camera = camera(DVec3::Z * 6.0, 30.0, [128; 2]);
    // A small square before a large one.
    let step = 0.2;
    let mesh = joined(&[&mapped(&square(step), |p| Vec3::new(0.5 * p.x, 0.5 * p.y, p.z)), &wall(0.0, 0.0)]);
    let radius = mesh.bounds().unwrap().radius;
    for operator in OPERATORS {
        for (share, is_line) in [(0.9, true), (1.1, false)] {
            let threshold = format!("depth-threshold={}", share * f64::from(step) / radius);
            let inked = ink(&Lines::Filter.seen(gpu, &mesh, &[operator, &threshold, "width=2"], &camera));
            // Its outline is 4 times its side, in lines of 2 px.
            let outline_px = 2.0 * 4.0 * camera.pixels_per_unit(6.0 - f64::from(step));
            assert_eq!(inked > 0, is_line, "{operator} {share}: {inked}");
            assert!(!is_line || (inked as f64 / outline_px - 1.0).abs() < 0.1, "{operator}: {inked} of {outline_px}");
        }
    }
}

#[test]
fn creases_are_lines_where_they_are_asked_for_and_sharp_enough() {
    let Some(gpu) = gpu_or_skip("creases_are_lines_where_they_are_asked_for_and_sharp_enough") else { return };
    let cube = Cuboid::default().mesh().unwrap();
    let camera = camera(DVec3::new(1.0, 1.0, 1.0).normalize() * 5.0, 40.0, [128; 2]);
    // A point on an edge towards the nearest corner, in the middle of the picture.
    let edge = cube.positions().iter().map(|p| p.as_dvec3()).fold(DVec3::ZERO, DVec3::max);
    let at = camera.project(DVec3::new(edge.x, edge.y, 0.2 * edge.z)).unwrap().pixel;
    for operator in OPERATORS {
        let drawn = |words: &[&str]| {
            let image = Lines::Filter.seen(gpu, &cube, &[&[operator, "width=3"], words].concat(), &camera);
            is_ink(&image, at.x, at.y)
        };
        assert!(drawn(&["edges=all"]) && !drawn(&["edges=silhouettes"]), "{operator}");
        assert!(drawn(&["edges=all", "normal-threshold=75"]), "{operator}");
        assert!(!drawn(&["edges=all", "normal-threshold=105"]), "{operator}");
    }
}
