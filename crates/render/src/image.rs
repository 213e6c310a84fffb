//! Pictures on the CPU.

use std::path::{Path, PathBuf};

/// RGBA bytes as the colour format stores them, row by row from the top, without padding.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Image {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// `4 * width * height` bytes.
    pub rgba: Vec<u8>,
}

/// Values of a depth buffer, row by row from the top.
#[derive(Debug, Clone, PartialEq)]
pub struct DepthImage {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// `width * height` values from 0 to 1.
    pub values: Vec<f32>,
}

/// Whole numbers, row by row from the top.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct IdImage {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// `width * height` values.
    pub values: Vec<u32>,
}

/// An image could not be written.
#[derive(Debug, thiserror::Error)]
#[error("cannot write {}: {cause}", path.display())]
pub struct ImageError {
    /// The file that was asked for.
    pub path: PathBuf,
    /// Why.
    pub cause: image::ImageError,
}

impl Image {
    /// Red, green, blue and alpha of a pixel, counted from the top left.
    ///
    /// # Panics
    /// If the pixel lies outside.
    pub fn pixel(&self, x: u32, y: u32) -> [u8; 4] {
        assert!(x < self.width && y < self.height, "pixel {x},{y} of {}x{}", self.width, self.height);
        let first = 4 * (y as usize * self.width as usize + x as usize);
        std::array::from_fn(|channel| self.rgba[first + channel])
    }

    /// The picture with straight alpha, as files hold it, of one whose colours are premultiplied by alpha. Opaque pixels stay
    /// as they are.
    #[must_use]
    pub fn unpremultiplied(mut self) -> Self {
        for pixel in self.rgba.chunks_exact_mut(4) {
            let alpha = u32::from(pixel[3]);
            if (1..255).contains(&alpha) {
                for part in &mut pixel[..3] {
                    *part = ((u32::from(*part) * 255 + alpha / 2) / alpha).min(255) as u8;
                }
            }
        }
        self
    }

    /// The picture as the bytes of a PNG file.
    ///
    /// # Errors
    /// The encoder's, for pictures larger than the format can hold.
    pub fn to_png(&self) -> Result<Vec<u8>, image::ImageError> {
        let mut png = std::io::Cursor::new(Vec::new());
        let color = image::ExtendedColorType::Rgba8;
        image::write_buffer_with_format(&mut png, &self.rgba, self.width, self.height, color, image::ImageFormat::Png)?;
        Ok(png.into_inner())
    }

    /// The picture that the bytes of a PNG file hold.
    ///
    /// # Errors
    /// The decoder's: these bytes are no PNG file, or a damaged one.
    pub fn from_png(png: &[u8]) -> Result<Self, image::ImageError> {
        let picture = image::load_from_memory_with_format(png, image::ImageFormat::Png)?.into_rgba8();
        Ok(Self { width: picture.width(), height: picture.height(), rgba: picture.into_raw() })
    }

    /// Writes a PNG file: beside its name first, renamed once it is whole.
    ///
    /// # Errors
    /// [`ImageError`]; no file is left half-written.
    pub fn save_png(&self, path: &Path) -> Result<(), ImageError> {
        let mut beside = path.as_os_str().to_owned();
        beside.push(format!(".{}.part", std::process::id()));
        let beside = PathBuf::from(beside);
        self.to_png()
            .and_then(|png| Ok(std::fs::write(&beside, png)?))
            .and_then(|()| Ok(std::fs::rename(&beside, path)?))
            .map_err(|cause| {
                // The part may not exist, and its removal cannot be mended here.
                let _ = std::fs::remove_file(&beside);
                ImageError { path: path.to_owned(), cause }
            })
    }
}

impl DepthImage {
    /// The value of a pixel, counted from the top left.
    ///
    /// # Panics
    /// If the pixel lies outside.
    pub fn value(&self, x: u32, y: u32) -> f32 {
        assert!(x < self.width && y < self.height, "pixel {x},{y} of {}x{}", self.width, self.height);
        self.values[y as usize * self.width as usize + x as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_png_holds_the_same_bytes_and_failures_leave_nothing() {
        let folder = tempfile::tempdir().unwrap();
        let rgba: Vec<u8> = (0..24_u8).map(|i| i * 7).collect();
        let image = Image { width: 3, height: 2, rgba };
        let path = folder.path().join("a.png");
        image.save_png(&path).unwrap();
        assert_eq!(image::open(&path).unwrap().into_rgba8().into_raw(), image.rgba);
        assert_eq!(Image::from_png(&std::fs::read(&path).unwrap()).unwrap(), image);
        assert!(Image::from_png(b"no picture").is_err());
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
        assert_eq!(image.pixel(2, 1), [20, 21, 22, 23].map(|i: u8| i * 7));

        let missing = folder.path().join("missing").join("a.png");
        let message = image.save_png(&missing).unwrap_err().to_string();
        assert!(message.contains("missing"), "{message}");
    }
}
