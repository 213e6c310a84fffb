//! What is left out of the drawing does not change the picture: triangles of fattened polygons, edges between back faces.

use crate::scene::{count, draw, framed, framed_as, ink, torus};
use silhouette_core::Camera;
use silhouette_core::glam::{Quat, Vec3};
use silhouette_core::mesh::TriangleMesh;
use silhouette_core::shapes::by_name;
use silhouette_core::view::{Framing, Projection};
use silhouette_gpu::TargetFormats;
use silhouette_render::{DEFAULT_FORMATS, Image};
use silhouette_testing::gpu_or_skip;

/// Two tori through each other, a bumpy body, and a torus stretched so that its triangles are skewed.
fn meshes() -> [TriangleMesh; 3] {
    let torus = torus();
    let moved = torus.positions().iter().map(|&p| Quat::from_rotation_x(1.2) * p + Vec3::X * 0.6);
    let second = torus.positions().len() as u32;
    let positions = torus.positions().iter().copied().chain(moved).collect();
    let triangles = torus.triangles().iter().copied();
    let triangles = triangles.clone().chain(triangles.map(|triangle| triangle.map(|vertex| vertex + second)));
    let linked = TriangleMesh::new(positions, triangles.collect()).unwrap();
    let skewed = torus.positions().iter().map(|p| Vec3::new(p.x + 3.0 * p.y, p.y, 0.4 * p.z)).collect();
    let skewed = TriangleMesh::new(skewed, torus.triangles().to_vec()).unwrap();
    [linked, by_name("blob:5672").unwrap(), skewed]
}

/// By how much ink two pictures differ, in pixels, among those that `matters` picks by column and row.
fn differing(first: &Image, second: &Image, matters: impl Fn(usize, usize) -> bool) -> f64 {
    let pairs = first.rgba.chunks_exact(4).zip(second.rgba.chunks_exact(4));
    let mattering = pairs.enumerate().filter(|(index, _)| matters(index % 256, index / 256));
    mattering.map(|(_, (a, b))| f64::from(a[0].abs_diff(b[0])) / 255.0).sum()
}

#[test]
fn convex_polygons_cover_with_fewer_triangles_what_the_fan_covers() {
    let Some(gpu) = gpu_or_skip("convex_polygons_cover_with_fewer_triangles_what_the_fan_covers") else { return };
    // Dashes run along edges and take the fan of all triangles; where no dash may be blank both have the same ink.
    let is_dash = |at: usize| ((at as f32 + 0.5) / 12.0).fract() < 0.6;
    let framings =
        [Framing::Perspective { fov_y_rad: 0.7 }, Framing::Perspective { fov_y_rad: 1.8 }, Framing::Orthographic];
    for (samples, framing) in [1, 4].into_iter().flat_map(|samples| framings.map(|framing| (samples, framing))) {
        let formats = TargetFormats { samples, ..DEFAULT_FORMATS };
        for mesh in meshes() {
            let camera = framed_as(&mesh, framing, 256);
            for clamp in ["fatten-clamp=4", "fatten-clamp=0"] {
                let words = ["variant=fatten", clamp, "width=5"];
                let [solid, dashed] = ["texture=solid", "texture=dashes"].map(|texture| {
                    let words: Vec<&str> = words.into_iter().chain([texture]).collect();
                    draw(gpu, &mesh, &camera, &words, formats).image
                });
                let differing = differing(&solid, &dashed, |x, y| is_dash(x) && is_dash(y));
                assert!(differing * 500.0 < ink(&solid) as f64, "{samples}, {words:?}: {differing} of {}", ink(&solid));
                assert!(ink(&dashed) < ink(&solid) && count(&dashed, |value| value == 0) > 300);
            }
        }
    }
}

