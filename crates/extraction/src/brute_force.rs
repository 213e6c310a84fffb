//! The baseline that Hall (2003) measures silhouette tracking against, deliberately naive.
//!
//! T. Hall, "Silhouette Tracking", 2003, sections Introduction and Definitions:
//!
//! 1. classify every face as front or back by its plane equation at the eye,
//! 2. test the three edges of every front face: an edge across which there is a back face, or none, is a silhouette edge.
//!
//! Departures: (1) the sign of the plane equation is exact; (2) an edge with three or more faces is a silhouette edge iff
//! its faces do not all face the same way (Hall excludes such meshes); (3) an edge is reported once, by id, ascending.
//!
//! One thread, no acceleration: every other method must equal this one, so its code has to be obviously right.

use silhouette_core::facing::judge;
use silhouette_core::id::{FaceId, HalfEdgeId};
use silhouette_core::loops::LoopWalker;
use silhouette_core::method::{ExtractionStats, PrepareError, Source};
use silhouette_core::prepared::Artefact;
use silhouette_core::silhouette::is_silhouette_edge;
use silhouette_core::{
    ExtractsEdges, ExtractsLoops, FaceFacings, Method, MethodGuide, MethodInfo, MethodOptions, NoOptions, PreparedMesh,
    Progress, SilhouetteEdges, SilhouetteLoops, Topology, TriangleMesh, Viewpoint,
};
use std::sync::Arc;

/// Finds silhouette edges by looking at every face and at every edge of the front ones. See the [module](self).
///
/// O(F + S log S) per view; F bits of scratch.
#[derive(Debug, Clone)]
pub struct BruteForce {
    mesh: Arc<TriangleMesh>,
    topology: Arc<Topology>,
    facings: FaceFacings,
    /// Edges of the last loop extraction.
    loop_edges: SilhouetteEdges,
    walker: LoopWalker,
    found: Vec<silhouette_core::EdgeId>,
}

impl Method for BruteForce {
    type Options = NoOptions;

    const INFO: MethodInfo = MethodInfo {
        name: "brute-force",
        summary: "Classifies every face, then tests every edge of the front ones; one thread, the oracle of all others.",
        source: Source { authors: "T. Hall", title: "Silhouette Tracking", venue: "bytegeist.com", year: 2003 },
        exact: true,
        needs: &[Topology::NAME],
        options: NoOptions::SPECS,
        guide: MethodGuide {
            origin: "Hall 2003, as its baseline",
            yields: "exact edges and loops",
            accuracy: "all edges and no others, to the last bit",
            cost: "O(F + S log S), one thread",
            memory: "36 bytes per edge, all of it topology",
            choose_when: "you want the plainest code that is right: the oracle of all others",
            limits: "evaluates every face in every view, on one thread",
        },
        published: &[],
    };

    fn prepare(mesh: &Arc<PreparedMesh>, _options: &NoOptions, progress: &dyn Progress) -> Result<Self, PrepareError> {
        Ok(Self {
            mesh: Arc::clone(mesh.mesh()),
            topology: mesh.artefact(Self::INFO.name, progress)?,
            facings: FaceFacings::default(),
            loop_edges: SilhouetteEdges::default(),
            walker: LoopWalker::default(),
            found: Vec::new(),
        })
    }

    fn bytes(&self) -> usize {
        self.facings.bytes() + self.walker.bytes() + size_of_val(self.found.as_slice())
    }
}

impl BruteForce {
    /// Step 1: the facing of every face. Yields the number of exact fallbacks.
    fn classify(&mut self, viewpoint: &Viewpoint) -> u64 {
        let faces = self.mesh.face_count();
        self.facings.clear(faces);
        let mut exact_fallbacks = 0;
        for face in (0..faces).map(FaceId::from_usize) {
            let judgement = judge(self.mesh.corners(face), viewpoint);
            self.facings.set(face, judgement.facing);
            exact_fallbacks += u64::from(judgement.exact_fallback);
        }
        exact_fallbacks
    }

    /// Step 2: the silhouette edges among those of front faces. Yields the number of edge tests.
    fn test_edges(&mut self) -> u64 {
        self.found.clear();
        let mut edges_tested = 0;
        for face in (0..self.mesh.face_count()).map(FaceId::from_usize) {
            if !self.facings.is_front(face) {
                continue;
            }
            for slot in 0..3 {
                let edge = self.topology.edge_of(HalfEdgeId::of(face, slot));
                let first = self.topology.half_edges(edge)[0].face();
                edges_tested += 1;
                // At an edge with k faces the first of them speaks for all, or k front faces would look at k faces each.
                let differs_from_first = !self.facings.is_front(first);
                if differs_from_first || first == face && is_silhouette_edge(&self.topology, &self.facings, edge) {
                    self.found.push(edge);
                }
            }
        }
        edges_tested
    }
}

impl ExtractsEdges for BruteForce {
    fn extract_edges(&mut self, viewpoint: &Viewpoint, out: &mut SilhouetteEdges) -> ExtractionStats {
        let exact_fallbacks = self.classify(viewpoint);
        let edges_tested = self.test_edges();
        out.refill(self.found.iter().copied());
        ExtractionStats {
            faces_tested: self.mesh.face_count() as u64,
            edges_tested,
            exact_fallbacks,
            ..ExtractionStats::default()
        }
    }
}

impl ExtractsLoops for BruteForce {
    fn extract_loops(&mut self, viewpoint: &Viewpoint, out: &mut SilhouetteLoops) -> ExtractionStats {
        let mut edges = std::mem::take(&mut self.loop_edges);
        let stats = self.extract_edges(viewpoint, &mut edges);
        self.walker.walk(&self.topology, &self.facings, &edges, out);
        self.loop_edges = edges;
        stats
    }
}
