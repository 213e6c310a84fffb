//! One mesh: every method that extracts edges, prepared alone, asserted, and timed in turn with the others.

use crate::cell::{Cell, compare_with_baseline, milliseconds, with_times};
use crate::stream_read::StreamRead;
use crate::threads::Threads;
use silhouette_compare::LeftOut;
use silhouette_compare::camera_path::Orbit;
use silhouette_compare::machine::describe_machine;
use silhouette_compare::registry;
use silhouette_compare::scaling::{ExtractionRow, OURS};
use silhouette_core::method::PrepareError;
use silhouette_core::{NoProgress, Topology, TriangleMesh, Viewpoint};
use silhouette_extraction::FacePatches;
use std::hint::black_box;
use std::sync::Arc;
use std::time::Instant;

/// Distance of the eyes from the centre, in radii of the bounding sphere.
const DISTANCE_RADII: f64 = 3.0;

/// Views of which the answers are asserted before anything is timed.
const ASSERTED_VIEWS: u32 = 8;

/// Tool of the rows of a plain read.
pub const STREAM_READ: &str = "stream-read";

/// Why a mesh was not measured.
#[derive(Debug, thiserror::Error)]
pub enum MeasureError {
    #[error("{mesh}: the mesh has no triangle")]
    Empty { mesh: String },
    #[error("{mesh}: {source}")]
    Prepare { mesh: String, source: PrepareError },
}

/// What was measured on a mesh.
pub struct Measured {
    pub rows: Vec<ExtractionRow>,
    /// Methods that are not defined for it.
    pub left_out: Vec<LeftOut>,
}

/// Measures every method of the registry that extracts edges, and a plain read, on a mesh in `views` views, 1 or more,
/// with each number of threads. Rows of one number of threads follow each other.
///
/// # Panics
/// If a method does not find the edges that the [`BASELINE`](registry::BASELINE) finds: what is wrong is not timed.
pub fn measure_mesh(
    name: &str,
    triangles: TriangleMesh,
    views: u32,
    all_threads: &[Threads],
) -> Result<Measured, MeasureError> {
    let Some(bounds) = triangles.bounds() else { return Err(MeasureError::Empty { mesh: name.to_owned() }) };
    let failed = |source| MeasureError::Prepare { mesh: name.to_owned(), source };
    let triangles = Arc::new(triangles);

    let (mut cells, mut left_out) = (Vec::new(), Vec::new());
    let (mut edges, mut plane_bytes) = (0, 0);
    for entry in registry::Registry::builtin().entries() {
        let cell = match Cell::prepare(entry, &triangles, all_threads) {
            Ok(Some(cell)) => cell,
            Ok(None) => continue,
            Err(PrepareError::Mesh(reason)) => {
                let (mesh, method) = (name.to_owned(), entry.info().name);
                left_out.push(LeftOut { mesh, method: method.to_owned(), reason: reason.to_string() });
                continue;
            }
            Err(other) => return Err(failed(other)),
        };
        let artefact = |error| failed(PrepareError::Cancelled(error));
        edges = cell.mesh.artefact::<Topology>("bench", &NoProgress).map_err(artefact)?.edge_count() as u64;
        if plane_bytes == 0 && entry.info().needs.contains(&"face-patches") {
            plane_bytes = cell.mesh.artefact::<FacePatches>("bench", &NoProgress).map_err(artefact)?.plane_bytes();
        }
        cells.push(cell);
    }

    let eyes =
        |views| Orbit::eyes(&bounds, views, DISTANCE_RADII).into_iter().map(|eye| Viewpoint::Perspective { eye });
    for view in eyes(ASSERTED_VIEWS) {
        for (run, threads) in all_threads.iter().enumerate() {
            threads.install(|| cells.iter_mut().for_each(|cell| cell.extract(run, &view)));
        }
        compare_with_baseline(&mut cells);
    }
    cells.iter_mut().for_each(Cell::forget);

    let views: Vec<Viewpoint> = eyes(views).collect();
    let stream = StreamRead::new(plane_bytes);
    let stream_ms = measure_views(&views, all_threads, &mut cells, &stream);

    let blank = blank_row(name, [triangles.face_count() as u64, edges], views.len() as u32);
    let rows = all_threads.iter().zip(&stream_ms).enumerate().flat_map(|(run, (threads, stream_ms))| {
        let blank = ExtractionRow { threads: threads.count, ..blank.clone() };
        let read = ExtractionRow {
            tool: STREAM_READ.to_owned(),
            method: "face-planes".to_owned(),
            bytes: Some(stream.bytes() as u64),
            ..blank.clone()
        };
        let read = with_times(read, stream_ms);
        cells.iter().map(|cell| cell.row(run, &blank)).chain([read]).collect::<Vec<_>>()
    });
    Ok(Measured { rows: rows.collect(), left_out })
}

/// Times all methods and the plain read, view by view; yields the milliseconds of the read for each number of threads.
///
/// A method is called for the view before without being timed, so that it finds its data where its own frame before
/// would have left them, and not where the other methods, run in between, did. The number of threads that comes first
/// changes from view to view, so that none is always the one behind an idle or a busy moment.
fn measure_views(
    views: &[Viewpoint],
    all_threads: &[Threads],
    cells: &mut [Cell],
    stream: &StreamRead,
) -> Vec<Vec<f64>> {
    let mut stream_ms = vec![Vec::with_capacity(views.len()); all_threads.len()];
    for (index, view) in views.iter().enumerate() {
        let before = &views[index.checked_sub(1).unwrap_or(views.len() - 1)];
        let runs = (0..all_threads.len()).map(|turn| (index + turn) % all_threads.len());
        for cell in cells.iter_mut() {
            for run in runs.clone() {
                all_threads[run].install(|| {
                    cell.extract(run, before);
                    cell.time(run, view);
                });
            }
        }
        compare_with_baseline(cells);
        for run in runs {
            stream_ms[run].push(all_threads[run].install(|| {
                black_box(stream.read());
                let start = Instant::now();
                black_box(stream.read());
                milliseconds(start)
            }));
        }
    }
    stream_ms
}

fn blank_row(mesh: &str, [faces, edges]: [u64; 2], views: u32) -> ExtractionRow {
    ExtractionRow {
        tool: OURS.to_owned(),
        method: String::new(),
        mesh: mesh.to_owned(),
        faces,
        edges,
        silhouette_edges: None,
        recall: None,
        views,
        threads: 1,
        median_ms: 0.0,
        p95_ms: 0.0,
        edges_per_second: 0.0,
        prepare_ms: None,
        bytes: None,
        bytes_per_edge: None,
        faces_tested: None,
        edges_tested: None,
        nodes_visited: None,
        exact_fallbacks: None,
        machine: describe_machine(),
    }
}
