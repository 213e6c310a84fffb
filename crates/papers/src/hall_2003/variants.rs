//! What flies the path: the paper's methods, what was added to them, and what they compete with today.

use super::printed::LEVELS_RAD;
use silhouette_core::method::{ExtractionStats, PrepareError};
use silhouette_core::{
    ExtractsLoops, Method, PreparedMesh, Progress, SilhouetteEdges, SilhouetteLoops, Topology, Viewpoint,
};
use silhouette_extraction::{BruteForceSimd, ClusterCones};
use silhouette_tracking::{
    Accuracy, BruteForce, Concavity, ConnectivityTable, ErrorBudget, TestedEdges, TrackedEdges, Tracker,
    TrackerOptions, Tracking,
};
use std::sync::Arc;

/// Share of the silhouette's length that the variant with a budget may miss.
pub const BUDGET: f32 = 0.01;

/// What an extractor of today is asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Asked {
    /// Sorted edges.
    Edges,
    /// Closed, ordered loops, as tracking yields them.
    Loops,
}

/// An extractor of today.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Extractor {
    /// All faces, many at a time.
    BruteForceSimd,
    /// Whole clusters of faces at a time.
    ClusterCones,
}

impl Extractor {
    /// Name of the method.
    pub fn name(self) -> &'static str {
        match self {
            Self::BruteForceSimd => BruteForceSimd::INFO.name,
            Self::ClusterCones => ClusterCones::INFO.name,
        }
    }

    fn prepare(
        self,
        mesh: &Arc<PreparedMesh>,
        progress: &dyn Progress,
    ) -> Result<Box<dyn ExtractsLoops>, PrepareError> {
        fn boxed<M: Method + ExtractsLoops>(
            mesh: &Arc<PreparedMesh>,
            progress: &dyn Progress,
        ) -> Result<Box<dyn ExtractsLoops>, PrepareError> {
            Ok(Box::new(M::prepare(mesh, &M::Options::default(), progress)?))
        }
        match self {
            Self::BruteForceSimd => boxed::<BruteForceSimd>(mesh, progress),
            Self::ClusterCones => boxed::<ClusterCones>(mesh, progress),
        }
    }
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
    /// An extractor of today.
    Today(Extractor, Asked),
}

impl Variant {
    /// All of them, in the order of the table; the baseline first.
    pub fn all() -> Vec<Self> {
        let every_edge = |level| Self::Level(level, TestedEdges::All);
        let levels = LEVELS_RAD.map(|level_rad| every_edge(Some(level_rad)));
        let single = [0.0, 0.2].map(|level_rad| Self::Level(Some(level_rad), TestedEdges::Single));
        let today = [Extractor::BruteForceSimd, Extractor::ClusterCones]
            .into_iter()
            .flat_map(|extractor| [Asked::Edges, Asked::Loops].map(|asked| Self::Today(extractor, asked)));
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
            Self::Today(extractor, Asked::Edges) => format!("{}, edges", extractor.name()),
            Self::Today(extractor, Asked::Loops) => format!("{}, loops", extractor.name()),
        }
    }

    /// Column of the paper's table that holds it.
    pub fn paper_column(self) -> Option<usize> {
        match self {
            Self::Level(Some(level_rad), TestedEdges::All) => {
                LEVELS_RAD.iter().position(|level| level.total_cmp(&level_rad).is_eq())
            }
            _ => None,
        }
    }
}

/// A prepared variant.
pub struct Flier {
    finder: Finder,
    /// The state that [`restore`](Self::restore) returns to.
    kept: Option<Box<Tracker>>,
}

enum Finder {
    BruteForce(Box<BruteForce>),
    Tracker(Box<Tracker>),
    Edges { method: Box<dyn ExtractsLoops>, stats: ExtractionStats, found: SilhouetteEdges },
    Loops { method: Box<dyn ExtractsLoops>, stats: ExtractionStats, found: SilhouetteLoops },
}

