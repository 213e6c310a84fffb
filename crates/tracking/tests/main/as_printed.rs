use crate::scenes::{Oracle, Scene, ordered};
use silhouette_core::loops::start_vertex;
use silhouette_core::topology::Twin;
use silhouette_core::{FaceFacings, HalfEdgeId};
use silhouette_tracking::TrackerOptions;
use silhouette_tracking::as_printed::{
    AppendedFace, LoopOrder, PrintedEdge, StopTest, WalkStart, complete_silhouette, find_silhouette_edge,
};

/// A sphere from outside: one loop, and its facings.
fn sphere() -> (Scene, FaceFacings, Vec<HalfEdgeId>) {
    let scene = Scene::builtin("icosphere:3");
    let view = scene.orbit(0.0, 1).next().unwrap();
    let facings = FaceFacings::new(&scene.mesh, &view);
    let loops = Oracle::default().look(&scene.mesh, scene.table.topology(), &view).clone();
    assert_eq!(loops.len(), 1);
    let half_edges = loops.get(0).to_vec();
    (scene, facings, half_edges)
}

#[test]
fn complete_silhouette_as_meant_is_the_loop_backwards() {
    let (scene, facings, half_edges) = sphere();
    let slips = (StopTest::CurrentFace, AppendedFace::CurrentFace);
    let printed =
        complete_silhouette(scene.table.topology(), |face| facings.is_front(face), half_edges[0], slips, 10_000);
    assert!(printed.ended);
    let backwards = half_edges[..1].iter().chain(half_edges[1..].iter().rev());
    let expected: Vec<_> = backwards.map(|h| PrintedEdge { face: Some(h.face()), slot: h.slot() }).collect();
    assert_eq!(printed.entries, expected);
}

#[test]
fn the_printed_stop_test_never_holds() {
    let (scene, facings, half_edges) = sphere();
    let slips = (StopTest::TestFace, AppendedFace::CurrentFace);
    let rounds = 100 * scene.mesh.face_count();
    let printed =
        complete_silhouette(scene.table.topology(), |face| facings.is_front(face), half_edges[0], slips, rounds);
    assert!(!printed.ended);
    assert!(printed.entries.len() > 10 * half_edges.len(), "it goes round and round");
}

/// Errata: with the stop test mended, all entries but the first name a back face.
#[test]
fn the_printed_entries_name_back_faces() {
    let (scene, facings, half_edges) = sphere();
    let is_front = |face| facings.is_front(face);
    let slips = (StopTest::CurrentFace, AppendedFace::TestFace);
    let printed = complete_silhouette(scene.table.topology(), is_front, half_edges[0], slips, 10_000);
    assert!(printed.ended);
    let back = printed.entries.iter().filter(|entry| !is_front(entry.face.unwrap())).count();
    assert_eq!((back, printed.entries.len()), (half_edges.len() - 1, half_edges.len()));
}

#[test]
fn the_printed_walk_goes_round_for_ever_where_all_faces_are_front() {
    let scene = Scene::builtin("icosphere:2");
    let rounds = 100 * scene.mesh.face_count();
    let topology = scene.table.topology();
    assert_eq!(find_silhouette_edge(topology, |_| true, HalfEdgeId::new(0), rounds), None);
    // The first state comes back, which is where the tracker's walk ends; and within 6 F steps.
    let mut visited = std::collections::BTreeSet::new();
    let (mut back, mut steps) = (HalfEdgeId::new(0), 0);
    while visited.insert((back, steps % 2)) {
        let left = back.next_in_face();
        let side = if steps % 2 == 0 { left } else { left.next_in_face() };
        let Twin::HalfEdge(twin) = topology.twin(side) else { unreachable!("closed") };
        (back, steps) = (twin, steps + 1);
    }
    assert_eq!((back, steps % 2), (HalfEdgeId::new(0), 0));
    assert!(steps <= 6 * scene.mesh.face_count());
    // With one back face, it ends.
    let back_face = silhouette_core::FaceId::new(200);
    let found = find_silhouette_edge(topology, |face| face != back_face, HalfEdgeId::new(0), rounds);
    assert!(found.is_none_or(|(half_edge, _)| half_edge.face() != back_face));
}

#[test]
fn starting_at_the_old_front_face_takes_more_steps() {
    let scene = Scene::builtin("blob:6000");
    let fly = |walk_start| {
        let mut tracker = scene.tracker(TrackerOptions { walk_start, ..TrackerOptions::default() });
        let mut oracle = Oracle::default();
        let (mut walks, mut steps) = (0, 0);
        for view in scene.orbit(0.5, 200) {
            let found = ordered(scene.table.topology(), tracker.update(&view));
            assert_eq!(found, *oracle.look(&scene.mesh, scene.table.topology(), &view), "{walk_start:?} {view:?}");
            walks += tracker.stats().walks;
            steps += tracker.stats().walk_steps;
        }
        steps as f64 / walks as f64
    };
    let (corrected, printed) = (fly(WalkStart::Corrected), fly(WalkStart::AsPrinted));
    assert!(printed > 1.5 * corrected, "{printed} steps per walk, {corrected} corrected");
}

#[test]
fn the_printed_order_runs_against_the_half_edges() {
    let scene = Scene::builtin("blob:2000");
    let mut tracker = scene.tracker(TrackerOptions { loop_order: LoopOrder::AsPrinted, ..TrackerOptions::default() });
    let mut corrected = scene.tracker(TrackerOptions::default());
    for view in scene.orbit(1.0, 20) {
        let expected = corrected.update(&view);
        let printed = tracker.update(&view);
        assert_eq!(printed.len(), expected.len());
        for (printed, expected) in printed.iter().zip(expected.iter()) {
            assert!(printed[1..].iter().rev().chain(&printed[..1]).eq(expected[1..].iter().chain(&expected[..1])));
            let next_end = |i: usize| start_vertex(&scene.mesh, printed[(i + 1) % printed.len()].next_in_face());
            assert!((0..printed.len()).all(|i| next_end(i) == start_vertex(&scene.mesh, printed[i])));
        }
    }
}
