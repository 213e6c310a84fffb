//! One mesh: every method that extracts edges, prepared alone, asserted, and timed in turn with the others.

use crate::arguments::Arguments;
use crate::stream_read::StreamRead;
use silhouette_compare::camera_path::Orbit;
use silhouette_compare::cost::Spread;
use silhouette_compare::machine::describe_machine;
use silhouette_compare::registry::{self, BASELINE, EdgeMethod, Entry, Prepared};
use silhouette_compare::scaling::{ExtractionRow, OURS};
use silhouette_core::method::{ExtractionStats, OptionValues, PrepareError};
use silhouette_core::shapes::{ShapeError, by_name};
use silhouette_core::{NoProgress, PreparedMesh, SilhouetteEdges, Topology, TriangleMesh, Viewpoint, load};
use silhouette_extraction::FacePatches;
use std::hint::black_box;
use std::path::Path;
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
    #[error("{mesh}: {source}")]
    Shape { mesh: String, source: ShapeError },
    #[error(transparent)]
    Load(#[from] load::LoadError),
    #[error("{mesh}: the mesh has no triangle")]
    Empty { mesh: String },
    #[error("{mesh}: {source}")]
    Prepare { mesh: String, source: PrepareError },
}

/// Measures every method of the registry that extracts edges, and a plain read, on a mesh.
///
/// # Panics
/// If a method does not find the edges that the [`BASELINE`] finds: what is wrong is not timed.
pub fn measure_mesh(mesh: &str, arguments: &Arguments) -> Result<Vec<ExtractionRow>, MeasureError> {
    let (name, triangles) = load_mesh(mesh)?;
    let Some(bounds) = triangles.bounds() else { return Err(MeasureError::Empty { mesh: name }) };
    let failed = |source| MeasureError::Prepare { mesh: name.clone(), source };
    let triangles = Arc::new(triangles);

    // Each method gets a mesh that nothing was derived from, so that its preparation holds all it needs.
    let mut cells = Vec::new();
    let mut counts = (triangles.face_count() as u64, 0);
    let mut plane_bytes = 0;
    for entry in registry::all() {
        let fresh = Arc::new(PreparedMesh::new(Arc::clone(&triangles)));
        let Some(cell) = Cell::prepare(entry, &fresh).map_err(failed)? else { continue };
        let artefact = |error| failed(PrepareError::Cancelled(error));
        counts.1 = fresh.artefact::<Topology>("bench", &NoProgress).map_err(artefact)?.edge_count() as u64;
        if plane_bytes == 0 && entry.info.needs.contains(&"face-patches") {
            plane_bytes = fresh.artefact::<FacePatches>("bench", &NoProgress).map_err(artefact)?.plane_bytes();
        }
        cells.push(cell);
    }

    let eyes =
        |views| Orbit::eyes(&bounds, views, DISTANCE_RADII).into_iter().map(|eye| Viewpoint::Perspective { eye });
    for view in eyes(ASSERTED_VIEWS) {
        cells.iter_mut().for_each(|cell| cell.extract(&view));
        compare_with_baseline(&mut cells);
    }
    cells.iter_mut().for_each(Cell::forget);

    // A method is called for the view before without being timed, so that it finds its data where its own frame before
    // would have left them, and not where the other methods, run in between, did.
    let views: Vec<Viewpoint> = eyes(arguments.views).collect();
    let stream = StreamRead::new(plane_bytes);
    let mut stream_ms = Vec::with_capacity(views.len());
    for (index, view) in views.iter().enumerate() {
        let before = &views[index.checked_sub(1).unwrap_or(views.len() - 1)];
        for cell in &mut cells {
            cell.extract(before);
            cell.time(view);
        }
        compare_with_baseline(&mut cells);
        black_box(stream.read());
        let start = Instant::now();
        black_box(stream.read());
        stream_ms.push(milliseconds(start));
    }

    let blank = blank_row(&name, counts, arguments);
    let mut rows: Vec<ExtractionRow> = cells.iter().map(|cell| cell.row(&blank)).collect();
    let bytes = stream.bytes() as u64;
    let read = ExtractionRow { tool: STREAM_READ.to_owned(), method: "face-planes".to_owned(), ..blank };
    rows.push(with_times(ExtractionRow { bytes: Some(bytes), ..read }, &stream_ms));
    Ok(rows)
}

fn load_mesh(mesh: &str) -> Result<(String, TriangleMesh), MeasureError> {
    if let Some(shape) = mesh.strip_prefix("builtin:") {
        let shape = by_name(shape).map_err(|source| MeasureError::Shape { mesh: mesh.to_owned(), source })?;
        return Ok((mesh.to_owned(), shape));
    }
    let path = Path::new(mesh);
    let name = path.file_name().map_or_else(|| mesh.to_owned(), |name| name.to_string_lossy().into_owned());
    Ok((name, load::load(path)?))
}

