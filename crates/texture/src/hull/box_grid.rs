//! [`BoxGrid`]: boxes that change, found by the place where they are.

use glam::{DVec3, IVec3, Vec3};
use silhouette_core::glam;
use std::collections::HashMap;

/// A box by its smallest and largest coordinates, which belong to it.
pub(super) type Box3 = [Vec3; 2];

/// The box around a triangle.
pub(super) fn box_of([a, b, c]: [Vec3; 3]) -> Box3 {
    [a.min(b).min(c), a.max(b).max(c)]
}

/// Numbered boxes, each listed in all cubes of a grid that it meets. Quick where boxes are about as large as a cube.
#[derive(Debug)]
pub(super) struct BoxGrid {
    origin: DVec3,
    cell: f64,
    boxes: Vec<Option<Box3>>,
    cells: HashMap<IVec3, Vec<u32>>,
}

impl BoxGrid {
    /// A grid without boxes, of cubes of side `cell`, for places within 2³⁰ cubes from `origin`.
    pub(super) fn new(origin: DVec3, cell: f64) -> Self {
        Self { origin, cell, boxes: Vec::new(), cells: HashMap::new() }
    }

    /// Gives a number another box, or none.
    pub(super) fn set(&mut self, number: u32, to: Option<Box3>) {
        let index = number as usize;
        if index >= self.boxes.len() {
            self.boxes.resize(index + 1, None);
        }
        if let Some(from) = std::mem::replace(&mut self.boxes[index], to) {
            for cell in self.cells_of(from) {
                let listed = self.cells.entry(cell).or_default();
                listed.retain(|&other| other != number);
            }
        }
        if let Some(to) = to {
            for cell in self.cells_of(to) {
                self.cells.entry(cell).or_default().push(number);
            }
        }
    }

    /// Whether a number has a box.
    pub(super) fn has(&self, number: u32) -> bool {
        self.boxes.get(number as usize).is_some_and(Option::is_some)
    }

    /// The numbers whose boxes meet one, ascending.
    pub(super) fn meeting(&self, of: Box3) -> Vec<u32> {
        let mut found = Vec::new();
        for listed in self.cells_of(of).filter_map(|cell| self.cells.get(&cell)) {
            let meets = |&&number: &&u32| {
                let other = self.boxes[number as usize];
                other.is_some_and(|other| other[0].cmple(of[1]).all() && of[0].cmple(other[1]).all())
            };
            found.extend(listed.iter().filter(meets));
        }
        found.sort_unstable();
        found.dedup();
        found
    }

    /// The cubes that a box meets. Rounding is monotonic, so boxes with a point in common share a cube.
    fn cells_of(&self, of: Box3) -> impl Iterator<Item = IVec3> + use<> {
        let [low, high] = of.map(|corner| ((corner.as_dvec3() - self.origin) / self.cell).floor().as_ivec3());
        let rows = (low.z..=high.z).flat_map(move |z| (low.y..=high.y).map(move |y| (y, z)));
        rows.flat_map(move |(y, z)| (low.x..=high.x).map(move |x| IVec3::new(x, y, z)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_testing::random::Random;

    /// Boxes that are set, changed and taken away, against a list of them.
    #[test]
    fn boxes_found_are_those_that_meet() {
        let mut random = Random::new(5);
        let mut grid = BoxGrid::new(DVec3::splat(0.1), 0.3);
        let mut all = vec![None; 40];
        let mut found = 0;
        for _ in 0..2000 {
            let corners = [0, 1, 2].map(|_| (random.vector() * 2.0).as_vec3());
            let of = box_of(corners.map(|corner| corners[0].lerp(corner, 0.3)));
            let number = random.below(40);
            all[number] = (!random.one_in(4)).then_some(of);
            grid.set(number as u32, all[number]);
            assert_eq!(grid.has(number as u32), all[number].is_some());
            let asked = box_of([corners[0], corners[1], corners[1]]);
            let meets = |of: Option<Box3>| {
                of.is_some_and(|of: Box3| of[0].cmple(asked[1]).all() && asked[0].cmple(of[1]).all())
            };
            let expected: Vec<u32> = (0..40).filter(|&number| meets(all[number as usize])).collect();
            found += expected.len();
            assert_eq!(grid.meeting(asked), expected);
        }
        assert!(found > 2000);
    }
}
