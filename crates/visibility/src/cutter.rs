//! Steps 4 to 6 for one stroke: its events, and the gaps between them.

use crate::chains::SegmentSource;
use crate::clear_edges::{ClearEdges, Segment};
use crate::contours::{Contour, ContourFinder, Layers};
use crate::events::{Depth, Event, crossing, piercing};
use crate::frame::ClippedEdge;
use crate::gaps::{self, Gap};
use crate::picture_grid::PictureGrid;
use crate::sight::Sight;
use crate::stroke::{Stroke, Strokes};

/// Counts of what was done.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct CutStats {
    /// What was done, in pairs of a stroke and a contour that pass the same cell. See [`MAX_WORK`](crate::MAX_WORK).
    pub work: u64,
    /// Pairs that were tested exactly.
    pub pairs: u64,
    /// Events found.
    pub events: u64,
}

/// What all strokes of a view are cut with.
#[derive(Clone, Copy)]
pub struct StrokeCutter<'a> {
    /// The strokes.
    pub strokes: &'a Strokes,
    /// The contours.
    pub contours: &'a [Contour],
    /// Each contour's part inside the picture.
    pub clipped_contours: &'a [Option<ClippedEdge>],
    /// Contours by place in the picture.
    pub grid: &'a PictureGrid,
    /// Facing of faces at contours.
    pub finder: ContourFinder<'a>,
    /// Faces by place.
    pub sight: Sight<'a>,
    /// Mesh edges that have been found to meet no face but their neighbours.
    pub clear_edges: &'a ClearEdges,
    /// Which layers count: those in front of a stroke, or all that the line of sight meets.
    pub depth: Depth,
}

/// Memory that is reused from stroke to stroke.
#[derive(Debug, Default)]
pub struct CutterScratch {
    near: Vec<u32>,
    /// For each contour the last stroke that saw it, plus one.
    seen_by: Vec<u32>,
    events: Vec<Event>,
    /// Counts since they were taken.
    pub stats: CutStats,
}

/// What an exact test of a crossing costs, and the event that it may yield, in pairs that pass the same cell.
const EXACT_PAIR: u64 = 64;

/// Faces that a stroke may meet on an ordinary surface, and what each beyond them costs.
const USUAL_FACES: u64 = 64;
const CROWDED_FACE: u64 = 4;

/// Distance in the picture within which a contour is taken to pass through a vertex, beyond both's own doubt.
const TOUCH_PX: f64 = 1e-3;

impl StrokeCutter<'_> {
    /// Appends the gaps of a stroke whose part inside the picture is `clipped`; yields for each end whether something
    /// touches it there, in the picture or in space, so that what is known of the stroke tells nothing of its neighbours.
    ///
    /// O(contours near it + events log events + log F).
    pub fn cut(
        &self,
        index: u32,
        clipped: &ClippedEdge,
        scratch: &mut CutterScratch,
        gaps: &mut Vec<Gap>,
    ) -> [bool; 2] {
        let stroke = &self.strokes.strokes[index as usize];
        let mut touched = self.find_crossings(index, clipped, scratch);
        let crossings = scratch.events.len();
        let touched_in_space = match stroke.source {
            SegmentSource::Edge(edge) if self.clear_edges.contains(edge) => [false; 2],
            SegmentSource::Edge(edge) => {
                let touched = self.find_piercings(stroke, scratch);
                // Faces on which the eye lies were left out; from elsewhere they count.
                let is_clear = touched == [false; 2] && scratch.events.len() == crossings;
                if is_clear && self.finder.at_eye.is_empty() {
                    self.clear_edges.insert(edge);
                }
                touched
            }
            _ => self.find_piercings(stroke, scratch),
        };
        if self.depth == Depth::Any {
            // A face that is passed through is met all the same, before or behind.
            scratch.events.truncate(crossings);
        }
        gaps::part(clipped.range, &mut scratch.events, gaps);
        scratch.stats.events += scratch.events.len() as u64;
        for end in 0..2 {
            touched[end] |= touched_in_space[end];
        }
        touched
    }

    /// Replaces the events by the crossings of a stroke with contours; yields which ends contours pass.
    fn find_crossings(&self, index: u32, clipped: &ClippedEdge, scratch: &mut CutterScratch) -> [bool; 2] {
        let CutterScratch { near, seen_by, events, stats, .. } = scratch;
        let stroke = &self.strokes.strokes[index as usize];
        near.clear();
        stats.work += self.grid.near(clipped, self.depth, near);
        seen_by.resize(self.contours.len(), 0);
        events.clear();
        let mut touched = [false; 2];
        for &contour_index in near.iter() {
            if std::mem::replace(&mut seen_by[contour_index as usize], index + 1) == index + 1 {
                continue;
            }
            let contour = &self.contours[contour_index as usize];
            let place = self.clipped_contours[contour_index as usize].as_ref();
            let Some(place) = place.filter(|place| clipped.may_meet(place, TOUCH_PX, self.depth)) else {
                continue;
            };
            let shared = stroke.vertices.map(|vertex| contour.vertices.contains(&vertex));
            let reach = clipped.doubt_px + place.doubt_px + TOUCH_PX;
            for end in 0..2 {
                let is_far = place.distance_px(clipped.pixels[end]) > reach;
                touched[end] |= !shared[end] && !is_far;
            }
            // Edges that share a vertex meet there and nowhere else.
            if shared.contains(&true) {
                continue;
            }
            stats.pairs += 1;
            stats.work += EXACT_PAIR;
            if let Some(event) = crossing(stroke, &self.sight.viewpoint, contour_index, contour, self.depth) {
                events.push(self.without_own_faces(stroke, contour, event));
            }
        }
        touched
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

    /// Appends the events at which a stroke passes through faces; yields which ends touch one.
    fn find_piercings(&self, stroke: &Stroke, scratch: &mut CutterScratch) -> [bool; 2] {
        let own = self.strokes.own_faces(stroke);
        let mesh = self.sight.mesh;
        let mut touched = [false; 2];
        let is_left_out = |face| own.contains(&face) || self.finder.at_eye.binary_search(&face).is_ok();
        let segment = Segment { ends: stroke.ends, vertices: stroke.vertices };
        let CutterScratch { events, stats, .. } = scratch;
        let faces = segment.for_each_meeting(mesh, self.sight.tree, is_left_out, |meeting| {
            for (at_end, found) in touched.iter_mut().zip(meeting.touched) {
                *at_end |= found;
            }
            let event = |passage| piercing(passage, mesh.corners(meeting.face), &self.sight.viewpoint);
            events.extend(meeting.passage.map(event));
        });
        stats.work += faces.saturating_sub(USUAL_FACES) * CROWDED_FACE;
        touched
    }
}
