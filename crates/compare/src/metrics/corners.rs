//! Whether drawn lines join at corners.

use super::ink::Ink;
use super::lines::TruePen;
use crate::truth::samples::{Run, TrueLines, TrueSample};
use glam::DVec2;
use std::ops::Range;

/// Lines that turn by less, in radians, show no gap at their turn.
const LEAST_TURN_RAD: f64 = 20.0 * std::f64::consts::PI / 180.0;

/// Parts of a line that turn by less do not count as bent.
const STRAIGHT_RAD: f64 = 2.0 * std::f64::consts::PI / 180.0;

/// A pixel of the true pen that is covered to this share is covered altogether, as far as its arcs are computed.
const COVERED: f32 = 0.999;

/// Share of the corners of the true lines that are closed; 1 where there is none.
///
/// A corner is a place where a line turns by 20 degrees or more, straight for twice the pen's width on either side and away from
/// all other lines. Its *join* is the part of the true pen whose nearest point of the line is the corner itself; the corner is
/// closed if every pixel that the join covers altogether is ink, and is not counted if there is no such pixel. A pen on one side
/// of a line has joins at the turns to its other side.
pub fn closed_corner_share(ink: &Ink, truth: &TrueLines, pen: TruePen<'_>) -> f64 {
    let (mut closed, mut counted) = (0_u32, 0_u32);
    for corner in corners(truth, 2.0 * pen.width_px) {
        let mut pixels = corner.join_pixels(pen).peekable();
        if pixels.peek().is_some() {
            counted += 1;
            closed += u32::from(pixels.all(|(x, y)| ink.is_ink(x, y)));
        }
    }
    if counted > 0 { f64::from(closed) / f64::from(counted) } else { 1.0 }
}

/// A corner in the picture: where it is, and the unit directions of the line before and after it.
#[derive(Debug, Clone, Copy)]
struct Corner {
    place: DVec2,
    before: DVec2,
    after: DVec2,
}

impl Corner {
    /// The pixels of the true pen, covered altogether, that lie beyond the end of the line before and the begin of the line after.
    fn join_pixels<'a>(&'a self, pen: TruePen<'a>) -> impl Iterator<Item = (i64, i64)> + 'a {
        let low = (self.place - pen.width_px).floor().as_i64vec2();
        let high = (self.place + pen.width_px).floor().as_i64vec2();
        let pixels = (low.y..=high.y).flat_map(move |y| (low.x..=high.x).map(move |x| (x, y)));
        pixels.filter(move |&(x, y)| {
            let from_corner = DVec2::new(x as f64 + 0.5, y as f64 + 0.5) - self.place;
            from_corner.dot(self.before) > 0.0
                && from_corner.dot(self.after) < 0.0
                && pen.picture.coverage(x, y) >= COVERED
        })
    }
}

/// The corners of lines that keep `clear_px` of other lines away and are straight for as long.
fn corners(truth: &TrueLines, clear_px: f64) -> impl Iterator<Item = Corner> + '_ {
    let at_turns = truth.runs.iter().flat_map(move |run| {
        let count = run.samples.len();
        let last = if run.closed { count } else { count.saturating_sub(1) };
        (0..last).filter_map(move |at| corner(truth, run, at, clear_px))
    });
    at_turns.filter(move |(corner, own)| is_alone(truth, corner.place, clear_px, own)).map(|(corner, _)| corner)
}

/// The corner between the samples `at` and `at + 1` of a run, with the samples of the run that belong to it.
fn corner(truth: &TrueLines, run: &Run, at: usize, clear_px: f64) -> Option<(Corner, [Range<usize>; 2])> {
    let samples = &truth.samples[run.samples.clone()];
    let [before, after] = [samples[at], samples[(at + 1) % samples.len()]];
    if before.tangent.angle_to(after.tangent).abs() < LEAST_TURN_RAD {
        return None;
    }
    let place = before.pixel + before.tangent * (0.5 * before.length_px);
    let backward = straight(samples, at, -1, clear_px)?;
    let forward = straight(samples, (at + 1) % samples.len(), 1, clear_px)?;
    let corner = Corner { place, before: before.tangent, after: after.tangent };
    Some((corner, [backward, forward].map(|own| own.start + run.samples.start..own.end + run.samples.start)))
}

/// The samples from `start` on, forwards or backwards, over a straight stretch of `length_px`; `None` where the line bends or
/// ends before. A stretch over the start of a closed line counts as bent: a line has one such place at most.
fn straight(samples: &[TrueSample], start: usize, step: isize, length_px: f64) -> Option<Range<usize>> {
    let tangent = samples[start].tangent;
    let mut length = 0.0;
    let mut at = start;
    while length < length_px {
        let sample = samples.get(at)?;
        if sample.tangent.angle_to(tangent).abs() > STRAIGHT_RAD {
            return None;
        }
        length += sample.length_px;
        if length < length_px {
            at = at.checked_add_signed(step)?;
        }
    }
    Some(start.min(at)..start.max(at) + 1)
}

/// Whether no sample but those of `own` lies within `clear_px` of `place`.
fn is_alone(truth: &TrueLines, place: DVec2, clear_px: f64, own: &[Range<usize>; 2]) -> bool {
    let near = |sample: &TrueSample| sample.pixel.distance_squared(place) < clear_px * clear_px;
    let is_own = |at: usize| own.iter().any(|range| range.contains(&at));
    truth.samples.iter().enumerate().all(|(at, sample)| is_own(at) || !near(sample))
}

#[cfg(test)]
mod tests {
    use super::super::sample_lines::{self, PEN_PX};
    use super::*;

    fn share(ink: &Ink, sample: &sample_lines::SampleLines) -> f64 {
        closed_corner_share(ink, &sample.lines, TruePen { picture: &sample.pen, width_px: PEN_PX })
    }

    /// At two of the four corners a join of 1.5 px covers a pixel altogether.
    #[test]
    fn the_corners_of_a_square_are_closed_until_one_is_notched() {
        let square = sample_lines::square();
        assert_eq!(corners(&square.lines, 2.0 * PEN_PX).count(), 4);
        assert!((share(&square.pen, &square) - 1.0).abs() < 1e-12);
        let notched = sample_lines::erase_around(&square.pen, DVec2::new(100.9, 30.1), 0.8);
        assert!((share(&notched, &square) - 0.5).abs() < 1e-12, "{}", share(&notched, &square));
        let blank = Ink::blank(square.pen.width(), square.pen.height());
        assert!(share(&blank, &square).abs() < 1e-12);
    }

    #[test]
    fn crossings_and_straight_lines_are_no_corners() {
        let crossing = sample_lines::crossing_lines();
        assert_eq!(corners(&crossing.lines, 2.0 * PEN_PX).count(), 0);
        let blank = Ink::blank(crossing.pen.width(), crossing.pen.height());
        assert!((share(&blank, &crossing) - 1.0).abs() < 1e-12, "nothing can be open");
    }
}
