//! Step 6: a stroke parted at its events.
//!
//! Events closer together than their rounding errors form one cut; their changes, being whole numbers, add up in any order.
//! Between cuts are gaps, each with one number of layers in front of it. Gaps between which the change is known form a
//! *span*: told the layers of one, all are known.

use crate::contours::Layers;
use crate::events::Event;
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
    /// The contour at which it begins, by its index, where it is one alone.
    pub crossed: Option<u32>,
}

impl Gap {
    /// Length in the stroke's parameter; not above 0 for an empty gap.
    pub fn length(&self) -> f64 {
        self.range[1] - self.range[0]
    }
}

/// Orders the events of a stroke that is drawn from `range[0]` to `range[1]`, and appends the gaps between them.
/// O(events log events).
pub fn part(range: [f64; 2], events: &mut Vec<Event>, gaps: &mut Vec<Gap>) {
    events.retain(|event| event.t + event.doubt > range[0] && event.t - event.doubt < range[1]);
    events.sort_unstable_by(|one, other| one.t.total_cmp(&other.t).then(one.contour.cmp(&other.contour)));
    let mut gap = Gap { range, offset: Layers::default(), begins_span: true, crossed: None };
    let mut rest = &events[..];
    while let Some((first, _)) = rest.split_first() {
        let mut end = first.t + first.doubt;
        let count = 1 + rest[1..]
            .iter()
            .take_while(|event| {
                let joins = event.t - event.doubt <= end;
                end = if joins { end.max(event.t + event.doubt) } else { end };
                joins
            })
            .count();
        let (cut, others) = rest.split_at(count);
        gap.range[1] = first.t - first.doubt;
        gaps.push(gap);
        let change = cut.iter().try_fold(Layers::default(), |mut sum, event| {
            sum.add(event.change?, 1);
            Some(sum)
        });
        match change {
            Some(change) => gap.offset.add(change, 1),
            None => gap.offset = Layers::default(),
        }
        gap = Gap {
            range: [end, range[1]],
            offset: gap.offset,
            begins_span: change.is_none(),
            crossed: if count == 1 { first.contour } else { None },
        };
        rest = others;
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
        Event { t, doubt: 1e-6, change, contour: Some((t * 10.0) as u32) }
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
        assert_eq!(gaps.iter().map(|gap| gap.crossed).collect::<Vec<_>>(), [None, None, Some(5), Some(7)]);
        assert!((gaps[1].range[0] - 0.3 - 1e-6).abs() < 2e-7 && (gaps[1].range[1] - 0.5).abs() < 2e-6);
    }

    #[test]
    fn a_stroke_without_events_is_one_gap() {
        let mut gaps = Vec::new();
        part([0.0, 1.0], &mut Vec::new(), &mut gaps);
        assert_eq!(gaps.len(), 1);
        assert_eq!((gaps[0].range, gaps[0].begins_span), ([0.0, 1.0], true));
    }
}
