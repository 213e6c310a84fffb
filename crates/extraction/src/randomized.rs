//! Some of the silhouette, for a small and chosen effort: random probes, completed along the silhouette.
//!
//! L. Markosian, M. Kowalski, S. Trychin, L. Bourdev, D. Goldstein, J. Hughes, "Real-Time Nonphotorealistic Rendering",
//! SIGGRAPH 1997, section 3.1, as T. Hall sums it up ("Silhouette Tracking", 2003, Introduction):
//!
//! 1. temporal coherence: the silhouette edges of the last view are tested first;
//! 2. random probes: a share of all edges, chosen anew in each view, is tested;
//! 3. spatial coherence: from each silhouette edge that a test finds, the silhouette is walked along until it closes.
//!
//! So every loop is found whole or not at all, and long loops are found with near certainty; small ones, on a mesh of many
//! bumps, are what it misses. Recall is measured against brute force in a comparison; nothing is promised here.
//!
//! Departures: (1) facings are exact, and each face is evaluated once per view, which is why walks always close; (2) probes
//! are uniform, where Markosian et al. prefer edges with a sharp dihedral angle; (3) all of the last silhouette is tested,
//! not a share of it, since an edge on a loop that was just walked costs one look.
//!
//! Cost: O(probes + S + faces in the fans around silhouette vertices) per view, whatever the size of the mesh; one byte
//! per face and one bit per half-edge of memory; a call allocates nothing once its memory has grown. The same seed and the same
//! sequence of views give the same edges, on any machine.

use crate::edge_order::EdgeOrder;
use silhouette_core::loops::next_silhouette_half_edge;
use silhouette_core::method::{ExtractionStats, PrepareError, Source};
use silhouette_core::prepared::Artefact;
use silhouette_core::silhouette::is_silhouette_edge_where;
use silhouette_core::{
    EdgeId, ExtractsEdges, FacingMemo, HalfEdgeId, Method, MethodGuide, MethodInfo, MethodOptions, PreparedMesh,
    Progress, SilhouetteEdges, Topology, TriangleMesh, Viewpoint,
};
use std::sync::Arc;

/// Finds the silhouette loops that random probes, or the last view's edges, hit. See the [module](self).
#[derive(Debug, Clone)]
pub struct Randomized {
    mesh: Arc<TriangleMesh>,
    topology: Arc<Topology>,
    /// Edges tested at random in each view.
    probes: u64,
    random: SplitMix64,
    memo: FacingMemo,
    /// Edges found in the last view, and in this one.
    last: Vec<u32>,
    found: Vec<u32>,
    /// Half-edges walked in this view: a bit each, zero between views, and a list of them.
    walked: Vec<u64>,
    path: Vec<HalfEdgeId>,
    order: EdgeOrder,
}

silhouette_core::method_options! {
    /// Options of [`Randomized`].
    pub struct RandomizedOptions {
        /// Share of all edges that each view tests at random; 0 only follows the last view, 1 is slower than brute force and
        /// still misses some loops.
        pub probes: f64 = number("probes", 0.0..=1.0, default 0.01, sweep log 0.001..=0.3),
        /// Start of the random sequence; any whole number is as good as another.
        pub seed: u32 = whole("seed", 0..=4_294_967_295, default 1),
    }
}

impl Method for Randomized {
    type Options = RandomizedOptions;

    const INFO: MethodInfo = MethodInfo {
        name: "randomized",
        summary: "Tests the last view's edges and some random ones, then walks along the silhouette; finds whole loops or none.",
        source: Source {
            authors: "L. Markosian, M. Kowalski, S. Trychin, L. Bourdev, D. Goldstein, J. Hughes",
            title: "Real-Time Nonphotorealistic Rendering",
            venue: "SIGGRAPH",
            year: 1997,
        },
        exact: false,
        needs: &[Topology::NAME],
        options: RandomizedOptions::SPECS,
        guide: MethodGuide {
            origin: "Markosian et al. 1997",
            yields: "most edges, whole loops",
            accuracy: "no: its recall is measured, 0.90 to 0.99 over a turn, by mesh",
            cost: "O(probes + S)",
            memory: "3 bytes per edge beyond topology",
            choose_when: "missing some small loops is a fair price for not looking at every face, and there is no \
                          time to prepare",
            limits: "misses small loops; probes are a share of the edges by default, so that its time grows with the \
                     mesh",
        },
        published: &[],
    };

