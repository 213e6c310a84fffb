//! Why a picture is empty: the mesh lies beside it, or behind the eye.

use silhouette_core::view::DepthDirection;
use silhouette_core::{Camera, Projection, TriangleMesh};

/// Where a mesh lies of which the camera shows nothing, and what to do about it; `None` where it may show something. O(F).
pub fn out_of_view(camera: &Camera, mesh: &TriangleMesh) -> Option<String> {
    let range = camera.clip_range(&mesh.bounds()?);
    let to_clip = camera.world_to_clip(range, DepthDirection::Standard);
    // Whether all corners so far lie behind the eye, and beyond the left, right, lower and upper side of the picture.
    let mut all = [matches!(camera.projection(), Projection::Perspective { .. }), true, true, true, true];
    for &corner in mesh.triangles().iter().flatten() {
        let at = to_clip * mesh.positions()[corner as usize].as_dvec3().extend(1.0);
        let beyond = [at.w <= 0.0, at.x < -at.w, at.x > at.w, at.y < -at.w, at.y > at.w];
        all.iter_mut().zip(beyond).for_each(|(all, beyond)| *all &= beyond);
        if !all.contains(&true) {
            return None;
        }
    }
    const WHERE: [&str; 5] =
        ["behind the eye", "left of the picture", "right of the picture", "below the picture", "above the picture"];
    let place = WHERE.into_iter().zip(all).find_map(|(place, is_there)| is_there.then_some(place))?;
    Some(format!("all of the mesh lies {place}; without --eye, --target and a height for --ortho it fits the view"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::glam::Vec3;
    use silhouette_core::shapes;

    #[test]
    fn places_are_named() {
        let cube = shapes::by_name("cube").unwrap();
        let seen = |eye: Vec3, target: Vec3, projection| {
            let camera = Camera::new(eye, target, Vec3::Y, projection, [100, 80]).unwrap();
            out_of_view(&camera, &cube)
        };
        let perspective = Projection::Perspective { fov_y_rad: 0.7 };
        let flat = Projection::Orthographic { height: 2.0 };
        let eye = Vec3::Z * 9.0;
        for (target, projection, place) in [
            (Vec3::Z * 20.0, perspective, Some("behind the eye")),
            (Vec3::Z * 20.0, flat, None),
            (Vec3::X * 30.0, perspective, Some("left of")),
            (Vec3::NEG_X * 30.0, perspective, Some("right of")),
            (Vec3::Y * 30.0, flat, Some("below")),
            (Vec3::NEG_Y * 30.0, flat, Some("above")),
            (Vec3::ZERO, perspective, None),
            (Vec3::ZERO, flat, None),
        ] {
            let found = seen(eye, target, projection);
            match place {
                Some(place) => assert!(found.as_ref().is_some_and(|found| found.contains(place)), "{found:?}"),
                None => assert_eq!(found, None),
            }
        }
        assert_eq!(seen(Vec3::ZERO, Vec3::X, perspective), None, "an eye inside sees faces from behind");
    }
}
