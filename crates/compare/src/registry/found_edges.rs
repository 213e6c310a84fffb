//! [`FoundEdges`]: the silhouette edges of a view and their loops, by vertices.

use super::Prepared;
use silhouette_core::loops::{LoopWalker, start_vertex};
use silhouette_core::method::ExtractionStats;
use silhouette_core::{FaceFacings, SilhouetteEdges, SilhouetteLoops, Topology, TriangleMesh, VertexId, Viewpoint};

/// Silhouette edges, and the loops that they form.
#[derive(Debug, Clone, PartialEq, Eq, Default, serde::Serialize)]
pub struct FoundEdges {
    /// Vertices of each silhouette edge, lower one first, sorted.
    pub edges: Vec<[VertexId; 2]>,
    /// Those that are boundary edges, sorted.
    pub boundary: Vec<[VertexId; 2]>,
    /// Vertices of each loop, in order.
    pub loops: Vec<Vec<VertexId>>,
}

impl Prepared {
    /// The edges that a method finds with their loops, and what finding the edges took; `None` of a method that extracts none. Of one
    /// that finds edges only, the loops are those that hold these edges.
    pub fn find_edges(
        &mut self,
        mesh: &TriangleMesh,
        topology: &Topology,
        viewpoint: &Viewpoint,
    ) -> Option<(FoundEdges, ExtractionStats)> {
        let mut edges = SilhouetteEdges::default();
        let stats = self.edges()?.extract_edges(viewpoint, &mut edges);
        let loops = self.find_loops(&edges, mesh, topology, viewpoint);
        let found = FoundEdges {
            edges: edges.iter().map(|edge| topology.end_points(edge)).collect(),
            boundary: edges.boundary(topology).map(|edge| topology.end_points(edge)).collect(),
            loops: loops
                .iter()
                .map(|half_edges| half_edges.iter().map(|&at| start_vertex(mesh, at)).collect())
                .collect(),
        };
        Some((found, stats))
    }

    /// The loops that a method finds; of one that finds edges only, the loops that hold these.
    fn find_loops(
        &mut self,
        edges: &SilhouetteEdges,
        mesh: &TriangleMesh,
        topology: &Topology,
        viewpoint: &Viewpoint,
    ) -> SilhouetteLoops {
        let mut loops = SilhouetteLoops::default();
        if let Some(method) = self.loops() {
            method.extract_loops(viewpoint, &mut loops);
        } else {
            LoopWalker::default().walk(topology, &FaceFacings::new(mesh, viewpoint), edges, &mut loops);
        }
        loops
    }
}
