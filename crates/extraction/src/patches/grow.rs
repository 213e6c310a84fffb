//! Partition of the faces into patches of at most 64 lanes, grown breadth-first.
//!
//! 1. Faces are sorted along a Morton curve of their centroids and cut into chunks of [`CHUNK`]: chunks are independent,
//!    so rayon works on them in parallel, and their limits do not depend on the number of threads.
//! 2. In a chunk, a patch grows from the first face on the curve that has none. It takes the face that has most sides in
//!    the patch, the oldest among equals, which keeps patches round and leaves few edges between them.
//! 3. A patch is full when its own faces, those faces of later patches that they touch (its *halo*) and the outside of
//!    boundary edges fill 64 lanes. An enclosed patch that is not full goes on with the next free face on the curve.
//!
//! An edge between two patches belongs to the earlier one, which has both its faces in its lanes.
//!
//! O(F log F) for the sort, O(F) for the growth.

use super::pairs::{OUTSIDE, pairs_of};
use super::planes::{Frame, LANES};
use rayon::prelude::*;
use silhouette_core::morton::place;
use silhouette_core::{Cancelled, Progress, Topology, TriangleMesh};
use std::collections::VecDeque;

/// Faces that one task partitions. Patches end where chunks end: at this size that lengthens patch borders by under 2 %.
const CHUNK: usize = 1 << 15;

/// Own faces of every patch.
#[derive(Debug, Default)]
pub(crate) struct Partition {
    /// Faces, patch after patch.
    pub(crate) faces: Vec<u32>,
    /// Where each patch ends in `faces`.
    pub(crate) ends: Vec<u32>,
    /// Patch of each face.
    pub(crate) patch_of: Vec<u32>,
}

impl Partition {
    pub(crate) fn len(&self) -> usize {
        self.ends.len()
    }

    pub(crate) fn own_faces(&self, patch: usize) -> &[u32] {
        let begin = if patch == 0 { 0 } else { self.ends[patch - 1] };
        &self.faces[begin as usize..self.ends[patch] as usize]
    }
}

/// Partitions the faces of `mesh`. See the [module](self).
///
/// # Errors
/// [`Cancelled`] when `progress` says so.
pub(crate) fn partition(
    mesh: &TriangleMesh,
    topology: &Topology,
    frame: &Frame,
    progress: &dyn Progress,
) -> Result<Partition, Cancelled> {
    let curve = along_curve(mesh, frame);
    progress.check()?;
    let mut rank = vec![0; curve.len()];
    for (position, &face) in curve.iter().enumerate() {
        rank[face as usize] = position as u32;
    }
    let chunks: Vec<_> = (0..curve.len().div_ceil(CHUNK))
        .into_par_iter()
        .map(|chunk| progress.check().map(|()| Growth::new(topology, &curve, &rank, chunk).grow()))
        .collect::<Result<_, _>>()?;
    let mut partition = Partition { patch_of: rank, ..Partition::default() };
    for (faces, ends) in chunks {
        let base = partition.faces.len() as u32;
        partition.ends.extend(ends.iter().map(|end| base + end));
        partition.faces.extend(faces);
    }
    for patch in 0..partition.len() {
        let begin = if patch == 0 { 0 } else { partition.ends[patch - 1] };
        for &face in &partition.faces[begin as usize..partition.ends[patch] as usize] {
            partition.patch_of[face as usize] = patch as u32;
        }
    }
    Ok(partition)
}

/// All faces in the order of a Morton curve through their centroids.
fn along_curve(mesh: &TriangleMesh, frame: &Frame) -> Vec<u32> {
    let mut keyed: Vec<(u64, u32)> = mesh
        .triangles()
        .par_iter()
        .enumerate()
        .map(|(face, triangle)| {
            let [a, b, c] = triangle.map(|vertex| frame.local(mesh.positions()[vertex as usize]));
            (place((a + b + c) / 3.0), face as u32)
        })
        .collect();
    keyed.par_sort_unstable();
    keyed.into_iter().map(|(_, face)| face).collect()
}

/// What a face of the chunk is to the patch that grows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum State {
    Free,
    Taken,
}

