//! [`Tracker`]: the loops of each frame from those of the frame before.

use crate::as_printed::{LoopOrder, list_in_printed_order};
use crate::brute_force::{check_edges, classify, classify_the_rest};
use crate::budget::{Audit, BudgetMode};
use crate::complete_silhouette::FoundLoops;
use crate::concave_edges::{ActiveEdges, TrackedEdges};
use crate::connectivity_table::ConnectivityTable;
use crate::detect_new::{complete_new, detect_in_boundary_list, detect_in_concave_list};
use crate::exact::ExactMode;
use crate::eye_crossing::ClearBall;
use crate::faces::Faces;
use crate::identity::{LoopEvents, LoopId, LoopIdentities};
use crate::options::{Accuracy, Concavity, MeshPolicy, TestedEdges, TrackerOptions};
use crate::refuse::NotTrackable;
use crate::scene::Scene;
use crate::single_edge::track_single_edge;
use crate::stats::{BruteForceReason, TrackingStats};
use crate::track::{track_all_edges, track_loops};
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::method::PositionsError;
use silhouette_core::{FacingMemo, SilhouetteLoops, TriangleMesh, Viewpoint};
use std::sync::Arc;

/// Follows the silhouette loops of a mesh from frame to frame. See the [crate](crate) for the method and what it costs.
///
/// Memory beyond the artefacts: 13.4 bytes per face (a place and a bit per half-edge, the memory of facings), 8 bytes per
/// selected concave edge and 20 per face there, some 40 bytes per silhouette edge.
#[derive(Debug, Clone)]
pub struct Tracker {
    scene: Scene,
    options: TrackerOptions,
    active: ActiveEdges,
    memo: FacingMemo,
    loops: FoundLoops,
    printed: SilhouetteLoops,
    identities: LoopIdentities,
    stats: TrackingStats,
    last_view: Option<Viewpoint>,
    clear_ball: ClearBall,
    exact: ExactMode,
    budget: Option<BudgetMode>,
    last_audit: Option<Audit>,
    /// Box around the mesh where the last frame saw it; differs from the mesh's own after it moved.
    last_bounds: [DVec3; 2],
}

impl Tracker {
    /// A tracker without a past: its first frame is found by brute force. O(F + C) for C concave edges.
    ///
    /// `table` and `edges` are those of `mesh`; the exact mode searches no edges, so [`TrackedEdges::none`] will do.
    ///
    /// # Errors
    /// [`NotTrackable`] if the mesh has defects and [`TrackerOptions::mesh_policy`] refuses them.
    ///
    /// # Panics
    /// If `table` is of another mesh.
    pub fn new(
        mesh: Arc<TriangleMesh>,
        table: Arc<ConnectivityTable>,
        edges: Arc<TrackedEdges>,
        mut options: TrackerOptions,
    ) -> Result<Self, NotTrackable> {
        if options.mesh_policy == MeshPolicy::Refuse && !table.defects().is_empty() {
            return Err(NotTrackable { defects: table.defects().to_vec() });
        }
        let last_bounds = table.bounds();
        let budget = match options.accuracy {
            Accuracy::Budget(budget) => Some(BudgetMode::new(budget)),
            Accuracy::Level | Accuracy::Exact => None,
        };
        if let Some(budget) = &budget {
            options.concavity = budget.level();
        }
        let mut tracker = Self {
            scene: Scene::new(mesh, table, edges),
            options,
            active: ActiveEdges::default(),
            memo: FacingMemo::default(),
            loops: FoundLoops::default(),
            printed: SilhouetteLoops::default(),
            identities: LoopIdentities::default(),
            stats: TrackingStats::default(),
            last_view: None,
            clear_ball: ClearBall::default(),
            exact: ExactMode::default(),
            budget,
            last_audit: None,
            last_bounds,
        };
        tracker.select();
        Ok(tracker)
    }

    /// The loops seen from `viewpoint`: every one closed, none twice, front faces on the left; in the order in which
    /// they were found, and begun anywhere. [`ids`](Self::ids) names them.
    ///
    /// O(old and new silhouette + faces walked over + selected concave edges + boundary edges); O(F) in a frame that is
    /// found by brute force. One thread. Allocates nothing once memory has grown.
    ///
    /// The [crate](crate)'s documentation says what is missed, and when; what is found is always silhouette.
    pub fn update(&mut self, viewpoint: &Viewpoint) -> &SilhouetteLoops {
        self.stats = TrackingStats::default();
        if self.options.accuracy == Accuracy::Exact {
            self.exact.find(&self.scene.surface(), viewpoint, &mut self.stats);
            self.identities.advance(self.exact.loops().len(), self.exact.relations());
            return self.loops();
        }
        self.stats.brute_force = self.reason_for_brute_force(viewpoint);
        self.loops.begin_frame(3 * self.scene.face_count());
        self.find(viewpoint);
        self.identities.advance(self.loops.now.loops.len(), &self.loops.relations);
        self.remember(viewpoint);
        if self.options.loop_order == LoopOrder::AsPrinted {
            list_in_printed_order(&self.loops.now.loops, &mut self.printed);
        }
        self.loops()
    }

