//! [`FillMetrics`]: what a filled picture scores.

use super::filled_picture::FilledPicture;
use super::{area, boundary, color, holes};
use serde::{Deserialize, Serialize};

/// What a filled picture scores in one view, or averaged over several. Every value is finite.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct FillMetrics {
    /// [`area::xor_share`].
    pub xor_share: f64,
    /// [`boundary::separation`]: Chamfer distance.
    pub boundary_chamfer_px: f64,
    /// [`boundary::separation`]: 95 % Hausdorff distance.
    pub boundary_hausdorff_95_px: f64,
    /// [`holes::hole_pixels`].
    pub hole_pixels: f64,
    /// [`color::psnr_db`].
    pub psnr_db: f64,
    /// [`color::flip`]: with the feature `flip` only.
    #[serde(default)]
    pub flip: Option<f64>,
}

/// Scores a filled picture. O(pixels + boundary in pixels).
///
/// # Panics
/// If picture and truth differ in size.
pub fn measure_fill(drawn: &FilledPicture, truth: &FilledPicture) -> FillMetrics {
    let separation = boundary::separation(drawn.coverage(), truth.coverage());
    FillMetrics {
        xor_share: area::xor_share(drawn.coverage(), truth.coverage()),
        boundary_chamfer_px: separation.chamfer_px,
        boundary_hausdorff_95_px: separation.hausdorff_95_px,
        hole_pixels: holes::hole_pixels(drawn.coverage(), truth.coverage()) as f64,
        psnr_db: color::psnr_db(drawn, truth),
        flip: color::flip(drawn, truth),
    }
}

#[cfg(test)]
mod tests {
    use super::super::ink::Ink;
    use super::super::sample_fill::{SIZE, disc, picture};
    use super::*;
    use glam::DVec2;

    #[test]
    fn every_metric_of_every_empty_combination_is_finite() {
        let (full, blank) = (picture(&disc(DVec2::splat(32.0), 20.0)), picture(&Ink::blank(SIZE, SIZE)));
        for drawn in [&full, &blank] {
            for truth in [&full, &blank] {
                let metrics = serde_json::to_value(measure_fill(drawn, truth)).unwrap();
                for (name, value) in metrics.as_object().unwrap() {
                    let is_unmeasured = name == "flip" && value.is_null();
                    assert!(is_unmeasured || value.as_f64().is_some_and(f64::is_finite), "{name}: {value}");
                }
            }
        }
    }
}
