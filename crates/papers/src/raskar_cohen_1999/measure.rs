//! Every variant of every mesh: pictures scored, frames timed.

use super::derived;
use super::lost::{self, Lost, LostError};
use super::picture::{Score, score};
use super::soup::{self, SoupResult};
use super::spheres::{self, SphereViews};
use super::timed::{FrameTimes, Plain, time};
use super::variants::{UNORIENTED, VARIANTS, Variant};
use glam::DVec3;
use silhouette_compare::drawing::{DrawError, Drawing, FrameStyle};
use silhouette_compare::machine::{describe_machine, describe_program};
use silhouette_compare::metrics::{Ink, TruePen};
use silhouette_compare::record::Profile;
use silhouette_compare::registry::{self, UnknownMethod};
use silhouette_compare::runner::NamedMesh;
use silhouette_compare::truth::{TruthError, TruthFinder};
use silhouette_core::method::{OptionError, PrepareError};
use silhouette_core::shapes::{ShapeError, Sphere, by_name};
use silhouette_core::view::{Camera, Framing, ViewError, ViewPreset};
use silhouette_core::{PreparedMesh, Progress, TriangleMesh};
use silhouette_gpu::PenPlacement;
use silhouette_render::{Cull, Gpu};
use std::collections::HashMap;
use std::collections::hash_map::Entry;
use std::sync::Arc;

