//! What each variant draws, on whatever adapter there is.

use crate::scene::{self, Drawn, count, draw, framed, ink, sphere_camera, sphere_radius_px, torus};
use silhouette_core::glam::Vec3;
use silhouette_core::mesh::TriangleMesh;
use silhouette_core::shapes::{Cuboid, Sphere};
use silhouette_core::view::{Camera, ClipRange, DepthDirection, Projection};
use silhouette_gpu::{FrameRenderer, TargetFormats};
use silhouette_render::DEFAULT_FORMATS;
use silhouette_testing::gpu_or_skip;
use wgpu::TextureFormat::{Depth16Unorm, Depth24Plus, Depth32Float};

/// Mean width outside of a sphere's outline, and how far the farthest ink is from it, in pixels.
fn beside_the_outline(drawn: &Drawn) -> [f64; 2] {
    let radius = sphere_radius_px();
    let [mut area, mut farthest] = [0.0, 0.0_f64];
    for (index, _) in drawn.image.rgba.chunks_exact(4).enumerate().filter(|(_, pixel)| pixel[0] == 0) {
        let [x, y] = [index % 512, index / 512].map(|at| at as f64 + 0.5 - 256.0);
        area += 1.0;
        farthest = farthest.max(x.hypot(y) - radius);
    }
    [area / (std::f64::consts::TAU * radius), farthest]
}

#[test]
fn equal_depth_draws_next_to_nothing_at_any_precision() {
    let Some(gpu) = gpu_or_skip("equal_depth_draws_next_to_nothing_at_any_precision") else { return };
    for level in [2, 4] {
        let mesh = Sphere::default().icosphere(level).unwrap();
        for depth in [Depth16Unorm, Depth24Plus, Depth32Float] {
            for depth_direction in [DepthDirection::Standard, DepthDirection::Reversed] {
                let formats = TargetFormats { depth, depth_direction, ..DEFAULT_FORMATS };
                let drawn = draw(gpu, &mesh, &sphere_camera(), &["variant=equal"], formats);
                assert!(ink(&drawn.image) < 10, "{formats:?}: {} px", ink(&drawn.image));
            }
        }
    }
}

#[test]
fn the_far_plane_pulls_when_it_moves_out_and_not_when_it_comes_closer() {
    let Some(gpu) = gpu_or_skip("the_far_plane_pulls_when_it_moves_out_and_not_when_it_comes_closer") else { return };
    let inked = |plane: &str, factor: &str| {
        let words = ["variant=depth-range", plane, factor];
        ink(&draw(gpu, &torus(), &framed(&torus(), 256), &words, DEFAULT_FORMATS).image)
    };
    assert!(inked("depth-plane=far", "plane-factor=0.8") < 10, "as printed");
    assert!(inked("depth-plane=far", "plane-factor=1.25") > 300);
    let near = [1.05, 1.3].map(|factor| inked("depth-plane=near", &format!("plane-factor={factor}")));
    assert!(near[0] > 20 && near[1] > 300, "{near:?}");
    assert!(inked("depth-plane=near", "plane-factor=0.95") < 10);
}

#[test]
fn screen_is_as_wide_as_asked_at_every_level_of_detail() {
    let Some(gpu) = gpu_or_skip("screen_is_as_wide_as_asked_at_every_level_of_detail") else { return };
    for level in [2, 3, 4, 5] {
        let mesh = Sphere::default().icosphere(level).unwrap();
        for width in [1.0, 2.0, 5.0] {
            let drawn = draw(gpu, &mesh, &sphere_camera(), &[&format!("width={width}")], DEFAULT_FORMATS);
            let [mean, farthest] = beside_the_outline(&drawn);
            // A coarse sphere's outline is a polygon, a little shorter than the circle.
            assert!((mean / width - 1.0).abs() < 0.06, "level {level}, {width} px: {mean}");
            assert!(farthest < width + 1.0, "level {level}, {width} px: {farthest}");
        }
    }
}

