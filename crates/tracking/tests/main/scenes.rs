//! Meshes, views, and an oracle that shares no code with the tracker.

use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::loops::LoopWalker;
use silhouette_core::shapes::by_name;
use silhouette_core::{
    FaceFacings, NoProgress, PreparedMesh, SilhouetteEdges, SilhouetteLoops, Topology, TriangleMesh, Viewpoint, load,
};
use silhouette_tracking::{
    BruteForce, Concavity, ConnectivityTable, MeshPolicy, NotTrackable, TestedEdges, TrackedEdges, Tracker,
    TrackerOptions,
};
use std::path::{Path, PathBuf};
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
        let edges = prepared.artefact("test", &NoProgress).unwrap();
        let table = prepared.artefact("test", &NoProgress).unwrap();
        Self { name: name.into(), mesh: Arc::clone(prepared.mesh()), edges, table }
    }

    pub fn builtin(name: &str) -> Self {
        Self::new(name, by_name(name).unwrap_or_else(|error| panic!("{name}: {error}")))
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
        let bounds = self.mesh.bounds().unwrap();
        let eye = bounds.center + direction.normalize() * (distance_radii * bounds.radius);
        Viewpoint::Perspective { eye: eye.as_vec3() }
    }

    /// `frames` views on a tilted circle, `step_deg` apart.
    pub fn orbit(&self, step_deg: f64, frames: u32) -> impl Iterator<Item = Viewpoint> + '_ {
        (0..frames).map(move |frame| {
            let (sin, cos) = (f64::from(frame) * step_deg.to_radians() + 0.417).sin_cos();
            self.view(DVec3::new(cos, 0.34 + 0.2 * sin, sin), 2.4)
        })
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

/// A mesh without every `nth` face.
pub fn with_holes(mesh: &TriangleMesh, nth: usize) -> TriangleMesh {
    let kept = mesh.triangles().iter().enumerate().filter(|(face, _)| face % nth != 0);
    TriangleMesh::new(mesh.positions().to_vec(), kept.map(|(_, &triangle)| triangle).collect()).unwrap()
}

/// Several meshes as one.
pub fn together(meshes: &[TriangleMesh]) -> TriangleMesh {
    let (mut positions, mut triangles) = (Vec::new(), Vec::new());
    for mesh in meshes {
        let first = positions.len() as u32;
        positions.extend_from_slice(mesh.positions());
        triangles.extend(mesh.triangles().iter().map(|triangle| triangle.map(|vertex| vertex + first)));
    }
    TriangleMesh::new(positions, triangles).unwrap()
}

/// The same mesh elsewhere.
pub fn moved(mesh: &TriangleMesh, by: Vec3) -> TriangleMesh {
    TriangleMesh::new(mesh.positions().iter().map(|&p| p + by).collect(), mesh.triangles().to_vec()).unwrap()
}

/// Closed and open meshes of every kind, all trackable without cutting.
pub fn zoo() -> Vec<Scene> {
    let mut zoo: Vec<Scene> =
        ["blob:3000", "torus:40,24", "gear", "knot", "cylinder", "icosphere:3", "grid:20,14", "cube"]
            .into_iter()
            .map(Scene::builtin)
            .collect();
    let blob = by_name("blob:2000,0.5").unwrap();
    zoo.push(Scene::new("blob with holes", with_holes(&blob, 37)));
    zoo.push(Scene::new(
        "two tori",
        together(&[by_name("torus:30,20").unwrap(), moved(&by_name("torus:24,16").unwrap(), Vec3::new(0.3, 1.1, 0.2))]),
    ));
    zoo
}

/// The meshes in the folder that `SILHOUETTES_MODELS` names; where it is unset, none, and a line that says so.
pub fn real_meshes(test: &str) -> Vec<Scene> {
    let Some(folder) = std::env::var_os("SILHOUETTES_MODELS").map(PathBuf::from) else {
        skipped(test, "SILHOUETTES_MODELS names no folder of meshes");
        return Vec::new();
    };
    let mut paths: Vec<_> = folder.read_dir().unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.retain(|path| load::Format::of(path).is_some());
    paths.sort();
    paths.iter().map(|path| loaded(path)).collect()
}

/// One of the meshes in that folder; where there is none, a line that says so.
pub fn real_mesh(test: &str, name: &str) -> Option<Scene> {
    let path = std::env::var_os("SILHOUETTES_MODELS").map(|folder| PathBuf::from(folder).join(name));
    let path = path.filter(|path| path.exists());
    if path.is_none() {
        skipped(test, &format!("SILHOUETTES_MODELS names no folder with {name}"));
    }
    path.map(|path| loaded(&path))
}

fn loaded(path: &Path) -> Scene {
    Scene::new(path.file_name().unwrap().to_string_lossy(), load::load(path).unwrap())
}

/// Says on stderr that a test did not run, and why.
#[allow(clippy::print_stderr, reason = "a skip must be seen")]
pub fn skipped(test: &str, why: &str) {
    eprintln!("skipped {test}: {why}");
}

/// Reproducible random numbers: a linear congruential generator, of which the high bits are used.
pub struct Random(pub u64);

impl Random {
    /// A number between -1 and 1.
    pub fn signed(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    /// A number from 0 to one below `count`.
    pub fn below(&mut self, count: usize) -> usize {
        ((self.signed() * 0.5 + 0.5) * count as f64) as usize % count
    }

    /// A point in the cube from -1 to 1.
    pub fn vector(&mut self) -> DVec3 {
        DVec3::new(self.signed(), self.signed(), self.signed())
    }
}
