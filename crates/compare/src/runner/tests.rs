use super::*;
use crate::coherence::{CoherenceMetrics, Motion};
use crate::cost::{FrameSample, PrepareCost};
use crate::drawing::{DrawError, pictures_of};
use crate::metrics::{FilledPicture, PictureKind, PictureMetrics};
use crate::options::{OptionSetting, OptionSettings};
use crate::record::{CameraRecord, Cell};
use crate::registry::{self, Registry};
use crate::scene::{CoherenceSpec, Profile};
use crate::truth::fill::FillTruth;
use frame_source::{FrameSource, Output};
use silhouette_core::{Camera, NoProgress, PreparedMesh, SilhouetteEdges, TriangleMesh, shapes};
use silhouette_render::Image;
use silhouette_testing::{Cancelling, gpu_or_skip};
use std::sync::Arc;

fn subject(name: &str, shape: &str) -> Subject {
    NamedMesh { name: name.to_owned(), mesh: Arc::new(PreparedMesh::new(shapes::by_name(shape).unwrap())) }.into()
}

/// The quick profile in small, of these methods.
fn small(methods: &[&str]) -> Scene {
    let mut scene = Profile::Quick.scene();
    (scene.picture.width, scene.picture.height) = (128, 128);
    (scene.path.frames, scene.path.scored) = (8, 2);
    scene.select(&methods.iter().map(|&name| name.to_owned()).collect::<Vec<_>>());
    scene
}

#[test]
fn what_cannot_be_compared_is_refused_before_anything_runs() {
    let torus = subject("a", "torus");
    assert!(matches!(check(&[]), Err(CompareError::NoMesh)));
    assert!(matches!(check(&[torus.clone(), torus.clone()]), Err(CompareError::SameName { .. })));
    let empty = Arc::new(PreparedMesh::new(TriangleMesh::new(vec![], vec![]).unwrap()));
    let empty: Subject = NamedMesh { name: "b".to_owned(), mesh: empty }.into();
    assert!(matches!(check(&[torus.clone(), empty.clone()]), Err(CompareError::EmptyMesh { mesh }) if mesh == "b"));
    let without_truth = Subject { truth: Some(Arc::clone(empty.mesh.mesh.mesh())), ..torus.clone() };
    assert!(matches!(check(&[without_truth]), Err(CompareError::EmptyMesh { .. })));
    assert!(check(&[torus]).is_ok());
    let mut tall = Profile::Quick.scene();
    tall.picture.height = 1 << 20;
    assert!(matches!(
        CompareConfig::new(tall, &Registry::builtin()),
        Err(SceneFault::Value { key: "picture.height", .. })
    ));
}

#[test]
fn brute_force_scores_as_the_truth_that_it_is() {
    let Some(gpu) = gpu_or_skip("brute_force_scores_as_the_truth_that_it_is") else { return };
    let mut scene = Profile::Quick.scene();
    (scene.path.frames, scene.path.scored) = (12, 3);
    for method in ["texture", "texture-lines", "normal-map-hull"] {
        scene.set(&format!("{method}.hull-vertices=60"), &Registry::builtin()).unwrap();
        scene.set(&format!("{method}.size=64"), &Registry::builtin()).unwrap();
    }
    let config = CompareConfig::new(scene, &Registry::builtin()).unwrap();
    let comparison = run(&config, &[subject("torus", "torus")], gpu, &NoProgress).unwrap();
    let registry = Registry::builtin();
    let pictures: usize = registry.entries().iter().map(|entry| pictures_of(entry.capabilities()).count()).sum();
    assert_eq!((comparison.cells.len(), comparison.pictures.len()), (pictures, pictures));
    let cell = comparison.cells.iter().find(|cell| cell.method == registry::BASELINE).unwrap();
    assert_eq!((cell.views.len(), cell.frame.frames), (3, 12));
    assert!(cell.frame.frame_ms.median > cell.frame.extract_ms.unwrap().median);
    let names: Vec<&str> = cell.artefacts.iter().map(|artefact| artefact.name.as_str()).collect();
    assert_eq!(names, registry.find(registry::BASELINE).unwrap().info().needs);
    let built: u64 = cell.artefacts.iter().map(|artefact| artefact.bytes).sum();
    assert!((1..=cell.prepare.bytes).contains(&built), "{built}");
    for view in &cell.views {
        let edges = view.edges.unwrap();
        assert!(edges.precision >= 1.0 && edges.recall >= 1.0 && edges.found == view.truth.silhouette_edges);
        let PictureMetrics::Lines(metrics) = view.metrics else { panic!("lines") };
        assert!(view.truth.visible_length_px > 500.0, "{view:?}");
        assert!(metrics.missed_1px < 0.01 && metrics.spurious_1px < 0.01, "{metrics:?}");
        assert!(metrics.chamfer_px < 0.3 && metrics.hausdorff_95_px <= 1.0, "{metrics:?}");
        assert!((metrics.width_mean_px - config.scene().pen.width_px).abs() < 0.25, "{metrics:?}");
    }
    // The same comparison finds the same pictures and scores: only times differ.
    let again = run(&config, &[subject("torus", "torus")], gpu, &NoProgress).unwrap();
    let scores = |comparison: &Comparison| {
        let metrics = |cell: &Cell| cell.views.iter().map(|view| view.metrics).collect::<Vec<_>>();
        comparison.cells.iter().map(metrics).collect::<Vec<_>>()
    };
    assert_eq!(scores(&comparison), scores(&again));
}

