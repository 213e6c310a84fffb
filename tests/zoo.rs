//! Meshes and views to test on, asked for by property instead of by file.

use glam::Vec3;
use proptest::prelude::*;
use silhouette_core::method::{Method, NoOptions};
use silhouette_core::shapes::{Sphere, Torus, by_name};
use silhouette_core::{
    ExtractsEdges, ExtractsLoops, FaceFacings, NoProgress, PreparedMesh, SilhouetteEdges, SilhouetteLoops, Topology,
    TriangleMesh, Viewpoint, load,
};
use silhouette_extraction::BruteForce;
use std::path::PathBuf;
use std::sync::Arc;

/// One view of one mesh with everything that brute force says of it.
pub struct Seen {
    pub topology: Arc<Topology>,
    pub facings: FaceFacings,
    pub edges: SilhouetteEdges,
    pub loops: SilhouetteLoops,
}

/// Brute force on one view.
pub fn look(mesh: &TriangleMesh, viewpoint: &Viewpoint) -> Seen {
    let prepared = Arc::new(PreparedMesh::new(mesh.clone()));
    let mut method = BruteForce::new(&prepared, NoOptions).unwrap();
    let (mut edges, mut loops) = (SilhouetteEdges::default(), SilhouetteLoops::default());
    method.extract_edges(viewpoint, &mut edges);
    method.extract_loops(viewpoint, &mut loops);
    let topology = prepared.artefact("test", &NoProgress).unwrap();
    let facings = FaceFacings::new(mesh, viewpoint);
    Seen { topology, facings, edges, loops }
}

/// Reproducible random numbers: a linear congruential generator, of which the high bits are used.
pub struct Random(pub u64);

impl Random {
    /// A number between -1 and 1.
    pub fn signed(&mut self) -> f32 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 40) as f32 / (1_u32 << 23) as f32 - 1.0
    }

    /// A number from 0 to one below `count`.
    pub fn below(&mut self, count: usize) -> usize {
        ((f64::from(self.signed()) * 0.5 + 0.5) * count as f64) as usize % count
    }

    /// A point in the cube from -1 to 1.
    pub fn vector(&mut self) -> Vec3 {
        Vec3::new(self.signed(), self.signed(), self.signed())
    }
}

/// Moves every vertex by up to `amount`, differently for each `seed`.
pub fn shaken(mesh: &TriangleMesh, amount: f32, seed: u64) -> TriangleMesh {
    let mut random = Random(seed);
    let positions = mesh.positions().iter().map(|&p| p + random.vector() * amount).collect();
    TriangleMesh::new(positions, mesh.triangles().to_vec()).unwrap()
}

/// A closed, consistently wound mesh: a sphere or torus, shaken up to self-intersection.
pub fn closed_mesh() -> impl Strategy<Value = TriangleMesh> {
    let base = prop_oneof![
        (0_u32..3).prop_map(|level| Sphere::default().icosphere(level).unwrap()),
        (3_u32..12, 3_u32..9).prop_map(|(around, across)| Torus::default().mesh(around, across).unwrap()),
    ];
    (base, 0.0_f32..0.6, any::<u64>()).prop_map(|(mesh, amount, seed)| shaken(&mesh, amount, seed))
}

/// A closed mesh with some of its faces taken away.
pub fn open_mesh() -> impl Strategy<Value = TriangleMesh> {
    (closed_mesh(), any::<u64>()).prop_map(|(mesh, keep)| {
        let kept = mesh.triangles().iter().enumerate().filter(|(face, _)| keep >> (face % 64) & 1 == 1);
        TriangleMesh::new(mesh.positions().to_vec(), kept.map(|(_, &triangle)| triangle).collect()).unwrap()
    })
}

/// Any view: from near, far, inside, along axes.
pub fn viewpoint() -> impl Strategy<Value = Viewpoint> {
    let direction = prop::array::uniform3(-3.0_f32..3.0);
    let grid = prop::array::uniform3(-2_i8..3).prop_map(|p| p.map(f32::from));
    prop_oneof![
        direction.clone().prop_map(|eye| Viewpoint::Perspective { eye: eye.into() }),
        grid.clone().prop_map(|eye| Viewpoint::Perspective { eye: eye.into() }),
        direction.prop_map(|to| Viewpoint::Orthographic { toward_viewer: to.into() }),
        grid.prop_map(|to| Viewpoint::Orthographic { toward_viewer: to.into() }),
    ]
}

/// `count` directions spread evenly over the sphere (a Fibonacci lattice).
pub fn directions(count: usize) -> impl Iterator<Item = Vec3> {
    let golden = std::f64::consts::PI * (3.0 - 5.0_f64.sqrt());
    (0..count).map(move |index| {
        let y = 1.0 - 2.0 * (index as f64 + 0.5) / count as f64;
        let (sin, cos) = (golden * index as f64).sin_cos();
        let radius = (1.0 - y * y).sqrt();
        glam::DVec3::new(radius * cos, y, radius * sin).as_vec3()
    })
}

/// Built-in shapes of every family, small.
pub fn builtins() -> Vec<(&'static str, TriangleMesh)> {
    let names = [
        "cube",
        "icosphere:2",
        "uv-sphere",
        "ellipsoid",
        "cylinder",
        "cone",
        "torus",
        "knot",
        "grid",
        "moebius",
        "gear",
    ];
    names.into_iter().chain(["blob:2000"]).map(|name| (name, by_name(name).unwrap())).collect()
}

/// The meshes in the folder that `SILHOUETTES_MODELS` names; where it is unset, none, and a line that says so.
pub fn real_meshes(test: &str) -> Vec<(String, TriangleMesh)> {
    let Some(folder) = std::env::var_os("SILHOUETTES_MODELS").map(PathBuf::from) else {
        skipped(test, "SILHOUETTES_MODELS names no folder of meshes");
        return Vec::new();
    };
    let mut paths: Vec<_> = folder.read_dir().unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.retain(|path| load::Format::of(path).is_some());
    paths.sort();
    let name = |path: &PathBuf| path.file_name().unwrap().to_string_lossy().into_owned();
    paths.iter().map(|path| (name(path), load::load(path).unwrap())).collect()
}

/// Says on stderr that a test did not run, and why.
#[allow(clippy::print_stderr, reason = "a skip must be seen")]
pub fn skipped(test: &str, why: &str) {
    eprintln!("skipped {test}: {why}");
}
