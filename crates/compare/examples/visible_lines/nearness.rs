//! Whether a place in the picture is close to some lines.

use crate::stretches::{Stretch, Stretches};
use silhouette_compare::truth::SPACING_PX;
use silhouette_core::glam::DVec2;
use std::collections::HashMap;

/// Places along stretches, at most [`SPACING_PX`] apart, each with the length that it stands for in pixels.
pub fn places(stretch: &Stretch) -> impl Iterator<Item = (DVec2, f64)> {
    let [from, to] = stretch.pixels;
    let length = from.distance(to);
    let count = (length / SPACING_PX).ceil();
    (0..count as u32).map(move |part| (from.lerp(to, (f64::from(part) + 0.5) / count), length / count))
}

/// Lines, ready to be asked what is near them.
#[derive(Debug)]
pub struct Nearness {
    /// Places by square cells as wide as the radius.
    cells: HashMap<(i64, i64), Vec<DVec2>>,
    radius_px: f64,
}

impl Nearness {
    /// Lines, and the distance in pixels that counts as near (above 0). O(length in pixels).
    pub fn new(lines: &Stretches, radius_px: f64) -> Self {
        let mut cells: HashMap<_, Vec<_>> = HashMap::new();
        for (place, _) in lines.as_slice().iter().flat_map(places) {
            cells.entry(cell(place, radius_px)).or_default().push(place);
        }
        Self { cells, radius_px }
    }

    /// Whether a line passes within the radius, to half of [`SPACING_PX`].
    pub fn is_near(&self, place: DVec2) -> bool {
        let (x, y) = cell(place, self.radius_px);
        let mut around = (x - 1..=x + 1).flat_map(|x| (y - 1..=y + 1).map(move |y| (x, y)));
        around.any(|cell| {
            self.cells.get(&cell).is_some_and(|places| places.iter().any(|p| p.distance(place) <= self.radius_px))
        })
    }

    /// Length in pixels of what lies farther from the lines than the radius.
    pub fn length_beyond_px(&self, stretches: &Stretches) -> f64 {
        let places = stretches.as_slice().iter().flat_map(places);
        places.filter(|&(place, _)| !self.is_near(place)).map(|(_, length_px)| length_px).sum()
    }
}

fn cell(place: DVec2, size: f64) -> (i64, i64) {
    let cell = (place / size).floor();
    (cell.x as i64, cell.y as i64)
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::EdgeId;

    fn line(from: (f64, f64), to: (f64, f64)) -> Stretches {
        let pixels = [from, to].map(|(x, y)| DVec2::new(x, y));
        Stretches::from_stretches(vec![Stretch { edge: EdgeId::new(0), range: [0.0, 1.0], pixels }])
    }

    #[test]
    fn what_is_farther_than_the_radius_is_measured() {
        let near = Nearness::new(&line((0.0, 0.0), (10.0, 0.0)), 1.0);
        assert!(near.is_near(DVec2::new(3.0, 0.9)) && !near.is_near(DVec2::new(3.0, 1.1)));
        assert!(near.is_near(DVec2::new(-0.7, 0.0)) && !near.is_near(DVec2::new(-1.3, 0.0)));
        // Leaves the neighbourhood a quarter of the way along.
        let leaving = line((5.0, 0.0), (5.0, 4.0));
        assert!((near.length_beyond_px(&leaving) - 3.0).abs() <= SPACING_PX);
        assert!(near.length_beyond_px(&line((0.0, 0.5), (10.0, 0.5))) < 1e-12);
    }
}
