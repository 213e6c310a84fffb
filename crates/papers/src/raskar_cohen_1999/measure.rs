//! Every variant of every mesh: pictures scored, faces that they lose, frames timed.

use super::lost::{self, Lost};
use super::score::{Score, score};
use super::soup::soup;
use super::timed::{FrameTimes, Plain, time};
use super::variants::{UNORIENTED, VARIANTS, Variant, style};
use crate::error::{Cause, PaperError};
use crate::paper::Run;
use silhouette_compare::drawing::{DrawError, Drawing};
use silhouette_compare::metrics::{Ink, TruePen};
use silhouette_compare::truth::{TrueLines, Truth, TruthFinder};
use silhouette_compare::{NamedMesh, Profile};
use silhouette_core::view::{Camera, Framing, ViewPreset};
use silhouette_core::{PreparedMesh, Progress, TriangleMesh};
use silhouette_gpu::Cull;
use silhouette_gpu::PenPlacement;
use silhouette_render::Gpu;
use std::collections::HashMap;
use std::sync::Arc;

/// What was measured on one mesh.
#[derive(Debug, Clone)]
pub struct MeshResult {
    /// Its name.
    pub name: String,
    /// Number of its faces.
    pub faces: usize,
    /// Length of its visible lines in pixels.
    pub visible_px: f64,
    /// Side of the picture in pixels.
    pub size_px: u32,
    /// Frame times, of [`VARIANTS`].
    pub times: FrameTimes,
    /// Scores of [`VARIANTS`], one sample per pixel, then those of [`UNORIENTED`] drawing the [`soup`] of the mesh.
    pub sharp: Vec<VariantResult>,
    /// Scores of [`VARIANTS`] with four samples per pixel, as the command line draws by default.
    pub smooth: Vec<VariantResult>,
    /// Front faces that pictures lose, one per size.
    pub lost: Vec<Lost>,
}

/// The score of one variant on one mesh.
#[derive(Debug, Clone, Copy)]
pub struct VariantResult {
    /// The variant.
    pub variant: Variant,
    /// The score of its picture.
    pub score: Score,
}

/// Rounds of timing.
fn rounds(profile: Profile) -> u32 {
    match profile {
        Profile::Quick => 9,
        Profile::Full => 15,
    }
}

/// Draws every variant of every mesh. With [`Profile::Quick`] half a minute for a mesh of a hundred thousand faces in software.
///
/// # Errors
/// [`PaperError`].
pub fn meshes(run: &Run<'_>, gpu: &Gpu) -> Result<Vec<MeshResult>, PaperError> {
    let each =
        run.meshes.iter().map(|named| measure_mesh(run, named, gpu).map_err(PaperError::of::<Cause>(&named.name)));
    each.collect()
}

/// The view that meshes are drawn in.
///
/// # Errors
/// [`Cause::EmptyMesh`], or no camera.
pub fn framed(mesh: &TriangleMesh, size: [u32; 2]) -> Result<Camera, Cause> {
    let bounds = mesh.bounds().ok_or(Cause::EmptyMesh)?;
    let (direction, up) = ViewPreset::default().directions();
    Ok(Camera::framing(&bounds, direction, up, Framing::Perspective { fov_y_rad: 0.7 }, size)?)
}

fn measure_mesh(run: &Run<'_>, NamedMesh { name, mesh }: &NamedMesh, gpu: &Gpu) -> Result<MeshResult, Cause> {
    let progress = run.progress;
    let camera = framed(mesh.mesh(), run.profile.size())?;
    progress.stage(&format!("{name}: pictures"), (1 + 2 * VARIANTS.len() + UNORIENTED.len()) as u64);
    let mut scene = Scene::new(mesh, camera, progress)?;
    let drawing = |mesh: &Arc<PreparedMesh>, variant: &Variant, samples| {
        variant.drawing(gpu, mesh, style(camera.size(), samples), progress)
    };
    let mut drawings = VARIANTS.iter().map(|variant| drawing(mesh, variant, 1)).collect::<Result<Vec<_>, _>>()?;
    let mut scored = |variant: Variant, drawing: &mut Drawing| -> Result<VariantResult, Cause> {
        let score = scene.score(gpu, drawing)?;
        progress.advance(1);
        Ok(VariantResult { variant, score })
    };
    let mut sharp = Vec::new();
    for (variant, drawing) in VARIANTS.into_iter().zip(&mut drawings) {
        sharp.push(scored(variant, drawing)?);
    }
    let soup = Arc::new(PreparedMesh::new(soup(mesh.mesh())));
    for unoriented in UNORIENTED {
        sharp.push(scored(unoriented.variant, &mut drawing(&soup, &unoriented.variant, 1)?)?);
    }
    let mut smooth = Vec::new();
    for variant in VARIANTS {
        smooth.push(scored(variant, &mut drawing(mesh, &variant, 4)?)?);
    }

    progress.stage(&format!("{name}: lost faces"), 1);
    let lost = lost::measure(gpu, [mesh, &soup], &camera, progress)?;
    progress.advance(1);

    let rounds = rounds(run.profile);
    progress.stage(&format!("{name}: time"), u64::from(rounds) + 1);
    let plain = |cull| Plain::new(gpu, mesh, style(camera.size(), 1), cull);
    let times = time(gpu, &camera, &mut [plain(Cull::None)?, plain(Cull::Back)?], &mut drawings, rounds, progress)?;
    Ok(MeshResult {
        name: name.clone(),
        faces: mesh.mesh().face_count(),
        visible_px: scene.truth.lines.total_length_px(),
        size_px: camera.size()[0],
        times,
        sharp,
        smooth,
        lost,
    })
}

