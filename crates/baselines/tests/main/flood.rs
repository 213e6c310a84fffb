//! Jump flooding: distances beside brute force, neighbours in a group, widths.

use crate::scene::{
    Lines, buffers, camera, count, draw_passes, ink, is_ink, ring_width_px, sphere, sphere_view, three_quarter, torus,
    view,
};
use silhouette_baselines::{JumpFlood, JumpFloodOptions};
use silhouette_core::glam::{DMat4, DVec3};
use silhouette_core::mesh::TriangleMesh;
use silhouette_core::method::{Method, MethodOptions};
use silhouette_core::shapes::{Cuboid, by_name};
use silhouette_core::view::{Camera, ClipRange};
use silhouette_gpu::{DrawsLines, FrameView, RendererError, TargetFormats};
use silhouette_render::{DEFAULT_FORMATS, Gpu, Image};
use silhouette_testing::edits::{joined, moved};
use silhouette_testing::gpu_or_skip;
use silhouette_testing::prepare::prepared;
use std::sync::Arc;

#[test]
fn outlines_are_as_wide_as_asked_in_every_view() {
    let Some(gpu) = gpu_or_skip("outlines_are_as_wide_as_asked_in_every_view") else { return };
    let mesh = sphere();
    for (fov_deg, size) in [(10.0, 512), (40.0, 256), (40.0, 512), (40.0, 1024), (90.0, 512), (120.0, 512)] {
        for width in [0.5, 1.5, 12.0] {
            let (camera, radius_px) = sphere_view(fov_deg, 0.3, size);
            let words = [format!("width={width}"), "width-unit=height-percent".to_owned()];
            let drawn = Lines::Flood.seen(gpu, &mesh, &words.each_ref().map(|word| &**word), &camera);
            let found = ring_width_px(ink(&drawn) as f64, radius_px, 1.0);
            let asked = 0.01 * width * f64::from(size);
            assert!((found - asked).abs() < 0.002 * asked + 0.1, "{fov_deg} {size}: {found} px of {asked}");
        }
    }
}

/// How far each pixel's middle is from the mesh in the image, by brute force over an image of eight times the size; 0 within it, and
/// `None` where the border of the mesh runs by the middle.
fn distances_px(gpu: &Gpu, mesh: &TriangleMesh, camera: &Camera, reach_px: f64) -> Vec<Option<f64>> {
    const SCALE: u32 = 8;
    let [width, height] = camera.size();
    let fine = view(mesh, camera, DEFAULT_FORMATS).tile([0; 2], [width, height], SCALE).unwrap();
    let image = Lines::Flood.picture(gpu, mesh, &["width=0"], &fine);
    let is_mesh = |x: i64, y: i64| image.pixel(x as u32, y as u32)[0] == 255;
    let scale = i64::from(SCALE);
    let (columns, rows) = (scale * i64::from(width), scale * i64::from(height));
    // Texels of the mesh that have a neighbour outside.
    let border: Vec<(i64, i64)> = (1..rows - 1)
        .flat_map(|y| (1..columns - 1).map(move |x| (x, y)))
        .filter(|&(x, y)| {
            is_mesh(x, y) && ![(1, 0), (-1, 0), (0, 1), (0, -1)].iter().all(|(a, b)| is_mesh(x + a, y + b))
        })
        .collect();
    let pixels = (0..i64::from(height)).flat_map(|y| (0..i64::from(width)).map(move |x| (x, y)));
    let distance = |(x, y): (i64, i64)| {
        let middle = [x, y].map(|side| (side as f64 + 0.5) * scale as f64);
        let corners = [(0, 0), (-1, 0), (0, -1), (-1, -1)];
        let within = corners.iter().filter(|(a, b)| is_mesh(middle[0] as i64 + a, middle[1] as i64 + b)).count();
        if within > 0 {
            return if within == 4 { Some(0.0) } else { None };
        }
        let away = |&(x, y): &(i64, i64)| (x as f64 + 0.5 - middle[0]).hypot(y as f64 + 0.5 - middle[1]);
        // The border runs beside its texels' middles, up to an eighth of a pixel and half of that on average.
        let nearest = border.iter().map(away).fold(2.0 * reach_px * scale as f64, f64::min);
        Some((nearest - 0.5) / scale as f64)
    };
    pixels.map(distance).collect()
}