fn milliseconds(start: Instant) -> f64 {
    start.elapsed().as_secs_f64() * 1000.0
}

/// One method on the mesh.
struct Cell {
    entry: &'static Entry,
    method: Box<dyn EdgeMethod>,
    mesh: Arc<PreparedMesh>,
    prepare_ms: f64,
    edges: SilhouetteEdges,
    times_ms: Vec<f64>,
    counts: Vec<f64>,
    stats: Vec<ExtractionStats>,
    /// Edges found, and edges to be found, over all views.
    found: [u64; 2],
}

impl Cell {
    /// `None` for a method that extracts no edges.
    fn prepare(entry: &'static Entry, mesh: &Arc<PreparedMesh>) -> Result<Option<Self>, PrepareError> {
        let start = Instant::now();
        let prepared = entry.prepare(mesh, &OptionValues::defaults(entry.info.options), &NoProgress)?;
        let prepare_ms = milliseconds(start);
        let Prepared::Edges(method) = prepared else { return Ok(None) };
        Ok(Some(Self {
            entry,
            method,
            mesh: Arc::clone(mesh),
            prepare_ms,
            edges: SilhouetteEdges::default(),
            times_ms: Vec::new(),
            counts: Vec::new(),
            stats: Vec::new(),
            found: [0; 2],
        }))
    }

    fn extract(&mut self, view: &Viewpoint) {
        black_box(self.method.extract_edges(black_box(view), &mut self.edges));
    }

    fn time(&mut self, view: &Viewpoint) {
        let start = Instant::now();
        let stats = self.method.extract_edges(black_box(view), &mut self.edges);
        self.times_ms.push(milliseconds(start));
        self.counts.push(self.edges.len() as f64);
        self.stats.push(stats);
    }

    /// Forgets what was counted before timing began.
    fn forget(&mut self) {
        self.found = [0; 2];
    }

    fn row(&self, blank: &ExtractionRow) -> ExtractionRow {
        let artefacts: usize = self.mesh.report().iter().map(|artefact| artefact.bytes).sum();
        let bytes = (self.method.bytes() + artefacts) as u64;
        let mean = |value: fn(&ExtractionStats) -> u64| {
            Some(self.stats.iter().map(|stats| value(stats) as f64).sum::<f64>() / self.stats.len() as f64)
        };
        let [found, expected] = self.found.map(|count| count as f64);
        let row = ExtractionRow {
            method: self.entry.info.name.to_owned(),
            silhouette_edges: Spread::of(&self.counts).map(|spread| spread.median),
            recall: Some(if expected > 0.0 { found / expected } else { 1.0 }),
            prepare_ms: Some(self.prepare_ms),
            bytes: Some(bytes),
            faces_tested: mean(|stats| stats.faces_tested),
            edges_tested: mean(|stats| stats.edges_tested),
            nodes_visited: mean(|stats| stats.nodes_visited),
            exact_fallbacks: mean(|stats| stats.exact_fallbacks),
            ..blank.clone()
        };
        with_times(row, &self.times_ms)
    }
}

/// Holds the last answer of every method against that of the baseline: an exact one must be equal, another may miss edges
/// but never add any.
fn compare_with_baseline(cells: &mut [Cell]) {
    let baseline = cells.iter().position(|cell| cell.entry.info.name == BASELINE).expect("the baseline extracts edges");
    let truth = std::mem::take(&mut cells[baseline].edges);
    for (index, cell) in cells.iter_mut().enumerate() {
        let name = cell.entry.info.name;
        let edges = if index == baseline { &truth } else { &cell.edges };
        assert!(
            !cell.entry.info.exact || *edges == truth,
            "{name} is exact, but its edges are not those of {BASELINE}"
        );
        assert!(edges.iter().all(|edge| truth.contains(edge)), "{name} found edges that are none");
        cell.found[0] += edges.len() as u64;
        cell.found[1] += truth.len() as u64;
    }
    cells[baseline].edges = truth;
}

fn blank_row(mesh: &str, (faces, edges): (u64, u64), arguments: &Arguments) -> ExtractionRow {
    ExtractionRow {
        tool: OURS.to_owned(),
        method: String::new(),
        mesh: mesh.to_owned(),
        faces,
        edges,
        silhouette_edges: None,
        recall: None,
        views: arguments.views,
        threads: arguments.threads,
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

fn with_times(row: ExtractionRow, times_ms: &[f64]) -> ExtractionRow {
    let spread = Spread::of(times_ms).expect("a mesh is measured in at least one view");
    let edges = row.edges as f64;
    ExtractionRow {
        median_ms: spread.median,
        p95_ms: spread.p95,
        edges_per_second: edges / spread.median * 1000.0,
        bytes_per_edge: row.bytes.map(|bytes| bytes as f64 / edges),
        ..row
    }
}
