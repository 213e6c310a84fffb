//! Curves of smoothed silhouettes.

use glam::{DVec3, Vec3};
use proptest::prelude::*;
use silhouette_core::{Camera, Projection};
use silhouette_smoothing::sampling::{MAX_SEGMENTS, Sampling, segments};
use silhouette_smoothing::{Hermite, SmoothingView};

fn view(distance: f32, fov_y_rad: f64) -> SmoothingView {
    let camera =
        Camera::new(Vec3::Z * distance, Vec3::ZERO, Vec3::Y, Projection::Perspective { fov_y_rad }, [900, 600]);
    SmoothingView::from_camera(&camera.unwrap())
}

proptest! {
    /// Invariant 22: a Hermite curve meets its ends with its tangents, either way round.
    #[test]
    fn a_curve_meets_its_ends_with_its_tangents(points in prop::array::uniform4(prop::array::uniform3(-2.0..2.0_f64))) {
        let [a, b, c, d] = points.map(DVec3::from_array);
        let curve = Hermite { ends: [a, d], tangents: [b, c] };
        for (u, end, tangent) in [(0.0, a, b), (1.0, d, c)] {
            prop_assert!(curve.point(u).distance(end) < 1e-12 && curve.derivative(u).distance(tangent) < 1e-12);
            prop_assert!(curve.reversed().point(1.0 - u).distance(end) < 1e-12);
            prop_assert!(curve.reversed().derivative(1.0 - u).distance(-tangent) < 1e-12);
        }
    }

    /// Invariant 29: no more segments for a larger tolerance, and no fewer in a view that is enlarged.
    #[test]
    fn segments_fall_with_the_tolerance_and_rise_with_the_picture(
        points in prop::array::uniform4(prop::array::uniform3(-0.5..0.5_f64)),
        distance in 2.0..20.0_f32,
        tolerance in 0.05..4.0_f64,
        factor in 1.0..8.0_f64,
    ) {
        let [a, b, c, d] = points.map(DVec3::from_array);
        let curve = Hermite { ends: [a, d], tangents: [b, c] };
        let count = |fov: f64, tolerance| segments(&curve, [DVec3::Z; 2], &view(distance, fov), tolerance, Sampling::Guaranteed);
        let wide = 1.2_f64;
        let narrow = 2.0 * ((wide * 0.5).tan() / factor).atan();
        prop_assert!(count(wide, tolerance * factor) <= count(wide, tolerance));
        prop_assert!(count(narrow, tolerance) >= count(wide, tolerance));
        // Enlarging is what dividing the tolerance does, but for rounding up.
        let [enlarged, finer] = [count(narrow, tolerance), count(wide, tolerance / factor)];
        prop_assert!(enlarged.abs_diff(finer) <= 1, "{} {}", enlarged, finer);
    }
}

/// Neither is constant, so that the property says something.
#[test]
fn numbers_of_segments_vary() {
    let curve = Hermite { ends: [DVec3::NEG_X, DVec3::X], tangents: [DVec3::Y * 2.0, DVec3::NEG_Y * 2.0] };
    let count =
        |distance, tolerance| segments(&curve, [DVec3::Z; 2], &view(distance, 1.0), tolerance, Sampling::Guaranteed);
    assert!(count(4.0, 0.5) > count(4.0, 8.0) && count(4.0, 0.5) > count(40.0, 0.5));
    assert!(count(4.0, 0.5) < MAX_SEGMENTS);
}
