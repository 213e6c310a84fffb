//! [`FrameSource`]: what draws the frames of a cell.
//!
//! A source that answers [`Output::Fill`] has its pictures scored as filled ones. Nothing else in the runner asks what a method
//! draws.

use crate::cost::FrameSample;
use crate::drawing::{DrawError, Drawing};
use crate::metrics::PictureKind;
use silhouette_core::glam::Vec3;
use silhouette_core::{Camera, SilhouetteEdges};
use silhouette_gpu::Pen;
use silhouette_render::{Gpu, Image};

/// What frames show.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Output {
    /// Black lines on opaque white paper, drawn with this pen.
    Lines(Pen),
    /// The mesh, lit as [`truth::fill::LIT`](crate::truth::fill::LIT), on a transparent ground, alpha 1 where it covers a
    /// sample.
    Fill,
}

impl Output {
    /// The kind of picture.
    pub fn kind(&self) -> PictureKind {
        match self {
            Self::Lines(_) => PictureKind::Lines,
            Self::Fill => PictureKind::Fill,
        }
    }
}

/// Draws one frame after another. Whatever it keeps from frame to frame, it keeps along the whole path.
pub trait FrameSource {
    /// What its frames show.
    fn output(&self) -> Output;

    /// Draws a frame, waits for it and yields what it took.
    ///
    /// # Errors
    /// [`DrawError::Gpu`].
    fn draw(&mut self, gpu: &Gpu, camera: &Camera) -> Result<FrameSample, DrawError>;

    /// The frame drawn last.
    ///
    /// # Errors
    /// [`DrawError::Gpu`].
    fn picture(&self, gpu: &Gpu) -> Result<Image, DrawError>;

    /// The edges of the frame drawn last, for a method that extracts edges.
    fn edges(&self) -> Option<&SilhouetteEdges>;

    /// Moves the vertices of the mesh for the frames to come; `false` where it cannot.
    fn move_to(&mut self, _gpu: &Gpu, _positions: &[Vec3]) -> bool {
        false
    }

    /// What is wrong with the frame drawn last, by the method's own word.
    fn warning(&self) -> Option<String> {
        None
    }
}

impl FrameSource for Drawing {
    fn output(&self) -> Output {
        match self.kind() {
            PictureKind::Lines => Output::Lines(self.pen()),
            PictureKind::Fill => Output::Fill,
        }
    }

    fn draw(&mut self, gpu: &Gpu, camera: &Camera) -> Result<FrameSample, DrawError> {
        self.draw(gpu, camera)
    }

    fn picture(&self, gpu: &Gpu) -> Result<Image, DrawError> {
        self.picture(gpu)
    }

    fn edges(&self) -> Option<&SilhouetteEdges> {
        self.edges()
    }

    fn move_to(&mut self, gpu: &Gpu, positions: &[Vec3]) -> bool {
        self.move_to(gpu, positions)
    }

    fn warning(&self) -> Option<String> {
        self.warning()
    }
}
