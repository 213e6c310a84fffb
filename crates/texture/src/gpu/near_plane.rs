//! [`meets_hull`]: whether a view begins inside the hull, so that its front faces do not cover the object.

use crate::hull::winding_number::winding_number;
use glam::{DVec2, DVec3, DVec4, Vec4Swizzles};
use silhouette_core::mesh::Bounds;
use silhouette_core::{TriangleMesh, glam};
use silhouette_gpu::FrameView;
use silhouette_rays::MeshHierarchy;

/// Whether the near window, the part of the near plane that the viewport shows, meets the solid hull.
///
/// Where it does not, each ray of the view begins outside of the hull and enters it through a front face beyond the near plane,
/// wherever the eye is. An open hull counts as met where it is not known to be clear. O(1) for views whose near plane is clear of the bounds, O(F) for others; allocates nothing.
pub(super) fn meets_hull(hull: &TriangleMesh, hierarchy: &MeshHierarchy, bounds: &Bounds, view: &FrameView) -> bool {
    let near = view.depth_law().range().near;
    // The largest scale is known to a fraction of a percent.
    if view.depth(bounds.center) - 1.01 * bounds.radius * view.largest_scale() > near {
        return false;
    }
    let to_clip = view.object_to_clip();
    // Above 0 beyond the near plane.
    let corners = |triangle: &[u32; 3]| triangle.map(|vertex| hull.positions()[vertex as usize].as_dvec3());
    let beyond = |point: DVec3| view.depth(point) - near;
    let crosses = |triangle: &[u32; 3]| {
        let corners = corners(triangle);
        let depths = corners.map(beyond);
        let mut ends = [DVec2::ZERO; 2];
        let mut count = 0;
        for (i, j) in [(0, 1), (1, 2), (2, 0)] {
            if (depths[i] > 0.0) != (depths[j] > 0.0) {
                let at = corners[i].lerp(corners[j], depths[i] / (depths[i] - depths[j]));
                let clip: DVec4 = to_clip * at.extend(1.0);
                ends[count] = clip.xy() / clip.w;
                count += 1;
            }
        }
        count == 2 && meets_window(ends)
    };
    hull.triangles().iter().any(crosses) || {
        // No face crosses the window, so that one point of it stands for all.
        let clip_z = view.depth_law().value_at(near);
        let middle = to_clip.inverse().project_point3(DVec3::new(0.0, 0.0, clip_z));
        winding_number(hull, hierarchy, middle.as_vec3(), |_| true) != Some(0)
    }
}

/// Whether a segment meets the square from -1 to 1.
fn meets_window([from, to]: [DVec2; 2]) -> bool {
    let way = to - from;
    let mut span = [0.0_f64, 1.0];
    for axis in 0..2 {
        if way[axis] == 0.0 {
            if from[axis].abs() > 1.0 {
                return false;
            }
            continue;
        }
        let [a, b] = [-1.0, 1.0].map(|side| (side - from[axis]) / way[axis]);
        span = [span[0].max(a.min(b)), span[1].min(a.max(b))];
    }
    span[0] <= span[1]
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{DMat4, Vec3};
    use silhouette_core::view::{Camera, ClipRange, DepthDirection, Projection};
    use silhouette_testing::builtin;

    fn view(projection: Projection, eye: Vec3, near: f64) -> FrameView {
        let camera = Camera::new(eye, eye - Vec3::Z, Vec3::Y, projection, [100, 100]).unwrap();
        FrameView::from_camera(&camera, ClipRange { near, far: 100.0 }, DepthDirection::Reversed).unwrap()
    }

    fn meets(view: &FrameView) -> bool {
        let hull = builtin("icosphere:3");
        meets_hull(&hull, &MeshHierarchy::new(&hull), &hull.bounds().unwrap(), view)
    }

    #[test]
    fn the_near_window_is_what_counts() {
        let narrow = Projection::Perspective { fov_y_rad: 0.2 };
        let wide = Projection::Perspective { fov_y_rad: 1.2 };
        let flat = Projection::Orthographic { height: 1.0 };
        assert!(!meets(&view(wide, Vec3::new(0.0, 0.0, 3.0), 0.5)), "clear of the bounds");
        assert!(meets(&view(wide, Vec3::new(0.0, 0.0, 0.0), 0.1)), "the eye inside");
        assert!(meets(&view(wide, Vec3::new(0.0, 0.0, 1.5), 0.7)), "the near plane cuts the front");
        assert!(meets(&view(narrow, Vec3::new(0.0, 0.0, 1.5), 1.0)), "the whole window inside, the eye outside");
        assert!(!meets(&view(narrow, Vec3::new(0.0, 0.0, 0.5), 2.0)), "the eye inside, the window beyond");
        assert!(!meets(&view(narrow, Vec3::new(1.3, 0.0, 0.5), 0.5)), "beside it, in the bounds' depths");
        assert!(!meets(&view(flat, Vec3::new(1.6, 0.0, 0.5), 0.5)), "the same in parallel");
        assert!(meets(&view(flat, Vec3::new(1.4, 0.0, 0.5), 0.5)), "the window reaches in");
    }

    #[test]
    fn frames_allocate_nothing() {
        let hull = builtin("icosphere:3");
        let (hierarchy, bounds) = (MeshHierarchy::new(&hull), hull.bounds().unwrap());
        let wide = Projection::Perspective { fov_y_rad: 1.2 };
        for distance in [3.0, 1.5] {
            let view = view(wide, Vec3::new(0.0, 0.0, distance), 0.5);
            assert_eq!(
                allocation_counter::measure(|| _ = meets_hull(&hull, &hierarchy, &bounds, &view)).count_total,
                0
            );
        }
    }

    #[test]
    fn model_matrices_move_the_hull() {
        let wide = Projection::Perspective { fov_y_rad: 1.2 };
        let clear = view(wide, Vec3::new(0.0, 0.0, 3.0), 0.5);
        let moved = |scale: DVec3| meets(&clear.with_model(DMat4::from_scale(scale)).unwrap());
        assert!(!moved(DVec3::new(9.0, 2.0, -2.0)));
        assert!(moved(DVec3::new(1.0, 1.0, -2.9)));
    }
}
