//! Brute force as fast as memory allows: every face of every patch, 64 at a time, on all cores.
//!
//! The definition is Hall's ("Silhouette Tracking", 2003, Definitions): a silhouette edge lies between a front and a back
//! face. The data layout is our own:
//!
//! 1. faces and edges lie in self-contained patches ([`FacePatches`]);
//! 2. the facing of a patch's lanes is one word, from planes in 16-bit integers; what their proven bound leaves open (one
//!    face in twenty thousand) is decided by [`silhouette_core::facing::judge`], so the result is exact;
//! 3. a patch that faces one way has no silhouette edge; in the others, edges are tested 32 at a time without a branch;
//! 4. a radix sort puts the ids in order in linear time.
//!
//! Steps 2 and 3 are compiled for several instruction sets, of which the widest that the processor has is chosen at run
//! time (`pulp`); all arithmetic is on integers, so it yields the same bits on all.
//!
//! Departures: none from the definition; a face in the halo of a patch is evaluated again there, which costs a quarter
//! more planes and saves all synchronisation and every look at another patch.
//!
//! Cost: O(F + S) per view, about 10 bytes read per face; a call allocates nothing once its memory has grown. Moving meshes:
//! [`ExtractsMovingEdges`]. Failure cases: a mesh whose faces are mostly needles goes mostly through `judge`, which is
//! still exact and some fifteen times slower.

use crate::edge_order::EdgeOrder;
use crate::loop_scratch::LoopScratch;
use crate::patches::{FacePatches, PatchPlanes};
use crate::sweep::{Harvest, Sweep, share_among_threads};
use rayon::prelude::*;
use silhouette_core::glam::Vec3;
use silhouette_core::method::{ExtractionStats, ExtractsMovingEdges, PositionsError, PrepareError, Source};
use silhouette_core::prepared::Artefact;
use silhouette_core::{
    ExtractsEdges, ExtractsLoops, FaceId, Method, MethodGuide, MethodInfo, MethodOptions, NoOptions, PreparedMesh,
    Progress, SilhouetteEdges, SilhouetteLoops, Topology, TriangleMesh, VertexId, Viewpoint,
};
use std::sync::Arc;

/// Patches that a task takes: about 70 microseconds of work, so that a mesh of a hundred thousand faces stays on one
/// thread and larger ones spread evenly.
const PATCHES_PER_TASK: usize = 2048;

/// Finds silhouette edges by testing all faces, 64 at a time. See the [module](self).
#[derive(Debug, Clone)]
pub struct BruteForceSimd {
    mesh: Arc<TriangleMesh>,
    patches: Arc<FacePatches>,
    /// This frame's positions and planes, if the mesh has moved.
    moved: Option<Moved>,
    /// One per task.
    harvests: Vec<Harvest>,
    order: EdgeOrder,
    topology: Arc<Topology>,
    loops: LoopScratch,
}

#[derive(Debug, Clone)]
struct Moved {
    positions: Vec<Vec3>,
    planes: PatchPlanes,
}

impl Method for BruteForceSimd {
    type Options = NoOptions;

    const INFO: MethodInfo = MethodInfo {
        name: "brute-force-simd",
        summary: "Classifies every face, 64 at a time from 16-bit planes, and tests edges only where facings differ; exact.",
        source: Source { authors: "T. Hall", title: "Silhouette Tracking", venue: "bytegeist.com", year: 2003 },
        exact: true,
        needs: &[FacePatches::NAME, Topology::NAME],
        options: NoOptions::SPECS,
        guide: MethodGuide {
            origin: "Hall's definition; data layout our own",
            yields: "exact edges and loops",
            accuracy: "all edges and no others, to the last bit",
            cost: "O(F + S), all threads",
            memory: "18 bytes per edge for patches, 11 of them beyond the edge table",
            choose_when: "you want all edges of a view at the speed of memory, whatever the view before; of a mesh \
                          that moves a little in each frame `tracking-exact` has them sooner (`cargo bench --bench \
                          kernels -- moving`), if its topology can be tracked",
            limits: "evaluates every face in every view: time grows with the mesh, however short its silhouette is",
        },
        published: &[],
    };

    fn prepare(mesh: &Arc<PreparedMesh>, _options: &NoOptions, progress: &dyn Progress) -> Result<Self, PrepareError> {
        let topology = mesh.artefact::<Topology>(Self::INFO.name, progress)?;
        let patches = mesh.artefact::<FacePatches>(Self::INFO.name, progress)?;
        let harvests = vec![Harvest::default(); patches.len().div_ceil(PATCHES_PER_TASK)];
        let order = EdgeOrder::new(topology.edge_count());
        Ok(Self {
            mesh: Arc::clone(mesh.mesh()),
            patches,
            moved: None,
            harvests,
            order,
            topology,
            loops: LoopScratch::default(),
        })
    }

    fn bytes(&self) -> usize {
        let harvests: usize = self.harvests.iter().map(Harvest::bytes).sum();
        let moved = self.moved.as_ref();
        let moved = moved.map_or(0, |moved| size_of_val(moved.positions.as_slice()) + moved.planes.bytes());
        self.order.bytes() + self.loops.bytes() + harvests + moved
    }
}

impl ExtractsEdges for BruteForceSimd {
    fn extract_edges(&mut self, viewpoint: &Viewpoint, out: &mut SilhouetteEdges) -> ExtractionStats {
        let planes = self.moved.as_ref().map_or(&self.patches.planes, |moved| &moved.planes);
        let mut sweep = Sweep::new(&self.mesh, &self.patches.layout, planes, viewpoint);
        if let Some(moved) = &self.moved {
            sweep.positions = &moved.positions;
        }
        let patches = self.patches.len();
        share_among_threads(&mut self.harvests, |task, harvest| {
            let first = task * PATCHES_PER_TASK;
            sweep.visit(first..patches.min(first + PATCHES_PER_TASK), harvest);
        });
        let mut stats = ExtractionStats::default();
        let harvests = &self.harvests;
        harvests.iter().for_each(|harvest| harvest.add_to(&mut stats));
        self.order.sort(harvests.iter().map(Harvest::edges), out);
        stats
    }
}

impl ExtractsMovingEdges for BruteForceSimd {
    fn update_positions(&mut self, positions: &[Vec3]) -> Result<(), PositionsError> {
        let vertices = self.mesh.vertex_count();
        if positions.len() != vertices {
            return Err(PositionsError::Count { given: positions.len(), vertices });
        }
        if let Some(vertex) = positions.par_iter().position_first(|position| !position.is_finite()) {
            return Err(PositionsError::NotFinite { vertex: VertexId::from_usize(vertex) });
        }
        let moved = self.moved.get_or_insert_with(|| Moved { positions: Vec::new(), planes: PatchPlanes::default() });
        moved.positions.clear();
        moved.positions.extend_from_slice(positions);
        moved.planes.compute(&self.patches.layout, self.mesh.triangles(), positions);
        Ok(())
    }
}

impl ExtractsLoops for BruteForceSimd {
    fn extract_loops(&mut self, viewpoint: &Viewpoint, out: &mut SilhouetteLoops) -> ExtractionStats {
        let mut loops = std::mem::take(&mut self.loops);
        let mut stats = self.extract_edges(viewpoint, &mut loops.edges);
        let positions = self.moved.as_ref().map_or(self.mesh.positions(), |moved| &moved.positions);
        let corners = |face: FaceId| self.mesh.triangles()[face.index()].map(|vertex| positions[vertex as usize]);
        loops.walk(&self.topology, corners, viewpoint, &mut stats, out);
        self.loops = loops;
        stats
    }
}