#[test]
fn ink_reaches_as_far_as_brute_force_says() {
    let Some(gpu) = gpu_or_skip("ink_reaches_as_far_as_brute_force_says") else { return };
    for (name, distance) in [("torus", 6.0), ("knot", 6.0), ("cube", 8.0)] {
        let (mesh, camera) = (by_name(name).unwrap(), three_quarter(distance, 96));
        let distances = distances_px(gpu, &mesh, &camera, 40.0);
        for width_px in [1.0, 2.0, 5.5, 13.0, 30.0] {
            let image = Lines::Flood.seen(gpu, &mesh, &[&format!("width={width_px}")], &camera);
            let (mut inked, mut off) = (0, 0);
            for (pixel, distance) in image.rgba.chunks_exact(4).zip(&distances) {
                let Some(distance) = *distance else { continue };
                let is_ink = pixel[0] == 0;
                inked += i32::from(is_ink);
                // How far the pixel is from where it would be right.
                let wrong_px = match is_ink {
                    // Where samples see a nearer part of the mesh than the pixel's middle does.
                    true if distance == 0.0 => 0.5,
                    true => distance - width_px,
                    false => distance.min(width_px - distance),
                };
                // Corners and narrow places are no straight borders, and jump flooding may miss the nearest seed.
                assert!(wrong_px < 0.75, "{name} {width_px}: ink {is_ink} at {distance} px");
                off += i32::from(wrong_px > 0.35);
            }
            assert!(
                off * 50 <= inked,
                "{name} {width_px}: {off} of {inked} px are off by more than a third of a pixel"
            );
            let within = |px: f64| distances.iter().flatten().filter(|&&away| away > 0.0 && away <= px).count() as f64;
            // As many pixels lie within a half of the rim as it is long: lines are off by less than a quarter of a pixel on
            // average: where a corner is fitted by a straight border, its seed lies that much inside.
            let rim_px = within(width_px + 0.5) - within(width_px - 0.5);
            let off_px = (f64::from(inked) - within(width_px)) / rim_px;
            assert!(off_px.abs() < 0.25, "{name} {width_px}: wider by {off_px} px");
        }
    }
}

/// Objects in one field.
fn group(gpu: &Gpu, meshes: &[&TriangleMesh], models: &[DMat4], words: &[&str], camera: &Camera) -> Image {
    let formats = DEFAULT_FORMATS;
    let options = JumpFloodOptions::parse(words.iter().copied()).unwrap();
    let method = JumpFlood::new(&prepared(meshes[0].clone()), options).unwrap();
    let meshes: Vec<_> = meshes.iter().map(|mesh| buffers(gpu, mesh)).collect();
    let pipelines = Arc::new(method.pipelines(gpu.device(), formats).unwrap());
    let mut group = method.group(gpu.device(), gpu.queue(), &pipelines, &meshes).unwrap();
    let range = ClipRange { near: 0.5, far: 50.0 };
    let view = FrameView::from_camera(camera, range, formats.depth_direction).unwrap();
    group.prepare(gpu.device(), gpu.queue(), &view, models).unwrap();
    draw_passes(gpu, |encoder| group.encode(encoder), |pass| group.draw(pass), camera.size(), formats)
}

/// Cubes of side 2 whose middles lie at these places.
fn places(places: [[f64; 3]; 2]) -> [DMat4; 2] {
    places.map(|place| DMat4::from_translation(DVec3::from_array(place)))
}

#[test]
fn the_outline_of_the_nearer_object_lies_over_the_farther_one() {
    let Some(gpu) = gpu_or_skip("the_outline_of_the_nearer_object_lies_over_the_farther_one") else { return };
    let cube = Cuboid { size: [2.0; 3] }.mesh().unwrap();
    let camera = camera(DVec3::Z * 12.0, 30.0, [256; 2]);
    // The left cube covers a part of the right one, whichever comes first.
    let [left, right] = places([[-0.7, 0.0, 2.0], [0.7, 0.0, -2.0]]);
    let edge = camera.project(DVec3::new(0.3, 0.0, 3.0)).unwrap().pixel;
    for models in [[left, right], [right, left]] {
        let image = group(gpu, &[&cube, &cube], &models, &["width=8"], &camera);
        // Over the face of the right cube, right of the left one's edge; nothing to the edge's left.
        for (beside, expected) in [(1.0, true), (4.0, true), (7.0, true), (9.5, false), (-1.5, false), (-4.0, false)] {
            assert_eq!(is_ink(&image, edge.x + beside, edge.y), expected, "{beside} px beside the edge");
        }
        assert_eq!(image.pixel((edge.x + 12.0) as u32, edge.y as u32)[0], 255, "that is the right cube's face");
    }
    // As one object they have one outline.
    let both =
        joined(&[&moved(&cube, left.w_axis.truncate().as_vec3()), &moved(&cube, right.w_axis.truncate().as_vec3())]);
    let image = group(gpu, &[&both], &[DMat4::IDENTITY], &["width=8"], &camera);
    assert!(!is_ink(&image, edge.x + 4.0, edge.y), "the control");
}

