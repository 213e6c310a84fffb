//! Which closed part is around which.

use super::{Part, Parts};
use crate::id::FaceId;
use crate::orientation::orientation;
use crate::progress::{Cancelled, Progress};
use glam::Vec3;
use robust::{Coord, orient2d};
use std::collections::HashMap;

/// Points of each part that are looked at: the majority decides, as one of them may lie on the surface of another part.
const SAMPLES: usize = 3;

/// Rays that are looked at between two questions whether to go on: some milliseconds.
const TESTS_BETWEEN_CHECKS: usize = 100_000;

/// For each part the smallest closed part that is around it, if it is closed itself. Memory: O(F).
///
/// From a few corners of each part a ray goes along x. A part is around another if it is crossed an odd number of times. Predicates
/// are exact, and rays are moved infinitesimally to pass no edge. Rays lie in a grid in the plane of y and z, so that each face meets
/// those near it only.
pub(super) fn surroundings(parts: &Parts<'_>, progress: &dyn Progress) -> Result<Vec<Option<usize>>, Cancelled> {
    let mut around = vec![None; parts.parts.len()];
    let solid: Vec<bool> = parts.parts.iter().map(Part::is_solid).collect();
    if solid.iter().filter(|&&is_solid| is_solid).count() < 2 {
        return Ok(around);
    }
    let rays = Rays::new(parts, &solid);
    // Part after part: of nested ones each crosses the rays of all inside of it, which is too much to hold for all of them.
    let mut faces: Vec<u32> = (0..parts.part_of.len() as u32).filter(|&face| solid[parts.of(face)]).collect();
    faces.sort_by_key(|&face| parts.of(face));
    let mut crossings: HashMap<u32, [u32; SAMPLES]> = HashMap::new();
    let mut tests = 0_usize;
    for faces in faces.chunk_by(|&one, &other| parts.of(one) == parts.of(other)) {
        let outer = parts.of(faces[0]);
        let part = &parts.parts[outer];
        for &face in faces {
            let corners = parts.mesh.corners(FaceId::new(face));
            rays.near(corners, |ray| {
                tests += 1;
                let inner = ray.part as usize;
                if inner != outer && part.may_enclose(&parts.parts[inner]) && crosses(ray.from, corners) {
                    crossings.entry(ray.part).or_default()[ray.sample] += 1;
                }
            });
            if tests >= TESTS_BETWEEN_CHECKS {
                tests = 0;
                progress.check()?;
            }
        }
        let size = |part: usize| (parts.parts[part].volume.abs(), part);
        for (inner, counts) in crossings.drain() {
            let odd = counts.iter().filter(|&count| count % 2 == 1).count();
            let slot: &mut Option<usize> = &mut around[inner as usize];
            if 2 * odd > SAMPLES && slot.is_none_or(|known| size(outer) < size(known)) {
                *slot = Some(outer);
            }
        }
    }
    Ok(around)
}

/// A ray along x from a corner of a part.
#[derive(Debug, Clone, Copy)]
struct Ray {
    from: Vec3,
    part: u32,
    sample: usize,
}

/// Rays by where they are in the plane of y and z.
struct Rays {
    min: [f32; 2],
    /// Cells per unit.
    scale: [f64; 2],
    side: usize,
    cells: Vec<Vec<Ray>>,
}

impl Rays {
    /// The rays of all solid parts, in about as many cells.
    fn new(parts: &Parts<'_>, solid: &[bool]) -> Self {
        let mut faces_of: Vec<(usize, usize, usize)> = vec![(usize::MAX, 0, 0); parts.parts.len()];
        for (face, &part) in parts.part_of.iter().enumerate() {
            let (first, last, count) = &mut faces_of[part as usize];
            (*first, *last, *count) = ((*first).min(face), face, *count + 1);
        }
        let mut rays = Vec::new();
        for (part, &(first, last, _)) in faces_of.iter().enumerate().filter(|&(part, _)| solid[part]) {
            let [a, b, _] = parts.mesh.corners(FaceId::from_usize(first));
            let [_, _, c] = parts.mesh.corners(FaceId::from_usize(last));
            let part = part as u32;
            rays.extend([a, b, c].into_iter().enumerate().map(|(sample, from)| Ray { from, part, sample }));
        }
        let flat = rays.iter().map(|ray| [ray.from.y, ray.from.z]);
        let (min, max) = flat.fold(([f32::INFINITY; 2], [f32::NEG_INFINITY; 2]), |(min, max), p| {
            ([min[0].min(p[0]), min[1].min(p[1])], [max[0].max(p[0]), max[1].max(p[1])])
        });
        let side = (rays.len() as f64).sqrt().ceil() as usize;
        let scale =
            [0, 1].map(|axis| side as f64 / (f64::from(max[axis]) - f64::from(min[axis])).max(f64::MIN_POSITIVE));
        let mut grid = Self { min, scale, side, cells: vec![Vec::new(); side * side] };
        for ray in rays {
            let [column, row] = [grid.cell(0, ray.from.y), grid.cell(1, ray.from.z)];
            grid.cells[row * side + column].push(ray);
        }
        grid
    }

    fn cell(&self, axis: usize, coordinate: f32) -> usize {
        let along = (f64::from(coordinate) - f64::from(self.min[axis])) * self.scale[axis];
        (along.max(0.0) as usize).min(self.side - 1)
    }

    /// Visits the rays of the cells that a face covers.
    fn near(&self, corners: [Vec3; 3], mut visit: impl FnMut(Ray)) {
        let [a, b, c] = corners;
        let (low, high) = (a.min(b).min(c), a.max(b).max(c));
        for row in self.cell(1, low.z)..=self.cell(1, high.z) {
            for column in self.cell(0, low.y)..=self.cell(0, high.y) {
                self.cells[row * self.side + column].iter().copied().for_each(&mut visit);
            }
        }
    }
}

/// Whether the ray from a point along x, moved by an infinitesimal along y and by its square along z, crosses a face.
fn crosses(from: Vec3, corners: [Vec3; 3]) -> bool {
    let [a, b, c] = corners;
    let turns = [turn(a, b, from), turn(b, c, from), turn(c, a, from)];
    let is_within = turns.iter().all(|&turn| turn > 0.0) || turns.iter().all(|&turn| turn < 0.0);
    // The face's plane is met ahead if the point is on the side that its normal points away from along x.
    is_within && orientation(a, b, c, from) * turns[0] < 0.0
}

/// How a, b and the moved point turn in the plane of y and z; 0 only where a and b are one point there.
fn turn(a: Vec3, b: Vec3, point: Vec3) -> f64 {
    let flat = |p: Vec3| Coord { x: f64::from(p.y), y: f64::from(p.z) };
    let exact = orient2d(flat(a), flat(b), flat(point));
    // What remains is the derivative along y, and where that vanishes, too, the one along z.
    [exact, f64::from(a.z) - f64::from(b.z), f64::from(b.y) - f64::from(a.y)]
        .into_iter()
        .find(|&value| value != 0.0)
        .unwrap_or(0.0)
}
