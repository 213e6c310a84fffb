//! The picture of a smooth piece. In a perspective it is a rational cubic, which drawing programs do not have: plain cubics take
//! its place, within a tolerance that is proved for each.

use super::SmoothPiece;
use crate::view::{Camera, Projection};
use glam::{DVec2, DVec3, Vec3, Vec3Swizzles as _};

/// Most halvings of a piece. What is then still in doubt touches the plane of the eye, and is left out.
const MAX_HALVINGS: u32 = 24;

/// Binomial coefficients of a cubic.
const BINOMIAL: [f64; 4] = [1.0, 3.0, 3.0, 1.0];

impl SmoothPiece {
    /// Appends control points, in pixels, of cubics that follow the picture of the piece within `tolerance_px`, each beginning
    /// where the one before it ends. What lies behind the eye of a perspective is left out, so that two cubics may not meet
    /// there. One cubic in an orthographic view; in a perspective their number grows by the fourth root of the accuracy.
    pub fn picture(&self, camera: &Camera, tolerance_px: f64, out: &mut Vec<[DVec2; 4]>) {
        let view = camera.view_matrix();
        let middle = DVec2::from(camera.size().map(f64::from)) * 0.5;
        let scale = camera.pixels_per_unit(1.0);
        let homogeneous = |point: Vec3| {
            let point = view.transform_point3(point.as_dvec3());
            let w = match camera.projection() {
                Projection::Perspective { .. } => -point.z,
                Projection::Orthographic { .. } => 1.0,
            };
            (middle * w + DVec2::new(point.x, -point.y) * scale).extend(w)
        };
        fit(self.control.map(homogeneous), tolerance_px, MAX_HALVINGS, out);
    }
}

/// Appends cubics for a rational one, whose control points are given as pixels times weight, and weight.
fn fit(control: [DVec3; 4], tolerance: f64, halvings: u32, out: &mut Vec<[DVec2; 4]>) {
    let least_weight = control.iter().map(|point| point.z).fold(f64::INFINITY, f64::min);
    if least_weight > 0.0 {
        let cubic = osculating(control);
        if halvings == 0 || error(control, cubic, least_weight) <= tolerance {
            out.push(cubic);
            return;
        }
    } else if halvings == 0 || control.iter().all(|point| point.z <= 0.0) {
        return;
    }
    for half in halves(control) {
        fit(half, tolerance, halvings - 1, out);
    }
}

/// The cubic with the same ends and the same derivatives there.
fn osculating([a, b, c, d]: [DVec3; 4]) -> [DVec2; 4] {
    let (from, to) = (a.xy() / a.z, d.xy() / d.z);
    [from, from + (b.xy() - from * b.z) / a.z, to + (c.xy() - to * c.z) / d.z, to]
}

/// A bound for the distance, at equal parameters, of a rational cubic N / w from the osculating cubic H: N - H w is of degree
/// six, and as it has double zeros at both ends, t² (1 - t)² times a quadratic, which its Bezier coefficients bound.
fn error(control: [DVec3; 4], cubic: [DVec2; 4], least_weight: f64) -> f64 {
    let mut sums = [DVec2::ZERO; 7];
    for (i, of_i) in BINOMIAL.into_iter().enumerate() {
        for (j, of_j) in BINOMIAL.into_iter().enumerate() {
            sums[i + j] += of_i * of_j * (control[i].xy() - cubic[i] * control[j].z);
        }
    }
    let quadratic = [sums[2], sums[3] * 0.5, sums[4]];
    // t² (1 - t)² is at most 1 / 16.
    quadratic.iter().map(|point| point.length()).fold(0.0, f64::max) / (16.0 * least_weight)
}

