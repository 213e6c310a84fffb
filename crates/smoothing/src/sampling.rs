//! Section III-E, adaptive sampling: how many straight segments a curve is drawn as, so that they keep within a tolerance in
//! pixels of it.
//!
//! Departures:
//!
//! 1. Eq. 8 with h as the paper defines it, the height of the arc, is too low: the error reaches 4 to 44 times the tolerance.
//!    (With the chord in place of the height it is right for small arcs.) A cubic strays from a chord over an n-th of its
//!    parameter by at most 1 / (8 n²) of its largest second derivative, which is six times the larger second difference of its
//!    control points; this bound is the default ([`Sampling::Guaranteed`]). It holds for curves of any form, S-shaped ones
//!    too, and is at most 9 % above the least number for arcs up to 90 degrees.
//! 2. In a perspective the image of a cubic is a rational curve: second differences are taken in homogeneous pixels, so that a
//!    straight curve has none, and the number grows by the ratio of the farthest to the nearest control point, which is close
//!    to 1 unless the curve comes near the eye.
//! 3. At least one segment, at most [`MAX_SEGMENTS`]; one for a curve that is behind the viewer.

use crate::eye::SmoothingView;
use crate::hermite::Hermite;
use silhouette_core::glam::{DVec3, Vec3Swizzles as _};

/// Most segments of a curve.
pub const MAX_SEGMENTS: u32 = 64;

silhouette_core::option_choice! {
    /// How the number of samples is found.
    pub enum Sampling {
        /// From the second differences of the control points: never too few.
        Guaranteed = "guaranteed",
        /// By Eq. 8 as printed, with the height of the arc.
        AsPrinted = "as-printed",
    }
}

/// Number of segments, 1 to [`MAX_SEGMENTS`], that a curve is drawn as in a view, with a tolerance in pixels above 0. `normals`
/// are the unit normals at its ends, which the printed law reads.
#[inline]
pub fn segments(curve: &Hermite, normals: [DVec3; 2], view: &SmoothingView, tolerance_px: f64, law: Sampling) -> u32 {
    let count = match law {
        Sampling::Guaranteed => guaranteed(curve, view, tolerance_px),
        Sampling::AsPrinted => as_printed(curve, normals, view, tolerance_px),
    };
    // A curve through the plane of the eye has no bound.
    if count.is_nan() {
        return MAX_SEGMENTS;
    }
    // Rounded up, which costs a call on processors that cannot be expected to have an instruction for it.
    let whole = count as u32;
    (whole.saturating_add(u32::from(f64::from(whole) < count))).clamp(1, MAX_SEGMENTS)
}

#[inline]
fn guaranteed(curve: &Hermite, view: &SmoothingView, tolerance_px: f64) -> f64 {
    let ends = [view.homogeneous(curve.ends[0]), view.homogeneous(curve.ends[1])];
    let third = |tangent: DVec3| view.homogeneous_way(tangent * (1.0 / 3.0));
    let (leaving, arriving) = (third(curve.tangents[0]), third(curve.tangents[1]));
    let (b, c) = (ends[0] + leaving, ends[1] - arriving);
    // The third part is w.
    let nearest = ends[0].z.min(b.z).min(c.z).min(ends[1].z);
    let farthest = ends[0].z.max(b.z).max(c.z).max(ends[1].z);
    if farthest <= 0.0 {
        return 1.0;
    }
    if nearest <= 0.0 {
        return f64::NAN;
    }
    // Of a second difference, the part that w has as well moves points along the line of sight.
    let bend_squared =
        |at: DVec3, difference: DVec3| (difference.xy() - difference.z / at.z * at.xy()).length_squared();
    let bend = bend_squared(b, c - b - leaving).max(bend_squared(c, arriving - (c - b))).sqrt();
    (0.75 * bend / (nearest * tolerance_px)).sqrt() * (farthest / nearest)
}

