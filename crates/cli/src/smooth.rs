//! `silhouettes smooth`: a coarse mesh with a smooth outline, as the triangles of one view or as their picture.

mod obj;

use crate::args::SmoothArguments;
use crate::failure::Failure;
use crate::input;
use crate::output::Output;
use crate::progress::TerminalProgress;
use crate::render;
use crate::winding::Winding;
use silhouette_compare::drawing::{FrameStyle, Ground, pictures_of};
use silhouette_compare::metrics::PictureKind;
use silhouette_compare::registry::{Capabilities, Entry, Prepared, Registry};
use silhouette_compare::runner::NamedMesh;
use silhouette_core::curves::{CurveKind, CurveSource};
use silhouette_core::method::OptionValues;
use silhouette_core::{Camera, Progress, SilhouetteCurves};
use silhouette_smoothing::{SmoothingView, ViewMesh};
use std::io::Write;
use std::path::Path;

/// The formats that a smoothed view is written in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Format {
    Obj,
    Png,
}

impl Format {
    /// Whether a method yields what this format holds.
    fn is_yielded_by(self, can: Capabilities) -> bool {
        match self {
            Self::Obj => can.triangles,
            Self::Png => pictures_of(can).next() == Some(PictureKind::Fill),
        }
    }
}

/// Width of the pen, which filled pictures do not use.
const PEN_WIDTH_PX: f64 = 1.0;

/// Runs the command.
pub fn run(arguments: &SmoothArguments, registry: &Registry) -> Result<(), Failure> {
    let format = format_of(&arguments.output)?;
    let (entry, options) = method_of(&arguments.method, &arguments.set, format, registry)?;
    let info = entry.info();
    let output = Output::create(Some(&arguments.output), std::slice::from_ref(&arguments.mesh))?;
    let progress = TerminalProgress::new();
    let named = input::mesh(&arguments.mesh, Winding::AsItIs, &progress)?;
    let bounds = named.mesh.mesh().bounds().ok_or_else(|| Failure::Input(format!("{}: has no face", named.name)))?;
    let camera = arguments.camera.camera(&bounds, named.mesh.mesh().origin())?;

    let prepared = entry.prepare(&named.mesh, &options, &progress);
    let mut prepared = prepared.map_err(|error| Failure::of_preparation(&named.name, info.name, error))?;
    let view_mesh = triangles(&prepared, &camera);
    let bytes = match format {
        Format::Obj => {
            let obj = obj::write(
                &view_mesh,
                named.mesh.mesh().origin(),
                &format!("{} in one view by {}", named.name, info.name),
            );
            obj.map_err(|error| Failure::Run(format!("{}: {error}", named.name)))?
        }
        Format::Png => {
            let style = FrameStyle {
                size: camera.size(),
                pen_width_px: PEN_WIDTH_PX,
                samples: arguments.samples,
                ground: Ground::Paper,
            };
            render::png((entry, &options), &named, &camera, style, &progress)?
        }
    };
    output.write(&bytes)?;
    let summary = summary(entry, &mut prepared, named.mesh.mesh().face_count(), &view_mesh, &camera);
    // Where stderr is closed there is nobody to tell.
    let _ = writeln!(std::io::stderr(), "{}: {summary}", named.name);
    Ok(())
}

/// The method of a smoothed view, with its options.
fn method_of<'a>(
    name: &str,
    set: &[String],
    format: Format,
    registry: &'a Registry,
) -> Result<(&'a Entry, OptionValues), Failure> {
    let entry = registry.find(name).map_err(Failure::input)?;
    if !format.is_yielded_by(entry.capabilities()) {
        let lacks = match format {
            Format::Obj => "makes no triangles of its own",
            Format::Png => "fills no image",
        };
        let known = registry.names(|entry| format.is_yielded_by(entry.capabilities()));
        return Err(Failure::Input(format!("--method {name} {lacks}; choose {known}")));
    }
    Ok((entry, OptionValues::parse(entry.info().options, set.iter().map(String::as_str))?))
}

/// The triangles that stand for a mesh in a view, by a method with options as `--set` takes them.
///
/// # Errors
/// [`Failure`]: there is no such method, it makes no triangles, or it is not defined for the mesh.
pub fn view_mesh(
    (method, set): (&str, &[String]),
    named: &NamedMesh,
    camera: &Camera,
    registry: &Registry,
    progress: &dyn Progress,
) -> Result<ViewMesh, Failure> {
    let (entry, options) = method_of(method, set, Format::Obj, registry)?;
    let prepared = entry.prepare(&named.mesh, &options, progress);
    let prepared = prepared.map_err(|error| Failure::of_preparation(&named.name, method, error))?;
    Ok(triangles(&prepared, camera))
}

/// The triangles of a view; none of a method that makes none.
fn triangles(prepared: &Prepared, camera: &Camera) -> ViewMesh {
    let mut view_mesh = ViewMesh::default();
    if let Some(mut remesher) = prepared.triangles() {
        remesher.remesh(&SmoothingView::from_camera(camera), &mut view_mesh);
    }
    view_mesh
}

/// What was done, in one line: what the method can tell of it.
fn summary(entry: &Entry, prepared: &mut Prepared, faces: usize, view_mesh: &ViewMesh, camera: &Camera) -> String {
    let mut facts = vec![format!("{faces} triangles")];
    if entry.capabilities().triangles {
        facts.push(format!("{} in their place", view_mesh.triangles.len()));
    }
    if let Some(method) = prepared.curves() {
        let mut curves = SilhouetteCurves::default();
        method.extract_curves(&camera.viewpoint(), &mut curves);
        let through_faces = curves.pieces().iter().filter(|piece| matches!(piece.source, CurveSource::Face(_))).count();
        if through_faces > 0 {
            facts.push(format!("{through_faces} of the mesh's crossed by the silhouette"));
        }
        let chains = |kind: CurveKind| curves.iter().filter(|chain| chain.pieces[0].kind == kind).count();
        let kinds = [CurveKind::Silhouette, CurveKind::Boundary, CurveKind::Crease];
        let counts = kinds.map(|kind| format!("{} {}", chains(kind), kind.name()));
        facts.push(format!("curves: {}", counts.join(", ")));
    }
    facts.join("; ")
}

fn format_of(path: &Path) -> Result<Format, Failure> {
    match path.extension().and_then(|extension| extension.to_str()).map(str::to_ascii_lowercase).as_deref() {
        Some("obj") => Ok(Format::Obj),
        Some("png") => Ok(Format::Png),
        _ => Err(Failure::Input(format!("{}: unknown kind of output; end its name in .obj or .png", path.display()))),
    }
}
