//! Arguments of `silhouettes compare`.

use crate::camera::UpAxisArgument;
use crate::mesh_argument::MeshArgument;
use crate::winding::OrientArgument;
use clap::{Args, ValueEnum};
use silhouette_compare::Profile;
use silhouette_compare::metrics::table::{self, Better, METRICS, MetricSpec};
use silhouette_compare::sweep::Shard;
use std::num::NonZeroUsize;
use std::path::PathBuf;
use std::str::FromStr;
use std::time::Duration;

/// How much a comparison measures.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum ProfileArgument {
    /// Small pictures, part of a turn: about a minute per mesh, even in software
    Quick,
    /// Large pictures, a whole turn
    Full,
}

impl From<ProfileArgument> for Profile {
    fn from(argument: ProfileArgument) -> Self {
        match argument {
            ProfileArgument::Quick => Self::Quick,
            ProfileArgument::Full => Self::Full,
        }
    }
}

/// Arguments of `compare`.
#[derive(Debug, Args)]
pub struct CompareArguments {
    /// Mesh files or builtin:NAME [default: those of the scene]
    pub meshes: Vec<MeshArgument>,
    /// Scene file (.toml) instead of a profile
    #[arg(long, value_name = "FILE", conflicts_with = "profile")]
    pub scene: Option<PathBuf>,
    /// How much to measure: a built-in scene
    #[arg(long, value_enum, default_value_t = ProfileArgument::Quick)]
    pub profile: ProfileArgument,
    /// Names of the methods, separated by commas [default: those of the scene, or all]
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    pub methods: Vec<String>,
    /// An option of a method; several values make one cell each, several options multiply
    #[arg(long, value_name = "METHOD.OPTION=VALUE[,VALUE...]")]
    pub set: Vec<String>,
    /// Add cells for N values of an option, 5 where no number is given, spread over those that it declares worth comparing; may be
    /// given several times
    #[arg(long, value_name = "METHOD.OPTION[=N]")]
    pub sweep: Vec<String>,
    /// Go on measuring values of swept options for about so many seconds, where the front of time and error is coarse
    #[arg(long, value_name = "SECONDS", value_parser = seconds, conflicts_with = "shard")]
    pub budget: Option<Duration>,
    /// With --budget: the error of the front, by its name in results.csv [default: chamfer_px for lines, boundary_chamfer_px
    /// for fills]
    #[arg(long, value_name = "METRIC", requires = "budget", value_parser = error_metric)]
    pub error: Option<&'static MetricSpec>,
    /// How often the camera's path is followed, all methods in turn, for times of moments that lie apart [default: that of the
    /// scene, or once]
    #[arg(long, value_name = "N")]
    pub passes: Option<u32>,
    /// The axis that the camera's path is around, and that points up [default: that of the scene]
    #[arg(long, value_enum, value_name = "AXIS")]
    pub up_axis: Option<UpAxisArgument>,
    #[command(flatten)]
    pub orient: OrientArgument,
    /// Draw each mesh simplified to at most N faces, and measure filled pictures against all of it
    #[arg(long, value_name = "N")]
    pub simplify: Option<NonZeroUsize>,
    /// Extraction timings of other tools for the report, as benches/peers writes them; may be given several times
    #[arg(long, value_name = "FILE.jsonl")]
    pub peers: Vec<PathBuf>,
    /// Measure only the I-th of N shares of the cells, to be merged with the others [default: that of a Slurm job array, or all]
    #[arg(long, value_name = "I/N", value_parser = Shard::from_str, conflicts_with = "peers")]
    pub shard: Option<Shard>,
    /// Folder for the report; made, or replaced where it holds an earlier report. With --shard: for the finished cells
    #[arg(short, long, value_name = "DIR")]
    pub output: PathBuf,
}

/// A time, as seconds.
fn seconds(text: &str) -> Result<Duration, String> {
    let seconds = text.parse().ok().filter(|seconds: &f64| *seconds > 0.0);
    seconds
        .and_then(|seconds| Duration::try_from_secs_f64(seconds).ok())
        .ok_or_else(|| "expected seconds above 0".to_owned())
}

/// A metric that can be better or worse.
fn error_metric(text: &str) -> Result<&'static MetricSpec, String> {
    let has_direction = |metric: &&MetricSpec| metric.better != Better::NearPenWidth;
    table::find(text).filter(has_direction).ok_or_else(|| {
        let names: Vec<&str> = METRICS.iter().filter(has_direction).map(|metric| metric.name).collect();
        format!("expected one of {}", names.join(", "))
    })
}
