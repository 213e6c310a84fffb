//! `silhouettes render`: the picture of one method as a PNG, of one mesh or of several that hide each other.

use crate::args::RenderArguments;
use crate::failure::{self, Failure};
use crate::input;
use crate::out_of_view::out_of_view;
use crate::output::Output;
use crate::progress::TerminalProgress;
use silhouette_compare::drawing::{DrawError, FrameStyle, Ground, render_method};
use silhouette_compare::registry::{Entry, Registry};
use silhouette_compare::runner::NamedMesh;
use silhouette_core::Camera;
use silhouette_core::method::{OptionKind, OptionValues};
use silhouette_render::{AdapterChoice, Gpu};

/// Pens thinner than this leave no ink, wider ones no paper.
const PEN_WIDTHS_PX: std::ops::RangeInclusive<f64> = 0.1..=100.0;

/// Runs the command.
pub fn run(arguments: &RenderArguments, registry: &Registry) -> Result<(), Failure> {
    let path = &arguments.output;
    if path.extension().is_none_or(|extension| !extension.eq_ignore_ascii_case("png")) {
        return Err(Failure::Input(format!("{}: unknown kind of output; end its name in .png", path.display())));
    }
    if !PEN_WIDTHS_PX.contains(&arguments.width) {
        let (min, max) = (PEN_WIDTHS_PX.start(), PEN_WIDTHS_PX.end());
        return Err(Failure::Input(format!("--width {}: give {min} to {max} pixels", arguments.width)));
    }
    let entry = registry.find(&arguments.method.method).map_err(Failure::input)?;
    let can = entry.capabilities();
    if !(can.edges || can.lines || can.fill) {
        let mend = format!("silhouettes extract --method {} -o FILE.svg draws those", arguments.method.method);
        return Err(Failure::Input(format!("--method {}: yields curves alone; {mend}", arguments.method.method)));
    }
    let ground = if arguments.transparent { Ground::Transparent } else { Ground::Paper };
    let words = on_ground(entry, ground).into_iter().chain(arguments.method.set.iter().map(String::as_str));
    let options = OptionValues::parse(entry.info().options, words)?;
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
    output.write(&png(entry, &options, &named, &camera, style, &progress)?)
}

/// Whether a method draws what faces outwards say, other than edges, which are the same for a mesh that is inside out.
pub fn draws_itself(entry: &Entry) -> bool {
    entry.capabilities().lines || entry.capabilities().fill
}

/// The picture of one view by one method, its lines where it yields any, as a PNG file. Prints what its user should know of it.
pub fn png(
    entry: &Entry,
    options: &OptionValues,
    named: &NamedMesh,
    camera: &Camera,
    style: FrameStyle,
    progress: &TerminalProgress,
) -> Result<Vec<u8>, Failure> {
    let gpu = AdapterChoice::from_env().and_then(Gpu::new).map_err(Failure::gpu)?;
    let failed = |error| match error {
        DrawError::Prepare(error) => Failure::of_preparation(&named.name, entry.info().name, error),
        other => Failure::run(other),
    };
    let rendered = render_method(&gpu, entry, options, &named.mesh, camera, style, progress).map_err(failed)?;
    if let Some(warning) = &rendered.warning {
        failure::note(warning);
    }
    rendered.image.unpremultiplied().to_png().map_err(Failure::run)
}

/// The option that a method needs on this ground, unless its user sets it: on a transparent one the inside of an outline is
/// transparent as well.
fn on_ground(entry: &Entry, ground: Ground) -> Option<&'static str> {
    let has_depth_only = |kind: &OptionKind| matches!(kind, OptionKind::Choice(words) if words.contains(&"depth-only"));
    let interior = entry.info().options.iter().find(|option| option.name == "interior");
    (ground == Ground::Transparent && interior.is_some_and(|option| has_depth_only(&option.kind)))
        .then_some("interior=depth-only")
}
