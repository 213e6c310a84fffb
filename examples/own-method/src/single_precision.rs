//! The method: facing in 32-bit arithmetic, without a filter. Fast to write, and wrong where a face is seen nearly edge-on.

use silhouette_core::method::{ExtractionStats, Method, MethodGuide, MethodInfo, NoOptions, PrepareError, Source};
use silhouette_core::silhouette::is_silhouette_edge_where;
use silhouette_core::{
    EdgeId, ExtractsEdges, FaceId, PreparedMesh, Progress, SilhouetteEdges, Topology, TriangleMesh, Viewpoint,
};
use std::sync::Arc;

/// Every face's plane at the eye, in 32 bits.
pub struct SinglePrecision {
    mesh: Arc<TriangleMesh>,
    topology: Arc<Topology>,
}

impl Method for SinglePrecision {
    type Options = NoOptions;

    const INFO: MethodInfo = MethodInfo {
        name: "single-precision",
        summary: "Brute force with every plane evaluated in 32-bit arithmetic.",
        source: Source { authors: "this example", title: "Single precision", venue: "examples/own-method", year: 2026 },
        exact: false,
        needs: &["topology"],
        options: &[],
        guide: MethodGuide {
            origin: "an example",
            yields: "most edges",
            accuracy: "no: planes are evaluated in 32 bits, so that faces near edge-on may face either way",
            cost: "O(F), one thread",
            memory: "none beyond topology",
            choose_when: "you want to see how a method is added",
            limits: "wrong where a plane passes the viewpoint closer than rounding",
        },
        published: &[],
    };

    fn prepare(mesh: &Arc<PreparedMesh>, _options: &NoOptions, progress: &dyn Progress) -> Result<Self, PrepareError> {
        let topology = mesh.artefact::<Topology>(Self::INFO.name, progress)?;
        Ok(Self { mesh: Arc::clone(mesh.mesh()), topology })
    }

    fn bytes(&self) -> usize {
        0
    }
}

impl ExtractsEdges for SinglePrecision {
    fn extract_edges(&mut self, viewpoint: &Viewpoint, out: &mut SilhouetteEdges) -> ExtractionStats {
        let is_front = |face: FaceId| {
            let [a, b, c] = self.mesh.triangles()[face.index()].map(|vertex| self.mesh.positions()[vertex as usize]);
            let toward_viewer = match *viewpoint {
                Viewpoint::Perspective { eye } => eye - a,
                Viewpoint::Orthographic { toward_viewer } => toward_viewer,
            };
            (b - a).cross(c - a).dot(toward_viewer) > 0.0
        };
        let edges = (0..self.topology.edge_count()).map(EdgeId::from_usize);
        out.refill_ascending(edges.filter(|&edge| is_silhouette_edge_where(&self.topology, is_front, edge)));
        let edges_tested = self.topology.edge_count() as u64;
        ExtractionStats { faces_tested: 2 * edges_tested, edges_tested, ..ExtractionStats::default() }
    }
}
