//! One view of one mesh, with everything that brute force says about it.

use silhouette_core::{
    ExtractsEdges, ExtractsLoops, FaceFacings, SilhouetteEdges, SilhouetteLoops, Topology, TriangleMesh, Viewpoint,
};
use silhouette_extraction::BruteForce;
use silhouette_testing::prepare::{artefact, method, prepared};
use std::sync::Arc;

/// Facings, edges and loops of a view.
pub struct Seen {
    pub topology: Arc<Topology>,
    pub facings: FaceFacings,
    pub edges: SilhouetteEdges,
    pub loops: SilhouetteLoops,
}

/// Brute force on one view.
pub fn look(mesh: &TriangleMesh, viewpoint: &Viewpoint) -> Seen {
    let prepared = prepared(mesh.clone());
    let mut method: BruteForce = method(&prepared);
    let (mut edges, mut loops) = (SilhouetteEdges::default(), SilhouetteLoops::default());
    method.extract_edges(viewpoint, &mut edges);
    method.extract_loops(viewpoint, &mut loops);
    Seen { topology: artefact(&prepared), facings: FaceFacings::new(mesh, viewpoint), edges, loops }
}
