//! Every method under criterion, in a group per crate: its preparation, its extraction along an orbit, its frames.
//!
//! `cargo bench --bench methods` on a built-in mesh of a few thousand faces, `-- tracking` behind it one crate, `-- frame` one kind of
//! work. Frames are left out where there is no adapter. What exact methods extract is checked before it is timed, and a
//! frame must leave a picture. The group `metrics` scores pictures as `silhouettes compare` does.

use criterion::{BatchSize, BenchmarkGroup, Criterion, criterion_group, criterion_main, measurement::WallTime};
use silhouette_compare::drawing::{Drawing, FrameStyle, Ground, pictures_of};
use silhouette_compare::metrics::distance_transform::distance_transform;
use silhouette_compare::metrics::{FilledPicture, Ink, PictureKind, measure_fill};
use silhouette_compare::registry::{Entry, Registry};
use silhouette_core::method::OptionValues;
use silhouette_core::view::{Camera, Framing};
use silhouette_core::{FaceFacings, NoProgress, PreparedMesh, SilhouetteEdges, Topology, TriangleMesh};
use silhouette_render::Gpu;
use silhouette_testing::prepare::cheap_options;
use silhouette_testing::{builtin, gpu_or_skip, views};
use std::sync::Arc;
use std::time::Duration;

const MESH: &str = "blob:3000";
const SIZE: [u32; 2] = [256, 256];

/// Methods by crate.
const CRATES: [(&str, &[&str]); 7] = [
    ("extraction", &["brute-force", "brute-force-simd", "cluster-cones", "randomized"]),
    ("tracking", &["tracking", "tracking-exact"]),
    ("image-precision", &["image-precision"]),
    ("edge-mesh", &["edge-mesh"]),
    ("baselines", &["fine-mesh", "inverted-hull", "gbuffer-filter", "jump-flood", "lod-mesh"]),
    (
        "smoothing",
        &[
            "smoothing",
            "interpolated-contours",
            "boundary-curve",
            "pn-triangles",
            "phong-tessellation",
            "adaptive-refinement",
        ],
    ),
    ("texture", &["texture", "texture-lines", "normal-map-hull"]),
];

/// Views of an orbit, a degree apart.
fn orbit(mesh: &TriangleMesh) -> Vec<Camera> {
    let direction = |degree: u32| {
        let angle = f64::from(degree).to_radians();
        silhouette_core::glam::DVec3::new(angle.sin(), 0.3, angle.cos())
    };
    let framing = Framing::Perspective { fov_y_rad: 0.7 };
    (0..360).map(|degree| views::framed(mesh, direction(degree), framing, SIZE)).collect()
}

fn methods(criterion: &mut Criterion) {
    let registry = Registry::builtin();
    let listed: usize = CRATES.iter().map(|(_, names)| names.len()).sum();
    assert!(listed >= registry.entries().len(), "a method is in no group");
    let gpu = gpu_or_skip("frames of methods");
    for (name, methods) in CRATES {
        let mut group = criterion.benchmark_group(name);
        // `lod-mesh` needs a cargo feature.
        for entry in methods.iter().filter_map(|method| registry.find(method).ok()) {
            preparation(&mut group, entry);
            extraction(&mut group, entry);
            if let Some(gpu) = &gpu {
                frames(&mut group, entry, gpu);
            }
        }
        group.finish();
    }
}

/// Default options; of methods that bake, those of a small bake.
fn options(entry: &Entry) -> OptionValues {
    let info = entry.info();
    let bakes = info.needs.contains(&"silhouette-textures");
    if bakes { cheap_options(info.options) } else { OptionValues::defaults(info.options) }
}

/// All that happens once per mesh.
fn preparation(group: &mut BenchmarkGroup<'_, WallTime>, entry: &Entry) {
    let mesh = builtin(MESH);
    let options = options(entry);
    group.bench_function(format!("{}/prepare", entry.info().name), |bencher| {
        let fresh = || Arc::new(PreparedMesh::new(mesh.clone()));
        bencher.iter_batched(
            fresh,
            |mesh| entry.prepare(&mesh, &options, &NoProgress).expect("the mesh is closed"),
            BatchSize::PerIteration,
        );
    });
}

