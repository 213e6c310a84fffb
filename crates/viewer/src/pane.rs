//! [`Pane`]: one method on screen, from its choice to its picture.

use crate::background::{Died, Job, Stage, Wake};
use crate::flicker::Flicker;
use crate::history::History;
use crate::layers::Layers;
use crate::meshes::Shown;
use crate::painter::{Frame, Painter, Question};
use crate::picture::{Picture, Pictures};
use crate::truth::{Score, Shot};
use eframe::egui::{self, TextureHandle, TextureId};
use eframe::wgpu;
use silhouette_compare::drawing::{DrawError, Drawing, FrameStyle, Ground, pictures_of};
use silhouette_compare::metrics::PictureKind;
use silhouette_compare::registry::{Entry, Registry};
use silhouette_compare::runner::NamedMesh;
use silhouette_core::method::OptionValues;
use silhouette_core::{Camera, Progress};
use silhouette_render::Gpu;
use silhouettes::application::{Failure, check_drawn_by};
use std::sync::Arc;
use std::time::Instant;

/// A method with its options.
#[derive(Debug, Clone)]
pub struct Choice {
    /// The method.
    pub entry: Entry,
    /// A value for each of its options.
    pub values: OptionValues,
}

impl Choice {
    /// A method with its default options.
    pub fn new(entry: &Entry) -> Self {
        Self { entry: entry.clone(), values: OptionValues::defaults(entry.info().options) }
    }

    /// The method of this name with options as the command line gives them.
    ///
    /// # Errors
    /// [`Failure::Input`]: there is no such method, it draws no pictures, or an option does not fit.
    pub fn of_words(registry: &Registry, method: &str, words: &[String]) -> Result<Self, Failure> {
        let entry = registry.find(method).map_err(Failure::input)?;
        if pictures_of(entry.capabilities()).next().is_none() {
            let drawn = registry.names(|entry| pictures_of(entry.capabilities()).next().is_some());
            return Err(Failure::Input(format!("--method {method}: yields curves alone; choose one of {drawn}")));
        }
        let values = OptionValues::parse(entry.info().options, words.iter().map(String::as_str))?;
        Ok(Self { entry: entry.clone(), values })
    }

    /// Name of the method.
    pub fn name(&self) -> &'static str {
        self.entry.info().name
    }

    /// What its pictures show: lines where it yields any.
    pub fn kind(&self) -> PictureKind {
        pictures_of(self.entry.capabilities()).next().unwrap_or(PictureKind::Lines)
    }
}

impl PartialEq for Choice {
    fn eq(&self, other: &Self) -> bool {
        self.name() == other.name() && self.values == other.values
    }
}

/// How lines are drawn in a pane, whatever the method.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Look {
    /// Width of the pen in pixels.
    pub pen_width_px: f64,
    /// Samples per pixel, 1 or 4.
    pub samples: u32,
    /// What is drawn besides the method.
    pub layers: Layers,
}

impl Default for Look {
    /// As the command line's `render`.
    fn default() -> Self {
        Self { pen_width_px: 1.5, samples: 4, layers: Layers::default() }
    }
}

/// What of the frames to come is looked at besides what they show.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct LooksAt {
    /// Their pixels, which are read back for it.
    pub pixels: bool,
    /// Edges that appear and vanish.
    pub changes: bool,
}

/// One method on screen.
pub struct Pane {
    /// What is wanted.
    pub choice: Choice,
    /// What is prepared or being prepared, and how it is drawn.
    asked: Option<(Choice, Look)>,
    preparation: Option<Job<Result<Drawing, Failure>>>,
    painter: Option<Painter>,
    /// The view that was asked for last.
    question: Option<Question>,
    frame: Option<Frame>,
    picture: Option<(Picture, u64)>,
    failure: Option<String>,
    /// How many frames have arrived since the mesh was opened.
    frames: u64,
    /// The first of them that is by what is prepared now.
    first_frame: u64,
    history: History,
    score: Option<Score>,
    overlay: Option<TextureHandle>,
    flicker: Flicker,
}

impl Pane {
    /// A pane that shows nothing yet.
    pub fn new(choice: Choice) -> Self {
        Self {
            choice,
            asked: None,
            preparation: None,
            painter: None,
            question: None,
            frame: None,
            picture: None,
            failure: None,
            frames: 0,
            first_frame: 0,
            history: History::default(),
            score: None,
            overlay: None,
            flicker: Flicker::default(),
        }
    }

