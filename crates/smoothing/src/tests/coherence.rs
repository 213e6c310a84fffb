//! How far silhouettes move in the image from frame to frame: at most twice as far as those of a far finer mesh, and without pops.

use super::shape;
use crate::shading_normals::NormalWeights;
use crate::{SmoothingOptions, SmoothingView};
use silhouette_core::curves::CurveSource;
use silhouette_core::glam::{DQuat, DVec2, DVec3, Vec3};
use silhouette_core::view::{Camera, Projection};
use silhouette_core::{ExtractsCurves, SilhouetteCurves};
use std::collections::HashMap;

/// Straight pieces of each curve.
const STEPS: usize = 8;

/// A silhouette in the image: polylines by the face that they run through.
#[derive(Default)]
struct Traced(HashMap<CurveSource, [DVec2; STEPS + 1]>);

impl Traced {
    fn new(curves: &SilhouetteCurves, view: &SmoothingView) -> Self {
        let at = |i: usize| i as f64 / STEPS as f64;
        let polyline = |piece: &silhouette_core::curves::SmoothPiece| {
            (piece.source, std::array::from_fn(|i| view.pixel(piece.point(at(i))).0))
        };
        Self(curves.pieces().iter().map(polyline).collect())
    }

    /// How far the points of `self` are from `next` at most.
    fn movement(&self, next: &Self) -> f64 {
        let to_polyline = |point: DVec2, line: &[DVec2; STEPS + 1]| {
            let to_segment = |pair: &[DVec2]| {
                let along = pair[1] - pair[0];
                let share = ((point - pair[0]).dot(along) / along.length_squared()).clamp(0.0, 1.0);
                point.distance(pair[0] + if share.is_nan() { 0.0 } else { share } * along)
            };
            line.windows(2).map(to_segment).fold(f64::INFINITY, f64::min)
        };
        let to_next = |source: &CurveSource, point: DVec2| {
            let same_face = next.0.get(source).map_or(f64::INFINITY, |line| to_polyline(point, line));
            // Where the silhouette has left a face, or slid along it, it may be close elsewhere.
            if same_face < 0.05 {
                same_face
            } else {
                next.0.values().map(|line| to_polyline(point, line)).fold(same_face, f64::min)
            }
        };
        self.0
            .iter()
            .flat_map(|(source, line)| line.iter().map(move |&point| to_next(source, point)))
            .fold(0.0, f64::max)
    }
}

/// The movement from frame to frame in pixels, the eye turning by 0.01 degree.
fn movements(name: &str, distance: f64, newton_steps: u32, frames: u32) -> Vec<f64> {
    let mut method =
        shape(name, SmoothingOptions { newton_steps, normals: NormalWeights::Sphere, ..Default::default() });
    let mut curves = SilhouetteCurves::default();
    let mut last = Traced::default();
    let mut moves = Vec::new();
    for frame in 0..frames {
        let turn =
            DQuat::from_axis_angle(DVec3::new(0.3, 1.0, 0.2).normalize(), (f64::from(frame) * 0.01).to_radians());
        let eye = turn * (DVec3::new(0.4, 0.5, 0.8).normalize() * distance);
        let projection = Projection::Perspective { fov_y_rad: 2.4 / distance };
        let camera = Camera::new(eye.as_vec3(), Vec3::ZERO, Vec3::Y, projection, [1024; 2]).unwrap();
        method.extract_curves(&camera.viewpoint(), &mut curves);
        let traced = Traced::new(&curves, &SmoothingView::from_camera(&camera));
        if frame > 0 {
            moves.push(last.movement(&traced).max(traced.movement(&last)));
        }
        last = traced;
    }
    moves
}

fn at_share(moves: &[f64], share: f64) -> f64 {
    let mut sorted = moves.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted[((sorted.len() - 1) as f64 * share).round() as usize]
}

#[test]
fn pops() {
    for (name, fine, d) in [
        ("icosphere:1", "icosphere:4", 1.2),
        ("icosphere:1", "icosphere:4", 2.5),
        ("icosphere:2", "icosphere:4", 1.2),
        ("torus:24,12", "torus:96,48", 2.5),
        ("torus:24,12", "torus:96,48", 5.0),
    ] {
        let frames = 2000;
        let fine = movements(fine, d, 3, 200);
        println!(
            "{name} fine: median {:.3} p99 {:.3} max {:.3}",
            at_share(&fine, 0.5),
            at_share(&fine, 0.99),
            at_share(&fine, 1.0)
        );
        for newton in [0, 3] {
            let m = movements(name, d, newton, frames);
            let over = m.iter().filter(|x| **x > 2.0 * at_share(&fine, 0.5)).count();
            let pops = m.iter().filter(|x| **x > 0.2).count();
            println!(
                "{name} {d} newton {newton}: median {:.3} p99 {:.3} p99.9 {:.3} max {:.3} over {over} pops {pops}",
                at_share(&m, 0.5),
                at_share(&m, 0.99),
                at_share(&m, 0.999),
                at_share(&m, 1.0)
            );
        }
    }
}
