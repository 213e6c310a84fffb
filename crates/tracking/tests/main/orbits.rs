use crate::scenes::{Oracle, Scene, options, ordered, real_meshes, zoo};
use silhouette_core::loops::start_vertex;
use silhouette_core::{SilhouetteLoops, Topology, TriangleMesh, Viewpoint};
use silhouette_tracking::{BruteForceReason, Concavity, TestedEdges, TrackerOptions};
use std::collections::BTreeSet;

/// Closed, oriented, no half-edge twice.
fn assert_well_formed(mesh: &TriangleMesh, loops: &SilhouetteLoops, context: &str) {
    let distinct: BTreeSet<_> = loops.half_edges().iter().collect();
    assert_eq!(distinct.len(), loops.half_edges().len(), "{context}: a half-edge twice");
    for half_edges in loops.iter() {
        for (index, &half_edge) in half_edges.iter().enumerate() {
            let next = half_edges[(index + 1) % half_edges.len()];
            assert_eq!(
                start_vertex(mesh, half_edge.next_in_face()),
                start_vertex(mesh, next),
                "{context}: {half_edge} does not lead to {next}"
            );
        }
    }
}

/// Tracks an orbit at level 0 with all edges tested; every frame must equal the oracle's. Yields how many frames after
/// the first were found by brute force though there was something to track.
fn equals_brute_force(scene: &Scene, views: impl Iterator<Item = Viewpoint>) -> usize {
    let mut tracker = scene.tracker(TrackerOptions::default());
    let topology = scene.table.topology();
    let mut oracle = Oracle::default();
    let mut fresh_frames = 0;
    for (frame, view) in views.enumerate() {
        let expected = oracle.look(&scene.mesh, topology, &view);
        let found = tracker.update(&view);
        let context = format!("{}, frame {frame}, {view:?}", scene.name);
        assert_well_formed(&scene.mesh, found, &context);
        if ordered(topology, found) != *expected {
            let edges = |loops: &SilhouetteLoops| loops.half_edges().iter().copied().collect::<BTreeSet<_>>();
            panic!("{context}: missed {:?}", &edges(expected) - &edges(found));
        }
        let reason = tracker.stats().brute_force;
        fresh_frames += usize::from(frame > 0 && !matches!(reason, None | Some(BruteForceReason::NothingToTrack)));
    }
    fresh_frames
}

#[test]
fn level_0_equals_brute_force_on_built_in_shapes() {
    for scene in zoo() {
        for step_deg in [0.1, 1.0, 10.0] {
            let fresh_frames = equals_brute_force(&scene, scene.orbit(step_deg, 500));
            assert!(fresh_frames <= 2, "{}: {fresh_frames} frames were not tracked at {step_deg} deg", scene.name);
        }
    }
}

/// Frames per orbit: few on large meshes unless `SILHOUETTES_ORBIT_FRAMES` says how many.
fn frames(few: u32) -> u32 {
    std::env::var("SILHOUETTES_ORBIT_FRAMES").map_or(few, |frames| frames.parse().expect("a number of frames"))
}

#[test]
fn level_0_equals_brute_force_on_real_meshes() {
    for scene in real_meshes("level_0_equals_brute_force_on_real_meshes") {
        if !scene.table.defects().is_empty() {
            continue;
        }
        let frames = frames(if scene.mesh.face_count() < 15_000 { 500 } else { 40 });
        for step_deg in [0.1, 1.0, 10.0] {
            let fresh_frames = equals_brute_force(&scene, scene.orbit(step_deg, frames));
            // Steps larger than the loops of small or inverted pieces: walks that lead nowhere.
            let share = if step_deg > 1.0 { 10 } else { 100 };
            assert!(fresh_frames <= 2 + frames as usize / share, "{}: {fresh_frames} at {step_deg} deg", scene.name);
        }
    }
}

/// Without the concave list the same orbits are not equal: the comparison can fail.
#[test]
fn without_concave_edges_new_loops_are_missed() {
    let scene = Scene::builtin("blob:3000");
    let missed = |concavity| {
        let mut tracker = scene.tracker(TrackerOptions { concavity, ..TrackerOptions::default() });
        let mut oracle = Oracle::default();
        let missed = |view| {
            let all = oracle.look(&scene.mesh, scene.table.topology(), &view).half_edges().len();
            all - tracker.update(&view).half_edges().len()
        };
        scene.orbit(1.0, 360).map(missed).sum::<usize>()
    };
    let levels = [Concavity::Above(0.0), Concavity::Above(0.2), Concavity::Ignored];
    let [none, some, many] = levels.map(missed);
    assert_eq!(none, 0);
    assert!(0 < some && some <= many, "{some} {many}");
}

/// What is found at any level, with any number of tested edges, are whole loops of the oracle.
#[test]
fn loops_are_found_whole_or_not_at_all() {
    for scene in zoo() {
        for (level_rad, tested) in [(0.0, TestedEdges::Single), (0.1, TestedEdges::All), (9.0, TestedEdges::Single)] {
            let mut tracker = scene.tracker(options(level_rad, tested));
            let mut oracle = Oracle::default();
            let topology: &Topology = scene.table.topology();
            for view in scene.orbit(3.0, 60) {
                let expected = oracle.look(&scene.mesh, topology, &view);
                let expected: BTreeSet<&[_]> = expected.iter().collect();
                let found = ordered(topology, tracker.update(&view));
                assert!(found.iter().all(|half_edges| expected.contains(half_edges)), "{} {view:?}", scene.name);
            }
        }
    }
}

/// An orthographic view turns as an eye does.
#[test]
fn orthographic_orbits_equal_brute_force() {
    for scene in zoo() {
        let center = scene.mesh.bounds().unwrap().center.as_vec3();
        let views: Vec<_> = scene
            .orbit(1.0, 200)
            .map(|view| match view {
                Viewpoint::Perspective { eye } => Viewpoint::Orthographic { toward_viewer: eye - center },
                orthographic @ Viewpoint::Orthographic { .. } => orthographic,
            })
            .collect();
        assert!(equals_brute_force(&scene, views.into_iter()) <= 2, "{}", scene.name);
    }
}
