//! What the paper's z-scaled variant draws, on whatever adapter there is.

use crate::scene::{self, count, framed, ink, torus};
use silhouette_core::glam::Vec3;
use silhouette_core::mesh::TriangleMesh;
use silhouette_core::shapes::{Cuboid, Sphere};
use silhouette_core::view::{Camera, DepthDirection, Projection};
use silhouette_gpu::TargetFormats;
use silhouette_image_precision::scale;
use silhouette_render::{DEFAULT_FORMATS, Gpu, Image};
use silhouette_testing::gpu_or_skip;

/// The paper's z-scaled variant with these options.
fn draw(gpu: &Gpu, mesh: &TriangleMesh, camera: &Camera, words: &[&str], formats: TargetFormats) -> Image {
    scene::draw(gpu, mesh, camera, &[&["variant=scale"], words].concat(), formats).image
}

#[test]
fn without_scaling_there_is_almost_no_ink() {
    let Some(gpu) = gpu_or_skip("without_scaling_there_is_almost_no_ink") else { return };
    for mesh in [torus(), Sphere::default().icosphere(4).unwrap(), Cuboid::default().mesh().unwrap()] {
        let camera = framed(&mesh, 256);
        let image = draw(gpu, &mesh, &camera, &["scale=1"], DEFAULT_FORMATS);
        assert!(ink(&image) < 10, "{} px", ink(&image));
        assert!(count(&image, |value| value == 255) > 5000, "front faces are white");
    }
}

#[test]
fn ink_grows_as_the_scale_falls() {
    let Some(gpu) = gpu_or_skip("ink_grows_as_the_scale_falls") else { return };
    let mesh = torus();
    let camera = framed(&mesh, 256);
    let drawn = ["scale=1", "scale=0.99", "scale=0.97", "scale=0.95", "scale=0.9"]
        .map(|scale| ink(&draw(gpu, &mesh, &camera, &[scale], DEFAULT_FORMATS)));
    assert!(drawn.windows(2).all(|pair| pair[0] < pair[1]), "{drawn:?}");
}

#[test]
fn the_rim_of_a_sphere_is_as_wide_as_the_law_says() {
    let Some(gpu) = gpu_or_skip("the_rim_of_a_sphere_is_as_wide_as_the_law_says") else { return };
    let mesh = Sphere { radius: 1.0 }.icosphere(6).unwrap();
    let projection = Projection::Orthographic { height: 2.2 };
    let camera = Camera::new(Vec3::Z * 4.0, Vec3::ZERO, Vec3::Y, projection, [1024; 2]).unwrap();
    let px = camera.pixels_per_unit(1.0);
    for scale in [0.95_f64, 0.9, 0.85] {
        let pull = (1.0 - scale) * 4.0;
        // The strip's area in an image: its width times its middle's length.
        let width = scale::rim_width(pull, 1.0);
        let expected = std::f64::consts::TAU * (1.0 - 0.5 * width) * width * px * px;
        let drawn = ink(&draw(gpu, &mesh, &camera, &[&format!("scale={scale}")], DEFAULT_FORMATS)) as f64;
        assert!((drawn / expected - 1.0).abs() < 0.05, "{scale}: {drawn} px of ink, expected {expected:.0}");
    }
}

#[test]
fn scaled_back_faces_cover_the_same_pixels() {
    let Some(gpu) = gpu_or_skip("scaled_back_faces_cover_the_same_pixels") else { return };
    // Seen from outside, a mesh turned inside out has its back faces in front.
    let torus = torus();
    let flipped = torus.triangles().iter().map(|&[a, b, c]| [a, c, b]).collect();
    let flipped = TriangleMesh::new(torus.positions().to_vec(), flipped).unwrap();
    let camera = framed(&torus, 256);
    let unscaled = draw(gpu, &flipped, &camera, &["scale=1"], DEFAULT_FORMATS);
    assert!(ink(&unscaled) > 5000);
    for scale in ["scale=0.99", "scale=0.8", "scale=0.3"] {
        let scaled = draw(gpu, &flipped, &camera, &[scale], DEFAULT_FORMATS);
        let mask = |image: &Image| image.rgba.iter().map(|&value| value == 128).collect::<Vec<_>>();
        assert!(mask(&scaled) == mask(&unscaled), "{scale}");
        assert!(ink(&scaled) >= ink(&unscaled));
    }
}

