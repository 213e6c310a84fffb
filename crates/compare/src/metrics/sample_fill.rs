//! Filled shapes drawn by arithmetic for the tests of metrics.

use super::filled_picture::FilledPicture;
use super::ink::Ink;
use glam::DVec2;
use silhouette_render::Image;

/// Width and height of every sample.
pub const SIZE: u32 = 64;

/// Points per pixel along each side that coverage is counted from.
const POINTS: u32 = 32;

fn shape(contains: impl Fn(DVec2) -> bool) -> Ink {
    Ink::from_fn(SIZE, SIZE, |x, y| {
        let offset = |at: u32| (f64::from(at) + 0.5) / f64::from(POINTS);
        let points = (0..POINTS * POINTS).map(|at| DVec2::new(offset(at % POINTS), offset(at / POINTS)));
        let inside = points.filter(|point| contains(DVec2::new(f64::from(x), f64::from(y)) + *point)).count();
        inside as f32 / (POINTS * POINTS) as f32
    })
}

/// A disc.
pub fn disc(center: DVec2, radius: f64) -> Ink {
    shape(|point| point.distance(center) < radius)
}

/// A square by its top left corner.
pub fn square(corner: DVec2, side: f64) -> Ink {
    shape(|point| (point - corner).min_element() >= 0.0 && (point - corner).max_element() < side)
}

/// A shape in mid grey.
pub fn picture(coverage: &Ink) -> FilledPicture {
    let bytes = |&coverage: &f32| [coverage * 128.0, coverage * 128.0, coverage * 128.0, coverage * 255.0];
    let rgba = coverage.coverages().iter().flat_map(bytes).map(|byte| byte.round() as u8).collect();
    FilledPicture::new(Image { width: SIZE, height: SIZE, rgba })
}
