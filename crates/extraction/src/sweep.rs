//! The work on one patch, shared by the methods that differ only in which patches they visit.

use crate::kernels::{Kernel, KernelTask, dispatch};
use crate::patches::planes::PlaneTest;
use crate::patches::{PAIRS, PatchLayout, PatchPlanes};
use pulp::Arch;
use rayon::prelude::*;
use silhouette_core::TriangleMesh;
use silhouette_core::facing::{Facing, FacingRule};
use silhouette_core::glam::Vec3;
use silhouette_core::method::ExtractionStats;
use std::ops::Range;

/// One view of a patched mesh.
#[derive(Clone, Copy)]
pub(crate) struct Sweep<'a, R> {
    pub(crate) layout: &'a PatchLayout,
    pub(crate) planes: &'a PatchPlanes,
    pub(crate) triangles: &'a [[u32; 3]],
    pub(crate) positions: &'a [Vec3],
    pub(crate) rule: &'a R,
    pub(crate) test: PlaneTest,
    arch: Arch,
}

/// What visits have found and done so far.
#[derive(Debug, Clone, Default)]
pub(crate) struct Harvest {
    /// Room for edges, of which the first `len` count: growing it in steps keeps the inner loop free of it.
    edges: Vec<u32>,
    len: usize,
    pub(crate) stats: ExtractionStats,
    /// Patches that wait for exact facings, and what is open about them.
    open_patches: Vec<OpenPatch>,
    doubts: Vec<Doubt>,
    /// Faces that were left to exact arithmetic.
    doubtful: Vec<u32>,
}

impl Harvest {
    pub(crate) fn clear(&mut self) {
        self.len = 0;
        self.stats = ExtractionStats::default();
        self.doubtful.clear();
    }

    /// Faces that were left to exact arithmetic, in any order.
    pub(crate) fn doubtful(&self) -> &[u32] {
        &self.doubtful
    }

    /// Silhouette edges in any order, a non-manifold one possibly several times.
    pub(crate) fn edges(&self) -> &[u32] {
        &self.edges[..self.len]
    }

    /// Adds what was done to `stats`.
    pub(crate) fn add_to(&self, stats: &mut ExtractionStats) {
        stats.faces_tested += self.stats.faces_tested;
        stats.edges_tested += self.stats.edges_tested;
        stats.exact_fallbacks += self.stats.exact_fallbacks;
    }

    pub(crate) fn bytes(&self) -> usize {
        size_of_val(self.edges.as_slice())
            + size_of_val(self.open_patches.as_slice())
            + size_of_val(self.doubts.as_slice())
            + size_of_val(self.doubtful.as_slice())
    }
}

/// Calls `work` with the number of each task and its cleared harvest: in parallel if there are several of both tasks and
/// threads, else on this very thread. Handing work to a pool of one thread would wake another core with cold caches, which
/// doubled the time of a view of 86 thousand faces.
pub(crate) fn share_among_threads(harvests: &mut [Harvest], work: impl Fn(usize, &mut Harvest) + Sync) {
    let work = |(task, harvest): (usize, &mut Harvest)| {
        harvest.clear();
        work(task, harvest);
    };
    if harvests.len() <= 1 || rayon::current_num_threads() == 1 {
        harvests.iter_mut().enumerate().for_each(work);
    } else {
        harvests.par_iter_mut().enumerate().for_each(work);
    }
}

impl<'a, R: FacingRule> Sweep<'a, R> {
    /// A view of the mesh where it was when its patches were built.
    pub(crate) fn new(mesh: &'a TriangleMesh, layout: &'a PatchLayout, planes: &'a PatchPlanes, rule: &'a R) -> Self {
        Self {
            layout,
            planes,
            triangles: mesh.triangles(),
            positions: mesh.positions(),
            rule,
            test: PlaneTest::new(rule.viewpoint(), planes.frame()),
            arch: Arch::new(),
        }
    }

    /// Finds the silhouette edges that these patches own: facing of all lanes, then the edges of those patches whose lanes
    /// differ. Patches with lanes that the 16-bit test leaves open come last, all together.
    pub(crate) fn visit(&self, patches: impl PatchList, harvest: &mut Harvest) {
        harvest.open_patches.clear();
        dispatch(self.arch, Visit { sweep: self, patches, harvest });
        dispatch(self.arch, Settle { sweep: self, harvest });
    }

