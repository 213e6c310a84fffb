//! Steps 4 to 6 for all strokes: their events, and the gaps between them.
//!
//! Each pair of edges is looked at once: the farther of two that cross is the one with the event. So the events of a stroke
//! come from several tasks, and are brought together afterwards.

use crate::chains::SegmentSource;
use crate::clear_edges::{ClearEdges, Segment};
use crate::contours::Contour;
use crate::crossing::{Crossed, Event, Meeting, meeting, touching_event};
use crate::frame::ClippedEdge;
use crate::gaps::{self, Gap};
use crate::layers::Layers;
use crate::line_error::{LineError, MAX_EVENTS, MAX_WORK};
use crate::picture_grid::PictureGrid;
use crate::piercing::piercing;
use crate::sight::Sight;
use crate::stroke::Strokes;
use rayon::prelude::*;
use silhouette_core::{EdgeId, Progress};
use std::ops::Range;
use std::sync::atomic::{AtomicU64, Ordering};

/// An edge in the picture: a stroke, a contour, or both.
#[derive(Debug, Clone, Copy)]
pub struct PictureEdge {
    /// Its ends, and what changes across it where it is a contour.
    pub crossed: Crossed,
    /// Vertices at its ends.
    pub vertices: [u32; 2],
    /// The mesh edge that a contour is.
    pub contour: Option<EdgeId>,
}

/// All edges in the picture: the strokes in their order, then the contours that are not drawn. `contours` ascend by edge, as
/// do the strokes along mesh edges, which come first. O(strokes + contours).
pub fn picture_edges(strokes: &Strokes, contours: &[Contour]) -> Vec<PictureEdge> {
    let mut edges = Vec::with_capacity(strokes.strokes.len() + contours.len());
    let mut undrawn = Vec::new();
    let mut rest = contours.iter().peekable();
    for stroke in &strokes.strokes {
        let mut edge = PictureEdge {
            crossed: Crossed { ends: stroke.ends, to_the_left: Layers::NONE },
            vertices: stroke.vertices,
            contour: None,
        };
        if let SegmentSource::Edge(id) = stroke.source {
            undrawn.extend(std::iter::from_fn(|| rest.next_if(|contour| contour.edge < id)));
            if let Some(contour) = rest.next_if(|contour| contour.edge == id) {
                (edge.crossed.to_the_left, edge.contour) = (contour.to_the_left, Some(id));
            }
        }
        edges.push(edge);
    }
    let of_contour = |contour: &Contour| PictureEdge {
        crossed: Crossed { ends: contour.ends, to_the_left: contour.to_the_left },
        vertices: contour.vertices,
        contour: Some(contour.edge),
    };
    edges.extend(undrawn.into_iter().chain(rest).map(of_contour));
    edges
}

/// Counts of what was done.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct CutStats {
    /// What was done, in pairs of edges that pass the same cell. See [`MAX_WORK`].
    pub work: u64,
    /// Pairs that were tested exactly.
    pub pairs: u64,
    /// Events found.
    pub events: u64,
}

impl CutStats {
    fn add(&mut self, other: Self) {
        self.work += other.work;
        self.pairs += other.pairs;
        self.events += other.events;
    }
}

/// What all strokes of a view are cut with.
#[derive(Clone, Copy)]
pub struct Cutter<'a> {
    /// The strokes.
    pub strokes: &'a Strokes,
    /// [All edges in the picture](picture_edges).
    pub edges: &'a [PictureEdge],
    /// Their parts inside the picture and a little beyond.
    pub clipped: &'a [Option<ClippedEdge>],
    /// What is drawn of each stroke: parameters.
    pub drawn: &'a [Option<[f64; 2]>],
    /// Contours by place in the picture.
    pub grid: &'a PictureGrid,
    /// Faces by place, and the viewer.
    pub sight: Sight<'a>,
    /// Mesh edges that have been found to meet no face but their neighbours.
    pub clear_edges: &'a ClearEdges,
}

