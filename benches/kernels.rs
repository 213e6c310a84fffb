//! Kernels under criterion: loading, topology, extraction, with throughput in faces.
//!
//! Runs on built-in shapes, and on every mesh of the folder that `SILHOUETTES_MODELS` names. Each cell asserts its answer
//! before it is timed. `cargo bench --bench kernels` runs all, with `-- topology` behind it some.

use criterion::{BatchSize, BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use rayon::prelude::*;
use silhouette_core::glam::Vec3;
use silhouette_core::method::{Method, NoOptions};
use silhouette_core::shapes::by_name;
use silhouette_core::{
    ExtractsEdges, FaceFacings, NoProgress, PreparedMesh, SilhouetteEdges, Topology, TriangleMesh, Viewpoint, load,
};
use silhouette_extraction::BruteForce;
use std::hint::black_box;
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

/// Built-in shapes from a few to a million faces.
const BUILTINS: [&str; 4] = ["gear", "torus:128,64", "blob:70000", "blob:1100000"];

fn model_files() -> Vec<PathBuf> {
    let Some(folder) = std::env::var_os("SILHOUETTES_MODELS") else { return Vec::new() };
    let entries = PathBuf::from(folder).read_dir().expect("SILHOUETTES_MODELS names a readable folder");
    let mut files: Vec<_> = entries.map(|entry| entry.expect("the folder can be read").path()).collect();
    files.retain(|file| load::Format::of(file).is_some());
    files.sort();
    files
}

fn name_of(file: &std::path::Path) -> String {
    file.file_name().expect("a file has a name").to_string_lossy().into_owned()
}

fn meshes() -> Vec<(String, TriangleMesh)> {
    let builtin = BUILTINS.map(|name| (name.to_owned(), by_name(name).expect("the table holds valid names")));
    let real = model_files().into_iter().map(|file| {
        let mesh = load::load(&file).expect("the folder holds valid meshes");
        (name_of(&file), mesh)
    });
    builtin.into_iter().chain(real).collect()
}

fn loading(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("load");
    for file in model_files() {
        let faces = load::load(&file).expect("the folder holds valid meshes").face_count();
        assert!(faces > 0);
        group.throughput(Throughput::Elements(faces as u64));
        group.bench_function(name_of(&file), |bencher| bencher.iter(|| load::load(black_box(&file))));
    }
    group.finish();
}

/// Sorted vertex pairs of all half-edges, as one integer each: what a topology has to sort at least.
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

fn extraction(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("extract");
    for (name, mesh) in meshes() {
        let bounds = mesh.bounds().expect("the mesh has faces");
        let eye = (bounds.center + silhouette_core::glam::DVec3::new(0.55, 0.35, 1.0) * 3.0 * bounds.radius).as_vec3();
        let viewpoint = Viewpoint::Perspective { eye: eye + Vec3::splat(1e-3) };
        let prepared = Arc::new(PreparedMesh::new(mesh));
        let mut method = BruteForce::new(&prepared, NoOptions).expect("nothing cancels and there are no options");
        let topology = prepared.artefact::<Topology>("bench", &NoProgress).expect("nothing cancels");
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

criterion_group! {
    name = kernels;
    config = Criterion::default()
        .sample_size(20)
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_secs(1));
    targets = loading, topology, extraction
}
criterion_main!(kernels);
