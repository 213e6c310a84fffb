//! The exact mode: no loop is ever missed, and a frame costs what changes. Not in Hall's paper.
//!
//! Hall looks at concave edges to notice new loops; here every face is watched, but by a certificate that says how far the
//! eye may travel before the face can turn.
//!
//! 1. [`certificates`]: faces whose certificate has ended are evaluated and get a new one; those that turned are noted.
//! 2. [`changes`]: a face that turns changes its own three edges, and the way past its three corners of the loop in whose
//!    fan it lay. Nothing else changes.
//! 3. [`walk`]: loops are put together from runs of the last frame's loops, which are copied, and from new pieces, which
//!    are walked.
//!
//! # Why nothing is missed
//!
//! A facing changes only where a certificate has ended, so step 1 knows all facings of this frame. Every silhouette
//! half-edge of this frame was one in the last frame, or has turned into one by the turn of a face, which step 2 sees; step
//! 3 starts from all of them. It copies the successor of a half-edge only if both still are silhouette and no face of the
//! fan between them has turned away: then the walk would pivot over the same front faces to the same edge.
//!
//! # Cost
//!
//! O(S + due faces + turned faces and the fans at their corners + F / 512), where S counts copies of a few nanoseconds
//! each; one thread; no allocation once memory has grown. O(F) in the first frame, when the kind of view changes and after
//! the mesh moved. Memory: 36 bytes per face, 15 of them lists of faces that the first frame fills. Every move is allowed:
//! the longer it is, the more faces are due, at worst all, which is brute force. Crossing the surface needs no rule either.
//! Needles and faces whose corners lie on a line have no height that can be computed, so they are judged exactly in every
//! frame: many of them make a frame slow.

mod certificates;
mod changes;
mod sides;
mod walk;

use crate::faces::Surface;
use crate::identity::Relation;
use crate::stats::{BruteForceReason, TrackingStats};
use certificates::Certificates;
use changes::note_changes;
use silhouette_core::facing::Facing;
use silhouette_core::method::ExtractionStats;
use silhouette_core::{FaceFacings, FaceId, SilhouetteLoops, Viewpoint};
use walk::LoopWeaver;

/// The facings, certificates and loops of the last frame, from which those of the next follow.
#[derive(Debug, Clone, Default)]
pub(crate) struct ExactMode {
    certificates: Certificates,
    facings: FaceFacings,
    /// The view that all facings are of; `None` if there is none.
    view: Option<Viewpoint>,
    /// Faces that were due in this frame, how far the eye may travel until they are again, and those of them that turned.
    due: Vec<FaceId>,
    heights: Vec<f64>,
    turned: Vec<FaceId>,
    weaver: LoopWeaver,
}

impl ExactMode {
    /// Forgets all facings: the next frame evaluates every face. Loops are kept, to relate the next ones to.
    pub fn forget_facings(&mut self) {
        self.view = None;
    }

    /// Forgets loops too.
    pub fn forget(&mut self) {
        self.view = None;
        self.facings.clear(self.facings.len());
        self.weaver.forget();
    }

    /// Finds all loops of a frame.
    pub fn find(&mut self, surface: &Surface, viewpoint: &Viewpoint, stats: &mut TrackingStats) {
        let step = self.view.as_ref().and_then(|view| step_between(view, viewpoint));
        if step.is_none() {
            stats.brute_force = Some(match self.view {
                None => BruteForceReason::FirstFrame,
                Some(_) => BruteForceReason::Jump,
            });
            self.certificates.forget(surface.triangles.len());
            if self.facings.len() != surface.triangles.len() {
                self.facings.clear(surface.triangles.len());
            }
        }
        self.view = Some(*viewpoint);
        self.renew(surface, viewpoint, step, stats);
        self.weaver.begin_frame(3 * surface.triangles.len());
        for &face in &self.turned {
            note_changes(surface.table, &self.facings, face, &mut self.weaver);
        }
        let carried_on = self.weaver.weave_from_old(surface.table, &self.facings);
        self.weaver.weave_from_new(surface.table, &self.facings);
        stats.loops_tracked = carried_on as u64;
        stats.loops_detected = (self.weaver.loops.len() - carried_on) as u64;
        stats.edges_tested = 3 * self.turned.len() as u64 + self.weaver.loops.half_edges().len() as u64;
    }

    /// Step 1: evaluates what is due, and notes what turned.
    fn renew(&mut self, surface: &Surface, viewpoint: &Viewpoint, step: Option<f64>, stats: &mut TrackingStats) {
        let Self { certificates, facings, due, turned, heights, .. } = self;
        turned.clear();
        if step == Some(0.0) {
            return;
        }
        certificates.travel(step.unwrap_or(0.0));
        certificates.collect_due(due);
        let (table, test) = (surface.table, surface.table.test(viewpoint));
        // Heights first, in a loop without a branch: so that the cache misses, one per face, overlap.
        heights.clear();
        heights.extend(due.iter().map(|&face| test.height(table.plane(face))));
        let mut counts = ExtractionStats { faces_tested: due.len() as u64, ..ExtractionStats::default() };
        for (&face, height) in due.iter().zip(&mut *heights) {
            let judgement = test.judge(table.plane(face), || surface.corners(face));
            counts.exact_fallbacks += u64::from(judgement.exact_fallback);
            if (judgement.facing == Facing::Front) != facings.is_front(face) {
                facings.set(face, judgement.facing);
                turned.push(face);
            }
            if *height == 0.0 {
                // Without area a face is back from everywhere.
                let [a, b, c] = surface.corners(face);
                *height = if a == b || b == c || c == a { f64::INFINITY } else { 0.0 };
            }
        }
        certificates.renew(due, heights.iter().copied());
        stats.count(&counts);
    }

    /// The loops of the last frame: closed, oriented, in the order in which they were put together.
    pub fn loops(&self) -> &SilhouetteLoops {
        &self.weaver.loops
    }

    /// Which loops of the frame before became which of the last.
    pub fn relations(&self) -> &[Relation] {
        &self.weaver.relations
    }

    /// Bytes held.
    pub fn bytes(&self) -> usize {
        let faces = size_of::<FaceId>() * (self.due.capacity() + self.turned.capacity());
        let heights = size_of::<f64>() * self.heights.capacity();
        self.certificates.bytes() + self.facings.bytes() + faces + heights + self.weaver.bytes()
    }
}

/// How far the eye moves between two views, in object space, or between the unit directions of orthographic views; never
/// too little, and 0 only if nothing changes. `None` where the kind of view changes, or a view is no view.
fn step_between(before: &Viewpoint, now: &Viewpoint) -> Option<f64> {
    let step = match (*before, *now) {
        (Viewpoint::Perspective { eye: before }, Viewpoint::Perspective { eye: now }) => {
            before.as_dvec3().distance(now.as_dvec3())
        }
        (Viewpoint::Orthographic { toward_viewer: before }, Viewpoint::Orthographic { toward_viewer: now }) => {
            let [from, to] = [before.as_dvec3().try_normalize()?, now.as_dvec3().try_normalize()?];
            if before == now { 0.0 } else { from.distance(to) + 16.0 * f64::EPSILON }
        }
        _ => return None,
    };
    step.is_finite().then_some(step * (1.0 + 8.0 * f64::EPSILON))
}
