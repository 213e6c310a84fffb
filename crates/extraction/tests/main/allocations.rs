use crate::scenes::prepare;
use silhouette_core::glam::Vec3;
use silhouette_core::method::ExtractsMovingEdges;
use silhouette_core::{ExtractsEdges, Method, PreparedMesh, SilhouetteEdges, Viewpoint};
use silhouette_extraction::{BruteForceSimd, ClusterCones, Randomized};
use std::sync::Arc;

fn orbit() -> Vec<Viewpoint> {
    let eye = |i: u8| Vec3::new((f32::from(i) * 0.4).cos() * 3.0, 0.5, (f32::from(i) * 0.4).sin() * 3.0);
    (0..16).map(|i| Viewpoint::Perspective { eye: eye(i) }).collect()
}

/// Allocations of all views of an orbit that was flown twice before: what grows grew.
fn steady_allocations<M: Method + ExtractsEdges>(faces: &str, threads: usize) -> u64 {
    let mesh = Arc::new(PreparedMesh::new(silhouette_core::shapes::by_name(faces).unwrap()));
    let mut method: M = prepare(&mesh);
    let mut edges = SilhouetteEdges::default();
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    pool.install(|| {
        let mut fly = || orbit().iter().map(|view| method.extract_edges(view, &mut edges).faces_tested).sum::<u64>();
        let first = fly() + fly();
        let views = orbit();
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
    for (faces, threads) in [("blob:5000", 1), ("blob:300000", 1), ("blob:300000", 2)] {
        assert_eq!(steady_allocations::<BruteForceSimd>(faces, threads), 0, "{faces}, {threads} threads");
        assert_eq!(steady_allocations::<ClusterCones>(faces, threads), 0, "{faces}, {threads} threads");
    }
    assert_eq!(steady_allocations::<Randomized>("blob:5000", 1), 0);
}

#[test]
fn moving_a_mesh_again_allocates_nothing() {
    let mesh = Arc::new(PreparedMesh::new(silhouette_core::shapes::by_name("blob:5000").unwrap()));
    let mut method: BruteForceSimd = prepare(&mesh);
    let positions = mesh.mesh().positions();
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    let counts = pool.install(|| {
        [0, 1].map(|_| allocation_counter::measure(|| method.update_positions(positions).unwrap()).count_total)
    });
    assert!(counts[0] > 0, "the counter counts");
    assert_eq!(counts[1], 0);
}
