//! How coordinates become positions: as 32-bit numbers, or read in 64 bits and counted from an origin; and which of both a file needs.

use super::notes::Note;
use crate::mesh::{Bounds, TriangleMesh};
use crate::origin::{FARTHEST, origin_between};
use glam::{DVec3, Vec3};
use rayon::prelude::*;

/// Makes 32-bit positions of coordinates, and learns what they lose.
#[derive(Debug, Clone, Copy)]
pub(super) struct Placing {
    /// `None`: coordinates are read as 32-bit numbers, rounded once, and are positions. The fast way, right for most meshes.
    wide: Option<Wide>,
}

/// Coordinates are read as 64-bit numbers.
#[derive(Debug, Clone, Copy)]
struct Wide {
    /// From where positions count.
    origin: DVec3,
    /// The largest that a coordinate has lost so far.
    rounding: f64,
}

/// How often a file is read anew at most: each time, what is left of a far mesh shrinks by 2^16 or more.
pub(super) const MOST_ATTEMPTS: usize = 4;

/// Faces that are looked at to learn whether a mesh may need more than 32-bit coordinates, so that the others pay nothing for it.
const SAMPLE: usize = 4096;

/// A side of a face no longer than so many times what rounding moves its ends is one whose direction rounding may change by
/// degrees.
const SHORT: f64 = 64.0;

/// One side in so many must be short to be worth a note.
const SHORT_SIDES: usize = 1000;

impl Placing {
    pub(super) const NARROW: Self = Self { wide: None };

    fn wide(origin: DVec3) -> Self {
        Self { wide: Some(Wide { origin, rounding: 0.0 }) }
    }

    /// Whether coordinates are to be read as 64-bit numbers.
    pub(super) fn is_wide(&self) -> bool {
        self.wide.is_some()
    }

    /// From where positions count.
    pub(super) fn origin(&self) -> DVec3 {
        self.wide.map_or(DVec3::ZERO, |wide| wide.origin)
    }

    /// The position along an axis of a coordinate. Infinite where it is beyond 32 bits.
    #[inline]
    pub(super) fn place(&mut self, axis: usize, coordinate: f64) -> f32 {
        let Some(wide) = &mut self.wide else { return coordinate as f32 };
        let position = coordinate - wide.origin[axis];
        let rounded = position as f32;
        wide.rounding = wide.rounding.max((position - f64::from(rounded)).abs());
        rounded
    }

    /// The same of a whole number, rounded once, not by way of 64-bit floats.
    pub(super) fn place_integer(&mut self, axis: usize, coordinate: i128) -> f32 {
        let Some(wide) = &mut self.wide else { return coordinate as f32 };
        if wide.origin[axis].fract() != 0.0 {
            return self.place(axis, coordinate as f64);
        }
        let position = coordinate - wide.origin[axis] as i128;
        let rounded = position as f32;
        wide.rounding = wide.rounding.max((position - rounded as i128).unsigned_abs() as f64);
        rounded
    }

    /// How the file of a mesh that was read so is better read anew, if it is. O(1) for meshes that are close to zero and whose
    /// edges are long, otherwise O(F).
    pub(super) fn better(&self, mesh: &TriangleMesh) -> Option<Self> {
        let sampled = || mesh.triangles().iter().step_by(mesh.face_count().div_ceil(SAMPLE).max(1));
        let seen = Bounds::of(sampled().flatten().map(|&vertex| mesh.positions()[vertex as usize]))?;
        if may_be_far(&seen) {
            let bounds = mesh.bounds()?;
            let step = origin_between(bounds.min, bounds.max);
            if step != DVec3::ZERO {
                return Some(Self::wide(self.origin() + step));
            }
        }
        let rounding = seen.min.abs().max(seen.max.abs()).max_element() * f64::from(f32::EPSILON) / 2.0;
        let short =
            sampled().flat_map(|&triangle| sides(mesh, triangle)).filter(|&side| is_short(side, rounding)).count();
        let are_many = short * SHORT_SIDES >= 3 * sampled().len();
        (!self.is_wide() && short > 0 && are_many).then(|| Self::wide(DVec3::ZERO))
    }

    /// What its user should know of what rounding did to a mesh. O(F) where coordinates were read as 64-bit numbers.
    pub(super) fn note(&self, mesh: &TriangleMesh) -> Option<Note> {
        let rounding = self.wide?.rounding;
        let all = mesh.triangles().par_iter().flat_map_iter(|&triangle| sides(mesh, triangle));
        let short = all.filter(|&side| is_short(side, rounding)).count();
        let are_many = short > 0 && short * SHORT_SIDES >= 3 * mesh.face_count();
        are_many.then_some(Note::Rounded { distance: rounding, sides: short, of: 3 * mesh.face_count() })
    }
}

/// Whether a mesh of which this part has been seen may need an origin. The part is no larger than the whole, and closer to zero by the
/// whole's extent at most.
fn may_be_far(part: &Bounds) -> bool {
    let reach = part.min.abs().max(part.max.abs()).max_element();
    reach > (FARTHEST - 1.0) * (part.max - part.min).max_element()
}

fn is_short(side: f64, rounding: f64) -> bool {
    side > 0.0 && side < SHORT * rounding
}

/// The lengths of a face's sides.
fn sides(mesh: &TriangleMesh, triangle: [u32; 3]) -> impl Iterator<Item = f64> {
    let [a, b, c] = triangle.map(|vertex| mesh.positions()[vertex as usize]).map(Vec3::as_dvec3);
    [a.distance(b), b.distance(c), c.distance(a)].into_iter()
}
