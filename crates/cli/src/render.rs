//! `silhouettes render`: the picture of one method as a PNG, of one mesh or of several that hide each other.

use crate::args::{MethodArguments, RenderArguments};
use crate::failure::{self, Failure};
use crate::input;
use crate::out_of_view::out_of_view;
use crate::output::Output;
use crate::progress::TerminalProgress;
use silhouette_compare::drawing::{DrawError, FrameStyle, Ground, Rendered, render_method};
use silhouette_compare::registry::{Entry, Registry};
use silhouette_compare::runner::NamedMesh;
use silhouette_core::method::{OptionKind, OptionValues};
use silhouette_core::{Camera, Progress};
use silhouette_render::{AdapterChoice, Gpu};

/// Pens thinner than this leave no ink, wider ones no paper.
const PEN_WIDTHS_PX: std::ops::RangeInclusive<f64> = 0.1..=100.0;

/// Runs the command.
pub fn run(arguments: &RenderArguments, registry: &Registry) -> Result<(), Failure> {
    let path = &arguments.output;
    if path.extension().is_none_or(|extension| !extension.eq_ignore_ascii_case("png")) {
        return Err(Failure::Input(format!("{}: unknown kind of output; end its name in .png", path.display())));
    }
    let ground = if arguments.transparent { Ground::Transparent } else { Ground::Paper };
    let (entry, options) = method_of_picture(&arguments.method, arguments.width, ground, registry)?;
    let output = Output::create(Some(path), &arguments.meshes)?;
    let progress = TerminalProgress::new();
    let named = input::drawable(&arguments.meshes, entry, arguments.orient.winding(draws_itself(entry)), &progress)?;
    let bounds = named.mesh.mesh().bounds().ok_or_else(|| Failure::Input(format!("{}: has no face", named.name)))?;
    let camera = arguments.camera.camera(&bounds, named.mesh.mesh().origin())?;
    if let Some(reason) = out_of_view(&camera, named.mesh.mesh()) {
        failure::note(format_args!("nothing lies in the view: {reason}"));
    }
    let (size, pen_width_px) = (camera.size(), arguments.width);
    let style = FrameStyle { size, pen_width_px, samples: arguments.samples, ground };
    output.write(&png((entry, &options), &named, &camera, style, &progress)?)
}

/// Whether a method draws what faces outwards say, other than edges, which are the same for a mesh that is inside out.
pub fn draws_itself(entry: &Entry) -> bool {
    entry.capabilities().lines || entry.capabilities().fill
}

/// The method of a picture with its options, on this ground with a pen of this width in pixels.
///
/// # Errors
/// [`Failure::Input`]: there is no such method, it draws nothing, or an option or the pen does not fit.
pub fn method_of_picture<'a>(
    MethodArguments { method, set }: &MethodArguments,
    pen_width_px: f64,
    ground: Ground,
    registry: &'a Registry,
) -> Result<(&'a Entry, OptionValues), Failure> {
    if !PEN_WIDTHS_PX.contains(&pen_width_px) {
        let (min, max) = (PEN_WIDTHS_PX.start(), PEN_WIDTHS_PX.end());
        return Err(Failure::Input(format!("--width {pen_width_px}: give {min} to {max} pixels")));
    }
    let entry = registry.find(method).map_err(Failure::input)?;
    let can = entry.capabilities();
    if !(can.edges || can.lines || can.fill) {
        let mend = format!("silhouettes extract --method {method} -o FILE.svg draws those");
        return Err(Failure::Input(format!("--method {method}: yields curves alone; {mend}")));
    }
    let words = on_ground(entry, ground).into_iter().chain(set.iter().map(String::as_str));
    let options = OptionValues::parse(entry.info().options, words)?;
    Ok((entry, options))
}

/// The device that the environment chooses.
///
/// # Errors
/// [`Failure`]: there is none, or the choice does not fit.
pub fn open_device() -> Result<Gpu, Failure> {
    AdapterChoice::from_env().and_then(Gpu::new).map_err(Failure::gpu)
}

/// The picture of one view by one method, its lines where it yields any, with straight alpha.
///
/// # Errors
/// [`Failure`]: the method is not defined for the mesh, or the device failed.
pub fn picture(
    gpu: &Gpu,
    (entry, options): (&Entry, &OptionValues),
    named: &NamedMesh,
    camera: &Camera,
    style: FrameStyle,
    progress: &dyn Progress,
) -> Result<Rendered, Failure> {
    let failed = |error| match error {
        DrawError::Prepare(error) => Failure::of_preparation(&named.name, entry.info().name, error),
        other => Failure::run(other),
    };
    let Rendered { image, warning } =
        render_method(gpu, entry, options, &named.mesh, camera, style, progress).map_err(failed)?;
    Ok(Rendered { image: image.unpremultiplied(), warning })
}

/// The same as a PNG file. Prints what its user should know of it.
pub fn png(
    method: (&Entry, &OptionValues),
    named: &NamedMesh,
    camera: &Camera,
    style: FrameStyle,
    progress: &TerminalProgress,
) -> Result<Vec<u8>, Failure> {
    let rendered = picture(&open_device()?, method, named, camera, style, progress)?;
    if let Some(warning) = &rendered.warning {
        failure::note(warning);
    }
    rendered.image.to_png().map_err(Failure::run)
}

/// The option that a method needs on this ground, unless its user sets it: on a transparent one the inside of an outline is
/// transparent as well.
fn on_ground(entry: &Entry, ground: Ground) -> Option<&'static str> {
    let has_depth_only = |kind: &OptionKind| matches!(kind, OptionKind::Choice(words) if words.contains(&"depth-only"));
    let interior = entry.info().options.iter().find(|option| option.name == "interior");
    (ground == Ground::Transparent && interior.is_some_and(|option| has_depth_only(&option.kind)))
        .then_some("interior=depth-only")
}
