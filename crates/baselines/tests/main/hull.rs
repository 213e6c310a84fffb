//! Hulls: how wide they are, where they tear, what they leave out.

use crate::scene::{Lines, camera, ink, is_ink, ring_width_px, sphere, sphere_view, square, three_quarter};
use silhouette_core::glam::{DVec2, DVec3, Vec3};
use silhouette_core::mesh::TriangleMesh;
use silhouette_core::shapes::Cuboid;
use silhouette_core::view::Camera;
use silhouette_render::Image;
use silhouette_testing::gpu_or_skip;

#[test]
fn hulls_of_spheres_are_as_wide_as_asked_in_every_view() {
    let Some(gpu) = gpu_or_skip("hulls_of_spheres_are_as_wide_as_asked_in_every_view") else { return };
    let mesh = sphere();
    for (fov_deg, size) in [(10.0, 512), (40.0, 256), (40.0, 512), (40.0, 1024), (90.0, 512), (120.0, 512)] {
        let (camera, radius_px) = sphere_view(fov_deg, 0.35, size);
        for width in [0.5, 1.5] {
            let words = [format!("width={width}"), "width-unit=height-percent".to_owned()];
            let drawn = Lines::Hull.seen(gpu, &mesh, &words.each_ref().map(|word| &**word), &camera);
            let found = ring_width_px(ink(&drawn) as f64, radius_px, 1.0);
            let asked = 0.01 * width * f64::from(size);
            assert!((found - asked).abs() < 0.02 * asked + 0.05, "{fov_deg} {size}: {found} px of {asked}");
        }
    }
}

/// Where the corners of a cube's outline are in a picture, and the directions from its middle.
fn outline_corners(camera: &Camera, cube: &TriangleMesh) -> Vec<(DVec2, DVec2)> {
    let pixel = |p: Vec3| camera.project(p.as_dvec3()).unwrap().pixel;
    let middle = pixel(Vec3::ZERO);
    // From a corner's side, all corners but the nearest and the farthest are on the outline.
    let toward = camera.eye().normalize();
    let mut corners: Vec<Vec3> = cube.positions().to_vec();
    corners.sort_by(|a, b| a.dot(toward).total_cmp(&b.dot(toward)));
    corners[1..7].iter().map(|&corner| (pixel(corner), (pixel(corner) - middle).normalize())).collect()
}

/// How many corners of the outline have ink beyond them, half of the width away.
fn closed_corners(image: &Image, camera: &Camera, cube: &TriangleMesh, width_px: f64) -> usize {
    let corners = outline_corners(camera, cube);
    let beyond = corners.iter().map(|&(at, away)| at + 0.5 * width_px * away);
    beyond.filter(|at| is_ink(image, at.x, at.y)).count()
}

#[test]
fn corners_of_a_cube_close_where_normals_are_welded_and_open_where_they_are_split() {
    let Some(gpu) = gpu_or_skip("corners_of_a_cube_close_where_normals_are_welded_and_open_where_they_are_split")
    else {
        return;
    };
    let cube = Cuboid::default().mesh().unwrap();
    let camera = camera(DVec3::new(1.0, 0.8, 1.2).normalize() * 8.0, 40.0, [256; 2]);
    // Every other corner of the outline belongs to one back face alone, which follows it.
    for (normals, closed) in [("normals=welded", 6), ("normals=split", 3)] {
        let image = Lines::Hull.seen(gpu, &cube, &["width=14", normals], &camera);
        assert_eq!(closed_corners(&image, &camera, &cube, 14.0), closed, "{normals}");
        assert!(ink(&image) > 2000, "{normals}");
    }
}

#[test]
fn a_right_angle_face_on_thins_the_lines_beside_it() {
    let Some(gpu) = gpu_or_skip("a_right_angle_face_on_thins_the_lines_beside_it") else { return };
    // Corners move by the width along the diagonal, and sides by the cosine of half of a right angle of it.
    let plate = Cuboid { size: [2.0, 2.0, 0.02] }.mesh().unwrap();
    let camera = camera(DVec3::Z * 4.0, 40.0, [512; 2]);
    let image = Lines::Hull.seen(gpu, &plate, &["width=20"], &camera);
    let side_px = 2.0 * camera.pixels_per_unit(4.01);
    let beside = ink(&image) as f64 / (4.0 * side_px);
    let expected = 20.0 * std::f64::consts::FRAC_1_SQRT_2;
    // Corners add a twentieth, and the plate hides less than a pixel of the hull, which is the face behind.
    assert!((beside / expected - 1.0).abs() < 0.08, "{beside} px of {expected}");
}

#[test]
fn a_flat_open_mesh_has_no_hull_and_its_back_is_ink() {
    let Some(gpu) = gpu_or_skip("a_flat_open_mesh_has_no_hull_and_its_back_is_ink") else { return };
    let [front, back] = [3.0, -3.0].map(|z| camera(DVec3::Z * z, 50.0, [64; 2]));
    assert_eq!(ink(&Lines::Hull.seen(gpu, &square(0.0), &["width=4"], &front)), 0);
    let side_px = 2.0 * back.pixels_per_unit(3.0);
    let drawn = ink(&Lines::Hull.seen(gpu, &square(0.0), &["width=4"], &back)) as f64;
    // Seen from behind, normals lean towards the middle of the picture, and corners are pushed there.
    assert!((0.7..1.0).contains(&(drawn / (side_px * side_px))), "{drawn}");
    // The others know no sides.
    for lines in [Lines::Filter, Lines::Flood] {
        for camera in [&front, &back] {
            assert!(ink(&lines.seen(gpu, &square(0.0), &["width=4"], camera)) > 400, "{lines:?}");
        }
    }
}

#[test]
fn a_push_in_space_thins_with_distance() {
    let Some(gpu) = gpu_or_skip("a_push_in_space_thins_with_distance") else { return };
    let mesh = sphere();
    let width_at = |distance: f64, words: &[&str]| {
        let camera = three_quarter(distance, 512);
        let radius_px = camera.pixels_per_unit(1.0) / (distance * distance - 1.0).sqrt();
        ring_width_px(ink(&Lines::Hull.seen(gpu, &mesh, words, &camera)) as f64, radius_px, 1.0)
    };
    let world = ["push=world", "width-unit=world", "width=0.1"];
    let [near, far] = [4.0, 8.0].map(|distance| width_at(distance, &world));
    // A sphere of 1.1 times the radius, seen from 4 and from 8 radii.
    let expected = |d: f64| {
        let px = three_quarter(d, 512).pixels_per_unit(1.0);
        px * 1.1 / (d * d - 1.21).sqrt() - px / (d * d - 1.0).sqrt()
    };
    for (found, distance) in [(near, 4.0), (far, 8.0)] {
        assert!((found / expected(distance) - 1.0).abs() < 0.05, "{distance}: {found} of {}", expected(distance));
    }
    let [near, far] = [4.0, 8.0].map(|distance| width_at(distance, &["width=8"]));
    assert!((near / far - 1.0).abs() < 0.03, "the control keeps its width: {near} {far}");
}
