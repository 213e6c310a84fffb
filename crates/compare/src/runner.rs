//! The comparison: methods x meshes x views.
//!
//! For each mesh:
//!
//! 1. the truth of every view, once for all methods;
//! 2. for each method, on a mesh that nothing was derived from yet: preparation, timed;
//! 3. a picture of every view, scored against the truth; edges found against edges to be found;
//! 4. frames along an animation path, timed after warm-up. Never before step 3: a cell says how right it is before it
//!    says how fast it is.

mod bench;

use crate::drawing::DrawError;
use crate::machine::RunDescription;
use crate::record::{Profile, Record};
use crate::registry::{self, Entry};
use crate::scaling::ExtractionRow;
use crate::truth::TruthError;
use bench::Bench;
use silhouette_core::method::{OptionValues, PrepareError};
use silhouette_core::view::{Framing, ViewError};
use silhouette_core::{Cancelled, PreparedMesh, Progress};
use silhouette_render::{Gpu, Image};
use silhouette_visibility::LineError;
use std::sync::Arc;

/// A method with the options it is compared with.
#[derive(Debug, Clone)]
pub struct MethodChoice {
    /// The method.
    pub entry: &'static Entry,
    /// Its options.
    pub options: OptionValues,
}

/// What is compared, and how thoroughly.
#[derive(Debug, Clone)]
pub struct CompareConfig {
    /// The methods, in the order in which they are reported.
    pub methods: Vec<MethodChoice>,
    /// How much is measured.
    pub profile: Profile,
    /// How views project.
    pub framing: Framing,
    /// Width in pixels of the pen that edges are drawn with, and of the true pen.
    pub pen_width_px: f64,
}

/// Default pen: wide enough that coverage, not aliasing, decides what is ink.
pub const DEFAULT_PEN_WIDTH_PX: f64 = 2.0;

impl CompareConfig {
    /// Every method with its default options, in perspective with a vertical field of view of 45 degrees.
    pub fn new(profile: Profile) -> Self {
        let choice =
            |entry: &'static Entry| MethodChoice { entry, options: OptionValues::defaults(entry.info.options) };
        Self {
            methods: registry::all().iter().map(choice).collect(),
            profile,
            framing: Framing::Perspective { fov_y_rad: 45.0_f64.to_radians() },
            pen_width_px: DEFAULT_PEN_WIDTH_PX,
        }
    }
}

/// A mesh to compare on.
#[derive(Debug, Clone)]
pub struct NamedMesh {
    /// Name in results and report, usually the path.
    pub name: String,
    /// The mesh.
    pub mesh: Arc<PreparedMesh>,
}

/// Why a comparison failed.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum CompareError {
    /// Nothing to compare.
    #[error("there is no {what} to compare")]
    Nothing {
        /// `"mesh"` or `"method"`.
        what: &'static str,
    },
    /// Two meshes have the same name, so their results could not be told apart.
    #[error("two meshes are named '{name}'")]
    SameName {
        /// The name.
        name: String,
    },
    /// A mesh has no triangle.
    #[error("{mesh}: the mesh has no triangle, so there is nothing to see")]
    EmptyMesh {
        /// Its name.
        mesh: String,
    },
    /// The views cannot be set up.
    #[error("{mesh}: {source}")]
    View {
        /// The mesh.
        mesh: String,
        /// What is wrong.
        source: ViewError,
    },
    /// The truth could not be found.
    #[error("{mesh}: {source}")]
    Truth {
        /// The mesh.
        mesh: String,
        /// What went wrong.
        source: TruthError,
    },
    /// A method could not be prepared or drawn.
    #[error("{mesh}, {method}: {source}")]
    Draw {
        /// The mesh.
        mesh: String,
        /// The method.
        method: &'static str,
        /// What went wrong.
        source: DrawError,
    },
    /// Stopped by the progress.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

impl CompareError {
    /// Names the mesh; a cancellation stays one, however deep it happened.
    fn truth(mesh: &str, source: TruthError) -> Self {
        match source {
            TruthError::Prepare(PrepareError::Cancelled(cancelled))
            | TruthError::Lines(LineError::Cancelled(cancelled)) => Self::Cancelled(cancelled),
            source => Self::Truth { mesh: mesh.to_owned(), source },
        }
    }

