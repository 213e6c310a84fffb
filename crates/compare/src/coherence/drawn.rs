//! [`DrawnFrame`]: what a method drew of a frame, asked where its line is at a place of the truth.

use super::places::TruePlace;
use super::{BARE_BEYOND, DRAWN_WITHIN, reference_scale};
use crate::metrics::boundary;
use crate::metrics::ink::{INK_THRESHOLD, Ink};
use crate::metrics::point_grid::PointGrid;
use glam::DVec2;

/// How far across the true line a drawn line is looked for, in reference pixels.
pub const OFFSET_REACH: f64 = 10.0;

/// Steps in which a picture is read across a line, in its own pixels.
const PROFILE_STEP_PX: f64 = 0.25;

/// Distance between points that stand for drawn lines, in reference pixels.
const LINE_SPACING: f64 = 1.0;

/// Whether a method draws a line at a place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum State {
    /// Its line lies within [`DRAWN_WITHIN`].
    Drawn,
    /// Between the two.
    Doubtful,
    /// None of its lines lies within [`BARE_BEYOND`].
    Bare,
}

/// What a method drew of a frame.
#[derive(Debug, Clone)]
pub enum DrawnFrame {
    /// A picture of lines.
    Picture(Ink),
    /// Lines as geometry.
    Lines(DrawnLines),
}

/// Lines as geometry, in reference pixels.
#[derive(Debug, Clone)]
pub struct DrawnLines {
    segments: Vec<[DVec2; 2]>,
    /// The segment of each point of the grid.
    segment_of: Vec<u32>,
    grid: PointGrid,
}

impl DrawnFrame {
    /// Straight pieces of lines, in pixels of a picture of this height. O(length).
    pub fn lines(segments: impl Iterator<Item = [DVec2; 2]>, height_px: u32) -> Self {
        let scale = reference_scale(height_px);
        let segments: Vec<[DVec2; 2]> = segments.map(|ends| ends.map(|end| end * scale)).collect();
        let (mut points, mut segment_of) = (Vec::new(), Vec::new());
        for (at, &[from, to]) in (0..).zip(&segments) {
            let count = (from.distance(to) / LINE_SPACING).ceil().max(1.0);
            for part in 0..count as u32 {
                points.push(from.lerp(to, (f64::from(part) + 0.5) / count));
                segment_of.push(at);
            }
        }
        Self::Lines(DrawnLines { segments, segment_of, grid: PointGrid::new(points, OFFSET_REACH + LINE_SPACING) })
    }

    /// The boundary of a filled picture by its coverage. O(pixels).
    pub fn boundary(coverage: &Ink) -> Self {
        Self::lines(boundary::boundary(coverage).into_iter(), coverage.height())
    }

    /// Whether a line is drawn at a place.
    pub fn state(&self, place: &TruePlace) -> State {
        let is_within = |distance: f64| match self {
            Self::Picture(ink) => {
                let scale = reference_scale(ink.height());
                ink.has_ink_within(place.at / scale, distance / scale)
            }
            Self::Lines(lines) => lines.nearest(place.at).is_some_and(|at| at.distance(place.at) <= distance),
        };
        if is_within(DRAWN_WITHIN) {
            State::Drawn
        } else if is_within(BARE_BEYOND) {
            State::Doubtful
        } else {
            State::Bare
        }
    }

    /// How far the middle of the nearest drawn line lies from a place along its normal, in reference pixels. `None` where there
    /// is none within [`OFFSET_REACH`], or one that ends beside the place.
    pub fn offset(&self, place: &TruePlace) -> Option<f64> {
        match self {
            Self::Picture(ink) => profile_offset(ink, place),
            Self::Lines(lines) => {
                let off = lines.nearest(place.at)? - place.at;
                let (across, along) = (off.dot(place.normal), off.perp_dot(place.normal).abs());
                (across.abs() <= OFFSET_REACH && along <= LINE_SPACING + 0.5 * across.abs()).then_some(across)
            }
        }
    }
}

impl DrawnLines {
    /// The point of a line that is nearest, of the segments that the nearest points stand for.
    fn nearest(&self, place: DVec2) -> Option<DVec2> {
        let at = self.grid.nearest(place, |_| true)?;
        let [from, to] = self.segments[self.segment_of[at] as usize];
        let along = to - from;
        let square = along.length_squared();
        let share = if square > 0.0 { ((place - from).dot(along) / square).clamp(0.0, 1.0) } else { 0.0 };
        Some(from + along * share)
    }
}

