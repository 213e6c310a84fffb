//! The tracker as a [`Method`] beside all others.

use crate::concave_edges::TrackedEdges;
use crate::connectivity_table::ConnectivityTable;
use crate::options::{Accuracy, TrackerOptions, TrackingOptions};
use crate::published::PUBLISHED;
use crate::refuse::RefusedByMethod;
use crate::tracker::Tracker;
use silhouette_core::glam::Vec3;
use silhouette_core::loops::LoopStart;
use silhouette_core::method::{ExtractionStats, ExtractsMovingEdges, PositionsError, PrepareError, Source};
use silhouette_core::prepared::Artefact;
use silhouette_core::{
    ExtractsEdges, ExtractsLoops, Method, MethodGuide, MethodInfo, MethodOptions, NoOptions, PreparedMesh, Progress,
    SilhouetteEdges, SilhouetteLoops, Viewpoint,
};
use std::sync::Arc;

/// [`Tracker`] with the outputs that all methods have: sorted edges, ordered loops.
#[derive(Debug, Clone)]
pub struct Tracking {
    tracker: Tracker,
    starts: Vec<LoopStart>,
}

impl Tracking {
    /// The tracker, for ids, events and stats of the last frame.
    pub fn tracker(&self) -> &Tracker {
        &self.tracker
    }

    /// The tracker, to change its level or make it forget.
    pub fn tracker_mut(&mut self) -> &mut Tracker {
        &mut self.tracker
    }
}

impl From<Tracker> for Tracking {
    fn from(tracker: Tracker) -> Self {
        Self { tracker, starts: Vec::new() }
    }
}

fn prepare(
    asker: &'static str,
    mesh: &Arc<PreparedMesh>,
    edges: Arc<TrackedEdges>,
    options: TrackerOptions,
    mend: &'static str,
    progress: &dyn Progress,
) -> Result<Tracking, PrepareError> {
    let table = mesh.artefact::<ConnectivityTable>(asker, progress)?;
    progress.check()?;
    let tracker = Tracker::new(Arc::clone(mesh.mesh()), table, edges, options);
    progress.check()?;
    Ok(tracker.map_err(|refusal| PrepareError::Mesh(Box::new(RefusedByMethod { refusal, mend })))?.into())
}

impl Method for Tracking {
    type Options = TrackingOptions;

    const INFO: MethodInfo = MethodInfo {
        name: "tracking",
        summary: "Follows the last view's loops, and searches concave and boundary edges for new ones; may miss loops, the \
                  more the higher its level.",
        source: Source { authors: "T. Hall", title: "Silhouette Tracking", venue: "bytegeist.com", year: 2003 },
        exact: false,
        needs: &[ConnectivityTable::NAME, TrackedEdges::NAME],
        options: TrackingOptions::SPECS,
        guide: MethodGuide {
            origin: "Hall 2003, corrected",
            yields: "loops with an identity over time",
            accuracy: "no: misses loops, the more the higher its level, or within a budget that it audits",
            cost: "O(S + walks + searched edges), one thread",
            memory: "45 bytes per face, 60 per concave edge",
            choose_when: "views follow each other closely, loops are wanted in order, and missing some is a fair \
                          price or its bound can be set",
            limits: "the same level misses more of a finer mesh; non-manifold edges and inconsistent winding are \
                     refused, or cut by `mesh=cut`; after a jump it starts by brute force",
        },
        published: PUBLISHED,
    };

    fn prepare(
        mesh: &Arc<PreparedMesh>,
        options: &TrackingOptions,
        progress: &dyn Progress,
    ) -> Result<Self, PrepareError> {
        options.validate()?;
        let edges = mesh.artefact::<TrackedEdges>(Self::INFO.name, progress)?;
        let mend = "set the option mesh=cut, which cuts it at these edges";
        prepare(Self::INFO.name, mesh, edges, (*options).into(), mend, progress)
    }