    /// Steps 2 to 4 of the paper's Introduction, or step 2 alone.
    fn find(&mut self, viewpoint: &Viewpoint) {
        let Self { scene, options, active, memo, loops, stats, budget, last_audit, .. } = self;
        let mut faces = Faces::new(scene.surface(), viewpoint, memo);
        if stats.brute_force.is_some() {
            classify(&mut faces);
            loops.compare(&mut faces);
            check_edges(&mut faces, stats, |faces, half_edge| complete_new(faces, loops, half_edge));
        } else {
            // Facings that are needed in any case come first, while nothing is known: in one run through memory.
            faces.evaluate(active.faces.len(), |index| (active.faces[index], active.planes[index]));
            loops.compare(&mut faces);
            let track_loop = match options.tested_edges {
                TestedEdges::All => track_all_edges,
                TestedEdges::Single => track_single_edge,
            };
            let tracked = track_loops(&mut faces, loops, stats, |faces, loops, old, stats| {
                track_loop(faces, loops, old, options.walk_start, stats)
            });
            stats.loops_tracked = loops.now.loops.len() as u64;
            if tracked.is_break() {
                stats.brute_force = Some(BruteForceReason::LongWalks);
                classify_the_rest(&mut faces);
                check_edges(&mut faces, stats, |faces, half_edge| complete_new(faces, loops, half_edge));
            } else {
                detect_in_concave_list(&mut faces, loops, active, stats);
                detect_in_boundary_list(&mut faces, loops, scene.edges().boundary(), stats);
                stats.loops_detected = loops.now.loops.len() as u64 - stats.loops_tracked;
            }
        }
        if let (Some(budget), None) = (budget, stats.brute_force)
            && budget.is_due(faces.stats.faces_tested, scene.face_count())
        {
            let tracked = faces.length_of(loops.now.loops.half_edges());
            classify_the_rest(&mut faces);
            check_edges(&mut faces, stats, |faces, half_edge| complete_new(faces, loops, half_edge));
            let whole = faces.length_of(loops.now.loops.half_edges());
            let missed_share = if whole > 0.0 { (1.0 - tracked / whole).max(0.0) } else { 0.0 };
            let audit = Audit { level: options.concavity, ..budget.conclude(missed_share) };
            stats.audited = true;
            *last_audit = Some(audit);
            if audit.next_level != options.concavity {
                options.concavity = audit.next_level;
                select(scene, active, options.concavity);
            }
        }
        stats.edges_tested += loops.now.loops.half_edges().len() as u64;
        stats.count(&faces.stats);
    }

    /// Why the next frame must not be tracked, if so.
    fn reason_for_brute_force(&self, viewpoint: &Viewpoint) -> Option<BruteForceReason> {
        let Some(last_view) = &self.last_view else { return Some(BruteForceReason::FirstFrame) };
        if self.loops.now.loops.is_empty() {
            return Some(BruteForceReason::NothingToTrack);
        }
        let (turn, crossing) = match (*last_view, *viewpoint) {
            (Viewpoint::Perspective { eye: before }, Viewpoint::Perspective { eye: now }) => {
                let [min, max] = self.scene.surface().table.bounds();
                let bounds = [min.min(self.last_bounds[0]), max.max(self.last_bounds[1])];
                (self.turn_of_eye(before, now), self.clear_ball.may_have_crossed(bounds, before, now))
            }
            (Viewpoint::Orthographic { toward_viewer: before }, Viewpoint::Orthographic { toward_viewer: now }) => {
                (before.as_dvec3().normalize_or_zero().distance(now.as_dvec3().normalize_or_zero()), false)
            }
            _ => (f64::NAN, false),
        };
        // What is not a number is a jump.
        let is_small = turn <= self.options.jump;
        if !is_small {
            Some(BruteForceReason::Jump)
        } else if crossing {
            Some(BruteForceReason::MayHaveCrossed)
        } else {
            None
        }
    }

