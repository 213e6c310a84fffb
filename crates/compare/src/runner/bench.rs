//! One mesh of a comparison: its truth, and the methods that are run on it.

use super::{CompareConfig, CompareError, Comparison, LeftOut, MethodChoice, NamedMesh, PictureSet};
use crate::camera_path::Orbit;
use crate::cost::{FrameCost, PrepareCost};
use crate::drawing::{DrawError, Drawing, FrameStyle};
use crate::metrics::{Ink, LineMetrics, TruePen, measure};
use crate::picture::difference;
use crate::record::{EdgeScore, MeshRecord, PenRecord, Record, TruthRecord, ViewRecord};
use crate::registry::Prepared;
use crate::truth::{Truth, TruthFinder};
use rayon::prelude::*;
use silhouette_core::method::PrepareError;
use silhouette_core::view::Camera;
use silhouette_core::{Cancelled, PreparedMesh, Progress, SilhouetteEdges};
use silhouette_gpu::{Pen, PenPlacement};
use silhouette_render::{Gpu, Image};
use std::collections::HashMap;
use std::sync::Arc;
use std::time::Instant;

/// A mesh with its truth, on which methods are run one after another.
pub(super) struct Bench<'a> {
    config: &'a CompareConfig,
    gpu: &'a Gpu,
    progress: &'a dyn Progress,
    mesh: &'a NamedMesh,
    record: MeshRecord,
    animation: Vec<Camera>,
    truths: Vec<Truth>,
    /// Ink of the truth, one a view, for each placement of the pen that was asked for.
    pens: HashMap<PenPlacement, Vec<Ink>>,
}

/// The view of which the report shows pictures: every profile has a first one.
const PICTURED_VIEW: usize = 0;

/// What a method answered in one view.
struct AnsweredView {
    picture: Image,
    edges: Option<EdgeScore>,
}

impl<'a> Bench<'a> {
    /// Finds the truth of every view.
    pub fn new(
        config: &'a CompareConfig,
        mesh: &'a NamedMesh,
        gpu: &'a Gpu,
        progress: &'a dyn Progress,
    ) -> Result<Self, CompareError> {
        let name = || mesh.name.clone();
        let bounds = mesh.mesh.mesh().bounds().ok_or_else(|| CompareError::EmptyMesh { mesh: name() })?;
        let (size, profile) = (config.profile.size(), config.profile);
        let cameras =
            |orbit: Orbit| orbit.cameras(&bounds).map_err(|source| CompareError::View { mesh: name(), source });
        let views = cameras(Orbit::turn(config.framing, size, profile.views()))?;
        let animation = cameras(Orbit::animation(config.framing, size, profile.warm_up() + profile.frames()))?;

        let truth_failed = |source| CompareError::truth(&mesh.name, source);
        let mut finder = TruthFinder::new(&mesh.mesh, progress).map_err(truth_failed)?;
        progress.stage(&format!("{}: truth", mesh.name), views.len() as u64);
        let mut truths = Vec::with_capacity(views.len());
        for camera in &views {
            progress.check()?;
            truths.push(finder.find(camera, progress).map_err(truth_failed)?);
            progress.advance(1);
        }
        let record = MeshRecord {
            name: name(),
            vertices: mesh.mesh.mesh().vertex_count(),
            faces: mesh.mesh.mesh().face_count(),
            edges: finder.edge_count(),
        };
        Ok(Self { config, gpu, progress, mesh, record, animation, truths, pens: HashMap::new() })
    }

    /// Runs a method: its answer first, its times afterwards. One that refuses the mesh is noted as left out.
    pub fn run_method(&mut self, choice: &MethodChoice, comparison: &mut Comparison) -> Result<(), CompareError> {
        let method = choice.entry.info.name;
        let mesh = self.mesh.name.clone();
        let failed = |error| match error {
            BenchError::Cancelled(cancelled) => CompareError::Cancelled(cancelled),
            BenchError::Draw(source) => CompareError::draw(&mesh, method, source),
        };
        let steps = self.truths.len() + self.animation.len();
        self.progress.stage(&format!("{mesh}: {method}"), steps as u64);

        let (mut drawing, prepare) = match self.prepare(choice) {
            Err(BenchError::Draw(DrawError::Prepare(PrepareError::Mesh(reason)))) => {
                comparison.left_out.push(LeftOut { mesh, method, reason: reason.to_string() });
                return Ok(());
            }
            prepared => prepared.map_err(failed)?,
        };
        let pen = drawing.pen();
        self.draw_true_pens(pen)?;
        let views = self.draw_views(&mut drawing).map_err(failed)?;
        let frame = self.time_frames(&mut drawing).map_err(failed)?;

        let inks: Vec<Ink> = views.par_iter().map(|view| Ink::from_picture(&view.picture)).collect();
        let true_pens = &self.pens[&pen.placement];
        let metrics: Vec<LineMetrics> = (0..views.len())
            .into_par_iter()
            .map(|view| {
                let pen = TruePen { picture: &true_pens[view], width_px: pen.width_px };
                measure(&inks[view], &self.truths[view].lines, pen)
            })
            .collect();

        for (index, (truth, metrics)) in self.truths.iter().zip(metrics).enumerate() {
            comparison.records.push(Record {
                mesh: self.record.clone(),
                method: method.to_owned(),
                options: choice.options.to_string(),
                profile: self.config.profile,
                view: ViewRecord::of(index as u32, &truth.camera),
                pen: PenRecord { width_px: pen.width_px, placement: placement_name(pen.placement).to_owned() },
                truth: TruthRecord {
                    silhouette_edges: truth.edges.len(),
                    visible_length_px: truth.lines.total_length_px(),
                },
                edges: views[index].edges,
                metrics,
                prepare,
                frame,
                run: comparison.run.clone(),
            });
        }
        let true_ink = &true_pens[PICTURED_VIEW];
        comparison.pictures.push(PictureSet {
            mesh,
            method: method.to_owned(),
            options: choice.options.to_string(),
            view: PICTURED_VIEW as u32,
            drawn: views[PICTURED_VIEW].picture.clone(),
            truth: true_ink.to_picture(),
            difference: difference(&inks[PICTURED_VIEW], true_ink),
        });
        Ok(())
    }

