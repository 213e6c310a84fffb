//! [`FillMetrics`]: what a filled picture scores.

use super::ink::Ink;
use super::{area, boundary, color, holes};
use serde::{Deserialize, Serialize};
use silhouette_render::Image;

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

/// A picture of a filled mesh on a transparent ground. Its alpha channel is how much of each pixel the mesh covers, and its
/// colours are premultiplied: what comes of clearing to transparent black, drawing opaque faces and averaging samples.
#[derive(Debug, Clone, PartialEq)]
pub struct FilledPicture {
    image: Image,
    coverage: Ink,
}

impl FilledPicture {
    /// A picture from its RGBA bytes. O(pixels).
    pub fn new(image: Image) -> Self {
        let coverage = Ink::from_fn(image.width, image.height, |x, y| f32::from(image.pixel(x, y)[3]) / 255.0);
        Self { image, coverage }
    }

    /// The picture as it was drawn.
    pub fn image(&self) -> &Image {
        &self.image
    }

    /// How much of each pixel the mesh covers.
    pub fn coverage(&self) -> &Ink {
        &self.coverage
    }

    /// Width and height in pixels.
    pub fn size(&self) -> [u32; 2] {
        [self.image.width, self.image.height]
    }

    /// Red, green and blue of each pixel over white paper, row by row.
    pub fn over_paper(&self) -> Vec<u8> {
        let over = |pixel: &[u8]| {
            let paper = 255 - pixel[3];
            [pixel[0], pixel[1], pixel[2]].map(|color| color.saturating_add(paper))
        };
        self.image.rgba.chunks_exact(4).flat_map(over).collect()
    }

    /// The picture over white paper, for people.
    pub fn to_picture(&self) -> Image {
        let opaque = |rgb: &[u8]| [rgb[0], rgb[1], rgb[2], 255];
        let rgba = self.over_paper().chunks_exact(3).flat_map(opaque).collect();
        Image { width: self.image.width, height: self.image.height, rgba }
    }
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

    #[test]
    fn colours_are_laid_over_paper_and_alpha_is_coverage() {
        let rgba = [[0, 0, 0, 0], [100, 50, 0, 255], [50, 25, 0, 128]].concat();
        let picture = FilledPicture::new(Image { width: 3, height: 1, rgba });
        assert_eq!(picture.over_paper(), [255, 255, 255, 100, 50, 0, 177, 152, 127]);
        assert_eq!(picture.to_picture().rgba[8..], [177, 152, 127, 255]);
        let covered = [0, 1, 2].map(|x| picture.coverage().coverage(x, 0));
        assert_eq!(covered.map(f32::to_bits), [0.0, 1.0, 128.0_f32 / 255.0].map(f32::to_bits));
    }
}
