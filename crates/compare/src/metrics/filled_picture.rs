//! [`FilledPicture`]: a picture of a filled mesh, with its coverage.

use super::ink::Ink;
use silhouette_render::Image;

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

#[cfg(test)]
mod tests {
    use super::*;

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
