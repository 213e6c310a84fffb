//! [`Layers`]: what is drawn besides a method, in its pass: shading and hidden lines below it, creases above it.

use silhouette_compare::drawing::Drawing;
use silhouette_core::feature_edges::feature_edges;
use silhouette_core::method::{NoOptions, PrepareError};
use silhouette_core::{Method, PreparedMesh, Progress, Topology};
use silhouette_extraction::BruteForceSimd;
use silhouette_gpu::{
    Color, Cull, EdgeRenderer, FillPipelines, FillRenderer, FillStyle, FrameRenderer, Hidden, Pen, PenPlacement, Shade,
    StrokePipelines, StrokeRenderer, StrokeStyle,
};
use silhouette_render::Gpu;
use std::sync::Arc;

/// Edges whose faces bend by this angle or more are creases where nobody said otherwise, in degrees.
const DEFAULT_CREASE_DEG: f64 = 30.0;

/// What is drawn besides a method.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Layers {
    /// The mesh, lit.
    pub shading: bool,
    /// All silhouette edges in grey, hidden ones too.
    pub hidden: bool,
    /// Creases that are seen.
    pub creases: bool,
    /// Edges whose faces bend by this angle or more are creases.
    pub crease_deg: f64,
}

impl Default for Layers {
    fn default() -> Self {
        Self { shading: false, hidden: false, creases: false, crease_deg: DEFAULT_CREASE_DEG }
    }
}

impl Layers {
    /// Adds them to what is drawn. O(F), and where hidden lines are shown also for each frame.
    ///
    /// # Errors
    /// [`PrepareError::Cancelled`].
    pub fn add_to(
        self,
        drawing: &mut Drawing,
        gpu: &Gpu,
        mesh: &Arc<PreparedMesh>,
        progress: &dyn Progress,
    ) -> Result<(), PrepareError> {
        let (device, formats) = (gpu.device(), drawing.target().formats());
        let strokes = |style: StrokeStyle| {
            let pipelines = Arc::new(StrokePipelines::new(device, formats, style));
            StrokeRenderer::new(device, &pipelines, drawing.mesh())
        };
        let width_px = drawing.pen().width_px;
        let pen = |width_px: f64| Pen { width_px, placement: PenPlacement::Centred };
        let mut below: Vec<Box<dyn FrameRenderer>> = Vec::new();
        let mut above: Vec<Box<dyn FrameRenderer>> = Vec::new();
        if self.shading {
            let style =
                FillStyle { shade: Shade::Lit(Color { srgb: [0.78, 0.8, 0.84], alpha: 1.0 }), cull: Cull::None };
            let pipelines = Arc::new(FillPipelines::new(device, formats, style));
            below.push(Box::new(FillRenderer::new(device, &pipelines, drawing.mesh())));
        }
        if self.hidden || self.creases {
            let topology = mesh.artefact::<Topology>("viewer", progress)?;
            if self.hidden {
                let ink = Color { srgb: [0.7; 3], alpha: 1.0 };
                let style =
                    StrokeStyle { pen: pen(width_px * 0.67), ink, hidden: Hidden::Drawn, ..StrokeStyle::default() };
                let extractor = BruteForceSimd::prepare(mesh, &NoOptions, progress)?;
                let edges =
                    EdgeRenderer::new(extractor, Arc::clone(mesh.mesh()), Arc::clone(&topology), strokes(style));
                below.push(Box::new(edges));
            }
            if self.creases {
                let style = StrokeStyle { pen: pen(width_px * 0.67), ..StrokeStyle::default() };
                let mut creases = strokes(style);
                let are_creases = feature_edges(mesh.mesh(), &topology, mesh.feature_edges(), self.crease_deg);
                let position = |vertex: silhouette_core::VertexId| mesh.mesh().positions()[vertex.index()].as_dvec3();
                for (edge, _) in are_creases.iter().filter(|(_, is_crease)| **is_crease) {
                    creases.lines_mut().push(topology.end_points(edge).map(position), false);
                }
                above.push(Box::new(creases));
            }
        }
        drawing.surround(below, above);
        Ok(())
    }
}
