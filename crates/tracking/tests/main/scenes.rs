//! Meshes, views, and an oracle that shares no code with the tracker.

use silhouette_core::glam::DVec3;
use silhouette_core::loops::LoopWalker;
use silhouette_core::{FaceFacings, PreparedMesh, SilhouetteEdges, SilhouetteLoops, Topology, TriangleMesh, Viewpoint};
use silhouette_testing::prepare::artefact;
use silhouette_testing::views::{orbit, seen_from_radii};
use silhouette_testing::{builtin, zoo};
use silhouette_tracking::{
    BruteForce, Concavity, ConnectivityTable, MeshPolicy, NotTrackable, TestedEdges, TrackedEdges, Tracker,
    TrackerOptions,
};
use std::sync::Arc;

/// A mesh with all that its trackers share.
pub struct Scene {
    pub name: String,
    pub mesh: Arc<TriangleMesh>,
    pub edges: Arc<TrackedEdges>,
    pub table: Arc<ConnectivityTable>,
}

impl Scene {
    pub fn new(name: impl Into<String>, mesh: TriangleMesh) -> Self {
        let prepared = PreparedMesh::new(mesh);
        let mesh = Arc::clone(prepared.mesh());
        Self { name: name.into(), mesh, edges: artefact(&prepared), table: artefact(&prepared) }
    }

    pub fn builtin(name: &str) -> Self {
        Self::new(name, builtin(name))
    }

    pub fn try_tracker(&self, options: TrackerOptions) -> Result<Tracker, NotTrackable> {
        Tracker::new(Arc::clone(&self.mesh), Arc::clone(&self.table), Arc::clone(&self.edges), options)
    }

    pub fn tracker(&self, options: TrackerOptions) -> Tracker {
        self.try_tracker(TrackerOptions { mesh_policy: MeshPolicy::Cut, ..options }).unwrap()
    }

    pub fn brute_force(&self) -> BruteForce {
        BruteForce::new(Arc::clone(&self.mesh), Arc::clone(&self.table), Arc::clone(&self.edges))
    }

    /// A view from `distance_radii` of the bounding sphere.
    pub fn view(&self, direction: DVec3, distance_radii: f64) -> Viewpoint {
        seen_from_radii(&self.mesh, direction, distance_radii)
    }

    /// `frames` views on a tilted circle, `step_deg` apart.
    pub fn orbit(&self, step_deg: f64, frames: u32) -> impl Iterator<Item = Viewpoint> + '_ {
        orbit(&self.mesh, step_deg, frames)
    }
}

/// Options with a level and a number of tested edges.
pub fn options(level_rad: f32, tested_edges: TestedEdges) -> TrackerOptions {
    TrackerOptions { concavity: Concavity::Above(level_rad), tested_edges, ..TrackerOptions::default() }
}

/// All silhouette loops of a view: every face by the exact predicate, every edge, then the core's walker.
#[derive(Default)]
pub struct Oracle {
    facings: FaceFacings,
    edges: SilhouetteEdges,
    walker: LoopWalker,
    pub loops: SilhouetteLoops,
}

impl Oracle {
    pub fn look(&mut self, mesh: &TriangleMesh, topology: &Topology, viewpoint: &Viewpoint) -> &SilhouetteLoops {
        self.facings.classify(mesh, viewpoint);
        self.edges = SilhouetteEdges::of(topology, &self.facings);
        self.walker.walk(topology, &self.facings, &self.edges, &mut self.loops);
        &self.loops
    }
}

/// The same loops in the order that does not depend on how they were found.
pub fn ordered(topology: &Topology, loops: &SilhouetteLoops) -> SilhouetteLoops {
    let mut out = SilhouetteLoops::default();
    out.refill_ordered(topology, loops, &mut Vec::new());
    out
}

/// Closed and open meshes of every kind, all trackable without cutting.
pub fn zoo() -> Vec<Scene> {
    zoo::edge_manifold().into_iter().map(|(name, mesh)| Scene::new(name, mesh)).collect()
}

/// The meshes in the folder that `SILHOUETTES_MODELS` names; if it is unset, none, and a line that says so.
pub fn real_meshes(test: &str) -> Vec<Scene> {
    silhouette_testing::real_meshes(test).map(|(name, mesh)| Scene::new(name, mesh)).collect()
}

/// One of the meshes in that folder; where there is none, a line that says so.
pub fn real_mesh(test: &str, name: &str) -> Option<Scene> {
    Some(Scene::new(name, silhouette_testing::real_mesh(test, name)?))
}

// Tests that look for one mesh among the real ones skip with it.
