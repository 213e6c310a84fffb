//! `silhouettes recommend`: the fastest method that keeps to an error and a time on a mesh, by measurements on it.

use crate::camera::{UpAxisArgument, size};
use crate::failure::{self, Failure};
use crate::input;
use crate::mesh_argument::MeshArgument;
use crate::output::Output;
use crate::progress::TerminalProgress;
use crate::render::open_device;
use crate::winding::OrientArgument;
use clap::{Args, ValueEnum};
use serde::Serialize;
use silhouette_compare::recommend::check::MAX_VIEWS;
use silhouette_compare::recommend::text::text;
use silhouette_compare::recommend::{
    Cache, CacheKey, Candidate, Check, ErrorLimit, Goal, LoopMeter, Measurer, Meter, Notebook, PictureMeter,
    Recommendation, Request, SECONDS, Setting, candidates, check, recommend,
};
use silhouette_compare::runner::NamedMesh;
use silhouette_compare::{Profile, Registry};
use silhouette_core::Progress;
use silhouette_render::Gpu;

/// Seconds that a calibration may be given.
const SECONDS_RANGE: std::ops::RangeInclusive<f64> = 0.1..=86_400.0;

/// Arguments of `recommend`.
#[derive(Debug, Args)]
pub struct RecommendArguments {
    /// Mesh file or builtin:NAME
    pub mesh: MeshArgument,
    /// What the method is for
    #[arg(long, value_enum, default_value_t = GoalArgument::Lines)]
    pub goal: GoalArgument,
    /// The largest error, by the name of a metric of docs/METRICS.md that is better the lower it is, or without a name for that of
    /// the goal [default: chamfer_px=0.5 for lines, boundary_chamfer_px=0.5 for fill, differing_edges=0 for loops]
    #[arg(long, value_name = "[NAME=]MAX")]
    pub error: Option<String>,
    /// The longest time in milliseconds: of a whole frame for lines and fill, of an extraction for loops [default: any]
    #[arg(long, value_name = "MS", value_parser = milliseconds)]
    pub max_ms: Option<f64>,
    /// How long measuring may take
    #[arg(long, value_name = "SECONDS", default_value_t = SECONDS, value_parser = seconds)]
    pub seconds: f64,
    /// Size of the pictures in pixels, or the side of square ones; 16 to 4096 each way
    #[arg(long, value_name = "WxH", default_value = "512x512", value_parser = size)]
    pub size: [u32; 2],
    /// The axis that points up in every view
    #[arg(long, value_enum, value_name = "AXIS", default_value_t = UpAxisArgument::Y)]
    pub up_axis: UpAxisArgument,
    #[command(flatten)]
    pub orient: OrientArgument,
    /// Check the promise in N more views, however long that takes
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=i64::from(MAX_VIEWS)))]
    pub check: Option<u32>,
    /// Measure everything anew and keep nothing
    #[arg(long)]
    pub no_cache: bool,
    /// Everything as JSON, each candidate with its figures
    #[arg(long)]
    pub json: bool,
}

/// What the method is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum GoalArgument {
    /// Visible silhouette lines
    Lines,
    /// The filled image
    Fill,
    /// Closed loops of silhouette edges, visible or not; needs no graphics device
    Loops,
}

impl From<GoalArgument> for Goal {
    fn from(argument: GoalArgument) -> Self {
        match argument {
            GoalArgument::Lines => Self::Lines,
            GoalArgument::Fill => Self::Fill,
            GoalArgument::Loops => Self::Loops,
        }
    }
}

#[derive(Serialize)]
struct Document<'a> {
    mesh: &'a str,
    #[serde(flatten)]
    recommendation: &'a Recommendation,
    check: Option<Check>,
}

/// Runs the command.
pub fn run(arguments: &RecommendArguments, registry: &Registry) -> Result<(), Failure> {
    // Report a mistake before reading a large mesh.
    request(arguments)?;
    setting(arguments)?;
    let progress = TerminalProgress::new();
    // Loops are the same for a mesh that is inside out.
    let winding = arguments.orient.winding(arguments.needs_device());
    let named = input::mesh(&arguments.mesh, winding, &progress)?;
    let gpu = arguments.needs_device().then(open_device).transpose()?;
    let (recommendation, check) = answer(arguments, &named, gpu.as_ref(), registry, &progress)?;
    print(arguments.json, &named, &recommendation, check)
}

impl RecommendArguments {
    /// Whether pictures are measured, so that a device is wanted.
    pub fn needs_device(&self) -> bool {
        Goal::from(self.goal).picture().is_some()
    }
}