/// De Casteljau's subdivision at the middle.
fn halves([a, b, c, d]: [DVec3; 4]) -> [[DVec3; 4]; 2] {
    let middle = |p: DVec3, q: DVec3| (p + q) * 0.5;
    let (ab, bc, cd) = (middle(a, b), middle(b, c), middle(c, d));
    let (abc, bcd) = (middle(ab, bc), middle(bc, cd));
    let at_middle = middle(abc, bcd);
    [[a, ab, abc, at_middle], [at_middle, bcd, cd, d]]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curves::{CurveKind, CurveSource};
    use crate::id::FaceId;
    use proptest::prelude::*;

    fn piece(control: [Vec3; 4]) -> SmoothPiece {
        SmoothPiece { control, kind: CurveKind::Silhouette, source: CurveSource::Face(FaceId::new(0)) }
    }

    fn camera(distance: f32, projection: Projection) -> Camera {
        Camera::new(Vec3::Z * distance, Vec3::ZERO, Vec3::Y, projection, [800, 600]).unwrap()
    }

    fn at([a, b, c, d]: [DVec2; 4], t: f64) -> DVec2 {
        let s = 1.0 - t;
        a * (s * s * s) + b * (3.0 * s * s * t) + c * (3.0 * s * t * t) + d * (t * t * t)
    }

    fn distance_to_polyline(point: DVec2, polyline: &[DVec2]) -> f64 {
        let to_segment = |pair: &[DVec2]| {
            let along = pair[1] - pair[0];
            let share = ((point - pair[0]).dot(along) / along.length_squared().max(1e-300)).clamp(0.0, 1.0);
            point.distance(pair[0] + share * along)
        };
        polyline.windows(2).map(to_segment).fold(f64::INFINITY, f64::min)
    }

    /// Largest distance of the true picture from the cubics, each of which stands as 400 chords.
    fn distance(piece: &SmoothPiece, camera: &Camera, cubics: &[[DVec2; 4]]) -> f64 {
        let polyline: Vec<DVec2> =
            cubics.iter().flat_map(|&cubic| (0..=400).map(move |i| at(cubic, f64::from(i) / 400.0))).collect();
        let seen = (0..=200).filter_map(|i| camera.project(piece.point(f64::from(i) / 200.0)));
        seen.map(|seen| distance_to_polyline(seen.pixel, &polyline)).fold(0.0, f64::max)
    }

    const CONTROL: [Vec3; 4] =
        [Vec3::new(-1.0, 0.0, 1.0), Vec3::new(-0.5, 1.5, -2.0), Vec3::new(1.0, -1.0, 2.0), Vec3::new(1.0, 0.5, -1.0)];

    #[test]
    fn an_orthographic_view_takes_one_cubic_and_is_exact() {
        let camera = camera(5.0, Projection::Orthographic { height: 3.0 });
        let mut cubics = Vec::new();
        piece(CONTROL).picture(&camera, 1e-9, &mut cubics);
        assert_eq!(cubics.len(), 1);
        for t in [0.0, 0.3, 0.8, 1.0] {
            let seen = camera.project(piece(CONTROL).point(t)).unwrap().pixel;
            assert!(at(cubics[0], t).distance(seen) < 1e-9);
        }
    }

    #[test]
    fn a_perspective_takes_more_by_the_fourth_root_of_the_accuracy() {
        let camera = camera(5.0, Projection::Perspective { fov_y_rad: 0.8 });
        let counts = [1e-1, 1e-5, 1e-9].map(|tolerance| {
            let mut cubics = Vec::new();
            piece(CONTROL).picture(&camera, tolerance, &mut cubics);
            assert!(cubics.windows(2).all(|pair| pair[0][3] == pair[1][0]), "they meet");
            cubics.len()
        });
        assert!(counts[0] > 1 && counts[1] <= 20 * counts[0] && counts[2] <= 20 * counts[1], "{counts:?}");
    }

    #[test]
    fn what_is_behind_the_eye_is_left_out() {
        let camera = camera(0.5, Projection::Perspective { fov_y_rad: 0.8 });
        let mut cubics = Vec::new();
        piece(CONTROL.map(|point| point + Vec3::Z * 9.0)).picture(&camera, 0.05, &mut cubics);
        assert!(cubics.is_empty());
        piece(CONTROL).picture(&camera, 0.05, &mut cubics);
        assert!(!cubics.is_empty() && cubics.len() < 2000 && cubics.iter().flatten().all(|point| point.is_finite()));
    }

    proptest! {
        #[test]
        fn cubics_keep_within_their_tolerance(
            control in prop::array::uniform4(prop::array::uniform3(-1.0..1.0_f32)),
            distance_of_eye in 1.5..9.0_f32,
            tolerance in 1e-2..1.0_f64,
        ) {
            let camera = camera(distance_of_eye, Projection::Perspective { fov_y_rad: 0.8 });
            let piece = piece(control.map(Vec3::from_array));
            let mut cubics = Vec::new();
            piece.picture(&camera, tolerance, &mut cubics);
            prop_assert!(distance(&piece, &camera, &cubics) <= tolerance + 1e-2);
        }
    }
}
