use crate::scenes::{Oracle, Scene, ordered, zoo};
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::method::{ExtractsMovingEdges, PositionsError};
use silhouette_core::{ExtractsEdges, SilhouetteEdges, VertexId};
use silhouette_testing::builtin;
use silhouette_testing::edits::{joined, moved, twisted, with_positions};
use silhouette_testing::views::seen_from;
use silhouette_tracking::{BruteForceReason, TrackerOptions, Tracking};

#[test]
fn a_mesh_that_moves_equals_brute_force_in_each_frame() {
    for scene in zoo() {
        let mut tracker = scene.tracker(TrackerOptions::default());
        let mut oracle = Oracle::default();
        let mut tracked = 0;
        for (frame, view) in scene.orbit(0.5, 60).enumerate() {
            let positions = twisted(&scene.mesh, frame as f32 * 0.01, 0.3);
            tracker.move_mesh(&positions).unwrap();
            let frozen = with_positions(&scene.mesh, positions);
            let expected = oracle.look(&frozen, scene.table.topology(), &view);
            let found = ordered(scene.table.topology(), tracker.update(&view));
            assert_eq!(found, *expected, "{}, frame {frame}", scene.name);
            let reason = tracker.stats().brute_force;
            tracked += usize::from(matches!(reason, None | Some(BruteForceReason::NothingToTrack)));
        }
        assert!(tracked >= 59, "{}: {tracked} frames were tracked", scene.name);
    }
}

/// The mesh sweeps over the eye, which rests.
#[test]
fn a_mesh_that_may_have_passed_the_eye_is_found_anew() {
    let scene = Scene::builtin("icosphere:3");
    let mut tracker = scene.tracker(TrackerOptions::default());
    let mut oracle = Oracle::default();
    let view = scene.view(DVec3::X, 3.0);
    for step in 0..60_u8 {
        let frozen = moved(&scene.mesh, Vec3::X * (0.1 * f32::from(step)));
        tracker.move_mesh(frozen.positions()).unwrap();
        let expected = oracle.look(&frozen, scene.table.topology(), &view);
        assert_eq!(ordered(scene.table.topology(), tracker.update(&view)), *expected, "step {step}");
    }
}

#[test]
fn positions_that_do_not_fit_are_refused_and_change_nothing() {
    let scene = Scene::builtin("blob:500");
    let mut method = Tracking::from(scene.tracker(TrackerOptions::default()));
    let view = scene.orbit(0.0, 1).next().unwrap();
    let (mut before, mut after) = (SilhouetteEdges::default(), SilhouetteEdges::default());
    method.extract_edges(&view, &mut before);
    let mut positions = scene.mesh.positions().to_vec();
    let vertices = positions.len();
    let short = method.update_positions(&positions[1..]);
    assert_eq!(short, Err(PositionsError::Count { given: vertices - 1, vertices }));
    positions[17].y = f32::NAN;
    let not_finite = method.update_positions(&positions);
    assert_eq!(not_finite, Err(PositionsError::NotFinite { vertex: VertexId::new(17) }));
    method.extract_edges(&view, &mut after);
    assert!(!before.is_empty());
    assert_eq!(before, after);
}

/// A ball moves off an eye that rests inside it: its outline, which holds no concave edge, comes from nowhere.
#[test]
fn a_body_that_passes_a_resting_eye_is_noticed() {
    let ball = builtin("icosphere:3");
    let scene = Scene::new("two balls", joined(&[&moved(&ball, Vec3::new(6.0, 0.0, 0.0)), &ball]));
    let mut tracker = scene.tracker(TrackerOptions::default());
    let view = seen_from([0.1, 0.2, 0.05]);
    assert_eq!(tracker.update(&view).len(), 1, "of the ball around the eye nothing is seen");
    let first = ball.vertex_count();
    let positions: Vec<Vec3> = (scene.mesh.positions().iter().enumerate())
        .map(|(vertex, &p)| if vertex < first { p } else { p + Vec3::new(0.0, 3.0, 0.0) })
        .collect();
    tracker.move_mesh(&positions).unwrap();
    assert_eq!(tracker.update(&view).len(), 2);
    assert_eq!(tracker.stats().brute_force, Some(BruteForceReason::MayHaveCrossed));
    tracker.update(&view);
    assert_eq!(tracker.stats().brute_force, None, "once is enough");
}
