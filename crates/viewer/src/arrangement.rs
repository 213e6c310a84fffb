//! [`Arrangement`]: where the pictures of one or two methods lie, and the divider between them.

use eframe::egui::{Pos2, Rect, pos2};

/// How many methods are on screen, and how they share it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Arrangement {
    /// One method.
    #[default]
    One,
    /// Two, each with a picture of its own.
    SideBySide,
    /// Two in one picture, the first on the left of the divider, the second on its right.
    Divided,
}

impl Arrangement {
    /// Every arrangement with its name on screen.
    pub const NAMED: [(&'static str, Self); 3] =
        [("one method", Self::One), ("side by side", Self::SideBySide), ("divided picture", Self::Divided)];

    /// How many methods there are.
    pub fn panes(self) -> usize {
        if self == Self::One { 1 } else { 2 }
    }

    /// Where the picture of each method lies, in pixels, with the divider at a share of the width.
    pub fn places(self, area: PixelRect, divider: f32) -> Vec<Place> {
        let PixelRect { min: [x, y], size: [width, height] } = area;
        let left = ((width as f32 * divider).round() as u32).clamp(1, width.max(2) - 1);
        let part =
            |from: u32, to: u32| PixelRect { min: [x + from, y], size: [to.saturating_sub(from).max(1), height] };
        let (first, second) = (part(0, left), part(left, width));
        match self {
            Self::One => vec![Place { picture: area, shown: area }],
            Self::SideBySide => [first, second].map(|place| Place { picture: place, shown: place }).into(),
            Self::Divided => [first, second].map(|place| Place { picture: area, shown: place }).into(),
        }
    }
}

/// Where a picture lies, and what of it is shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Place {
    /// All of the picture.
    pub picture: PixelRect,
    /// The part that is shown.
    pub shown: PixelRect,
}

/// A rectangle of whole pixels of the window.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PixelRect {
    /// Top left corner.
    pub min: [u32; 2],
    /// Width and height, 1 or more.
    pub size: [u32; 2],
}

impl PixelRect {
    /// The pixels that lie within a rectangle in points, at least one.
    pub fn within(rect: Rect, pixels_per_point: f32) -> Self {
        let [low, high] = [rect.min, rect.max].map(|corner| [corner.x, corner.y].map(|side| side * pixels_per_point));
        let min = low.map(|side| side.ceil().max(0.0) as u32);
        let size = [0, 1].map(|axis| (high[axis].floor().max(0.0) as u32).saturating_sub(min[axis]).max(1));
        Self { min, size }
    }

    /// The same in points.
    pub fn to_points(self, pixels_per_point: f32) -> Rect {
        let corner = |pixels: [u32; 2]| -> Pos2 {
            let [x, y] = pixels.map(|side| side as f32 / pixels_per_point);
            pos2(x, y)
        };
        let [width, height] = self.size;
        Rect { min: corner(self.min), max: corner([self.min[0] + width, self.min[1] + height]) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const AREA: PixelRect = PixelRect { min: [10, 20], size: [101, 50] };

    #[test]
    fn what_is_shown_covers_the_area_without_overlap() {
        for (name, arrangement) in Arrangement::NAMED {
            for divider in [0.0, 0.01, 0.5, 0.999, 1.0] {
                let places = arrangement.places(AREA, divider);
                assert_eq!(places.len(), arrangement.panes());
                let widths: u32 = places.iter().map(|place| place.shown.size[0]).sum();
                assert_eq!(widths, AREA.size[0], "{name} {divider}");
                assert!(places.iter().all(|place| place.shown.size[0] > 0));
                assert!(
                    places.windows(2).all(|pair| pair[0].shown.min[0] + pair[0].shown.size[0] == pair[1].shown.min[0])
                );
            }
        }
        let divided = Arrangement::Divided.places(AREA, 0.5);
        assert!(divided.iter().all(|place| place.picture == AREA), "both show the same view");
    }

    #[test]
    fn pixels_are_whole_at_any_scale() {
        for scale in [1.0, 1.25, 1.5, 2.0] {
            let rect = Rect { min: pos2(3.3, 0.0), max: pos2(200.7, 100.2) };
            let pixels = PixelRect::within(rect, scale);
            let back = pixels.to_points(scale);
            assert!(rect.expand(1e-3).contains_rect(back), "{scale}: {back}");
            assert!((back.width() - rect.width()).abs() < 2.0 / scale + 1e-3);
        }
        let none = Rect { min: pos2(5.0, 5.0), max: pos2(4.0, 4.0) };
        assert_eq!(PixelRect::within(none, 1.0).size, [1, 1]);
    }
}
