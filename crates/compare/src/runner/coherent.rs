//! [`CoherenceBench`]: motions followed frame by frame, after the timed path and outside of its clock.

use super::coherence_truth::true_sequence;
use super::error::CompareError;
use super::frame_source::{FrameSource, Output};
use super::subject::Subject;
use crate::camera_path::Orbit;
use crate::coherence::metrics::{measure, observe};
use crate::coherence::{DrawnFrame, Motion, Observation, Sequence, TrueFrame};
use crate::drawing::DrawError;
use crate::metrics::{FilledPicture, Ink, PictureKind};
use crate::record::CoherenceRecord;
use crate::scene::CoherenceSpec;
use crate::truth::visible::VisibleLine;
use silhouette_core::glam::Vec3;
use silhouette_core::mesh::Bounds;
use silhouette_core::{PreparedMesh, Progress};
use silhouette_render::Gpu;
use std::collections::BTreeMap;
use std::sync::Arc;

/// A mesh with the truth of its motions, found once for all cells.
pub struct CoherenceBench<'a> {
    subject: &'a Subject,
    spec: &'a CoherenceSpec,
    orbit: Orbit,
    bounds: Bounds,
    /// By motion, and whether it is the truth of a mesh that another stands for.
    sequences: BTreeMap<(Motion, bool), Sequence>,
}

/// A motion as a method is led along it.
struct Leg<'a> {
    motion: Motion,
    bounds: Bounds,
    rest: &'a [Vec3],
    sequence: &'a Sequence,
}

impl<'a> CoherenceBench<'a> {
    /// A bench for a mesh with these bounds; nothing is found yet.
    pub fn new(subject: &'a Subject, spec: &'a CoherenceSpec, orbit: Orbit, bounds: Bounds) -> Self {
        Self { subject, spec, orbit, bounds, sequences: BTreeMap::new() }
    }

    /// Follows every motion of the scene, those of the mesh last, and measures what is drawn.
    ///
    /// # Errors
    /// [`CompareError`].
    pub fn run(
        &mut self,
        source: &mut dyn FrameSource,
        method: &str,
        gpu: &Gpu,
        progress: &dyn Progress,
    ) -> Result<Vec<CoherenceRecord>, CompareError> {
        let kind = source.output().kind();
        let mut records = Vec::new();
        for motion in Motion::ALL.into_iter().filter(|motion| self.spec.motions.contains(motion)) {
            let of_other = kind == PictureKind::Fill && self.subject.truth.is_some();
            self.find(motion, of_other, progress)?;
            let name = &self.subject.mesh.name;
            progress.stage(&format!("{name}: {method}, {}", motion.name()), self.spec.frames.into());
            let mesh = self.subject.mesh.mesh.mesh();
            let sequence = &self.sequences[&(motion, of_other)];
            let leg = Leg { motion, bounds: self.bounds, rest: mesh.positions(), sequence };
            let failed = |source| CompareError::draw(name, method, source);
            let observations = leg.follow(source, gpu, progress).map_err(failed)?;
            let metrics = observations.map(|observations| measure(sequence, &observations, kind));
            records.push(CoherenceRecord { motion, frames: self.spec.frames, metrics });
        }
        Ok(records)
    }

    /// Finds the truth of a motion, unless it is there.
    fn find(&mut self, motion: Motion, of_other: bool, progress: &dyn Progress) -> Result<(), CompareError> {
        let name = &self.subject.mesh.name;
        if self.sequences.contains_key(&(motion, of_other)) {
            return Ok(());
        }
        let failed = |cause| CompareError::View { mesh: name.clone(), cause };
        let cameras = motion.cameras(&self.orbit, &self.bounds, self.spec.frames).map_err(failed)?;
        let mesh = match self.subject.truth.as_ref().filter(|_| of_other) {
            Some(truth) => Arc::new(PreparedMesh::new(Arc::clone(truth))),
            None => Arc::clone(&self.subject.mesh.mesh),
        };
        progress.stage(&format!("{name}: truth, {}", motion.name()), cameras.len() as u64);
        let sequence = true_sequence(&mesh, &self.bounds, motion, &cameras, progress);
        let sequence = sequence.map_err(|source| CompareError::truth(name, source))?;
        self.sequences.insert((motion, of_other), sequence);
        Ok(())
    }
}

impl Leg<'_> {
    /// Draws every frame and observes it; `None` for a method that cannot follow the mesh.
    fn follow(
        &self,
        source: &mut dyn FrameSource,
        gpu: &Gpu,
        progress: &dyn Progress,
    ) -> Result<Option<Vec<Vec<Observation>>>, DrawError> {
        let mut observations = Vec::with_capacity(self.sequence.frames.len());
        let before = source.warning();
        for (at, frame) in (0..).zip(&self.sequence.frames) {
            progress.check()?;
            if let Some(positions) = self.motion.positions(self.rest, &self.bounds, at)
                && !source.move_to(gpu, &positions)
            {
                return Ok(None);
            }
            source.draw(gpu, &frame.camera)?;
            // A method that goes on to draw the mesh at rest says so.
            if self.motion.moves_mesh() && source.warning().is_some_and(|warning| Some(warning) != before) {
                return Ok(None);
            }
            observations.push(observe(frame, &drawn(source, gpu, frame)?));
            progress.advance(1);
        }
        Ok(Some(observations))
    }
}

/// What was drawn last: of a method that extracts edges those that are visible, of any other its picture.
fn drawn(source: &dyn FrameSource, gpu: &Gpu, frame: &TrueFrame) -> Result<DrawnFrame, DrawError> {
    if let Some(edges) = source.edges() {
        let segments = frame.visible.iter().flat_map(VisibleLine::segments);
        let found = segments.filter(|(edge, _)| edges.contains(*edge)).map(|(_, ends)| ends);
        return Ok(DrawnFrame::lines(found, frame.camera.size()[1]));
    }
    let picture = source.picture(gpu)?;
    Ok(match source.output() {
        Output::Lines(_) => DrawnFrame::Picture(Ink::from_picture(&picture)),
        Output::Fill => DrawnFrame::boundary(FilledPicture::new(picture).coverage()),
    })
}
