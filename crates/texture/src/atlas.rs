//! [`Atlas`]: where the faces of a hull lie in a texture (section 3.3, "texture atlas").
//!
//! The paper leaves charts to a library. Here every two adjacent faces share a square block of texels, cut by its diagonal, which
//! is their common edge; a face that finds no partner has a block alone. Blocks are equal in size and fill pages row by row.
//!
//! ```text
//!   . . . . . . .      corners of faces lie at centres of texels: bilinear filtering at a point of a face
//!   . 2-------0 .      reads texels of the block only, and gives weight only to points of the two faces
//!   . | \   B | .
//!   . |   \   | .      . is the gutter
//!   . | A   \ | .
//!   . 0-------1 .
//!   . . . . . . .
//! ```
//!
//! A texel of the gutter lies on the *neighbour* across the edge: its offset from the edge is turned into the neighbour's plane,
//! and clamped to the neighbour. What is baked there is expressed in the frame that the renderer interpolates at that very point
//! of the neighbour. The frame is continuous over the hull, so that values on both sides of an edge can be blended.
//!
//! Everything follows from the order of the hull's faces and half-edges. O(F log F).

use crate::hull::Hull;
use crate::silhouette_texture::FacePlace;
use crate::volume_size::{VolumeSize, VolumeSizeError};
use glam::{DVec3, Vec2, Vec3};
use silhouette_core::topology::Twin;
use silhouette_core::{FaceId, HalfEdgeId, Topology, glam};
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Fewest texels along a block's side, gutter included.
pub const LEAST_SIDE: u32 = 4;

/// Most texels that a gutter can be wide.
pub const MOST_GUTTER: u32 = 8;

/// Two faces of the hull in a square of texels.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Block {
    /// Page.
    pub page: u32,
    /// Texels between the page's first column and the block's, gutter included.
    pub x: u32,
    /// Texels between the page's first row and the block's, gutter included.
    pub y: u32,
    /// The half-edge of the first face that leaves the corner away from the diagonal.
    pub first: HalfEdgeId,
    /// The same of the second face, if there is one.
    pub second: Option<HalfEdgeId>,
}

/// Blocks of equal size on pages.
#[derive(Debug, Clone)]
pub struct Atlas {
    size: VolumeSize,
    side: u32,
    gutter: u32,
    blocks: Vec<Block>,
    /// Per half-edge, what lies across it if both faces are wound alike.
    twins: Vec<Option<HalfEdgeId>>,
    corners: Vec<[DVec3; 3]>,
}

/// A point of the hull.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// The face.
    pub face: FaceId,
    /// Weights of its corners: 0 or positive, with sum 1.
    pub weights: Vec3,
}

/// A hull that cannot be laid out.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum AtlasError {
    /// The size is out of range.
    #[error(transparent)]
    Size(#[from] VolumeSizeError),
    /// The hull has no face.
    #[error("the hull has no face")]
    NoFaces,
    /// The gutter is too wide.
    #[error("a gutter of {0} texels is too wide: at most {MOST_GUTTER} are supported")]
    Gutter(u32),
    /// The faces do not fit.
    #[error(
        "a hull of {faces} faces does not fit {} {} of {} x {} texels: its {blocks} blocks need at least {side} x {side} \
         texels each; take {least_side} x {least_side} texels, or {least_pages} pages",
        .size.pages, if .size.pages == 1 { "page" } else { "pages" }, .size.width, .size.height
    )]
    TooSmall {
        /// Faces of the hull.
        faces: usize,
        /// Blocks that they make.
        blocks: usize,
        /// Least side of a block.
        side: u32,
        /// The size that was asked for.
        size: VolumeSize,
        /// The least side of square pages that would do.
        least_side: u64,
        /// The least number of pages of the wanted size that would do.
        least_pages: u64,
    },
}

impl Atlas {
    /// Lays out a hull in blocks as large as fit.
    ///
    /// # Errors
    /// [`AtlasError`].
    pub fn new(hull: &Hull, size: VolumeSize, gutter: u32) -> Result<Self, AtlasError> {
        let (size, mesh) = (size.checked()?, hull.mesh());
        if gutter > MOST_GUTTER {
            return Err(AtlasError::Gutter(gutter));
        }
        if mesh.face_count() == 0 {
            return Err(AtlasError::NoFaces);
        }
        let twins = twins(&Topology::new(mesh), mesh.triangles());
        let pairs = pair(&twins);
        let side = side_of_blocks(pairs.len(), mesh.face_count(), size, gutter)?;
        let (columns, rows) = (size.width / side, size.height / side);
        let block = |(at, &(first, second)): (usize, &(HalfEdgeId, Option<HalfEdgeId>))| {
            let (row, column) = (at as u32 / columns, at as u32 % columns);
            Block { page: row / rows, x: column * side, y: row % rows * side, first, second }
        };
        let blocks = pairs.iter().enumerate().map(block).collect();
        let corners = (0..mesh.face_count()).map(|face| mesh.corners(FaceId::from_usize(face)).map(Vec3::as_dvec3));
        Ok(Self { size, side, gutter, blocks, twins, corners: corners.collect() })
    }

