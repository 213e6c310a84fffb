//! Brute force as Hall's note 1 describes it: the first frame, what tracking falls back to, and what it is measured by.
//!
//! 1. Find all front faces. 2. Check every edge of them: is a back face, or none, across?
//!
//! It has no past: loops are walked anew in each frame. Facing test and walk are those of the tracker. As in the paper one
//! face is looked at after the other; [`BruteForce::in_fours`] evaluates four at a time as the tracker does, so that the
//! ratio of its time to a tracker's says what tracking saves and nothing else. (In `silhouette-extraction` there is a simpler one that shares no code with any method, the oracle.)

use crate::complete_silhouette::next_silhouette_side;
use crate::concave_edges::TrackedEdges;
use crate::connectivity_table::{ConnectivityTable, Side};
use crate::faces::Faces;
use crate::scene::Scene;
use crate::stats::TrackingStats;
use silhouette_core::{FaceId, FacingMemo, HalfEdgeId, SilhouetteLoops, TriangleMesh, Viewpoint};
use std::sync::Arc;

/// Step 1 in a view of which nothing is known yet.
pub(crate) fn classify(faces: &mut Faces) {
    let table = faces.surface.table;
    faces.evaluate(table.face_count(), |face| (FaceId::from_usize(face), table.plane(FaceId::from_usize(face))));
}

/// Step 1, in a view of which something is known.
pub(crate) fn classify_the_rest(faces: &mut Faces) {
    for face in (0..faces.surface.triangles.len()).map(FaceId::from_usize) {
        faces.is_front(face);
    }
}

/// Step 2: hands over every silhouette half-edge, to complete its loop unless that was found before.
pub(crate) fn check_edges(
    faces: &mut Faces,
    stats: &mut TrackingStats,
    mut complete: impl FnMut(&mut Faces, HalfEdgeId),
) {
    for face in (0..faces.surface.triangles.len()).map(FaceId::from_usize) {
        if !faces.recall(face) {
            continue;
        }
        stats.edges_tested += 3;
        for slot in 0..3 {
            if faces.across(Side::new(face, slot)).is_none_or(|across| !faces.recall(across.face)) {
                complete(faces, HalfEdgeId::of(face, slot));
            }
        }
    }
}

/// Walks the loop through a silhouette half-edge unless it was found before. O(faces in the fans along it).
fn complete(faces: &Faces, start: HalfEdgeId, loops: &mut SilhouetteLoops, places: &mut [u32]) {
    if loops.half_edges().get(places[start.index()] as usize) == Some(&start) {
        return;
    }
    let mut half_edge = start;
    loop {
        places[half_edge.index()] = loops.half_edges().len() as u32;
        loops.push(half_edge);
        let next = next_silhouette_side(faces.surface.table, |face| faces.recall(face), Side::of(half_edge));
        half_edge = next.half_edge();
        if half_edge == start {
            break;
        }
    }
    loops.end_loop();
}

/// Finds all silhouette loops anew in each frame. See the [module](self).
#[derive(Debug, Clone)]
pub struct BruteForce {
    scene: Scene,
    memo: FacingMemo,
    in_fours: bool,
    loops: SilhouetteLoops,
    /// Where in the loops of this frame, or else of some frame before, each half-edge stands.
    places: Vec<u32>,
    stats: TrackingStats,
}

impl BruteForce {
    /// For a mesh and what [`Tracker`](crate::Tracker) prepares of it; defects are cut.
    ///
    /// # Panics
    /// If the table is of another mesh.
    pub fn new(mesh: Arc<TriangleMesh>, table: Arc<ConnectivityTable>, edges: Arc<TrackedEdges>) -> Self {
        let scene = Scene::new(mesh, table, edges);
        let places = vec![0; 3 * scene.face_count()];
        let (loops, stats) = (SilhouetteLoops::default(), TrackingStats::default());
        Self { scene, memo: FacingMemo::default(), in_fours: false, loops, places, stats }
    }

    /// Evaluates four faces at a time from now on: the same answers and counts, in less time.
    pub fn in_fours(self) -> Self {
        Self { in_fours: true, ..self }
    }

    /// The loops seen from `viewpoint`, in no particular order. O(F), one thread, no allocation once memory has grown.
    pub fn update(&mut self, viewpoint: &Viewpoint) -> &SilhouetteLoops {
        self.stats = TrackingStats::default();
        self.loops.clear();
        let Self { scene, memo, in_fours, loops, places, stats } = self;
        let mut faces = Faces::new(scene.surface(), viewpoint, memo);
        if *in_fours {
            classify(&mut faces);
        } else {
            faces.evaluate_one_by_one();
        }
        check_edges(&mut faces, stats, |faces, half_edge| complete(faces, half_edge, loops, places));
        stats.count(&faces.stats);
        &self.loops
    }

    /// The loops of the last frame.
    pub fn loops(&self) -> &SilhouetteLoops {
        &self.loops
    }

    /// What the last frame took.
    pub fn stats(&self) -> &TrackingStats {
        &self.stats
    }
}
