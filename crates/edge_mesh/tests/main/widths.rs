//! Lines are as wide as asked, in any unit, at any size and field of view, and meet at corners.

use crate::scene::{GROUND, PATHS, any_view, count, framed, ink, picture, picture_of};
use silhouette_core::glam::Vec3;
use silhouette_core::shapes::Sphere;
use silhouette_core::view::{Camera, Projection};
use silhouette_core::{TriangleMesh, Viewpoint};
use silhouette_render::{Gpu, Image};
use silhouette_testing::{builtin, gpu_or_skip};
use std::f64::consts::PI;

/// A camera on the z axis that sees a unit sphere as a disc of three quarters of the height.
fn sphere_camera(fov_deg: f64, size: u32) -> Camera {
    let distance = (1.0 + (1.0 / (0.75 * (0.5 * fov_deg.to_radians()).tan())).powi(2)).sqrt();
    let projection = Projection::Perspective { fov_y_rad: fov_deg.to_radians() };
    Camera::new(Vec3::new(0.0, 0.0, distance as f32), Vec3::ZERO, Vec3::Y, projection, [size; 2]).unwrap()
}

/// Width of the ring of ink around the disc that a sphere's faces cover, in pixels.
fn ring_px(gpu: &Gpu, fov_deg: f64, size: u32, words: &[&str]) -> f64 {
    let mesh = Sphere::default().icosphere(5).unwrap();
    let image = picture(gpu, &mesh, &sphere_camera(fov_deg, size), words);
    let paper = count(&image, |value| value == 255) as f64;
    ((paper + ink(&image) as f64) / PI).sqrt() - (paper / PI).sqrt()
}

#[test]
fn relative_widths_are_the_same_at_every_size() {
    let Some(gpu) = gpu_or_skip("relative_widths_are_the_same_at_every_size") else { return };
    for path in PATHS {
        for size in [512, 1024, 4096] {
            let px = ring_px(gpu, 45.0, size, &[path, "width=0.6", "width-unit=height-percent"]);
            let asked = 0.006 * f64::from(size);
            assert!((px / asked - 1.0).abs() < 0.02, "{path}, {size} px: {px}, not {asked}");
        }
    }
}

#[test]
fn widths_are_the_same_at_every_field_of_view() {
    let Some(gpu) = gpu_or_skip("widths_are_the_same_at_every_field_of_view") else { return };
    for path in PATHS {
        for fov_deg in [10.0, 40.0, 80.0, 120.0] {
            for asked in [1.5, 4.0, 12.0] {
                let px = ring_px(gpu, fov_deg, 768, &[path, &format!("width={asked}")]);
                // Counting the pixels of a circle is off by up to 0.05 px.
                let most = f64::max(0.02 * asked, 0.05);
                assert!((px - asked).abs() < most, "{path}, {fov_deg} degrees: {px}, not {asked}");
            }
        }
    }
}

#[test]
fn widths_in_the_world_fall_with_depth_and_those_on_paper_do_not() {
    let Some(gpu) = gpu_or_skip("widths_in_the_world_fall_with_depth_and_those_on_paper_do_not") else { return };
    for path in PATHS {
        for fov_deg in [20.0, 60.0, 100.0] {
            let camera = sphere_camera(fov_deg, 768);
            let Viewpoint::Perspective { eye } = camera.viewpoint() else { panic!("a perspective") };
            let distance = f64::from(eye.z);
            // Where the outline of the sphere is.
            let depth = distance - 1.0 / distance;
            let asked = 0.04 * camera.pixels_per_unit(depth);
            let px = ring_px(gpu, fov_deg, 768, &[path, "width=0.04", "width-unit=world"]);
            assert!((px / asked - 1.0).abs() < 0.02, "{path}, {fov_deg} degrees: {px}, not {asked}");
        }
        let px = ring_px(gpu, 45.0, 768, &[path, "width=1.27", "width-unit=mm", "dpi=100"]);
        assert!((px / 5.0 - 1.0).abs() < 0.02, "{path}: {px}");
    }
}

