//! `silhouettes bake`: a silhouette texture as a file.

use crate::args::BakeArguments;
use crate::failure::{self, Failure};
use crate::input;
use crate::output::Output;
use crate::progress::TerminalProgress;
use crate::winding::Winding;
use glam::DVec3;
use silhouette_compare::machine::describe_program;
use silhouette_compare::runner::NamedMesh;
use silhouette_core::{Method, MethodOptions, Progress};
use silhouette_texture::bake::{BakeError, BakeReport};
use silhouette_texture::hull::HullError;
use silhouette_texture::method::{TextureError, bake, hull as make_hull};
use silhouette_texture::siltex::{self, Metadata};
use silhouette_texture::{Hull, SilhouetteTexture, Texture, TextureOptions};
use std::ffi::OsString;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// The entry of a `.siltex` file's metadata that says from where its positions count in the coordinates of the mesh's file.
const ORIGIN: &str = "origin";

/// The origin of a texture with this metadata; zero where there is none.
pub fn origin(metadata: &Metadata) -> DVec3 {
    let numbers = |text: &String| text.split(' ').map(|number| number.parse::<f64>().ok()).collect::<Option<Vec<_>>>();
    let origin = metadata.get(ORIGIN).and_then(numbers).and_then(|numbers| <[f64; 3]>::try_from(numbers).ok());
    origin.map(DVec3::from).filter(|origin| origin.is_finite()).unwrap_or_default()
}

/// Runs the command.
pub fn run(arguments: &BakeArguments) -> Result<(), Failure> {
    let path = &arguments.output;
    if path.extension().is_none_or(|extension| !extension.eq_ignore_ascii_case("siltex")) {
        return Err(Failure::Input(format!("{}: unknown kind of output; end its name in .siltex", path.display())));
    }
    let options = TextureOptions::parse(arguments.set.iter().map(String::as_str))?;
    let choice = options.bake();
    let inputs: Vec<_> = [&arguments.mesh].into_iter().chain(&arguments.hull).cloned().collect();
    Output::create(Some(path), &inputs)?;
    let progress = TerminalProgress::new();
    let named = input::mesh(&arguments.mesh, arguments.orient.winding(true), &progress)?;
    let mesh = named.mesh.mesh();

    let start = Instant::now();
    let given = arguments.hull.as_ref().map(|given| input::mesh(given, Winding::AsItIs, &progress)).transpose()?;
    let checkpoint = checkpoint(path);
    let Baked { hull, texture, report } = baked(&named, given.as_ref(), &options, Some(&checkpoint), &progress)?;
    if report.restored_tiles > 0 {
        let (restored, tiles) = (report.restored_tiles, report.tiles);
        failure::note(format!("went on from {}: {restored} of {tiles} tiles were finished", checkpoint.display()));
    }
    let metadata = metadata(&named, &options)?;
    siltex::write(path, &texture, &metadata, &progress).map_err(Failure::input)?;
    std::fs::remove_file(&checkpoint).map_err(|error| Failure::Run(format!("{}: {error}", checkpoint.display())))?;
    drop(progress);

    let size = choice.options.size;
    let offset = hull.offset().map_or_else(String::new, |offset| format!(" within {offset:.3}"));
    let summary = format!(
        "{}: {} vertices in a hull of {}{offset}; {} x {} x {} samples on {} page{}, {:.0} % of texels used; {:.1} rays per \
         sample; {:.1} s",
        named.name,
        mesh.positions().len(),
        hull.mesh().positions().len(),
        size.width,
        size.height,
        size.azimuths,
        size.pages,
        if size.pages == 1 { "" } else { "s" },
        100.0 * report.utilisation,
        report.rays_per_sample(),
        start.elapsed().as_secs_f64(),
    );
    // Where stderr is closed there is nobody to tell.
    let _ = writeln!(std::io::stderr(), "{summary}");
    if report.hidden_centers > 0 {
        let share = 100.0 * report.hidden_centers as f64 / report.texels as f64;
        let name = Texture::INFO.name;
        failure::note(format!(
            "at {share:.1} % of texels the middle of the lobe does not show the mesh, so that method {name} may draw holes; \
             raise hull-vertices, or set centers=texel"
        ));
    }
    Ok(())
}

/// A silhouette texture that was baked.
pub struct Baked {
    /// The hull.
    pub hull: Hull,
    /// The texture, which holds the hull as well.
    pub texture: SilhouetteTexture,
    /// What it took.
    pub report: BakeReport,
}

/// Bakes the texture of a mesh, on a hull that is given or made. Finished tiles lie at `checkpoint` meanwhile, if there is one.
///
/// # Errors
/// [`Failure`]: the mesh has no hull, the one that is given does not enclose it, or the work was cancelled.
pub fn baked(
    named: &NamedMesh,
    hull: Option<&NamedMesh>,
    options: &TextureOptions,
    checkpoint: Option<&Path>,
    progress: &dyn Progress,
) -> Result<Baked, Failure> {
    let (mesh, choice) = (named.mesh.mesh(), options.bake());
    let failed = |error: TextureError| match error {
        TextureError::Bake(error @ BakeError::Checkpoint { .. }) => Failure::Input(error.to_string()),
        TextureError::FeatureOff => Failure::run(error),
        error => Failure::Input(format!("{}: {error}", named.name)),
    };
    let hull = match hull {
        Some(given) => {
            let placed = given.mesh.mesh().relative_to(mesh.origin());
            let placed = placed.map_err(|error| Failure::Input(format!("{}: {error}", given.name)))?;
            Hull::checked_with_progress(mesh, placed, progress).map_err(|error| match error {
                HullError::Cancelled(cancelled) => cancelled.into(),
                error => Failure::Input(format!("{}: {error}", given.name)),
            })?
        }
        None => make_hull(mesh, choice.hull_vertices, progress).map_err(failed)?,
    };
    let (texture, report) = bake(mesh, &hull, choice.options, choice.terms, progress, checkpoint).map_err(failed)?;
    Ok(Baked { hull, texture, report })
}

/// What a file of a texture says of where it comes from.
///
/// # Errors
/// [`Failure::Input`]: an option does not fit.
pub fn metadata(named: &NamedMesh, options: &TextureOptions) -> Result<Metadata, Failure> {
    let values = options.values()?.to_string();
    let metadata = [("mesh", named.name.clone()), ("options", values), ("program", describe_program())];
    let mut metadata: Metadata = metadata.into_iter().map(|(key, value)| (key.to_owned(), value)).collect();
    let origin = named.mesh.mesh().origin();
    if origin != DVec3::ZERO {
        let [x, y, z] = origin.to_array();
        metadata.insert(ORIGIN.to_owned(), format!("{x} {y} {z}"));
    }
    Ok(metadata)
}

/// Where finished tiles of an output lie meanwhile.
fn checkpoint(path: &Path) -> PathBuf {
    let mut name: OsString = path.as_os_str().to_owned();
    name.push(".checkpoint");
    PathBuf::from(name)
}