    /// Prepares a method for a mesh that nothing was derived from, so that its time holds everything it needs.
    fn prepare(&self, choice: &MethodChoice) -> Result<(Drawing, PrepareCost), BenchError> {
        let fresh = Arc::new(PreparedMesh::new(Arc::clone(self.mesh.mesh.mesh())));
        let start = Instant::now();
        let prepared = choice.entry.prepare(&fresh, &choice.options, self.progress).map_err(DrawError::from)?;
        let prepare_ms = start.elapsed().as_secs_f64() * 1000.0;
        let own = match &prepared {
            Prepared::Edges(method) => method.bytes(),
            Prepared::Lines(method) => method.bytes(),
        };
        let bytes = own + fresh.report().iter().map(|artefact| artefact.bytes).sum::<usize>();

        let style = FrameStyle { size: self.config.profile.size(), pen_width_px: self.config.pen_width_px, samples: 1 };
        let start = Instant::now();
        let drawing = Drawing::new(self.gpu, &fresh, prepared, style)?;
        let renderer_ms = start.elapsed().as_secs_f64() * 1000.0;
        Ok((drawing, PrepareCost { prepare_ms, renderer_ms, bytes: bytes as u64 }))
    }

    /// Draws the truth of every view with this kind of pen, unless a method before had the same.
    fn draw_true_pens(&mut self, pen: Pen) -> Result<(), CompareError> {
        if self.pens.contains_key(&pen.placement) {
            return Ok(());
        }
        let mut pictures = Vec::with_capacity(self.truths.len());
        for truth in &self.truths {
            self.progress.check()?;
            pictures.push(truth.draw(pen));
        }
        self.pens.insert(pen.placement, pictures);
        Ok(())
    }

    /// A picture of every view, and its edges scored.
    fn draw_views(&self, drawing: &mut Drawing) -> Result<Vec<AnsweredView>, BenchError> {
        let mut views = Vec::with_capacity(self.truths.len());
        for truth in &self.truths {
            self.progress.check()?;
            drawing.draw(self.gpu, &truth.camera)?;
            let edges = drawing.edges().map(|found| score_edges(found, &truth.edges));
            views.push(AnsweredView { picture: drawing.picture(self.gpu)?, edges });
            self.progress.advance(1);
        }
        Ok(views)
    }

    fn time_frames(&self, drawing: &mut Drawing) -> Result<FrameCost, BenchError> {
        let mut frames = Vec::with_capacity(self.animation.len());
        for camera in &self.animation {
            self.progress.check()?;
            frames.push(drawing.draw(self.gpu, camera)?);
            self.progress.advance(1);
        }
        Ok(FrameCost::of(&frames, self.config.profile.warm_up()).expect("every profile times at least one frame"))
    }
}

#[derive(Debug, thiserror::Error)]
enum BenchError {
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    #[error(transparent)]
    Draw(#[from] DrawError),
}

fn placement_name(placement: PenPlacement) -> &'static str {
    match placement {
        PenPlacement::Centred => "centred",
        PenPlacement::Inside => "inside",
        PenPlacement::Outside => "outside",
    }
}

fn score_edges(found: &SilhouetteEdges, truth: &SilhouetteEdges) -> EdgeScore {
    let right = found.iter().filter(|&edge| truth.contains(edge)).count() as f64;
    let share = |whole: usize| if whole == 0 { 1.0 } else { right / whole as f64 };
    EdgeScore { found: found.len(), precision: share(found.len()), recall: share(truth.len()) }
}
