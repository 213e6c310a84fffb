//! [`Truths`]: what the scored frames of a mesh are measured against, found once for all cells.

use super::error::CompareError;
use super::frame_source::Output;
use super::subject::Subject;
use crate::metrics::fill::measure_fill;
use crate::metrics::filled_picture::FilledPicture;
use crate::metrics::line_errors::{LineErrors, line_errors, reach_px};
use crate::metrics::lines::{TruePen, measure};
use crate::metrics::{Ink, PictureMetrics};
use crate::picture::difference;
use crate::record::{EdgeScore, MeshRecord, TruthRecord};
use crate::truth::fill::FillTruth;
use crate::truth::sight::sight_ray;
use crate::truth::view_facts::ViewFacts;
use crate::truth::{Truth, TruthFinder};
use silhouette_core::{Camera, Progress, SilhouetteEdges};
use silhouette_gpu::{Pen, PenPlacement};
use silhouette_rays::RayCaster;
use silhouette_render::{Gpu, Image};
use std::collections::HashMap;
use std::sync::OnceLock;

/// The truth of every scored frame of a mesh. That of filled pictures, and that of each placement of the pen, is drawn when a
/// cell first asks for it.
pub struct Truths<'a> {
    subject: &'a Subject,
    /// The mesh, as results name it.
    pub mesh: MeshRecord,
    finder: TruthFinder,
    views: Vec<Truth>,
    facts: Vec<ViewFacts>,
    rays: OnceLock<RayCaster>,
    pens: HashMap<PenPlacement, Vec<Ink>>,
    fills: Vec<FilledPicture>,
}

/// What a picture scored, and pictures of that.
pub struct Scored {
    /// The metrics.
    pub metrics: PictureMetrics,
    /// Where it errs, for a picture of lines.
    pub errors: Option<LineErrors>,
    /// The picture, the truth and their difference, for people.
    pub pictures: [Image; 3],
}

impl<'a> Truths<'a> {
    /// Finds the true lines of every view, and what is known to make methods err there: ink of a pen of `pen_width_px` is
    /// looked up on lines within its reach.
    ///
    /// # Errors
    /// [`CompareError::Truth`], [`CompareError::Cancelled`].
    pub fn find(
        subject: &'a Subject,
        cameras: &[Camera],
        pen_width_px: f64,
        progress: &dyn Progress,
    ) -> Result<Self, CompareError> {
        let mesh = &subject.mesh.mesh;
        let failed = |cause| CompareError::truth(&subject.mesh.name, cause);
        let mut finder = TruthFinder::new(mesh, progress).map_err(failed)?;
        progress.stage(&format!("{}: truth", subject.mesh.name), cameras.len() as u64);
        let (mut views, mut facts) = (Vec::with_capacity(cameras.len()), Vec::with_capacity(cameras.len()));
        for camera in cameras {
            progress.check()?;
            let truth = finder.find(camera, progress).map_err(failed)?;
            facts.push(finder.facts(&truth, reach_px(pen_width_px), progress).map_err(failed)?);
            views.push(truth);
            progress.advance(1);
        }
        let mesh = MeshRecord {
            name: subject.mesh.name.clone(),
            vertices: mesh.mesh().vertex_count(),
            faces: mesh.mesh().face_count(),
            edges: finder.edge_count(),
            inward_faces: finder.inward_faces(),
        };
        Ok(Self { subject, mesh, finder, views, facts, rays: OnceLock::new(), pens: HashMap::new(), fills: Vec::new() })
    }

    /// Draws what pictures of this kind are measured against, unless it is there.
    ///
    /// # Errors
    /// [`CompareError::FillTruth`], [`CompareError::Cancelled`].
    pub fn prepare(&mut self, output: Output, gpu: &Gpu, progress: &dyn Progress) -> Result<(), CompareError> {
        match output {
            Output::Lines(pen) => self.prepare_pen(pen, progress)?,
            Output::Fill if self.fills.is_empty() => {
                let failed = |cause| CompareError::FillTruth { mesh: self.mesh.name.clone(), cause };
                let fine = self.subject.truth.as_ref().unwrap_or(self.subject.mesh.mesh.mesh());
                let mut truth = FillTruth::new(gpu, fine).map_err(failed)?;
                let mut drawn = Vec::with_capacity(self.views.len());
                for view in &self.views {
                    progress.check()?;
                    drawn.push(truth.find(gpu, &view.camera).map_err(failed)?);
                }
                self.fills = drawn;
            }
            Output::Fill => {}
        }
        Ok(())
    }

