//! Equation 3 moves as it should: it falls with more texels, azimuths and bits, and rises with each of the paper's mistakes.

use silhouette_core::NoProgress;
use silhouette_core::glam::Vec3;
use silhouette_core::shapes::Torus;
use silhouette_core::{FaceId, TriangleMesh};
use silhouette_testing::{edits, zoo};
use silhouette_texture::lobe::{Meridian, Span};
use silhouette_texture::lookup::AzimuthRule;
use silhouette_texture::sampling_error::{ErrorOptions, SamplingError, places, sampling_error};
use silhouette_texture::{
    AngleFormat, Bake, BakeOptions, CenterRule, Frame, Hull, LobeRule, VisibilityFunction, VisibilityRule, VolumeSize,
};
use std::f32::consts::PI;

const SIZE: VolumeSize = VolumeSize { width: 96, height: 96, azimuths: 32, pages: 1 };

fn scene() -> (TriangleMesh, Hull) {
    let torus = |minor_radius, around, across| Torus { major_radius: 1.0, minor_radius }.mesh(around, across).unwrap();
    (torus(0.3, 48, 24), Hull::trusted(torus(0.45, 12, 8)))
}

fn error_of(options: BakeOptions, azimuths: AzimuthRule) -> SamplingError {
    let (object, hull) = scene();
    let (texture, _) = Bake::new(&object, &hull, options).run(&NoProgress, None).unwrap();
    let visibility = VisibilityFunction::new(&object, &hull, options.rule);
    let measured = ErrorOptions { points: 150, directions: 1000, azimuths };
    sampling_error(&texture, &visibility, &measured, &NoProgress).unwrap()
}

/// Each control by its own default is far above twice the standard error.
fn assert_worse(worse: SamplingError, better: SamplingError, times: f64) {
    assert!(worse.mean > better.mean * times, "{worse:?} {better:?}");
    assert!(worse.mean - better.mean > 2.0 * (worse.standard_error + better.standard_error), "{worse:?} {better:?}");
}

#[test]
fn the_papers_half_texel_and_its_two_centres_cost_what_they_should() {
    let options = BakeOptions { size: SIZE, format: AngleFormat::Float16, ..BakeOptions::default() };
    let aligned = error_of(options, AzimuthRule::Aligned);
    assert!(aligned.mean < 0.01 && aligned.shown > 0.05, "{aligned:?}");
    assert!((aligned.excess + aligned.missing - aligned.mean).abs() < 1e-12);
    assert_worse(error_of(options, AzimuthRule::AsPrinted), aligned, 1.3);
    let mixed = error_of(BakeOptions { centers: CenterRule::AsPrinted, ..options }, AzimuthRule::Aligned);
    assert_worse(mixed, aligned, 2.0);
    let own = error_of(BakeOptions { centers: CenterRule::Texel, ..options }, AzimuthRule::Aligned);
    assert_worse(mixed, own, 2.0);
}

#[test]
fn coarser_textures_are_worse() {
    let options = BakeOptions { size: SIZE, format: AngleFormat::Float16, ..BakeOptions::default() };
    let fine = error_of(options, AzimuthRule::Aligned);
    let with = |size| error_of(BakeOptions { size, ..options }, AzimuthRule::Aligned);
    assert_worse(with(VolumeSize { width: 40, height: 40, ..SIZE }), fine, 1.3);
    assert_worse(with(VolumeSize { azimuths: 6, ..SIZE }), fine, 1.3);
}

/// A sphere within a sphere by equation 1: the error is that of storage alone, and 8 bits cost more than 16.
#[test]
fn bits_cost_what_their_steps_do() {
    let object = zoo::builtin("icosphere:4");
    let hull = Hull::trusted(edits::mapped(&zoo::builtin("icosphere:1"), |point| point * 1.6));
    let measure = |format| {
        let options = BakeOptions { size: SIZE, format, rule: VisibilityRule::Exterior, ..BakeOptions::default() };
        let (texture, report) = Bake::new(&object, &hull, options).run(&NoProgress, None).unwrap();
        assert_eq!(report.hidden_centers, 0);
        let visibility = VisibilityFunction::new(&object, &hull, options.rule);
        let options = ErrorOptions { points: 100, directions: 4000, ..ErrorOptions::default() };
        sampling_error(&texture, &visibility, &options, &NoProgress).unwrap()
    };
    let [byte, half] = [AngleFormat::Unorm8, AngleFormat::Float16].map(measure);
    // A border that is off by e all around a lobe of half-angle a errs on e sin(a) / 2 of the sphere; rounding and bisection are off
    // by at most 1/510 of pi and 1/1024 of pi.
    let most = f64::from(PI / 510.0 + PI / 1024.0) / 2.0;
    assert!(byte.mean < most, "{byte:?}");
    assert_worse(byte, half, 1.2);
}

