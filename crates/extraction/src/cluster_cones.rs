//! Silhouette edges in sub-linear time, by skipping clusters of faces that an eye sees from one side.
//!
//! P. Sander, X. Gu, S. Gortler, H. Hoppe, J. Snyder, "Silhouette Clipping", SIGGRAPH 2000, section 4 (a search tree over
//! edges with anchored cones); D. Johnson, E. Cohen, "Spatialized Normal Cone Hierarchies", I3D 2001.
//!
//! 1. Edges are clustered by place and normal: the patches of [`FacePatches`], in the order of an 8-ary tree.
//! 2. Each node bounds the planes of all faces at the edges below it (`cones/`).
//! 3. A view descends the tree level by level; a node whose faces all face one way is skipped with all its edges.
//! 4. The patches that remain are evaluated as by [`BruteForceSimd`](crate::BruteForceSimd), exactly.
//!
//! Departures from Sander et al.: (1) leaves are patches of about 75 edges, tested 64 faces and 32 edges at a time, instead
//! of single edges with a tree built by merging pairs; (2) a ball of normals in place of one cone for front and one for
//! back; (3) bounds hold in floating point, by proof, and what they leave is exact.
//!
//! Cost: O(silhouette patches x log F) per view, so about O(sqrt F) for a shape that is refined; 0.6 bytes per edge beyond
//! [`FacePatches`]; a call allocates nothing once its memory has grown. Failure cases: faces in random order of facing
//! (foliage, noise of a scanner) leave no cluster to skip, and the tree is then a tax of some per cent. The mesh cannot
//! move: bounds would have to be built anew.

use crate::cones::ConeTree;
use crate::edge_order::EdgeOrder;
use crate::loop_scratch::LoopScratch;
use crate::patches::FacePatches;
use crate::sweep::{Far, Harvest, Near, Sweep, share_among_threads};
use silhouette_core::method::{ExtractionStats, PrepareError, Source};
use silhouette_core::prepared::Artefact;
use silhouette_core::{
    ExtractsEdges, ExtractsLoops, FaceId, FacingRule, Method, MethodGuide, MethodInfo, MethodOptions, NoOptions,
    PreparedMesh, Progress, SilhouetteEdges, SilhouetteLoops, Topology, TriangleMesh, Viewpoint,
};
use std::sync::Arc;

/// Patches that a task takes. Silhouettes rarely leave more than a few thousand, so that most views are one task.
const PATCHES_PER_TASK: usize = 2048;

/// Patches up to which a mesh is taken to lie in caches, where asking ahead costs more than it gains: 4.5 MB.
const PATCHES_NEAR: usize = 1 << 12;

/// Finds silhouette edges among those patches that a tree of plane bounds cannot rule out. See the [module](self).
#[derive(Debug)]
pub struct ClusterCones {
    mesh: Arc<TriangleMesh>,
    patches: Arc<FacePatches>,
    tree: ConeTree,
    /// Patches that this view leaves, and the tree's scratch.
    mixed: Vec<u32>,
    queue: Vec<u32>,
    /// One per task.
    harvests: Vec<Harvest>,
    /// Tasks of the last view.
    tasks: usize,
    order: EdgeOrder,
    topology: Arc<Topology>,
    loops: LoopScratch,
}

impl Method for ClusterCones {
    type Options = NoOptions;

    const INFO: MethodInfo = MethodInfo {
        name: "cluster-cones",
        summary: "Skips clusters of faces that all face one way by a tree of plane bounds, evaluates the others; exact.",
        source: Source {
            authors: "P. Sander, X. Gu, S. Gortler, H. Hoppe, J. Snyder",
            title: "Silhouette Clipping",
            venue: "SIGGRAPH",
            year: 2000,
        },
        exact: true,
        needs: &[FacePatches::NAME, Topology::NAME],
        options: NoOptions::SPECS,
        guide: MethodGuide {
            origin: "Sander et al. 2000, Johnson and Cohen 2001",
            yields: "exact edges and loops",
            accuracy: "all edges and no others, to the last bit",
            cost: "grows as F^0.5 to F^0.7 on a shape that is refined",
            memory: "0.6 bytes per edge more than `brute-force-simd`",
            choose_when: "the mesh stays and is seen from many viewpoints: time grows more slowly than the mesh, \
                          which shows above 100 thousand faces",
            limits: "gains nothing on scans, where many clusters hold both facings; does not follow a mesh that \
                     moves",
        },
        published: &[],
    };

