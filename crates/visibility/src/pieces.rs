//! Step 7: strokes cut at their events into pieces, each with the layers in front of it.
//!
//! Events closer together than their rounding errors form one cut. One sight line in the longest gap between cuts tells the
//! layers there; the changes at the cuts, which are whole numbers and may be added up in any order, tell the others. Only
//! beyond an event whose change is not known another sight line is cast.

use crate::contours::{Contour, ContourFinder, Layers};
use crate::events::{Depth, Event, crossing, piercing};
use crate::frame::ClippedEdge;
use crate::picture_grid::PictureGrid;
use crate::sight::Sight;
use crate::stroke::{Stroke, Strokes};
use silhouette_core::FaceId;

/// A part of a stroke with one number of layers in front of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Piece {
    /// The stroke, by its index.
    pub stroke: u32,
    /// Parameters at both ends.
    pub range: [f64; 2],
    /// Layers in front.
    pub layers: Layers,
    /// The contour at each end whose projection is crossed there, by its index; `None` at a vertex, at the border of the
    /// picture, and where a face is pierced.
    pub crossed: [Option<u32>; 2],
}

/// Counts of what was done.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct PieceStats {
    /// Pairs of a stroke and a contour that were tested.
    pub pairs: u64,
    /// Events found.
    pub events: u64,
    /// Sight lines cast.
    pub sight_lines: u64,
}

/// Places in a gap at which a sight line is tried, as shares of its length, until one is certain.
const TRIALS: [f64; 6] = [0.5, 0.381_966, 0.618_034, 0.723_607, 0.276_393, 0.145_898];

/// What all strokes of a view are cut with.
#[derive(Clone, Copy)]
pub struct PieceCutter<'a> {
    /// The strokes.
    pub strokes: &'a Strokes,
    /// The contours.
    pub contours: &'a [Contour],
    /// Contours by place in the picture.
    pub grid: &'a PictureGrid,
    /// Facing of faces at contours.
    pub finder: ContourFinder<'a>,
    /// Casts sight lines.
    pub sight: Sight<'a>,
    /// Whether all that matters is if something is in front.
    pub only_visible: bool,
}

/// Memory that is reused from stroke to stroke.
#[derive(Debug, Default)]
pub struct CutterScratch {
    near: Vec<u32>,
    /// For each contour the last stroke that saw it, plus one.
    seen_by: Vec<u32>,
    events: Vec<Event>,
    gaps: Vec<Gap>,
    /// Counts since it was made.
    pub stats: PieceStats,
}

/// A stretch without events, and what follows it.
#[derive(Debug, Clone, Copy)]
struct Gap {
    range: [f64; 2],
    layers: Option<Layers>,
    /// Change at the cut that ends it.
    change: Option<Layers>,
    /// The contour crossed there, where it is one alone.
    crossed: Option<u32>,
}

impl PieceCutter<'_> {
    /// Appends the pieces of a stroke whose part inside the picture is `clipped`.
    ///
    /// O(contours near it + events log events + log F a sight line).
    pub fn cut(&self, index: u32, clipped: &ClippedEdge, scratch: &mut CutterScratch, out: &mut Vec<Piece>) {
        let stroke = &self.strokes.strokes[index as usize];
        self.find_crossings(index, clipped, Depth::Nearer, scratch);
        self.find_piercings(stroke, scratch);
        let own = self.strokes.own_faces(stroke);
        part_into_gaps(clipped.range, scratch);
        let any = self.only_visible && scratch.gaps.len() == 1;
        while let Some(gap) = longest_undecided(&scratch.gaps) {
            let layers = self.look_in(stroke, scratch.gaps[gap].range, own, any, &mut scratch.stats);
            spread(&mut scratch.gaps, gap, layers);
        }
        emit(index, clipped.range, &scratch.gaps, out);
    }

    fn look_in(&self, stroke: &Stroke, range: [f64; 2], own: &[FaceId], any: bool, stats: &mut PieceStats) -> Layers {
        let mut layers = Layers::default();
        for share in TRIALS {
            stats.sight_lines += 1;
            let t = range[0] + (range[1] - range[0]) * share;
            let seen = self.sight.look(stroke, t, |face| own.contains(&face), any);
            layers = seen.layers;
            if seen.certain {
                break;
            }
        }
        layers
    }

    /// Replaces the events by the crossings of a stroke with contours.
    pub fn find_crossings(&self, index: u32, clipped: &ClippedEdge, depth: Depth, scratch: &mut CutterScratch) {
        let CutterScratch { near, seen_by, events, stats, .. } = scratch;
        let stroke = &self.strokes.strokes[index as usize];
        near.clear();
        self.grid.near(clipped, near);
        seen_by.resize(self.contours.len(), 0);
        events.clear();
        for &contour_index in near.iter() {
            if std::mem::replace(&mut seen_by[contour_index as usize], index + 1) == index + 1 {
                continue;
            }
            let contour = &self.contours[contour_index as usize];
            // Edges that share a vertex meet there and nowhere else.
            if stroke.vertices.iter().any(|vertex| contour.vertices.contains(vertex)) {
                continue;
            }
            stats.pairs += 1;
            if let Some(event) = crossing(stroke, &self.sight.viewpoint, contour_index, contour, depth) {
                events.push(self.without_own_faces(stroke, contour, event));
            }
        }
    }

    /// A stroke that is no mesh edge may cross the edges of faces that it lies on, which do not hide it.
    fn without_own_faces(&self, stroke: &Stroke, contour: &Contour, mut event: Event) -> Event {
        let own = self.strokes.own_faces(stroke);
        if own.is_empty() || !self.finder.topology.faces(contour.edge).any(|face| own.contains(&face)) {
            return event;
        }
        let counted = self.finder.change_to_the_left(contour.edge, |face| !own.contains(&face));
        if let Some(change) = &mut event.change {
            let toward_left = if *change == contour.to_the_left { 1 } else { -1 };
            *change = Layers::default();
            change.add(counted, toward_left);
        }
        event
    }

    fn find_piercings(&self, stroke: &Stroke, scratch: &mut CutterScratch) {
        let own = self.strokes.own_faces(stroke);
        let mesh = self.sight.mesh;
        self.sight.tree.faces_at(stroke.ends[0], stroke.ends[1], |face| {
            let vertices = mesh.triangles()[face.index()];
            if !own.contains(&face) && !stroke.vertices.iter().any(|vertex| vertices.contains(vertex)) {
                scratch.events.extend(piercing(stroke, &self.sight.viewpoint, mesh.corners(face)));
            }
        });
    }
}