    /// Names mesh and method; a cancellation stays one, however deep it happened.
    fn draw(mesh: &str, method: &'static str, source: DrawError) -> Self {
        match source {
            DrawError::Prepare(PrepareError::Cancelled(cancelled)) => Self::Cancelled(cancelled),
            source => Self::Draw { mesh: mesh.to_owned(), method, source },
        }
    }
}

/// What a comparison found.
#[derive(Debug, Clone)]
pub struct Comparison {
    /// How much was measured.
    pub profile: Profile,
    /// Machine, adapter and program.
    pub run: RunDescription,
    /// The methods, in the order in which they are reported.
    pub methods: Vec<&'static Entry>,
    /// One record a mesh, method and view, in this order.
    pub records: Vec<Record>,
    /// One set of pictures a mesh and method, in this order.
    pub pictures: Vec<PictureSet>,
    /// What is missing: methods that refuse a mesh. Neither records nor pictures hold anything of them.
    pub left_out: Vec<LeftOut>,
    /// Extraction timings of other tools or other runs, for the report; [`run`] leaves it empty.
    pub peers: Vec<ExtractionRow>,
}

/// A method that a comparison leaves out on a mesh, because it is not defined for it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LeftOut {
    /// Name of the mesh.
    pub mesh: String,
    /// Name of the method.
    pub method: &'static str,
    /// Why, with the elements at fault.
    pub reason: String,
}

impl std::fmt::Display for LeftOut {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { mesh, method, reason } = self;
        write!(f, "{mesh}: {method} is left out: {reason}")
    }
}

/// Pictures of one view.
#[derive(Debug, Clone)]
pub struct PictureSet {
    /// Name of the mesh.
    pub mesh: String,
    /// Name of the method.
    pub method: String,
    /// Its options as `name=value` words.
    pub options: String,
    /// Number of the view.
    pub view: u32,
    /// What the method drew.
    pub drawn: Image,
    /// What was to be drawn.
    pub truth: Image,
    /// False colours, see [`picture::difference`](crate::picture::difference()).
    pub difference: Image,
}

/// Runs every method on every mesh. Takes a few seconds a mesh with [`Profile::Quick`] on two cores without a
/// graphics card; memory for one mesh at a time.
///
/// # Errors
/// [`CompareError`]; a failing method fails the comparison. One that is not defined for a mesh does not: it is listed as
/// [left out](Comparison::left_out).
pub fn run(
    config: &CompareConfig,
    meshes: &[NamedMesh],
    gpu: &Gpu,
    progress: &dyn Progress,
) -> Result<Comparison, CompareError> {
    check(config, meshes)?;
    let mut comparison = Comparison {
        profile: config.profile,
        run: RunDescription::of_this_process(gpu.adapter()),
        methods: config.methods.iter().map(|choice| choice.entry).collect(),
        records: Vec::new(),
        pictures: Vec::new(),
        left_out: Vec::new(),
        peers: Vec::new(),
    };
    for mesh in meshes {
        let mut bench = Bench::new(config, mesh, gpu, progress)?;
        for choice in &config.methods {
            bench.run_method(choice, &mut comparison)?;
        }
    }
    Ok(comparison)
}