/// The answer for a mesh, and what its check found; notes are printed. `gpu` is there where [one is
/// wanted](RecommendArguments::needs_device).
///
/// # Errors
/// [`Failure`]: an argument or the mesh does not fit, or the run failed.
pub fn answer(
    arguments: &RecommendArguments,
    named: &NamedMesh,
    gpu: Option<&Gpu>,
    registry: &Registry,
    progress: &dyn Progress,
) -> Result<(Recommendation, Option<Check>), Failure> {
    let request = request(arguments)?;
    let setting = setting(arguments)?;
    let candidates = candidates(request.goal, registry);
    if candidates.is_empty() {
        return Err(Failure::Input(format!("--goal {}: no method of this program yields any", request.goal.name())));
    }
    let cache = if arguments.no_cache { None } else { Cache::of_user(|name| std::env::var_os(name)) };
    let key = CacheKey::new(named, request.goal, &setting, gpu);
    let known = cache.as_ref().map_or_else(|| Ok(Notebook::default()), |cache| cache.load(&key));
    let known = known.unwrap_or_else(|damaged| {
        failure::note(damaged);
        Notebook::default()
    });
    let mut notebook = known.arranged(&candidates);
    let task = Task { request: &request, candidates: &candidates, views: arguments.check };
    let answered = match gpu {
        None => {
            let mut meter = LoopMeter::new(named, &candidates, setting, progress).map_err(Failure::of_comparison)?;
            task.answer(&mut meter, &mut notebook)
        }
        Some(gpu) => {
            let meter = PictureMeter::new(named, request.goal, &candidates, setting, gpu, progress);
            let Some(mut meter) = meter.map_err(Failure::of_comparison)? else {
                unreachable!("goals with pictures have a meter")
            };
            task.answer(&mut meter, &mut notebook)
        }
    };
    let (recommendation, check) = answered?;
    if arguments.check.is_some() && check.is_none() {
        failure::note("--check: there is no promise to check");
    }
    if let Some(cache) = cache.filter(|_| recommendation.views_measured > 0)
        && let Err(error) = cache.store(&key, &notebook)
    {
        failure::note(format_args!("{}: the measurements are not kept: {error}", cache.folder().display()));
    }
    Ok((recommendation, check))
}

fn print(json: bool, named: &NamedMesh, recommendation: &Recommendation, check: Option<Check>) -> Result<(), Failure> {
    let answer = if json {
        let document = Document { mesh: &named.name, recommendation, check };
        serde_json::to_string_pretty(&document).map_err(Failure::run)? + "\n"
    } else {
        text(recommendation, &named.name, check.as_ref())
    };
    Output::Stdout.write(answer.as_bytes())
}

/// What is measured, whatever measures it.
struct Task<'a> {
    request: &'a Request,
    candidates: &'a [Candidate],
    views: Option<u32>,
}

impl Task<'_> {
    fn answer<M: Meter>(
        &self,
        meter: &mut M,
        notebook: &mut Notebook,
    ) -> Result<(Recommendation, Option<Check>), Failure> {
        let mut measurer = Measurer::new(meter, notebook);
        let recommendation = recommend(&mut measurer, self.request, self.candidates).map_err(Failure::of_comparison)?;
        let check = match self.views {
            Some(views) => check(&mut measurer, &recommendation, views).map_err(Failure::of_comparison)?,
            None => None,
        };
        Ok((recommendation, check))
    }
}

fn request(arguments: &RecommendArguments) -> Result<Request, Failure> {
    let goal = Goal::from(arguments.goal);
    let limit = match &arguments.error {
        Some(text) => ErrorLimit::parse(goal, text),
        None => Ok(goal.default_limit()),
    };
    let request = limit.and_then(|limit| Request::limited(goal, limit));
    let request = request.map_err(|fault| Failure::Input(format!("--error: {fault}")))?;
    Ok(Request { max_ms: arguments.max_ms, seconds: arguments.seconds, ..request })
}

/// Views as those of the profile `quick`, but from all around.
fn setting(arguments: &RecommendArguments) -> Result<Setting, Failure> {
    let mut scene = Profile::Quick.scene();
    [scene.picture.width, scene.picture.height] = arguments.size;
    scene.path.up_axis = arguments.up_axis.into();
    scene.check().map_err(|fault| Failure::Input(format!("--size: {fault}")))?;
    Ok(Setting::from(&scene))
}

fn milliseconds(text: &str) -> Result<f64, String> {
    let ms = text.parse().ok().filter(|ms: &f64| ms.is_finite() && *ms > 0.0);
    ms.ok_or_else(|| "expected milliseconds, above 0".to_owned())
}

fn seconds(text: &str) -> Result<f64, String> {
    let seconds = text.parse().ok().filter(|seconds: &f64| SECONDS_RANGE.contains(seconds));
    seconds.ok_or_else(|| format!("expected {} to {} seconds", SECONDS_RANGE.start(), SECONDS_RANGE.end()))
}
