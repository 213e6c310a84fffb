//! Brute force as Hall's note 1 describes it: the first frame, what tracking falls back to, and what it is measured by.
//!
//! 1. Find all front faces. 2. Check every edge of them: is a back face, or none, across?
//!
//! Facing and loop completion are those of the tracker, so that a ratio of their times says what tracking saves and
//! nothing else. (In `silhouette-extraction` there is a simpler one that shares no code with any method, the oracle.)

use crate::complete_silhouette::FoundLoops;
use crate::concave_edges::TrackedEdges;
use crate::connectivity_table::{ConnectivityTable, Side};
use crate::faces::Faces;
use crate::scene::Scene;
use crate::stats::TrackingStats;
use silhouette_core::{FaceId, FacingMemo, HalfEdgeId, SilhouetteLoops, TriangleMesh, Viewpoint};
use std::sync::Arc;

/// Step 1, in a view of which nothing is known yet.
pub(crate) fn classify(faces: &mut Faces) {
    faces.evaluate(faces.surface.table.planes());
}

/// Step 1, in a view of which something is known.
pub(crate) fn classify_the_rest(faces: &mut Faces) {
    for face in (0..faces.surface.triangles.len()).map(FaceId::from_usize) {
        faces.is_front(face);
    }
}

/// Step 2: completes every loop that was not found before.
pub(crate) fn check_edges(faces: &mut Faces, loops: &mut FoundLoops, stats: &mut TrackingStats) {
    for face in (0..faces.surface.triangles.len()).map(FaceId::from_usize) {
        if !faces.recall(face) {
            continue;
        }
        stats.edges_tested += 3;
        for slot in 0..3 {
            let half_edge = HalfEdgeId::of(face, slot);
            let is_silhouette = faces.across(Side::new(face, slot)).is_none_or(|across| !faces.recall(across.face));
            if is_silhouette && !loops.is_found(half_edge) {
                loops.complete(faces, half_edge);
            }
        }
    }
}

/// Finds all silhouette loops anew in each frame. See the [module](self).
#[derive(Debug, Clone)]
pub struct BruteForce {
    scene: Scene,
    memo: FacingMemo,
    loops: FoundLoops,
    stats: TrackingStats,
}

impl BruteForce {
    /// For a mesh and what [`Tracker`](crate::Tracker) prepares of it; defects are cut.
    ///
    /// # Panics
    /// If the table is of another mesh.
    pub fn new(mesh: Arc<TriangleMesh>, table: Arc<ConnectivityTable>, edges: Arc<TrackedEdges>) -> Self {
        let scene = Scene::new(mesh, table, edges);
        Self { scene, memo: FacingMemo::default(), loops: FoundLoops::default(), stats: TrackingStats::default() }
    }

    /// The loops seen from `viewpoint`, in no particular order. O(F), one thread, no allocation once memory has grown.
    pub fn update(&mut self, viewpoint: &Viewpoint) -> &SilhouetteLoops {
        self.stats = TrackingStats::default();
        self.loops.begin_frame(3 * self.scene.face_count());
        let mut faces = Faces::new(self.scene.surface(), viewpoint, &mut self.memo);
        classify(&mut faces);
        check_edges(&mut faces, &mut self.loops, &mut self.stats);
        self.stats.count(&faces.stats);
        &self.loops.now.loops
    }

    /// The loops of the last frame.
    pub fn loops(&self) -> &SilhouetteLoops {
        &self.loops.now.loops
    }

    /// What the last frame took.
    pub fn stats(&self) -> &TrackingStats {
        &self.stats
    }
}