#[test]
fn scored_frames_are_frames_of_the_timed_path() {
    let Some(gpu) = gpu_or_skip("scored_frames_are_frames_of_the_timed_path") else { return };
    let config = CompareConfig::new(small(&["brute-force"]), &Registry::builtin()).unwrap();
    let torus = subject("torus", "torus");
    let comparison = run(&config, std::slice::from_ref(&torus), gpu, &NoProgress).unwrap();
    let path = &config.scene().path;
    let bounds = torus.mesh.mesh.mesh().bounds().unwrap();
    let cameras = path.orbit(config.scene().picture.size()).cameras(&bounds).unwrap();
    let cell = &comparison.cells[0];
    assert_eq!(cell.views.iter().map(|view| view.frame).collect::<Vec<_>>(), path.scored_frames());
    for view in &cell.views {
        assert_eq!(view.camera, CameraRecord::from(&cameras[(path.warm_up + view.frame) as usize]));
        assert!(view.frame_ms <= cell.frame.frame_ms.max, "its time is among those summarised");
    }
}

/// Recall of tracking at levels 0 and 1 along a path of `frames` frames of `step_deg`, six of them scored.
fn recall_of_tracking(gpu: &Gpu, step_deg: f64, frames: u32) -> Vec<f64> {
    let mut scene = small(&["tracking"]);
    (scene.path.step_deg, scene.path.frames, scene.path.scored) = (step_deg, frames, 6);
    scene.set("tracking.concavity=0,1", &Registry::builtin()).unwrap();
    let config = CompareConfig::new(scene, &Registry::builtin()).unwrap();
    let comparison = run(&config, &[subject("lossy", LOSSY_SHAPE)], gpu, &NoProgress).unwrap();
    let levels: Vec<_> = comparison.cells.iter().map(|cell| cell.options.0["concavity"].clone()).collect();
    assert_eq!(levels, [0.0, 1.0].map(OptionSetting::Number));
    comparison.cells.iter().map(|cell| cell.recall().unwrap()).collect()
}

/// A built-in shape on which tracking without shallow concave edges misses loops.
const LOSSY_SHAPE: &str = "blob:20000";

#[test]
fn tracking_at_level_one_loses_recall_on_the_path_that_is_timed() {
    let Some(gpu) = gpu_or_skip("tracking_at_level_one_loses_recall_on_the_path_that_is_timed") else { return };
    let recall = recall_of_tracking(gpu, 1.0, 60);
    assert!(recall[0] >= 1.0 && recall[1] < 0.99, "{recall:?}");
}

/// The control: where scored views lie 60 degrees apart, the tracker starts afresh in each of them and nothing is seen of
/// what it loses while it tracks. A comparison that scored such views, and timed others, would report a lossy method as
/// exact; the same tracker on the timed path shows the loss.
#[test]
fn distant_views_would_hide_what_tracking_loses() {
    let Some(gpu) = gpu_or_skip("distant_views_would_hide_what_tracking_loses") else { return };
    let distant = recall_of_tracking(gpu, 60.0, 6);
    assert!(distant.iter().all(|&recall| recall >= 1.0), "{distant:?}");
    let tracked = recall_of_tracking(gpu, 1.0, 60);
    assert!(distant[1] - tracked[1] > 0.01, "{distant:?} {tracked:?}");
}

/// A filled drawing: the mesh at one sample per pixel, moved to the right.
struct Fine {
    renderer: FillTruth,
    shift_px: u32,
    picture: Option<FilledPicture>,
}

impl FrameSource for Fine {
    fn output(&self) -> Output {
        Output::Fill
    }

    fn draw(&mut self, gpu: &Gpu, camera: &Camera) -> Result<FrameSample, DrawError> {
        self.picture = self.renderer.find(gpu, camera).ok();
        Ok(FrameSample { frame_ms: 1.0, ..FrameSample::default() })
    }