/// The growth of one chunk's patches.
struct Growth<'a> {
    topology: &'a Topology,
    /// The chunk's faces along the curve.
    curve: &'a [u32],
    rank: &'a [u32],
    /// Rank of the chunk's first face.
    base: u32,
    state: Vec<State>,
    /// Patch in whose halo a free face is, and how many of its sides are in that patch.
    halo: Vec<(u32, u8)>,
    /// Halo faces of the growing patch: those with one side in it, and those with more.
    queue: VecDeque<u32>,
    notches: VecDeque<u32>,
    /// Halo faces of the growing patch in later chunks.
    foreign: Vec<u32>,
    lanes: usize,
    touches_outside: bool,
    faces: Vec<u32>,
    ends: Vec<u32>,
}

impl<'a> Growth<'a> {
    fn new(topology: &'a Topology, curve: &'a [u32], rank: &'a [u32], chunk: usize) -> Self {
        let base = chunk * CHUNK;
        let curve = &curve[base..curve.len().min(base + CHUNK)];
        Self {
            topology,
            curve,
            rank,
            base: base as u32,
            state: vec![State::Free; curve.len()],
            halo: vec![(u32::MAX, 0); curve.len()],
            queue: VecDeque::new(),
            notches: VecDeque::new(),
            foreign: Vec::new(),
            lanes: 0,
            touches_outside: false,
            faces: Vec::with_capacity(curve.len()),
            ends: Vec::new(),
        }
    }

    fn grow(mut self) -> (Vec<u32>, Vec<u32>) {
        for seed in 0..self.curve.len() {
            if self.state[seed] == State::Taken {
                continue;
            }
            if !self.take(seed as u32) {
                self.close();
                // Even with all its neighbours one face fits an empty patch.
                self.take(seed as u32);
            }
            while let Some(face) = self.notches.pop_front().or_else(|| self.queue.pop_front()) {
                if self.state[face as usize] == State::Free {
                    self.take(face);
                }
            }
            if self.open_halo() {
                self.close();
            }
        }
        self.close();
        (self.faces, self.ends)
    }

    /// Whether a free face touches the growing patch: then it is full, otherwise it is enclosed.
    fn open_halo(&self) -> bool {
        let begin = self.ends.last().map_or(0, |&end| end as usize);
        self.lanes > self.faces.len() - begin + usize::from(self.touches_outside)
    }

    fn close(&mut self) {
        if self.ends.last().map_or(0, |&end| end as usize) < self.faces.len() {
            self.ends.push(self.faces.len() as u32);
        }
        self.foreign.clear();
        self.lanes = 0;
        self.touches_outside = false;
    }

    /// Adds a face, given by its index in the chunk, to the growing patch, if it fits with its neighbours.
    fn take(&mut self, local: u32) -> bool {
        let patch = self.ends.len() as u32;
        let face = self.curve[local as usize];
        let mut lanes = self.lanes + usize::from(self.halo[local as usize].0 != patch);
        let mut touches_outside = self.touches_outside;
        let mut fresh = [OUTSIDE; 6];
        let mut fresh_count = 0;
        for pair in pairs_of(self.topology, face) {
            if pair.other == OUTSIDE {
                lanes += usize::from(!touches_outside);
                touches_outside = true;
                continue;
            }
            let rank = self.rank[pair.other as usize];
            let is_known = match rank.checked_sub(self.base) {
                None => true,
                Some(other) if (other as usize) < self.curve.len() => {
                    self.state[other as usize] == State::Taken || self.halo[other as usize].0 == patch
                }
                Some(_) => self.foreign.contains(&pair.other),
            };
            if !is_known && !fresh[..fresh_count].contains(&pair.other) {
                fresh[fresh_count] = pair.other;
                fresh_count += 1;
            }
        }
        lanes += fresh_count;
        if lanes > LANES {
            return false;
        }
        self.lanes = lanes;
        self.touches_outside = touches_outside;
        self.state[local as usize] = State::Taken;
        self.faces.push(face);
        for pair in pairs_of(self.topology, face).filter(|pair| pair.other != OUTSIDE) {
            self.welcome(pair.other, patch);
        }
        true
    }

    /// Enters a neighbour of the growing patch into its halo, or notes one more side.
    fn welcome(&mut self, face: u32, patch: u32) {
        let Some(local) = self.rank[face as usize].checked_sub(self.base) else { return };
        if local as usize >= self.curve.len() {
            if !self.foreign.contains(&face) {
                self.foreign.push(face);
            }
            return;
        }
        if self.state[local as usize] == State::Taken {
            return;
        }
        let (of, sides) = &mut self.halo[local as usize];
        if *of == patch {
            *sides += 1;
            self.notches.push_back(local);
        } else {
            (*of, *sides) = (patch, 1);
            self.queue.push_back(local);
        }
    }
}
