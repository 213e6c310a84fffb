//! The visibility function that a silhouette texture samples.

use glam::Vec3;
use proptest::prelude::*;
use silhouette_core::FaceId;
use silhouette_testing::builtin;
use silhouette_testing::edits::mapped;
use silhouette_testing::strategies::closed_mesh;
use silhouette_texture::{Hull, VisibilityFunction, VisibilityRule};

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// Invariant 31: a point of an enclosing hull shows nothing in directions that leave the hull there, so that no lobe covers more
    /// than half of all directions.
    #[test]
    fn a_hull_shows_nothing_in_directions_that_leave_it(
        object in closed_mesh(),
        choice in any::<prop::sample::Index>(),
        weights in prop::array::uniform3(0.01_f32..1.0),
        directions in prop::collection::vec(prop::array::uniform3(-1.0_f32..1.0), 40),
        is_exterior: bool,
    ) {
        // Shaken shapes reach no farther than 3.
        let hull = Hull::trusted(mapped(&builtin("icosphere:1"), |p| p * 4.0));
        let rule = if is_exterior { VisibilityRule::Exterior } else { VisibilityRule::Interior };
        let visibility = VisibilityFunction::new(&object, &hull, rule);
        let face = FaceId::from_usize(choice.index(hull.mesh().face_count()));
        let weights = Vec3::from(weights) / weights.iter().sum::<f32>();
        let point = visibility.point(face, weights);
        let (mut leaving, mut shown) = (0, 0);
        for direction in directions.into_iter().map(Vec3::from).filter(|d| d.length() > 0.1).map(Vec3::normalize) {
            let outwards = point.normal.dot(direction);
            if outwards >= 0.0 {
                prop_assert!(!visibility.shows(&point, direction), "{} of {:?}", direction, point);
                leaving += 1;
            } else {
                shown += usize::from(visibility.shows(&point, direction));
            }
        }
        // Towards the middle of what it holds, it may show something.
        prop_assume!(leaving > 0);
        prop_assert!(shown <= 40 - leaving);
    }
}

/// The rule says something: inwards, most points of a close hull show the object.
#[test]
fn a_hull_shows_its_object_inwards() {
    let object = builtin("icosphere:3");
    let hull = Hull::trusted(mapped(&builtin("icosphere:1"), |p| p * 1.3));
    let visibility = VisibilityFunction::new(&object, &hull, VisibilityRule::Exterior);
    for face in (0..hull.mesh().face_count()).map(FaceId::from_usize) {
        let point = visibility.point(face, Vec3::splat(1.0 / 3.0));
        assert!(visibility.shows(&point, -point.position.normalize().as_vec3()), "{face}");
    }
}
