//! One method on one mesh: prepared alone, called and timed with each number of threads.

use crate::threads::Threads;
use silhouette_compare::cost::Spread;
use silhouette_compare::registry::{BASELINE, Entry};
use silhouette_compare::scaling::ExtractionRow;
use silhouette_core::method::{ExtractionStats, OptionValues, PrepareError};
use silhouette_core::{ExtractsEdges, NoProgress, PreparedMesh, SilhouetteEdges, TriangleMesh, Viewpoint};
use std::hint::black_box;
use std::sync::Arc;
use std::time::Instant;

pub fn milliseconds(start: Instant) -> f64 {
    start.elapsed().as_secs_f64() * 1000.0
}

/// One method on the mesh.
pub struct Cell {
    pub entry: Entry,
    method: Box<dyn ExtractsEdges>,
    /// What the prepared method holds beyond the artefacts of its mesh.
    method_bytes: usize,
    /// What the method's preparation asked for, and nothing else's.
    pub mesh: Arc<PreparedMesh>,
    /// One for each number of threads.
    runs: Vec<Run>,
}

/// What was measured with one number of threads.
#[derive(Default)]
struct Run {
    prepare_ms: f64,
    edges: SilhouetteEdges,
    times_ms: Vec<f64>,
    counts: Vec<f64>,
    stats: Vec<ExtractionStats>,
    /// Edges found, and edges to be found, over all views.
    found: [u64; 2],
}

impl Cell {
    /// Prepares the method with each number of threads in turn, of a mesh that nothing was derived from, so that the
    /// preparation holds all it needs. The last one stays and serves all: results do not depend on threads, and two would
    /// need twice the memory. `None` for a method that extracts no edges.
    pub fn prepare(
        entry: &Entry,
        triangles: &Arc<TriangleMesh>,
        all_threads: &[Threads],
    ) -> Result<Option<Self>, PrepareError> {
        let mut last = None;
        let mut runs = Vec::new();
        for threads in all_threads {
            drop(last.take());
            let mesh = Arc::new(PreparedMesh::new(Arc::clone(triangles)));
            let (prepared, prepare_ms) = threads.install(|| {
                let start = Instant::now();
                let prepared = entry.prepare(&mesh, &OptionValues::defaults(entry.info().options), &NoProgress);
                (prepared, milliseconds(start))
            });
            let prepared = prepared?;
            let bytes = prepared.bytes();
            let Some(method) = prepared.into_edges() else { return Ok(None) };
            last = Some((method, bytes, mesh));
            runs.push(Run { prepare_ms, ..Run::default() });
        }
        let entry = entry.clone();
        Ok(last.map(|(method, method_bytes, mesh)| Self { entry, method, method_bytes, mesh, runs }))
    }

    /// Extracts on the current threads, as a call of run `index`.
    pub fn extract(&mut self, index: usize, view: &Viewpoint) {
        black_box(self.method.extract_edges(black_box(view), &mut self.runs[index].edges));
    }

    /// The same, timed and counted.
    pub fn time(&mut self, index: usize, view: &Viewpoint) {
        let run = &mut self.runs[index];
        let start = Instant::now();
        let stats = self.method.extract_edges(black_box(view), &mut run.edges);
        run.times_ms.push(milliseconds(start));
        run.counts.push(run.edges.len() as f64);
        run.stats.push(stats);
    }

    /// Forgets what was counted before timing began.
    pub fn forget(&mut self) {
        self.runs.iter_mut().for_each(|run| run.found = [0; 2]);
    }

    /// The row of run `index`; `blank` has what all rows of the mesh and of this number of threads share.
    pub fn row(&self, index: usize, blank: &ExtractionRow) -> ExtractionRow {
        let run = &self.runs[index];
        let artefacts: usize = self.mesh.report().iter().map(|artefact| artefact.bytes).sum();
        let bytes = (self.method_bytes + artefacts) as u64;
        let mean = |value: fn(&ExtractionStats) -> u64| {
            Some(run.stats.iter().map(|stats| value(stats) as f64).sum::<f64>() / run.stats.len() as f64)
        };
        let [found, expected] = run.found.map(|count| count as f64);
        let row = ExtractionRow {
            method: self.entry.info().name.to_owned(),
            silhouette_edges: Spread::of(&run.counts).map(|spread| spread.median),
            recall: Some(if expected > 0.0 { found / expected } else { 1.0 }),
            prepare_ms: Some(run.prepare_ms),
            bytes: Some(bytes),
            faces_tested: mean(|stats| stats.faces_tested),
            edges_tested: mean(|stats| stats.edges_tested),
            nodes_visited: mean(|stats| stats.nodes_visited),
            exact_fallbacks: mean(|stats| stats.exact_fallbacks),
            ..blank.clone()
        };
        with_times(row, &run.times_ms)
    }
}

/// A row with what its times say.
pub fn with_times(row: ExtractionRow, times_ms: &[f64]) -> ExtractionRow {
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

/// Holds the last answer of every method, with every number of threads, against that of the baseline: an exact one must
/// be equal, another may miss edges but never add any.
///
/// # Panics
/// If that is not so.
pub fn compare_with_baseline(cells: &mut [Cell]) {
    let baseline =
        cells.iter().position(|cell| cell.entry.info().name == BASELINE).expect("the baseline extracts edges");
    let truth = std::mem::take(&mut cells[baseline].runs[0].edges);
    for (place, cell) in cells.iter_mut().enumerate() {
        let name = cell.entry.info().name;
        for (index, run) in cell.runs.iter_mut().enumerate() {
            let edges = if (place, index) == (baseline, 0) { &truth } else { &run.edges };
            assert!(
                !cell.entry.info().exact || *edges == truth,
                "{name} is exact, but its edges are not those of {BASELINE}"
            );
            assert!(edges.iter().all(|edge| truth.contains(edge)), "{name} found edges that are none");
            run.found[0] += edges.len() as u64;
            run.found[1] += truth.len() as u64;
        }
    }
    cells[baseline].runs[0].edges = truth;
}