/// The middle of the ink nearest to the place in a profile across it: ink that begins and ends within reach.
fn profile_offset(ink: &Ink, place: &TruePlace) -> Option<f64> {
    let scale = reference_scale(ink.height());
    let (center, reach) = (place.at / scale, OFFSET_REACH / scale);
    let steps = (2.0 * reach / PROFILE_STEP_PX).ceil() as u32;
    let threshold = f64::from(INK_THRESHOLD);
    let at_step = |step: u32| -reach + 2.0 * reach * f64::from(step) / f64::from(steps);
    let mut nearest: Option<(f64, f64)> = None;
    let mut begin: Option<f64> = None;
    let mut before = ink.sample(center + place.normal * at_step(0));
    for step in 1..=steps {
        let coverage = ink.sample(center + place.normal * at_step(step));
        let crossing = || {
            let share = (threshold - before) / (coverage - before);
            at_step(step - 1) + share * (at_step(step) - at_step(step - 1))
        };
        match (before >= threshold, coverage >= threshold) {
            (false, true) => begin = Some(crossing()),
            (true, false) => {
                if let Some(begin) = begin.take() {
                    let end = crossing();
                    let distance = if begin <= 0.0 && end >= 0.0 { 0.0 } else { begin.abs().min(end.abs()) };
                    if nearest.is_none_or(|(best, _)| distance < best) {
                        nearest = Some((distance, 0.5 * (begin + end)));
                    }
                }
            }
            _ => {}
        }
        before = coverage;
    }
    nearest.map(|(_, middle)| middle * scale)
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::EdgeId;

    fn place(x: f64, y: f64, normal: DVec2) -> TruePlace {
        let at = DVec2::new(x, y);
        let edge = EdgeId::new(0);
        TruePlace { at, normal, length: 1.0, line: 0, loop_id: 0, edge, share: 0.5, is_clear: true, is_outer: true }
    }

    /// A vertical line of 4 reference pixels whose middle is at `x`, in a picture of this height.
    fn picture(x: f64, height: u32) -> DrawnFrame {
        let scale = reference_scale(height);
        let covered = |column: u32| {
            let (left, right) = (f64::from(column) * scale, f64::from(column + 1) * scale);
            (right.min(x + 2.0) - left.max(x - 2.0)).max(0.0) / scale
        };
        DrawnFrame::Picture(Ink::from_fn(height, height, |column, _| covered(column) as f32))
    }

    #[test]
    fn offsets_are_those_of_geometry_at_any_size_of_the_picture() {
        for height in [250, 500, 1000] {
            for off in [-6.0, -1.3, 0.0, 0.7, 5.0] {
                let line = [DVec2::new(500.0 + off, 0.0), DVec2::new(500.0 + off, 1000.0)];
                let lines = DrawnFrame::lines([line.map(|end| end / reference_scale(height))].into_iter(), height);
                let at = place(500.0, 500.0, DVec2::X);
                let found = [lines.offset(&at), picture(500.0 + off, height).offset(&at)].map(Option::unwrap);
                assert!((found[0] - off).abs() < 1e-9, "{height}: {found:?} instead of {off}");
                // A pixel holds how much of it is covered, not where: that is lost below a pixel.
                assert!(
                    (found[1] - off).abs() < 0.25 * reference_scale(height),
                    "{height}: {found:?} instead of {off}"
                );
            }
        }
    }

    #[test]
    fn a_line_is_drawn_doubtful_or_bare_by_its_distance() {
        for (off, state) in [(2.5, State::Drawn), (4.5, State::Doubtful), (9.0, State::Bare)] {
            let line = [DVec2::new(500.0 + off, 0.0), DVec2::new(500.0 + off, 1000.0)];
            let at = place(500.0, 500.0, DVec2::X);
            assert_eq!(DrawnFrame::lines([line].into_iter(), 1000).state(&at), state);
            // The ink of a pen lies half its width nearer.
            assert_eq!(picture(500.0 + off + 2.0, 1000).state(&at), state);
        }
    }

    #[test]
    fn where_nothing_is_drawn_or_ink_fills_all_there_is_no_offset() {
        let at = place(500.0, 500.0, DVec2::X);
        for ink in [Ink::blank(1000, 1000), Ink::from_fn(1000, 1000, |_, _| 1.0)] {
            assert_eq!(DrawnFrame::Picture(ink).offset(&at), None);
        }
        let ends_before = [DVec2::new(500.0, 0.0), DVec2::new(500.0, 495.0)];
        assert_eq!(DrawnFrame::lines([ends_before].into_iter(), 1000).offset(&at), None);
        assert_eq!(DrawnFrame::lines(std::iter::empty(), 1000).state(&at), State::Bare);
    }
}