    /// The blocks, in the order of their first faces' matching.
    pub fn blocks(&self) -> &[Block] {
        &self.blocks
    }

    /// Texels along a block's side, gutter included.
    pub fn side(&self) -> u32 {
        self.side
    }

    /// Texels of all pages.
    pub fn size(&self) -> VolumeSize {
        self.size
    }

    /// Texels that lie on the block's own faces, as a share of all texels.
    pub fn utilisation(&self) -> f64 {
        let inner = u64::from(self.side - 2 * self.gutter);
        let faces = |block: &Block| if block.second.is_some() { inner * inner } else { inner * (inner + 1) / 2 };
        self.blocks.iter().map(faces).sum::<u64>() as f64 / self.size.texels() as f64
    }

    /// Of each texel of all pages, whether it lies in a block.
    pub fn used_texels(&self) -> Vec<bool> {
        let mut used = vec![false; self.size.texels() as usize];
        for block in &self.blocks {
            for y in block.y..block.y + self.side {
                used[self.size.texel(block.page, block.x, y)..][..self.side as usize].fill(true);
            }
        }
        used
    }

    /// Where the corners of each face lie.
    pub fn places(&self) -> Vec<FacePlace> {
        let mut places = vec![FacePlace { page: 0, corners: [Vec2::ZERO; 3] }; self.corners.len()];
        let (near, far) = (f64::from(self.gutter) + 0.5, f64::from(self.side - self.gutter) - 0.5);
        for block in &self.blocks {
            let place = |x: f64, y: f64| {
                let (x, y) = (f64::from(block.x) + x, f64::from(block.y) + y);
                Vec2::new((x / f64::from(self.size.width)) as f32, (y / f64::from(self.size.height)) as f32)
            };
            let mut put = |half_edge: HalfEdgeId, corners: [Vec2; 3]| {
                let face = &mut places[half_edge.face().index()];
                face.page = block.page;
                for (step, corner) in corners.into_iter().enumerate() {
                    face.corners[(half_edge.slot() as usize + step) % 3] = corner;
                }
            };
            put(block.first, [place(near, near), place(far, near), place(near, far)]);
            if let Some(second) = block.second {
                put(second, [place(far, far), place(near, far), place(far, near)]);
            }
        }
        places
    }

    /// The hull point at a place in a block, in texels from the centre of its first texel, from -0.5 to [`side`](Self::side) - 0.5.
    /// A place outside both faces lies on the neighbour across the nearest edge, or on that edge if there is none.
    pub fn point(&self, block: &Block, x: f64, y: f64) -> Place {
        let across = f64::from(self.side - 2 * self.gutter - 1);
        let (x, y) = ((x - f64::from(self.gutter)) / across, (y - f64::from(self.gutter)) / across);
        // A texel on the diagonal belongs to the first face.
        let is_second = x + y > 1.0 + ON_EDGE;
        match block.second {
            Some(second) if is_second => self.unfold(second, [x + y - 1.0, 1.0 - x, 1.0 - y]),
            _ => self.unfold(block.first, [1.0 - x - y, x, y]),
        }
    }

    /// A point in the plane of a face, given by weights that may be negative, moved onto the face or its neighbour.
    fn unfold(&self, half_edge: HalfEdgeId, weights: [f64; 3]) -> Place {
        let (face, slot) = (half_edge.face(), half_edge.slot() as usize);
        let mut of_slot = [0.0; 3];
        for (step, weight) in weights.into_iter().enumerate() {
            of_slot[(slot + step) % 3] = weight;
        }
        let corners = &self.corners[face.index()];
        let farthest = (0..3).min_by(|&a, &b| of_slot[a].total_cmp(&of_slot[b])).unwrap_or(0);
        if of_slot[farthest] >= -ON_EDGE {
            return Place { face, weights: clamped(of_slot) };
        }
        let edge = HalfEdgeId::of(face, (farthest as u32 + 1) % 3);
        let Some(twin) = self.twins[edge.index()] else { return Place { face, weights: clamped(of_slot) } };
        let [from, to] = [corners[(farthest + 1) % 3], corners[(farthest + 2) % 3]];
        let along = (to - from).normalize_or_zero();
        let off = |point: DVec3| (point - from) - (point - from).dot(along) * along;
        let point = (0..3).map(|at| of_slot[at] * corners[at]).sum::<DVec3>();
        let neighbour = &self.corners[twin.face().index()];
        let (opposite, start) = ((twin.slot() as usize + 2) % 3, twin.slot() as usize);
        let height = off(neighbour[opposite]).length();
        // Both planes meet in the edge: a point keeps its place along it and its distance from it.
        let weight = if height > 0.0 { off(point).length() / height } else { 0.0 };
        let foot = from + (point - from).dot(along) * along + weight * off(neighbour[opposite]);
        let length = from.distance(to);
        let share = (foot - weight * neighbour[opposite] - (1.0 - weight) * from).dot(along);
        let share = if length > 0.0 { share / length } else { 0.0 };
        let mut turned = [0.0; 3];
        // The twin runs the other way: it leaves `to`.
        (turned[opposite], turned[start], turned[(start + 1) % 3]) = (weight, share, 1.0 - weight - share);
        Place { face: twin.face(), weights: clamped(turned) }
    }
}