/// The gaps of a stroke, and which of its ends something touches.
#[derive(Debug, Clone, PartialEq)]
pub struct CutStroke {
    /// The stroke, by its index.
    pub stroke: u32,
    /// Its gaps in the list of all gaps.
    pub gaps: Range<usize>,
    /// Parameters at the ends of what is drawn of it.
    pub range: [f64; 2],
    /// Whether a face touches its ends in space.
    pub touched: [bool; 2],
}

/// All strokes inside the picture with their gaps, in order.
#[derive(Default)]
pub struct Cuts {
    /// The strokes.
    pub strokes: Vec<CutStroke>,
    /// Their gaps.
    pub gaps: Vec<Gap>,
    /// What it took.
    pub stats: CutStats,
}

/// Edges that a task takes: some 0.1 ms of work.
const EDGES_PER_TASK: usize = 64;

/// Strokes that a task puts in order: some 0.05 ms of work.
const ORDERED_PER_TASK: usize = 2048;

/// What an exact test of a crossing costs, in pairs that pass the same cell.
const EXACT_PAIR: u64 = 64;

/// Faces that a stroke may meet on an ordinary surface, and what each beyond them costs.
const USUAL_FACES: u64 = 64;
const CROWDED_FACE: u64 = 4;

/// Memory that is reused from edge to edge.
#[derive(Default)]
struct Scratch {
    near: Vec<u32>,
    /// For each edge the last that saw it, plus one.
    seen_by: Vec<u32>,
}

/// What a task finds: events, each with its stroke, and strokes that something touches.
#[derive(Default)]
struct Found {
    events: Vec<(u32, Event)>,
    touched: Vec<(u32, [bool; 2])>,
    stats: CutStats,
}