#[test]
fn every_depth_format_and_direction_draws_the_same_lines() {
    let Some(gpu) = gpu_or_skip("every_depth_format_and_direction_draws_the_same_lines") else { return };
    let mesh = torus();
    let camera = framed(&mesh, 256);
    let expected = ink(&draw(gpu, &mesh, &camera, &["scale=0.95"], DEFAULT_FORMATS)) as f64;
    use wgpu::TextureFormat::{Depth16Unorm, Depth24Plus, Depth32Float};
    for depth in [Depth16Unorm, Depth24Plus, Depth32Float] {
        for depth_direction in [DepthDirection::Standard, DepthDirection::Reversed] {
            for samples in [1, 4] {
                let formats = TargetFormats { depth, depth_direction, samples, ..DEFAULT_FORMATS };
                let image = draw(gpu, &mesh, &camera, &["scale=0.95"], formats);
                let drawn = image.rgba.chunks_exact(4).map(|p| 1.0 - f64::from(p[0]) / 255.0).sum::<f64>();
                let paper = count(&image, |value| value == 128) as f64 * 127.0 / 255.0;
                assert!(((drawn - paper) / expected - 1.0).abs() < 0.05, "{formats:?}: {} {expected}", drawn - paper);
            }
        }
    }
}

#[test]
fn a_plate_bleeds_through_as_soon_as_the_pull_exceeds_its_thickness() {
    let Some(gpu) = gpu_or_skip("a_plate_bleeds_through_as_soon_as_the_pull_exceeds_its_thickness") else { return };
    let plate = Cuboid { size: [2.0, 2.0, 0.02] }.mesh().unwrap();
    let projection = Projection::Perspective { fov_y_rad: 0.3 };
    let camera = Camera::new(Vec3::Z * 4.0, Vec3::ZERO, Vec3::Y, projection, [128; 2]).unwrap();
    // Front at 3.99, back at 4.01: the critical scale is their ratio, 0.995.
    let share = |scale| ink(&draw(gpu, &plate, &camera, &[scale], DEFAULT_FORMATS)) as f64 / (128.0 * 128.0);
    assert!(share("scale=0.996") < 0.01);
    assert!(share("scale=0.994") > 0.99);
}

#[test]
fn an_eye_inside_sees_no_black_unless_asked_to() {
    let Some(gpu) = gpu_or_skip("an_eye_inside_sees_no_black_unless_asked_to") else { return };
    let cube = Cuboid::default().mesh().unwrap();
    let projection = Projection::Perspective { fov_y_rad: 1.0 };
    let camera = Camera::new(Vec3::ZERO, Vec3::Z, Vec3::Y, projection, [64; 2]).unwrap();
    assert_eq!(ink(&draw(gpu, &cube, &camera, &[], DEFAULT_FORMATS)), 0);
    assert_eq!(ink(&draw(gpu, &cube, &camera, &["eye-inside=draw"], DEFAULT_FORMATS)), 64 * 64);
}

#[test]
fn an_empty_mesh_draws_nothing() {
    let Some(gpu) = gpu_or_skip("an_empty_mesh_draws_nothing") else { return };
    let empty = TriangleMesh::new(vec![Vec3::ONE], vec![]).unwrap();
    let camera = framed(&torus(), 16);
    let image = draw(gpu, &empty, &camera, &[], DEFAULT_FORMATS);
    assert_eq!(count(&image, |value| value == 128), 16 * 16);
}