    fn picture(&self, _gpu: &Gpu) -> Result<Image, DrawError> {
        let image = self.picture.as_ref().unwrap().image();
        let row = |pixels: &[u8]| {
            let mut moved = vec![0; 4 * self.shift_px as usize];
            moved.extend_from_slice(&pixels[..pixels.len() - moved.len()]);
            moved
        };
        let rgba = image.rgba.chunks_exact(4 * image.width as usize).flat_map(row).collect();
        Ok(Image { rgba, ..image.clone() })
    }

    fn edges(&self) -> Option<&SilhouetteEdges> {
        None
    }
}

#[test]
fn a_source_that_fills_is_measured_against_the_filled_truth() {
    let Some(gpu) = gpu_or_skip("a_source_that_fills_is_measured_against_the_filled_truth") else { return };
    let (scene, torus) = (small(&["brute-force"]), subject("torus", "torus"));
    let mut bench = Bench::new(&scene, &torus, gpu, &NoProgress).unwrap();
    let mut cell = |shift_px: u32| {
        let renderer = FillTruth::new(gpu, torus.mesh.mesh.mesh()).unwrap();
        let mut source = Fine { renderer, shift_px, picture: None };
        let cost = PrepareCost { prepare_ms: 0.0, renderer_ms: 0.0, bytes: 0 };
        bench.score_source(&mut source, "fine", OptionSettings::default(), cost).unwrap()
    };
    let ((same, pictures, _), (moved, ..)) = (cell(0), cell(3));
    assert_eq!((same.picture, same.pen, pictures.picture), (PictureKind::Fill, None, PictureKind::Fill));
    assert_eq!(pictures.drawn, pictures.truth);
    for (same, moved) in same.views.iter().zip(&moved.views) {
        let (PictureMetrics::Fill(same_metrics), PictureMetrics::Fill(metrics)) = (same.metrics, moved.metrics) else {
            panic!("filled pictures")
        };
        assert!(same_metrics.xor_share.abs() < 1e-9 && same_metrics.boundary_chamfer_px.abs() < 1e-9);
        assert!(metrics.xor_share > 0.02 && metrics.psnr_db < same_metrics.psnr_db - 10.0, "{metrics:?}");
        assert!((0.5..3.0).contains(&metrics.boundary_chamfer_px), "{metrics:?}");
        assert!(same.truth.area_px.is_some_and(|area| area > 1000.0) && same.edges.is_none());
    }
}

/// A renderer that slips by three pixels in one frame only.
struct Slipping {
    fine: Fine,
    drawn: usize,
    slips_at: usize,
}

impl FrameSource for Slipping {
    fn output(&self) -> Output {
        self.fine.output()
    }

    fn draw(&mut self, gpu: &Gpu, camera: &Camera) -> Result<FrameSample, DrawError> {
        self.fine.shift_px = if self.drawn == self.slips_at { 3 } else { 0 };
        self.drawn += 1;
        self.fine.draw(gpu, camera)
    }

    fn picture(&self, gpu: &Gpu) -> Result<Image, DrawError> {
        self.fine.picture(gpu)
    }

    fn edges(&self) -> Option<&SilhouetteEdges> {
        None
    }
}

#[test]
fn the_pictures_kept_are_of_the_worst_view() {
    let Some(gpu) = gpu_or_skip("the_pictures_kept_are_of_the_worst_view") else { return };
    let (scene, torus) = (small(&["brute-force"]), subject("torus", "torus"));
    let mut bench = Bench::new(&scene, &torus, gpu, &NoProgress).unwrap();
    let scored = scene.path.scored_frames();
    for (at, &frame) in scored.iter().enumerate() {
        let renderer = FillTruth::new(gpu, torus.mesh.mesh.mesh()).unwrap();
        let fine = Fine { renderer, shift_px: 0, picture: None };
        let mut source = Slipping { fine, drawn: 0, slips_at: (scene.path.warm_up + frame) as usize };
        let cost = PrepareCost { prepare_ms: 0.0, renderer_ms: 0.0, bytes: 0 };
        let (cell, pictures, _) = bench.score_source(&mut source, "slipping", OptionSettings::default(), cost).unwrap();
        assert_eq!((cell.worst_view(), pictures.frame), (Some(at), frame));
        assert_ne!(pictures.drawn, pictures.truth, "frame {frame}");
    }
}