/// Orders the events and merges those that rounding cannot part.
fn part_into_gaps(range: [f64; 2], scratch: &mut CutterScratch) {
    let CutterScratch { events, gaps, stats, .. } = scratch;
    events.retain(|event| event.t + event.doubt > range[0] && event.t - event.doubt < range[1]);
    events.sort_unstable_by(|one, other| one.t.total_cmp(&other.t).then(one.contour.cmp(&other.contour)));
    stats.events += events.len() as u64;
    gaps.clear();
    let mut begin = range[0];
    let mut at = 0;
    while at < events.len() {
        let first = &events[at];
        let mut end = first.t + first.doubt;
        let mut change = first.change;
        let low = first.t - first.doubt;
        let mut next = at + 1;
        while next < events.len() && events[next].t - events[next].doubt <= end {
            let event = &events[next];
            end = end.max(event.t + event.doubt);
            change = change.zip(event.change).map(|(mut sum, more)| {
                sum.add(more, 1);
                sum
            });
            next += 1;
        }
        let crossed = if next == at + 1 { first.contour } else { None };
        gaps.push(Gap { range: [begin, low], layers: None, change, crossed });
        begin = end;
        at = next;
    }
    gaps.push(Gap { range: [begin, range[1]], layers: None, change: None, crossed: None });
}

/// The longest gap that has a length and no layers yet.
fn longest_undecided(gaps: &[Gap]) -> Option<usize> {
    let undecided = gaps.iter().enumerate().filter(|(_, gap)| gap.layers.is_none() && gap.range[1] > gap.range[0]);
    let longest = undecided.max_by(|(_, one), (_, other)| length(one).total_cmp(&length(other)));
    longest.map(|(index, _)| index)
}

fn length(gap: &Gap) -> f64 {
    gap.range[1] - gap.range[0]
}

/// Tells a gap its layers, and those that known changes connect with it.
fn spread(gaps: &mut [Gap], from: usize, layers: Layers) {
    gaps[from].layers = Some(layers);
    let mut sum = layers;
    for at in from + 1..gaps.len() {
        match gaps[at - 1].change {
            Some(change) if gaps[at].layers.is_none() => sum.add(change, 1),
            _ => break,
        }
        gaps[at].layers = Some(sum);
    }
    sum = layers;
    for at in (0..from).rev() {
        match gaps[at].change {
            Some(change) if gaps[at].layers.is_none() => sum.add(change, -1),
            _ => break,
        }
        gaps[at].layers = Some(sum);
    }
}

/// Appends a piece for each run of gaps of one invisibility.
fn emit(stroke: u32, range: [f64; 2], gaps: &[Gap], out: &mut Vec<Piece>) {
    let mut current: Option<Piece> = None;
    let mut cut = (range[0], None);
    for gap in gaps {
        if gap.range[1] > gap.range[0]
            && let Some(layers) = gap.layers
        {
            match &mut current {
                Some(piece) if piece.layers.invisibility() == layers.invisibility() => {}
                _ => {
                    if let Some(mut piece) = current.take() {
                        (piece.range[1], piece.crossed[1]) = cut;
                        out.push(piece);
                    }
                    current = Some(Piece { stroke, range: [cut.0, range[1]], layers, crossed: [cut.1, None] });
                }
            }
            cut = (gap.range[1], gap.crossed);
        }
    }
    out.extend(current);
}
