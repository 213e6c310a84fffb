//! The exact share of each pixel's area that polygons cover.
//!
//! Each edge of a polygon adds, in every row of pixels that it passes, what it covers of the pixels to its right: a
//! trapezium of the pixel that it is in, all of those beyond. Summed along the row this is the signed area of the polygon in
//! each pixel. There is no sampling; the only error is that of adding 64-bit numbers. Overlapping polygons add up, so unite them
//! [first](super::pen) where overlap should count once.

use glam::DVec2;

/// Rows of pixels on which polygons are accumulated.
#[derive(Debug, Clone)]
pub struct CoverageRows {
    width: usize,
    first_row: u32,
    /// Row by row, one cell wider than the picture: the change of coverage from each pixel to the next.
    cells: Vec<f64>,
}

impl CoverageRows {
    /// `rows` rows of `width` pixels from `first_row` of the picture on, nothing covered.
    pub fn new(width: u32, first_row: u32, rows: u32) -> Self {
        let width = width as usize;
        Self { width, first_row, cells: vec![0.0; (width + 1) * rows as usize] }
    }

    /// Adds a closed polygon of points in pixels. Its area counts as positive where it runs clockwise as seen in the picture
    /// (y points down), as negative where it runs the other way. O(points + pixels that its edges pass).
    pub fn add_polygon(&mut self, points: impl Iterator<Item = DVec2> + Clone) {
        let next = points.clone().cycle().skip(1);
        for (from, to) in points.zip(next) {
            self.add_edge(from, to);
        }
    }

    /// The covered share of each pixel, row by row. O(pixels).
    pub fn into_shares(self) -> Vec<f32> {
        let mut shares = Vec::with_capacity(self.cells.len());
        for row in self.cells.chunks_exact(self.width + 1) {
            let sums = row[..self.width].iter().scan(0.0, |sum, change| {
                *sum += change;
                Some(*sum as f32)
            });
            shares.extend(sums);
        }
        shares
    }

    fn add_edge(&mut self, from: DVec2, to: DVec2) {
        let rows = (self.cells.len() / (self.width + 1)) as f64;
        let shift = DVec2::new(0.0, f64::from(self.first_row));
        let (from, to) = (from - shift, to - shift);
        // Upwards in the picture the inside is to the right.
        let (top, bottom, sign) = if from.y < to.y { (from, to, -1.0) } else { (to, from, 1.0) };
        let (begin, end) = (top.y.max(0.0), bottom.y.min(rows));
        if begin >= end {
            return;
        }
        let x_at = |y: f64| top.x + (bottom.x - top.x) * ((y - top.y) / (bottom.y - top.y));
        let mut y = begin;
        let mut row = begin as usize;
        while y < end {
            let next = (row as f64 + 1.0).min(end);
            self.add_in_row(row, [x_at(y), x_at(next)], sign * (next - y));
            y = next;
            row += 1;
        }
    }

    /// A piece of an edge within a row, from one abscissa to another, that covers `height` of the pixels to its right.
    fn add_in_row(&mut self, row: usize, xs: [f64; 2], height: f64) {
        let [left, right] = if xs[0] <= xs[1] { xs } else { [xs[1], xs[0]] };
        let width = self.width as f64;
        if left >= width {
            return;
        }
        let cells = &mut self.cells[row * (self.width + 1)..(row + 1) * (self.width + 1)];
        // What is left of the picture covers whole rows; what is right of it nothing.
        let per_px = if right > left { height / (right - left) } else { 0.0 };
        if left < 0.0 {
            cells[0] += if right <= 0.0 { height } else { -left * per_px };
        }
        let (mut x, end) = (left.max(0.0), right.min(width));
        if left >= 0.0 && right <= left.floor() + 1.0 {
            add_in_pixel(cells, left as usize, 0.5 * (left + right), height);
            return;
        }
        while x < end {
            let next = (x.floor() + 1.0).min(end);
            add_in_pixel(cells, x as usize, 0.5 * (x + next), (next - x) * per_px);
            x = next;
        }
    }
}