fn check(config: &CompareConfig, meshes: &[NamedMesh]) -> Result<(), CompareError> {
    if config.methods.is_empty() {
        return Err(CompareError::Nothing { what: "method" });
    }
    if meshes.is_empty() {
        return Err(CompareError::Nothing { what: "mesh" });
    }
    let mut names: Vec<&str> = meshes.iter().map(|mesh| mesh.name.as_str()).collect();
    names.sort_unstable();
    if let Some(pair) = names.windows(2).find(|pair| pair[0] == pair[1]) {
        return Err(CompareError::SameName { name: pair[0].to_owned() });
    }
    match meshes.iter().find(|mesh| mesh.mesh.mesh().face_count() == 0) {
        Some(mesh) => Err(CompareError::EmptyMesh { mesh: mesh.name.clone() }),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::{NoProgress, TriangleMesh, shapes};
    use silhouette_render::testing::gpu_or_skip;

    fn named(name: &str, shape: &str) -> NamedMesh {
        NamedMesh { name: name.to_owned(), mesh: Arc::new(PreparedMesh::new(shapes::by_name(shape).unwrap())) }
    }

    #[test]
    fn what_cannot_be_compared_is_refused_before_anything_runs() {
        let config = CompareConfig::new(Profile::Quick);
        let torus = named("a", "torus");
        assert!(matches!(check(&config, &[]), Err(CompareError::Nothing { what: "mesh" })));
        assert!(matches!(check(&config, &[torus.clone(), torus.clone()]), Err(CompareError::SameName { .. })));
        let empty = Arc::new(PreparedMesh::new(TriangleMesh::new(vec![], vec![]).unwrap()));
        let empty = NamedMesh { name: "b".to_owned(), mesh: empty };
        assert!(
            matches!(check(&config, &[torus.clone(), empty]), Err(CompareError::EmptyMesh { mesh }) if mesh == "b")
        );
        let without = CompareConfig { methods: Vec::new(), ..config.clone() };
        assert!(matches!(check(&without, std::slice::from_ref(&torus)), Err(CompareError::Nothing { what: "method" })));
        assert!(check(&config, &[torus]).is_ok());
    }

    #[test]
    fn brute_force_scores_as_the_truth_that_it_is() {
        let Some(gpu) = gpu_or_skip("brute_force_scores_as_the_truth_that_it_is") else { return };
        let config = CompareConfig::new(Profile::Quick);
        let comparison = run(&config, &[named("torus", "torus")], gpu, &NoProgress).unwrap();
        assert_eq!(comparison.records.len(), config.methods.len() * config.profile.views() as usize);
        assert_eq!(comparison.pictures.len(), config.methods.len());
        for record in comparison.records.iter().filter(|record| record.method == registry::BASELINE) {
            let edges = record.edges.unwrap();
            assert!(edges.precision >= 1.0 && edges.recall >= 1.0 && edges.found == record.truth.silhouette_edges);
            let metrics = &record.metrics;
            assert!(record.truth.visible_length_px > 500.0, "{record:?}");
            assert!(metrics.missed_1px < 0.01 && metrics.spurious_1px < 0.01, "{metrics:?}");
            assert!(metrics.chamfer_px < 0.3 && metrics.hausdorff_95_px <= 1.0, "{metrics:?}");
            assert!((metrics.width_mean_px - config.pen_width_px).abs() < 0.25, "{metrics:?}");
            assert_eq!(record.frame.frames, config.profile.frames());
            assert!(record.frame.frame_ms.median > record.frame.extract_ms.unwrap().median);
        }
        // The same comparison finds the same pictures and scores: only times differ.
        let again = run(&config, &[named("torus", "torus")], gpu, &NoProgress).unwrap();
        let scores =
            |comparison: &Comparison| comparison.records.iter().map(|record| record.metrics).collect::<Vec<_>>();
        assert_eq!(scores(&comparison), scores(&again));
    }

    #[test]
    fn a_method_that_refuses_a_mesh_is_left_out_with_its_reason() {
        let Some(gpu) = gpu_or_skip("a_method_that_refuses_a_mesh_is_left_out_with_its_reason") else { return };
        let config = CompareConfig::new(Profile::Quick);
        let comparison = run(&config, &[named("one-sided", "moebius:12,2")], gpu, &NoProgress).unwrap();
        let left_out: Vec<_> = comparison.left_out.iter().map(|cell| (cell.mesh.as_str(), cell.method)).collect();
        assert_eq!(left_out, [("one-sided", "tracking"), ("one-sided", "tracking-exact")]);
        let note = comparison.left_out[0].to_string();
        assert!(note.starts_with("one-sided: tracking is left out: ") && note.contains("disagree"), "{note}");
        let others = config.methods.len() - left_out.len();
        assert_eq!((comparison.pictures.len(), comparison.records.len()), (others, others * 6));
        assert!(comparison.records.iter().all(|record| !record.method.starts_with("tracking")));
    }

    #[test]
    fn a_cancelled_comparison_stops() {
        struct CancelAlways;
        impl Progress for CancelAlways {
            fn stage(&self, _name: &str, _total: u64) {}
            fn advance(&self, _steps: u64) {}
            fn is_cancelled(&self) -> bool {
                true
            }
        }
        let Some(gpu) = gpu_or_skip("a_cancelled_comparison_stops") else { return };
        let config = CompareConfig::new(Profile::Quick);
        let stopped = run(&config, &[named("torus", "torus")], gpu, &CancelAlways);
        assert!(matches!(stopped, Err(CompareError::Cancelled(_))), "{stopped:?}");
    }
}
