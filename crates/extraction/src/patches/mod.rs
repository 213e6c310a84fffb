//! [`FacePatches`]: faces and edges in self-contained patches of 64 lanes, shared by the methods of this crate.
//!
//! A patch holds the planes of its own faces and of its *halo*, those neighbours with which it shares an edge that it
//! owns; so 512 bytes of planes and one word of facings decide all its edges, without a look at any other patch. A patch
//! whose lanes all face the same way has no silhouette edge. In the others, edges are pairs of lanes and are tested 32 at
//! a time without a branch.
//!
//! 1. [`pairs`]: every edge becomes pairs of faces, boundary and non-manifold edges too.
//! 2. [`grow`]: faces are partitioned into compact patches.
//! 3. [`order`]: patches are put in an order in which runs of 8, 64 ... are compact as well.
//! 4. [`planes`]: planes in 16-bit integers, and the test that decides 64 of them.
//!
//! Memory for a closed mesh, a fifth to a quarter of the lanes being halo: about 7 bytes per edge for planes, 3.5 for the
//! face of each lane (needed for exact fallbacks and for moving meshes), 7 for the edge table (lanes and id). Building is
//! O(F log F), parallel, and gives the same patches for any number of threads.

mod grow;
pub(crate) mod order;
mod pairs;
pub(crate) mod planes;

use grow::Partition;
use pairs::{OUTSIDE, pairs_of};
use planes::{Frame, LANES, PlaneBlock, quantize};
use rayon::prelude::*;
use silhouette_core::glam::Vec3;
use silhouette_core::prepared::Artefact;
use silhouette_core::{Cancelled, PreparedMesh, Progress, Topology, TriangleMesh};

/// Edges in a block of pairs: the lanes of a block fill one cache line.
pub(crate) const PAIRS: usize = 32;

/// 32 edges of one patch: the lanes of the faces on either side. Unused places hold lane 0 twice, which never differs.
#[derive(Debug, Clone)]
#[repr(align(64))]
pub(crate) struct PairBlock {
    first: [u8; PAIRS],
    second: [u8; PAIRS],
}

impl PairBlock {
    /// A bit for each edge whose faces differ in `facings`.
    #[inline(always)]
    pub(crate) fn differing(&self, facings: u64) -> u32 {
        let mut differing = 0;
        for (index, (&first, &second)) in self.first.iter().zip(&self.second).enumerate() {
            let differs = ((facings >> (first & 63)) ^ (facings >> (second & 63))) & 1;
            differing |= differs << index;
        }
        differing as u32
    }
}

/// What is fixed about a patch.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PatchHead {
    /// Lanes that an edge names, the outside among them.
    pub(crate) used: u64,
    /// Its first block of edges; the next patch's first is its end.
    pub(crate) first_block: u32,
    /// Edges that it owns (pairs, for non-manifold edges).
    pub(crate) pairs: u32,
}

/// The part of the patches that does not depend on positions.
#[derive(Debug)]
pub(crate) struct PatchLayout {
    /// One more than there are patches.
    heads: Vec<PatchHead>,
    /// Face of each lane; [`OUTSIDE`] where there is none.
    lanes: Vec<[u32; LANES]>,
    pair_blocks: Vec<PairBlock>,
    edge_ids: Vec<[u32; PAIRS]>,
}

/// Planes of all patches, for one set of positions.
#[derive(Debug, Clone, Default)]
pub(crate) struct PatchPlanes {
    frame: Option<Frame>,
    pub(crate) blocks: Vec<PlaneBlock>,
    /// Lanes that are not back from everywhere.
    pub(crate) open: Vec<u64>,
}

/// Faces and edges in self-contained patches of 64 lanes: the artefact that `brute-force-simd` and `cluster-cones` share.
///
/// A patch holds 16-bit planes of its own faces and of those neighbours with which it shares an edge that it owns, so that
/// 512 bytes and one word of facings decide all its edges. About 18 bytes per edge: 7 for planes, 3.5 for the faces of
/// lanes, 7.5 for the table of edges (lanes and ids).
#[derive(Debug)]
pub struct FacePatches {
    pub(crate) layout: PatchLayout,
    pub(crate) planes: PatchPlanes,
}