/// Adds `height` of what lies to the right of an abscissa within a pixel.
fn add_in_pixel(cells: &mut [f64], pixel: usize, middle: f64, height: f64) {
    let inside = height * (pixel as f64 + 1.0 - middle);
    cells[pixel] += inside;
    cells[pixel + 1] += height - inside;
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn shares(points: &[DVec2], size: u32) -> Vec<f32> {
        let mut rows = CoverageRows::new(size, 0, size);
        rows.add_polygon(points.iter().copied());
        rows.into_shares()
    }

    fn points<const N: usize>(points: [(f64, f64); N]) -> [DVec2; N] {
        points.map(|(x, y)| DVec2::new(x, y))
    }

    #[test]
    fn a_half_plane_cuts_pixels_as_geometry_says() {
        // Below the line y = x / 2 + 0.25, which passes (0, 0.25), (1, 0.75), (1.5, 1), (2, 1.25).
        let below = points([(-9.0, -4.25), (9.0, 4.75), (9.0, 90.0), (-9.0, 90.0)]);
        let shares = shares(&below, 2);
        let expected = [0.5, 0.25 * 0.25, 1.0, 0.9375];
        for (share, expected) in shares.iter().zip(expected) {
            assert!((f64::from(*share) - expected).abs() < 1e-7, "{shares:?}");
        }
    }

    #[test]
    fn a_rectangle_covers_the_product_of_its_overlaps() {
        let rectangle = points([(0.25, 1.5), (2.5, 1.5), (2.5, 3.75), (0.25, 3.75)]);
        let shares = shares(&rectangle, 4);
        let overlap = |at: u32, low: f64, high: f64| {
            let at = f64::from(at);
            (high.min(at + 1.0) - low.max(at)).max(0.0)
        };
        for (at, share) in (0_u32..).zip(&shares) {
            let expected = overlap(at % 4, 0.25, 2.5) * overlap(at / 4, 1.5, 3.75);
            assert!((f64::from(*share) - expected).abs() < 1e-7, "pixel {at}: {share} instead of {expected}");
        }
        let turned: Vec<DVec2> = rectangle.into_iter().rev().collect();
        let negative = self::shares(&turned, 4);
        assert!(shares.iter().zip(&negative).all(|(one, other)| (one + other).abs() < 1e-7), "the sign is the winding");
    }

    #[test]
    fn bands_of_rows_agree_with_the_whole() {
        let polygon = points([(1.3, 0.2), (7.9, 3.3), (5.1, 7.7), (-2.0, 6.1)]);
        let whole = shares(&polygon, 8);
        let mut parts = Vec::new();
        for (first, rows) in [(0, 3), (3, 4), (7, 1)] {
            let mut band = CoverageRows::new(8, first, rows);
            band.add_polygon(polygon.iter().copied());
            parts.extend(band.into_shares());
        }
        assert!(whole.iter().zip(&parts).all(|(one, other)| (one - other).abs() < 1e-6));
    }

    proptest! {
        /// The shares of a polygon within the picture sum up to its area, whatever pixels it passes; beyond the picture's
        /// sides nothing is lost or won inside.
        #[test]
        fn shares_sum_up_to_the_area(corners in prop::collection::vec((-40_i32..200, 0_i32..160), 3..9), left in 0_i32..8) {
            let polygon: Vec<DVec2> =
                corners.iter().map(|&(x, y)| DVec2::new(f64::from(x) / 10.0, f64::from(y) / 10.0)).collect();
            let moved: Vec<DVec2> = polygon.iter().map(|&point| point + DVec2::new(4.0, 0.0)).collect();
            let closed = moved.iter().zip(moved.iter().cycle().skip(1));
            let area: f64 = closed.map(|(one, other)| 0.5 * one.perp_dot(*other)).sum();
            let wide = shares(&moved, 24);
            prop_assert!((wide.iter().map(|&share| f64::from(share)).sum::<f64>() - area).abs() < 1e-4);
            // The same through a window that begins `left` pixels further to the right.
            let mut window = CoverageRows::new(8, 0, 24);
            let shift = DVec2::new(f64::from(left), 0.0);
            window.add_polygon(moved.iter().map(|&point| point - shift));
            for (at, share) in window.into_shares().into_iter().enumerate() {
                let same = wide[at / 8 * 24 + at % 8 + left as usize];
                prop_assert!((share - same).abs() < 1e-5, "{} {}", share, same);
            }
        }
    }
}