    /// The edges of a patch whose facings differ.
    #[inline(always)]
    fn test_edges(&self, patch: usize, facings: u64, harvest: &mut Harvest) {
        let head = self.layout.head(patch);
        let used = facings & head.used;
        if used == 0 || used == head.used {
            return;
        }
        let Harvest { edges, len, stats, .. } = harvest;
        stats.edges_tested += u64::from(head.pairs);
        let mut found = *len;
        for (pairs, ids) in self.layout.blocks(patch) {
            if edges.len() < found + PAIRS {
                edges.resize(2 * found + PAIRS, 0);
            }
            let mut differing = pairs.differing(facings);
            let count = differing.count_ones() as usize;
            // Four ids at a time whether or not there are four: how many edges of a block differ is beyond prediction, and
            // a mispredicted branch costs more than the superfluous writes, which the next block overwrites.
            for quad in edges[found..found + PAIRS].chunks_exact_mut(4) {
                for id in quad {
                    *id = ids[differing.trailing_zeros() as usize % PAIRS];
                    differing &= differing.wrapping_sub(1);
                }
                if differing == 0 {
                    break;
                }
            }
            found += count;
        }
        *len = found;
    }
}

/// A patch some of whose facings the 16-bit test left open.
#[derive(Debug, Clone, Copy)]
struct OpenPatch {
    patch: usize,
    facings: u64,
    unsure: u64,
}

/// One lane of an open patch with its face's vertices, once they are looked up.
#[derive(Debug, Clone, Copy)]
struct Doubt {
    face: u32,
    triangle: [u32; 3],
    /// Index of the open patch.
    index: usize,
    lane: u32,
}

/// Patches to visit, in their order.
pub(crate) trait PatchList {
    /// Whether patches must be asked for ahead of their visits: where visits jump about in main memory, the processor
    /// cannot guess what comes next.
    const ASKS_AHEAD: bool;

    fn len(&self) -> usize;
    fn patch(&self, index: usize) -> usize;
}

impl PatchList for Range<usize> {
    const ASKS_AHEAD: bool = false;

    fn len(&self) -> usize {
        ExactSizeIterator::len(self)
    }

    fn patch(&self, index: usize) -> usize {
        self.start + index
    }
}

/// Some of the patches of a mesh that caches hold.
pub(crate) struct Near<'a>(pub(crate) &'a [u32]);

/// Some of the patches of a mesh that lies in main memory.
pub(crate) struct Far<'a>(pub(crate) &'a [u32]);

impl PatchList for Near<'_> {
    const ASKS_AHEAD: bool = false;

    fn len(&self) -> usize {
        self.0.len()
    }

    fn patch(&self, index: usize) -> usize {
        self.0[index] as usize
    }
}

impl PatchList for Far<'_> {
    const ASKS_AHEAD: bool = true;

    fn len(&self) -> usize {
        self.0.len()
    }

    fn patch(&self, index: usize) -> usize {
        self.0[index] as usize
    }
}

/// How many visits before its own the planes of a patch are asked for.
const PLANES_AHEAD: usize = 12;

/// How many visits before its own the edges of a patch are asked for; its head must have come by then.
const EDGES_AHEAD: usize = 6;

/// One pass over patches.
struct Visit<'a, R, P> {
    sweep: &'a Sweep<'a, R>,
    patches: P,
    harvest: &'a mut Harvest,
}

impl<R: FacingRule, P: PatchList> KernelTask for Visit<'_, R, P> {
    #[inline(always)]
    fn run<K: Kernel>(self, kernel: K) {
        let Self { sweep, patches, harvest } = self;
        let planes = sweep.planes;
        for index in 0..patches.len() {
            if P::ASKS_AHEAD {
                if index + PLANES_AHEAD < patches.len() {
                    sweep.prefetch_planes(kernel, patches.patch(index + PLANES_AHEAD));
                }
                if index + EDGES_AHEAD < patches.len() {
                    sweep.prefetch_edges(kernel, patches.patch(index + EDGES_AHEAD));
                }
            }
            let patch = patches.patch(index);
            let evaluated = planes.open[patch];
            harvest.stats.faces_tested += u64::from(evaluated.count_ones());
            let [front, back] = kernel.front_and_back(&sweep.test, &planes.blocks[patch]);
            let (facings, unsure) = (front & evaluated, evaluated & !(front | back));
            if unsure == 0 {
                sweep.test_edges(patch, facings, harvest);
            } else {
                harvest.open_patches.push(OpenPatch { patch, facings, unsure });
            }
        }
    }
}

