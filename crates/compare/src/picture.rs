//! Side-by-side pictures: what a method drew, the truth, and where they differ.

use crate::metrics::ink::Ink;
use silhouette_render::Image;

/// Colour of ink that is missing: on the true pen, but not drawn.
pub const MISSED: [u8; 4] = [214, 39, 40, 255];
/// Colour of ink that is spurious: drawn, but not on the true pen.
pub const SPURIOUS: [u8; 4] = [31, 119, 180, 255];
/// Colour of ink that agrees.
pub const AGREEING: [u8; 4] = [0, 0, 0, 255];
/// Colour of paper that agrees.
pub const PAPER: [u8; 4] = [255, 255, 255, 255];

/// False colours: [`MISSED`], [`SPURIOUS`], [`AGREEING`] and [`PAPER`], pixel by pixel without tolerance, so that lines
/// moved by less than a pixel show as thin seams.
///
/// # Panics
/// If the pictures differ in size.
pub fn difference(drawn: &Ink, truth: &Ink) -> Image {
    assert_eq!((drawn.width(), drawn.height()), (truth.width(), truth.height()), "pictures of one view");
    let color = |(&drawn, &truth): (&bool, &bool)| match (drawn, truth) {
        (true, true) => AGREEING,
        (true, false) => SPURIOUS,
        (false, true) => MISSED,
        (false, false) => PAPER,
    };
    let rgba = drawn.mask().iter().zip(&truth.mask()).flat_map(color).collect();
    Image { width: drawn.width(), height: drawn.height(), rgba }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_combination_has_its_colour() {
        let drawn = Ink::from_fn(4, 1, |x, _| [1.0, 1.0, 0.0, 0.0][x as usize]);
        let truth = Ink::from_fn(4, 1, |x, _| [1.0, 0.0, 1.0, 0.0][x as usize]);
        assert_eq!(difference(&drawn, &truth).rgba, [AGREEING, SPURIOUS, MISSED, PAPER].concat());
    }
}