    /// Draws what pictures of lines are measured against, unless it is there.
    pub(crate) fn prepare_pen(&mut self, pen: Pen, progress: &dyn Progress) -> Result<(), CompareError> {
        if !self.pens.contains_key(&pen.placement) {
            let mut drawn = Vec::with_capacity(self.views.len());
            for view in &self.views {
                progress.check()?;
                drawn.push(view.draw(pen));
            }
            self.pens.insert(pen.placement, drawn);
        }
        Ok(())
    }

    /// The truth of a view, and what finds more lines of it.
    pub(crate) fn view_and_finder(&mut self, view: usize) -> (&Truth, &mut TruthFinder) {
        (&self.views[view], &mut self.finder)
    }

    /// The truth of a view as results state it for pictures of this kind.
    pub fn record(&self, view: usize, output: Output) -> TruthRecord {
        let area = |fill: &FilledPicture| fill.coverage().coverages().iter().map(|&share| f64::from(share)).sum();
        let truth = &self.views[view];
        TruthRecord {
            silhouette_edges: truth.edges.len(),
            visible_length_px: truth.lines.total_length_px(),
            area_px: self.fills.get(view).filter(|_| output == Output::Fill).map(area),
        }
    }

    /// Scores edges found in a view. O(S log S).
    pub fn score_edges(&self, view: usize, found: &SilhouetteEdges) -> EdgeScore {
        let truth = &self.views[view].edges;
        let right = found.iter().filter(|&edge| truth.contains(edge)).count() as f64;
        let share = |whole: usize| if whole == 0 { 1.0 } else { right / whole as f64 };
        EdgeScore { found: found.len(), precision: share(found.len()), recall: share(truth.len()) }
    }

    /// Scores a picture of a view for which [`prepare`](Self::prepare) was called.
    ///
    /// # Panics
    /// If it was not.
    pub fn score(&self, view: usize, output: Output, picture: &Image) -> Scored {
        match output {
            Output::Lines(pen) => self.score_ink(view, pen, &Ink::from_picture(picture), picture.clone()),
            Output::Fill => {
                let (drawn, truth) = (FilledPicture::new(picture.clone()), &self.fills[view]);
                let difference = difference(drawn.coverage(), truth.coverage());
                let metrics = PictureMetrics::Fill(measure_fill(&drawn, truth));
                Scored { metrics, errors: None, pictures: [drawn.to_picture(), truth.to_picture(), difference] }
            }
        }
    }

    /// Scores lines that are shown as `picture`, for a pen that was [prepared](Self::prepare_pen).
    ///
    /// # Panics
    /// If it was not.
    pub(crate) fn score_ink(&self, view: usize, pen: Pen, drawn: &Ink, picture: Image) -> Scored {
        let truth = &self.pens[&pen.placement][view];
        let true_pen = TruePen { picture: truth, width_px: pen.width_px };
        let Truth { camera, lines, .. } = &self.views[view];
        let metrics = PictureMetrics::Lines(measure(drawn, lines, true_pen));
        let rays = self.rays.get_or_init(|| RayCaster::new(self.subject.mesh.mesh.mesh()));
        let seen = |place| {
            let (origin, direction) = sight_ray(camera, place);
            let hit = rays.first(origin, direction.as_vec3(), f64::INFINITY)?;
            Some(self.finder.seen(camera).of_face(hit.face, hit.is_exit))
        };
        let errors = Some(line_errors(drawn, lines, true_pen, &self.facts[view], seen));
        Scored { metrics, errors, pictures: [picture, truth.to_picture(), difference(drawn, truth)] }
    }
}
