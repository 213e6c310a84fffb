//! [`BorderSearch`]: where along a meridian the object begins and ceases to be shown, with few rays.
//!
//! 1. [`scan`](BorderSearch::scan) tries the whole span at steps of [`STEP`], and bisects between two that differ. Parts narrower
//!    than a step may be missed.
//! 2. [`follow`](BorderSearch::follow) is given where the borders lie at a neighbour. Each is bracketed: a little before and a
//!    little after, farther and farther away until both sides differ, then bisected. Between the brackets it tries the span at
//!    steps of [`PROBE`]. As soon as anything is not as expected, it gives up, and the meridian is scanned.
//!
//! Borders are known to half of [`tolerance`](BorderSearch::tolerance). Each ray that is cast is counted.

use crate::lobe::{Meridian, Span};
use std::f32::consts::PI;

/// Largest distance between two directions of a scan, in radians: 2.8 degrees.
pub const STEP: f32 = PI / 64.0;

/// Largest distance between two directions where a neighbour's borders are followed, in radians: 22.5 degrees.
pub const PROBE: f32 = PI / 8.0;

/// A search along meridians of one hull point.
pub struct BorderSearch<F> {
    /// How far away the object is shown at an angle from the centre, or `None`.
    pub shows: F,
    /// Width to which borders are bracketed, in radians.
    pub tolerance: f32,
    /// Calls of `shows`.
    pub calls: u64,
    /// How far away the object was met nearest to the last border at which it ceases to be shown.
    pub grazed: Option<f32>,
}

/// What is known at an angle.
#[derive(Clone, Copy)]
struct Probe {
    angle: f32,
    distance: Option<f32>,
}

impl Probe {
    fn is_shown(self) -> bool {
        self.distance.is_some()
    }
}

impl<F: FnMut(f32) -> Option<f32>> BorderSearch<F> {
    /// A search that has cast no ray yet.
    pub fn new(shows: F, tolerance: f32) -> Self {
        Self { shows, tolerance, calls: 0, grazed: None }
    }

    /// Searches the whole span. `center` is what is known at angle 0 if the span begins there.
    pub fn scan(&mut self, span: Span, center: Option<f32>) -> Meridian {
        let Some((first, end)) = self.ends(span, center) else { return Meridian::default() };
        let count = ((end - first.angle) / STEP).ceil().max(1.0);
        let mut borders = Vec::new();
        let mut last = first;
        for index in 1..=count as u32 {
            let next = self.probe(first.angle + (end - first.angle) * (index as f32 / count));
            if next.is_shown() != last.is_shown() {
                borders.push(self.bisect(last, next));
            }
            last = next;
        }
        self.grazed = last.distance.or(self.grazed);
        Meridian::new(first.is_shown(), borders)
    }

    /// Searches near the borders of a neighbour, each expected within about `slack` radians. `None` if the meridian turns out to be
    /// unlike the neighbour's.
    pub fn follow(&mut self, span: Span, center: Option<f32>, expected: &Meridian, slack: f32) -> Option<Meridian> {
        let (first, end) = self.ends(span, center)?;
        if first.is_shown() != expected.is_shown_first {
            return None;
        }
        let margin = self.tolerance * 0.5;
        let guesses: Vec<f32> = expected
            .borders()
            .iter()
            .copied()
            .filter(|&border| border > first.angle + margin && border < end - margin)
            .collect();
        let mut borders = Vec::with_capacity(guesses.len());
        let mut from = first;
        for (at, &guess) in guesses.iter().enumerate() {
            let limit = guesses.get(at + 1).map_or(end, |next| (guess + next) * 0.5);
            let (low, high) = self.bracket(from, guess, limit, slack)?;
            if !self.is_alike(from, low.angle) {
                return None;
            }
            borders.push(self.bisect(low, high));
            from = high;
        }
        let last = if from.angle < end { self.probe(end) } else { from };
        if last.is_shown() != from.is_shown() || !self.is_alike(from, end) {
            return None;
        }
        self.grazed = last.distance.or(self.grazed);
        Some(Meridian::new(first.is_shown(), borders))
    }

    /// What is known where the span begins, and the last angle to try; `None` of a span without room.
    fn ends(&mut self, span: Span, center: Option<f32>) -> Option<(Probe, f32)> {
        let margin = self.tolerance * 0.5;
        if span.to - span.from <= self.tolerance {
            return None;
        }
        let first =
            if span.from > 0.0 { self.probe(span.from + margin) } else { Probe { angle: 0.0, distance: center } };
        Some((first, span.to - margin))
    }

    fn probe(&mut self, angle: f32) -> Probe {
        self.calls += 1;
        Probe { angle, distance: (self.shows)(angle) }
    }

