//! [`Pen`]: how wide a line is drawn and on which side of the true line.

/// Where the ink lies relative to an oriented line whose front face is on its left, seen in the image.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum PenPlacement {
    /// Half of the width on either side.
    #[default]
    Centred,
    /// All of it on the left: on the front face, inside the outline.
    Inside,
    /// All of it on the right: beyond the front face, outside the outline.
    Outside,
}

/// How wide a line is drawn and where.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pen {
    /// Width in pixels of the camera's viewport, 0 or more.
    pub width_px: f64,
    /// Where the ink lies.
    pub placement: PenPlacement,
}

impl Pen {
    /// The distances to the left of the line that the ink covers, in pixels: lowest, highest. A width that is negative or
    /// no number counts as 0.
    pub fn span_px(&self) -> [f64; 2] {
        let width_px = self.width_px.max(0.0);
        match self.placement {
            PenPlacement::Centred => [-0.5 * width_px, 0.5 * width_px],
            PenPlacement::Inside => [0.0, width_px],
            PenPlacement::Outside => [-width_px, 0.0],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_placement_covers_the_width() {
        for placement in [PenPlacement::Centred, PenPlacement::Inside, PenPlacement::Outside] {
            let [low, high] = Pen { width_px: 3.0, placement }.span_px();
            assert!((high - low - 3.0).abs() < 1e-12 && low <= 0.0 && high >= 0.0, "{placement:?}");
        }
    }
}
