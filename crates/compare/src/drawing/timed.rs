//! [`Timed`]: a method whose extractions are timed.

use silhouette_core::glam::Vec3;
use silhouette_core::method::{ExtractionStats, ExtractsMovingEdges, PositionsError};
use silhouette_core::{ExtractsEdges, SilhouetteEdges, Viewpoint};
use std::time::Instant;

/// A method, and how long its last extraction took.
pub(super) struct Timed<M: ?Sized> {
    method: Box<M>,
    extract_ms: f64,
}

impl<M: ?Sized> Timed<M> {
    /// Times a method.
    pub fn new(method: Box<M>) -> Self {
        Self { method, extract_ms: 0.0 }
    }

    /// Wall time of the last extraction in milliseconds.
    pub fn extract_ms(&self) -> f64 {
        self.extract_ms
    }
}

impl<M: ExtractsEdges + ?Sized> ExtractsEdges for Timed<M> {
    fn extract_edges(&mut self, viewpoint: &Viewpoint, out: &mut SilhouetteEdges) -> ExtractionStats {
        let start = Instant::now();
        let stats = self.method.extract_edges(viewpoint, out);
        self.extract_ms = start.elapsed().as_secs_f64() * 1000.0;
        stats
    }
}

impl<M: ExtractsMovingEdges + ?Sized> ExtractsMovingEdges for Timed<M> {
    fn update_positions(&mut self, positions: &[Vec3]) -> Result<(), PositionsError> {
        self.method.update_positions(positions)
    }
}
