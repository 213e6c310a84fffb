use crate::scenes::{Oracle, Scene, options, ordered, zoo};
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::{SilhouetteLoops, Viewpoint};
use silhouette_testing::views::seen_from;
use silhouette_tracking::{BruteForceReason, Concavity, TestedEdges, Tracker, TrackerOptions};

fn reason(tracker: &mut Tracker, view: &Viewpoint) -> Option<BruteForceReason> {
    tracker.update(view);
    tracker.stats().brute_force
}

#[test]
fn the_same_view_again_is_the_identity_and_walks_nothing() {
    for scene in zoo() {
        for tested in [TestedEdges::All, TestedEdges::Single] {
            let mut tracker = scene.tracker(options(0.0, tested));
            for view in scene.orbit(7.0, 30) {
                let first: SilhouetteLoops = tracker.update(&view).clone();
                let ids = tracker.ids().to_vec();
                let second = ordered(scene.table.topology(), tracker.update(&view));
                assert_eq!(second, ordered(scene.table.topology(), &first), "{}", scene.name);
                let stats = tracker.stats();
                assert_eq!((stats.walks, stats.walk_steps), (0, 0), "{}", scene.name);
                assert!(first.is_empty() || stats.brute_force.is_none());
                assert!(tracker.events().is_empty(), "{}", scene.name);
                let mut same_ids = tracker.ids().to_vec();
                same_ids.sort_unstable();
                let mut ids = ids;
                ids.sort_unstable();
                assert_eq!(same_ids, ids);
            }
        }
    }
}

#[test]
fn reasons_are_reported() {
    let scene = Scene::builtin("icosphere:3");
    let mut tracker = scene.tracker(TrackerOptions::default());
    assert_eq!(reason(&mut tracker, &seen_from([3.0, 0.0, 0.0])), Some(BruteForceReason::FirstFrame));
    assert_eq!(reason(&mut tracker, &seen_from([3.0, 0.1, 0.0])), None);
    assert_eq!(reason(&mut tracker, &seen_from([-3.0, 0.1, 0.0])), Some(BruteForceReason::Jump));
    assert_eq!(reason(&mut tracker, &seen_from([-2.9, 0.1, 0.0])), None);
    let along = Viewpoint::Orthographic { toward_viewer: Vec3::X };
    assert_eq!(reason(&mut tracker, &along), Some(BruteForceReason::Jump), "another kind of view");
    let turned = Viewpoint::Orthographic { toward_viewer: Vec3::new(5.0, 0.2, 0.0) };
    assert_eq!(reason(&mut tracker, &turned), None);
    assert_eq!(reason(&mut tracker, &seen_from([f32::NAN, 0.0, 0.0])), Some(BruteForceReason::Jump));
    assert_eq!(reason(&mut tracker, &seen_from([3.0, 0.0, 0.0])), Some(BruteForceReason::NothingToTrack));
    tracker.reset();
    assert!(tracker.loops().is_empty() && tracker.ids().is_empty());
    assert_eq!(reason(&mut tracker, &seen_from([3.0, 0.0, 0.0])), Some(BruteForceReason::FirstFrame));
    let mut never = scene.tracker(TrackerOptions { jump: 0.0, ..TrackerOptions::default() });
    never.update(&seen_from([3.0, 0.0, 0.0]));
    assert_eq!(reason(&mut never, &seen_from([3.0, 0.0, 1e-6])), Some(BruteForceReason::Jump));
}

/// A convex mesh has no concave edge at which its silhouette could be found again after the eye was inside.
#[test]
fn an_eye_that_leaves_a_convex_mesh_finds_its_silhouette() {
    let scene = Scene::builtin("icosphere:3");
    let mut tracker = scene.tracker(TrackerOptions::default());
    let mut oracle = Oracle::default();
    assert_eq!(scene.edges.concave().len(), 0);
    let mut reasons = Vec::new();
    for step in 0..60_u8 {
        let view = seen_from([0.0, 0.03, 2.0 - 0.05 * f32::from(step)]);
        let expected = oracle.look(&scene.mesh, scene.table.topology(), &view);
        assert_eq!(ordered(scene.table.topology(), tracker.update(&view)), *expected, "step {step}");
        let is_inside = (f32::from(step) * 0.05 - 2.0).abs() < 0.98;
        assert_eq!(expected.is_empty(), is_inside, "step {step}");
        reasons.push(tracker.stats().brute_force);
    }
    assert!(reasons.contains(&Some(BruteForceReason::MayHaveCrossed)));
    assert!(reasons.contains(&Some(BruteForceReason::NothingToTrack)));
    assert!(reasons.iter().filter(|reason| reason.is_none()).count() > 15, "outside the box it tracks: {reasons:?}");
}

/// Flying through a concave mesh, level 0 stays equal to brute force; inside the box, clear balls let it track.
#[test]
fn flights_through_a_mesh_equal_brute_force() {
    for name in ["blob:2000,0.6", "torus:40,24", "gear", "grid:20,14", "knot"] {
        let scene = Scene::builtin(name);
        let bounds = scene.mesh.bounds().unwrap();
        let mut tracker = scene.tracker(TrackerOptions::default());
        let mut oracle = Oracle::default();
        let mut tracked = 0;
        for step in 0..400_u16 {
            let t = f64::from(step) * 0.01;
            let direction = DVec3::new((1.3 * t).sin(), (0.9 * t + 0.4).cos(), (2.1 * t).sin());
            let eye = (bounds.center + direction * (bounds.radius * (1.2 - 0.29 * t))).as_vec3();
            let view = seen_from(eye);
            let expected = oracle.look(&scene.mesh, scene.table.topology(), &view);
            assert_eq!(ordered(scene.table.topology(), tracker.update(&view)), *expected, "{name}, step {step}");
            tracked += usize::from(tracker.stats().brute_force.is_none());
        }
        assert!(tracked > 100, "{name}: {tracked} of 400 frames were tracked");
    }
}

#[test]
fn the_level_changes_at_run_time() {
    let scene = Scene::builtin("blob:3000");
    let mut tracker = scene.tracker(options(1.0, TestedEdges::All));
    let mut oracle = Oracle::default();
    let mut missed = |tracker: &mut Tracker, view: &Viewpoint| {
        let all = oracle.look(&scene.mesh, scene.table.topology(), view).half_edges().len();
        all - tracker.update(view).half_edges().len()
    };
    let views: Vec<_> = scene.orbit(1.0, 200).collect();
    let before: usize = views.iter().map(|view| missed(&mut tracker, view)).sum();
    assert!(before > 0);
    tracker.set_concavity(Concavity::Above(0.0));
    assert_eq!(missed(&mut tracker, &views[199]), 0, "the next frame finds all that holds a concave edge");
    assert_eq!(tracker.options().concavity, Concavity::Above(0.0));
    let concave = scene.edges.concave();
    assert!(concave.is_sorted_by(|a, b| a.angle_rad >= b.angle_rad));
}
