//! What flies the path: the paper's methods, what was added to them, and what they compete with today.

use super::printed::LEVELS_RAD;
use silhouette_compare::registry::{self, EdgeMethod, Prepared};
use silhouette_core::method::{ExtractionStats, OptionValues, PrepareError};
use silhouette_core::{PreparedMesh, Progress, SilhouetteEdges, SilhouetteLoops, Topology, Viewpoint};
use silhouette_tracking::{
    Accuracy, BruteForce, Concavity, ConnectivityTable, ErrorBudget, TestedEdges, TrackedEdges, Tracker,
    TrackingOptions,
};
use std::sync::Arc;

/// Share of the silhouette's length that the variant with a budget may miss.
pub const BUDGET: f32 = 0.01;

/// What a method of today is asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Asked {
    /// Sorted edges.
    Edges,
    /// Closed, ordered loops, as tracking yields them.
    Loops,
}

/// One way to find the silhouette of each frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Variant {
    /// The paper's baseline.
    BruteForce,
    /// The same with as many faces at a time as tracking evaluates.
    BruteForceInFours,
    /// Tracking at a level in radians; `None` searches no concave edge.
    Level(Option<f32>, TestedEdges),
    /// Tracking that misses nothing.
    Exact,
    /// Tracking that sets its level so as to miss [`BUDGET`].
    Budget,
    /// A method of the registry.
    Today(&'static str, Asked),
}

impl Variant {
    /// All of them, in the order of the table; the baseline first.
    pub fn all() -> Vec<Self> {
        let every_edge = |level| Self::Level(level, TestedEdges::All);
        let levels = LEVELS_RAD.map(|level_rad| every_edge(Some(level_rad)));
        let single = [0.0, 0.2].map(|level_rad| Self::Level(Some(level_rad), TestedEdges::Single));
        let today = ["brute-force-simd", "cluster-cones"];
        let today =
            today.into_iter().flat_map(|name| [Asked::Edges, Asked::Loops].map(|asked| Self::Today(name, asked)));
        [Self::BruteForce, Self::BruteForceInFours]
            .into_iter()
            .chain(levels)
            .chain([every_edge(None)])
            .chain(single)
            .chain([Self::Exact, Self::Budget])
            .chain(today)
            .collect()
    }

    /// Name in tables.
    pub fn label(self) -> String {
        match self {
            Self::BruteForce => "brute force (Hall)".to_owned(),
            Self::BruteForceInFours => "brute force, in fours".to_owned(),
            Self::Level(Some(level_rad), TestedEdges::All) => format!("tracking, N = {level_rad}"),
            Self::Level(None, TestedEdges::All) => "tracking, no concave edges".to_owned(),
            Self::Level(Some(level_rad), TestedEdges::Single) => format!("single edges, N = {level_rad}"),
            Self::Level(None, TestedEdges::Single) => "single edges, no concave edges".to_owned(),
            Self::Exact => "tracking, exact".to_owned(),
            Self::Budget => format!("tracking, {} % budget", 100.0 * BUDGET),
            Self::Today(name, Asked::Edges) => format!("{name}, edges"),
            Self::Today(name, Asked::Loops) => format!("{name}, loops"),
        }
    }

    /// Column of the paper's table that it stands in.
    pub fn paper_column(self) -> Option<usize> {
        match self {
            Self::Level(Some(level_rad), TestedEdges::All) => {
                LEVELS_RAD.iter().position(|level| level.total_cmp(&level_rad).is_eq())
            }
            _ => None,
        }
    }

    /// Prepares it.
    ///
    /// # Errors
    /// [`PrepareError`]: cancelled, or a mesh that cannot be tracked.
    pub fn prepare(self, mesh: &Arc<PreparedMesh>, progress: &dyn Progress) -> Result<Flier, PrepareError> {
        let options = match self {
            Self::Today(name, asked) => return prepare_of_today(name, asked, mesh, progress),
            Self::BruteForce | Self::BruteForceInFours => None,
            Self::Level(level, tested_edges) => {
                let concavity = level.map_or(Concavity::Ignored, Concavity::Above);
                Some(TrackingOptions { concavity, tested_edges, ..TrackingOptions::default() })
            }
            Self::Exact => Some(TrackingOptions { accuracy: Accuracy::Exact, ..TrackingOptions::default() }),
            Self::Budget => {
                let accuracy = Accuracy::Budget(ErrorBudget { missed_share: BUDGET, audit_share: 0.1 });
                Some(TrackingOptions { accuracy, ..TrackingOptions::default() })
            }
        };
        let table = mesh.artefact::<ConnectivityTable>("reproduce tracking", progress)?;
        let edges = mesh.artefact::<TrackedEdges>("reproduce tracking", progress)?;
        let triangles = Arc::clone(mesh.mesh());
        let Some(options) = options else {
            let brute_force = BruteForce::new(triangles, table, edges);
            let in_fours = self == Self::BruteForceInFours;
            return Ok(Flier::BruteForce(Box::new(if in_fours { brute_force.in_fours() } else { brute_force })));
        };
        let tracker = Tracker::new(triangles, table, edges, options);
        Ok(Flier::Tracker(Box::new(tracker.map_err(|refusal| PrepareError::Mesh(Box::new(refusal)))?)))
    }
}