    fn bytes(&self) -> usize {
        self.tracker.bytes() + size_of_val(self.starts.as_slice())
    }
}

impl ExtractsEdges for Tracking {
    fn extract_edges(&mut self, viewpoint: &Viewpoint, out: &mut SilhouetteEdges) -> ExtractionStats {
        self.tracker.update(viewpoint);
        let topology = self.tracker.table().topology();
        out.refill(self.tracker.loops().half_edges().iter().map(|&half_edge| topology.edge_of(half_edge)));
        self.tracker.stats().extraction()
    }
}

impl ExtractsMovingEdges for Tracking {
    fn update_positions(&mut self, positions: &[Vec3]) -> Result<(), PositionsError> {
        self.tracker.move_mesh(positions)
    }
}

impl ExtractsLoops for Tracking {
    fn extract_loops(&mut self, viewpoint: &Viewpoint, out: &mut SilhouetteLoops) -> ExtractionStats {
        self.tracker.update(viewpoint);
        let Self { tracker, starts } = self;
        out.refill_ordered(tracker.table().topology(), tracker.loops(), starts);
        tracker.stats().extraction()
    }
}

/// [`Tracking`] in its [exact](Accuracy::Exact) mode: a method of its own, since its answers are those of brute force.
#[derive(Debug, Clone)]
pub struct ExactTracking(Tracking);

impl ExactTracking {
    /// The tracker, for ids, events and stats of the last frame.
    pub fn tracker(&self) -> &Tracker {
        self.0.tracker()
    }
}

impl Method for ExactTracking {
    type Options = NoOptions;

    const INFO: MethodInfo = MethodInfo {
        name: "tracking-exact",
        summary: "Keeps the last view's loops but for those that a turned face touches; knows by the eye's path which \
                  faces may have turned; exact.",
        source: Source {
            authors: "the authors of silhouettes",
            title: "Exact tracking by certificates",
            venue: "silhouettes",
            year: 2026,
        },
        exact: true,
        needs: &[ConnectivityTable::NAME],
        options: NoOptions::SPECS,
        guide: MethodGuide {
            origin: "our own",
            yields: "all loops, with an identity over time",
            accuracy: "all edges and no others, to the last bit",
            cost: "O(S + faces due), one thread; 0.8 % of the faces are due at 0.1 degrees per frame on the bunny",
            memory: "68 bytes per face",
            choose_when: "views follow each other closely, or the mesh moves a little in each frame; loops, all of \
                          them, come in order",
            limits: "non-manifold edges and inconsistent winding are refused; at a million faces each face that is \
                     due is a miss of the cache, and `cluster-cones` is faster",
        },
        published: &[],
    };

    fn prepare(mesh: &Arc<PreparedMesh>, _options: &NoOptions, progress: &dyn Progress) -> Result<Self, PrepareError> {
        let options = TrackerOptions { accuracy: Accuracy::Exact, ..TrackerOptions::default() };
        let mend = "take brute-force-simd, which needs no two faces per edge";
        prepare(Self::INFO.name, mesh, Arc::new(TrackedEdges::none()), options, mend, progress).map(Self)
    }

    fn bytes(&self) -> usize {
        self.0.bytes()
    }
}

impl ExtractsEdges for ExactTracking {
    fn extract_edges(&mut self, viewpoint: &Viewpoint, out: &mut SilhouetteEdges) -> ExtractionStats {
        self.0.extract_edges(viewpoint, out)
    }
}

impl ExtractsMovingEdges for ExactTracking {
    fn update_positions(&mut self, positions: &[Vec3]) -> Result<(), PositionsError> {
        self.0.update_positions(positions)
    }
}

impl ExtractsLoops for ExactTracking {
    fn extract_loops(&mut self, viewpoint: &Viewpoint, out: &mut SilhouetteLoops) -> ExtractionStats {
        self.0.extract_loops(viewpoint, out)
    }
}