    /// Forgets all that is of the last mesh.
    pub fn clear(&mut self) {
        *self = Self::new(self.choice.clone());
    }

    /// Brings what is drawn nearer to what is wanted. Called for each frame of the window; does no work itself.
    pub fn update(
        &mut self,
        gpu: &Arc<Gpu>,
        wake: &Wake,
        mesh: &Shown,
        look: Look,
        camera: &Camera,
        looks_at: LooksAt,
    ) {
        let wanted = (self.choice.clone(), look);
        if self.asked.as_ref() != Some(&wanted) {
            self.prepare(gpu, wake, mesh, wanted, camera.size());
        }
        self.take_preparation(gpu, wake);
        self.take_frames(looks_at.changes);
        let reads_back = looks_at.pixels;
        let question = Question { camera: *camera, reads_back };
        let is_answered =
            self.question.is_some_and(|asked| asked.camera == *camera && (asked.reads_back || !reads_back));
        if let Some(painter) = &self.painter
            && !is_answered
        {
            painter.ask(question);
            self.question = Some(question);
        }
    }

    fn prepare(&mut self, gpu: &Arc<Gpu>, wake: &Wake, mesh: &Shown, wanted: (Choice, Look), size: [u32; 2]) {
        if let Err(failure) = check_drawn_by(&mesh.argument, &wanted.0.entry) {
            self.asked = Some(wanted);
            self.preparation = None;
            return self.fail(failure.to_string());
        }
        let (choice, look) = wanted.clone();
        let (gpu, mesh) = (Arc::clone(gpu), mesh.named.clone());
        self.failure = None;
        self.preparation = Some(Job::start(wake, move |progress| drawing(&gpu, &mesh, &choice, look, size, progress)));
        self.asked = Some(wanted);
    }

    fn take_preparation(&mut self, gpu: &Arc<Gpu>, wake: &Wake) {
        let Some(result) = self.preparation.as_ref().and_then(Job::poll) else { return };
        self.preparation = None;
        self.question = None;
        self.history.clear();
        self.flicker.clear();
        self.score = None;
        self.first_frame = self.frames + 1;
        match result {
            Ok(Ok(drawing)) => match &self.painter {
                Some(painter) => painter.change(drawing),
                None => self.painter = Some(Painter::start(gpu, wake, drawing)),
            },
            Ok(Err(failure)) => self.fail(failure.to_string()),
            Err(died) => self.fail(died.to_string()),
        }
    }

    fn take_frames(&mut self, looks_at_changes: bool) {
        while let Some(result) = self.painter.as_ref().and_then(Painter::poll) {
            self.take_frame(result, looks_at_changes);
        }
    }

    /// Waits for the picture that was asked for last until a moment at most, so that the window shows it at once and need not draw
    /// itself again for it.
    pub fn wait(&mut self, until: Instant, looks_at: LooksAt) {
        while let Some(painter) = self.painter.as_ref().filter(|painter| painter.is_busy()) {
            let Some(result) = painter.wait(until.saturating_duration_since(Instant::now())) else { return };
            self.take_frame(result, looks_at.changes);
        }
    }

    fn take_frame(&mut self, result: Result<Result<Frame, DrawError>, Died>, looks_at_changes: bool) {
        match result {
            Ok(Ok(frame)) => {
                self.frames += 1;
                self.history.drawn(self.frames, frame.sample.frame_ms);
                match &frame.edges {
                    Some(edges) if looks_at_changes => self.flicker.follow(edges, Instant::now()),
                    _ => self.flicker.clear(),
                }
                self.frame = Some(frame);
            }
            Ok(Err(error)) => self.fail(error.to_string()),
            Err(died) => self.fail(died.to_string()),
        }
    }

    fn fail(&mut self, message: String) {
        self.failure = Some(message);
        self.painter = None;
        self.frame = None;
        self.question = None;
    }

    /// Stops the preparation; what was shown before is shown on, and the choice is that.
    pub fn cancel(&mut self) {
        if self.preparation.take().is_some() {
            self.failure =
                Some("the preparation was cancelled; choose a method or change an option to begin again".into());
        }
    }

