//! One mesh of a comparison: the cells that are run on it.

use super::coherent::CoherenceBench;
use super::comparison::{LeftOut, Outcome, PictureSet};
use super::error::CompareError;
use super::follow::{FollowError, Followed, ScoredFrame, follow};
use super::frame_source::{FrameSource, Output};
use super::subject::Subject;
use super::truths::{Scored, Truths};
use crate::cost::{FrameCost, FrameSample, PrepareCost};
use crate::drawing::afresh::Afresh;
use crate::drawing::{DrawError, Drawing, FrameStyle, Ground};
use crate::options::OptionSettings;
use crate::record::{ArtefactRecord, CameraRecord, Cell, PenRecord, View};
use crate::scene::{MethodChoice, Scene};
use rayon::prelude::*;
use silhouette_core::Progress;
use silhouette_core::method::PrepareError;
use silhouette_core::view::Camera;
use silhouette_gpu::PenPlacement;
use silhouette_render::Gpu;
use std::collections::BTreeMap;

/// A mesh with its truth, on which cells are run one after another.
pub(crate) struct Bench<'a> {
    scene: &'a Scene,
    gpu: &'a Gpu,
    progress: &'a dyn Progress,
    subject: &'a Subject,
    /// All frames of the path, warm-up frames first.
    cameras: Vec<Camera>,
    /// Indices of the scored frames among them, ascending.
    scored: Vec<usize>,
    truths: Truths<'a>,
    /// Where the scene asks for coherence.
    coherence: Option<CoherenceBench<'a>>,
}

/// A cell of which the path was followed once or more.
pub(crate) struct BegunCell {
    drawing: Drawing,
    cell: Cell,
    pictures: PictureSet,
    /// What each frame took in each pass, warm-up frames too.
    passes: Vec<Vec<FrameSample>>,
}

/// What beginning a cell yields.
pub(crate) enum Begun {
    /// A cell.
    Cell(Box<BegunCell>),
    /// The method is not defined for the mesh.
    LeftOut(LeftOut),
}

impl<'a> Bench<'a> {
    /// Finds the truth of every scored frame.
    pub fn new(
        scene: &'a Scene,
        subject: &'a Subject,
        gpu: &'a Gpu,
        progress: &'a dyn Progress,
    ) -> Result<Self, CompareError> {
        let name = || subject.mesh.name.clone();
        let bounds = subject.mesh.mesh.mesh().bounds().ok_or_else(|| CompareError::EmptyMesh { mesh: name() })?;
        let orbit = scene.path.orbit(scene.picture.size());
        let cameras = orbit.cameras(&bounds).map_err(|cause| CompareError::View { mesh: name(), cause })?;
        let warm_up = scene.path.warm_up as usize;
        let scored: Vec<usize> = scene.path.scored_frames().into_iter().map(|frame| warm_up + frame as usize).collect();
        let seen: Vec<Camera> = scored.iter().map(|&index| cameras[index]).collect();
        let truths = Truths::find(subject, &seen, scene.pen.width_px, progress)?;
        let coherence = scene.coherence.as_ref().map(|spec| CoherenceBench::new(subject, spec, orbit, bounds));
        Ok(Self { scene, gpu, progress, subject, cameras, scored, truths, coherence })
    }

    /// Runs a cell: prepares the method, follows the path as often as the scene says, scores the frames kept.
    pub fn run_cell(&mut self, choice: &MethodChoice) -> Result<Outcome, CompareError> {
        match self.begin(choice)? {
            Begun::LeftOut(left_out) => Ok(Outcome::LeftOut(left_out)),
            Begun::Cell(mut begun) => {
                for _ in 1..self.scene.path.passes {
                    self.follow_again(&mut begun)?;
                }
                Ok(self.finish(*begun))
            }
        }
    }

    /// Follows the path of a cell once more, for times alone.
    pub fn follow_again(&self, begun: &mut BegunCell) -> Result<(), CompareError> {
        let mesh = &self.subject.mesh.name;
        let method = &begun.cell.method;
        let pass = begun.passes.len() + 1;
        self.progress.stage(&format!("{mesh}: {method}, pass {pass}"), self.cameras.len() as u64);
        let followed = follow(&mut begun.drawing, &self.cameras, &[], self.gpu, self.progress);
        begun.passes.push(followed.map_err(|error| failed(mesh, method, error))?.samples);
        Ok(())
    }

    /// A cell with the times of all passes over its path.
    pub fn finish(&self, begun: BegunCell) -> Outcome {
        let BegunCell { mut cell, pictures, passes, .. } = begun;
        // The cost of a single pass is in the cell already.
        if passes.len() > 1 {
            cell.frame = frame_cost(&passes, self.scene);
        }
        Outcome::Measured { cell: Box::new(cell), pictures: Box::new(pictures) }
    }

