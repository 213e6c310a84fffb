//! Every method against the exact visible lines.

use super::methods::{Drawn, METHODS, builtin};
use crate::directions::spread;
use crate::drawings::{FOV_Y_RAD, camera};
use crate::error::{Cause, PaperError};
use crate::paper::Run;
use crate::table::{Cell, Column, Range, Row, Table};
use silhouette_compare::NamedMesh;
use silhouette_compare::metrics::{Ink, LineMetrics, TruePen, measure};
use silhouette_compare::truth::{Truth, TruthFinder};
use silhouette_core::{PreparedMesh, Progress};
use silhouette_gpu::{Pen, PenPlacement};
use silhouette_render::Gpu;
use std::collections::HashMap;
use std::sync::Arc;

/// Shapes of hard edges: all corners of a right angle, an apex, rims around a hole, a sheet, and a plate that is nearly one.
pub const HARD_EDGES: [&str; 5] = ["cube", "cone", "ring", "grid:1,1", "cube:2,2,0.02"];

/// What ranges are over.
const OVER_VIEWS: &str = "views spread evenly";

/// A table of every mesh, and of every shape of hard edges.
///
/// # Errors
/// [`PaperError`]: cancelled, or a device that failed.
pub fn by_mesh(gpu: &Gpu, run: &Run<'_>, views: u32, size: [u32; 2]) -> Result<Vec<Table>, PaperError> {
    let hard_edges = HARD_EDGES.iter().map(|name| builtin(name)).collect::<Result<Vec<_>, _>>()?;
    let of = |named: &NamedMesh| {
        of_mesh(gpu, named, views, size, run.progress).map_err(PaperError::of::<Cause>(&named.name))
    };
    run.meshes.iter().chain(&hard_edges).map(of).collect()
}

fn of_mesh(gpu: &Gpu, named: &NamedMesh, views: u32, size: [u32; 2], progress: &dyn Progress) -> Result<Table, Cause> {
    progress.stage(&format!("{}: lines", named.name), METHODS.len() as u64);
    let mut views = views_of(&named.mesh, views, size, progress)?;
    let mut rows = Vec::new();
    for drawn in METHODS {
        rows.push(row(&drawn, &scores(gpu, &named.mesh, &drawn, &mut views, size, progress)?));
        progress.advance(1);
    }
    let length_px: f64 = views.iter().map(|view| view.truth.lines.total_length_px()).sum();
    Ok(Table {
        name: "accuracy",
        subject: named.name.clone(),
        about: format!("{} views, {:.0} px of visible lines each", views.len(), length_px / views.len() as f64),
        columns: columns(),
        rows,
        ..Table::default()
    })
}

/// One view, what is true of it, and that truth as drawn by the pens of methods.
struct View {
    truth: Truth,
    pens: HashMap<PenPlacement, Ink>,
}

fn views_of(mesh: &Arc<PreparedMesh>, count: u32, size: [u32; 2], progress: &dyn Progress) -> Result<Vec<View>, Cause> {
    let mut finder = TruthFinder::new(mesh, progress)?;
    let view = |direction| -> Result<View, Cause> {
        let camera = camera(mesh.mesh(), direction, FOV_Y_RAD, size)?;
        Ok(View { truth: finder.find(&camera, progress)?, pens: HashMap::new() })
    };
    spread(count).map(view).collect()
}

/// The scores of a method in every view.
fn scores(
    gpu: &Gpu,
    mesh: &Arc<PreparedMesh>,
    drawn: &Drawn,
    views: &mut [View],
    size: [u32; 2],
    progress: &dyn Progress,
) -> Result<Vec<LineMetrics>, Cause> {
    let mut drawing = drawn.drawing(gpu, mesh, "", size, progress)?;
    let mut score = |View { truth, pens }: &mut View| -> Result<LineMetrics, Cause> {
        progress.check()?;
        drawing.draw(gpu, &truth.camera)?;
        let ink = Ink::from_picture(&drawing.picture(gpu)?);
        let pen @ Pen { width_px, placement } = drawing.pen();
        let picture = pens.entry(placement).or_insert_with(|| truth.draw(pen));
        Ok(measure(&ink, &truth.lines, TruePen { picture, width_px }))
    };
    views.iter_mut().map(&mut score).collect()
}

fn columns() -> Vec<Column> {
    let percent = |title, metric, meaning| Column::new(title, metric, "%", meaning);
    vec![
        percent("missed", "missed at 1 px", "visible length without ink within 1 px"),
        percent("spurious", "spurious at 1 px", "ink farther than 1 px from the true pen"),
        Column {
            digits: 1,
            ..percent("closed", "closed corners", "corners at which the pen's join is inked altogether")
        },
        Column::new("width", "mean width", "px", "mean width of the drawn lines where they are drawn"),
        Column::new("deviation", "deviation of width", "px", "standard deviation of that width"),
        Column::new("gaps", "gaps", "per 1000 px", "stretches longer than 1 px without ink"),
    ]
}

fn row(drawn: &Drawn, scores: &[LineMetrics]) -> Row {
    let values: [fn(&LineMetrics) -> f64; 6] = [
        |metrics| 100.0 * metrics.missed_1px,
        |metrics| 100.0 * metrics.spurious_1px,
        |metrics| 100.0 * metrics.closed_corners,
        |metrics| metrics.width_mean_px,
        |metrics| metrics.width_deviation_px,
        |metrics| metrics.gaps_per_1000px,
    ];
    let cells = values.map(|value| Cell::range(Range::of(scores.iter().map(value), OVER_VIEWS)));
    Row::new(drawn.label, cells.to_vec())
}