/// One view, and what is true of it.
struct Scene {
    camera: Camera,
    truth: Truth,
    /// The silhouette edges, visible or not.
    all_lines: TrueLines,
    /// The visible lines as drawn by pens of each placement.
    true_pens: HashMap<PenPlacement, Ink>,
}

impl Scene {
    fn new(mesh: &Arc<PreparedMesh>, camera: Camera, progress: &dyn Progress) -> Result<Self, Cause> {
        let mut finder = TruthFinder::new(mesh, progress)?;
        let truth = finder.find(&camera, progress)?;
        let all_lines = finder.lines_seen_or_not(&camera, progress)?;
        progress.advance(1);
        Ok(Self { camera, truth, all_lines, true_pens: HashMap::new() })
    }

    /// Draws the view and scores the picture.
    fn score(&mut self, gpu: &Gpu, drawing: &mut Drawing) -> Result<Score, DrawError> {
        drawing.draw(gpu, &self.camera)?;
        let ink = Ink::from_picture(&drawing.picture(gpu)?);
        let pen = drawing.pen();
        let picture = self.true_pens.entry(pen.placement).or_insert_with(|| self.truth.draw(pen));
        let pen = TruePen { picture, width_px: pen.width_px };
        Ok(score(&ink, &self.truth.lines, &self.all_lines, pen))
    }
}

#[cfg(test)]
mod tests {
    use super::super::variants::{SCALE_99, SCREEN};
    use super::*;
    use silhouette_core::NoProgress;
    use silhouette_core::shapes::by_name;
    use silhouette_testing::gpu_or_skip;

    fn of<'a>(mesh: &'a MeshResult, label: &str) -> &'a Score {
        &mesh.sharp.iter().find(|result| result.variant.label == label).unwrap().score
    }

    #[test]
    fn variants_draw_what_follows_from_the_geometry() {
        let Some(gpu) = gpu_or_skip("variants_draw_what_follows_from_the_geometry") else { return };
        let mesh = Arc::new(PreparedMesh::new(by_name("blob:5672").unwrap()));
        let named = NamedMesh { name: "blob".to_owned(), mesh };
        let run = Run { profile: Profile::Quick, meshes: &[], gpu: Some(gpu), progress: &NoProgress };
        let mesh = &measure_mesh(&run, &named, gpu).unwrap();
        let screen = of(mesh, SCREEN.label);
        assert!((1.9..2.1).contains(&screen.metrics.width_mean_px), "{screen:?}");
        assert!(screen.metrics.missed_1px + screen.stray + screen.metrics.gaps_per_1000px < 1e-12, "{screen:?}");
        for nothing in ["equal", "far plane closer"] {
            assert!(of(mesh, nothing).metrics.missed_1px > 0.999, "{nothing}");
        }
        let half = of(mesh, "wireframe").metrics.width_mean_px / screen.metrics.width_mean_px;
        assert!((0.4..0.6).contains(&half), "{half}: front faces hide the inner half");
        assert!(of(mesh, "scale 0.95").ink_over_length_px > of(mesh, SCALE_99.label).ink_over_length_px);
        for lost in &mesh.lost {
            let [scaled, screen] = lost.inks.map(|ink| ink.false_share);
            assert!(scaled <= 0.0 && screen > 0.0, "scaling moves no sample, so that small faces cannot ink: {lost:?}");
        }
        assert!(mesh.lost.is_sorted_by(|coarse, fine| coarse.share >= fine.share), "{:?}", mesh.lost);
        assert!(mesh.times.variants_ms.iter().chain([&mesh.times.plain_ms]).all(|&ms| ms > 0.0));
    }

    /// Files of scanned, modelled and engineered meshes, all closed.
    const REAL: [&str; 6] =
        ["stanford-bunny.obj", "armadillo.obj", "rocker-arm.obj", "fandisk.obj", "spot.obj", "homer.obj"];

    #[test]
    fn screen_draws_the_true_lines_of_real_meshes() {
        use std::io::Write;
        let test = "screen_draws_the_true_lines_of_real_meshes";
        let Some(folder) = std::env::var_os("SILHOUETTES_MODELS") else {
            // Straight to stderr, so that the skip shows even though the test passes.
            writeln!(std::io::stderr(), "skipped {test}: SILHOUETTES_MODELS names no folder of meshes").unwrap();
            return;
        };
        let Some(gpu) = gpu_or_skip(test) else { return };
        for name in REAL {
            let path = std::path::Path::new(&folder).join(name);
            let mesh = Arc::new(PreparedMesh::new(silhouette_core::load::load(&path).unwrap()));
            let camera = framed(mesh.mesh(), [1024; 2]).unwrap();
            let mut scene = Scene::new(&mesh, camera, &NoProgress).unwrap();
            for samples in [1, 4] {
                let mut drawing = SCREEN.drawing(gpu, &mesh, style(camera.size(), samples), &NoProgress).unwrap();
                let Score { metrics, stray, .. } = scene.score(gpu, &mut drawing).unwrap();
                assert!(metrics.missed_1px <= 0.005 && metrics.gaps_per_1000px < 1e-12, "{name}: {metrics:?}");
                assert!(metrics.spurious_1px <= 0.01 && stray <= 0.01, "{name}: {stray} {metrics:?}");
                let steady = if samples == 4 { 0.25 } else { 0.4 };
                assert!(metrics.width_deviation_px <= steady, "{name}, {samples} samples: {metrics:?}");
            }
        }
    }
}
