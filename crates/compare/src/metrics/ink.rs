//! [`Ink`]: a picture reduced to how much of each pixel is drawn.

use glam::DVec2;
use silhouette_render::Image;

/// A pixel counts as ink from this coverage on: the pixel's nearest value if the picture had no grey.
pub const INK_THRESHOLD: f32 = 0.5;

/// How much of each pixel a method drew, 0 (paper) to 1 (black), row by row from the top left.
#[derive(Debug, Clone, PartialEq)]
pub struct Ink {
    width: u32,
    height: u32,
    coverage: Vec<f32>,
}

impl Ink {
    /// Paper without ink.
    pub fn blank(width: u32, height: u32) -> Self {
        Self { width, height, coverage: vec![0.0; width as usize * height as usize] }
    }

    /// Coverage as a function of column and row; values are clamped to 0..=1, and NaN counts as paper.
    pub fn from_fn(width: u32, height: u32, mut coverage: impl FnMut(u32, u32) -> f32) -> Self {
        let mut ink = Self::blank(width, height);
        for y in 0..height {
            for x in 0..width {
                ink.set(x, y, coverage(x, y));
            }
        }
        ink
    }

    /// Darkness of a picture of black ink on white paper whose bytes are linear in coverage: 1 minus the mean of red,
    /// green and blue.
    pub fn from_picture(picture: &Image) -> Self {
        Self::from_fn(picture.width, picture.height, |x, y| {
            let [r, g, b, _] = picture.pixel(x, y).map(f32::from);
            1.0 - (r + g + b) / (3.0 * 255.0)
        })
    }

    /// The picture of which [`from_picture`](Self::from_picture) makes this ink, up to the rounding of its bytes.
    pub fn to_picture(&self) -> Image {
        let gray = self.coverage.iter().map(|coverage| ((1.0 - coverage) * 255.0).round() as u8);
        let rgba = gray.flat_map(|gray| [gray, gray, gray, 255]).collect();
        Image { width: self.width, height: self.height, rgba }
    }

    /// Width in pixels.
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Height in pixels.
    pub fn height(&self) -> u32 {
        self.height
    }

    /// Length of the picture's diagonal in pixels: what distances are where there is nothing to measure to.
    pub fn diagonal_px(&self) -> f64 {
        f64::from(self.width).hypot(f64::from(self.height))
    }

    /// Coverage of a pixel; 0 outside of the picture.
    pub fn coverage(&self, x: i64, y: i64) -> f32 {
        let inside = (0..i64::from(self.width)).contains(&x) && (0..i64::from(self.height)).contains(&y);
        if inside { self.coverage[y as usize * self.width as usize + x as usize] } else { 0.0 }
    }

    /// Sets the coverage of a pixel, clamped to 0..=1; NaN counts as paper.
    ///
    /// # Panics
    /// If the pixel is outside of the picture.
    pub fn set(&mut self, x: u32, y: u32, coverage: f32) {
        assert!(x < self.width && y < self.height, "pixel {x},{y} is outside of {}x{}", self.width, self.height);
        let coverage = if coverage.is_nan() { 0.0 } else { coverage.clamp(0.0, 1.0) };
        self.coverage[y as usize * self.width as usize + x as usize] = coverage;
    }

    /// Whether a pixel counts as ink.
    pub fn is_ink(&self, x: i64, y: i64) -> bool {
        self.coverage(x, y) >= INK_THRESHOLD
    }

    /// Coverage of each pixel, row by row.
    pub fn coverages(&self) -> &[f32] {
        &self.coverage
    }

    /// Which pixels count as ink, row by row.
    pub fn mask(&self) -> Vec<bool> {
        self.coverage.iter().map(|&coverage| coverage >= INK_THRESHOLD).collect()
    }

