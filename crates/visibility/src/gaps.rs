//! Step 6: a stroke parted at its events.
//!
//! Events closer together than their rounding errors form one cut; their changes, being whole numbers, add up in any order.
//! Between cuts are gaps, each with one number of layers in front of it. Gaps between which the change is known form a
//! *span*: once the layers of one are known, all are.

use crate::crossing::Event;
use crate::layers::Layers;
use std::ops::Range;

/// A stretch of a stroke without events.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gap {
    /// Parameters at its ends. Empty or turned around where a cut reaches beyond the stroke's end.
    pub range: [f64; 2],
    /// Layers in front, beyond those of its span's first gap.
    pub offset: Layers,
    /// Whether it begins another span than the gap before it.
    pub begins_span: bool,
}

impl Gap {
    /// Length in the stroke's parameter; not above 0 for an empty gap.
    pub fn length(&self) -> f64 {
        self.range[1] - self.range[0]
    }
}

/// Orders the events of a stroke that is drawn from `range[0]` to `range[1]`, and appends the gaps between them. The first
/// gap lies before all events, even if it is empty: at a vertex, it holds what is in front of the stroke right there.
/// O(events log events).
pub fn part(range: [f64; 2], events: &mut [Event], gaps: &mut Vec<Gap>) {
    let mut gap = Gap { range, offset: Layers::NONE, begins_span: true };
    if events.is_empty() {
        gaps.push(gap);
        return;
    }
    events.sort_unstable_by(|one, other| one.t.total_cmp(&other.t));
    let is_inside = |event: &&Event| event.t + event.doubt > range[0] && event.t - event.doubt < range[1];
    let mut rest = events.iter().filter(is_inside).peekable();
    while let Some(first) = rest.next() {
        let mut end = first.t + first.doubt;
        let mut change = first.change;
        while let Some(event) = rest.next_if(|event| event.t - event.doubt <= end) {
            end = end.max(event.t + event.doubt);
            change = change.zip(event.change).map(|(mut sum, more)| {
                sum.add(more, 1);
                sum
            });
        }
        gap.range[1] = first.t - first.doubt;
        gaps.push(gap);
        match change {
            Some(change) => gap.offset.add(change, 1),
            None => gap.offset = Layers::NONE,
        }
        gap = Gap { range: [end, range[1]], offset: gap.offset, begins_span: change.is_none() };
    }
    gaps.push(gap);
}

/// The spans of a stroke's gaps.
pub fn spans(gaps: &[Gap]) -> impl Iterator<Item = Range<usize>> + '_ {
    let mut at = 0;
    std::iter::from_fn(move || {
        let begin = at;
        if begin == gaps.len() {
            return None;
        }
        at += 1;
        while at < gaps.len() && !gaps[at].begins_span {
            at += 1;
        }
        Some(begin..at)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn event(t: f64, change: Option<i32>) -> Event {
        let change = change.map(|front| Layers { front, back: 0 });
        Event { t, doubt: 1e-6, change }
    }

    #[test]
    fn events_are_ordered_merged_and_added_up() {
        let mut events = vec![
            event(0.7, Some(-1)),
            event(0.3, Some(2)),
            event(0.3 + 1e-7, Some(-1)),
            event(0.95, Some(5)),
            event(0.5, None),
        ];
        let mut gaps = Vec::new();
        part([0.1, 0.9], &mut events, &mut gaps);
        let offsets: Vec<i32> = gaps.iter().map(|gap| gap.offset.front).collect();
        assert_eq!(offsets, [0, 1, 0, -1]);
        assert_eq!(spans(&gaps).collect::<Vec<_>>(), [0..2, 2..4]);
        assert!((gaps[1].range[0] - 0.3 - 1e-6).abs() < 2e-7 && (gaps[1].range[1] - 0.5).abs() < 2e-6);
    }

    #[test]
    fn a_stroke_without_events_is_one_gap() {
        let mut gaps = Vec::new();
        part([0.0, 1.0], &mut [], &mut gaps);
        assert_eq!(gaps.len(), 1);
        assert_eq!((gaps[0].range, gaps[0].begins_span), ([0.0, 1.0], true));
    }
}
