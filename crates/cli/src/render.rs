//! `silhouettes render`: the lines of one method as a PNG.

use crate::args::RenderArguments;
use crate::failure::{self, Failure};
use crate::input;
use crate::output::Output;
use crate::progress::TerminalProgress;
use silhouette_compare::drawing::{DrawError, FrameStyle, render_method};
use silhouette_compare::registry;
use silhouette_core::method::OptionValues;
use silhouette_render::{AdapterChoice, Gpu};

/// Pens thinner than this leave no ink, wider ones no paper.
const PEN_WIDTHS_PX: std::ops::RangeInclusive<f64> = 0.1..=100.0;

/// Runs the command.
pub fn run(arguments: &RenderArguments) -> Result<(), Failure> {
    let path = &arguments.output;
    if path.extension().is_none_or(|extension| !extension.eq_ignore_ascii_case("png")) {
        return Err(Failure::Input(format!("{}: unknown kind of output; end its name in .png", path.display())));
    }
    if !PEN_WIDTHS_PX.contains(&arguments.width) {
        let (min, max) = (PEN_WIDTHS_PX.start(), PEN_WIDTHS_PX.end());
        return Err(Failure::Input(format!("--width {}: give {min} to {max} pixels", arguments.width)));
    }
    let entry = registry::find(&arguments.method.method).map_err(Failure::input)?;
    let options = OptionValues::parse(entry.info.options, arguments.method.set.iter().map(String::as_str))?;
    let output = Output::create(Some(path), &[&arguments.mesh])?;
    let progress = TerminalProgress::new();
    let named = input::mesh(&arguments.mesh, &progress)?;
    let bounds = named.mesh.mesh().bounds().ok_or_else(|| Failure::Input(format!("{}: has no face", named.name)))?;
    let camera = arguments.camera.camera(&bounds)?;
    let gpu = AdapterChoice::from_env().and_then(Gpu::new).map_err(Failure::gpu)?;
    let style = FrameStyle { size: camera.size(), pen_width_px: arguments.width, samples: arguments.samples };
    let failed = |error| match error {
        DrawError::Prepare(error) => Failure::of_preparation(&named.name, entry.info.name, error),
        other => Failure::run(other),
    };
    let rendered = render_method(&gpu, entry, &options, &named.mesh, &camera, style, &progress).map_err(failed)?;
    if let Some(warning) = &rendered.warning {
        failure::note(warning);
    }
    output.write(&rendered.image.to_png().map_err(Failure::run)?)
}