    /// Columns and rows of the ink pixels, row by row.
    pub fn ink_pixels(&self) -> impl Iterator<Item = (u32, u32)> + '_ {
        let width = self.width as usize;
        let is_ink = |&(_, &coverage): &(usize, &f32)| coverage >= INK_THRESHOLD;
        self.coverage.iter().enumerate().filter(is_ink).map(move |(at, _)| ((at % width) as u32, (at / width) as u32))
    }

    /// Whether the area of some ink pixel (its closed square) lies within `tolerance_px` of a point in pixel
    /// coordinates. O(tolerance squared).
    pub fn has_ink_within(&self, point: DVec2, tolerance_px: f64) -> bool {
        let low = (point - tolerance_px).floor().as_i64vec2();
        let high = (point + tolerance_px).floor().as_i64vec2();
        // A point on the side of a pixel touches the pixel before it too, hence `low - 1`.
        (low.y - 1..=high.y).any(|y| {
            (low.x - 1..=high.x).any(|x| {
                let corner = DVec2::new(x as f64, y as f64);
                let nearest = point.clamp(corner, corner + 1.0);
                nearest.distance_squared(point) <= tolerance_px * tolerance_px && self.is_ink(x, y)
            })
        })
    }

    /// Coverage at a point in pixel coordinates, linear between pixel centres.
    pub fn sample(&self, point: DVec2) -> f64 {
        let corner = (point - 0.5).floor();
        let [fx, fy] = (point - 0.5 - corner).to_array();
        let at = |dx: i64, dy: i64| f64::from(self.coverage(corner.x as i64 + dx, corner.y as i64 + dy));
        let top = at(0, 0) * (1.0 - fx) + at(1, 0) * fx;
        let bottom = at(0, 1) * (1.0 - fx) + at(1, 1) * fx;
        top * (1.0 - fy) + bottom * fy
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tolerance_is_measured_to_the_area_of_a_pixel() {
        let mut ink = Ink::blank(10, 10);
        ink.set(5, 5, 1.0);
        let near = |x, y, tolerance| ink.has_ink_within(DVec2::new(x, y), tolerance);
        assert!(near(5.2, 5.9, 0.0), "inside");
        assert!(near(6.0, 6.0, 0.0), "on the corner");
        assert!(near(6.5, 5.5, 0.5) && !near(6.51, 5.5, 0.5), "half a pixel to the right");
        assert!(near(6.375, 6.5, 0.625) && !near(6.375, 6.5, 0.62), "a 3-4-5 triangle off the corner");
        assert!(!near(-4.0, 1e6, 2.0), "outside of the picture");
    }

    #[test]
    fn coverage_is_clamped_and_nan_is_paper() {
        let ink = Ink::from_fn(3, 1, |x, _| [f32::NAN, -3.0, 7.0][x as usize]);
        assert_eq!([0, 1, 2].map(|x| ink.coverage(x, 0).to_bits()), [0.0, 0.0, 1.0].map(f32::to_bits));
        assert_eq!(ink.ink_pixels().collect::<Vec<_>>(), [(2, 0)]);
        assert_eq!((ink.coverage(-1, 0), ink.coverage(3, 0)), (0.0, 0.0));
    }

    #[test]
    fn sampling_is_exact_at_pixel_centres_and_linear_between() {
        let ink = Ink::from_fn(2, 1, |x, _| x as f32);
        assert!((ink.sample(DVec2::new(0.5, 0.5))).abs() < 1e-12);
        assert!((ink.sample(DVec2::new(1.5, 0.5)) - 1.0).abs() < 1e-12);
        assert!((ink.sample(DVec2::new(0.75, 0.5)) - 0.25).abs() < 1e-12);
    }

    #[test]
    fn black_on_white_becomes_coverage() {
        let rgba = [[0; 4], [255; 4], [127; 4]].concat();
        let ink = Ink::from_picture(&Image { width: 3, height: 1, rgba });
        assert_eq!((ink.coverage(0, 0), ink.coverage(1, 0)), (1.0, 0.0));
        assert!(ink.is_ink(2, 0), "a byte of 127 is just darker than half");
        assert_eq!(ink.to_picture().rgba, [[0, 0, 0, 255], [255; 4], [127, 127, 127, 255]].concat());
    }
}
