//! [`Measuring`]: pictures on screen against the truth of their views, beside the window.

use crate::background::{Died, Stage, Wake, Worker};
use crate::pane::Pane;
use eframe::egui::{Color32, ColorImage};
use silhouette_compare::metrics::filled_picture::FilledPicture;
use silhouette_compare::metrics::lines::{TruePen, measure};
use silhouette_compare::metrics::{Ink, PictureKind, PictureMetrics, fill::measure_fill};
use silhouette_compare::picture::{MISSED, SPURIOUS, difference};
use silhouette_compare::runner::NamedMesh;
use silhouette_compare::truth::fill::FillTruth;
use silhouette_compare::truth::{Truth, TruthFinder};
use silhouette_core::{Camera, Progress};
use silhouette_gpu::Pen;
use silhouette_render::{Gpu, Image};
use silhouettes::application::Failure;
use std::sync::Arc;

/// A picture of a pane.
#[derive(Debug, Clone)]
pub struct Shot {
    /// Which pane's.
    pub pane: usize,
    /// Which frame of the pane.
    pub frame: u64,
    /// The view.
    pub camera: Camera,
    /// The pen of its lines.
    pub pen: Pen,
    /// What it shows.
    pub kind: PictureKind,
    /// The picture.
    pub picture: Arc<Image>,
}

/// What a picture scored.
#[derive(Debug, Clone)]
pub struct Score {
    /// Which pane's.
    pub pane: usize,
    /// Which frame of the pane.
    pub frame: u64,
    /// The view.
    pub camera: Camera,
    /// The metrics.
    pub metrics: PictureMetrics,
    /// Length of the true visible lines in pixels, for a picture of lines.
    pub true_length_px: Option<f64>,
    /// What is missed and what is spurious, over a transparent ground.
    pub overlay: ColorImage,
}

/// Measures pictures of one mesh, the latest first.
pub struct Measuring(Worker<Vec<Shot>, Result<Vec<Score>, Failure>>);

impl Measuring {
    /// Starts the thread. It prepares the truth of the mesh when it is first asked.
    pub fn start(gpu: &Arc<Gpu>, wake: &Wake, mesh: &NamedMesh) -> Self {
        let (gpu, mesh) = (Arc::clone(gpu), mesh.clone());
        let mut finders = Finders { lines: None, fill: None };
        Self(Worker::start(wake, move |shots: Vec<Shot>, progress| finders.score(&gpu, &mesh, &shots, progress)))
    }

    /// Asks for scores of pictures, in place of any that wait.
    pub fn ask(&self, shots: Vec<Shot>) {
        self.0.ask(shots);
    }

    /// Scores, if some are there.
    pub fn poll(&self) -> Option<Result<Result<Vec<Score>, Failure>, Died>> {
        self.0.poll()
    }

    /// How far measuring is, while there is something to measure.
    pub fn stage(&self) -> Option<Stage> {
        self.0.stage()
    }
}

/// Pictures on screen and what they score, while that is wanted.
#[derive(Default)]
pub struct Measured {
    /// Whether pictures are measured.
    pub is_on: bool,
    /// Whether what is missed and spurious lies over them.
    pub is_over: bool,
    measuring: Option<Measuring>,
    /// The frame of each pane that was asked about last.
    asked: [u64; 2],
    failure: Option<String>,
}

impl Measured {
    /// Forgets all that is of the last mesh.
    pub fn clear(&mut self) {
        *self = Self { is_on: self.is_on, is_over: self.is_over, ..Self::default() };
    }

    /// Measures no more, and forgets what was being measured.
    pub fn cancel(&mut self) {
        *self = Self::default();
    }

    /// Asks about pictures that are new, and hands scores to their panes.
    pub fn update(
        &mut self,
        gpu: &Arc<Gpu>,
        wake: &Wake,
        mesh: &NamedMesh,
        context: &eframe::egui::Context,
        panes: &mut [Pane],
    ) {
        if !self.is_on {
            // What is done is kept for the next time; what is not is not worth finishing.
            if self.stage().is_some() {
                self.measuring = None;
            }
            return;
        }
        let measuring = self.measuring.get_or_insert_with(|| Measuring::start(gpu, wake, mesh));
        while let Some(result) = measuring.poll() {
            match result {
                Ok(Ok(scores)) => {
                    self.failure = None;
                    for score in scores {
                        if let Some(pane) = panes.get_mut(score.pane) {
                            pane.take_score(context, score);
                        }
                    }
                }
                Ok(Err(failure)) => self.failure = Some(failure.to_string()),
                Err(died) => {
                    self.cancel();
                    return self.failure = Some(died.to_string());
                }
            }
        }
        let shots: Vec<Shot> = panes.iter().enumerate().filter_map(|(index, pane)| pane.unscored(index)).collect();
        if shots.iter().any(|shot| shot.frame != self.asked[shot.pane]) {
            shots.iter().for_each(|shot| self.asked[shot.pane] = shot.frame);
            measuring.ask(shots);
        }
    }

