//! Loops through some of the silhouette edges, as a method yields them that may miss some.

use silhouette_core::glam::Vec3;
use silhouette_core::loops::LoopWalker;
use silhouette_core::{FaceFacings, SilhouetteEdges, SilhouetteLoops, Topology};
use silhouette_testing::views::seen_from;
use silhouette_testing::{Random, zoo};

/// A walk passes non-manifold edges that were not found, and ends all the same, having met silhouette edges only.
#[test]
fn walks_end_whichever_edges_were_found() {
    let mut walker = LoopWalker::default();
    for (name, mesh) in zoo::all() {
        let topology = Topology::new(&mesh);
        let reach = mesh.bounds().unwrap().radius as f32;
        for eye in [[3.0, 2.0, 1.0], [0.0, 0.0, 3.0], [0.1, 0.05, 0.02]] {
            let facings = FaceFacings::new(&mesh, &seen_from(Vec3::from(eye) * reach));
            let all = SilhouetteEdges::of(&topology, &facings);
            let mut random = Random::new(1);
            for share in [0.05, 0.5, 0.95] {
                let mut some = SilhouetteEdges::default();
                some.refill(all.iter().filter(|_| random.unit() < share));
                let mut loops = SilhouetteLoops::default();
                walker.walk(&topology, &facings, &some, &mut loops);
                let mut walked: Vec<_> = loops.half_edges().iter().map(|&side| topology.edge_of(side)).collect();
                assert!(walked.iter().all(|&edge| all.contains(edge)), "{name}");
                walked.sort_unstable();
                assert!(some.iter().all(|edge| walked.binary_search(&edge).is_ok()), "{name}: an edge in no loop");
            }
        }
    }
}