impl FacePatches {
    /// Builds the patches of a mesh. O(F log F), parallel.
    ///
    /// # Errors
    /// [`Cancelled`] by `progress`, which is asked between the four steps, and within the first.
    pub fn new(mesh: &TriangleMesh, topology: &Topology, progress: &dyn Progress) -> Result<Self, Cancelled> {
        progress.stage("face patches", 4);
        let step = || {
            progress.advance(1);
            progress.check()
        };
        progress.check()?;
        let frame = frame_of(mesh.triangles(), mesh.positions());
        let partition = grow::partition(mesh, topology, &frame, progress)?;
        step()?;
        let order = order::tree_order(mesh, &partition, &frame);
        step()?;
        let layout = PatchLayout::new(topology, &partition, &order);
        step()?;
        let mut planes = PatchPlanes::default();
        planes.compute(&layout, mesh.triangles(), mesh.positions());
        step()?;
        Ok(Self { layout, planes })
    }

    /// Number of patches.
    pub fn len(&self) -> usize {
        self.layout.len()
    }

    /// Whether the mesh has no face.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Bytes that the lanes and ids of edges take: the edge table proper.
    pub fn edge_table_bytes(&self) -> usize {
        size_of_val(self.layout.pair_blocks.as_slice()) + size_of_val(self.layout.edge_ids.as_slice())
    }

    /// Bytes that a pass over all planes reads.
    pub fn plane_bytes(&self) -> usize {
        self.planes.bytes()
    }
}

impl Artefact for FacePatches {
    const NAME: &'static str = "face-patches";

    fn build(mesh: &PreparedMesh, progress: &dyn Progress) -> Result<Self, Cancelled> {
        let topology = mesh.artefact::<Topology>(Self::NAME, progress)?;
        Self::new(mesh.mesh(), &topology, progress)
    }

    fn bytes(&self) -> usize {
        self.edge_table_bytes()
            + self.planes.bytes()
            + size_of_val(self.layout.heads.as_slice())
            + size_of_val(self.layout.lanes.as_slice())
    }
}

/// The lanes and edges of one patch before they are laid out.
struct Draft {
    lanes: [u32; LANES],
    used: u64,
    pairs: u32,
    blocks: Vec<(PairBlock, [u32; PAIRS])>,
}

impl Draft {
    fn new(topology: &Topology, partition: &Partition, patch: usize) -> Self {
        let mut draft = Self { lanes: [OUTSIDE; LANES], used: 0, pairs: 0, blocks: Vec::new() };
        let own = partition.own_faces(patch);
        draft.lanes[..own.len()].copy_from_slice(own);
        let mut len = own.len();
        for (lane, &face) in own.iter().enumerate() {
            for pair in pairs_of(topology, face) {
                let owner =
                    if pair.other == OUTSIDE { patch } else { partition.patch_of[pair.other as usize] as usize };
                if owner < patch || (owner == patch && !pair.leads) {
                    continue;
                }
                // The outside needs no plane: the first lane without a face serves, and is never front.
                let known = draft.lanes[..len].iter().position(|&other| other == pair.other);
                let other = known.unwrap_or_else(|| {
                    draft.lanes[len] = pair.other;
                    len += 1;
                    len - 1
                });
                draft.push([lane, other], pair.edge);
            }
        }
        draft
    }

    fn push(&mut self, lanes: [usize; 2], edge: u32) {
        let place = self.pairs as usize % PAIRS;
        if place == 0 {
            self.blocks.push((PairBlock { first: [0; PAIRS], second: [0; PAIRS] }, [0; PAIRS]));
        }
        let (pairs, ids) = self.blocks.last_mut().expect("a block was pushed with the first edge");
        (pairs.first[place], pairs.second[place], ids[place]) = (lanes[0] as u8, lanes[1] as u8, edge);
        self.used |= 1 << lanes[0] | 1 << lanes[1];
        self.pairs += 1;
    }
}

