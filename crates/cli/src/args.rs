//! The command line, as clap reads it.

use crate::camera::CameraArguments;
use crate::compare::arguments::{CompareArguments, ProfileArgument};
use crate::lines::LinesArguments;
use crate::mesh_argument::MeshArgument;
use crate::recommend::{GoalArgument, RecommendArguments};
use crate::score::{self, ScoreArguments};
use crate::winding::OrientArgument;
use clap::builder::{PossibleValue, PossibleValuesParser};
use clap::{Args, Parser, Subcommand};
use silhouette_core::method::Source;
use silhouette_papers::Paper;
use std::path::PathBuf;

/// Find, draw and compare the silhouettes of triangle meshes.
///
/// MESH is a file (.obj .ply .off .stl .gltf .glb), - for standard input, or builtin:NAME, for example builtin:torus or
/// builtin:blob:100000.
#[derive(Debug, Parser)]
#[command(name = "silhouettes", version, subcommand_required = true, arg_required_else_help = true)]
pub struct Arguments {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
    /// Refuse files of meshes with more bytes than this, with all that they name; memory stays within 300 bytes per byte
    #[arg(long, global = true, value_name = "BYTES")]
    pub limit_bytes: Option<u64>,
}

/// The commands.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Say which adapter draws, what runs where, and the remedy where nothing does
    #[command(after_help = "Examples:\n  silhouettes doctor\n  SILHOUETTES_ADAPTER=software silhouettes doctor")]
    Doctor,
    /// Say what each method yields, needs, costs and misses, when to choose it, and which options it has
    #[command(
        after_help = "Examples:\n  silhouettes methods\n  silhouettes methods tracking\n  silhouettes methods --json"
    )]
    Methods(MethodsArguments),
    /// Count and check a mesh: components, genus, boundary loops and every defect with its ids
    #[command(after_help = "Examples:\n  silhouettes inspect bunny.obj\n  silhouettes inspect builtin:moebius --json")]
    Inspect(InspectArguments),
    /// Find silhouette edges, loops and smooth curves; write JSON, SVG or OBJ, or the edges of every view as GLB
    #[command(after_help = "Examples:\n  \
        silhouettes extract bunny.obj --eye 0,0.1,1\n  \
        silhouettes extract builtin:torus --view iso -o torus.svg\n  \
        silhouettes extract part.stl --ortho fit --view front -o outline.obj\n  \
        silhouettes extract coarse.obj --method smoothing -o smooth.svg\n  \
        silhouettes extract part.stl --creases 30 -o part.glb\n\n\
        JSON: {\"method\", \"mesh\": {\"vertices\", \"triangles\"}, \"viewpoint\", \"edges\": [[a,b]...], \"boundary\": [[a,b]...],\n\
        \"loops\": [[v...]...], \"stats\"}. Edges have a < b and are sorted; \"edges\" holds all silhouette edges, \"boundary\"\n\
        those among them that have one face only. Loops run with the front face on the left. A method with curves adds\n\
        \"curves\": [{\"closed\", \"pieces\": [{\"kind\": \"silhouette\"|\"boundary\"|\"crease\", \"source\": {\"face\": n} or\n\
        {\"edge\": [a,b]}, \"control\": [[x,y,z] x 4]}...]}...], cubic Bezier curves in the coordinates of the mesh; one without\n\
        edges leaves out \"edges\", \"boundary\" and \"loops\". Curves, where there are any, are what SVG and OBJ hold: SVG as\n\
        cubics within 0.05 pixels, OBJ as polylines within a ten-thousandth of the mesh's extent.\n\
        GLB: the mesh with the extension EXT_mesh_primitive_edge_visibility, for viewers that draw its edges themselves, in any\n\
        view: hard edges always, smooth ones where they are silhouettes. Hard are boundaries, edges that do not join two\n\
        consistently wound faces, edges that the mesh's file calls sharp, and creases. It is read back as a mesh with sharp\n\
        edges. docs/formats/glb-edges.md describes it.")]
    Extract(ExtractArguments),
    /// Draw visible lines, hidden ones removed, as SVG for plotters, PDF, DXF or HP-GL; also JSON and glTF
    #[command(after_help = "Examples:\n  \
        silhouettes lines bunny.obj -o bunny.svg\n  \
        silhouettes lines part.stl --creases 30 --hidden --page a3 --landscape --width 0.3mm -o part.svg\n  \
        silhouettes lines part.stl --ortho fit --view front --scale 1 -o part-1-to-1.svg\n  \
        silhouettes lines house.obj tree.obj --units px --size 1600x900 --stats -o scene.svg\n  \
        silhouettes lines part.stl --hidden -o part.json\n  \
        silhouettes lines coarse.obj --smooth -o smooth.svg\n  \
        silhouettes lines part.stl --ortho fit --view front --creases 30 -o part.dxf\n  \
        silhouettes lines part.stl --section 0,0,5,0,0,1 --view iso --creases 30 --fill '#eee' -o open.pdf\n\n\
        Kinds: section, silhouette, boundary, ridge, valley, material, intersection, curve (with --smooth), mesh; for pens also outline.\n\
        An edge of several kinds has the first of them. SVG: one Inkscape layer per kind, visible and hidden apart; PDF: an optional\n\
        content group; DXF (of AutoCAD 2004, in millimetres, y up): a layer such as silhouette-visible; HP-GL: a pen, numbered from 1.\n\
        SVG, PDF and DXF hold curves, HP-GL chords within 1/80 mm.\n\
        JSON: {\"camera\", \"size\", \"page\", \"chains\": [{\"kind\", \"visible\", \"invisibility\", \"object\", \"closed\",\n\
        \"edges\": [[a,b]...], \"points\": [[x,y,z]...], \"pixels\": [[x,y]...]}...], \"outline\"}.\n\
        Chains along smooth curves have no edges but \"curves\", a number for each piece of curve, and \"handles\".")]
    Lines(Box<LinesArguments>),
    /// Draw the lines of one method, or the surface that it fills, to a PNG
    #[command(after_help = "Examples:\n  \
        silhouettes render bunny.obj --method brute-force -o bunny.png\n  \
        silhouettes render bunny.obj --method image-precision --set variant=scale --set scale=0.97 -o bunny.png\n  \
        silhouettes render builtin:knot --view iso --size 512x512 --width 2 -o knot.png\n  \
        silhouettes render bunny.obj --method image-precision --transparent -o lines.png\n  \
        silhouettes render house.obj tree.obj --method edge-mesh -o scene.png\n  \
        silhouettes render bunny.obj --method fine-mesh -o surface.png\n  \
        silhouettes render bunny.siltex --method texture -o bunny.png")]
    Render(RenderArguments),
    /// Smooth the outline of a coarse mesh in one view: its triangles as an OBJ, or its picture as a PNG
    #[command(after_help = "Examples:\n  \
        silhouettes smooth coarse.obj -o smooth.png\n  \
        silhouettes smooth builtin:icosphere:1 --view iso --set tolerance=0.25 -o smooth.obj\n  \
        silhouettes smooth coarse.obj --set crease=40 --ortho fit --view front -o smooth.obj\n\n\
        An OBJ holds the triangles that stand for the mesh in this view, in its own coordinates: positions once each (v), a\n\
        normal per corner (vn), so that the surface is closed where the mesh is. A PNG is the picture that `render` draws. On\n\
        stderr: triangles before and after, and of methods with curves also silhouette triangles and curves.")]
    Smooth(SmoothArguments),
    /// Bake a silhouette texture: a coarse hull that is drawn with the outlines of the mesh
    #[command(after_help = "Examples:\n  \
        silhouettes bake bunny.obj -o bunny.siltex\n  \
        silhouettes bake bunny.obj --set size=512 --set hull-vertices=1000 -o bunny.siltex\n  \
        silhouettes bake builtin:torus --set size=128 --set terms=16 -o torus.siltex\n  \
        silhouettes bake bunny.obj --hull cage.obj -o bunny.siltex\n\n\
        Options are those of the method texture, which `silhouettes methods texture` lists. A bake that was interrupted goes on where it was\n\
        when the same command is given again: what is finished lies in FILE.checkpoint, which is removed at the end. The file is\n\
        drawn by `silhouettes render FILE --method texture`, `texture-lines` or `normal-map-hull`; docs/formats/siltex.md describes it.")]
    Bake(BakeArguments),
    /// Compare methods on meshes: pictures, speed, accuracy, a report that opens offline
    #[command(after_help = "Examples:\n  \
        silhouettes compare bunny.obj -o out/bunny\n  \
        silhouettes compare bunny.obj fandisk.obj --methods brute-force,image-precision --profile quick -o out/two\n  \
        silhouettes compare bunny.obj --methods brute-force,tracking --set tracking.concavity=0,0.5,1 -o out/sweep\n  \
        silhouettes compare bunny.obj --methods brute-force,tracking --sweep tracking.concavity --budget 30 -o out/front\n  \
        silhouettes compare --scene crates/compare/scenes/quick.toml -o out/scene\n  \
        silhouettes compare bunny.obj --simplify 500 -o out/coarse\n  \
        silhouettes compare bunny.obj --peers vtk.jsonl --peers numpy.jsonl -o out/peers\n  \
        silhouettes compare -o out/builtin\n\n\
        A scene is a TOML file with meshes, camera path, picture, pen and methods; crates/compare/scenes/quick.toml explains each key. Paths\n\
        in it are relative to its folder. Times and accuracy are of the same frames: of the timed frames some are scored.\n\
        A simplified mesh keeps its components, holes and handles. Where N faces are too few for that, it is refused with the\n\
        number that can be reached.\n\n\
        Each sweep varies one option about the scene's cells, so several add up, where lists of --set multiply. With --budget the value\n\
        in the middle of the widest gap of the front is measured next, on all meshes, until the front is fine or the time is up.\n\n\
        Finished cells are kept beside the report until it is written: a comparison that was interrupted goes on where it was when\n\
        the same command is given again. Shards of one comparison may share a folder; `silhouettes merge` makes the report.")]
    Compare(CompareArguments),
    /// Make one report of the cells that several processes measured
    #[command(after_help = "Examples:\n  \
        silhouettes compare bunny.obj --shard 1/2 -o out/cells\n  \
        silhouettes compare bunny.obj --shard 2/2 -o out/cells\n  \
        silhouettes merge out/cells -o out/bunny\n\n\
        The folders must hold every cell of one comparison: same program, meshes, methods and scene. Pictures are worth the same\n\
        whichever process drew them; times of different machines stand in charts of their own. docs/sweeps has examples for GNU\n\
        parallel, HyperQueue and Slurm.")]
    Merge(MergeArguments),
    /// Score what another program drew against the truth of a scene: edge lists, line SVG, pictures
    #[command(after_help = score::HELP)]
    Score(Box<ScoreArguments>),
    /// Say which method to use on a mesh: the fastest within an error and a time, by measurements on it
    #[command(after_help = "Examples:\n  \
        silhouettes recommend bunny.obj\n  \
        silhouettes recommend bunny.obj --goal lines --error missed_1px=0.02 --max-ms 16.6\n  \
        silhouettes recommend coarse.obj --goal fill --size 1920x1080 --json\n  \
        silhouettes recommend builtin:knot --goal loops --check 200\n\n\
        Measured are views from all around, in at most 20 seconds: all methods in few of them, the best ones in as many as a promise\n\
        takes. The promise, that 95 % of views keep to the error and the time, rests on counting views that were drawn after the\n\
        choice; docs/METRICS.md defines it, --check tries it. Times are those of this machine as busy as it is. Measurements are kept\n\
        in the user's cache (silhouettes/recommend in XDG_CACHE_HOME or ~/.cache), so that other limits are answered at once. Exit code\n\
        0 also where no method keeps to the limits: the answer then says what comes closest.")]
    Recommend(RecommendArguments),
    /// Measure what a paper printed, and set both side by side: tables, charts, a page that opens offline
    #[command(after_help = "Examples:\n  \
        silhouettes reproduce tracking stanford-bunny.obj -o out/tracking\n  \
        silhouettes reproduce tracking stanford-bunny.obj armadillo.obj cow.obj --profile full -o out/tracking\n  \
        silhouettes reproduce image-precision -o out/image-precision\n  \
        silhouettes reproduce smoothing -o out/smoothing\n  \
        silhouettes reproduce smoothing knot.off bear.off stanford-bunny.obj -o out/smoothing\n  \
        silhouettes reproduce all -o out/papers\n\n\
        The models of the papers are not part of this program. Without a mesh built-in shapes are measured: for\n\
        tracking no value then stands beside the paper's, whose bunny is recognised by its 69451 faces; for image-precision\n\
        they are as large as the paper's models; for smoothing they have as many faces, and files of more than 600 faces are\n\
        measured simplified and in full. Values are compared only where model and hardware allow it; elsewhere the\n\
        tables say why not. With all, each paper is written to a folder of its own.")]
    Reproduce(ReproduceArguments),
}

