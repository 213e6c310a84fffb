//! What a frame costs, over plain rendering in the same run.

use super::methods::{METHODS, builtin, style};
use crate::directions::spread;
use crate::drawings::{FOV_Y_RAD, camera, drawing, time};
use crate::error::{Cause, PaperError};
use crate::paper::Run;
use crate::table::{Cell, Column, Row, Table};
use silhouette_baselines::FineMesh;
use silhouette_compare::NamedMesh;
use silhouette_compare::drawing::{DrawError, Drawing};
use silhouette_compare::registry::Entry;
use silhouette_core::Progress;
use silhouette_gpu::RendererError;
use silhouette_render::Gpu;

/// A table of every mesh, and of a built-in shape if one is named.
///
/// # Errors
/// [`PaperError`]: cancelled, or a device that failed.
pub fn by_mesh(
    gpu: &Gpu,
    run: &Run<'_>,
    rounds: u32,
    size: [u32; 2],
    largest: Option<&str>,
) -> Result<Vec<Table>, PaperError> {
    let largest = largest.map(builtin).transpose()?;
    let of = |named: &NamedMesh| {
        of_mesh(gpu, named, rounds, size, run.progress).map_err(PaperError::of::<Cause>(&named.name))
    };
    run.meshes.iter().chain(&largest).map(of).collect()
}

/// A drawing, or why the device cannot hold what the method derives from the mesh.
fn unless_too_large(drawing: Result<Drawing, Cause>) -> Result<Result<Drawing, String>, Cause> {
    match drawing {
        Err(Cause::Draw(DrawError::Renderer(RendererError::MeshTooLarge(refusal)))) => Ok(Err(refusal.to_string())),
        other => other.map(Ok),
    }
}

fn of_mesh(gpu: &Gpu, named: &NamedMesh, rounds: u32, size: [u32; 2], progress: &dyn Progress) -> Result<Table, Cause> {
    progress.stage(&format!("{}: frames", named.name), 1);
    let mesh = &named.mesh;
    let plain: Entry = Entry::of::<FineMesh>().fill().into();
    let mut plain = drawing(gpu, mesh, &plain, "shading=flat", style(size), progress)?;
    let mut drawings = Vec::new();
    for drawn in &METHODS {
        drawings.push(unless_too_large(drawn.drawing(gpu, mesh, "", size, progress))?);
    }
    let cameras = spread(rounds).map(|direction| camera(mesh.mesh(), direction, FOV_Y_RAD, size));
    let cameras: Vec<_> = cameras.collect::<Result<_, _>>()?;
    let held = drawings.iter_mut().filter_map(|drawing| drawing.as_mut().ok());
    let mut all: Vec<_> = std::iter::once(&mut plain).chain(held).collect();
    let mut times = time(gpu, &cameras, &mut all, progress)?.into_iter();
    progress.advance(1);
    let plain_ms = times.next().unwrap_or(f64::NAN);
    let row = |label, ms: f64| Row::new(label, [ms, ms / plain_ms].map(Cell::one).to_vec());
    let mut rows = vec![row("plain", plain_ms)];
    for (drawn, drawing) in METHODS.iter().zip(&drawings) {
        rows.push(match drawing {
            Ok(_) => row(drawn.label, times.next().unwrap_or(f64::NAN)),
            Err(refusal) => Row::new(drawn.label, vec![Cell::default().noted(refusal), Cell::default()]),
        });
    }
    Ok(Table {
        name: "frames",
        subject: named.name.clone(),
        about: format!(
            "{} faces, {} x {} pixels, drawn by {}",
            mesh.mesh().face_count(),
            size[0],
            size[1],
            gpu.adapter().name
        ),
        columns: vec![
            Column::new("frame", "frame time", "ms", "median time of a frame, from the camera to a finished picture"),
            Column::new(
                "over plain",
                "frame time over plain rendering",
                "×",
                "over that of plain rendering in the same run",
            ),
        ],
        rows,
        ..Table::default()
    })
}