#[test]
fn fattening_in_the_plane_makes_spikes_that_grow_with_detail_and_the_clamp_shortens_them() {
    let name = "fattening_in_the_plane_makes_spikes_that_grow_with_detail_and_the_clamp_shortens_them";
    let Some(gpu) = gpu_or_skip(name) else { return };
    // Asked for 2 px; what an earlier experiment measured on a sphere turned another way.
    let mut means = Vec::new();
    for (level, tabled) in [(2, 2.9), (3, 4.5), (4, 9.6), (5, 19.7)] {
        let mesh = Sphere::default().icosphere(level).unwrap();
        let of = |word: &str| {
            let words = ["variant=fatten", "fatten-law=as-printed", word];
            beside_the_outline(&draw(gpu, &mesh, &sphere_camera(), &words, DEFAULT_FORMATS))
        };
        let [mean, farthest] = of("fatten-clamp=0");
        assert!((mean / tabled - 1.0).abs() < 0.15, "level {level}: {mean} px, {tabled} tabled");
        assert!(farthest > 20.0, "level {level}: {farthest}");
        let [clamped, clamped_farthest] = of("fatten-clamp=1");
        assert!(clamped < mean && clamped_farthest < farthest, "level {level}");
        means.push(mean);
    }
    assert!(means.is_sorted(), "{means:?}");
}

#[test]
fn wireframe_shows_half_of_its_width() {
    let Some(gpu) = gpu_or_skip("wireframe_shows_half_of_its_width") else { return };
    let mesh = Sphere::default().icosphere(4).unwrap();
    let drawn = draw(gpu, &mesh, &sphere_camera(), &["variant=wireframe", "width=8"], DEFAULT_FORMATS);
    let [mean, _] = beside_the_outline(&drawn);
    assert!((mean / 4.0 - 1.0).abs() < 0.1, "{mean}");
}

#[test]
fn polygon_offset_is_half_its_slope_wide_on_a_smooth_rim() {
    let Some(gpu) = gpu_or_skip("polygon_offset_is_as_wide_as_an_earlier_experiment_tells") else { return };
    let mesh = Sphere::default().icosphere(5).unwrap();
    let mean = |slope: &str| {
        let words = ["variant=offset", "offset-constant=0", slope];
        beside_the_outline(&draw(gpu, &mesh, &sphere_camera(), &words, DEFAULT_FORMATS))[0]
    };
    let [one, four] = [mean("offset-slope=1"), mean("offset-slope=4")];
    assert!(one < four && (four / 0.87 - 1.0).abs() < 0.15, "{one} {four}");
}

#[test]
fn a_fixed_pull_magnifies_and_scaling_does_not() {
    let Some(gpu) = gpu_or_skip("a_fixed_pull_magnifies_and_scaling_does_not") else { return };
    let mesh = Sphere::default().icosphere(5).unwrap();
    let farthest = |words: &[&str]| beside_the_outline(&draw(gpu, &mesh, &sphere_camera(), words, DEFAULT_FORMATS))[1];
    // p t / (z - t) at the rim: 218 px from the centre, depth 2.67.
    let pulled = farthest(&["variant=fixed-pull", "pull=0.03"]);
    let law = silhouette_image_precision::fixed_pull::radial_shift_px(sphere_radius_px(), 0.03, 3.0 - 1.0 / 3.0);
    assert!((pulled - law).abs() < 1.0, "{pulled} {law}");
    assert!(farthest(&["variant=scale", "scale=0.99"]) < 0.5);
}

#[test]
fn widths_in_other_units_come_to_their_pixels() {
    let Some(gpu) = gpu_or_skip("widths_in_other_units_come_to_their_pixels") else { return };
    let mesh = Sphere::default().icosphere(4).unwrap();
    // The rim is at depth 3 - 1/3, where a unit covers 618 / 2.667 px.
    let px_per_unit = sphere_camera().pixels_per_unit(3.0 - 1.0 / 3.0);
    let world = format!("width={}", 4.0 / px_per_unit);
    for words in [
        ["width-unit=px", "width=4", "dpi=300"],
        ["width-unit=world", &world, "dpi=300"],
        ["width-unit=mm", "width=1.016", "dpi=100"],
        ["width-unit=height-percent", "width=0.78125", "dpi=300"],
    ] {
        let [mean, _] = beside_the_outline(&draw(gpu, &mesh, &sphere_camera(), &words, DEFAULT_FORMATS));
        assert!((mean / 4.0 - 1.0).abs() < 0.05, "{words:?}: {mean}");
    }
}

