//! [`LaidPatterns`]: where along each path the strokes and gaps of a pattern lie, so that lines which lie on each other have
//! theirs in the same places.
//!
//! The phase of a place counts periods: it is a whole number in the middle of a stroke, so that a stroke is where it lies
//! within half a stroke's share of one, whichever way the line runs. Along a path it is piecewise linear, between knots.

use super::drawn::DrawnSegments;
use super::flatten::chords;
use super::paths::{Path, Paths};
use silhouette_core::glam::DVec2;

/// Lengths of a stroke and of the gap behind it, in page units, above 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pattern {
    pub on: f64,
    pub off: f64,
}

impl Pattern {
    /// Length of a stroke and a gap.
    pub fn period(self) -> f64 {
        self.on + self.off
    }

    /// Half a stroke in periods: below 0.5.
    pub fn half_stroke(self) -> f64 {
        0.5 * self.on / self.period()
    }
}

/// A straight piece of a path: of a curve, a chord.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Chord {
    /// The segment of the path that it belongs to.
    pub segment: usize,
    /// The parameters of that segment at its ends.
    pub parameters: [f64; 2],
    /// Where it begins and ends along the path, in page units from the path's start.
    pub along: [f64; 2],
    /// Its ends on the page.
    pub ends: [DVec2; 2],
}

/// The chords of a path, each within `tolerance` of its curve. O(chords).
pub fn chords_of(path: Path<'_>, tolerance: f64) -> Vec<Chord> {
    let (mut all, mut along) = (Vec::new(), 0.0);
    for (index, segment) in path.segments().enumerate() {
        let count = chords(&segment, tolerance);
        for chord in 0..count {
            let parameters = [chord, chord + 1].map(|end| f64::from(end) / f64::from(count));
            let ends = parameters.map(|parameter| segment.at(parameter));
            let end = along + ends[0].distance(ends[1]);
            all.push(Chord { segment: index, parameters, along: [along, end], ends });
            along = end;
        }
    }
    all
}

/// A place of a path at which the phase is known; between two it is linear.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Knot {
    /// Page units from the path's start.
    pub along: f64,
    /// Periods.
    pub phase: f64,
}

/// The lines along which a pattern has been laid.
pub struct LaidPatterns {
    pattern: Pattern,
    tolerance: f64,
    drawn: DrawnSegments,
    /// The phases at both ends of each drawn piece; `None` while the path that it belongs to is being laid.
    phases: Vec<Option<[f64; 2]>>,
    /// The stretches of the chord being laid that lie on others.
    covered: Vec<([f64; 2], u32)>,
}

/// What a stretch that lies on no other line leads to.
#[derive(Debug, Clone, Copy)]
enum Until {
    /// The end of an open path, or a place beyond which the path returns upon itself.
    End,
    /// The first point of a closed path.
    Start,
    /// A stretch that lies on another line, whose phase begins with this.
    Phase(f64),
}

/// What is known of the path being laid.
#[derive(Default)]
struct Laying {
    knots: Vec<Knot>,
    /// Indices of pieces behind the last knot, and where each begins and ends along the path.
    pending: Vec<(u32, [f64; 2])>,
}