    /// How far the preparation is, while there is one.
    pub fn stage(&self) -> Option<Stage> {
        self.preparation.as_ref().map(Job::stage)
    }

    /// Whether there is a method to draw with, and no other is being prepared.
    pub fn is_prepared(&self) -> bool {
        self.preparation.is_none() && self.painter.is_some()
    }

    /// Whether something is to come.
    pub fn is_busy(&self) -> bool {
        self.preparation.is_some() || self.painter.as_ref().is_some_and(Painter::is_busy)
    }

    /// Why there is no picture.
    pub fn failure(&self) -> Option<&str> {
        self.failure.as_deref()
    }

    /// The frame on screen.
    pub fn frame(&self) -> Option<&Frame> {
        self.frame.as_ref()
    }

    /// How many frames have been drawn since the mesh was opened.
    pub fn frames(&self) -> u64 {
        self.frames
    }

    /// Frame times and errors of the last frames.
    pub fn history(&self) -> &History {
        &self.history
    }

    /// The picture on screen, where it was read back and has no score yet.
    pub fn unscored(&self, pane: usize) -> Option<Shot> {
        let frame = self.frame.as_ref()?;
        let is_scored = self.score.as_ref().is_some_and(|score| score.frame == self.frames);
        let picture = Arc::clone(frame.picture.as_ref().filter(|_| !is_scored)?);
        let (camera, pen, kind) = (frame.camera, frame.pen, self.choice.kind());
        Some(Shot { pane, frame: self.frames, camera, pen, kind, picture })
    }

    /// Takes a score, unless the method has changed since.
    pub fn take_score(&mut self, context: &egui::Context, score: Score) {
        if score.frame < self.first_frame {
            return;
        }
        let leading = score.metrics.kind().leading_metric();
        if let Some(error) = leading.error(&score.metrics) {
            self.history.measured(score.frame, error);
        }
        let (image, options) = (score.overlay.clone(), egui::TextureOptions::NEAREST);
        match &mut self.overlay {
            Some(overlay) => overlay.set(image, options),
            None => self.overlay = Some(context.load_texture("missed and spurious", image, options)),
        }
        self.score = Some(score);
    }

    /// Edges that appeared or vanished a moment ago, of a method that extracts edges.
    pub fn flicker(&self) -> &Flicker {
        &self.flicker
    }

    /// The score of the view on screen, once it is there.
    pub fn score(&self) -> Option<&Score> {
        let shown = self.frame.as_ref()?;
        self.score.as_ref().filter(|score| score.camera == shown.camera)
    }

    /// What the picture on screen misses and what is spurious in it, once that is known.
    pub fn overlay(&self) -> Option<TextureId> {
        self.score().and(self.overlay.as_ref()).map(TextureHandle::id)
    }

    /// The picture on screen, for the window to show.
    pub fn picture(&mut self, device: &wgpu::Device, pictures: &Pictures) -> Option<Picture> {
        let shown = &self.frame.as_ref()?.texture;
        if self.picture.as_ref().is_none_or(|(_, number)| *number != shown.number) {
            self.picture = Some((pictures.of(device, &shown.view), shown.number));
        }
        self.picture.as_ref().map(|(picture, _)| picture.clone())
    }
}

/// Prepares a method and all that its frames are drawn with.
fn drawing(
    gpu: &Gpu,
    mesh: &NamedMesh,
    choice: &Choice,
    look: Look,
    size: [u32; 2],
    progress: &dyn Progress,
) -> Result<Drawing, Failure> {
    let of_preparation = |error| Failure::of_preparation(&mesh.name, choice.name(), error);
    let prepared = choice.entry.prepare(&mesh.mesh, &choice.values, progress).map_err(of_preparation)?;
    let kind = choice.kind();
    let Look { pen_width_px, samples, .. } = look;
    let style = FrameStyle { size, pen_width_px, samples, ground: Ground::measured(kind) };
    let drawing = Drawing::new(gpu, &mesh.mesh, prepared, kind, style);
    let mut drawing = drawing.map_err(|error| match error {
        DrawError::Prepare(error) => of_preparation(error),
        other => Failure::run(other),
    })?;
    look.layers.add_to(&mut drawing, gpu, &mesh.mesh, progress).map_err(of_preparation)?;
    Ok(drawing)
}