#[test]
fn polygons_are_fattened_as_polygons() {
    let Some(gpu) = gpu_or_skip("polygons_are_fattened_as_polygons") else { return };
    let cube = Cuboid::default().mesh().unwrap();
    let camera = framed(&cube, 256);
    let inked = |word: &str| {
        let words = ["variant=fatten", "width=4", "fatten-clamp=0", word];
        ink(&draw(gpu, &cube, &camera, &words, DEFAULT_FORMATS).image) as f64
    };
    let [triangles, quadrilaterals] = [inked("polygons=triangles"), inked("polygons=fans")];
    assert!(quadrilaterals > 1000.0 && (quadrilaterals / triangles - 1.0).abs() < 0.2, "{quadrilaterals} {triangles}");
}

#[test]
fn a_soup_of_turned_triangles_is_drawn_without_orientation() {
    let Some(gpu) = gpu_or_skip("a_soup_of_turned_triangles_is_drawn_without_orientation") else { return };
    let mesh = torus();
    let camera = framed(&mesh, 256);
    let positions = mesh.triangles().iter().flatten().map(|&vertex| mesh.positions()[vertex as usize]).collect();
    let turn = |[a, b, c]: [u32; 3]| if a % 2 == 0 { [a, b, c] } else { [a, c, b] };
    let triangles = (0..mesh.face_count() as u32).map(|face| turn([3 * face, 3 * face + 1, 3 * face + 2]));
    let soup = TriangleMesh::new(positions, triangles.collect()).unwrap();
    let inked = |mesh: &TriangleMesh, words: &[&str]| ink(&draw(gpu, mesh, &camera, words, DEFAULT_FORMATS).image);
    let expected = inked(&mesh, &["variant=scale", "scale=0.95"]) as f64;
    let found = inked(&soup, &["variant=unoriented", "scale=0.95"]) as f64;
    assert!((found / expected - 1.0).abs() < 0.05, "{found} {expected}");
    // With several samples a pixel as well: what one sample sees is marked.
    let smooth = TargetFormats { samples: 4, ..DEFAULT_FORMATS };
    let dark = |words: &[&str], mesh: &TriangleMesh| {
        let image = draw(gpu, mesh, &camera, words, smooth).image;
        image.rgba.chunks_exact(4).filter(|pixel| pixel[0] < 64).count() as f64
    };
    let ratio = dark(&["variant=unoriented", "scale=0.95"], &soup) / dark(&["variant=scale", "scale=0.95"], &mesh);
    assert!((ratio - 1.0).abs() < 0.05, "{ratio}");
    let wide = inked(&soup, &["variant=unoriented", "unoriented-lines=screen", "width=2"]);
    assert!(wide > inked(&mesh, &["width=2"]) * 9 / 10, "{wide}");
    // Oriented variants need the winding.
    assert!(inked(&soup, &["variant=scale", "scale=0.95"]) as f64 > 2.0 * expected);
}

#[test]
fn a_soup_without_shared_vertices_is_drawn_as_its_mesh() {
    let Some(gpu) = gpu_or_skip("a_soup_without_shared_vertices_is_drawn_as_its_mesh") else { return };
    let mesh = torus();
    let positions = mesh.triangles().iter().flatten().map(|&vertex| mesh.positions()[vertex as usize]).collect();
    let triangles = (0..mesh.face_count() as u32).map(|face| [3 * face, 3 * face + 1, 3 * face + 2]).collect();
    let soup = TriangleMesh::new(positions, triangles).unwrap();
    let camera = framed(&mesh, 256);
    let [shared, apart] = [&mesh, &soup].map(|mesh| draw(gpu, mesh, &camera, &[], DEFAULT_FORMATS).image);
    assert!(shared == apart && ink(&shared) > 500);
}

#[test]
fn lines_are_cut_at_the_near_plane() {
    let Some(gpu) = gpu_or_skip("lines_are_cut_at_the_near_plane") else { return };
    // A long box beside the eye, which lies between its ends.
    let bar = Cuboid { size: [0.2, 0.2, 40.0] }.mesh().unwrap();
    let projection = Projection::Perspective { fov_y_rad: 1.2 };
    let camera =
        Camera::new(Vec3::new(0.5, 0.4, 5.0), Vec3::new(0.5, 0.4, 0.0), Vec3::Y, projection, [256; 2]).unwrap();
    let drawn = draw(gpu, &bar, &camera, &["width=3"], DEFAULT_FORMATS).image;
    // Two silhouette edges run from the image's border towards its middle.
    assert!((400..3000).contains(&ink(&drawn)), "{}", ink(&drawn));
}

