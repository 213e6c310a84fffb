//! Section 3.2, second way of the z-scaled translation: another near or far plane for back faces.
//!
//! With near plane N and far plane F the buffer holds `d = F (z - N) / (z (F - N))`, which falls with N *and* with F. So
//! both planes have to move out to pull back faces; "move the far z plane closer", as printed, pushes them away and draws
//! nothing. Moving the far plane pulls in proportion to z (z - N), not to z.
//!
//! A near plane that moves out clips what lies before it. The renderer gives front faces a near plane that is as much
//! farther in, so that nothing is lost.

use silhouette_core::view::ClipRange;

silhouette_core::option_choice! {
    /// The plane that back faces see elsewhere.
    pub enum MovedPlane {
        /// The near plane.
        Near = "near",
        /// The far plane.
        Far = "far",
    }
}

/// What is left of a range at least.
const LEAST_SHARE: f64 = 0.01;

/// View to clip space for back faces.
#[cfg(feature = "gpu")]
pub(crate) fn projection(
    view: &silhouette_gpu::FrameView,
    plane: MovedPlane,
    factor: f64,
) -> silhouette_core::glam::DMat4 {
    let law = view.depth_law();
    let z = law.z_row(moved(law.range(), plane, factor));
    let mut projection = view.projection();
    (projection.z_axis.z, projection.w_axis.z) = (z.z, z.w);
    projection
}

/// The range that back faces see: the plane's depth times `factor`, the far plane kept beyond the near one. A near plane
/// at or behind the eye, which only orthographic views have, moves by `factor - 1` of the way to the far plane. A far plane that
/// is infinitely far stays there.
pub fn moved(range: ClipRange, plane: MovedPlane, factor: f64) -> ClipRange {
    let ClipRange { near, far } = range;
    if far.is_infinite() {
        return if plane == MovedPlane::Near { ClipRange { near: near * factor, far } } else { range };
    }
    let least = LEAST_SHARE * (far - near);
    match plane {
        MovedPlane::Near if near > 0.0 => ClipRange { near: (near * factor).min(far - least), far },
        MovedPlane::Near => ClipRange { near: near + share(factor) * (far - near), far },
        MovedPlane::Far => ClipRange { near, far: (far + (factor - 1.0) * far.abs()).max(near + least) },
    }
}

/// `range` such that back faces inside of it are not clipped by the plane that is moved.
pub fn widened(range: ClipRange, plane: MovedPlane, factor: f64) -> ClipRange {
    let ClipRange { near, far } = range;
    match plane {
        MovedPlane::Near if factor > 1.0 && near > 0.0 => ClipRange { near: near / factor, far },
        MovedPlane::Near if factor > 1.0 => {
            let share = share(factor);
            ClipRange { near: (near - share * far) / (1.0 - share), far }
        }
        MovedPlane::Far if factor < 1.0 => ClipRange { near, far: far / factor },
        _ => range,
    }
}

/// Share of the range by which an orthographic near plane moves.
fn share(factor: f64) -> f64 {
    (factor - 1.0).min(1.0 - LEAST_SHARE)
}

/// How far a moved plane brings a point at a depth nearer to the viewer in a perspective, in world units; negative where
/// it is pushed away: the depth that stands for the same buffer value in `range` as the point's own in the moved one.
pub fn pull_at(range: ClipRange, plane: MovedPlane, factor: f64, depth: f64) -> f64 {
    let there = moved(range, plane, factor);
    if range.far.is_infinite() {
        return depth * (1.0 - range.near / there.near);
    }
    let value = there.far * (depth - there.near) / (depth * (there.far - there.near));
    let ClipRange { near, far } = range;
    depth - far * near / (far - value * (far - near))
}

#[cfg(test)]
mod tests {
    use super::*;

    const RANGE: ClipRange = ClipRange { near: 1.0, far: 6.0 };

    #[test]
    fn both_planes_pull_when_they_move_out_and_push_when_they_move_in() {
        for depth in [1.5, 2.0, 4.0] {
            assert!(pull_at(RANGE, MovedPlane::Near, 1.05, depth) > 0.0);
            assert!(pull_at(RANGE, MovedPlane::Near, 0.95, depth) < 0.0);
            assert!(pull_at(RANGE, MovedPlane::Far, 1.05, depth) > 0.0);
            assert!(pull_at(RANGE, MovedPlane::Far, 0.95, depth) < 0.0, "the paper's direction");
        }
    }

    #[test]
    fn small_moves_pull_as_the_derivatives_say() {
        let (ClipRange { near, far }, depth, step) = (RANGE, 2.5, 1e-6);
        let by_near = (1.0 - depth / far) * step * depth * far / (far - near);
        assert!((pull_at(RANGE, MovedPlane::Near, 1.0 + step, depth) / by_near - 1.0).abs() < 1e-4);
        let by_far = depth * (depth - near) * (step * far) / (far * (far - near));
        assert!((pull_at(RANGE, MovedPlane::Far, 1.0 + step, depth) / by_far - 1.0).abs() < 1e-4);
    }

    #[test]
    fn an_infinite_far_plane_is_the_limit_of_a_far_one() {
        let [infinite, far] = [f64::INFINITY, 1e9].map(|far| ClipRange { near: 1.0, far });
        for depth in [1.5, 4.0] {
            let [a, b] = [infinite, far].map(|range| pull_at(range, MovedPlane::Near, 1.05, depth));
            assert!((a - b).abs() < 1e-6 && a > 0.0, "{a} {b}");
        }
        assert_eq!(moved(infinite, MovedPlane::Far, 1.5), infinite);
    }

    #[test]
    fn the_widened_range_holds_what_the_moved_plane_would_clip() {
        let wide = widened(RANGE, MovedPlane::Near, 1.25);
        assert!((moved(wide, MovedPlane::Near, 1.25).near - RANGE.near).abs() < 1e-12);
        let wide = widened(RANGE, MovedPlane::Far, 0.5);
        assert!((moved(wide, MovedPlane::Far, 0.5).far - RANGE.far).abs() < 1e-12);
        let behind = ClipRange { near: -1.0, far: 3.0 };
        assert!(moved(widened(behind, MovedPlane::Near, 1.5), MovedPlane::Near, 1.5).near <= behind.near);
    }
}
