//! Silhouette smoothing on one core: the time of each step per view, and per silhouette triangle.
//!
//! `cargo bench -p silhouette-benches --bench smoothing`. Built-in meshes, and with `SILHOUETTES_MODELS=DIR` the meshes of DIR
//! simplified to 500 faces. One row per mesh: the median over views of each step, in microseconds, its share of the whole, and
//! nanoseconds per silhouette triangle. Once per view the whole surface is made too, which is closed where the mesh is.

#![allow(clippy::print_stdout, reason = "the table is the output")]

use silhouette_core::view::{Camera, Framing};
use silhouette_core::{Method, PreparedMesh, Topology, TriangleMesh, shapes, simplify};
use silhouette_smoothing::{Remesher, Smoothing, SmoothingOptions, SmoothingView, ViewMesh};
use silhouette_testing::directions::spread;
use silhouette_testing::{real_meshes, views};
use std::sync::Arc;
use std::time::Instant;

/// Views of each mesh.
const VIEWS: usize = 50;

/// Passes through all views; the fastest of each view counts, as these machines are shared.
const PASSES: usize = 40;

const STEPS: [&str; 4] = ["extract", "sample", "perturb", "re-mesh"];

fn main() {
    let mut meshes: Vec<(String, TriangleMesh)> = ["icosphere:2", "torus:24,12", "knot", "blob:43000"]
        .map(|name| (name.to_owned(), shapes::by_name(name).expect("a built-in shape")))
        .into();
    for (name, mesh) in real_meshes("smoothing") {
        if let Ok(coarse) = simplify::simplify(&mesh, 500) {
            meshes.push((format!("{name} to 500"), coarse));
        }
    }
    println!(
        "{:28} {:>7} {:>6} {:>6}  {}  {:>9} {:>7}",
        "mesh",
        "faces",
        "growth",
        "crossed",
        header(),
        "whole us",
        "ns each"
    );
    for projection in [Framing::Orthographic, Framing::Perspective { fov_y_rad: 0.7 }] {
        println!("{projection:?}");
        for (name, mesh) in &meshes {
            row(name, mesh, projection);
        }
    }
}

fn header() -> String {
    STEPS.map(|step| format!("{:>16}", format!("{step} us"))).join(" ")
}

fn row(name: &str, mesh: &TriangleMesh, projection: Framing) {
    let prepared = Arc::new(PreparedMesh::new(mesh.clone()));
    let mut method = Smoothing::new(&prepared, SmoothingOptions::default()).expect("default options");
    let mut out = ViewMesh::default();
    let cameras: Vec<Camera> =
        spread(VIEWS).map(|direction| views::framed(mesh, direction, projection, [1280, 800])).collect();
    // What is drawn: of a closed mesh, without the triangles of invisible parts that are seen from behind.
    let is_closed = method.shading_mesh().is_closed();
    let mut whole = method.clone();
    let mut surface = ViewMesh::default();
    let (mut best, mut crossed, mut triangles) = ([[f64::INFINITY; 4]; VIEWS], 0, 0);
    for pass in 0..PASSES {
        for (camera, best) in cameras.iter().zip(&mut best) {
            let view = SmoothingView::from_camera(camera);
            let start = Instant::now();
            method.find_silhouette(view.eye());
            let found = Instant::now();
            method.sample(&view);
            let sampled = Instant::now();
            method.perturb(view.eye());
            let perturbed = Instant::now();
            method.local_remeshing(is_closed.then(|| view.eye()), &mut out);
            let ends = [found, sampled, perturbed, Instant::now()];
            let begins = [start, found, sampled, perturbed];
            for (best, (begin, end)) in best.iter_mut().zip(begins.into_iter().zip(ends)) {
                *best = best.min((end - begin).as_secs_f64() * 1e6);
            }
            if pass == 0 {
                crossed += method.silhouette().segments().len();
                triangles += out.triangles.len();
                whole.remesh(&view, &mut surface);
                let topology = Topology::new(&surface.to_mesh().expect("finite"));
                assert!(!is_closed || topology.boundary_edge_count() == 0, "{name}");
            }
        }
    }
    let sums = [0, 1, 2, 3].map(|step| best.iter().map(|steps| steps[step]).sum::<f64>() / VIEWS as f64);
    let whole: f64 = sums.iter().sum();
    let steps = sums.map(|sum| format!("{sum:9.2} ({:3.0} %)", 100.0 * sum / whole)).join(" ");
    let growth = triangles as f64 / (VIEWS * mesh.face_count()) as f64;
    let crossed = crossed as f64 / VIEWS as f64;
    println!(
        "{name:28} {:>7} {growth:>6.2} {crossed:>6.0}  {steps}  {whole:>9.2} {:>7.0}",
        mesh.face_count(),
        1e3 * whole / crossed
    );
}