#[test]
fn polygons_that_run_past_the_eye_are_fattened_no_further_than_their_lines() {
    let Some(gpu) = gpu_or_skip("polygons_that_run_past_the_eye_are_fattened_no_further_than_their_lines") else {
        return;
    };
    // The middles of a long box's edges lie behind the eye; pushed by multiples of such a depth they would cross the picture.
    let bar = Cuboid { size: [0.2, 0.2, 40.0] }.mesh().unwrap();
    let projection = Projection::Perspective { fov_y_rad: 1.2 };
    for (beside, z) in [(0.5, -5.0), (0.15, -10.0)] {
        let eye = Vec3::new(beside, beside, z);
        let camera = Camera::new(eye, eye - Vec3::Z, Vec3::Y, projection, [256; 2]).unwrap();
        for clamp in ["fatten-clamp=4", "fatten-clamp=0"] {
            let inked = |words: &[&str]| ink(&draw(gpu, &bar, &camera, words, DEFAULT_FORMATS).image);
            let [fattened, lines] = [inked(&["variant=fatten", "width=3", clamp]), inked(&["width=3"])];
            assert!((1..lines).contains(&fattened), "{z}, {clamp}: {fattened} {lines}");
        }
    }
}

#[test]
fn extra_edges_textures_and_colours_show() {
    let Some(gpu) = gpu_or_skip("extra_edges_textures_and_colours_show") else { return };
    let cube = Cuboid::default().mesh().unwrap();
    let camera = framed(&cube, 256);
    let image = |words: &[&str]| draw(gpu, &cube, &camera, words, DEFAULT_FORMATS).image;
    let plain = ink(&image(&[]));
    assert!(ink(&image(&["extra-edges=boundary-and-creases"])) > plain + plain / 3);
    for texture in ["texture=dashes", "texture=stipple"] {
        let share = ink(&image(&[texture])) as f64 / plain as f64;
        assert!((0.35..0.8).contains(&share), "{texture}: {share}");
    }
    let red = image(&["ink-red=1"]);
    assert_eq!(red.rgba.chunks_exact(4).filter(|pixel| pixel[..3] == [255, 0, 0]).count(), plain);
    assert!(ink(&image(&["light-thinning=1"])) < plain * 9 / 10);
    assert!(ink(&image(&["clutter-distance=1"])) < plain);
    let faded = image(&["depth-fade=1"]);
    assert!(faded.rgba.chunks_exact(4).any(|pixel| (30..220).contains(&pixel[0]) && pixel[0] != 128));
    for interior in ["interior=lit", "interior=grey", "interior=gooch"] {
        let shades = |pixel: &[u8]| pixel[0] != 0 && pixel[0] != 255 && pixel[0] != 128;
        assert!(image(&[interior]).rgba.chunks_exact(4).filter(|pixel| shades(pixel)).count() > 5000, "{interior}");
    }
}

#[test]
fn charcoal_is_grey_on_both_sides() {
    let Some(gpu) = gpu_or_skip("charcoal_is_grey_on_both_sides") else { return };
    let mesh = Sphere::default().icosphere(4).unwrap();
    let image = draw(gpu, &mesh, &sphere_camera(), &["variant=charcoal", "interior=paper"], DEFAULT_FORMATS).image;
    let greys = count(&image, |value| (20..120).contains(&value));
    let banded = count(&image, |value| (86..120).contains(&value));
    assert!(greys > 1000 && banded > 50, "{greys} {banded}");
}

