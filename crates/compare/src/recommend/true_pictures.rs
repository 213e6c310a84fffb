//! [`TruePictures`]: what pictures of any view are compared with, found when a view is first measured.

use super::meter::{Fault, Until};
use super::views::{Setting, ViewId};
use crate::metrics::{FilledPicture, Ink, PictureKind, PictureMetrics, TruePen, measure, measure_fill};
use crate::runner::{CompareError, NamedMesh};
use crate::scene::limits::MAX_SCORED_PIXELS;
use crate::truth::fill::FillTruth;
use crate::truth::samples::TrueLines;
use crate::truth::visible::VisibleLine;
use crate::truth::{TruthError, TruthFinder, pen};
use silhouette_core::Camera;
use silhouette_core::mesh::Bounds;
use silhouette_core::method::PrepareError;
use silhouette_gpu::{Pen, PenPlacement};
use silhouette_render::{Gpu, Image};
use silhouette_visibility::LineError;
use std::collections::HashMap;

/// The true lines of a view, and these as pens draw them.
struct TrueView {
    lines: TrueLines,
    visible: Vec<VisibleLine>,
    pens: Vec<(PenPlacement, Ink)>,
}

/// The truth of the views of a mesh. Keeps that of as many views as comparisons do; that of others is found again when needed.
pub(super) struct TruePictures<'a> {
    mesh: &'a NamedMesh,
    gpu: &'a Gpu,
    bounds: Bounds,
    most_views: usize,
    finder: Option<TruthFinder>,
    lines: HashMap<ViewId, TrueView>,
    filler: Option<FillTruth>,
    fills: HashMap<ViewId, FilledPicture>,
}

impl<'a> TruePictures<'a> {
    /// Of a mesh in views of a size; nothing is found yet.
    ///
    /// # Errors
    /// [`CompareError::EmptyMesh`].
    pub fn new(mesh: &'a NamedMesh, setting: Setting, gpu: &'a Gpu) -> Result<Self, CompareError> {
        let bounds = mesh.mesh.mesh().bounds().ok_or_else(|| CompareError::EmptyMesh { mesh: mesh.name.clone() })?;
        let pixels = u64::from(setting.size[0]) * u64::from(setting.size[1]);
        let most_views = (MAX_SCORED_PIXELS / pixels.max(1)) as usize;
        let (lines, fills) = (HashMap::new(), HashMap::new());
        Ok(Self { mesh, gpu, bounds, most_views, finder: None, lines, filler: None, fills })
    }

    /// Bounds of the mesh.
    pub fn bounds(&self) -> &Bounds {
        &self.bounds
    }

    /// Finds the truth of a view of one kind, and with it what the truth of all views takes.
    pub fn set_up(
        &mut self,
        kind: PictureKind,
        (view, camera): (ViewId, &Camera),
        until: &Until<'_>,
    ) -> Result<(), Fault> {
        match kind {
            PictureKind::Lines => self.lines_of(view, camera, until).map(drop),
            PictureKind::Fill => self.fill_of(view, camera).map(drop),
        }
    }

    /// Scores a picture of a view: lines drawn with a pen, or without one a filled picture.
    pub fn score(
        &mut self,
        (view, camera): (ViewId, &Camera),
        pen: Option<Pen>,
        picture: Image,
        until: &Until<'_>,
    ) -> Result<PictureMetrics, Fault> {
        match pen {
            Some(pen) => self.score_lines((view, camera), pen, &picture, until),
            None => self.score_fill((view, camera), picture),
        }
    }

    fn score_lines(
        &mut self,
        (view, camera): (ViewId, &Camera),
        pen: Pen,
        picture: &Image,
        until: &Until<'_>,
    ) -> Result<PictureMetrics, Fault> {
        let truth = self.lines_of(view, camera, until)?;
        if truth.pens.iter().all(|(placement, _)| *placement != pen.placement) {
            truth.pens.push((pen.placement, pen::draw(&truth.visible, pen, camera.size())));
        }
        let Some((_, drawn)) = truth.pens.iter().find(|(placement, _)| *placement == pen.placement) else {
            unreachable!("it was pushed")
        };
        let true_pen = TruePen { picture: drawn, width_px: pen.width_px };
        Ok(PictureMetrics::Lines(measure(&Ink::from_picture(picture), &truth.lines, true_pen)))
    }

    fn lines_of(&mut self, view: ViewId, camera: &Camera, until: &Until<'_>) -> Result<&mut TrueView, Fault> {
        if !self.lines.contains_key(&view) {
            let found = self.find_lines(camera, until)?;
            if self.lines.len() >= self.most_views {
                self.lines.clear();
            }
            self.lines.insert(view, found);
        }
        let Some(truth) = self.lines.get_mut(&view) else { unreachable!("it was inserted") };
        Ok(truth)
    }

    fn find_lines(&mut self, camera: &Camera, until: &Until<'_>) -> Result<TrueView, Fault> {
        let name = &self.mesh.name;
        let failed = |cause| match cause {
            TruthError::Prepare(PrepareError::Cancelled(cancelled))
            | TruthError::Lines(LineError::Cancelled(cancelled)) => until.fault(cancelled),
            cause => CompareError::Truth { mesh: name.clone(), cause }.into(),
        };
        let finder = match &mut self.finder {
            Some(finder) => finder,
            none => none.insert(TruthFinder::new(&self.mesh.mesh, until).map_err(failed)?),
        };
        let truth = finder.find(camera, until).map_err(failed)?;
        Ok(TrueView { lines: truth.lines, visible: truth.visible, pens: Vec::new() })
    }

    fn score_fill(&mut self, (view, camera): (ViewId, &Camera), picture: Image) -> Result<PictureMetrics, Fault> {
        let truth = self.fill_of(view, camera)?;
        Ok(PictureMetrics::Fill(measure_fill(&FilledPicture::new(picture), truth)))
    }

    fn fill_of(&mut self, view: ViewId, camera: &Camera) -> Result<&FilledPicture, Fault> {
        if !self.fills.contains_key(&view) {
            let failed = |cause| CompareError::FillTruth { mesh: self.mesh.name.clone(), cause };
            let filler = match &mut self.filler {
                Some(filler) => filler,
                none => none.insert(FillTruth::new(self.gpu, self.mesh.mesh.mesh()).map_err(failed)?),
            };
            let found = filler.find(self.gpu, camera).map_err(failed)?;
            if self.fills.len() >= self.most_views {
                self.fills.clear();
            }
            self.fills.insert(view, found);
        }
        Ok(&self.fills[&view])
    }
}
