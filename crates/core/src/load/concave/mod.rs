//! Polygons that a fan does not cover: concave ones.
//!
//! 1. Readers [fan](super::polygon::fan) every polygon, because a file may name vertices before it states them, and
//!    remember where polygons of four or more corners are ([`Polygons`]).
//! 2. Once all positions are known, each fan is tested: its triangles must not face away from the polygon. The fan of a
//!    convex polygon passes, and stays.
//! 3. Of any other, the corners are [projected](plane) along the polygon's normal,
//! 4. and [ears are clipped](ear_clipping). There are as many triangles as in the fan, whose place they take.
//!
//! A polygon that crosses itself has no such triangles; it remains a fan, and a [`Note`] counts it.

mod box_tree;
mod ear_clipping;
mod plane;

use self::ear_clipping::EarClipping;
use super::notes::Note;
use crate::id::FaceId;
use glam::{DVec3, Vec3};

/// Where among a mesh's triangles the fans of polygons are that have four or more corners.
#[derive(Default)]
pub(super) struct Polygons {
    runs: Vec<Run>,
}

/// Successive polygons with equally many corners.
struct Run {
    /// The first triangle of the first polygon.
    first: usize,
    triangles_per_polygon: usize,
    polygons: usize,
}

impl Run {
    fn end(&self) -> usize {
        self.first + self.triangles_per_polygon * self.polygons
    }
}

impl Polygons {
    /// Takes a polygon whose fan begins with triangle `first`.
    pub(super) fn begin(&mut self, first: usize, corners: usize) {
        if corners <= 3 {
            return;
        }
        let triangles_per_polygon = corners - 2;
        let continues = |run: &&mut Run| run.triangles_per_polygon == triangles_per_polygon && run.end() == first;
        match self.runs.last_mut().filter(continues) {
            Some(run) => run.polygons += 1,
            None => self.runs.push(Run { first, triangles_per_polygon, polygons: 1 }),
        }
    }

    /// Replaces the fans that fold over by triangles that do not, and counts those that remain. All corners must be among
    /// `positions`.
    ///
    /// O(corners) for fans that stay; O(n log n) for most concave polygons of n corners, never more than O(n) with the
    /// factor [`ear_clipping::MOST_STEPS`].
    pub(super) fn triangulate(&self, positions: &[Vec3], triangles: &mut [[u32; 3]]) -> Option<Note> {
        let mut triangulation = Triangulation { positions, ears: EarClipping::default() };
        let mut crossing: Option<(u64, FaceId)> = None;
        for run in &self.runs {
            let polygons = triangles[run.first..run.end()].chunks_exact_mut(run.triangles_per_polygon);
            for (polygon, fan) in polygons.enumerate() {
                if !triangulation.unfold(fan) {
                    let first = || FaceId::from_usize(run.first + polygon * run.triangles_per_polygon);
                    crossing.get_or_insert_with(|| (0, first())).0 += 1;
                }
            }
        }
        crossing.map(|(count, first)| Note::CrossingPolygons { count, first })
    }
}

struct Triangulation<'a> {
    positions: &'a [Vec3],
    ears: EarClipping,
}

impl Triangulation<'_> {
    /// Replaces a fan if it folds over. False if it does and there is nothing better.
    fn unfold(&mut self, fan: &mut [[u32; 3]]) -> bool {
        // Most polygons are convex quadrilaterals: for those, half the work will do.
        if let &mut [one, other] = fan
            && area_vector(self.positions, one).dot(area_vector(self.positions, other)) > 0.0
        {
            return true;
        }
        let normal = normal(self.positions, fan);
        if fan.iter().all(|&triangle| area_vector(self.positions, triangle).dot(normal) >= 0.0) {
            // A bow tie has no normal either, but areas.
            return normal != DVec3::ZERO
                || fan.iter().all(|&triangle| area_vector(self.positions, triangle) == DVec3::ZERO);
        }
        let corners = fan[0][..2].iter().copied().chain(fan.iter().map(|triangle| triangle[2]));
        let corners: Vec<u32> = corners.collect();
        let position = |&corner: &u32| self.positions[corner as usize].as_dvec3();
        plane::project(corners.iter().map(position), normal, self.ears.points());
        let Some(triangles) = self.ears.clip() else { return false };
        for (triangle, slots) in fan.iter_mut().zip(triangles) {
            *triangle = slots.map(|slot| corners[slot as usize]);
        }
        true
    }
}

/// The normal of a polygon after Newell, twice its area long: the sum over any triangles that make it up.
fn normal(positions: &[Vec3], triangles: &[[u32; 3]]) -> DVec3 {
    triangles.iter().map(|&triangle| area_vector(positions, triangle)).sum()
}

/// The normal of a triangle, twice its area long. Exactly 0 for collinear corners whose coordinates are of similar size.
fn area_vector(positions: &[Vec3], triangle: [u32; 3]) -> DVec3 {
    let [a, b, c] = triangle.map(|vertex| positions[vertex as usize].as_dvec3());
    (b - a).cross(c - a)
}
