//! [`LoopMeter`]: methods that extract loops, measured against all silhouette edges by Hall's definition. Needs no device.

use super::candidates::Candidate;
use super::meter::{Fault, Meter, Preparation, Sample, Until};
use super::views::{Setting, ViewId, run_up};
use crate::cost::PrepareCost;
use crate::record::ArtefactRecord;
use crate::registry::Prepared;
use crate::runner::{CompareError, NamedMesh};
use silhouette_core::mesh::Bounds;
use silhouette_core::method::PrepareError;
use silhouette_core::{
    Camera, EdgeId, FaceFacings, PreparedMesh, Progress, SilhouetteEdges, SilhouetteLoops, Topology,
};
use std::sync::Arc;
use std::time::Instant;

/// How the edges of loops differ from the silhouette edges, in numbers of edges.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct EdgeErrors {
    /// Silhouette edges.
    pub all: usize,
    /// Silhouette edges that no loop holds.
    pub missed: usize,
    /// Edges of loops that are no silhouette edges.
    pub wrong: usize,
}

impl EdgeErrors {
    /// The edges of loops, each once, against all silhouette edges. O(S log S).
    pub fn of(found: &SilhouetteEdges, all: &SilhouetteEdges) -> Self {
        let right = found.iter().filter(|&edge| all.contains(edge)).count();
        Self { all: all.len(), missed: all.len() - right, wrong: found.len() - right }
    }

    /// The values of [`LOOP_METRICS`](super::goal::LOOP_METRICS); of a view without silhouette edges every wrong one counts 1.
    pub fn values(&self) -> [f64; 3] {
        [self.missed + self.wrong, self.missed, self.wrong].map(|count| count as f64 / self.all.max(1) as f64)
    }
}

/// Extracts loops of a mesh by any candidate.
pub struct LoopMeter<'a> {
    mesh: &'a NamedMesh,
    candidates: &'a [Candidate],
    setting: Setting,
    bounds: Bounds,
    topology: Arc<Topology>,
    facings: FaceFacings,
    progress: &'a dyn Progress,
    start: Instant,
    prepared: Option<Prepared>,
    loops: SilhouetteLoops,
}

impl<'a> LoopMeter<'a> {
    /// Prepares the truth: topology. O(F).
    ///
    /// # Errors
    /// [`CompareError::EmptyMesh`], [`CompareError::Cancelled`].
    pub fn new(
        mesh: &'a NamedMesh,
        candidates: &'a [Candidate],
        setting: Setting,
        progress: &'a dyn Progress,
    ) -> Result<Self, CompareError> {
        let start = Instant::now();
        let bounds = mesh.mesh.mesh().bounds().ok_or_else(|| CompareError::EmptyMesh { mesh: mesh.name.clone() })?;
        let topology: Arc<Topology> = mesh.mesh.artefact("recommendation", progress)?;
        Ok(Self {
            mesh,
            candidates,
            setting,
            bounds,
            topology,
            facings: FaceFacings::default(),
            progress,
            start,
            prepared: None,
            loops: SilhouetteLoops::default(),
        })
    }

    /// How the loops found last differ from the truth of a view.
    fn errors(&mut self, camera: &Camera) -> EdgeErrors {
        self.facings.classify(self.mesh.mesh.mesh(), &camera.viewpoint());
        let all = SilhouetteEdges::of(&self.topology, &self.facings);
        let mut edges: Vec<EdgeId> =
            self.loops.half_edges().iter().map(|&half_edge| self.topology.edge_of(half_edge)).collect();
        edges.sort_unstable();
        edges.dedup();
        let mut found = SilhouetteEdges::default();
        found.refill_ascending(edges);
        EdgeErrors::of(&found, &all)
    }
}

impl Meter for LoopMeter<'_> {
    fn prepare(&mut self, candidate: usize, until_s: f64) -> Result<Preparation, Fault> {
        self.prepared = None;
        let Candidate { entry, options, .. } = &self.candidates[candidate];
        let until = Until::new(self.progress, self.start, until_s);
        let fresh = Arc::new(self.mesh.mesh.fresh());
        let start = Instant::now();
        let mut prepared = entry.prepare(&fresh, options, &until).map_err(|error| match error {
            PrepareError::Cancelled(cancelled) => until.fault(cancelled),
            error => Fault::Refused(error.to_string()),
        })?;
        let prepare_ms = start.elapsed().as_secs_f64() * 1000.0;
        if prepared.loops().is_none() {
            return Err(Fault::Refused("the method extracts no loops".to_owned()));
        }
        let preparation = preparation(&fresh, prepared.bytes(), prepare_ms, 0.0);
        self.prepared = Some(prepared);
        Ok(preparation)
    }

    fn sample(&mut self, candidate: usize, view: ViewId, _until_s: f64) -> Result<Sample, Fault> {
        self.progress.check().map_err(CompareError::from)?;
        let failed = |cause| CompareError::View { mesh: self.mesh.name.clone(), cause };
        let run_up = run_up(&self.candidates[candidate].entry);
        let cameras = view.cameras(run_up, &self.setting, &self.bounds).map_err(failed)?;
        let method = self.prepared.as_mut().and_then(Prepared::loops);
        let Some(method) = method else { return Err(Fault::Refused("the method is not prepared".to_owned())) };
        let mut ms = 0.0;
        for camera in &cameras {
            let viewpoint = camera.viewpoint();
            let start = Instant::now();
            method.extract_loops(&viewpoint, &mut self.loops);
            ms = start.elapsed().as_secs_f64() * 1000.0;
        }
        let camera = cameras[cameras.len() - 1];
        Ok(Sample { ms, errors: self.errors(&camera).values().to_vec() })
    }

    fn elapsed_s(&self) -> f64 {
        self.start.elapsed().as_secs_f64()
    }
}

/// What preparing a method on a fresh mesh made.
pub(super) fn preparation(fresh: &PreparedMesh, own_bytes: usize, prepare_ms: f64, renderer_ms: f64) -> Preparation {
    let report = fresh.report();
    let bytes = own_bytes + report.iter().map(|artefact| artefact.bytes).sum::<usize>();
    Preparation {
        cost: PrepareCost { prepare_ms, renderer_ms, bytes: bytes as u64 },
        artefacts: report.iter().map(ArtefactRecord::from).collect(),
        own_bytes: own_bytes as u64,
    }
}
