//! The work on one patch, shared by the methods that differ only in which patches they visit.

use crate::patches::planes::PlaneTest;
use crate::patches::{PAIRS, PatchLayout, PatchPlanes};
use pulp::{Arch, Simd, WithSimd};
use silhouette_core::facing::{Facing, judge};
use silhouette_core::glam::Vec3;
use silhouette_core::method::ExtractionStats;
use silhouette_core::{TriangleMesh, Viewpoint};

/// One view of a patched mesh.
#[derive(Clone, Copy)]
pub(crate) struct Sweep<'a> {
    pub(crate) layout: &'a PatchLayout,
    pub(crate) planes: &'a PatchPlanes,
    pub(crate) triangles: &'a [[u32; 3]],
    pub(crate) positions: &'a [Vec3],
    pub(crate) viewpoint: Viewpoint,
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
}

impl Harvest {
    pub(crate) fn clear(&mut self) {
        self.len = 0;
        self.stats = ExtractionStats::default();
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
    }
}

impl<'a> Sweep<'a> {
    /// A view of the mesh where it was when its patches were built.
    pub(crate) fn new(
        mesh: &'a TriangleMesh,
        layout: &'a PatchLayout,
        planes: &'a PatchPlanes,
        viewpoint: &Viewpoint,
    ) -> Self {
        Self {
            layout,
            planes,
            triangles: mesh.triangles(),
            positions: mesh.positions(),
            viewpoint: *viewpoint,
            test: PlaneTest::new(viewpoint, planes.frame()),
            arch: Arch::new(),
        }
    }

    /// Finds the silhouette edges that a patch owns: facing of all lanes, then, unless they all agree, its edges.
    #[inline(always)]
    pub(crate) fn visit(&self, patch: usize, harvest: &mut Harvest) {
        let open = self.planes.open[patch];
        let (front, unsure) = self.test.facings(&self.planes.blocks[patch]);
        let mut facings = front & open;
        if unsure & open != 0 {
            facings |= self.settle(patch, unsure & open, harvest);
        }
        let head = self.layout.head(patch);
        let used = facings & head.used;
        if used != 0 && used != head.used {
            harvest.stats.edges_tested += u64::from(head.pairs);
            self.arch.dispatch(MixedPatch { sweep: self, patch, facings, harvest });
        }
    }

    /// Facings of the lanes that the 16-bit test left open.
    #[cold]
    fn settle(&self, patch: usize, mut unsure: u64, harvest: &mut Harvest) -> u64 {
        let mut facings = 0;
        while unsure != 0 {
            let lane = unsure.trailing_zeros() as usize;
            unsure &= unsure - 1;
            let face = self.layout.lanes(patch)[lane] as usize;
            let judgement = judge(self.triangles[face].map(|vertex| self.positions[vertex as usize]), &self.viewpoint);
            facings |= u64::from(judgement.facing == Facing::Front) << lane;
            harvest.stats.faces_tested += 1;
            harvest.stats.exact_fallbacks += u64::from(judgement.exact_fallback);
        }
        facings
    }
}

/// The edges of a patch whose facings differ. A value, not a closure, so that it is inlined into the function that `pulp`
/// compiles for each instruction set.
struct MixedPatch<'a> {
    sweep: &'a Sweep<'a>,
    patch: usize,
    facings: u64,
    harvest: &'a mut Harvest,
}

impl WithSimd for MixedPatch<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _simd: S) {
        let Harvest { edges, len, .. } = self.harvest;
        let mut found = *len;
        for (pairs, ids) in self.sweep.layout.blocks(self.patch) {
            if edges.len() < found + PAIRS {
                edges.resize(2 * found + PAIRS, 0);
            }
            let mut differing = pairs.differing(self.facings);
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