    fn prepare(mesh: &Arc<PreparedMesh>, _options: &NoOptions, progress: &dyn Progress) -> Result<Self, PrepareError> {
        let topology = mesh.artefact::<Topology>(Self::INFO.name, progress)?;
        let patches = mesh.artefact::<FacePatches>(Self::INFO.name, progress)?;
        progress.check()?;
        let tree = ConeTree::new(mesh.mesh(), &patches.layout, &patches.planes, progress)?;
        progress.check()?;
        let harvests = vec![Harvest::default(); patches.len().div_ceil(PATCHES_PER_TASK)];
        let order = EdgeOrder::new(topology.edge_count());
        Ok(Self {
            mesh: Arc::clone(mesh.mesh()),
            patches,
            tree,
            mixed: Vec::new(),
            queue: Vec::new(),
            harvests,
            tasks: 0,
            order,
            topology,
            loops: LoopScratch::default(),
        })
    }

    fn bytes(&self) -> usize {
        let scratch = size_of_val(self.mixed.as_slice()) + size_of_val(self.queue.as_slice());
        self.tree.bytes()
            + scratch
            + self.order.bytes()
            + self.loops.bytes()
            + self.harvests.iter().map(Harvest::bytes).sum::<usize>()
    }
}

impl ClusterCones {
    /// [`extract_edges`](ExtractsEdges::extract_edges) by any rule of facing: what no filter is certain of is left to it.
    pub fn extract_edges_by(&mut self, rule: &impl FacingRule, out: &mut SilhouetteEdges) -> ExtractionStats {
        let planes = &self.patches.planes;
        let sweep = Sweep::new(&self.mesh, &self.patches.layout, planes, rule);
        let nodes_visited = self.tree.mixed_patches(rule.viewpoint(), planes.frame(), &mut self.queue, &mut self.mixed);
        let is_far = self.patches.len() > PATCHES_NEAR;
        let tasks = self.mixed.len().div_ceil(PATCHES_PER_TASK);
        let harvests = &mut self.harvests[..tasks];
        share_among_threads(harvests, |task, harvest| {
            let first = task * PATCHES_PER_TASK;
            let patches = &self.mixed[first..self.mixed.len().min(first + PATCHES_PER_TASK)];
            if is_far { sweep.visit(Far(patches), harvest) } else { sweep.visit(Near(patches), harvest) }
        });
        let mut stats = ExtractionStats { nodes_visited, ..ExtractionStats::default() };
        harvests.iter().for_each(|harvest| harvest.add_to(&mut stats));
        self.order.sort(harvests.iter().map(Harvest::edges), out);
        self.tasks = tasks;
        stats
    }

    /// Faces of the last view that were left to exact arithmetic, in any order; those seen edge-on are among them, but for
    /// faces without area.
    pub fn doubtful_faces(&self) -> impl Iterator<Item = FaceId> + '_ {
        self.harvests[..self.tasks].iter().flat_map(|harvest| harvest.doubtful().iter().copied().map(FaceId::new))
    }
}

impl ExtractsEdges for ClusterCones {
    fn extract_edges(&mut self, viewpoint: &Viewpoint, out: &mut SilhouetteEdges) -> ExtractionStats {
        self.extract_edges_by(viewpoint, out)
    }
}

impl ExtractsLoops for ClusterCones {
    fn extract_loops(&mut self, viewpoint: &Viewpoint, out: &mut SilhouetteLoops) -> ExtractionStats {
        let mut loops = std::mem::take(&mut self.loops);
        let mut stats = self.extract_edges(viewpoint, &mut loops.edges);
        let corners = |face| self.mesh.corners(face);
        loops.walk(&self.topology, corners, viewpoint, &mut stats, out);
        self.loops = loops;
        stats
    }
}
