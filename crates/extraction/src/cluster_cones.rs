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
//! Cost: O(silhouette patches x log F) a view, so about O(sqrt F) for a shape that is refined; half a byte an edge beyond
//! [`FacePatches`]; a call allocates nothing once its memory has grown. Failure cases: faces in random order of facing
//! (foliage, noise of a scanner) leave no cluster to skip, and the tree is then a tax of some per cent. The mesh cannot
//! move: bounds would have to be built anew.

use crate::cones::ConeTree;
use crate::edge_order::EdgeOrder;
use crate::loop_scratch::LoopScratch;
use crate::patches::FacePatches;
use crate::sweep::{Harvest, Sweep};
use rayon::prelude::*;
use silhouette_core::method::{ExtractionStats, OptionValues, PrepareError, Source};
use silhouette_core::prepared::Artefact;
use silhouette_core::{
    ExtractsEdges, ExtractsLoops, Method, MethodInfo, PreparedMesh, Progress, SilhouetteEdges, SilhouetteLoops,
    Topology, TriangleMesh, Viewpoint,
};
use std::sync::Arc;

/// Patches that a task takes. Silhouettes rarely leave more than a few thousand, so tasks are small.
const PATCHES_PER_TASK: usize = 1024;

/// Patches from which a mesh is taken to lie in main memory: 36 MB with their edges, the last-level cache of a workstation.
/// There a batch is read ahead of its visits, which takes a tenth (3 million faces) to a third (10 million) off a view;
/// in caches it would add as much.
const PATCHES_BEYOND_CACHES: usize = 1 << 15;

/// Patches read ahead: 17 cache lines each, more than any core has misses in flight, and all fit the first-level cache.
const TOUCHED_AT_ONCE: usize = 16;

/// Finds silhouette edges among those patches that a tree of plane bounds cannot rule out. See the [module](self).
#[derive(Debug)]
pub struct ClusterCones {
    mesh: Arc<TriangleMesh>,
    patches: Arc<FacePatches>,
    tree: ConeTree,
    /// Whether the patches lie beyond the caches, so that they are read ahead of their visits.
    reads_ahead: bool,
    /// Patches that this view leaves, and the tree's scratch.
    mixed: Vec<u32>,
    queue: Vec<u32>,
    /// One a task.
    harvests: Vec<Harvest>,
    order: EdgeOrder,
    topology: Arc<Topology>,
    loops: LoopScratch,
}

impl Method for ClusterCones {
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
        options: &[],
    };

    fn prepare(
        mesh: &Arc<PreparedMesh>,
        _options: &OptionValues,
        progress: &dyn Progress,
    ) -> Result<Self, PrepareError> {
        let topology = mesh.artefact::<Topology>(Self::INFO.name, progress)?;
        let patches = mesh.artefact::<FacePatches>(Self::INFO.name, progress)?;
        progress.check()?;
        let tree = ConeTree::new(mesh.mesh(), &patches.layout, &patches.planes);
        let harvests = vec![Harvest::default(); patches.len().div_ceil(PATCHES_PER_TASK)];
        let order = EdgeOrder::new(topology.edge_count());
        Ok(Self {
            mesh: Arc::clone(mesh.mesh()),
            reads_ahead: patches.len() > PATCHES_BEYOND_CACHES,
            patches,
            tree,
            mixed: Vec::new(),
            queue: Vec::new(),
            harvests,
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

impl ExtractsEdges for ClusterCones {
    fn extract_edges(&mut self, viewpoint: &Viewpoint, out: &mut SilhouetteEdges) -> ExtractionStats {
        let planes = &self.patches.planes;
        let sweep = Sweep::new(&self.mesh, &self.patches.layout, planes, viewpoint);
        let nodes_visited = self.tree.mixed_patches(viewpoint, planes.frame(), &mut self.queue, &mut self.mixed);
        let reads_ahead = self.reads_ahead;
        let batch = if reads_ahead { TOUCHED_AT_ONCE } else { PATCHES_PER_TASK };
        let tasks = self.mixed.len().div_ceil(PATCHES_PER_TASK);
        let work = |(patches, harvest): (&[u32], &mut Harvest)| {
            harvest.clear();
            for batch in patches.chunks(batch) {
                let batch = batch.iter().map(|&patch| patch as usize);
                if reads_ahead {
                    sweep.touch(batch.clone());
                }
                let lanes = batch.clone().map(|patch| u64::from(planes.open[patch].count_ones()));
                harvest.stats.faces_tested += lanes.sum::<u64>();
                sweep.visit(batch, harvest);
            }
        };
        match &mut self.harvests[..tasks] {
            [] => {}
            [only] => work((&self.mixed, only)),
            several => self.mixed.par_chunks(PATCHES_PER_TASK).zip(several).for_each(work),
        }
        let mut stats = ExtractionStats { nodes_visited, ..ExtractionStats::default() };
        let harvests = &self.harvests[..tasks];
        harvests.iter().for_each(|harvest| harvest.add_to(&mut stats));
        self.order.sort(harvests.iter().map(Harvest::edges), out);
        stats
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

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::glam::Vec3;
    use silhouette_core::{NoProgress, shapes};

    #[test]
    fn reading_ahead_changes_nothing() {
        let mesh = Arc::new(PreparedMesh::new(shapes::by_name("blob:20000").unwrap()));
        let options = OptionValues::defaults(ClusterCones::INFO.options);
        let mut method = ClusterCones::prepare(&mesh, &options, &NoProgress).unwrap();
        let view = Viewpoint::Perspective { eye: Vec3::new(0.5, 3.0, 1.0) };
        let mut extract = |reads_ahead| {
            method.reads_ahead = reads_ahead;
            let mut edges = SilhouetteEdges::default();
            let stats = method.extract_edges(&view, &mut edges);
            (edges, stats)
        };
        let (edges, stats) = extract(false);
        assert!(edges.len() > 100);
        assert_eq!(extract(true), (edges, stats));
    }
}