/// A coarse mesh is measured against the fine one that it stands for.
#[test]
fn the_truth_of_filled_pictures_may_be_another_mesh() {
    let Some(gpu) = gpu_or_skip("the_truth_of_filled_pictures_may_be_another_mesh") else { return };
    let scene = small(&["brute-force"]);
    let fine = Arc::new(shapes::by_name("icosphere:5").unwrap());
    let coarse = Subject { truth: Some(fine), ..subject("coarse", "icosphere:1") };
    let mut bench = Bench::new(&scene, &coarse, gpu, &NoProgress).unwrap();
    let renderer = FillTruth::new(gpu, coarse.mesh.mesh.mesh()).unwrap();
    let mut source = Fine { renderer, shift_px: 0, picture: None };
    let cost = PrepareCost { prepare_ms: 0.0, renderer_ms: 0.0, bytes: 0 };
    let (cell, ..) = bench.score_source(&mut source, "fine", OptionSettings::default(), cost).unwrap();
    let Some(PictureMetrics::Fill(metrics)) = cell.mean_metrics() else { panic!("filled pictures") };
    // A polyhedron inside of its sphere covers less of the picture.
    assert!((0.02..0.2).contains(&metrics.xor_share), "{metrics:?}");
}

#[test]
fn a_method_that_refuses_a_mesh_is_left_out_with_its_reason() {
    let Some(gpu) = gpu_or_skip("a_method_that_refuses_a_mesh_is_left_out_with_its_reason") else { return };
    let config =
        CompareConfig::new(small(&["brute-force", "tracking", "tracking-exact"]), &Registry::builtin()).unwrap();
    let comparison = run(&config, &[subject("one-sided", "moebius:12,2")], gpu, &NoProgress).unwrap();
    let left_out: Vec<_> = comparison.left_out.iter().map(|cell| (cell.mesh.as_str(), cell.method.as_str())).collect();
    assert_eq!(left_out, [("one-sided", "tracking"), ("one-sided", "tracking-exact")]);
    let note = comparison.left_out[0].to_string();
    assert!(note.starts_with("one-sided: tracking is left out: ") && note.contains("disagree"), "{note}");
    assert_eq!((comparison.pictures.len(), comparison.cells.len()), (1, 1));
    assert_eq!(comparison.cells[0].method, "brute-force");
}

#[test]
fn a_cancelled_comparison_stops() {
    let Some(gpu) = gpu_or_skip("a_cancelled_comparison_stops") else { return };
    let config = CompareConfig::new(small(&["brute-force"]), &Registry::builtin()).unwrap();
    let stopped = run(&config, &[subject("torus", "torus")], gpu, &Cancelling::at_once());
    assert!(matches!(stopped, Err(CompareError::Cancelled(_))), "{stopped:?}");
}

/// Lines that are all found are coherent along every motion; a method that finds loops by chance loses some; and one that only
/// knows the mesh at rest is marked where the mesh moves.
#[test]
fn coherence_is_measured_along_every_motion() {
    let Some(gpu) = gpu_or_skip("coherence_is_measured_along_every_motion") else { return };
    let mut scene = small(&["brute-force", "brute-force-simd", "randomized", "image-precision", "fine-mesh"]);
    (scene.picture.width, scene.picture.height, scene.picture.samples) = (512, 512, 4);
    scene.path.step_deg = 0.5;
    scene.set("randomized.probes=0.0002", &Registry::builtin()).unwrap();
    scene.coherence = Some(CoherenceSpec { motions: Motion::ALL.to_vec(), frames: 8 });
    let config = CompareConfig::new(scene, &Registry::builtin()).unwrap();
    let comparison = run(&config, &[subject("blob", "blob:5000")], gpu, &NoProgress).unwrap();
    let of = |method: &str| &comparison.cells.iter().find(|cell| cell.method == method).unwrap().coherence;
    for cell in &comparison.cells {
        let motions: Vec<Motion> = cell.coherence.iter().map(|record| record.motion).collect();
        assert_eq!(motions, Motion::ALL, "{}", cell.method);
        let follows = !["brute-force", "randomized"].contains(&cell.method.as_str());
        assert_eq!(cell.coherence[3].metrics.is_some(), follows, "{}", cell.method);
        assert!(cell.coherence[..3].iter().all(|record| record.metrics.is_some() && record.frames == 8));
    }
    for metrics in of("brute-force-simd").iter().filter_map(|record| record.metrics) {
        let expected = CoherenceMetrics { loops_lost: Some(0.0), ..CoherenceMetrics::default() };
        assert_eq!(metrics, expected);
    }
    let random = of("randomized")[0].metrics.unwrap();
    assert!(random.loops_lost.unwrap() > 0.05, "{random:?}");
    for record in of("image-precision") {
        let metrics = record.metrics.unwrap();
        assert!(metrics.flicker + metrics.dropouts < 0.02 && metrics.movement_p99_rpx < 2.0, "{record:?}");
    }
    for record in of("fine-mesh") {
        let metrics = record.metrics.unwrap();
        assert!(metrics.movement_p99_rpx < 1.5 && metrics.dropouts < 0.02, "{record:?}");
        assert_eq!(metrics.loops_lost, None);
    }
}