#[test]
fn a_16_bit_buffer_of_a_wide_range_still_draws_screen_and_warns_of_a_pull() {
    let Some(gpu) = gpu_or_skip("a_16_bit_buffer_of_a_wide_range_still_draws_screen_and_warns_of_a_pull") else {
        return;
    };
    let mesh = torus();
    let camera = framed(&mesh, 256);
    let coarse = TargetFormats { depth: Depth16Unorm, depth_direction: DepthDirection::Standard, ..DEFAULT_FORMATS };
    let range = Some(ClipRange { near: 6e-4, far: 6.0 });
    let within = |words: &[&str], formats| scene::draw_within(gpu, &mesh, &camera, words, formats, range);
    let [fine, rough] = [DEFAULT_FORMATS, coarse].map(|formats| within(&[], formats));
    assert_eq!(rough.warning, None);
    let missing = fine.image.rgba.chunks_exact(4).zip(rough.image.rgba.chunks_exact(4));
    let missing = missing.filter(|(fine, rough)| fine[0] == 0 && rough[0] != 0).count();
    assert!(missing * 50 < ink(&fine.image), "{missing} of {}", ink(&fine.image));
    let pulled = within(&["variant=scale"], coarse);
    assert!(pulled.warning.is_some_and(|warning| warning.contains("variant=screen")));
    assert_eq!(within(&["variant=scale"], DEFAULT_FORMATS).warning, None);
}

#[test]
fn polygon_mode_lines_are_drawn_or_the_feature_is_named() {
    let Some(gpu) = gpu_or_skip("polygon_mode_lines_are_drawn_or_the_feature_is_named") else { return };
    let cube = Cuboid::default().mesh().unwrap();
    let words = ["variant=wireframe", "wireframe-lines=polygon-mode"];
    if gpu.device().features().contains(wgpu::Features::POLYGON_MODE_LINE) {
        assert!(ink(&draw(gpu, &cube, &framed(&cube, 128), &words, DEFAULT_FORMATS).image) > 100);
    } else {
        let error = scene::renderer(gpu, &cube, &words, DEFAULT_FORMATS).unwrap_err();
        assert!(error.to_string().contains("POLYGON_MODE_LINE"), "{error}");
    }
}

#[test]
fn no_variant_fails_on_an_empty_mesh_or_on_one_without_area() {
    let Some(gpu) = gpu_or_skip("no_variant_fails_on_an_empty_mesh_or_on_one_without_area") else { return };
    let empty = TriangleMesh::new(vec![Vec3::ONE], vec![]).unwrap();
    let flat = TriangleMesh::new(vec![Vec3::ZERO, Vec3::X, Vec3::X * 0.5], vec![[0, 1, 2], [0, 0, 1]]).unwrap();
    let camera = framed(&torus(), 32);
    for variant in ["screen", "equal", "wireframe", "fixed-pull", "fatten", "charcoal", "unoriented", "offset"] {
        let word = format!("variant={variant}");
        for lines in ["unoriented-lines=scale", "unoriented-lines=screen"] {
            let words = [&word, lines, "polygons=fans", "extra-edges=boundary-and-creases"];
            let drawn = draw(gpu, &empty, &camera, &words, DEFAULT_FORMATS);
            assert_eq!(count(&drawn.image, |value| value == 128), 32 * 32, "{variant}");
            let _ = draw(gpu, &flat, &camera, &words, DEFAULT_FORMATS);
        }
    }
}

#[test]
fn pictures_are_the_same_every_time() {
    let Some(gpu) = gpu_or_skip("pictures_are_the_same_every_time") else { return };
    let mesh = torus();
    let camera = framed(&mesh, 128);
    for variant in ["variant=screen", "variant=fatten", "variant=charcoal", "variant=unoriented"] {
        let [first, second] = [(); 2].map(|()| draw(gpu, &mesh, &camera, &[variant], DEFAULT_FORMATS).image);
        assert!(first == second, "{variant}");
    }
}

#[test]
fn renderers_follow_the_camera() {
    let Some(gpu) = gpu_or_skip("renderers_follow_the_camera") else { return };
    let mesh = torus();
    let words = ["variant=unoriented", "unoriented-lines=screen"];
    let mut renderer = scene::renderer(gpu, &mesh, &words, DEFAULT_FORMATS).unwrap();
    for size in [64, 128] {
        let camera = framed(&mesh, size);
        let view = scene::view_of(&renderer, &mesh, &camera, DEFAULT_FORMATS, None);
        renderer.prepare(gpu.device(), gpu.queue(), &view).unwrap();
        let again = scene::draw_with(gpu, &renderer, camera.size(), DEFAULT_FORMATS);
        assert!(again == draw(gpu, &mesh, &camera, &words, DEFAULT_FORMATS).image, "{size}");
    }
}