/// What a weight of 0 may be after rounding: a point that lies on an edge stays on its face. Across the edge, a neighbour without area
/// has a height that is rounding as well, and would move the point anywhere.
const ON_EDGE: f64 = 1e-9;

/// Negative weights become 0, and the sum 1.
fn clamped(weights: [f64; 3]) -> Vec3 {
    let weights = DVec3::from(weights).max(DVec3::ZERO);
    (weights / weights.element_sum()).as_vec3()
}

/// Twins of half-edges that run opposite ways, as they do where two faces are wound alike.
fn twins(topology: &Topology, triangles: &[[u32; 3]]) -> Vec<Option<HalfEdgeId>> {
    let start = |half_edge: HalfEdgeId| triangles[half_edge.face().index()][half_edge.slot() as usize];
    (0..triangles.len() * 3)
        .map(HalfEdgeId::from_usize)
        .map(|half_edge| match topology.twin(half_edge) {
            Twin::HalfEdge(twin) if start(twin) != start(half_edge) && twin.face() != half_edge.face() => Some(twin),
            _ => None,
        })
        .collect()
}

/// Pairs of adjacent faces and single faces, each by the half-edge that leaves the corner opposite the common edge.
///
/// The face with the fewest unpaired neighbours chooses first, and takes the neighbour that has the fewest left itself: a face
/// with only one to choose from is better served at once. That leaves few alone, though not provably the fewest.
fn pair(twins: &[Option<HalfEdgeId>]) -> Vec<(HalfEdgeId, Option<HalfEdgeId>)> {
    let faces = twins.len() / 3;
    let mut is_paired = vec![false; faces];
    let edges = |face: FaceId| (0..3).map(move |slot| HalfEdgeId::of(face, slot));
    let free = |is_paired: &[bool], face: FaceId| {
        edges(face).filter(|edge| twins[edge.index()].is_some_and(|twin| !is_paired[twin.face().index()])).count()
    };
    let mut queue: BinaryHeap<Reverse<(usize, FaceId)>> =
        (0..faces).map(FaceId::from_usize).map(|face| Reverse((free(&is_paired, face), face))).collect();
    let mut pairs = Vec::new();
    while let Some(Reverse((count, face))) = queue.pop() {
        // Counts only fall; an entry that is out of date has a later one with the true count.
        if is_paired[face.index()] || count != free(&is_paired, face) {
            continue;
        }
        is_paired[face.index()] = true;
        let partner = edges(face)
            .filter_map(|edge| twins[edge.index()].map(|twin| (edge, twin)))
            .filter(|(_, twin)| !is_paired[twin.face().index()])
            .min_by_key(|&(edge, twin)| (free(&is_paired, twin.face()), edge));
        let away = |edge: HalfEdgeId| edge.next_in_face().next_in_face();
        let first = partner.map_or(HalfEdgeId::of(face, 0), |(edge, _)| away(edge));
        pairs.push((first, partner.map(|(_, twin)| away(twin))));
        let mut changed = vec![face];
        if let Some((_, twin)) = partner {
            is_paired[twin.face().index()] = true;
            changed.push(twin.face());
        }
        for neighbour in changed.into_iter().flat_map(edges).filter_map(|edge| twins[edge.index()]) {
            if !is_paired[neighbour.face().index()] {
                queue.push(Reverse((free(&is_paired, neighbour.face()), neighbour.face())));
            }
        }
    }
    pairs
}

/// The largest side with which all blocks fit.
fn side_of_blocks(blocks: usize, faces: usize, size: VolumeSize, gutter: u32) -> Result<u32, AtlasError> {
    let least = LEAST_SIDE.max(2 * gutter + 2);
    let fit = |side: u32| u64::from(size.width / side) * u64::from(size.height / side) * u64::from(size.pages);
    let largest = (least..=size.width.min(size.height)).rev().find(|&side| fit(side) >= blocks as u64);
    largest.ok_or_else(|| {
        let per_page = u64::from(size.width / least) * u64::from(size.height / least);
        let columns = (blocks as f64).sqrt().ceil() as u64;
        let least_pages = (blocks as u64).div_ceil(per_page.max(1));
        let least_side = columns * u64::from(least);
        AtlasError::TooSmall { faces, blocks, side: least, size, least_side, least_pages }
    })
}
