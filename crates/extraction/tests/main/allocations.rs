use silhouette_core::method::ExtractsMovingEdges;
use silhouette_core::{ExtractsEdges, Method, SilhouetteEdges, Viewpoint};
use silhouette_extraction::{BruteForceSimd, ClusterCones, Randomized};
use silhouette_testing::prepare::{method, prepared};
use silhouette_testing::views::orbit;
use silhouette_testing::{builtin, with_threads};

/// Allocations of all views of an orbit that was flown twice before, so that buffers have grown.
fn steady_allocations<M: Method + ExtractsEdges>(name: &str, threads: usize) -> u64 {
    let mesh = prepared(builtin(name));
    let views: Vec<Viewpoint> = orbit(mesh.mesh(), 23.0, 16).collect();
    let mut method: M = method(&mesh);
    let mut edges = SilhouetteEdges::default();
    with_threads(threads, || {
        let mut fly = || views.iter().map(|view| method.extract_edges(view, &mut edges).faces_tested).sum::<u64>();
        let first = fly() + fly();
        let info = allocation_counter::measure(|| {
            for view in &views {
                method.extract_edges(view, &mut edges);
            }
        });
        assert!(first > 0);
        info.count_total
    })
}

#[test]
fn a_steady_call_allocates_nothing() {
    for (name, threads) in [("blob:5000", 1), ("blob:300000", 1), ("blob:300000", 2)] {
        assert_eq!(steady_allocations::<BruteForceSimd>(name, threads), 0, "{name}, {threads} threads");
        assert_eq!(steady_allocations::<ClusterCones>(name, threads), 0, "{name}, {threads} threads");
    }
    assert_eq!(steady_allocations::<Randomized>("blob:5000", 1), 0);
}

#[test]
fn moving_a_mesh_again_allocates_nothing() {
    let mesh = prepared(builtin("blob:5000"));
    let mut method: BruteForceSimd = method(&mesh);
    let positions = mesh.mesh().positions();
    let counts = with_threads(1, || {
        [0, 1].map(|_| allocation_counter::measure(|| method.update_positions(positions).unwrap()).count_total)
    });
    assert!(counts[0] > 0, "the counter counts");
    assert_eq!(counts[1], 0);
}
