//! Kernels under criterion: loading, topology, extraction, of meshes that move as well, with throughput in faces.
//!
//! Runs on built-in shapes, and on every mesh of the folder that `SILHOUETTES_MODELS` names. Each cell asserts its answer
//! before it is timed. `cargo bench --bench kernels` runs all, with `-- topology` behind it some.

use criterion::{BatchSize, BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use rayon::prelude::*;
use silhouette_core::glam::Vec3;
use silhouette_core::method::ExtractsMovingEdges;
use silhouette_core::view::ViewPreset;
use silhouette_core::{
    ExtractsEdges, FaceFacings, Method, NoOptions, SilhouetteEdges, Topology, TriangleMesh, Viewpoint, load,
};
use silhouette_extraction::{BruteForce, BruteForceSimd};
use silhouette_testing::prepare::{artefact, method, prepared};
use silhouette_testing::views::seen_from;
use silhouette_testing::{builtin, real_meshes};
use silhouette_tracking::ExactTracking;
use std::hint::black_box;
use std::sync::Arc;
use std::time::Duration;

/// Built-in shapes from a few to a million faces.
const BUILTINS: [&str; 4] = ["gear", "torus:128,64", "blob:70000", "blob:1100000"];

fn meshes() -> impl Iterator<Item = (String, TriangleMesh)> {
    BUILTINS.into_iter().map(|name| (name.to_owned(), builtin(name))).chain(real_meshes("real meshes"))
}

fn loading(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("load");
    for file in real_meshes::paths("loading") {
        let faces = load::load(&file).expect("the folder holds valid meshes").face_count();
        assert!(faces > 0);
        group.throughput(Throughput::Elements(faces as u64));
        group.bench_function(real_meshes::file_name(&file), |bencher| bencher.iter(|| load::load(black_box(&file))));
    }
    group.finish();
}

/// Sorted vertex pairs of all half-edges, as one integer each: the least that a topology has to sort.
fn edge_keys(mesh: &TriangleMesh) -> Vec<u64> {
    let pair = |a: u32, b: u32| u64::from(a.min(b)) << 32 | u64::from(a.max(b));
    mesh.triangles().iter().flat_map(|&[a, b, c]| [pair(a, b), pair(b, c), pair(c, a)]).collect()
}

fn topology(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("topology");
    for (name, mesh) in meshes() {
        let mut keys = edge_keys(&mesh);
        keys.par_sort_unstable();
        keys.dedup();
        assert_eq!(Topology::new(&mesh).edge_count(), keys.len());
        group.throughput(Throughput::Elements(mesh.face_count() as u64));
        group.bench_function(BenchmarkId::new("build", &name), |bencher| {
            bencher.iter(|| Topology::new(black_box(&mesh)));
        });
        let keys = edge_keys(&mesh);
        group.bench_function(BenchmarkId::new("sort-keys-only", &name), |bencher| {
            bencher.iter_batched_ref(|| keys.clone(), |keys| keys.par_sort_unstable(), BatchSize::LargeInput);
        });
    }
    group.finish();
}

/// Three radii from the mesh, askew.
fn viewpoint_of(mesh: &TriangleMesh) -> Viewpoint {
    let bounds = mesh.bounds().expect("the mesh has faces");
    let (direction, _) = ViewPreset::ThreeQuarter.directions();
    seen_from((bounds.center + direction * 3.0 * bounds.radius).as_vec3() + Vec3::splat(1e-3))
}

fn extraction(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("extract");
    for (name, mesh) in meshes() {
        let viewpoint = viewpoint_of(&mesh);
        let prepared = prepared(mesh);
        let mut method: BruteForce = method(&prepared);
        let topology: Arc<Topology> = artefact(&prepared);
        let mut edges = SilhouetteEdges::default();
        method.extract_edges(&viewpoint, &mut edges);
        assert_eq!(edges, SilhouetteEdges::of(&topology, &FaceFacings::new(prepared.mesh(), &viewpoint)));
        group.throughput(Throughput::Elements(prepared.mesh().face_count() as u64));
        group.bench_function(BenchmarkId::new("brute-force", &name), |bencher| {
            bencher.iter(|| method.extract_edges(black_box(&viewpoint), &mut edges));
        });
    }
    group.finish();
}

/// Positions of a mesh through which a wave travels, a hundredth of its radius high and as long as the mesh: one turn of the wave in
/// so many frames.
const FRAMES: usize = 60;

fn frames_of(mesh: &TriangleMesh) -> Vec<Vec<Vec3>> {
    let bounds = mesh.bounds().expect("the mesh has faces");
    let radius = bounds.radius as f32;
    let wave = |position: Vec3, frame: usize| {
        let phase = position.x / radius + frame as f32 / FRAMES as f32;
        position + Vec3::Y * (0.01 * radius * (phase * std::f32::consts::TAU).sin())
    };
    (0..FRAMES).map(|frame| mesh.positions().iter().map(|&position| wave(position, frame)).collect()).collect()
}

/// New positions and the silhouette edges of a viewpoint that rests, in one.
fn moving(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("moving");
    for (name, mesh) in meshes() {
        let (viewpoint, frames) = (viewpoint_of(&mesh), frames_of(&mesh));
        let prepared = prepared(mesh);
        // Some meshes cannot be tracked.
        let Ok(mut tracking) = ExactTracking::new(&prepared, NoOptions) else { continue };
        let mut simd: BruteForceSimd = method(&prepared);
        let (mut edges, mut tracked) = (SilhouetteEdges::default(), SilhouetteEdges::default());
        for positions in &frames {
            frame(&mut simd, positions, &viewpoint, &mut edges);
            frame(&mut tracking, positions, &viewpoint, &mut tracked);
            assert_eq!(edges, tracked);
        }
        group.throughput(Throughput::Elements(prepared.mesh().face_count() as u64));
        let mut next = frames.iter().cycle();
        group.bench_function(BenchmarkId::new("brute-force-simd", &name), |bencher| {
            bencher.iter(|| frame(&mut simd, next.next().expect("endless"), &viewpoint, &mut edges));
        });
        group.bench_function(BenchmarkId::new("tracking-exact", &name), |bencher| {
            bencher.iter(|| frame(&mut tracking, next.next().expect("endless"), &viewpoint, &mut tracked));
        });
    }
    group.finish();
}

fn frame(method: &mut impl ExtractsMovingEdges, positions: &[Vec3], viewpoint: &Viewpoint, out: &mut SilhouetteEdges) {
    method.update_positions(positions).expect("one position per vertex");
    method.extract_edges(viewpoint, out);
}

criterion_group! {
    name = kernels;
    config = Criterion::default()
        .sample_size(20)
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_secs(1));
    targets = loading, topology, extraction, moving
}
criterion_main!(kernels);
