//! What a frame costs, over plain rendering in the same run.

use super::methods::{METHODS, style};
use crate::directions::spread;
use crate::drawings::{FOV_Y_RAD, camera, drawing, time};
use crate::error::{Cause, PaperError};
use crate::paper::Run;
use crate::table::{Cell, Column, Row, Table};
use silhouette_baselines::FineMesh;
use silhouette_compare::NamedMesh;
use silhouette_compare::registry::Entry;
use silhouette_core::shapes::by_name;
use silhouette_core::{PreparedMesh, Progress};
use silhouette_render::Gpu;
use std::sync::Arc;

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
    let largest = largest.map(|name| -> Result<NamedMesh, Cause> {
        Ok(NamedMesh { name: format!("builtin:{name}"), mesh: Arc::new(PreparedMesh::new(by_name(name)?)) })
    });
    let largest = largest.transpose()?;
    let of = |named: &NamedMesh| {
        of_mesh(gpu, named, rounds, size, run.progress).map_err(PaperError::of::<Cause>(&named.name))
    };
    run.meshes.iter().chain(&largest).map(of).collect()
}

fn of_mesh(gpu: &Gpu, named: &NamedMesh, rounds: u32, size: [u32; 2], progress: &dyn Progress) -> Result<Table, Cause> {
    progress.stage(&format!("{}: frames", named.name), 1);
    let mesh = &named.mesh;
    let plain: Entry = Entry::of::<FineMesh>().fill().into();
    let mut plain = drawing(gpu, mesh, &plain, "shading=flat", style(size), progress)?;
    let drawings = METHODS.iter().map(|drawn| drawn.drawing(gpu, mesh, "", size, progress));
    let mut drawings = drawings.collect::<Result<Vec<_>, _>>()?;
    let cameras = spread(rounds).map(|direction| camera(mesh.mesh(), direction, FOV_Y_RAD, size));
    let cameras: Vec<_> = cameras.collect::<Result<_, _>>()?;
    let mut all: Vec<_> = std::iter::once(&mut plain).chain(&mut drawings).collect();
    let times = time(gpu, &cameras, &mut all, progress)?;
    progress.advance(1);
    let plain_ms = times[0];
    let labels = std::iter::once("plain").chain(METHODS.iter().map(|drawn| drawn.label));
    let row = |(label, ms): (&'static str, f64)| Row::new(label, [ms, ms / plain_ms].map(Cell::one).to_vec());
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
        rows: labels.zip(times).map(row).collect(),
        ..Table::default()
    })
}