impl<R: FacingRule> Sweep<'_, R> {
    #[inline(always)]
    fn prefetch_planes<K: Kernel>(&self, kernel: K, patch: usize) {
        for [xy, zd] in self.planes.blocks[patch].groups() {
            kernel.prefetch(xy);
            kernel.prefetch(zd);
        }
        kernel.prefetch(&self.planes.open[patch]);
        kernel.prefetch(self.layout.head(patch));
    }

    #[inline(always)]
    fn prefetch_edges<K: Kernel>(&self, kernel: K, patch: usize) {
        for (pairs, ids) in self.layout.blocks(patch) {
            kernel.prefetch(pairs);
            kernel.prefetch(&ids[0]);
            kernel.prefetch(&ids[PAIRS / 2]);
        }
    }
}

/// Decides the lanes that the 16-bit test left open, and then the edges of their patches. In stages over all of them:
/// within a stage no step waits for another, so that cache misses overlap; one by one they were a third of the time on ten
/// million faces.
struct Settle<'a, R> {
    sweep: &'a Sweep<'a, R>,
    harvest: &'a mut Harvest,
}

impl<R: FacingRule> KernelTask for Settle<'_, R> {
    #[inline(always)]
    fn run<K: Kernel>(self, kernel: K) {
        let Self { sweep, harvest } = self;
        let Harvest { open_patches, doubts, doubtful, stats, .. } = &mut *harvest;
        doubts.clear();
        for (index, &OpenPatch { patch, mut unsure, .. }) in open_patches.iter().enumerate() {
            while unsure != 0 {
                let lane = unsure.trailing_zeros();
                unsure &= unsure - 1;
                let face = sweep.layout.lanes(patch)[lane as usize];
                doubts.push(Doubt { face, triangle: [0; 3], index, lane });
            }
        }
        for doubt in &mut *doubts {
            doubt.triangle = sweep.triangles[doubt.face as usize];
            doubt.triangle.iter().for_each(|&vertex| kernel.prefetch(&sweep.positions[vertex as usize]));
        }
        for &Doubt { face, triangle, index, lane } in &*doubts {
            let judgement = sweep.rule.judge(triangle.map(|vertex| sweep.positions[vertex as usize]));
            open_patches[index].facings |= u64::from(judgement.facing == Facing::Front) << lane;
            stats.exact_fallbacks += u64::from(judgement.exact_fallback);
            if judgement.exact_fallback {
                doubtful.push(face);
            }
        }
        stats.faces_tested += doubts.len() as u64;
        for index in 0..harvest.open_patches.len() {
            let OpenPatch { patch, facings, .. } = harvest.open_patches[index];
            sweep.test_edges(patch, facings, harvest);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::patches::FacePatches;
    use silhouette_core::{NoProgress, Topology, Viewpoint, shapes};

    #[test]
    fn asking_ahead_changes_nothing() {
        let mesh = shapes::by_name("blob:20000").unwrap();
        let patches = FacePatches::new(&mesh, &Topology::new(&mesh), &NoProgress).unwrap();
        let viewpoint = Viewpoint::Perspective { eye: Vec3::new(0.5, 3.0, 1.0) };
        let sweep = Sweep::new(&mesh, &patches.layout, &patches.planes, &viewpoint);
        let all: Vec<u32> = (0..patches.len() as u32).collect();
        let [mut plain, mut near, mut far] = std::array::from_fn(|_| Harvest::default());
        sweep.visit(0..patches.len(), &mut plain);
        sweep.visit(Near(&all), &mut near);
        sweep.visit(Far(&all), &mut far);
        assert!(plain.edges().len() > 100);
        assert_eq!((near.edges(), &near.stats), (plain.edges(), &plain.stats));
        assert_eq!((far.edges(), &far.stats), (plain.edges(), &plain.stats));
    }
}