/// Fading asks for the depth of every pixel of ink, and charcoal for the facing of every polygon.
#[test]
fn cut_triangles_have_the_ink_of_fans() {
    let Some(gpu) = gpu_or_skip("cut_triangles_have_the_ink_of_fans") else { return };
    // Polygons that meet at an edge have greys of their own, of which the last one drawn shows along it.
    // Both laws push by half an edge, which is all that is allowed, and the printed one draws fans.
    for words in [&["variant=fatten", "depth-fade=1"][..], &["variant=charcoal", "interior=paper"]] {
        for mesh in meshes() {
            let camera = framed(&mesh, 256);
            let [cut, fans] = ["fatten-law=exact", "fatten-law=as-printed"].map(|law| {
                let words: Vec<&str> = words.iter().copied().chain([law, "fatten-clamp=0.5", "width=40"]).collect();
                draw(gpu, &mesh, &camera, &words, DEFAULT_FORMATS).image
            });
            let inked = count(&cut, |value| value != 128 && value != 255);
            let differing = differing(&cut, &fans, |_, _| true);
            assert!(inked > 150 && differing * 20.0 < inked as f64, "{words:?}: {differing} of {inked}");
        }
    }
}

/// Faces whose area is below what 32 bits can tell have no plane to be fattened in.
#[test]
fn faces_too_small_for_a_normal_draw_nothing() {
    let Some(gpu) = gpu_or_skip("faces_too_small_for_a_normal_draw_nothing") else { return };
    let torus = torus();
    // In the torus's hole, turned every way.
    let specks = (0..200).flat_map(|speck| {
        let turn = Quat::from_rotation_y(0.4 * speck as f32) * Quat::from_rotation_x(0.7 * speck as f32);
        [Vec3::ZERO, Vec3::X, Vec3::new(0.3, 1.0, 0.0)].map(|corner| turn * corner * 1e-13)
    });
    let first = torus.positions().len() as u32;
    let positions: Vec<Vec3> = torus.positions().iter().copied().chain(specks).collect();
    let speck = |at: u32| [first + 3 * at, first + 3 * at + 1, first + 3 * at + 2];
    let triangles = torus.triangles().iter().copied().chain((0..200).map(speck));
    let specked = TriangleMesh::new(positions, triangles.collect()).unwrap();
    let projection = Projection::Perspective { fov_y_rad: 0.8 };
    for eye in [Vec3::Y * 4.0, Vec3::Z * 4.0] {
        let camera = Camera::new(eye, Vec3::ZERO, Vec3::new(0.1, 1.0, 1.0), projection, [256, 256]).unwrap();
        for words in [&["variant=fatten"][..], &["variant=fatten", "fatten-clamp=0"], &["variant=charcoal"]] {
            let [found, expected] =
                [&specked, &torus].map(|mesh| draw(gpu, mesh, &camera, words, DEFAULT_FORMATS).image);
            assert!(differing(&found, &expected, |_, _| true) < 1.0, "{words:?} from {eye}");
        }
    }
}

/// A sheet from behind: all of its faces are back faces, whose edges fill three quarters of the table.
#[test]
fn a_large_sheet_from_behind_shows_its_boundary_alone() {
    let Some(gpu) = gpu_or_skip("a_large_sheet_from_behind_shows_its_boundary_alone") else { return };
    const SIDE: u32 = 256;
    let place = |at: u32| at as f32 / SIDE as f32 * 2.0 - 1.0;
    let bend = |x: f32, y: f32| 0.1 * (1.5 * x).sin() * y.cos();
    let rows = (0..=SIDE).flat_map(|y| (0..=SIDE).map(move |x| (place(x), place(y))));
    let positions: Vec<Vec3> = rows.map(|(x, y)| Vec3::new(x, y, bend(x, y))).collect();
    let squares = (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| y * (SIDE + 1) + x));
    let triangles = squares.flat_map(|a| [[a, a + SIDE + 1, a + 1], [a + 1, a + SIDE + 1, a + SIDE + 2]]);
    let mesh = TriangleMesh::new(positions, triangles.collect()).unwrap();
    assert_eq!(mesh.face_count(), 1 << 17);
    let projection = Projection::Perspective { fov_y_rad: 0.8 };
    let camera = Camera::new(Vec3::new(0.0, 0.0, 4.0), Vec3::ZERO, Vec3::Y, projection, [256, 256]).unwrap();
    let image = draw(gpu, &mesh, &camera, &["variant=screen"], DEFAULT_FORMATS).image;
    let is_inked = |x: usize, y: usize| image.rgba[4 * (256 * y + x)] < 128;
    let within = (80..176).flat_map(|y| (80..176).map(move |x| (x, y))).filter(|&(x, y)| is_inked(x, y)).count();
    assert!(within == 0 && ink(&image) > 400, "{within} pixels within, {} in all", ink(&image));
}
