//! Pictures of a view: PNG, dark lines on light paper or on a transparent ground.

use super::error::ForeignFault;
use crate::metrics::Ink;
use silhouette_render::Image;

/// The head of a PNG file: its signature, the head of its first chunk, and in that chunk width and height.
const HEAD: usize = 24;

/// The picture, over white paper. Nothing is decoded of one that has another size than the view, whatever its file promises.
///
/// # Errors
/// [`ForeignFault::Form`] for what is no PNG file or a damaged one, [`ForeignFault::WrongSize`].
pub fn read(png: &[u8], size: [u32; 2]) -> Result<Image, ForeignFault> {
    let form = |message: String| ForeignFault::Form { place: "PNG".to_owned(), message };
    let is_png = png.starts_with(b"\x89PNG\r\n\x1a\n") && png.get(12..16) == Some(b"IHDR");
    if !is_png || png.len() < HEAD {
        return Err(form("no picture of this kind; write it as a PNG file".to_owned()));
    }
    let side = |at: usize| u32::from_be_bytes([png[at], png[at + 1], png[at + 2], png[at + 3]]);
    let [width, height] = [side(16), side(20)];
    if [width, height] != size {
        return Err(ForeignFault::WrongSize { found: format!("is {width} x {height} pixels"), wanted: size });
    }
    let mut picture = Image::from_png(png).map_err(|error| form(format!("{error}; write it anew")))?;
    for pixel in picture.rgba.chunks_exact_mut(4) {
        let alpha = u32::from(pixel[3]);
        for part in &mut pixel[..3] {
            *part = ((u32::from(*part) * alpha + 255 * (255 - alpha) + 127) / 255) as u8;
        }
        pixel[3] = 255;
    }
    Ok(picture)
}

/// What the user of a picture should know that seems to be light on dark.
pub fn note(picture: &Image) -> Option<String> {
    let ink = Ink::from_picture(picture).ink_pixels().count();
    let is_dark = 2 * ink > picture.width as usize * picture.height as usize;
    is_dark.then(|| "more than half of its pixels count as ink; lines are to be dark on a light ground".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_transparent_ground_is_paper() {
        let rgba = [[0, 0, 0, 255], [0, 0, 0, 0], [255, 0, 0, 128], [9, 9, 9, 255]].concat();
        let png = Image { width: 2, height: 2, rgba }.to_png().unwrap();
        let picture = read(&png, [2, 2]).unwrap();
        let expected = [[0, 0, 0, 255], [255; 4], [255, 127, 127, 255], [9, 9, 9, 255]].concat();
        assert_eq!(picture.rgba, expected);
        assert_eq!(note(&picture), None);
        let dark = Image { rgba: [[0, 0, 0, 255], [0, 0, 0, 255], [9, 9, 9, 255], [255; 4]].concat(), ..picture };
        assert!(note(&dark).unwrap().contains("dark on a light ground"));
    }

    #[test]
    fn what_is_no_picture_of_the_view_is_refused() {
        let png = Image { width: 3, height: 2, rgba: vec![255; 24] }.to_png().unwrap();
        let refused = |png: &[u8]| read(png, [4, 2]).unwrap_err().to_string();
        assert_eq!(refused(&png), "is 3 x 2 pixels, but the view is 4 x 2 pixels; draw it at that size");
        assert!(refused(b"GIF89a").contains("write it as a PNG file"));
        assert!(refused(&png[..20]).contains("write it as a PNG file"));
        // A file that promises gigabytes is refused by its head.
        let mut huge = png.clone();
        huge[16..24].copy_from_slice(&[0x7f; 8]);
        assert!(refused(&huge).contains("is 2139062143 x 2139062143 pixels"));
        let damaged = read(&png[..png.len() - 20], [3, 2]).unwrap_err().to_string();
        assert!(damaged.starts_with("PNG: ") && damaged.ends_with("write it anew"), "{damaged}");
    }
}