#[test]
fn points_are_spread_over_the_area() {
    let (_, hull) = scene();
    let mesh = hull.mesh();
    let area = |face: FaceId| {
        let [a, b, c] = mesh.corners(face);
        (b - a).cross(c - a).length()
    };
    let faces = || (0..mesh.face_count()).map(FaceId::from_usize);
    let total: f32 = faces().map(area).sum();
    let places = places(mesh, 20_000);
    assert!(places.iter().all(|place| place.weights.min_element() >= 0.0));
    let mut counts = vec![0.0_f32; mesh.face_count()];
    places.iter().for_each(|place| counts[place.face.index()] += 1.0);
    for face in faces() {
        let expected = 20_000.0 * area(face) / total;
        assert!((counts[face.index()] - expected).abs() < 6.0 + 0.05 * expected);
    }
    let middle: Vec3 = places.iter().map(|place| place.weights).sum::<Vec3>() / 20_000.0;
    assert!((middle - Vec3::splat(1.0 / 3.0)).length() < 0.01, "{middle}");
}

/// Where a meridian leaves a lobe twice, the three rules differ as they say.
#[test]
fn lobe_rules_stand_for_parts() {
    let span = Span { from: 0.0, to: 2.0 };
    let meridian = Meridian::new(true, vec![0.4, 0.9, 1.2]);
    assert_eq!(meridian.parts(span).collect::<Vec<_>>(), [[0.0, 0.4], [0.9, 1.2]]);
    assert!((meridian.angle(span, LobeRule::LastExit) - 1.2).abs() < 1e-6);
    assert!((meridian.angle(span, LobeRule::FirstExit) - 0.4).abs() < 1e-6);
    let area = (1.0 - 0.4_f32.cos()) + (0.9_f32.cos() - 1.2_f32.cos());
    assert!((meridian.angle(span, LobeRule::EqualArea) - (1.0 - area).acos()).abs() < 1e-5);
    for rule in [LobeRule::EqualArea, LobeRule::LastExit, LobeRule::FirstExit] {
        assert_eq!(Meridian::new(false, vec![]).angle(span, rule).to_bits(), 0);
        assert!((Meridian::new(true, vec![]).angle(span, rule) - 2.0).abs() < 1e-5);
        assert!((Meridian::new(true, vec![0.7]).angle(span, rule) - 0.7).abs() < 1e-5);
    }
    assert_eq!(Meridian::new(false, vec![0.5, 0.8]).angle(span, LobeRule::FirstExit).to_bits(), 0);
    // The narrowest parts go where there are too many.
    let many = Meridian::new(true, vec![0.1, 0.3, 0.5, 0.51, 0.8, 0.9, 1.0, 1.4]);
    assert_eq!(many.borders(), [0.1, 0.3, 0.8, 0.9, 1.0, 1.4]);
}

/// The mean direction of a cone about an axis beside the middle lies on the axis.
#[test]
fn moments_point_along_the_axis_of_a_cone() {
    let axis = Vec3::new(0.1, 0.2, 1.0).normalize();
    let frame = Frame::new(Vec3::Z, Vec3::X);
    let (count, half_angle) = (720, 0.8_f32);
    let mut sum = silhouette_core::glam::DVec3::ZERO;
    for index in 0..count {
        let across = frame.direction(index as f32 / count as f32, PI / 2.0);
        let span = Span::new(&frame, across, Vec3::NEG_Z);
        assert!((span.to - PI / 2.0).abs() < 1e-5);
        let inside = |angle: f32| (angle.cos() * Vec3::Z + angle.sin() * across).dot(axis) > half_angle.cos();
        let border = (1..20_000).map(|step| step as f32 / 20_000.0 * PI / 2.0).find(|&angle| !inside(angle)).unwrap();
        sum += Meridian::new(true, vec![border]).moment(span, Vec3::Z, across);
    }
    assert!(sum.normalize().as_vec3().angle_between(axis) < 2e-3, "{sum}");
}