/// Eq. 8, its n read as the number of segments.
fn as_printed(curve: &Hermite, normals: [DVec3; 2], view: &SmoothingView, tolerance_px: f64) -> f64 {
    let [(from, _), (middle, w), (to, _)] = [0.0, 0.5, 1.0].map(|t| view.pixel(curve.point(t)));
    if w <= 0.0 {
        return 1.0;
    }
    let height = middle.distance(0.5 * (from + to));
    let cosine = normals[0].dot(normals[1]).clamp(-1.0, 1.0);
    let sine_of_half = (0.5 * (1.0 - cosine)).sqrt();
    0.5 * (height * sine_of_half / tolerance_px).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bridges::bridge;
    use crate::eye::Eye;
    use proptest::prelude::*;
    use silhouette_core::glam::{DMat4, DVec2, Vec3};
    use silhouette_core::view::{Camera, Projection};

    /// A view along z in which one unit is one pixel.
    fn pixels() -> SmoothingView {
        let to_clip = DMat4::from_scale(DVec3::new(2.0 / 1000.0, 2.0 / 1000.0, 1e-6));
        SmoothingView::new(Eye::new(DVec3::Z.extend(0.0)), to_clip, [1000, 1000])
    }

    fn distance_to_polyline(point: DVec2, polyline: &[DVec2]) -> f64 {
        let to_segment = |pair: &[DVec2]| {
            let (a, along) = (pair[0], pair[1] - pair[0]);
            let share = ((point - a).dot(along) / along.length_squared()).clamp(0.0, 1.0);
            point.distance(a + share * along)
        };
        polyline.windows(2).map(to_segment).fold(f64::INFINITY, f64::min)
    }

    /// Largest distance in pixels of a curve from its polyline of some segments.
    fn error_px(curve: &Hermite, view: &SmoothingView, segments: u32) -> f64 {
        let at = |t: f64| view.pixel(curve.point(t)).0;
        let polyline: Vec<_> = (0..=segments).map(|i| at(f64::from(i) / f64::from(segments))).collect();
        (0..=512).map(|i| distance_to_polyline(at(f64::from(i) / 512.0), &polyline)).fold(0.0, f64::max)
    }

    fn arc(degrees: f64, chord: f64) -> (Hermite, [DVec3; 2]) {
        let half = 0.5 * degrees.to_radians();
        let normals = [-half, half].map(|angle| DVec3::new(angle.sin(), angle.cos(), 0.0));
        let radius = 0.5 * chord / half.sin();
        (bridge(normals.map(|normal| radius * normal), normals), normals)
    }

    #[test]
    fn arcs_of_every_angle_and_size_keep_within_the_tolerance_and_by_the_printed_law_they_do_not() {
        let view = pixels();
        let mut worst = [0.0_f64; 2];
        for degrees in (1..=170).step_by(3) {
            for tolerance in [0.25, 0.5, 1.0, 2.0, 4.0] {
                for chord in [1.0, 7.0, 30.0, 120.0, 400.0] {
                    let (curve, normals) = arc(f64::from(degrees), chord);
                    for (worst, law) in worst.iter_mut().zip([Sampling::Guaranteed, Sampling::AsPrinted]) {
                        let count = segments(&curve, normals, &view, tolerance, law);
                        assert!(count < MAX_SEGMENTS);
                        *worst = worst.max(error_px(&curve, &view, count) / tolerance);
                    }
                }
            }
        }
        assert!(worst[0] <= 1.0 && worst[1] > 4.0, "{worst:?}");
    }

    #[test]
    fn the_bound_is_close_to_the_least_number() {
        let view = pixels();
        for degrees in [10.0, 45.0, 90.0] {
            let (curve, normals) = arc(degrees, 500.0);
            let count = segments(&curve, normals, &view, 0.25, Sampling::Guaranteed);
            let least = (1..).find(|&count| error_px(&curve, &view, count) <= 0.25).unwrap();
            assert!(f64::from(count) <= 1.09 * f64::from(least) + 1.0, "{degrees}: {count}, least {least}");
        }
    }

    #[test]
    fn what_is_behind_the_viewer_or_reaches_there_has_a_bounded_number() {
        let camera =
            Camera::new(Vec3::Z, Vec3::ZERO, Vec3::Y, Projection::Perspective { fov_y_rad: 1.0 }, [512; 2]).unwrap();
        let view = SmoothingView::from_camera(&camera);
        let (curve, normals) = arc(90.0, 1.0);
        let behind = Hermite { ends: curve.ends.map(|end| end + 9.0 * DVec3::Z), ..curve };
        let across = bridge([DVec3::new(0.0, 0.0, 3.0), DVec3::ZERO], normals);
        let counts = [behind, across].map(|curve| segments(&curve, normals, &view, 1.0, Sampling::Guaranteed));
        assert_eq!(counts, [1, MAX_SEGMENTS]);
        assert_eq!(segments(&across, normals, &view, f64::MIN_POSITIVE, Sampling::Guaranteed), MAX_SEGMENTS);
    }

    proptest! {
        #[test]
        fn curves_of_any_form_keep_within_the_tolerance(
            points in prop::array::uniform4(prop::array::uniform3(-0.5..0.5_f64)),
            distance in 2.0..20.0_f32,
            tolerance in 0.25..4.0_f64,
        ) {
            let projection = Projection::Perspective { fov_y_rad: 0.6 };
            let camera = Camera::new(Vec3::Z * distance, Vec3::ZERO, Vec3::Y, projection, [900, 600]).unwrap();
            let view = SmoothingView::from_camera(&camera);
            let [a, b, c, d] = points.map(DVec3::from_array);
            let curve = Hermite { ends: [a, d], tangents: [b, c] };
            let count = segments(&curve, [DVec3::Z; 2], &view, tolerance, Sampling::Guaranteed);
            prop_assume!(count < MAX_SEGMENTS);
            prop_assert!(error_px(&curve, &view, count) <= tolerance);
            prop_assert!(segments(&curve, [DVec3::Z; 2], &view, 2.0 * tolerance, Sampling::Guaranteed) <= count);
        }
    }
}