    /// Whether angles between one that is known and another are alike, tried at most [`PROBE`] apart.
    fn is_alike(&mut self, from: Probe, end: f32) -> bool {
        let count = ((end - from.angle) / PROBE).ceil().max(1.0);
        (1..count as u32).all(|index| {
            let angle = from.angle + (end - from.angle) * (index as f32 / count);
            self.probe(angle).is_shown() == from.is_shown()
        })
    }

    /// Two angles around a guess between which the first border after `from` lies.
    fn bracket(&mut self, from: Probe, guess: f32, limit: f32, slack: f32) -> Option<(Probe, Probe)> {
        let mut width = slack;
        let mut low = self.probe_within(guess - width, from, limit);
        if low.is_shown() != from.is_shown() {
            // The border comes earlier.
            let mut high = low;
            while low.angle > from.angle {
                width *= 2.0;
                low = self.probe_within(guess - width, from, limit);
                if low.is_shown() == from.is_shown() {
                    return Some((low, high));
                }
                high = low;
            }
            return None;
        }
        loop {
            let high = self.probe_within(guess + width, from, limit);
            if high.is_shown() != from.is_shown() {
                return Some((low, high));
            }
            if high.angle >= limit {
                return None;
            }
            low = high;
            width *= 2.0;
        }
    }

    fn probe_within(&mut self, angle: f32, from: Probe, limit: f32) -> Probe {
        if angle <= from.angle { from } else { self.probe(angle.min(limit)) }
    }

    /// The border between two angles that differ.
    fn bisect(&mut self, mut low: Probe, mut high: Probe) -> f32 {
        while high.angle - low.angle > self.tolerance {
            let middle = self.probe((low.angle + high.angle) * 0.5);
            if middle.is_shown() == low.is_shown() {
                low = middle;
            } else {
                high = middle;
            }
        }
        self.grazed = low.distance.or(self.grazed);
        (low.angle + high.angle) * 0.5
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const TOLERANCE: f32 = PI / 512.0;
    const SPAN: Span = Span { from: 0.0, to: 1.7 };

    fn shown(borders: &[f32]) -> impl FnMut(f32) -> Option<f32> + '_ {
        |angle| (borders.iter().filter(|&&border| border < angle).count() % 2 == 0).then_some(2.0 - angle)
    }

    fn agrees(found: &Meridian, borders: &[f32]) -> bool {
        found.borders().len() == borders.len()
            && found.borders().iter().zip(borders).all(|(a, b)| (a - b).abs() <= TOLERANCE * 0.51)
    }

    #[test]
    fn a_scan_finds_all_borders_that_are_a_step_apart() {
        for borders in [&[][..], &[0.4], &[0.4, 0.5, 1.2], &[1.69]] {
            let mut search = BorderSearch::new(shown(borders), TOLERANCE);
            let found = search.scan(SPAN, Some(2.0));
            assert!(found.is_shown_first && agrees(&found, borders), "{found:?}");
            assert!(search.calls <= 35 + 4 * borders.len() as u64, "{}", search.calls);
            let last = if borders.len() % 2 == 0 { SPAN.to } else { borders[borders.len() - 1] };
            assert!((2.0 - search.grazed.unwrap() - last).abs() <= TOLERANCE);
        }
    }

    #[test]
    fn a_neighbour_makes_a_search_cheap() {
        let expected = Meridian::new(true, vec![0.9]);
        let mut search = BorderSearch::new(shown(&[0.905]), TOLERANCE);
        let found = search.follow(SPAN, Some(2.0), &expected, TOLERANCE).unwrap();
        assert!(agrees(&found, &[0.905]));
        assert!(search.calls <= 9, "{}", search.calls);
    }

    #[test]
    fn a_neighbour_unlike_the_meridian_is_not_followed() {
        let follow = |truth: &[f32], expected: &[f32]| {
            let expected = Meridian::new(true, expected.to_vec());
            BorderSearch::new(shown(truth), TOLERANCE).follow(SPAN, Some(2.0), &expected, TOLERANCE)
        };
        assert_eq!(follow(&[], &[0.9]), None);
        assert_eq!(follow(&[0.9], &[]), None);
        assert_eq!(follow(&[0.3, 0.8], &[]), None);
        let hidden = Meridian::new(false, vec![]);
        assert_eq!(BorderSearch::new(shown(&[]), TOLERANCE).follow(SPAN, Some(2.0), &hidden, TOLERANCE), None);
    }

    proptest! {
        /// Whatever the guess, a single border is found or the search gives up.
        #[test]
        fn a_border_is_found_from_any_guess(border in 0.02_f32..1.68, guess in 0.02_f32..1.68) {
            let expected = Meridian::new(true, vec![guess]);
            let mut search = BorderSearch::new(shown(std::slice::from_ref(&border)), TOLERANCE);
            let found = search.follow(SPAN, Some(2.0), &expected, TOLERANCE).unwrap();
            prop_assert!(agrees(&found, &[border]), "{:?}", found);
        }
    }
}
