//! [`CoherenceMetrics`]: the numbers of a sequence, and what each is.

use super::drawn::{DrawnFrame, State};
use super::flicker::flicker;
use super::links::Links;
use super::loops_lost::loops_lost;
use super::movement::movement;
use super::places::{TrueFrame, TruePlace};
use crate::metrics::PictureKind;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

/// The truth of consecutive frames.
#[derive(Debug, Clone, Default)]
pub struct Sequence {
    /// The frames.
    pub frames: Vec<TrueFrame>,
    /// Links from each frame to the next: one fewer.
    pub links: Vec<Links>,
}

/// What a method does at a place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Observation {
    /// Whether it draws a line there.
    pub state: State,
    /// How far that lies from the true line, in reference pixels, where the place is clear.
    pub offset: Option<f64>,
}

/// How many places before and after one have a part in its distance to the drawn line.
const NEIGHBOURS: usize = 5;

/// What a method does at every place of a frame. The distance to the drawn line is the median over a place and the five before
/// and after on the same line, of which six must have one: a raster moves single places, a drawing moves stretches. O(places).
pub fn observe(frame: &TrueFrame, drawn: &DrawnFrame) -> Vec<Observation> {
    let places = &frame.places;
    let offset = |place: &TruePlace| if place.is_clear { drawn.offset(place) } else { None };
    let offsets: Vec<Option<f64>> = places.par_iter().map(offset).collect();
    let observe = |(at, place): (usize, &TruePlace)| {
        let around = at.saturating_sub(NEIGHBOURS)..places.len().min(at + NEIGHBOURS + 1);
        let mut near: Vec<f64> =
            around.filter(|&other| places[other].line == place.line).filter_map(|other| offsets[other]).collect();
        near.sort_unstable_by(f64::total_cmp);
        let is_known = offsets[at].is_some() && near.len() > NEIGHBOURS;
        Observation { state: drawn.state(place), offset: is_known.then(|| near[near.len() / 2]) }
    };
    places.par_iter().enumerate().map(observe).collect()
}

/// The numbers of a sequence. Every value is finite.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct CoherenceMetrics {
    /// [`movement`]: what 99 % of the line moves at most.
    pub movement_p99_rpx: f64,
    /// [`movement`]: the most that a stretch moves.
    pub movement_max_rpx: f64,
    /// [`flicker`]: share of the drawn length.
    pub flicker: f64,
    /// [`flicker`]: share of the true length.
    pub dropouts: f64,
    /// [`loops_lost`]; `None` for filled pictures.
    pub loops_lost: Option<f64>,
}

/// Measures a sequence, of filled pictures along the outline alone.
///
/// # Panics
/// If there is not one observation for every place of every frame.
pub fn measure(sequence: &Sequence, observations: &[Vec<Observation>], kind: PictureKind) -> CoherenceMetrics {
    let counts = |frame: usize, at: usize| kind == PictureKind::Lines || sequence.frames[frame].places[at].is_outer;
    let moved = movement(sequence, observations, counts);
    let flickering = flicker(sequence, observations, counts);
    CoherenceMetrics {
        movement_p99_rpx: moved.p99,
        movement_max_rpx: moved.max,
        flicker: flickering.flashes,
        dropouts: flickering.dropouts,
        loops_lost: (kind == PictureKind::Lines).then(|| loops_lost(sequence, observations)),
    }
}

/// What a number states about itself.
#[derive(Debug, Clone, Copy)]
pub struct CoherenceSpec {
    /// Name in results: a field of [`CoherenceMetrics`], after the motion and an underscore in flat tables.
    pub name: &'static str,
    /// Name in the report.
    pub title: &'static str,
    /// Unit.
    pub unit: &'static str,
    /// Worst value; the best of all is 0.
    pub worst: &'static str,
    /// What it is, in one sentence.
    pub summary: &'static str,
    /// Reads it; `None` where it is not defined.
    pub value: fn(&CoherenceMetrics) -> Option<f64>,
}

/// Every number, in the order of results and report.
pub const COHERENCE: [CoherenceSpec; 5] = [
    CoherenceSpec {
        name: "movement_p99_rpx",
        title: "movement, p99",
        unit: "rpx",
        worst: "20",
        summary: "Change of the signed distance from true to drawn line between two frames, which 99 % of the line's length does not exceed; changes up to 0.6 rpx count as 0.",
        value: |metrics| Some(metrics.movement_p99_rpx),
    },
    CoherenceSpec {
        name: "movement_max_rpx",
        title: "movement, max",
        unit: "rpx",
        worst: "20",
        summary: "The largest such change that every place of some stretch of 20 rpx makes.",
        value: |metrics| Some(metrics.movement_max_rpx),
    },
    CoherenceSpec {
        name: "flicker",
        title: "flicker",
        unit: "share",
        worst: "1",
        summary: "Share of the drawn true length that was bare before and is bare again after at most three frames, while the true line stays.",
        value: |metrics| Some(metrics.flicker),
    },
    CoherenceSpec {
        name: "dropouts",
        title: "dropouts",
        unit: "share",
        worst: "1",
        summary: "Share of the true length that is bare for at most three frames, drawn before and after, while the true line stays.",
        value: |metrics| Some(metrics.dropouts),
    },
    CoherenceSpec {
        name: "loops_lost",
        title: "loops lost",
        unit: "share",
        worst: "1",
        summary: "Share of the silhouette's loops, over all frames, of whose visible length less than half is drawn; not defined for filled pictures.",
        value: |metrics| metrics.loops_lost,
    },
];

#[cfg(test)]
mod tests {
    use super::super::sample_sequence::{SampleSequence, exact};
    use super::*;

    #[test]
    fn an_empty_sequence_and_one_without_lines_score_nothing() {
        for kind in PictureKind::ALL {
            let metrics = measure(&Sequence::default(), &[], kind);
            assert_eq!(metrics.loops_lost.is_some(), kind == PictureKind::Lines);
            assert!(COHERENCE.iter().all(|spec| (spec.value)(&metrics).is_none_or(|value| value.abs() < 1e-12)));
        }
    }

    /// Most of the line must be measured, or the numbers would be of a remnant.
    #[test]
    fn true_lines_stay_and_are_clear_for_the_most_part() {
        let sample = SampleSequence::blob(512);
        let places = || sample.sequence.frames.iter().flat_map(|frame| &frame.places);
        let clear = places().filter(|place| place.is_clear).count() as f64 / places().count() as f64;
        let links = || sample.sequence.links.iter().flat_map(|links| &links.forward);
        let kept = links().flatten().count() as f64 / links().count() as f64;
        assert!(clear > 0.5 && kept > 0.9, "{clear} {kept}");
        assert!(places().any(|place| place.is_outer) && !places().all(|place| place.is_outer));
        assert!(sample.measure(exact).loops_lost.is_some());
    }

    #[test]
    fn the_documentation_holds_the_table() {
        let text = include_str!("../../../../docs/METRICS.md");
        for CoherenceSpec { name, unit, worst, summary, .. } in &COHERENCE {
            let row = format!("| `{name}` | {unit} | 0 | {worst} | {summary} |");
            assert!(text.contains(&row), "docs/METRICS.md lacks this row:\n{row}");
        }
        let json = serde_json::to_value(CoherenceMetrics::default()).unwrap();
        let names: Vec<&String> = json.as_object().unwrap().keys().collect();
        assert!(COHERENCE.iter().all(|spec| names.contains(&&spec.name.to_owned())) && names.len() == COHERENCE.len());
    }
}