    /// Begins a cell: prepares the method, follows the path once, scores the frames kept. A method that refuses the mesh is noted as
    /// left out.
    pub fn begin(&mut self, choice: &MethodChoice) -> Result<Begun, CompareError> {
        let method = choice.entry.info().name;
        let mesh = self.subject.mesh.name.clone();
        self.progress.stage(&format!("{mesh}: {method}"), self.cameras.len() as u64);
        let prepared = self.prepare(choice);
        let (mut drawing, prepare, artefacts) = match prepared {
            Err(DrawError::Prepare(PrepareError::Mesh(reason))) => {
                let method = method.to_owned();
                return Ok(Begun::LeftOut(LeftOut { mesh, method, reason: reason.to_string() }));
            }
            prepared => prepared.map_err(|cause| CompareError::draw(&mesh, method, cause))?,
        };
        let options = OptionSettings::from(&choice.options);
        let (mut cell, pictures, samples) = self.score_source(&mut drawing, method, options, prepare)?;
        cell.artefacts = artefacts;
        if let Some(coherence) = &mut self.coherence {
            cell.coherence = coherence.run(&mut drawing, method, self.gpu, self.progress)?;
        }
        Ok(Begun::Cell(Box::new(BegunCell { drawing, cell, pictures, passes: vec![samples] })))
    }

    /// Prepares a method for a mesh that nothing was derived from, so that its time and its artefacts hold everything it needs.
    fn prepare(&self, choice: &MethodChoice) -> Result<(Drawing, PrepareCost, Vec<ArtefactRecord>), DrawError> {
        let Scene { picture, pen, .. } = self.scene;
        let style = FrameStyle {
            size: picture.size(),
            pen_width_px: pen.width_px,
            samples: picture.samples,
            ground: Ground::measured(choice.picture),
        };
        let method = (&choice.entry, &choice.options);
        let mesh = &self.subject.mesh.mesh;
        let Afresh { drawing, cost, artefacts, .. } =
            Afresh::prepare(self.gpu, mesh, method, choice.picture, style, self.progress)?;
        Ok((drawing, cost, artefacts.iter().map(ArtefactRecord::from).collect()))
    }

    /// Follows the path with whatever draws the frames, and scores what was kept; yields what each frame took as well.
    pub(super) fn score_source(
        &mut self,
        source: &mut dyn FrameSource,
        method: &str,
        options: OptionSettings,
        prepare: PrepareCost,
    ) -> Result<(Cell, PictureSet, Vec<FrameSample>), CompareError> {
        let output = source.output();
        self.truths.prepare(output, self.gpu, self.progress)?;
        let mesh = &self.subject.mesh.name;
        let followed = follow(source, &self.cameras, &self.scored, self.gpu, self.progress);
        let followed = followed.map_err(|error| failed(mesh, method, error))?;
        let score = |(view, frame): (usize, &ScoredFrame)| self.truths.score(view, output, &frame.picture);
        let scores: Vec<Scored> = followed.scored.par_iter().enumerate().map(score).collect();
        let view = |at: usize| self.view(at, output, &followed, &scores[at]);
        let views: Vec<View> = (0..scores.len()).map(view).collect();

        let cell = Cell {
            mesh: self.truths.mesh.clone(),
            method: method.to_owned(),
            options,
            picture: output.kind(),
            run: 0,
            pen: match output {
                Output::Lines(pen) => {
                    let placement = placement_name(pen.placement).to_owned();
                    Some(PenRecord { width_px: pen.width_px, placement })
                }
                Output::Fill => None,
            },
            prepare,
            artefacts: Vec::new(),
            frame: frame_cost(std::slice::from_ref(&followed.samples), self.scene),
            views,
            intervals: BTreeMap::new(),
            coherence: Vec::new(),
        };
        let pictured = cell.worst_view().expect("every scene scores at least one frame");
        let [drawn, truth, difference] = scores[pictured].pictures.clone();
        let pictures = PictureSet {
            mesh: mesh.clone(),
            method: method.to_owned(),
            options: cell.options.clone(),
            picture: cell.picture,
            frame: cell.views[pictured].frame,
            drawn,
            truth,
            difference,
        };
        Ok((cell.with_intervals(), pictures, followed.samples))
    }

    fn view(&self, view: usize, output: Output, followed: &Followed, scored: &Scored) -> View {
        let frame = &followed.scored[view];
        let sample = &followed.samples[frame.index];
        View {
            frame: frame.index as u32 - self.scene.path.warm_up,
            camera: CameraRecord::from(&self.cameras[frame.index]),
            frame_ms: sample.frame_ms,
            extract_ms: sample.extraction.map(|extraction| extraction.extract_ms),
            truth: self.truths.record(view, output),
            edges: frame.edges.as_ref().map(|found| self.truths.score_edges(view, found)),
            metrics: scored.metrics,
            errors: scored.errors,
        }
    }
}

fn frame_cost(passes: &[Vec<FrameSample>], scene: &Scene) -> FrameCost {
    FrameCost::of(passes, scene.path.warm_up).expect("every scene times at least one frame")
}

fn failed(mesh: &str, method: &str, error: FollowError) -> CompareError {
    match error {
        FollowError::Cancelled(cancelled) => CompareError::Cancelled(cancelled),
        FollowError::Draw(cause) => CompareError::draw(mesh, method, cause),
    }
}

fn placement_name(placement: PenPlacement) -> &'static str {
    match placement {
        PenPlacement::Centred => "centred",
        PenPlacement::Inside => "inside",
        PenPlacement::Outside => "outside",
    }
}