    /// Why there is no score.
    pub fn failure(&self) -> Option<&str> {
        self.failure.as_deref()
    }

    /// How far measuring is, while there is something to measure.
    pub fn stage(&self) -> Option<Stage> {
        self.measuring.as_ref().and_then(Measuring::stage)
    }
}

/// What finds truths, made when it is first needed.
struct Finders {
    lines: Option<TruthFinder>,
    fill: Option<FillTruth>,
}

impl Finders {
    fn score(
        &mut self,
        gpu: &Gpu,
        mesh: &NamedMesh,
        shots: &[Shot],
        progress: &dyn Progress,
    ) -> Result<Vec<Score>, Failure> {
        // Two panes may show the same view, whose truth is found once.
        let mut known: Option<Truth> = None;
        shots.iter().map(|shot| self.score_one(gpu, mesh, shot, &mut known, progress)).collect()
    }

    fn score_one(
        &mut self,
        gpu: &Gpu,
        mesh: &NamedMesh,
        shot: &Shot,
        known: &mut Option<Truth>,
        progress: &dyn Progress,
    ) -> Result<Score, Failure> {
        let failed = |error: &dyn std::fmt::Display| Failure::Run(format!("{}: no truth: {error}", mesh.name));
        let (metrics, true_length_px, difference) = match shot.kind {
            PictureKind::Lines => {
                let finder = match &mut self.lines {
                    Some(finder) => finder,
                    none => none.insert(TruthFinder::new(&mesh.mesh, progress).map_err(|error| failed(&error))?),
                };
                progress.stage("the true lines of the view", 0);
                let truth = match known.take().filter(|truth| truth.camera == shot.camera) {
                    Some(truth) => truth,
                    None => finder.find(&shot.camera, progress).map_err(|error| failed(&error))?,
                };
                progress.check()?;
                let (drawn, pen) = (Ink::from_picture(&shot.picture), truth.draw(shot.pen));
                let metrics = measure(&drawn, &truth.lines, TruePen { picture: &pen, width_px: shot.pen.width_px });
                let length = truth.lines.total_length_px();
                *known = Some(truth);
                (PictureMetrics::Lines(metrics), Some(length), difference(&drawn, &pen))
            }
            PictureKind::Fill => {
                progress.stage("the true surface", 0);
                let finder = match &mut self.fill {
                    Some(finder) => finder,
                    none => none.insert(FillTruth::new(gpu, mesh.mesh.mesh()).map_err(|error| failed(&error))?),
                };
                let truth = finder.find(gpu, &shot.camera).map_err(|error| failed(&error))?;
                progress.check()?;
                let drawn = FilledPicture::new(Image::clone(&shot.picture));
                let metrics = measure_fill(&drawn, &truth);
                (PictureMetrics::Fill(metrics), None, difference(drawn.coverage(), truth.coverage()))
            }
        };
        let Shot { pane, frame, camera, .. } = *shot;
        Ok(Score { pane, frame, camera, metrics, true_length_px, overlay: overlay(&difference) })
    }
}

/// The colours of what is missed and of what is spurious, nothing elsewhere.
fn overlay(difference: &Image) -> ColorImage {
    let color = |pixel: &[u8]| match pixel {
        [r, g, b, _] if *pixel == MISSED || *pixel == SPURIOUS => Color32::from_rgb(*r, *g, *b),
        _ => Color32::TRANSPARENT,
    };
    let pixels = difference.rgba.chunks_exact(4).map(color).collect();
    ColorImage::new([difference.width as usize, difference.height as usize], pixels)
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_compare::picture::{AGREEING, PAPER};

    #[test]
    fn an_overlay_shows_what_differs_and_nothing_else() {
        let image = Image { width: 4, height: 1, rgba: [MISSED, SPURIOUS, AGREEING, PAPER].concat() };
        let [red, blue] = [MISSED, SPURIOUS].map(|[r, g, b, _]| Color32::from_rgb(r, g, b));
        assert_eq!(overlay(&image).pixels, [red, blue, Color32::TRANSPARENT, Color32::TRANSPARENT]);
    }
}