#[test]
fn objects_that_touch_keep_a_line_between_them() {
    let Some(gpu) = gpu_or_skip("objects_that_touch_keep_a_line_between_them") else { return };
    let cube = Cuboid { size: [2.0; 3] }.mesh().unwrap();
    // Straight from before, where their faces lie in one plane, and from a side.
    for eye in [DVec3::Z * 12.0, DVec3::new(4.0, 3.0, 11.0)] {
        let camera = camera(eye, 30.0, [256; 2]);
        let image = group(gpu, &[&cube, &cube], &places([[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]]), &["width=6"], &camera);
        for y in [-0.8, -0.3, 0.2, 0.7] {
            let at = camera.project(DVec3::new(0.0, y, 1.0)).unwrap().pixel;
            let inked = (-8..=8).filter(|&beside| is_ink(&image, at.x + f64::from(beside), at.y)).count();
            assert!((5..=8).contains(&inked), "{eye} {y}: {inked} px across the line");
        }
    }
}

#[test]
fn outlines_that_cross_leave_no_gap() {
    let Some(gpu) = gpu_or_skip("outlines_that_cross_leave_no_gap") else { return };
    let (cube, torus) = (Cuboid { size: [2.0; 3] }.mesh().unwrap(), torus());
    let camera = three_quarter(9.0, 256);
    let models =
        [DMat4::from_translation(DVec3::new(0.3, 0.1, 1.5)), DMat4::from_translation(DVec3::new(-0.6, 0.4, -1.5))];
    let image = group(gpu, &[&cube, &torus], &models, &["width=9"], &camera);
    let near = group(gpu, &[&cube, &torus], &models[..1], &["width=9"], &camera);
    // The cube's line is what it is without the torus behind it: objects beyond the end of the models are not drawn.
    let lost =
        image.rgba.chunks_exact(4).zip(near.rgba.chunks_exact(4)).filter(|(both, one)| one[0] == 0 && both[0] != 0);
    assert_eq!(lost.count(), 0, "pixels of the nearer line");
    assert!(ink(&image) > ink(&near) + 1000 && ink(&near) > 2000);
}

#[test]
fn rims_are_blended_where_asked() {
    let Some(gpu) = gpu_or_skip("rims_are_blended_where_asked") else { return };
    let (camera, radius_px) = sphere_view(40.0, 0.3, 256);
    let [sharp, smooth] = ["antialiasing=samples", "antialiasing=coverage"]
        .map(|word| Lines::Flood.seen(gpu, &sphere(), &["width=8", word], &camera));
    let is_grey = |value: u8| !matches!(value, 0 | 128 | 255);
    assert_eq!(count(&sharp, is_grey), 0);
    let rim_px = std::f64::consts::TAU * (radius_px + 8.0);
    assert!(count(&smooth, is_grey) as f64 > 0.8 * rim_px);
    // Ink darkens the ground by what it covers.
    let dark =
        |image: &Image| image.rgba.chunks_exact(4).map(|p| (128.0 - f64::from(p[0].min(128))) / 128.0).sum::<f64>();
    assert!((dark(&smooth) / dark(&sharp) - 1.0).abs() < 0.01);
}

#[test]
fn a_group_has_at_most_as_many_objects_as_it_has_numbers() {
    let Some(gpu) = gpu_or_skip("a_group_has_at_most_as_many_objects_as_it_has_numbers") else { return };
    let mesh = Cuboid::default().mesh().unwrap();
    let method = JumpFlood::new(&prepared(mesh.clone()), JumpFloodOptions::default()).unwrap();
    let formats = TargetFormats { samples: 4, ..DEFAULT_FORMATS };
    let pipelines = Arc::new(method.pipelines(gpu.device(), formats).unwrap());
    let meshes = vec![buffers(gpu, &mesh); 65_536];
    let error = method.group(gpu.device(), gpu.queue(), &pipelines, &meshes).unwrap_err();
    assert_eq!(error, RendererError::TooMany { what: "objects of a group", count: 65_536, limit: 65_535 });
    assert!(method.group(gpu.device(), gpu.queue(), &pipelines, &meshes[..1]).is_ok());
}