    /// A move of the eye as [`TrackerOptions::jump`] measures it.
    fn turn_of_eye(&self, before: Vec3, now: Vec3) -> f64 {
        let table = self.scene.surface().table;
        let (before, now) = (before.as_dvec3(), now.as_dvec3());
        if before == now {
            return 0.0;
        }
        let distance = before.distance(table.center()).max(table.radius());
        before.distance(now) / distance
    }

    /// Keeps what the next frame has to know of this one.
    fn remember(&mut self, viewpoint: &Viewpoint) {
        self.last_view = Some(*viewpoint);
        let surface = self.scene.surface();
        let bounds = surface.table.bounds();
        self.last_bounds = bounds;
        let needs_ball = matches!(self.stats.brute_force, Some(reason) if reason != BruteForceReason::LongWalks);
        if let (true, Viewpoint::Perspective { eye }) = (needs_ball, *viewpoint) {
            self.clear_ball.measure(&surface, bounds, eye);
        }
        self.clear_ball.see();
    }

    /// Forgets all loops, without events: the next frame is found by brute force, and its loops are new.
    pub fn reset(&mut self) {
        self.loops.forget();
        self.printed.clear();
        self.identities.forget();
        self.last_view = None;
        self.exact.forget();
    }

    /// Selects the concave edges that the next frames search, until the next audit where there is a budget. O(C + F /
    /// 64) for C concave edges; allocates nothing.
    pub fn set_concavity(&mut self, concavity: Concavity) {
        self.options.concavity = concavity;
        self.select();
    }

    fn select(&mut self) {
        select(&self.scene, &mut self.active, self.options.concavity);
    }

    /// Makes `positions`, one per vertex in object space, those of the next frames; topology and loops are kept.
    ///
    /// O(V + F + E) for planes and angles and O(C log C) to order C concave edges, on one thread; allocates nothing
    /// from the second call on, unless a shape has more concave edges than any before. The mesh should move little
    /// between frames, as the eye should: no jump is noticed. That vertices pass the eye is: the eye must stay outside
    /// the box around the old and the new positions, or the frame is found by brute force. In the exact mode O(V + F), no
    /// angles are needed, any move is allowed, and the next frame evaluates every face.
    ///
    /// # Errors
    /// [`PositionsError`]; the previous positions then stay in force.
    pub fn move_mesh(&mut self, positions: &[Vec3]) -> Result<(), PositionsError> {
        let bounds = self.scene.surface().table.bounds();
        self.scene.update_positions(positions, self.options.accuracy != Accuracy::Exact)?;
        self.last_bounds = [self.last_bounds[0].min(bounds[0]), self.last_bounds[1].max(bounds[1])];
        self.clear_ball.forget();
        self.exact.forget_facings();
        self.select();
        Ok(())
    }

    /// The loops of the last frame.
    pub fn loops(&self) -> &SilhouetteLoops {
        match (self.options.accuracy, self.options.loop_order) {
            (Accuracy::Exact, _) => self.exact.loops(),
            (_, LoopOrder::Corrected) => &self.loops.now.loops,
            (_, LoopOrder::AsPrinted) => &self.printed,
        }
    }

    /// The id of each loop of the last frame.
    pub fn ids(&self) -> &[LoopId] {
        self.identities.ids()
    }

    /// What happened to loops between the last two frames.
    pub fn events(&self) -> &LoopEvents {
        self.identities.events()
    }

    /// What the last frame took.
    pub fn stats(&self) -> &TrackingStats {
        &self.stats
    }

    /// What the last audit of a tracker with an [`ErrorBudget`](crate::ErrorBudget) saw; `None` before the first.
    pub fn last_audit(&self) -> Option<&Audit> {
        self.last_audit.as_ref()
    }

    /// The options in force.
    pub fn options(&self) -> &TrackerOptions {
        &self.options
    }

    /// Neighbours and planes, the topology that is tracked on, and its defects.
    pub fn table(&self) -> &ConnectivityTable {
        self.scene.table()
    }

    /// Where new silhouettes are searched.
    pub fn edges(&self) -> &TrackedEdges {
        self.scene.edges()
    }

    /// Bytes held beyond the mesh and its artefacts.
    pub fn bytes(&self) -> usize {
        let frame = self.memo.bytes() + self.loops.bytes() + self.printed.bytes() + self.identities.bytes();
        self.scene.bytes() + self.active.bytes() + frame + self.exact.bytes()
    }
}

/// Gathers the concave edges of a level.
fn select(scene: &Scene, active: &mut ActiveEdges, concavity: Concavity) {
    let level_rad = match concavity {
        Concavity::Above(level_rad) => Some(level_rad),
        Concavity::Ignored => None,
    };
    active.select(scene.concave(), level_rad, scene.surface().table);
}
