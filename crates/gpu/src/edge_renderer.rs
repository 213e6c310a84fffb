//! [`EdgeRenderer`]: silhouette edges found on the CPU, drawn as strokes.

use crate::frame_renderer::FrameRenderer;
use crate::frame_view::FrameView;
use crate::renderer_error::RendererError;
use crate::strokes::{Polylines, StrokeRenderer};
use glam::Vec3;
use silhouette_core::method::{ExtractionStats, ExtractsMovingEdges, PositionsError};
use silhouette_core::{ExtractsEdges, SilhouetteEdges, Topology, TriangleMesh, VertexId};
use std::sync::Arc;

/// Draws what a method extracts: in each frame the edges seen from the view's own
/// [viewpoint](FrameView::viewpoint), as strokes that the mesh hides.
///
/// Cost of a frame: the extraction, O(S) on the CPU and for the upload, one pass over the faces for their depth.
pub struct EdgeRenderer<E> {
    extractor: E,
    edges: SilhouetteEdges,
    stats: ExtractionStats,
    topology: Arc<Topology>,
    mesh: Arc<TriangleMesh>,
    /// Positions of a mesh that moves; empty until it does.
    moved: Vec<Vec3>,
    strokes: StrokeRenderer,
}

impl<E: ExtractsEdges> EdgeRenderer<E> {
    /// Draws the edges of `extractor`, which was prepared for `mesh`, with `strokes`, whose buffers hold the same mesh.
    pub fn new(extractor: E, mesh: Arc<TriangleMesh>, topology: Arc<Topology>, strokes: StrokeRenderer) -> Self {
        let (edges, stats) = (SilhouetteEdges::default(), ExtractionStats::default());
        Self { extractor, edges, stats, topology, mesh, moved: Vec::new(), strokes }
    }

    /// The edges of the view last prepared.
    pub fn edges(&self) -> &SilhouetteEdges {
        &self.edges
    }

    /// What finding them took.
    pub fn stats(&self) -> ExtractionStats {
        self.stats
    }

    /// The strokes, to set what hides them.
    pub fn strokes_mut(&mut self) -> &mut StrokeRenderer {
        &mut self.strokes
    }

    /// The method.
    pub fn extractor(&self) -> &E {
        &self.extractor
    }
}

impl<E: ExtractsMovingEdges> EdgeRenderer<E> {
    /// Replaces the positions, one per vertex in the mesh's own space, for extraction and drawing. O(V + F), allocates nothing
    /// from the second call on.
    ///
    /// # Errors
    /// [`PositionsError`]; the positions of before then stay in force.
    pub fn set_positions(&mut self, queue: &wgpu::Queue, positions: &[Vec3]) -> Result<(), PositionsError> {
        self.extractor.update_positions(positions)?;
        self.strokes.mesh().set_positions(queue, positions)?;
        self.moved.clear();
        self.moved.extend_from_slice(positions);
        Ok(())
    }
}

impl<E: ExtractsEdges> FrameRenderer for EdgeRenderer<E> {
    fn prepare(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, view: &FrameView) -> Result<(), RendererError> {
        self.stats = self.extractor.extract_edges(&view.viewpoint(), &mut self.edges);
        let positions = if self.moved.is_empty() { self.mesh.positions() } else { &self.moved };
        let position = |vertex: VertexId| positions[vertex.index()].as_dvec3();
        let lines: &mut Polylines = self.strokes.lines_mut();
        lines.clear();
        for edge in self.edges.iter() {
            lines.push(self.topology.end_points(edge).map(position), false);
        }
        self.strokes.prepare(device, queue, view)
    }

    fn encode(&self, encoder: &mut wgpu::CommandEncoder) {
        self.strokes.encode(encoder);
    }

    fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        self.strokes.draw(pass);
    }
}