fn prepare_of_today(
    name: &'static str,
    asked: Asked,
    mesh: &Arc<PreparedMesh>,
    progress: &dyn Progress,
) -> Result<Flier, PrepareError> {
    let entry = registry::find(name).expect("the variants name methods of the registry");
    let prepared = entry.prepare(mesh, &OptionValues::defaults(entry.info.options), progress)?;
    let Prepared::Edges(method) = prepared else { unreachable!("the variants name methods that extract edges") };
    let stats = ExtractionStats::default();
    Ok(match asked {
        Asked::Edges => Flier::Edges { method, stats, found: SilhouetteEdges::default() },
        Asked::Loops => Flier::Loops { method, stats, found: SilhouetteLoops::default() },
    })
}

/// A prepared variant.
pub enum Flier {
    /// Hall's baseline.
    BruteForce(Box<BruteForce>),
    /// Hall's tracking and what was added to it.
    Tracker(Box<Tracker>),
    /// A method of today, asked for edges.
    Edges {
        /// The method.
        method: Box<dyn EdgeMethod>,
        /// What the last frame took.
        stats: ExtractionStats,
        /// What the last frame found.
        found: SilhouetteEdges,
    },
    /// A method of today, asked for loops.
    Loops {
        /// The method.
        method: Box<dyn EdgeMethod>,
        /// What the last frame took.
        stats: ExtractionStats,
        /// What the last frame found.
        found: SilhouetteLoops,
    },
}

impl Flier {
    /// Finds the silhouette of a frame.
    pub fn frame(&mut self, view: &Viewpoint) {
        match self {
            Self::BruteForce(brute_force) => drop(brute_force.update(view)),
            Self::Tracker(tracker) => drop(tracker.update(view)),
            Self::Edges { method, stats, found } => *stats = method.extract_edges(view, found),
            Self::Loops { method, stats, found } => {
                let Some(loops) = method.as_loops() else { unreachable!("asked for loops where there are some") };
                *stats = loops.extract_loops(view, found);
            }
        }
    }

    /// Faces that the last frame evaluated; distinct ones for Hall's methods.
    pub fn faces_evaluated(&self) -> u64 {
        match self {
            Self::BruteForce(brute_force) => brute_force.stats().faces_evaluated,
            Self::Tracker(tracker) => tracker.stats().faces_evaluated,
            Self::Edges { stats, .. } | Self::Loops { stats, .. } => stats.faces_tested,
        }
    }

    /// Whether a tracker found the last frame by brute force.
    pub fn fell_back(&self) -> bool {
        matches!(self, Self::Tracker(tracker) if tracker.stats().brute_force.is_some())
    }

    /// The edges that the last frame found.
    pub fn edges(&self, topology: &Topology, out: &mut SilhouetteEdges) {
        let loops = match self {
            Self::Edges { found, .. } => return out.clone_from(found),
            Self::BruteForce(brute_force) => brute_force.loops(),
            Self::Tracker(tracker) => tracker.loops(),
            Self::Loops { found, .. } => found,
        };
        out.refill(loops.half_edges().iter().map(|&half_edge| topology.edge_of(half_edge)));
    }

    /// What the next frame depends on, kept to fly the same frames again.
    pub fn state(&self) -> Option<Box<Tracker>> {
        match self {
            Self::Tracker(tracker) => Some(tracker.clone()),
            _ => None,
        }
    }

    /// Goes back to a state.
    pub fn restore(&mut self, state: &Option<Box<Tracker>>) {
        if let (Self::Tracker(tracker), Some(state)) = (self, state) {
            tracker.clone_from(state);
        }
    }
}