impl Command {
    /// Whether a device may be opened to run it.
    pub fn may_open_device(&self) -> bool {
        match self {
            Self::Doctor | Self::Render(_) | Self::Smooth(_) | Self::Compare(_) | Self::Reproduce(_) => true,
            Self::Lines(arguments) => arguments.quick,
            Self::Recommend(arguments) => arguments.goal != GoalArgument::Loops,
            Self::Methods(_)
            | Self::Inspect(_)
            | Self::Extract(_)
            | Self::Bake(_)
            | Self::Merge(_)
            | Self::Score(_) => false,
        }
    }
}

/// Arguments of `methods`.
#[derive(Debug, Args)]
pub struct MethodsArguments {
    /// Name of a method, of which all is said [default: each in short]
    pub method: Option<String>,
    /// All that is known as JSON, an array of methods
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `inspect`.
#[derive(Debug, Args)]
pub struct InspectArguments {
    /// Mesh file or builtin:NAME
    pub mesh: MeshArgument,
    /// Everything as JSON, each defect with all of its ids
    #[arg(long)]
    pub json: bool,
}

/// Which method, and how.
#[derive(Debug, Clone, Args)]
pub struct MethodArguments {
    /// Name of the method
    #[arg(long, value_name = "NAME", default_value = Self::DEFAULT)]
    pub method: String,
    /// An option of the method; may be given several times
    #[arg(long, value_name = "NAME=VALUE")]
    pub set: Vec<String>,
}

impl MethodArguments {
    /// The method where none is named.
    pub const DEFAULT: &str = "brute-force";
}

/// Arguments of `extract`.
#[derive(Debug, Args)]
pub struct ExtractArguments {
    /// Mesh file or builtin:NAME
    pub mesh: MeshArgument,
    #[command(flatten)]
    pub method: MethodArguments,
    /// Joins vertices no farther apart than this, in units of the mesh, so that seams are no boundaries; numbers of vertices are
    /// then those of the joined mesh [--weld alone: 0]
    #[arg(long, value_name = "DISTANCE", num_args = 0..=1, require_equals = true, default_missing_value = "0")]
    pub weld: Option<f32>,
    /// GLB: edges whose faces bend by at least this angle are hard [default: 75]
    #[arg(long, value_name = "DEG", value_parser = bend)]
    pub creases: Option<f64>,
    /// Output file: .json, .svg, .obj or .glb [default: JSON on standard output]
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    #[command(flatten)]
    pub orient: OrientArgument,
    #[command(flatten)]
    pub camera: CameraArguments,
}

/// Arguments of `render`.
#[derive(Debug, Args)]
pub struct RenderArguments {
    /// Mesh files or builtin:NAME; several are drawn together, in one space, and hide each other; for the methods of silhouette
    /// textures also one .siltex file
    #[arg(required = true, value_name = "MESH")]
    pub meshes: Vec<MeshArgument>,
    #[command(flatten)]
    pub method: MethodArguments,
    /// Width of the pen in pixels
    #[arg(long, value_name = "PX", default_value_t = 1.5)]
    pub width: f64,
    /// Samples per pixel: 1, or 4 for smooth lines
    #[arg(long, value_name = "N", default_value = "4", value_parser = samples)]
    pub samples: u32,
    /// Leave the ground and the inside of outlines transparent, in place of white paper
    #[arg(long)]
    pub transparent: bool,
    /// Output file (.png)
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,
    #[command(flatten)]
    pub orient: OrientArgument,
    #[command(flatten)]
    pub camera: CameraArguments,
}

/// Arguments of `smooth`.
#[derive(Debug, Args)]
pub struct SmoothArguments {
    /// Mesh file or builtin:NAME
    pub mesh: MeshArgument,
    /// Name of the method: for a PNG one that fills its image, for an OBJ one that makes triangles for each view
    #[arg(long, value_name = "NAME", default_value = "smoothing")]
    pub method: String,
    /// An option of the method; may be given several times
    #[arg(long, value_name = "NAME=VALUE")]
    pub set: Vec<String>,
    /// Samples per pixel of a PNG: 1, or 4 for smooth outlines
    #[arg(long, value_name = "N", default_value = "4", value_parser = samples)]
    pub samples: u32,
    /// Output file: .obj or .png
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,
    #[command(flatten)]
    pub camera: CameraArguments,
}

/// Arguments of `bake`.
#[derive(Debug, Args)]
pub struct BakeArguments {
    /// Mesh file or builtin:NAME
    pub mesh: MeshArgument,
    /// A hull of your own, a mesh that encloses the other [default: one of at most hull-vertices vertices]
    #[arg(long, value_name = "MESH")]
    pub hull: Option<MeshArgument>,
    /// An option of the method texture; may be given several times
    #[arg(long, value_name = "NAME=VALUE")]
    pub set: Vec<String>,
    #[command(flatten)]
    pub orient: OrientArgument,
    /// Output file: .siltex
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,
}

fn samples(text: &str) -> Result<u32, String> {
    text.parse().ok().filter(|samples| [1, 4].contains(samples)).ok_or_else(|| "expected 1 or 4".to_owned())
}

/// An angle between faces.
pub fn bend(text: &str) -> Result<f64, String> {
    let degrees = text.parse().ok().filter(|degrees: &f64| (0.0..=180.0).contains(degrees));
    degrees.ok_or_else(|| "expected an angle of 0 to 180 degrees".to_owned())
}

/// Arguments of `merge`.
#[derive(Debug, Args)]
pub struct MergeArguments {
    /// Folders of finished cells, as `compare --shard` leaves them
    #[arg(required = true, value_name = "DIR")]
    pub cells: Vec<PathBuf>,
    /// Extraction timings of other tools for the report, as benches/peers writes them; may be given several times
    #[arg(long, value_name = "FILE.jsonl")]
    pub peers: Vec<PathBuf>,
    /// Folder for the report; made, or replaced where it holds an earlier report
    #[arg(short, long, value_name = "DIR")]
    pub output: PathBuf,
}

/// What stands for every paper.
pub const EVERY_PAPER: &str = "all";

/// The names that `reproduce` knows: those of the papers, and the one that stands for all.
fn papers() -> PossibleValuesParser {
    let paper = |paper: &Paper| {
        let Source { authors, title, year, .. } = paper.source;
        PossibleValue::new(paper.name).help(format!("{authors} {year}, {title}"))
    };
    let all = PossibleValue::new(EVERY_PAPER).help("Every one of these");
    PossibleValuesParser::new(silhouette_papers::ALL.into_iter().map(paper).chain([all]))
}

/// Arguments of `reproduce`.
#[derive(Debug, Args)]
pub struct ReproduceArguments {
    /// Whose figures to measure
    #[arg(value_parser = papers())]
    pub paper: String,
    /// Mesh files or builtin:NAME [default: built-in shapes]
    pub meshes: Vec<MeshArgument>,
    /// How much to measure
    #[arg(long, value_enum, default_value_t = ProfileArgument::Quick)]
    pub profile: ProfileArgument,
    /// Folder for the tables; made, or replaced where it holds an earlier reproduction
    #[arg(short, long, value_name = "DIR")]
    pub output: PathBuf,
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_command_line_is_consistent() {
        Arguments::command().debug_assert();
    }

    #[test]
    fn every_command_shows_an_example() {
        for command in Arguments::command().get_subcommands() {
            let help = command.get_after_help().map(ToString::to_string).unwrap_or_default();
            assert!(help.contains(&format!("silhouettes {}", command.get_name())), "{}", command.get_name());
        }
    }
}