    fn prepare(
        mesh: &Arc<PreparedMesh>,
        options: &RandomizedOptions,
        progress: &dyn Progress,
    ) -> Result<Self, PrepareError> {
        options.validate()?;
        let topology = mesh.artefact::<Topology>(Self::INFO.name, progress)?;
        let edges = topology.edge_count();
        Ok(Self {
            mesh: Arc::clone(mesh.mesh()),
            probes: (options.probes * edges as f64).ceil() as u64,
            random: SplitMix64(options.seed.into()),
            memo: FacingMemo::default(),
            last: Vec::new(),
            found: Vec::new(),
            walked: vec![0; topology.half_edge_count().div_ceil(64)],
            path: Vec::new(),
            order: EdgeOrder::new(edges),
            topology,
        })
    }

    fn bytes(&self) -> usize {
        let lists = size_of_val(self.last.as_slice()) + size_of_val(self.found.as_slice());
        let walks = size_of_val(self.walked.as_slice()) + size_of_val(self.path.as_slice());
        self.memo.bytes() + lists + walks + self.order.bytes()
    }
}

impl Randomized {
    /// Tests an edge and walks the loops through it that were not walked yet.
    fn probe(&mut self, edge: EdgeId, viewpoint: &Viewpoint, stats: &mut ExtractionStats) {
        let Self { mesh, topology, memo, found, walked, path, .. } = self;
        let mut is_front = |face| memo.is_front(face, |face| mesh.corners(face), viewpoint, stats);
        if !is_silhouette_edge_where(topology, &mut is_front, edge) {
            return;
        }
        for &start in topology.half_edges(edge) {
            if !is_front(start.face()) {
                continue;
            }
            let mut half_edge = start;
            // A loop is a cycle of a permutation: a walk that was begun ends where it began, and one that meets a walked
            // half-edge at once has been walked as a whole.
            while walked[half_edge.index() / 64] >> (half_edge.index() % 64) & 1 == 0 {
                walked[half_edge.index() / 64] |= 1 << (half_edge.index() % 64);
                path.push(half_edge);
                found.push(topology.edge_of(half_edge).get());
                let is_silhouette = |is_front: &mut _, edge| is_silhouette_edge_where(topology, is_front, edge);
                half_edge = next_silhouette_half_edge(topology, &mut is_front, is_silhouette, half_edge);
            }
        }
    }
}

impl ExtractsEdges for Randomized {
    fn extract_edges(&mut self, viewpoint: &Viewpoint, out: &mut SilhouetteEdges) -> ExtractionStats {
        let edges = self.topology.edge_count() as u64;
        let mut stats = ExtractionStats::default();
        self.memo.begin_view(self.mesh.face_count());
        self.last.clear();
        self.last.append(&mut self.found);
        for index in 0..self.last.len() {
            self.probe(EdgeId::new(self.last[index]), viewpoint, &mut stats);
        }
        let probes = if edges == 0 { 0 } else { self.probes };
        for _ in 0..probes {
            let edge = EdgeId::new(self.random.below(edges) as u32);
            self.probe(edge, viewpoint, &mut stats);
        }
        stats.edges_tested = self.last.len() as u64 + probes + self.path.len() as u64;
        for half_edge in self.path.drain(..) {
            self.walked[half_edge.index() / 64] = 0;
        }
        self.order.sort([self.found.as_slice()].into_iter(), out);
        stats
    }
}

/// Steele, Lea and Flood's generator ("Fast Splittable Pseudorandom Number Generators", 2014): eight bytes of state, and
/// the same sequence on every machine.
#[derive(Debug, Clone)]
struct SplitMix64(u64);

impl SplitMix64 {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    /// A number below `limit`, whose bias of less than `limit / 2^64` no probe can notice.
    fn below(&mut self, limit: u64) -> u64 {
        ((u128::from(self.next()) * u128::from(limit)) >> 64) as u64
    }
}
