//! `silhouettes score`: what another program drew, scored against the truth of a scene.

mod arguments;
mod files;
mod table;

pub use arguments::{HELP, ScoreArguments};

use crate::failure::{self, Failure};
use crate::input;
use crate::mesh_argument::MeshArgument;
use crate::output::{Output, check_writable};
use crate::progress::TerminalProgress;
use files::FileOfView;
use silhouette_compare::foreign::cameras::CamerasDocument;
use silhouette_compare::foreign::score::ScoreError;
use silhouette_compare::foreign::{ForeignFile, ForeignScore, Frame, ScoredView, Scorer, read, results};
use silhouette_compare::runner::{DEFAULT_PEN_WIDTH_PX, NamedMesh, Subject};
use silhouette_compare::scene::{MeshSpec, Scene};
use silhouette_core::Progress;
use silhouette_core::mesh::Bounds;
use std::path::Path;

/// Runs the command.
pub fn run(arguments: &ScoreArguments) -> Result<(), Failure> {
    let scene = scene(arguments)?;
    let argument = mesh_argument(arguments, scene.as_ref())?;
    let target = Target::new(arguments, &argument)?;
    let progress = TerminalProgress::new();
    let mesh = input::welded(&argument, arguments.weld, arguments.orient.winding(false), &progress)?;
    let bounds = mesh.mesh.mesh().bounds().ok_or_else(|| Failure::Input(format!("{}: has no face", mesh.name)))?;
    let views = views(arguments, scene.as_ref(), &mesh, &bounds)?;
    let of_scene = scene.as_ref().map_or(DEFAULT_PEN_WIDTH_PX, |scene| scene.pen.width_px);
    let width = arguments.width.unwrap_or(of_scene);
    let cameras = |views: &[ScoredView]| CamerasDocument::new(&mesh.name, mesh.mesh.mesh(), &bounds, views, width);
    let directory = match target {
        Target::Cameras(output) => {
            let mut text = serde_json::to_vec_pretty(&cameras(&views)).map_err(Failure::run)?;
            text.push(b'\n');
            return output.write(&text);
        }
        Target::Scores(directory) => directory,
    };
    let frames: Vec<u32> = views.iter().map(|view| view.frame).collect();
    let mut files = files::of_views(&arguments.lines, &arguments.frame, &frames)?;
    files.sort_by_key(|file| file.view);
    let name = arguments.name.clone().unwrap_or_else(|| files::program(&arguments.lines[0]));
    let shown: Vec<ScoredView> = files.iter().map(|file| views[file.view]).collect();
    let document = cameras(&shown);
    // What cannot be read is refused before the truth is found.
    let drawings = files.iter().zip(&shown).map(|(file, view)| drawing(&file.path, view, width));
    let drawings = drawings.collect::<Result<Vec<_>, _>>()?;
    let subject = Subject::from(mesh.clone());
    let mut scorer = Scorer::new(&subject, shown, width, &progress).map_err(Failure::of_comparison)?;
    let scores = score(&mut scorer, drawings, &files, &progress)?;
    let cell = scorer.cell(&name, scores.iter().map(|score| score.view.clone()).collect());
    Output::Stdout.write(table::of(&cell).as_bytes())?;
    if let Some(directory) = directory {
        let names: Vec<String> = files.iter().map(|file| file.path.display().to_string()).collect();
        results::write(directory, &cell, &scores, &names, &document).map_err(Failure::run)?;
    }
    Ok(())
}

/// What is written where.
enum Target<'a> {
    Cameras(Output),
    Scores(Option<&'a Path>),
}

impl<'a> Target<'a> {
    fn new(arguments: &'a ScoreArguments, mesh: &MeshArgument) -> Result<Self, Failure> {
        let path = arguments.output.as_deref();
        if arguments.cameras {
            return Ok(Self::Cameras(Output::create(path, std::slice::from_ref(mesh))?));
        }
        if let Some(directory) = path {
            results::check_target(directory).map_err(Failure::input)?;
            check_writable(directory)?;
        }
        Ok(Self::Scores(path))
    }
}

/// The scene that is named, if any.
fn scene(arguments: &ScoreArguments) -> Result<Option<Scene>, Failure> {
    let scene = match (&arguments.scene, arguments.profile) {
        (Some(path), _) => Scene::load(path).map_err(Failure::input)?,
        (None, Some(profile)) => silhouette_compare::Profile::from(profile).scene(),
        (None, None) => return Ok(None),
    };
    if !arguments.camera.is_default() {
        let mend = "leave out the camera options, or the scene";
        return Err(Failure::Input(format!("camera: the scene says where the camera is; {mend}")));
    }
    Ok(Some(scene))
}

/// The mesh that is named, or the only one of the scene.
fn mesh_argument(arguments: &ScoreArguments, scene: Option<&Scene>) -> Result<MeshArgument, Failure> {
    if let Some(mesh) = &arguments.mesh {
        return Ok(mesh.clone());
    }
    let Some(scene) = scene else {
        return Err(Failure::Input("score: name a mesh, or a scene that does (--scene FILE)".to_owned()));
    };
    match &scene.meshes[..] {
        [MeshSpec::Simplified { mesh, .. }] => Err(Failure::Input(format!(
            "{}: {mesh} is drawn simplified, which no other program knows; write the simplified mesh to a file and name that",
            scene.name
        ))),
        [spec] => Ok(spec.mesh().into()),
        [] => Err(Failure::Input(format!("{}: meshes: none is listed; name one as an argument", scene.name))),
        several => {
            let names: Vec<&str> = several.iter().map(MeshSpec::mesh).collect();
            let mend = "name the one that the files show";
            Err(Failure::Input(format!("{}: has several meshes ({}); {mend}", scene.name, names.join(", "))))
        }
    }
}

/// The scored frames of the scene, or the one view of the camera options.
fn views(
    arguments: &ScoreArguments,
    scene: Option<&Scene>,
    mesh: &NamedMesh,
    bounds: &Bounds,
) -> Result<Vec<ScoredView>, Failure> {
    match scene {
        Some(scene) => Ok(ScoredView::of_scene(scene, bounds)?),
        None => Ok(vec![ScoredView { frame: 0, camera: arguments.camera.camera(bounds, mesh.mesh.mesh().origin())? }]),
    }
}

/// What a file holds of a view. Prints what its user should know.
fn drawing(path: &Path, view: &ScoredView, width: f64) -> Result<ForeignFile, Failure> {
    let frame = Frame { size: view.camera.size(), pen_width_px: width };
    let mut file = read(path, frame).map_err(Failure::input)?;
    for about_file in std::mem::take(&mut file.notes) {
        failure::note(format_args!("{}: {about_file}", path.display()));
    }
    Ok(file)
}

/// Scores what each file holds of its view, in order.
fn score(
    scorer: &mut Scorer<'_>,
    drawings: Vec<ForeignFile>,
    files: &[FileOfView],
    progress: &dyn Progress,
) -> Result<Vec<ForeignScore>, Failure> {
    let mut scores = Vec::with_capacity(files.len());
    for (view, (drawing, file)) in drawings.into_iter().zip(files).enumerate() {
        progress.check()?;
        let score = scorer.score(view, drawing, progress).map_err(|error| match error {
            ScoreError::File(fault) => Failure::input(fault.in_file(&file.path)),
            ScoreError::Truth(error) => Failure::of_comparison(error),
            other => Failure::run(other),
        })?;
        scores.push(score);
    }
    Ok(scores)
}