impl PatchLayout {
    fn new(topology: &Topology, partition: &Partition, order: &[u32]) -> Self {
        let drafts: Vec<Draft> =
            order.par_iter().map(|&patch| Draft::new(topology, partition, patch as usize)).collect();
        let mut heads = Vec::with_capacity(drafts.len() + 1);
        let mut first_block = 0;
        for draft in &drafts {
            heads.push(PatchHead { used: draft.used, first_block, pairs: draft.pairs });
            first_block += draft.blocks.len() as u32;
        }
        heads.push(PatchHead { used: 0, first_block, pairs: 0 });
        let lanes = drafts.par_iter().map(|draft| draft.lanes).collect();
        let (pair_blocks, edge_ids) = drafts.into_par_iter().flat_map_iter(|draft| draft.blocks).unzip();
        Self { heads, lanes, pair_blocks, edge_ids }
    }

    pub(crate) fn len(&self) -> usize {
        self.lanes.len()
    }

    pub(crate) fn lanes(&self, patch: usize) -> &[u32; LANES] {
        &self.lanes[patch]
    }

    pub(crate) fn head(&self, patch: usize) -> &PatchHead {
        &self.heads[patch]
    }

    /// Blocks of edges of a patch, with their ids.
    #[inline(always)]
    pub(crate) fn blocks(&self, patch: usize) -> impl Iterator<Item = (&PairBlock, &[u32; PAIRS])> {
        let range = self.heads[patch].first_block as usize..self.heads[patch + 1].first_block as usize;
        self.pair_blocks[range.clone()].iter().zip(&self.edge_ids[range])
    }
}

impl PatchPlanes {
    /// Replaces all planes by those of these positions. O(F), parallel; allocates nothing from the second call on.
    pub(crate) fn compute(&mut self, layout: &PatchLayout, triangles: &[[u32; 3]], positions: &[Vec3]) {
        let frame = frame_of(triangles, positions);
        self.frame = Some(frame);
        self.blocks.resize_with(layout.len(), PlaneBlock::default);
        self.open.resize(layout.len(), 0);
        let outputs = self.blocks.par_iter_mut().zip(&mut self.open);
        outputs.zip(&layout.lanes).with_min_len(64).for_each(|((block, open), lanes)| {
            *open = 0;
            for (lane, &face) in lanes.iter().enumerate().filter(|&(_, &face)| face != OUTSIDE) {
                let corners = triangles[face as usize].map(|vertex| positions[vertex as usize]);
                let plane = quantize(corners, &frame);
                *open |= u64::from(plane.is_some()) << lane;
                block.set(lane, plane.unwrap_or_default());
            }
        });
    }

    /// The frame of the planes.
    pub(crate) fn frame(&self) -> &Frame {
        self.frame.as_ref().expect("planes are computed when patches are built")
    }

    pub(crate) fn bytes(&self) -> usize {
        size_of_val(self.blocks.as_slice()) + size_of_val(self.open.as_slice())
    }
}

/// The frame of those positions that triangles use.
fn frame_of(triangles: &[[u32; 3]], positions: &[Vec3]) -> Frame {
    let empty = || (Vec3::INFINITY, Vec3::NEG_INFINITY);
    let join = |a: (Vec3, Vec3), b: (Vec3, Vec3)| (a.0.min(b.0), a.1.max(b.1));
    let (min, max) = triangles
        .par_iter()
        .with_min_len(1 << 14)
        .fold(empty, |bounds, triangle| {
            triangle.iter().map(|&vertex| positions[vertex as usize]).fold(bounds, |bounds, p| join(bounds, (p, p)))
        })
        .reduce(empty, join);
    if triangles.is_empty() { Frame::of(Vec3::ZERO, Vec3::ZERO) } else { Frame::of(min, max) }
}