fn extraction(group: &mut BenchmarkGroup<'_, WallTime>, entry: &Entry) {
    let mesh = Arc::new(PreparedMesh::new(builtin(MESH)));
    let options = options(entry);
    let mut prepared = entry.prepare(&mesh, &options, &NoProgress).expect("the mesh is closed");
    let cameras = orbit(mesh.mesh());
    let Some(method) = prepared.edges() else { return };
    let topology = mesh.artefact::<Topology>("benchmark", &NoProgress).expect("not cancelled");
    let mut edges = SilhouetteEdges::default();
    for camera in &cameras {
        method.extract_edges(&camera.viewpoint(), &mut edges);
        let truth = SilhouetteEdges::of(&topology, &FaceFacings::new(mesh.mesh(), &camera.viewpoint()));
        assert!(!entry.info().exact || edges == truth, "{}", entry.info().name);
    }
    let mut next = cameras.iter().cycle();
    group.bench_function(format!("{}/extract", entry.info().name), |bencher| {
        bencher.iter(|| method.extract_edges(&next.next().expect("endless").viewpoint(), &mut edges));
    });
}

fn frames(group: &mut BenchmarkGroup<'_, WallTime>, entry: &Entry, gpu: &Gpu) {
    let style = FrameStyle { size: SIZE, pen_width_px: 2.0, samples: 1, ground: Ground::Paper };
    let options = options(entry);
    for kind in pictures_of(entry.capabilities()) {
        let mesh = Arc::new(PreparedMesh::new(builtin(MESH)));
        let prepared = entry.prepare(&mesh, &options, &NoProgress).expect("the mesh is closed");
        let mut drawing = Drawing::new(gpu, &mesh, prepared, kind, style).expect("it yields this kind of picture");
        let cameras = orbit(mesh.mesh());
        drawing.draw(gpu, &cameras[0]).expect("the view is plain");
        let picture = drawing.picture(gpu).expect("the picture is there");
        // An extractor that may miss loops may miss the only one of a view.
        let may_be_blank = entry.capabilities().edges && !entry.info().exact;
        let has_ink = Ink::from_picture(&picture).ink_pixels().next().is_some();
        assert!(has_ink || may_be_blank, "{} is blank", entry.info().name);
        let mut next = cameras.iter().cycle();
        let name = if kind == PictureKind::Fill { "fill" } else { "lines" };
        group.bench_function(format!("{}/frame of {name}", entry.info().name), |bencher| {
            bencher.iter(|| drawing.draw(gpu, next.next().expect("endless")).expect("the view is plain"));
        });
    }
}

fn metrics(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("metrics");
    let radius = f64::from(SIZE[0]) * 0.4;
    let disc = |radius: f64| {
        Ink::from_fn(SIZE[0], SIZE[1], |x, y| {
            let [dx, dy] = [x, y].map(|at| f64::from(at) - f64::from(SIZE[0]) * 0.5);
            if dx.hypot(dy) < radius { 1.0 } else { 0.0 }
        })
    };
    let [drawn, truth] = [radius, radius + 2.0].map(|radius| FilledPicture::new(disc(radius).to_picture()));
    let mask = disc(radius).mask();
    assert!(distance_transform(&mask, SIZE[0] as usize).iter().all(|distance| distance.is_finite()));
    group.bench_function("distance transform", |bencher| {
        bencher.iter(|| distance_transform(&mask, SIZE[0] as usize));
    });
    assert!(measure_fill(&drawn, &truth) != measure_fill(&truth, &truth), "a picture that is off is worse");
    group.bench_function("fill", |bencher| bencher.iter(|| measure_fill(&drawn, &truth)));
    group.finish();
}

criterion_group! {
    name = all;
    config = Criterion::default()
        .sample_size(10)
        .warm_up_time(Duration::from_millis(100))
        .measurement_time(Duration::from_millis(500));
    targets = methods, metrics
}
criterion_main!(all);