impl Cutter<'_> {
    /// Cuts all strokes. O(edges + pairs that pass the same cell + events log events + strokes log F), parallel.
    ///
    /// # Errors
    /// [`LineError`].
    pub fn cut(&self, progress: &dyn Progress) -> Result<Cuts, LineError> {
        let mut asked: Vec<(u32, u32)> = (0..self.strokes.strokes.len() as u32)
            .into_par_iter()
            .with_min_len(ORDERED_PER_TASK)
            .filter(|&index| self.asks_for_piercings(index))
            .map(|index| (self.sight.tree.key_of_place(self.strokes.strokes[index as usize].at(0.5)), index))
            .collect();
        // Those that are close to each other look at the same faces.
        asked.par_sort_unstable();
        let asked: Vec<u32> = asked.into_iter().map(|(_, index)| index).collect();

        let (edges, strokes) = (self.edges.len(), asked.len());
        let (of_crossings, of_piercings) = (edges.div_ceil(EDGES_PER_TASK), strokes.div_ceil(EDGES_PER_TASK));
        progress.stage("visible lines", (edges + strokes) as u64);
        let (work, events) = (AtomicU64::new(0), AtomicU64::new(0));
        let most_events = MAX_EVENTS.max(8 * self.strokes.strokes.len() as u64);
        let is_crowded = || work.load(Ordering::Relaxed) > MAX_WORK || events.load(Ordering::Relaxed) > most_events;
        let find = |scratch: &mut Scratch, task: usize| {
            progress.check()?;
            let mut found = Found::default();
            let count = |found: &Found, before: (u64, u64)| {
                work.fetch_add(found.stats.work - before.0, Ordering::Relaxed);
                events.fetch_add(found.events.len() as u64 - before.1, Ordering::Relaxed);
                if is_crowded() { Err(LineError::TooCrowded) } else { Ok(()) }
            };
            let chunk = |task: usize, of: usize| task * EDGES_PER_TASK..of.min((task + 1) * EDGES_PER_TASK);
            if task < of_crossings {
                for index in chunk(task, edges) {
                    let before = (found.stats.work, found.events.len() as u64);
                    self.find_crossings(index as u32, scratch, &mut found);
                    count(&found, before)?;
                }
                progress.advance(chunk(task, edges).len() as u64);
            } else {
                let chunk = chunk(task - of_crossings, strokes);
                self.find_piercings(&asked[chunk.clone()], &mut found);
                count(&found, (0, 0))?;
                progress.advance(chunk.len() as u64);
            }
            Ok(found)
        };
        let tasks = (0..of_crossings + of_piercings).into_par_iter();
        let found: Result<Vec<Found>, LineError> = tasks.map_init(Scratch::default, find).collect();
        let found = found?;
        if is_crowded() { Err(LineError::TooCrowded) } else { Ok(self.part(found)) }
    }

    /// Appends the events of an edge with those that come after it, and with all if it is no contour.
    fn find_crossings(&self, index: u32, scratch: &mut Scratch, found: &mut Found) {
        let Some(place) = &self.clipped[index as usize] else { return };
        let (edge, is_drawn) = (&self.edges[index as usize], self.is_drawn(index));
        let from = if edge.contour.is_some() { index + 1 } else { 0 };
        if edge.contour.is_none() && !is_drawn {
            return;
        }
        let Scratch { near, seen_by } = scratch;
        near.clear();
        seen_by.resize(self.edges.len(), 0);
        found.stats.work += self.grid.near(place, from, edge.contour.is_none(), near);
        for &other_index in near.iter() {
            if std::mem::replace(&mut seen_by[other_index as usize], index + 1) == index + 1 {
                continue;
            }
            let other = &self.edges[other_index as usize];
            // Edges that share a vertex meet there and nowhere else.
            if edge.vertices.iter().any(|vertex| other.vertices.contains(vertex)) {
                continue;
            }
            let may_cross = self.clipped[other_index as usize].as_ref().is_some_and(|other| place.may_cross(other));
            let roles = [
                is_drawn.then_some((index, other_index)),
                (edge.contour.is_some() && self.is_drawn(other_index)).then_some((other_index, index)),
            ];
            if !may_cross || roles == [None; 2] {
                continue;
            }
            found.stats.pairs += 1;
            found.stats.work += EXACT_PAIR;
            match meeting(&self.sight.view.viewer, edge.crossed.ends, other.crossed.ends) {
                Meeting::Apart => {}
                Meeting::Crossing(crossing) => {
                    for (which, (stroke, contour)) in
                        roles.into_iter().enumerate().filter_map(|(at, role)| Some((at, role?)))
                    {
                        let crossed = &self.edges[contour as usize].crossed;
                        let event = crossing.event(which, crossed);
                        found
                            .events
                            .extend(event.map(|event| (stroke, self.without_own_faces(stroke, contour, event))));
                    }
                }
                Meeting::Touching => {
                    for (stroke, contour) in roles.into_iter().flatten() {
                        let ends = self.edges[stroke as usize].crossed.ends;
                        let surface = self.sight.surface(&self.strokes.strokes[stroke as usize]);
                        let crossed = &self.edges[contour as usize].crossed;
                        let event = touching_event(&self.sight.view.viewer, ends, surface, crossed);
                        found
                            .events
                            .extend(event.map(|event| (stroke, self.without_own_faces(stroke, contour, event))));
                    }
                }
            }
        }
    }

    fn is_drawn(&self, index: u32) -> bool {
        self.drawn.get(index as usize).is_some_and(Option::is_some)
    }

    /// A stroke that is no mesh edge may cross the edges of faces that it lies on, which do not hide it.
    fn without_own_faces(&self, stroke: u32, contour: u32, mut event: Event) -> Event {
        let stroke = &self.strokes.strokes[stroke as usize];
        let contour = &self.edges[contour as usize];
        if let (SegmentSource::Edge(_), _) | (_, None) = (stroke.source, contour.contour) {
            return event;
        }
        let (own, view) = (self.strokes.own_faces(stroke), &self.sight.view);
        if let Some((edge, change)) = contour.contour.zip(event.change.as_mut())
            && view.topology.faces(edge).any(|face| own.contains(face))
        {
            let toward_left = if *change == contour.crossed.to_the_left { 1 } else { -1 };
            *change = view.change_to_the_left(edge, |face| !own.contains(face)).times(toward_left);
        }
        event
    }

    /// Appends the events at which some strokes pass through faces, and which of their ends touch one. `strokes` are those
    /// [of which it is to be asked](Self::asks_for_piercings).
    fn find_piercings(&self, strokes: &[u32], found: &mut Found) {
        let view = &self.sight.view;
        let segment = |&index: &u32| {
            let stroke = &self.strokes.strokes[index as usize];
            (stroke.ends, stroke.vertices)
        };
        let segments: Vec<_> = strokes.iter().map(segment).collect();
        let mut met = vec![(false, [false; 2], 0_u64); strokes.len()];
        self.sight.tree.faces_at_each(&segments, |at, candidate| {
            let ((ends, vertices), (is_met, touched, faces)) = (segments[at], &mut met[at]);
            *faces += 1;
            let Some(meeting) = (Segment { ends, vertices }).meeting(view.mesh, &candidate) else { return };
            let stroke = &self.strokes.strokes[strokes[at] as usize];
            if self.strokes.own_faces(stroke).contains(meeting.face) {
                return;
            }
            *is_met = true;
            for (at_end, meets) in touched.iter_mut().zip(meeting.touched) {
                *at_end |= meets;
            }
            let event = |passage| (strokes[at], piercing(passage, view.facing(meeting.face)));
            found.events.extend(meeting.passage.map(event));
        });
        for (&index, (is_met, touched, faces)) in strokes.iter().zip(met) {
            found.stats.work += faces.saturating_sub(USUAL_FACES) * CROWDED_FACE;
            if touched != [false; 2] {
                found.touched.push((index, touched));
            }
            if let (SegmentSource::Edge(edge), false) = (self.strokes.strokes[index as usize].source, is_met) {
                self.clear_edges.insert(edge);
            }
        }
    }

    /// Whether a stroke is drawn and may meet faces.
    fn asks_for_piercings(&self, index: u32) -> bool {
        self.is_drawn(index)
            && match self.strokes.strokes[index as usize].source {
                SegmentSource::Edge(edge) => !self.clear_edges.contains(edge),
                SegmentSource::Curve(_) | SegmentSource::Intersection(_) => true,
            }
    }

    /// Brings the events of each stroke together and parts the strokes at them.
    fn part(&self, found: Vec<Found>) -> Cuts {
        let count = self.strokes.strokes.len();
        // A counting sort of events by stroke.
        let mut first = vec![0_u32; count + 1];
        let all_events = || found.iter().flat_map(|found| &found.events);
        all_events().for_each(|(stroke, _)| first[*stroke as usize + 1] += 1);
        for stroke in 0..count {
            first[stroke + 1] += first[stroke];
        }
        let none = Event { t: 0.0, doubt: 0.0, change: None };
        let mut events = vec![none; first[count] as usize];
        let mut next = first.clone();
        for (stroke, event) in all_events() {
            events[next[*stroke as usize] as usize] = *event;
            next[*stroke as usize] += 1;
        }
        let mut touched = vec![[false; 2]; count];
        found.iter().flat_map(|found| &found.touched).for_each(|&(stroke, ends)| touched[stroke as usize] = ends);
        let mut cuts = Cuts::default();
        found.iter().for_each(|found| cuts.stats.add(found.stats));
        cuts.stats.events = events.len() as u64;
        // As large as what follows.
        drop(found);
        cuts.gaps.reserve(events.len() + count);
        for (stroke, range) in self.drawn.iter().enumerate() {
            if let Some(range) = *range {
                let begin = cuts.gaps.len();
                gaps::part(range, &mut events[first[stroke] as usize..first[stroke + 1] as usize], &mut cuts.gaps);
                let gaps = begin..cuts.gaps.len();
                cuts.strokes.push(CutStroke { stroke: stroke as u32, gaps, range, touched: touched[stroke] });
            }
        }
        cuts
    }
}
