use proptest::prelude::*;
use silhouette_core::method::{OptionError, PrepareError};
use silhouette_core::{
    ExtractsEdges, ExtractsLoops, Method, PreparedMesh, SilhouetteEdges, SilhouetteLoops, Topology, TriangleMesh,
    Viewpoint,
};
use silhouette_extraction::{BruteForce, Randomized, RandomizedOptions};
use silhouette_testing::prepare::{artefact, method, prepared};
use silhouette_testing::strategies::{lattice_viewpoint, soup};
use silhouette_testing::views::{hard_viewpoints, seen_from};
use silhouette_testing::{builtin, zoo};
use std::collections::BTreeSet;
use std::sync::Arc;

fn randomized(mesh: &Arc<PreparedMesh>, probes: f64) -> Randomized {
    Randomized::new(mesh, RandomizedOptions { probes, ..RandomizedOptions::default() }).unwrap()
}

/// What is found are silhouette edges, and with one half-edge of a loop all of the loop.
fn check(mesh: TriangleMesh, views: &[Viewpoint]) {
    let mesh = prepared(mesh);
    let mut oracle: BruteForce = method(&mesh);
    let mut method = randomized(&mesh, 0.2);
    let topology: Arc<Topology> = artefact(&mesh);
    let (mut found, mut all, mut loops) = <(SilhouetteEdges, SilhouetteEdges, SilhouetteLoops)>::default();
    for view in views {
        method.extract_edges(view, &mut found);
        oracle.extract_edges(view, &mut all);
        oracle.extract_loops(view, &mut loops);
        assert!(found.iter().all(|edge| all.contains(edge)), "{view:?}");
        let mut whole = BTreeSet::new();
        for half_edges in loops.iter() {
            let edges: Vec<_> = half_edges.iter().map(|&half_edge| topology.edge_of(half_edge)).collect();
            if edges.iter().all(|&edge| found.contains(edge)) {
                whole.extend(edges);
            }
        }
        assert!(found.iter().eq(whole), "{view:?}");
    }
}

#[test]
fn loops_are_found_whole_or_not_at_all() {
    for (_, mesh) in zoo::all() {
        let views = hard_viewpoints(&mesh, 8);
        check(mesh, &views);
    }
}

proptest! {
    #[test]
    fn any_soup(mesh in soup(150), views in prop::collection::vec(lattice_viewpoint(4), 1..8)) {
        check(mesh, &views);
    }
}

#[test]
fn a_loop_once_found_is_followed_without_luck() {
    let mesh = prepared(builtin("icosphere:5"));
    // One probe per view: it takes many views to hit the outline, and none to keep it.
    let mut oracle: BruteForce = method(&mesh);
    let mut method = randomized(&mesh, 0.00001);
    let (mut found, mut all) = (SilhouetteEdges::default(), SilhouetteEdges::default());
    let mut misses_before_first_hit = 0;
    for frame in 0..2000_u16 {
        let angle = f32::from(frame) * 1e-3;
        let view = seen_from([3.0 * angle.cos(), 0.3, 3.0 * angle.sin()]);
        method.extract_edges(&view, &mut found);
        oracle.extract_edges(&view, &mut all);
        if found.is_empty() && misses_before_first_hit == usize::from(frame) {
            misses_before_first_hit += 1;
        } else {
            assert_eq!(found, all, "frame {frame}");
        }
    }
    assert!((1..1000).contains(&misses_before_first_hit), "{misses_before_first_hit}");
}

#[test]
fn the_seed_decides() {
    let mesh = prepared(builtin("blob:20000"));
    let run = |seed| {
        let mut method = Randomized::new(&mesh, RandomizedOptions { probes: 0.01, seed }).unwrap();
        let mut edges = SilhouetteEdges::default();
        let views = [[3.0, 0.0, 0.0], [0.0, 3.0, 0.5], [0.0, -1.0, 3.0]].map(seen_from);
        views.map(|view| (method.extract_edges(&view, &mut edges), edges.clone()))
    };
    assert_eq!(run(5), run(5));
    assert_ne!(run(5).map(|view| view.0.faces_tested), run(6).map(|view| view.0.faces_tested));
}

#[test]
fn far_fewer_faces_are_tested() {
    let mesh = prepared(builtin("blob:100000"));
    let (mut found, mut all) = (SilhouetteEdges::default(), SilhouetteEdges::default());
    let view = seen_from([3.0, 0.0, 0.0]);
    let stats = method::<Randomized>(&mesh).extract_edges(&view, &mut found);
    method::<BruteForce>(&mesh).extract_edges(&view, &mut all);
    assert!(stats.faces_tested < 10_000, "{stats:?}");
    assert!(
        found.len() * 2 > all.len(),
        "the outline itself is long enough to be hit: {} of {}",
        found.len(),
        all.len()
    );
}

#[test]
fn options_out_of_range_are_refused_before_anything_is_built() {
    let mesh = prepared(builtin("cube"));
    for probes in [-0.1, 1.5, f64::NAN] {
        let error = Randomized::new(&mesh, RandomizedOptions { probes, seed: 1 }).unwrap_err();
        assert!(matches!(error, PrepareError::Option(OptionError::Value { name: "probes", .. })), "{error}");
    }
    assert!(mesh.report().is_empty());
}
