use crate::scenes::{Scene, options};
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::{HalfEdgeId, TriangleMesh};
use silhouette_testing::builtin;
use silhouette_testing::edits::{joined, moved};
use silhouette_testing::views::seen_from;
use silhouette_tracking::{Accuracy, LoopEvent, LoopId, TestedEdges, Tracker, TrackerOptions};

/// Births, deaths, splits and merges of the last frame.
fn tally(tracker: &Tracker) -> [usize; 4] {
    let mut counts = [0; 4];
    for event in tracker.events().iter() {
        counts[match event {
            LoopEvent::Birth { .. } => 0,
            LoopEvent::Death { .. } => 1,
            LoopEvent::Split { .. } => 2,
            LoopEvent::Merge { .. } => 3,
        }] += 1;
    }
    counts
}

/// A torus: along its axis two circles, from its side one loop or more. On the way the outer and the inner circle meet.
#[test]
fn a_torus_that_turns_merges_its_circles_and_splits_them_again() {
    let scene = Scene::builtin("torus:96,64");
    for accuracy in [Accuracy::Level, Accuracy::Exact] {
        turn_a_torus(scene.tracker(TrackerOptions { accuracy, ..TrackerOptions::default() }));
    }
}

fn turn_a_torus(mut tracker: Tracker) {
    let views = |range: std::ops::Range<u16>| {
        range.map(|step| f64::from(step).to_radians() * 0.25).map(|angle| {
            let (sin, cos) = angle.sin_cos();
            seen_from((DVec3::new(sin, cos, 0.003) * 12.0).as_vec3())
        })
    };
    let mut totals = [0; 4];
    for (frame, view) in views(0..360).enumerate() {
        let loops = tracker.update(&view).len();
        assert_eq!(tracker.ids().len(), loops);
        if frame == 0 {
            assert_eq!((loops, tally(&tracker)), (2, [2, 0, 0, 0]));
        } else {
            totals.iter_mut().zip(tally(&tracker)).for_each(|(total, count)| *total += count);
        }
    }
    // A torus keeps two contour generators from everywhere but its tangent cone: nothing is ever born out of nothing.
    assert_eq!(tracker.loops().len(), 2, "two generators, from the side as well");
    assert!(totals[0] <= 2 && totals[1] <= 2, "few births and deaths by the edges' zigzag: {totals:?}");
}

/// Dumb-bell: a surface of revolution about x with two lobes.
fn dumbbell() -> TriangleMesh {
    let (along, around) = (120_u32, 64_u32);
    let radius = |x: f64| {
        (0.35 + 0.65 * (std::f64::consts::PI * x / 2.0).sin().powi(2)) * (1.0 - (x / 2.0).powi(8)).max(0.0).sqrt()
    };
    let mut positions = vec![Vec3::new(-2.0, 0.0, 0.0)];
    for i in 1..along {
        let x = -2.0 + 4.0 * f64::from(i) / f64::from(along);
        for j in 0..around {
            let (sin, cos) = (std::f64::consts::TAU * (f64::from(j) + 0.3) / f64::from(around)).sin_cos();
            positions.push(DVec3::new(x, radius(x) * cos, radius(x) * sin).as_vec3());
        }
    }
    positions.push(Vec3::new(2.0, 0.0, 0.0));
    let at = |i: u32, j: u32| 1 + (i - 1) * around + j % around;
    let last = positions.len() as u32 - 1;
    let mut triangles = Vec::new();
    for j in 0..around {
        triangles.push([0, at(1, j + 1), at(1, j)]);
        triangles.push([last, at(along - 1, j), at(along - 1, j + 1)]);
        for i in 1..along - 1 {
            let [a, b, c, d] = [at(i, j), at(i, j + 1), at(i + 1, j), at(i + 1, j + 1)];
            triangles.extend([[a, b, c], [b, d, c]]);
        }
    }
    TriangleMesh::new(positions, triangles).unwrap()
}

