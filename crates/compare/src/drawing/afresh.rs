//! [`Afresh`]: a method prepared for a mesh of which nothing was derived yet, so that its cost holds everything that it needs.

use super::{DrawError, Drawing, FrameStyle};
use crate::cost::PrepareCost;
use crate::metrics::PictureKind;
use crate::registry::Entry;
use silhouette_core::method::OptionValues;
use silhouette_core::prepared::ArtefactReport;
use silhouette_core::{PreparedMesh, Progress};
use silhouette_render::Gpu;
use std::sync::Arc;
use std::time::Instant;

/// A method that is ready to draw, and what that took.
pub struct Afresh {
    /// The method.
    pub drawing: Drawing,
    /// What preparing it cost.
    pub cost: PrepareCost,
    /// The artefacts that were built for it, in the order of completion.
    pub artefacts: Vec<ArtefactReport>,
    /// Bytes that it holds beyond them.
    pub own_bytes: usize,
}

impl Afresh {
    /// Prepares a method and its renderer. What was derived from `mesh` before is not used.
    ///
    /// # Errors
    /// [`DrawError`].
    pub fn prepare(
        gpu: &Gpu,
        mesh: &PreparedMesh,
        (entry, options): (&Entry, &OptionValues),
        kind: PictureKind,
        style: FrameStyle,
        progress: &dyn Progress,
    ) -> Result<Self, DrawError> {
        let fresh = Arc::new(mesh.fresh());
        let start = Instant::now();
        let prepared = entry.prepare(&fresh, options, progress)?;
        let prepare_ms = start.elapsed().as_secs_f64() * 1000.0;
        let (artefacts, own_bytes) = (fresh.report(), prepared.bytes());
        let bytes = own_bytes + artefacts.iter().map(|artefact| artefact.bytes).sum::<usize>();
        let start = Instant::now();
        let drawing = Drawing::new(gpu, &fresh, prepared, kind, style)?;
        let renderer_ms = start.elapsed().as_secs_f64() * 1000.0;
        Ok(Self { drawing, cost: PrepareCost { prepare_ms, renderer_ms, bytes: bytes as u64 }, artefacts, own_bytes })
    }
}
