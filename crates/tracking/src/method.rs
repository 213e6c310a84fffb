//! The tracker as a [`Method`] beside all others.

use crate::as_printed::{LoopOrder, WalkStart};
use crate::concave_edges::TrackedEdges;
use crate::connectivity_table::ConnectivityTable;
use crate::options::{Accuracy, Concavity, ErrorBudget, MeshPolicy, TestedEdges, TrackingOptions};
use crate::tracker::Tracker;
use silhouette_core::glam::Vec3;
use silhouette_core::loops::LoopStart;
use silhouette_core::method::{
    ExtractionStats, ExtractsMovingEdges, OptionKind, OptionSpec, OptionValues, PositionsError, PrepareError, Source,
};
use silhouette_core::prepared::Artefact;
use silhouette_core::{
    ExtractsEdges, ExtractsLoops, Method, MethodInfo, PreparedMesh, Progress, SilhouetteEdges, SilhouetteLoops,
    Viewpoint,
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

const OPTIONS: &[OptionSpec] = &[
    OptionSpec {
        name: "concavity",
        summary: "Only concave edges whose interior angle exceeds pi by more than this are searched for new loops: 0 \
                  searches all, pi or more none, which is fast and misses what is new.",
        unit: "rad",
        kind: OptionKind::Number { min: 0.0, max: 3.2, default: 0.0 },
    },
    OptionSpec {
        name: "missed-share",
        summary: "Share of the silhouette's length that may be missed. Above 0 it sets the level while tracking, by what \
                  audits see missed.",
        unit: "",
        kind: OptionKind::Number { min: 0.0, max: 1.0, default: 0.0 },
    },
    OptionSpec {
        name: "audit-share",
        summary: "Faces that audits may evaluate, over those that tracking evaluates.",
        unit: "",
        kind: OptionKind::Number { min: 1e-6, max: 1000.0, default: 0.1 },
    },
    OptionSpec {
        name: "tested-edges",
        summary: "How many edges of each old loop are tested: all, or one and more only where it leads nowhere.",
        unit: "",
        kind: OptionKind::Choice(&["all", "single"]),
    },
    OptionSpec {
        name: "mesh",
        summary: "What happens to a mesh with edges that cannot be tracked across: it is refused, or cut there.",
        unit: "",
        kind: OptionKind::Choice(&["refuse", "cut"]),
    },
    OptionSpec {
        name: "jump",
        summary: "The eye's longest move, over its distance, that is tracked; 0 finds each frame by brute force.",
        unit: "",
        kind: OptionKind::Number { min: 0.0, max: 1000.0, default: 0.5 },
    },
    OptionSpec {
        name: "walk-start",
        summary: "Where walks to a grown silhouette start: at the face that became visible, or as printed.",
        unit: "",
        kind: OptionKind::Choice(&["corrected", "as-printed"]),
    },
];

fn options(values: &OptionValues) -> Result<TrackingOptions, PrepareError> {
    let missed_share = values.number("missed-share")? as f32;
    let budget = ErrorBudget { missed_share, audit_share: values.number("audit-share")? as f32 };
    Ok(TrackingOptions {
        accuracy: if missed_share > 0.0 { Accuracy::Budget(budget) } else { Accuracy::Level },
        concavity: Concavity::Above(values.number("concavity")? as f32),
        tested_edges: if values.choice("tested-edges")? == "all" { TestedEdges::All } else { TestedEdges::Single },
        mesh_policy: if values.choice("mesh")? == "refuse" { MeshPolicy::Refuse } else { MeshPolicy::Cut },
        jump: values.number("jump")?,
        walk_start: match values.choice("walk-start")? {
            "corrected" => WalkStart::Corrected,
            _ => WalkStart::AsPrinted,
        },
        // Loops of this trait run along their half-edges.
        loop_order: LoopOrder::Corrected,
    })
}

fn prepare(
    asker: &'static str,
    mesh: &Arc<PreparedMesh>,
    edges: Arc<TrackedEdges>,
    options: TrackingOptions,
    progress: &dyn Progress,
) -> Result<Tracking, PrepareError> {
    let table = mesh.artefact::<ConnectivityTable>(asker, progress)?;
    let tracker = Tracker::new(Arc::clone(mesh.mesh()), table, edges, options);
    Ok(tracker.map_err(|refusal| PrepareError::Mesh(Box::new(refusal)))?.into())
}

impl Method for Tracking {
    const INFO: MethodInfo = MethodInfo {
        name: "tracking",
        summary: "Follows the last view's loops, and searches concave and border edges for new ones; may miss loops, the \
                  more the higher its level.",
        source: Source { authors: "T. Hall", title: "Silhouette Tracking", venue: "bytegeist.com", year: 2003 },
        exact: false,
        needs: &[ConnectivityTable::NAME, TrackedEdges::NAME],
        options: OPTIONS,
    };

    fn prepare(mesh: &Arc<PreparedMesh>, values: &OptionValues, progress: &dyn Progress) -> Result<Self, PrepareError> {
        let options = options(values)?;
        let edges = mesh.artefact::<TrackedEdges>(Self::INFO.name, progress)?;
        prepare(Self::INFO.name, mesh, edges, options, progress)
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
        options: &[],
    };

    fn prepare(
        mesh: &Arc<PreparedMesh>,
        _values: &OptionValues,
        progress: &dyn Progress,
    ) -> Result<Self, PrepareError> {
        let options = TrackingOptions { accuracy: Accuracy::Exact, ..TrackingOptions::default() };
        prepare(Self::INFO.name, mesh, Arc::new(TrackedEdges::none()), options, progress).map(Self)
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
