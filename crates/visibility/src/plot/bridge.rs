//! Step 3, bridge: a contour that is hidden for less than its pen's width goes on.
//!
//! A fold of a few faces, of which scans have many, hides the contour behind it for a moment and cuts one line into two. Round ends of
//! a pen close such a gap with ink, but the pen is lifted for it. It is not where the same contour goes on underneath.

use super::layer::LayerName;
use crate::chains::Chain;
use crate::kind::LineKind;
use crate::lines::Lines;
use silhouette_core::glam::DVec2;
use std::collections::HashMap;

/// The hidden way from one end of a gap to the other may be this many times as long as the gap may be: behind a fold contours zigzag.
const MOST_WAY: f64 = 10.0;

/// Most chains on that way.
const MOST_CHAINS: usize = 64;

/// The end of a chain: its index, and whether it is its last point.
type End = (usize, bool);

/// A place where chains of one kind and object end.
type Place = (LineKind, u32, [u64; 2]);

/// Bridged gaps.
#[derive(Debug, Clone, Copy, PartialEq, Default, serde::Serialize)]
pub struct Bridged {
    /// How many.
    pub gaps: u64,
    /// Their length in page units.
    pub length: f64,
}

/// The gaps of visible chains of straight segments that are no wider than `most_px` says for their kind, as straight segments in
/// pixels: from the end of one chain to that of another which hidden chains join to it, as far as they were found. O(chains),
/// expected.
pub fn gaps(lines: &Lines, most_px: impl Fn(LineKind) -> f64) -> Vec<(LayerName, u32, [DVec2; 2])> {
    let mut ends_at: HashMap<Place, Ends> = HashMap::new();
    for (index, chain) in lines.chains.iter().enumerate().filter(|(_, chain)| is_cut(chain)) {
        for last in [false, true] {
            ends_at.entry(place(&chain, last)).or_default().push((index, last), chain.style.invisibility == 0);
        }
    }
    let mut gaps = Vec::new();
    for (index, chain) in lines.chains.iter().enumerate() {
        if chain.style.invisibility > 0 || !is_cut(&chain) {
            continue;
        }
        let most = most_px(chain.style.kind);
        for last in [false, true] {
            let from = pixel(&chain, last);
            let Some(other) = across(lines, &ends_at, place(&chain, last), most * MOST_WAY) else { continue };
            let to = pixel(&lines.chains.get(other.0), other.1);
            // Each gap is met from both sides.
            if (index, last) < other && from.distance(to) <= most && from != to {
                gaps.push((LayerName::of(chain.style), chain.style.object, [from, to]));
            }
        }
    }
    gaps
}

/// Ends that meet in a place; more than one of either is no gap.
#[derive(Default)]
struct Ends {
    visible: Vec<End>,
    hidden: Vec<End>,
}

impl Ends {
    fn push(&mut self, end: End, is_visible: bool) {
        if is_visible { self.visible.push(end) } else { self.hidden.push(end) }
    }
}

/// Follows hidden chains from a visible one's end to another's.
fn across(lines: &Lines, ends_at: &HashMap<Place, Ends>, from: Place, most_way: f64) -> Option<End> {
    let mut ends = &ends_at[&from];
    let mut way = 0.0;
    let mut came_by = usize::MAX;
    for _ in 0..MOST_CHAINS {
        let mut onward = ends.hidden.iter().filter(|(chain, _)| *chain != came_by);
        let (Some(&(chain, last)), None) = (onward.next(), onward.next()) else { return None };
        let hidden = lines.chains.get(chain);
        way += hidden.length_px();
        if way > most_way {
            return None;
        }
        came_by = chain;
        ends = &ends_at[&place(&hidden, !last)];
        match ends.visible[..] {
            [] => {}
            [end] if ends.hidden.len() == 1 => return Some(end),
            _ => return None,
        }
    }
    None
}

/// Whether a chain has ends, and is straight between its points.
fn is_cut(chain: &Chain<'_>) -> bool {
    !chain.closed && chain.handles.is_empty()
}

fn pixel(chain: &Chain<'_>, last: bool) -> DVec2 {
    chain.pixels[if last { chain.pixels.len() - 1 } else { 0 }]
}

fn place(chain: &Chain<'_>, last: bool) -> Place {
    // Adding 0 makes both zeros one.
    (chain.style.kind, chain.style.object, (pixel(chain, last) + DVec2::ZERO).to_array().map(f64::to_bits))
}
