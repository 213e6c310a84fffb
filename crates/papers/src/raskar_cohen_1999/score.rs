//! One picture, scored: the metrics of [`crate::metrics`], and what shows through.

use silhouette_compare::metrics::distance_transform::distance_transform;
use silhouette_compare::metrics::{Ink, LineMetrics, TruePen, measure};
use silhouette_compare::truth::TrueLines;

/// Ink farther than this from every silhouette edge, visible or not, shows through from behind.
pub const BLEED_PX: f64 = 5.0;

/// Ink is a stray where it lies farther beyond a pen's width than this.
const STRAY_PX: f64 = 1.0;

/// The score of a picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Score {
    /// Against the visible lines.
    pub metrics: LineMetrics,
    /// Ink in pixels over the length of the visible lines: their width if there were no other ink.
    pub ink_over_length_px: f64,
    /// Share of the ink farther than the pen's width and a pixel from every visible line, on either side, so that it does
    /// not depend on where the true pen lies.
    pub stray: f64,
    /// Share of the ink farther than [`BLEED_PX`] from every silhouette edge, visible or not.
    pub bleed: f64,
    /// Distance of the farthest ink from every silhouette edge, in pixels; 0 without ink.
    pub farthest_px: f64,
}

/// Scores `ink` against the visible lines and, for what shows through, against `all_lines`. O(pixels + samples).
///
/// # Panics
/// If ink and true pen differ in size.
pub fn score(ink: &Ink, visible: &TrueLines, all_lines: &TrueLines, pen: TruePen<'_>) -> Score {
    let pixels = ink.ink_pixels().count() as f64;
    let share = |count: usize| if pixels > 0.0 { count as f64 / pixels } else { 0.0 };
    let (to_all, to_visible) = (distances(ink, all_lines), distances(ink, visible));
    let reach = pen.width_px + STRAY_PX;
    let length = visible.total_length_px();
    Score {
        metrics: measure(ink, visible, pen),
        ink_over_length_px: if length > 0.0 { pixels / length } else { 0.0 },
        stray: share(to_visible.iter().filter(|&&distance| distance > reach).count()),
        bleed: share(to_all.iter().filter(|&&distance| distance > BLEED_PX).count()),
        farthest_px: to_all.into_iter().fold(0.0, f64::max),
    }
}

/// Distance of every ink pixel from the nearest pixel that a line runs through.
fn distances(ink: &Ink, lines: &TrueLines) -> Vec<f64> {
    let mut near = Ink::blank(ink.width(), ink.height());
    for sample in &lines.samples {
        let [x, y] = sample.pixel.floor().to_array().map(|at| at.max(0.0) as u32);
        near.set(x.min(ink.width() - 1), y.min(ink.height() - 1), 1.0);
    }
    let distance = distance_transform(&near.mask(), ink.width() as usize);
    ink.ink_pixels().map(|(x, y)| distance[(y * ink.width() + x) as usize]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec2;
    use silhouette_compare::truth::visible::VisibleLine;
    use silhouette_core::EdgeId;

    fn level_line() -> TrueLines {
        let points = [4.0, 28.0].map(|x| DVec2::new(x, 16.0)).to_vec();
        TrueLines::of(&[VisibleLine { points, edges: vec![EdgeId::new(0)], closed: false }])
    }

    fn score_of(is_ink: impl Fn(u32, u32) -> bool) -> Score {
        let lines = level_line();
        let ink = Ink::from_fn(32, 32, |x, y| f32::from(u8::from(is_ink(x, y))));
        score(&ink, &lines, &lines, TruePen { picture: &ink, width_px: 2.0 })
    }

    #[test]
    fn a_line_has_its_width_and_nothing_shows_through() {
        let line = |x: u32, y: u32| (4..28).contains(&x) && (15..17).contains(&y);
        let score = score_of(line);
        assert!((score.ink_over_length_px - 2.0).abs() < 1e-12 && score.bleed.abs() < 1e-12);
        assert!((score.farthest_px - 1.0).abs() < 1e-12, "{score:?}");
    }

    #[test]
    fn a_stain_far_from_every_line_shows_through_and_one_nearby_does_not() {
        let line = |x: u32, y: u32| (4..28).contains(&x) && (15..17).contains(&y);
        let stained = score_of(|x, y| line(x, y) || (y == 28 && x < 12));
        assert!((stained.stray - 12.0 / 60.0).abs() < 1e-12, "{stained:?}");
        assert!((stained.bleed - 12.0 / 60.0).abs() < 1e-12 && stained.farthest_px >= 12.0, "{stained:?}");
        assert!(score_of(|x, y| line(x, y) || (y == 20 && (4..28).contains(&x))).bleed.abs() < 1e-12);
        let blank = score_of(|_, _| false);
        assert!(blank.farthest_px.abs() < 1e-12 && blank.bleed.abs() < 1e-12);
    }
}