impl LaidPatterns {
    /// None yet, of those that `paths` hold. Lines within `tolerance` (page units, above 0) of each other lie on each other.
    pub fn of<'a>(paths: impl Iterator<Item = &'a Paths>, pattern: Pattern, tolerance: f64) -> Self {
        let drawn = DrawnSegments::over(paths, tolerance);
        Self { pattern, tolerance, drawn, phases: Vec::new(), covered: Vec::new() }
    }

    /// Lays the pattern along a path: at least two knots, from its start to its end.
    ///
    /// 1. Where the path lies on one that was laid before, or on an earlier part of itself, it has the phase of that.
    /// 2. A path that lies on none begins and ends with a whole stroke, or has a whole number of periods if it is closed; for
    ///    that the pattern is stretched. One too short for two strokes stays whole.
    /// 3. Between two such stretches the phase runs on, stretched by the half period at most that makes it meet both. From one
    ///    to an end of the path it leads to a whole stroke, if there is room for a period.
    ///
    /// O(chords + pairs that pass the same place), expected.
    pub fn lay(&mut self, path: &[Chord], closed: bool) -> Vec<Knot> {
        let mut laying = Laying::default();
        for chord in path {
            self.lay_chord(chord, &mut laying);
        }
        let length = path.last().map_or(0.0, |chord| chord.along[1]);
        self.settle(&mut laying, length, if closed { Until::Start } else { Until::End });
        laying.knots
    }

    fn lay_chord(&mut self, chord: &Chord, laying: &mut Laying) {
        let mut covered = std::mem::take(&mut self.covered);
        covered.clear();
        self.drawn.push_covered(chord.ends, &mut covered);
        let [from, to] = chord.along;
        let least = self.tolerance / (to - from);
        let mut done = 0.0;
        for &(stretch, index) in &covered {
            let (begin, end) = (f64::max(stretch[0], done), stretch[1]);
            // Where a line turns sharply, its own next pieces lie beside each other for as long as the tolerance.
            let is_own = self.phases[index as usize].is_none();
            if end - begin <= if is_own { 2.0 * least } else { 0.0 } {
                continue;
            }
            self.add_pending(chord, [done, begin], laying);
            let at = |share: f64| from + (to - from) * share;
            if is_own {
                self.settle(laying, at(begin), Until::End);
            }
            let [first, last] = self.phases_beside(chord, [begin, end], index);
            self.settle(laying, at(begin), Until::Phase(first));
            let phase = laying.knots.last().map_or(first, |knot| knot.phase) + (last - first);
            laying.knots.push(Knot { along: at(end), phase });
            done = end;
        }
        self.add_pending(chord, [done, 1.0], laying);
        self.covered = covered;
    }

    /// Enters a part of a chord that lies on no other line.
    fn add_pending(&mut self, chord: &Chord, part: [f64; 2], laying: &mut Laying) {
        if part[0] >= part[1] {
            return;
        }
        let index = self.phases.len() as u32;
        self.drawn.insert(part.map(|share| chord.ends[0].lerp(chord.ends[1], share)));
        self.phases.push(None);
        let [from, to] = chord.along;
        laying.pending.push((index, part.map(|share| from + (to - from) * share)));
    }

    /// The phases of a drawn piece beside both ends of a stretch of a chord, as they are in the direction of the chord.
    fn phases_beside(&self, chord: &Chord, stretch: [f64; 2], index: u32) -> [f64; 2] {
        let [p, q] = self.drawn.segment(index);
        let [at_p, at_q] = self.phases[index as usize].expect("it was settled");
        let way = q - p;
        let phases = stretch.map(|share| {
            let point = chord.ends[0].lerp(chord.ends[1], share);
            at_p + (at_q - at_p) * ((point - p).dot(way) / way.length_squared()).clamp(0.0, 1.0)
        });
        let same_way = way.dot(chord.ends[1] - chord.ends[0]) >= 0.0;
        if same_way { phases } else { phases.map(|phase| -phase) }
    }

    /// Adds the knot at `along`, and that at the start if there is none, and with them the phases of what is pending.
    fn settle(&mut self, laying: &mut Laying, along: f64, until: Until) {
        let last = laying.knots.last().copied();
        let periods = (along - last.map_or(0.0, |knot| knot.along)) / self.pattern.period();
        let half = self.pattern.half_stroke();
        let [from, to] = match (last, until) {
            (None, Until::End) => {
                // Ahead of an open path lies a gap in thought, so that its strokes and gaps are as many.
                let strokes = (periods + 1.0 - 2.0 * half).round();
                if strokes < 2.0 { [0.0; 2] } else { [-half, strokes - 1.0 + half] }
            }
            (None, Until::Start) => {
                let strokes = periods.round();
                if strokes < 2.0 { [0.0; 2] } else { [-half, strokes - half] }
            }
            (None, Until::Phase(phase)) if periods < 1.0 => [phase - periods, phase],
            (None, Until::Phase(phase)) => [-half, meeting(-half, phase, periods)],
            (Some(knot), Until::End) if periods < 1.0 => [knot.phase, knot.phase + periods],
            (Some(knot), Until::End) => [knot.phase, meeting(knot.phase, half, periods)],
            (Some(knot), Until::Start) => [knot.phase, meeting(knot.phase, laying.knots[0].phase, periods)],
            (Some(knot), Until::Phase(phase)) => [knot.phase, meeting(knot.phase, phase, periods)],
        };
        let start = last.unwrap_or(Knot { along: 0.0, phase: from });
        if last.is_none() {
            laying.knots.push(start);
        }
        laying.knots.push(Knot { along, phase: to });
        let slope = if along > start.along { (to - from) / (along - start.along) } else { 0.0 };
        for (index, ends) in laying.pending.drain(..) {
            self.phases[index as usize] = Some(ends.map(|end| from + slope * (end - start.along)));
        }
    }
}

/// The phase nearest to `from + periods` that is in the same place of the pattern as `to`.
fn meeting(from: f64, to: f64, periods: f64) -> f64 {
    to + (from + periods - to).round()
}

/// The strokes of a pattern between knots, from where to where along the path, in order. O(knots + strokes).
pub fn strokes(knots: &[Knot], pattern: Pattern) -> Vec<[f64; 2]> {
    let half = pattern.half_stroke();
    let rounding = pattern.period() * 1e-9;
    let mut strokes: Vec<[f64; 2]> = Vec::new();
    for pair in knots.windows(2) {
        let [from, to] = [pair[0].along, pair[1].along];
        // Strokes lie alike in both directions.
        let sign = if pair[1].phase < pair[0].phase { -1.0 } else { 1.0 };
        let [low, high] = [sign * pair[0].phase, sign * pair[1].phase];
        let at = |phase: f64| {
            let share = (phase - low) / (high - low);
            if share <= 0.0 {
                from
            } else if share >= 1.0 {
                to
            } else {
                from + (to - from) * share
            }
        };
        for middle in (low - half).ceil() as i64..=(high + half).floor() as i64 {
            let middle = middle as f64;
            let stroke = if high > low { [at(middle - half), at(middle + half)] } else { [from, to] };
            match strokes.last_mut() {
                Some(last) if stroke[0] <= last[1] + rounding => last[1] = last[1].max(stroke[1]),
                _ => strokes.push(stroke),
            }
        }
    }
    strokes
}
