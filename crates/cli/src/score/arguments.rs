//! What `score` is asked for.

use crate::camera::CameraArguments;
use crate::compare::arguments::ProfileArgument;
use crate::mesh_argument::MeshArgument;
use crate::winding::OrientArgument;
use clap::Args;
use clap::builder::NonEmptyStringValueParser;
use std::path::PathBuf;

/// Examples and forms, for `--help`.
pub const HELP: &str = "Examples:\n  \
    silhouettes score --scene mine.toml --cameras > cameras.json\n  \
    silhouettes score --scene mine.toml --lines 'theirs-{frame}.svg' -o out/theirs\n  \
    silhouettes score bunny.obj --profile quick --lines seven.png --frame 7\n  \
    silhouettes score bunny.obj --eye 0,0.1,0.4 --size 800x600 --lines bunny.svg\n  \
    silhouettes extract builtin:torus -o edges.json && silhouettes score builtin:torus --lines edges.json\n\n\
    The views are the scored frames of a scene, or one view by the camera options. --cameras prints their cameras as JSON: eye,\n\
    target, up, field of view, focal length, matrices. Frames are numbered as in the results of compare.\n\n\
    JSON: {\"edges\": [[a,b]...]}, pairs of vertices from 0; {\"polylines\": [[[x,y]...]...]} in pixels, origin at the top left, centres\n\
    of pixels at .5; or what extract and lines write. SVG: all strokes, of the view's shape. Lines are drawn with the scene's pen,\n\
    of edges the visible parts. PNG: judged as it is, of the view's size, dark lines on white or transparent ground.\n\n\
    DIR holds results.jsonl and results.csv in the columns of compare, times left empty, and pictures: drawn, truth, difference.\n\
    docs/score has examples for Blender's Line Art and Freestyle, and for a program that links to nothing.";

/// Arguments of `score`.
#[derive(Debug, Args)]
pub struct ScoreArguments {
    /// Mesh file or builtin:NAME [default: that of the scene]
    pub mesh: Option<MeshArgument>,
    /// Scene file (.toml) whose scored frames the files show
    #[arg(long, value_name = "FILE", conflicts_with = "profile")]
    pub scene: Option<PathBuf>,
    /// A built-in scene in its place
    #[arg(long, value_enum)]
    pub profile: Option<ProfileArgument>,
    /// What another program drew: .json, .svg or .png, one file per view; {frame} stands for the number of each
    #[arg(long, value_name = "FILE", required_unless_present = "cameras")]
    pub lines: Vec<PathBuf>,
    /// The number of the frame that a file shows; once for each file [default: all scored frames in order]
    #[arg(long, value_name = "N")]
    pub frame: Vec<u32>,
    /// Print the cameras of the views as JSON, and score nothing
    #[arg(long, conflicts_with_all = ["lines", "frame", "name"])]
    pub cameras: bool,
    /// What results call the other program [default: the name of the first file without its ending]
    #[arg(long, value_name = "NAME", value_parser = NonEmptyStringValueParser::new())]
    pub name: Option<String>,
    /// Width of the pen that lines are drawn with, in pixels [default: that of the scene, or 2]
    #[arg(long, value_name = "PX", value_parser = width)]
    pub width: Option<f64>,
    /// Folder for results and pictures; made, or replaced where it holds an earlier score. With --cameras: a file (.json)
    #[arg(short, long, value_name = "DIR")]
    pub output: Option<PathBuf>,
    /// Joins vertices no farther apart than this, in units of the mesh, as programs do for which seams are no lines; numbers of
    /// vertices are then those of the joined mesh [--weld alone: 0]
    #[arg(long, value_name = "DISTANCE", num_args = 0..=1, require_equals = true, default_missing_value = "0")]
    pub weld: Option<f32>,
    #[command(flatten)]
    pub orient: OrientArgument,
    #[command(flatten)]
    pub camera: CameraArguments,
}

fn width(text: &str) -> Result<f64, String> {
    let width = text.parse().ok().filter(|width: &f64| (0.1..=64.0).contains(width));
    width.ok_or_else(|| "expected a width of 0.1 to 64 pixels".to_owned())
}
