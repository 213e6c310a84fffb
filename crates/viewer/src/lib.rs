#![doc = include_str!("../README.md")]
//!
//! # What lies where
//!
//! 1. [`run`] reads the [`arguments`], opens a device ([`silhouette_render::Gpu`]) and the window, whose contents are a
//!    [`viewer::Viewer`].
//! 2. [`meshes`]: the mesh on screen. [`scenes`]: the scene that it is of. [`view`]: the camera. [`pane`]: a method from its
//!    choice to its picture, which a [`painter`] draws and a [`picture`] shows.
//!    [`arrangement`]: one method or two. [`viewport`]: pictures and divider. [`panels`]: what stands around them.
//! 3. [`background`]: nothing that takes long happens in a frame of the window. [`messages`]: what went wrong.
//!    [`measure`]: how fast the window is.
//!
//! Methods, options, cameras, truths and errors are those of the command line; nothing is implemented here a second time.

pub mod arguments;
pub mod arrangement;
pub mod background;
pub mod clock;
pub mod flicker;
pub mod history;
pub mod layers;
pub mod measure;
pub mod meshes;
pub mod messages;
pub mod painter;
pub mod pane;
pub mod panels;
pub mod path;
pub mod picture;
pub mod save;
pub mod scenes;
pub mod tracks;
pub mod truth;
pub mod view;
pub mod viewer;
pub mod viewport;

use arguments::Arguments;
use background::lock;
use clap::Parser;
use eframe::{egui, egui_wgpu};
use silhouette_compare::registry::Registry;
use silhouette_render::{AdapterChoice, Gpu};
use silhouettes::application::{Failure, silence_mesa, usage};
use std::io::Write;
use std::process::ExitCode;
use std::sync::Arc;
use viewer::Viewer;

/// What lines on stderr begin with.
const PROGRAM: &str = "silhouettes-viewer";

/// Room beside the pictures that a window begins with, in points.
const AROUND: [f32; 2] = [viewer::SIDE_POINTS, 25.0];

/// Opens a window with the methods of `registry`, as the process's arguments say. Prints what goes wrong.
pub fn run(registry: &Registry) -> ExitCode {
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) if !error.use_stderr() => {
            // Help and version: clap's own text, on stdout. A reader such as `head` that has seen enough is no failure.
            let is_read = !error.print().is_err_and(|error| error.kind() != std::io::ErrorKind::BrokenPipe);
            return if is_read { ExitCode::SUCCESS } else { ExitCode::FAILURE };
        }
        Err(error) => return usage(&error, PROGRAM).report(PROGRAM),
    };
    silence_mesa();
    match open(arguments, registry) {
        Ok(report) => {
            // A reader such as `head` that has seen enough is no failure.
            let is_written = std::io::stdout().lock().write_all(report.as_bytes());
            let is_read = !is_written.is_err_and(|error| error.kind() != std::io::ErrorKind::BrokenPipe);
            if is_read { ExitCode::SUCCESS } else { ExitCode::FAILURE }
        }
        Err(failure) => failure.report(PROGRAM),
    }
}

/// Shows the window until it is closed. What a measurement has to print.
fn open(arguments: Arguments, registry: &Registry) -> Result<String, Failure> {
    let [width, height] = arguments.camera.size().map(|side| side as f32);
    let start = arguments.start(registry)?;
    let gpu = Arc::new(AdapterChoice::from_env().and_then(Gpu::new).map_err(Failure::gpu)?);
    let options = eframe::NativeOptions {
        viewport: egui::ViewportBuilder::default()
            .with_title("silhouettes")
            .with_app_id(PROGRAM)
            .with_inner_size([width + AROUND[0], height + AROUND[1]]),
        wgpu_options: egui_wgpu::WgpuConfiguration { wgpu_setup: setup(&gpu), ..Default::default() },
        renderer: eframe::Renderer::Wgpu,
        ..Default::default()
    };
    let registry = registry.clone();
    let is_measured = start.measure.is_some();
    let mut outcome = None;
    let of_viewer = &mut outcome;
    let create: eframe::AppCreator<'_> = Box::new(move |context| {
        let viewer = Viewer::new(context, gpu, registry, start).map_err(|failure| failure.to_string())?;
        *of_viewer = Some(viewer.outcome());
        Ok(Box::new(viewer))
    });
    eframe::run_native("silhouettes", options, create).map_err(|error| {
        Failure::run(format_args!("no window can be opened: {error}; `silhouettes render` needs none"))
    })?;
    let measured = outcome.and_then(|outcome| lock(&outcome).take());
    let early = || Err(Failure::run("--measure: the window was closed before the time was over; nothing was measured"));
    if is_measured { measured.unwrap_or_else(early) } else { Ok(String::new()) }
}

/// The device of `gpu` for the window to be drawn with, so that it shows textures that methods draw.
pub fn setup(gpu: &Gpu) -> egui_wgpu::WgpuSetup {
    let (instance, adapter) = gpu.wgpu_adapter();
    egui_wgpu::WgpuSetupExisting {
        instance: instance.clone(),
        adapter: adapter.clone(),
        device: gpu.device().clone(),
        queue: gpu.queue().clone(),
    }
    .into()
}
