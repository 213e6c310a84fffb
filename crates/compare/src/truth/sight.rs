//! [`sight_ray`]: what a pixel looks along.

use glam::{DVec2, DVec3};
use silhouette_core::{Camera, Projection};

/// Origin and unit direction of the ray of sight through a place of the picture, in pixels. In a parallel view it begins far
/// before the eye: what lies there is seen too.
pub fn sight_ray(camera: &Camera, pixel: DVec2) -> (DVec3, DVec3) {
    let to_world = camera.view_matrix().inverse();
    let center = DVec2::from(camera.size().map(f64::from)) * 0.5;
    let [x, y] = ((pixel - center) / camera.pixels_per_unit(1.0)).to_array();
    match camera.projection() {
        Projection::Perspective { .. } => {
            (camera.eye().as_dvec3(), to_world.transform_vector3(DVec3::new(x, -y, -1.0)).normalize())
        }
        Projection::Orthographic { .. } => {
            let direction = to_world.transform_vector3(DVec3::NEG_Z).normalize();
            let back = 100.0 * camera.eye().as_dvec3().distance(camera.target().as_dvec3());
            (to_world.transform_point3(DVec3::new(x, -y, 0.0)) - direction * back, direction)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::glam::Vec3;
    use silhouette_core::shapes;
    use silhouette_core::view::Framing;

    #[test]
    fn a_ray_passes_through_what_appears_at_its_pixel() {
        let bounds = shapes::by_name("cube").unwrap().bounds().unwrap();
        for framing in [Framing::Perspective { fov_y_rad: 0.7 }, Framing::Orthographic] {
            let camera = Camera::framing(&bounds, DVec3::new(0.3, 0.5, 1.0), Vec3::Y, framing, [300, 200]).unwrap();
            for point in [DVec3::new(0.2, -0.4, 0.1), DVec3::new(-0.5, 0.5, 0.5)] {
                let (origin, direction) = sight_ray(&camera, camera.project(point).unwrap().pixel);
                let off = (point - origin).reject_from(direction).length();
                assert!(off < 1e-5 && (point - origin).dot(direction) > 0.0, "{framing:?}: {off}");
            }
        }
    }
}