/// Seen from the side the dumb-bell has one silhouette; along its axis, the rim of the near lobe, the far side of the
/// waist and the rim of the far lobe: three. So on the way there are splits or births, and merges or deaths on the way
/// back, and each loop that there is has an id that some event has named.
#[test]
fn a_two_lobed_body_splits_and_merges() {
    let scene = Scene::new("dumb-bell", dumbbell());
    assert!(scene.table.defects().is_empty());
    for accuracy in [Accuracy::Level, Accuracy::Exact] {
        split_and_merge(scene.tracker(TrackerOptions { accuracy, ..TrackerOptions::default() }));
    }
}

fn split_and_merge(mut tracker: Tracker) {
    let mut totals = [0; 4];
    let steps = (0..=360_u16).chain((0..360).rev());
    let mut loops_seen = Vec::new();
    for (frame, step) in steps.enumerate() {
        let (sin, cos) = (f64::from(step) * 0.25 + 0.01).to_radians().sin_cos();
        tracker.update(&seen_from((DVec3::new(sin, cos * 0.99, cos * 0.13) * 9.0).as_vec3()));
        loops_seen.push(tracker.loops().len());
        if frame > 0 {
            assert_eq!(tracker.stats().brute_force, None);
            totals.iter_mut().zip(tally(&tracker)).for_each(|(total, count)| *total += count);
        }
    }
    let [births, deaths, splits, merges] = totals;
    assert_eq!((loops_seen[0], loops_seen[360], loops_seen[720]), (1, 3, 1));
    assert!(splits >= 1 && merges >= 1, "{totals:?}");
    assert_eq!(births + splits, deaths + merges, "back to one loop: {totals:?}");
}

/// Bodies that do not touch: each keeps its loop and its id, however the loops are found.
#[test]
fn disjoint_bodies_keep_their_ids() {
    let ball = builtin("icosphere:3");
    let places = [Vec3::ZERO, Vec3::new(4.0, 0.0, 0.0), Vec3::new(0.0, 4.0, 1.0)];
    let balls = places.map(|place| moved(&ball, place));
    let scene = Scene::new("three balls", joined(&balls.each_ref()));
    let body_of = |half_edge: HalfEdgeId| half_edge.face().index() / ball.face_count();
    for tested in [TestedEdges::All, TestedEdges::Single] {
        let mut tracker = scene.tracker(options(0.0, tested));
        let mut id_of_body: Option<[LoopId; 3]> = None;
        for view in scene.orbit(2.0, 180) {
            tracker.update(&view);
            let mut ids = [None; 3];
            for (half_edges, &id) in tracker.loops().iter().zip(tracker.ids()) {
                ids[body_of(half_edges[0])] = Some(id);
            }
            let ids = ids.map(Option::unwrap);
            assert_eq!(*id_of_body.get_or_insert(ids), ids, "{tested:?}");
        }
    }
}

/// A bump that comes over the horizon of a ball, and goes: one birth or split, one death or merge, the outline's id
/// stays.
#[test]
fn the_outline_keeps_its_id_while_small_loops_come_and_go() {
    let scene = Scene::builtin("blob:8000,0.2");
    for accuracy in [Accuracy::Level, Accuracy::Exact] {
        let mut tracker = scene.tracker(TrackerOptions { accuracy, ..TrackerOptions::default() });
        let (mut outline, mut changes, mut events) = (None, 0, 0);
        for view in scene.orbit(0.5, 720) {
            tracker.update(&view);
            let loops = tracker.loops().iter().zip(tracker.ids());
            let longest = loops.max_by_key(|(half_edges, _)| half_edges.len()).map(|(_, &id)| id);
            changes += usize::from(outline != longest);
            events += tracker.events().len();
            outline = longest;
        }
        assert!(events > 20, "{accuracy:?}: {events} events: loops do come and go");
        assert!(changes <= 3, "{accuracy:?}: {changes} changes of the outline's id");
    }
}