/// The article's width follows from constants: it is neither the same share of a picture at other fields of view nor what one asks.
#[test]
fn printed_widths_depend_on_the_picture() {
    let Some(gpu) = gpu_or_skip("printed_widths_depend_on_the_picture") else { return };
    let [narrow, wide] = [20.0, 60.0].map(|fov_deg| ring_px(gpu, fov_deg, 1024, &["arithmetic=as-printed", "width=9"]));
    // 0.1 / 75 of the distance to the eye, seen at a focal length of 512 px over the tangent.
    let law = |fov_deg: f64| 512.0 / (0.5 * fov_deg.to_radians()).tan() * 0.1 / 75.0;
    // On a smooth rim the side that moves outwards shows, and the faces hide the other.
    assert!((narrow / law(20.0) - 1.0).abs() < 0.05, "{narrow} {}", law(20.0));
    // The distance to the eye grows towards the border of the picture, and depth does not.
    assert!(wide > 1.1 * law(60.0), "{wide} {}", law(60.0));
    assert!(narrow > 2.5 * wide, "{narrow} {wide}");
}

/// Pixels that a flood from the picture's border reaches over whatever is no ink.
fn flooded(image: &Image) -> Vec<bool> {
    let [width, height] = [image.width, image.height].map(|side| side as usize);
    let is_ink = |at: usize| image.rgba[4 * at] == 0;
    let mut reached = vec![false; width * height];
    let mut open: Vec<usize> = (0..width * height)
        .filter(|at| {
            (at % width == 0 || at / width == 0 || at % width == width - 1 || at / width == height - 1) && !is_ink(*at)
        })
        .collect();
    while let Some(at) = open.pop() {
        if std::mem::replace(&mut reached[at], true) {
            continue;
        }
        let (x, y) = (at % width, at / width);
        let beside = [
            (x > 0, at.wrapping_sub(1)),
            (x + 1 < width, at + 1),
            (y > 0, at.wrapping_sub(width)),
            (y + 1 < height, at + width),
        ];
        open.extend(
            beside
                .into_iter()
                .filter(|&(is_inside, next)| is_inside && !is_ink(next) && !reached[next])
                .map(|(_, next)| next),
        );
    }
    reached
}

/// A box as thin as a sheet.
fn plate() -> TriangleMesh {
    silhouette_testing::edits::mapped(&builtin("cube"), |p| Vec3::new(p.x, 0.01 * p.y, p.z))
}

#[test]
fn outlines_are_closed_at_sharp_corners() {
    let Some(gpu) = gpu_or_skip("outlines_are_closed_at_sharp_corners") else { return };
    for (name, mesh) in [
        ("cube", builtin("cube")),
        ("cone", builtin("cone")),
        ("gear", builtin("gear")),
        ("plate", plate()),
        ("grid", builtin("grid:1,1")),
    ] {
        for direction in silhouette_testing::directions::octants().chain(silhouette_testing::directions::AXES) {
            let camera =
                silhouette_testing::views::framed(&mesh, direction, silhouette_testing::views::PERSPECTIVE, [256; 2]);
            let view = any_view(&mesh, &camera);
            let shown = picture_of(gpu, &mesh, &["width=0", "interior=paper"], &view);
            for path in PATHS {
                for width in ["width=2", "width=5"] {
                    let image = picture_of(gpu, &mesh, &[path, width, "interior=none", "boundaries=all"], &view);
                    let reached = flooded(&image);
                    let leaks = shown
                        .rgba
                        .chunks_exact(4)
                        .zip(&reached)
                        .filter(|(pixel, reached)| pixel[0] == 255 && **reached);
                    assert_eq!(leaks.count(), 0, "{name} from {direction}, {path}, {width}");
                }
            }
        }
    }
    // The control: an outline with a gap leaks.
    let mesh = builtin("cube");
    let mut image = picture(gpu, &mesh, &framed(&mesh, 256), &["width=2", "interior=none"]);
    let gap = (0..256 * 256).find(|at| image.rgba[4 * at] == 0).unwrap();
    for at in [gap - 1, gap, gap + 1].into_iter().flat_map(|at| [at, at + 256, at + 512, at + 768]) {
        image.rgba[4 * at] = 128;
    }
    let inside = 128 * 256 + 128;
    assert!(flooded(&image)[inside] && image.rgba[4 * inside] != 0 && (GROUND[0] - 0.5).abs() < 1e-9);
}