/// Why nothing was measured.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ReproduceError {
    /// A mesh has no triangle.
    #[error("{mesh}: the mesh has no triangle, so it has no silhouette")]
    EmptyMesh {
        /// Its name.
        mesh: String,
    },
    /// A picture could not be drawn.
    #[error("{mesh}: {source}")]
    Draw {
        /// The mesh.
        mesh: String,
        /// Why.
        source: DrawError,
    },
    /// The truth could not be found.
    #[error("{mesh}: {source}")]
    Truth {
        /// The mesh.
        mesh: String,
        /// Why.
        source: TruthError,
    },
    /// A built-in shape could not be made.
    #[error(transparent)]
    Shape(#[from] ShapeError),
    /// A camera could not be made.
    #[error(transparent)]
    View(#[from] ViewError),
    /// The registry lacks the method.
    #[error(transparent)]
    Method(#[from] UnknownMethod),
    /// A variant's options do not fit.
    #[error(transparent)]
    Option(#[from] OptionError),
}

/// What was measured, and where.
#[derive(Debug, Clone)]
pub struct Reproduction {
    /// How much was measured.
    pub profile: Profile,
    /// Adapter and driver.
    pub adapter: String,
    /// The machine in one line.
    pub machine: String,
    /// The program in one line.
    pub program: String,
    /// One a mesh: those named, and the spheres.
    pub meshes: Vec<MeshResult>,
    /// A soup of a million triangles, one a variant of [`UNORIENTED`]; empty for [`Profile::Quick`].
    pub soup: Vec<SoupResult>,
}

/// What was measured on one mesh.
#[derive(Debug, Clone)]
pub struct MeshResult {
    /// Its name.
    pub name: String,
    /// Its faces.
    pub faces: usize,
    /// Length of its visible lines in pixels, and how many pixels a side the picture has.
    pub visible_px: f64,
    /// Side of the picture in pixels.
    pub size_px: u32,
    /// Level of the icosphere that it is, for meshes beside whose widths predictions stand.
    pub sphere_level: Option<u32>,
    /// Frame times; `None` for spheres, which are not timed.
    pub times: Option<FrameTimes>,
    /// One a variant, in their order, one sample a pixel.
    pub variants: Vec<VariantResult>,
    /// The same with four samples a pixel, as the command line draws where nothing else is asked.
    pub smooth: Vec<VariantResult>,
    /// Front faces that pictures lose, one a size.
    pub lost: Vec<Lost>,
    /// What many views of a sphere show; `None` for other meshes.
    pub views: Option<SphereViews>,
    /// The soup of the same triangles with every other one turned, drawn by [`UNORIENTED`].
    pub shuffled: Vec<VariantResult>,
}

/// What was measured of one variant on one mesh.
#[derive(Debug, Clone, Copy)]
pub struct VariantResult {
    /// The variant.
    pub variant: Variant,
    /// Its picture's score.
    pub score: Score,
}

/// Rounds of timing.
fn rounds(profile: Profile) -> u32 {
    match profile {
        Profile::Quick => 9,
        Profile::Full => 15,
    }
}

/// Draws every variant of every mesh, and of icospheres of four levels. Half a minute a mesh of a hundred thousand faces
/// with [`Profile::Quick`] in software.
///
/// # Errors
/// [`ReproduceError`].
pub fn run(
    profile: Profile,
    meshes: &[NamedMesh],
    gpu: &Gpu,
    progress: &dyn Progress,
) -> Result<Reproduction, ReproduceError> {
    let mut results = measure_meshes(profile, meshes, gpu, progress)?;
    for (level, ..) in derived::FATTENED {
        let mesh = Arc::new(PreparedMesh::new(Sphere::default().icosphere(level)?));
        let camera = spheres::camera(DVec3::new(0.55, 0.35, 1.0))?;
        let name = format!("icosphere:{level}");
        results.push(measure_mesh(&name, &mesh, gpu, &camera, Some(level), 0, progress)?);
    }
    let soup = if profile == Profile::Full { measure_soup(gpu, profile.size(), progress)? } else { Vec::new() };
    Ok(Reproduction::new(profile, gpu, results, soup))
}

impl Reproduction {
    /// What was measured, with where.
    fn new(profile: Profile, gpu: &Gpu, meshes: Vec<MeshResult>, soup: Vec<SoupResult>) -> Self {
        let adapter = gpu.adapter().to_string();
        Self { profile, adapter, machine: describe_machine(), program: describe_program(), meshes, soup }
    }
}

fn measure_meshes(
    profile: Profile,
    meshes: &[NamedMesh],
    gpu: &Gpu,
    progress: &dyn Progress,
) -> Result<Vec<MeshResult>, ReproduceError> {
    let each = meshes.iter().map(|NamedMesh { name, mesh }| {
        let camera = framed(mesh.mesh(), name, profile.size())?;
        measure_mesh(name, mesh, gpu, &camera, None, rounds(profile), progress)
    });
    each.collect()
}

/// The view that meshes are drawn in.
fn framed(mesh: &TriangleMesh, name: &str, size: [u32; 2]) -> Result<Camera, ReproduceError> {
    let bounds = mesh.bounds().ok_or_else(|| ReproduceError::EmptyMesh { mesh: name.to_owned() })?;
    let (direction, up) = ViewPreset::default().directions();
    Ok(Camera::framing(&bounds, direction, up, Framing::Perspective { fov_y_rad: 0.7 }, size)?)
}

fn measure_soup(gpu: &Gpu, size: [u32; 2], progress: &dyn Progress) -> Result<Vec<SoupResult>, ReproduceError> {
    progress.stage("soup of a million triangles", UNORIENTED.len() as u64);
    let mesh = by_name(soup::MILLION)?;
    let camera = framed(&mesh, soup::MILLION, size)?;
    soup::measure(gpu, mesh, &camera, progress).map_err(|error| of_lost(soup::MILLION, error))
}

/// An error of a picture, with the mesh that it is of.
fn of_lost(mesh: &str, error: LostError) -> ReproduceError {
    match error {
        LostError::Draw(source) => ReproduceError::Draw { mesh: mesh.to_owned(), source },
        LostError::Option(error) => error.into(),
        LostError::Method(error) => error.into(),
        LostError::View(error) => error.into(),
    }
}

fn measure_mesh(
    name: &str,
    mesh: &Arc<PreparedMesh>,
    gpu: &Gpu,
    camera: &Camera,
    sphere_level: Option<u32>,
    rounds: u32,
    progress: &dyn Progress,
) -> Result<MeshResult, ReproduceError> {
    let draw_error = |source| ReproduceError::Draw { mesh: name.to_owned(), source };
    let truth_error = |source| ReproduceError::Truth { mesh: name.to_owned(), source };
    let style =
        FrameStyle { size: camera.size(), pen_width_px: silhouette_compare::runner::DEFAULT_PEN_WIDTH_PX, samples: 1 };
    progress.stage(&format!("{name}: pictures"), (1 + 2 * VARIANTS.len() + UNORIENTED.len()) as u64);
    let mut finder = TruthFinder::new(mesh, progress).map_err(truth_error)?;
    let truth = finder.find(camera, progress).map_err(truth_error)?;
    let all_lines = finder.lines_seen_or_not(camera, progress).map_err(truth_error)?;
    progress.advance(1);

    let entry = registry::find("image-precision")?;
    let drawing = |mesh: &Arc<PreparedMesh>, variant: &Variant, style| -> Result<Drawing, ReproduceError> {
        let prepared = entry.prepare(mesh, &variant.options()?, progress).map_err(|e| draw_error(e.into()))?;
        Drawing::new(gpu, mesh, prepared, style).map_err(draw_error)
    };
    let mut true_pens: HashMap<PenPlacement, Ink> = HashMap::new();
    let mut scored = |drawing: &mut Drawing, variant: Variant| -> Result<VariantResult, ReproduceError> {
        drawing.draw(gpu, camera).map_err(draw_error)?;
        let ink = Ink::from_picture(&drawing.picture(gpu).map_err(draw_error)?);
        let pen = drawing.pen();
        let picture = match true_pens.entry(pen.placement) {
            Entry::Occupied(drawn) => drawn.into_mut(),
            Entry::Vacant(wanted) => wanted.insert(truth.draw(pen)),
        };
        let pen = TruePen { picture, width_px: pen.width_px };
        progress.advance(1);
        Ok(VariantResult { variant, score: score(&ink, &truth.lines, &all_lines, pen) })
    };
    let mut drawings = VARIANTS.iter().map(|variant| drawing(mesh, variant, style)).collect::<Result<Vec<_>, _>>()?;
    let variants = drawings
        .iter_mut()
        .zip(VARIANTS)
        .map(|(drawing, variant)| scored(drawing, variant))
        .collect::<Result<Vec<_>, _>>()?;
    let four = FrameStyle { samples: 4, ..style };
    let smooth = VARIANTS
        .into_iter()
        .map(|variant| scored(&mut drawing(mesh, &variant, four)?, variant))
        .collect::<Result<Vec<_>, _>>()?;
    let soup = Arc::new(PreparedMesh::new(soup::turned_soup(mesh.mesh())));
    let shuffled = UNORIENTED
        .into_iter()
        .map(|variant| scored(&mut drawing(&soup, &variant, style)?, variant))
        .collect::<Result<Vec<_>, _>>()?;

    progress.stage(&format!("{name}: lost faces and views"), 1);
    let error_of = |error| of_lost(name, error);
    let lost = lost::measure(gpu, mesh, camera, progress).map_err(error_of)?;
    let views = sphere_level.map(|_| spheres::measure(gpu, name, mesh, progress)).transpose().map_err(error_of)?;
    progress.advance(1);

    let mut times = None;
    if rounds > 0 {
        progress.stage(&format!("{name}: time"), u64::from(rounds) + 1);
        let plain = [Cull::None, Cull::Back].map(|cull| Plain::new(gpu, mesh, style, cull));
        let [plain, culled] = plain;
        let plain = [&plain.map_err(draw_error)?, &culled.map_err(draw_error)?];
        times = Some(time(gpu, camera, plain, &mut drawings, rounds, progress).map_err(draw_error)?);
    }
    Ok(MeshResult {
        name: name.to_owned(),
        faces: mesh.mesh().face_count(),
        visible_px: truth.lines.total_length_px(),
        size_px: camera.size()[0],
        sphere_level,
        times,
        variants,
        smooth,
        lost,
        views,
        shuffled,
    })
}

impl ReproduceError {
    /// Whether the mesh is at fault, not the run.
    pub fn is_of_input(&self) -> bool {
        matches!(self, Self::EmptyMesh { .. } | Self::Draw { source: DrawError::Prepare(PrepareError::Mesh(_)), .. })
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use silhouette_core::NoProgress;
    use silhouette_core::shapes::by_name;
    use silhouette_render::testing::gpu_or_skip;

    fn blob() -> [NamedMesh; 1] {
        let mesh = Arc::new(PreparedMesh::new(by_name("blob:5672").unwrap()));
        [NamedMesh { name: "builtin:blob:5672".to_owned(), mesh }]
    }

    /// A reproduction of one mesh, without spheres; `None` where there is no adapter.
    pub fn of_one_mesh(test: &str) -> Option<Reproduction> {
        let gpu = gpu_or_skip(test)?;
        let meshes = measure_meshes(Profile::Quick, &blob(), gpu, &NoProgress).unwrap();
        Some(Reproduction::new(Profile::Quick, gpu, meshes, Vec::new()))
    }

    fn of<'a>(mesh: &'a MeshResult, label: &str) -> &'a Score {
        &mesh.variants.iter().find(|result| result.variant.label == label).unwrap().score
    }

    #[test]
    fn variants_draw_what_the_geometry_and_earlier_experiments_predict() {
        let Some(gpu) = gpu_or_skip("variants_draw_what_the_geometry_and_earlier_experiments_predict") else { return };
        let reproduction = run(Profile::Quick, &blob(), gpu, &NoProgress).unwrap();
        let spheres = reproduction.meshes.iter().filter_map(|mesh| Some((mesh.sphere_level?, mesh)));
        for (level, mesh) in spheres {
            let screen = of(mesh, "screen");
            assert!((1.95..2.1).contains(&screen.metrics.width_mean_px), "{level}: {screen:?}");
            assert!(screen.metrics.missed_1px + screen.stray + screen.metrics.gaps_per_1000px < 1e-12, "{screen:?}");
            for nothing in ["equal", "far plane closer"] {
                assert!(of(mesh, nothing).metrics.missed_1px > 0.999, "{nothing}");
            }
            let views = mesh.views.unwrap();
            let (_, mean, farthest) = derived::FATTENED.into_iter().find(|row| row.0 == level).unwrap();
            assert!((views.mean_width_px / mean - 1.0).abs() < 0.15, "{level}: {views:?}");
            let [least, most] = views.farthest_px;
            assert!(0.85 * least < farthest && farthest < 1.15 * most, "{level}: {views:?}");
        }
        let finest = reproduction.meshes.iter().find(|mesh| mesh.sphere_level == Some(5)).unwrap();
        let sphere = reproduction.meshes.iter().find(|mesh| mesh.sphere_level == Some(4)).unwrap();
        let (over_views, expected) = (sphere.views.unwrap().lost.unwrap(), derived::lost(&sphere.name).unwrap());
        for (at, expected) in expected.into_iter().enumerate() {
            let [mean, least, most] =
                [over_views.mean, over_views.least, over_views.most].map(|shares| 100.0 * shares[at]);
            assert!(0.85 * least < expected && expected < 1.15 * most, "{over_views:?}");
            // At 1024 pixels five of some 1700 faces are lost.
            assert!((mean / expected - 1.0).abs() < if at < 2 { 0.15 } else { 0.3 }, "{over_views:?}");
        }
        for (lost, expected) in sphere.lost.iter().zip(expected) {
            // In the usual view, whose field of view is narrower, fewer are lost at 256 pixels.
            let tolerance = if lost.size_px == 256 { 0.35 } else { 0.15 };
            assert!((100.0 * lost.share / expected - 1.0).abs() < tolerance, "{lost:?} {expected}");
            assert_eq!(lost.extra_px[0], 0, "scaling moves no sample");
        }
        let figures = super::super::rows::figures(&reproduction);
        let of_views = figures.iter().filter(|figure| figure.metric.ends_with("of views"));
        assert_eq!(of_views.count(), 4 * 3 + 3 * 3, "three of spikes a sphere, three of lost faces a size");
        assert!(figures.iter().all(|figure| figure.ours.is_none_or(f64::is_finite)));
        let scaled = of(finest, "scale 0.95").ink_over_length_px;
        assert!((scaled / derived::scaled_width_px(0.95) - 1.0).abs() < 0.15, "{scaled}");
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
        let entry = registry::find("image-precision").unwrap();
        for name in REAL {
            let path = std::path::Path::new(&folder).join(name);
            let mesh = Arc::new(PreparedMesh::new(silhouette_core::load::load(&path).unwrap()));
            let (direction, up) = ViewPreset::default().directions();
            let framing = Framing::Perspective { fov_y_rad: 0.7 };
            let bounds = mesh.mesh().bounds().unwrap();
            let camera = Camera::framing(&bounds, direction, up, framing, [1024; 2]).unwrap();
            let mut finder = TruthFinder::new(&mesh, &NoProgress).unwrap();
            let truth = finder.find(&camera, &NoProgress).unwrap();
            let all_lines = finder.lines_seen_or_not(&camera, &NoProgress).unwrap();
            for samples in [1, 4] {
                let prepared = entry.prepare(&mesh, &VARIANTS[0].options().unwrap(), &NoProgress).unwrap();
                let style = FrameStyle { size: camera.size(), pen_width_px: 2.0, samples };
                let mut drawing = Drawing::new(gpu, &mesh, prepared, style).unwrap();
                drawing.draw(gpu, &camera).unwrap();
                let ink = Ink::from_picture(&drawing.picture(gpu).unwrap());
                let pen = drawing.pen();
                let picture = truth.draw(pen);
                let pen = TruePen { picture: &picture, width_px: pen.width_px };
                let Score { metrics, stray, .. } = score(&ink, &truth.lines, &all_lines, pen);
                assert!(metrics.missed_1px <= 0.005 && metrics.gaps_per_1000px < 1e-12, "{name}: {metrics:?}");
                assert!(metrics.spurious_1px <= 0.01 && stray <= 0.01, "{name}: {stray} {metrics:?}");
                let steady = if samples == 4 { 0.25 } else { 0.4 };
                assert!(metrics.width_deviation_px <= steady, "{name}, {samples} samples: {metrics:?}");
            }
        }
    }

    #[test]
    fn a_soup_of_turned_triangles_is_still_drawn() {
        let Some(reproduction) = of_one_mesh("a_soup_of_turned_triangles_is_still_drawn") else { return };
        let mesh = &reproduction.meshes[0];
        let (soup, scaled) = (mesh.shuffled[0].score, of(mesh, "scale 0.99"));
        assert!((soup.ink_over_length_px / scaled.ink_over_length_px - 1.0).abs() < 0.3, "{soup:?} {scaled:?}");
    }
}
