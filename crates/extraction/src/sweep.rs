//! The work on one patch, shared by the methods that differ only in which patches they visit.

use crate::patches::planes::PlaneTest;
use crate::patches::{PAIRS, PatchLayout, PatchPlanes};
use pulp::{Arch, Simd, WithSimd};
use silhouette_core::facing::{Facing, judge};
use silhouette_core::glam::Vec3;
use silhouette_core::method::ExtractionStats;
use silhouette_core::{TriangleMesh, Viewpoint};
use std::hint::black_box;

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
    /// Patches that wait for exact facings, and what is open about them.
    open_patches: Vec<OpenPatch>,
    doubts: Vec<Doubt>,
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
            + size_of_val(self.open_patches.as_slice())
            + size_of_val(self.doubts.as_slice())
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

    /// Finds the silhouette edges that these patches own: facing of all lanes, then the edges of those patches whose lanes
    /// differ. Patches with lanes that the 16-bit test leaves open come last, all together.
    #[inline(always)]
    pub(crate) fn visit(&self, patches: impl Iterator<Item = usize>, harvest: &mut Harvest) {
        harvest.open_patches.clear();
        for patch in patches {
            let evaluated = self.planes.open[patch];
            let (front, unsure) = self.test.facings(&self.planes.blocks[patch]);
            let (facings, unsure) = (front & evaluated, unsure & evaluated);
            if unsure == 0 {
                self.test_edges(patch, facings, harvest);
            } else {
                harvest.open_patches.push(OpenPatch { patch, facings, unsure });
            }
        }
        self.settle(harvest);
        for index in 0..harvest.open_patches.len() {
            let OpenPatch { patch, facings, .. } = harvest.open_patches[index];
            self.test_edges(patch, facings, harvest);
        }
    }

    /// Reads what visits to these patches will read, without doing anything with it. Nothing here depends on anything, so
    /// the misses of all patches overlap, where a visit would wait for those of its own patch.
    pub(crate) fn touch(&self, patches: impl Iterator<Item = usize> + Clone) {
        let mut sum = 0;
        for patch in patches.clone() {
            sum ^= self.planes.blocks[patch].touch() ^ self.planes.open[patch] ^ self.layout.head(patch).used;
        }
        for patch in patches {
            for (pairs, ids) in self.layout.blocks(patch) {
                sum ^= u64::from(pairs.touch()) ^ u64::from(ids[0] ^ ids[PAIRS / 2]);
            }
        }
        black_box(sum);
    }

    #[inline(always)]
    fn test_edges(&self, patch: usize, facings: u64, harvest: &mut Harvest) {
        let head = self.layout.head(patch);
        let used = facings & head.used;
        if used != 0 && used != head.used {
            harvest.stats.edges_tested += u64::from(head.pairs);
            self.arch.dispatch(MixedPatch { sweep: self, patch, facings, harvest });
        }
    }

    /// Decides the lanes that the 16-bit test left open. In stages over all of them: within a stage no step waits for
    /// another, so that cache misses overlap; one by one they were a third of the time on ten million faces.
    fn settle(&self, harvest: &mut Harvest) {
        let Harvest { open_patches, doubts, stats, .. } = harvest;
        doubts.clear();
        for (index, &OpenPatch { patch, mut unsure, .. }) in open_patches.iter().enumerate() {
            while unsure != 0 {
                let lane = unsure.trailing_zeros();
                unsure &= unsure - 1;
                let face = self.layout.lanes(patch)[lane as usize];
                doubts.push(Doubt { triangle: [face; 3], index, lane });
            }
        }
        for doubt in &mut *doubts {
            doubt.triangle = self.triangles[doubt.triangle[0] as usize];
        }
        for &Doubt { triangle, index, lane } in &*doubts {
            let judgement = judge(triangle.map(|vertex| self.positions[vertex as usize]), &self.viewpoint);
            open_patches[index].facings |= u64::from(judgement.facing == Facing::Front) << lane;
            stats.exact_fallbacks += u64::from(judgement.exact_fallback);
        }
        stats.faces_tested += doubts.len() as u64;
    }
}

/// A patch some of whose facings the 16-bit test left open.
#[derive(Debug, Clone, Copy)]
struct OpenPatch {
    patch: usize,
    facings: u64,
    unsure: u64,
}

/// One lane of an open patch with its face's vertices; before they are looked up, the face three times.
#[derive(Debug, Clone, Copy)]
struct Doubt {
    triangle: [u32; 3],
    /// Index of the open patch.
    index: usize,
    lane: u32,
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
