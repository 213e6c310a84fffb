//! Merging of coincident vertices. Loading never does it by itself, except for STL, which has no vertex numbers.
//!
//! A mesh whose vertices were split along texture or material seams has a boundary wherever it was split, and every
//! boundary edge of a front face counts as silhouette. Welding closes such seams.

use crate::mesh::TriangleMesh;
use glam::{DVec3, Vec3};
use std::collections::HashMap;
use std::collections::hash_map::Entry;

/// A welded mesh and where each vertex went.
#[derive(Debug, Clone, PartialEq)]
pub struct Welded {
    /// The mesh over the vertices that are left.
    ///
    /// They keep the order and the position that they had. Triangles keep their order and number too, also those that
    /// now name a vertex twice; [`inspect`](crate::inspect) lists them. Unreferenced vertices are merged like any
    /// other and stay where nothing is near.
    pub mesh: TriangleMesh,
    /// For each vertex of the old mesh its vertex in the new one.
    pub vertex_of: Vec<u32>,
}

impl Welded {
    /// How many vertices were merged into others.
    pub fn merged(&self) -> usize {
        self.vertex_of.len() - self.mesh.vertex_count()
    }
}

/// Why a mesh cannot be welded.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum WeldError {
    /// The tolerance is negative, infinite or NaN.
    #[error("the tolerance {tolerance} is no distance; give a finite number of object units, 0 or more")]
    Tolerance {
        /// What was given.
        tolerance: f32,
    },
}

/// Merges vertices of equal position; 0.0 and -0.0 are equal. Each group is represented by its lowest id.
///
/// O(V + F) expected.
pub fn weld_exact(mesh: &TriangleMesh) -> Welded {
    let mut known = ExactPositions::default();
    weld(mesh, |position, _| known.id_of(position))
}

/// Merges each vertex into the lowest-numbered representative within `tolerance` of it, in object units.
///
/// Vertices are taken in the order of their ids. One that has no representative within the tolerance (at a distance of
/// `tolerance` or less, evaluated in 64-bit arithmetic) becomes one itself. So no vertex moves by more than the
/// tolerance, representatives are further apart than the tolerance, and a chain of close vertices is not pulled into
/// one. With a tolerance of 0 this is [`weld_exact`].
///
/// O(V + F) expected, whatever the ratio of coordinates to tolerance: a grid cell holds a bounded number of
/// representatives, and cells are named by 64-bit floats, which do not overflow.
///
/// # Errors
/// [`WeldError::Tolerance`] where it is no distance.
pub fn weld_within(mesh: &TriangleMesh, tolerance: f32) -> Result<Welded, WeldError> {
    if !(tolerance.is_finite() && tolerance >= 0.0) {
        return Err(WeldError::Tolerance { tolerance });
    }
    if tolerance == 0.0 {
        return Ok(weld_exact(mesh));
    }
    let mut grid = Grid::new(f64::from(tolerance));
    Ok(weld(mesh, |position, representatives| grid.id_of(position, representatives)))
}

/// Gives each vertex the id that `id_of` finds among the representatives so far, where their number means a new one.
fn weld(mesh: &TriangleMesh, mut id_of: impl FnMut(Vec3, &[Vec3]) -> u32) -> Welded {
    let mut representatives = Vec::new();
    let mut vertex_of = Vec::with_capacity(mesh.vertex_count());
    for &position in mesh.positions() {
        let id = id_of(position, &representatives);
        if id as usize == representatives.len() {
            representatives.push(position);
        }
        vertex_of.push(id);
    }
    let triangles = mesh.triangles().iter().map(|triangle| triangle.map(|vertex| vertex_of[vertex as usize])).collect();
    let welded = TriangleMesh::new(representatives, triangles);
    let welded =
        welded.expect("positions are a subset of a valid mesh's, and every triangle's vertex has a representative");
    let mesh = welded.with_origin(mesh.origin());
    Welded { mesh, vertex_of }
}

/// Ids of positions by their bits, in the order in which they are first asked for.
#[derive(Debug, Default)]
pub(crate) struct ExactPositions(HashMap<[u32; 3], u32>);

impl ExactPositions {
    /// The id of a position: the one it has, or the next. Positions must be finite, fewer than 2^32.
    pub(crate) fn id_of(&mut self, position: Vec3) -> u32 {
        let next = self.0.len() as u32;
        // Adding 0.0 turns -0.0 into 0.0 and leaves the rest alone.
        *self.0.entry(position.to_array().map(|x| (x + 0.0).to_bits())).or_insert(next)
    }
}

/// Representatives by cubic cell, their sides a little more than twice the tolerance: what lies within the tolerance
/// of a point is then in the point's own cell or in the nearer neighbour along each axis, eight cells in all.
struct Grid {
    tolerance: f64,
    side: f64,
    /// The representative last put into a cell.
    last: HashMap<[u64; 3], u32>,
    /// The one put into the same cell before, for each representative.
    before: Vec<Option<u32>>,
}

/// Excess of half a cell's side over the tolerance. It outweighs the rounding of a coordinate divided by the side
/// (2^-53 of it) as long as there are fewer than 2^26 cells to the origin; further out, neighbouring 32-bit coordinates
/// lie cells apart, so that only equal ones, which share a cell, can be within the tolerance.
const MARGIN: f64 = 1.0 / (1 << 20) as f64;

/// End of the chain of a cell's representatives.
const NONE: Option<u32> = None;

impl Grid {
    fn new(tolerance: f64) -> Self {
        Self { tolerance, side: 2.0 * tolerance * (1.0 + MARGIN), last: HashMap::new(), before: Vec::new() }
    }

    fn id_of(&mut self, position: Vec3, representatives: &[Vec3]) -> u32 {
        let position = position.as_dvec3();
        let scaled = position / self.side;
        let own = scaled.floor();
        let nearer = own + DVec3::select((scaled - own).cmplt(DVec3::splat(0.5)), DVec3::NEG_ONE, DVec3::ONE);
        let mut found = NONE;
        for corner in 0..8 {
            let axis = |i: usize| if corner >> i & 1 == 0 { own[i] } else { nearer[i] };
            let mut next = self.last.get(&cell([axis(0), axis(1), axis(2)])).copied();
            while let Some(id) = next {
                let distance_squared = representatives[id as usize].as_dvec3().distance_squared(position);
                if distance_squared <= self.tolerance * self.tolerance {
                    found = Some(found.map_or(id, |lowest: u32| lowest.min(id)));
                }
                next = self.before[id as usize];
            }
        }
        found.unwrap_or_else(|| self.insert(own, representatives.len() as u32))
    }

    fn insert(&mut self, own: DVec3, id: u32) -> u32 {
        let before = match self.last.entry(cell(own.to_array())) {
            Entry::Occupied(mut entry) => Some(entry.insert(id)),
            Entry::Vacant(entry) => {
                entry.insert(id);
                NONE
            }
        };
        self.before.push(before);
        id
    }
}

/// The name of a cell: its whole-numbered coordinates by their bits, without a -0.0.
fn cell(coordinates: [f64; 3]) -> [u64; 3] {
    coordinates.map(|x| (x + 0.0).to_bits())
}
