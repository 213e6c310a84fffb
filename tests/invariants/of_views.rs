//! What edges do not depend on.

use crate::seen::look;
use glam::Vec3;
use proptest::prelude::*;
use silhouette_core::{Camera, Projection};
use silhouette_testing::strategies::{closed_mesh, soup};

proptest! {
    /// Invariant 15: field of view, viewport and the upward direction change no edge; another place of the eye does.
    #[test]
    fn only_the_place_of_the_eye_decides_the_edges(
        mesh in prop_oneof![closed_mesh(), soup(40)],
        eye in prop::array::uniform3(1.5_f32..6.0),
        degrees in prop::array::uniform2(0.01_f64..179.0),
        sizes in prop::array::uniform4(1_u32..2000),
        up in prop::array::uniform2(-1.0_f32..1.0),
    ) {
        let eye = Vec3::from(eye);
        let camera = |of: usize| {
            let projection = Projection::Perspective { fov_y_rad: degrees[of].to_radians() };
            let up = eye.any_orthogonal_vector() + Vec3::splat(up[of] * 0.1);
            Camera::new(eye, Vec3::splat(0.1 * of as f32), up, projection, [sizes[2 * of], sizes[2 * of + 1]]).unwrap()
        };
        let of = |camera: Camera| look(&mesh, &camera.viewpoint());
        prop_assert_eq!(of(camera(0)).edges, of(camera(1)).edges);
    }
}
