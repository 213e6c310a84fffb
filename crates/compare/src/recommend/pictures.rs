//! [`PictureMeter`]: frames of lines or filled pictures, timed, read back and compared with the truth of their cameras.

use super::candidates::Candidate;
use super::goal::{ErrorMetric, Goal};
use super::meter::{Fault, Meter, Preparation, Sample, Until};
use super::true_pictures::TruePictures;
use super::views::{Purpose, Setting, ViewId, run_up};
use crate::drawing::afresh::Afresh;
use crate::drawing::{DrawError, Drawing, FrameStyle, Ground};
use crate::metrics::{PictureKind, PictureMetrics, find};
use crate::record::ArtefactRecord;
use crate::runner::{CompareError, NamedMesh};
use silhouette_core::method::PrepareError;
use silhouette_core::{Camera, Progress};
use silhouette_render::Gpu;
use std::time::Instant;

/// Draws frames of a mesh by any candidate.
pub struct PictureMeter<'a> {
    mesh: &'a NamedMesh,
    kind: PictureKind,
    metrics: Vec<ErrorMetric>,
    candidates: &'a [Candidate],
    setting: Setting,
    gpu: &'a Gpu,
    progress: &'a dyn Progress,
    start: Instant,
    truths: TruePictures<'a>,
    drawing: Option<Drawing>,
}

impl<'a> PictureMeter<'a> {
    /// Prepares for lines or filled pictures; `None` for a goal without pictures. The truth is found view by view.
    ///
    /// # Errors
    /// [`CompareError::EmptyMesh`].
    pub fn new(
        mesh: &'a NamedMesh,
        goal: Goal,
        candidates: &'a [Candidate],
        setting: Setting,
        gpu: &'a Gpu,
        progress: &'a dyn Progress,
    ) -> Result<Option<Self>, CompareError> {
        let start = Instant::now();
        let Some(kind) = goal.picture() else { return Ok(None) };
        let truths = TruePictures::new(mesh, setting, gpu)?;
        let (metrics, drawing) = (goal.metrics(), None);
        Ok(Some(Self { mesh, kind, metrics, candidates, setting, gpu, progress, start, truths, drawing }))
    }

    fn errors(&self, metrics: &PictureMetrics) -> Vec<f64> {
        let value = |metric: &ErrorMetric| find(metric.name).and_then(|spec| (spec.value)(metrics));
        // `Goal::metrics` names none that this build does not measure.
        self.metrics.iter().map(|metric| value(metric).unwrap_or(f64::INFINITY)).collect()
    }

    fn cameras(&self, candidate: usize, view: ViewId) -> Result<Vec<Camera>, CompareError> {
        let run_up = run_up(&self.candidates[candidate].entry);
        let failed = |cause| CompareError::View { mesh: self.mesh.name.clone(), cause };
        view.cameras(run_up, &self.setting, self.truths.bounds()).map_err(failed)
    }
}

/// A failing candidate's fault: only a cancellation concerns more than the candidate.
fn fault(error: DrawError, until: &Until<'_>) -> Fault {
    match error {
        DrawError::Prepare(PrepareError::Cancelled(cancelled)) => until.fault(cancelled),
        error => Fault::Refused(error.to_string()),
    }
}

impl Meter for PictureMeter<'_> {
    fn set_up(&mut self, until_s: f64) -> Result<(), Fault> {
        let until = Until::new(self.progress, self.start, until_s);
        let failed = |cause| CompareError::View { mesh: self.mesh.name.clone(), cause };
        let view = ViewId { purpose: Purpose::Choice, index: 0 };
        let cameras = view.cameras(0, &self.setting, self.truths.bounds()).map_err(failed)?;
        self.truths.set_up(self.kind, (view, &cameras[0]), &until)
    }

    fn prepare(&mut self, candidate: usize, until_s: f64) -> Result<Preparation, Fault> {
        self.drawing = None;
        let until = Until::new(self.progress, self.start, until_s);
        let Candidate { entry, options, .. } = &self.candidates[candidate];
        let Setting { size, samples, pen_width_px, .. } = self.setting;
        let style = FrameStyle { size, pen_width_px, samples, ground: Ground::measured(self.kind) };
        let afresh = Afresh::prepare(self.gpu, &self.mesh.mesh, (entry, options), self.kind, style, &until);
        let Afresh { mut drawing, cost, artefacts, own_bytes } = afresh.map_err(|error| fault(error, &until))?;
        // Drivers finish pipelines when they are first drawn with.
        let warm_up = self.cameras(candidate, ViewId { purpose: Purpose::Choice, index: 0 })?;
        drawing.draw(self.gpu, &warm_up[0]).map_err(|error| fault(error, &until))?;
        self.drawing = Some(drawing);
        let artefacts = artefacts.iter().map(ArtefactRecord::from).collect();
        Ok(Preparation { cost, artefacts, own_bytes: own_bytes as u64 })
    }

    fn sample(&mut self, candidate: usize, view: ViewId, until_s: f64) -> Result<Sample, Fault> {
        let until = Until::new(self.progress, self.start, until_s);
        until.check().map_err(|cancelled| until.fault(cancelled))?;
        let cameras = self.cameras(candidate, view)?;
        let camera = cameras[cameras.len() - 1];
        let Some(drawing) = &mut self.drawing else {
            return Err(Fault::Refused("the method is not prepared".to_owned()));
        };
        let mut draw = || {
            for camera in &cameras[..cameras.len() - 1] {
                drawing.pass_by(self.gpu, camera)?;
            }
            let sample = drawing.draw(self.gpu, &camera)?;
            Ok((sample.frame_ms, drawing.picture(self.gpu)?))
        };
        let (ms, picture) = draw().map_err(|error| fault(error, &until))?;
        let output = match self.kind {
            PictureKind::Lines => Some(drawing.pen()),
            PictureKind::Fill => None,
        };
        let metrics = self.truths.score((view, &camera), output, picture, &until)?;
        Ok(Sample { ms, errors: self.errors(&metrics) })
    }

    fn elapsed_s(&self) -> f64 {
        self.start.elapsed().as_secs_f64()
    }
}