impl Finder {
    fn new(variant: Variant, mesh: &Arc<PreparedMesh>, progress: &dyn Progress) -> Result<Self, PrepareError> {
        let options = match variant {
            Variant::Today(extractor, asked) => {
                let method = extractor.prepare(mesh, progress)?;
                let stats = ExtractionStats::default();
                return Ok(match asked {
                    Asked::Edges => Self::Edges { method, stats, found: SilhouetteEdges::default() },
                    Asked::Loops => Self::Loops { method, stats, found: SilhouetteLoops::default() },
                });
            }
            Variant::BruteForce | Variant::BruteForceInFours => None,
            Variant::Level(level, tested_edges) => {
                let concavity = level.map_or(Concavity::Ignored, Concavity::Above);
                Some(TrackerOptions { concavity, tested_edges, ..TrackerOptions::default() })
            }
            Variant::Exact => Some(TrackerOptions { accuracy: Accuracy::Exact, ..TrackerOptions::default() }),
            Variant::Budget => {
                let accuracy = Accuracy::Budget(ErrorBudget { missed_share: BUDGET, audit_share: 0.1 });
                Some(TrackerOptions { accuracy, ..TrackerOptions::default() })
            }
        };
        let table = mesh.artefact::<ConnectivityTable>(Tracking::INFO.name, progress)?;
        let edges = mesh.artefact::<TrackedEdges>(Tracking::INFO.name, progress)?;
        let triangles = Arc::clone(mesh.mesh());
        let Some(options) = options else {
            let brute_force = BruteForce::new(triangles, table, edges);
            let in_fours = variant == Variant::BruteForceInFours;
            return Ok(Self::BruteForce(Box::new(if in_fours { brute_force.in_fours() } else { brute_force })));
        };
        let tracker = Tracker::new(triangles, table, edges, options);
        Ok(Self::Tracker(Box::new(tracker.map_err(|refusal| PrepareError::Mesh(Box::new(refusal)))?)))
    }
}

impl Flier {
    /// Prepares a variant.
    ///
    /// # Errors
    /// [`PrepareError`]: cancelled, or a mesh that cannot be tracked.
    pub fn new(variant: Variant, mesh: &Arc<PreparedMesh>, progress: &dyn Progress) -> Result<Self, PrepareError> {
        Ok(Self { finder: Finder::new(variant, mesh, progress)?, kept: None })
    }

    /// Finds the silhouette of a frame.
    pub fn frame(&mut self, view: &Viewpoint) {
        match &mut self.finder {
            Finder::BruteForce(brute_force) => drop(brute_force.update(view)),
            Finder::Tracker(tracker) => drop(tracker.update(view)),
            Finder::Edges { method, stats, found } => *stats = method.extract_edges(view, found),
            Finder::Loops { method, stats, found } => *stats = method.extract_loops(view, found),
        }
    }

    /// Faces that the last frame evaluated; distinct ones for Hall's methods.
    pub fn faces_evaluated(&self) -> u64 {
        match &self.finder {
            Finder::BruteForce(brute_force) => brute_force.stats().faces_evaluated,
            Finder::Tracker(tracker) => tracker.stats().faces_evaluated,
            Finder::Edges { stats, .. } | Finder::Loops { stats, .. } => stats.faces_tested,
        }
    }

    /// Whether frames depend on those before them.
    pub fn has_a_past(&self) -> bool {
        matches!(self.finder, Finder::Tracker(_))
    }

    /// Whether a tracker found the last frame by brute force.
    pub fn fell_back(&self) -> bool {
        matches!(&self.finder, Finder::Tracker(tracker) if tracker.stats().brute_force.is_some())
    }

    /// The loops that the last frame found, for variants that find loops.
    pub fn loops(&self) -> Option<&SilhouetteLoops> {
        match &self.finder {
            Finder::BruteForce(brute_force) => Some(brute_force.loops()),
            Finder::Tracker(tracker) => Some(tracker.loops()),
            Finder::Loops { found, .. } => Some(found),
            Finder::Edges { .. } => None,
        }
    }

    /// The edges that the last frame found.
    pub fn edges(&self, topology: &Topology, out: &mut SilhouetteEdges) {
        if let Finder::Edges { found, .. } = &self.finder {
            out.clone_from(found);
        } else if let Some(loops) = self.loops() {
            out.refill(loops.half_edges().iter().map(|&half_edge| topology.edge_of(half_edge)));
        }
    }

    /// Keeps what the next frame depends on, to fly the same frames again.
    pub fn keep(&mut self) {
        if let Finder::Tracker(tracker) = &self.finder {
            self.kept = Some(tracker.clone());
        }
    }

    /// Returns to the state that was kept.
    pub fn restore(&mut self) {
        if let (Finder::Tracker(tracker), Some(kept)) = (&mut self.finder, &self.kept) {
            tracker.clone_from(kept);
        }
    }
}
