//! [`PointGrid`]: the nearest of many points of a picture.

use glam::DVec2;
use std::collections::HashMap;

/// Points by the square cell that they lie in. The side of a cell is the farthest that a search reaches.
#[derive(Debug, Clone, Default)]
pub struct PointGrid {
    reach: f64,
    cells: HashMap<[i32; 2], Vec<u32>>,
    points: Vec<DVec2>,
}

impl PointGrid {
    /// Points to be found within `reach`, above 0. O(points).
    pub fn new(points: Vec<DVec2>, reach: f64) -> Self {
        let mut cells: HashMap<[i32; 2], Vec<u32>> = HashMap::new();
        for (at, &point) in (0..).zip(&points) {
            cells.entry(cell(point, reach)).or_default().push(at);
        }
        Self { reach, cells, points }
    }

    /// The nearest point within reach (included) of those that are wanted, by its index. Of several as near, the first.
    pub fn nearest(&self, point: DVec2, is_wanted: impl Fn(usize) -> bool) -> Option<usize> {
        let [x, y] = cell(point, self.reach);
        let mut nearest: Option<(f64, usize)> = None;
        let around = (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| [x.saturating_add(dx), y.saturating_add(dy)]));
        for &at in around.filter_map(|cell| self.cells.get(&cell)).flatten() {
            let at = at as usize;
            let distance = self.points[at].distance_squared(point);
            let is_nearer = nearest.is_none_or(|best| (distance, at) < best);
            if distance <= self.reach * self.reach && is_nearer && is_wanted(at) {
                nearest = Some((distance, at));
            }
        }
        nearest.map(|(_, at)| at)
    }
}

fn cell(point: DVec2, reach: f64) -> [i32; 2] {
    (point / reach).floor().as_ivec2().to_array()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_nearest_within_reach_is_found(
            points in prop::collection::vec((-9.0_f64..9.0, -9.0_f64..9.0), 0..30),
            at in (-9.0_f64..9.0, -9.0_f64..9.0),
            reach in 0.1_f64..5.0,
        ) {
            let points: Vec<DVec2> = points.into_iter().map(DVec2::from).collect();
            let at = DVec2::from(at);
            let wanted = |index: usize| index % 3 != 1;
            let within = |&(index, point): &(usize, &DVec2)| point.distance(at) <= reach && wanted(index);
            let expected = points.iter().enumerate().filter(within);
            let expected = expected.min_by(|a, b| a.1.distance(at).total_cmp(&b.1.distance(at))).map(|(index, _)| index);
            prop_assert_eq!(PointGrid::new(points.clone(), reach).nearest(at, wanted), expected);
        }
    }
}
