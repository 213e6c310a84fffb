//! [`Renderer`]: interior and lines in the caller's render pass, and what comes before it.

use crate::as_printed::AsPrintedLines;
use crate::lines::Lines;
use crate::method::EdgeMesh;
use crate::options::{ArithmeticChoice, CullChoice};
use crate::pipelines::{Pipelines, Stages};
use crate::style;
use silhouette_core::Viewpoint;
use silhouette_core::mesh::Bounds;
use silhouette_gpu::{
    CameraUniform, DrawsLines, FillRenderer, FrameRenderer, FrameView, MeshBuffers, PenPlacement, RendererError,
    TargetFormats, Viewport,
};
use std::sync::Arc;

impl DrawsLines for EdgeMesh {
    type Pipelines = Pipelines;
    type Renderer = Renderer;

    /// Silhouettes lie beyond the front face; those of the article, and ridges and valleys, on both sides.
    fn pen_placement(&self) -> PenPlacement {
        match self.options().arithmetic {
            ArithmeticChoice::Corrected => PenPlacement::Outside,
            ArithmeticChoice::AsPrinted => PenPlacement::Centred,
        }
    }

    fn pipelines(&self, device: &wgpu::Device, formats: TargetFormats) -> Result<Pipelines, RendererError> {
        Ok(Pipelines::new(device, self.options(), formats))
    }

    fn renderer(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        pipelines: &Arc<Pipelines>,
        mesh: &Arc<MeshBuffers>,
    ) -> Result<Renderer, RendererError> {
        Renderer::new(device, queue, self, pipelines, mesh)
    }
}

/// What draws the lines of an instance.
#[derive(Debug)]
enum InstanceLines {
    /// Nothing: the mesh has no triangles.
    None,
    Corrected(Box<Lines>),
    AsPrinted(AsPrintedLines),
}

/// Draws the interior, then ridges and valleys, then silhouettes.
#[derive(Debug)]
pub struct Renderer {
    pipelines: Arc<Pipelines>,
    mesh: Arc<MeshBuffers>,
    /// With back faces, and without them.
    interior: [Option<FillRenderer>; 2],
    /// Whether the view last prepared leaves back faces out.
    culls: bool,
    /// Whether that cannot be seen from outside.
    is_outward: bool,
    lines: InstanceLines,
    viewport: Option<Viewport>,
}

impl Renderer {
    fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        method: &EdgeMesh,
        pipelines: &Arc<Pipelines>,
        mesh: &Arc<MeshBuffers>,
    ) -> Result<Self, RendererError> {
        if mesh.face_count() as usize != method.mesh().face_count() {
            return Err(RendererError::OtherForm { what: "meshes" });
        }
        let lines = match &pipelines.lines {
            _ if mesh.face_count() == 0 => InstanceLines::None,
            Stages::Corrected(stages) => Lines::new(device, queue, stages, method, mesh)?
                .map_or(InstanceLines::None, |lines| InstanceLines::Corrected(Box::new(lines))),
            Stages::AsPrinted(stage) => InstanceLines::AsPrinted(AsPrintedLines::new(device, queue, stage, method)?),
        };
        Ok(Self {
            interior: pipelines.interior.each_ref().map(|fill| Some(FillRenderer::new(device, fill.as_ref()?, mesh))),
            culls: false,
            is_outward: method.is_outward(),
            lines,
            pipelines: Arc::clone(pipelines),
            mesh: Arc::clone(mesh),
            viewport: None,
        })
    }

    /// What the view last encoded draws, on the device: the list of silhouettes and boundaries and the list of ridges and
    /// valleys, each a word that holds the number of entries and then the entries, in any order.
    /// [`DrawnEdges::of_words`](crate::drawn_edges::DrawnEdges::of_words) reads them. `None` where the vertex stage decides.
    /// For stages of the caller's own; storage buffers that may be copied from.
    pub fn drawn_edges(&self) -> Option<[&wgpu::Buffer; 2]> {
        if let InstanceLines::Corrected(lines) = &self.lines { lines.lists() } else { None }
    }

    /// The normals of this frame's faces, on the device, as [`oct_normal`](crate::oct_normal) stores them: one word per face. `None`
    /// unless the mesh has moved and ridges or valleys are drawn by their angle.
    pub fn normals(&self) -> Option<&wgpu::Buffer> {
        if let InstanceLines::Corrected(lines) = &self.lines { lines.normals() } else { None }
    }

    /// The facings of the view last encoded, on the device: one bit per face, set for front faces; face `f` is bit `f % 32` of
    /// word `f / 32`. `None` for a mesh without triangles, and for the article's arithmetic.
    pub fn facings(&self) -> Option<&wgpu::Buffer> {
        if let InstanceLines::Corrected(lines) = &self.lines { Some(lines.facing()) } else { None }
    }
}

/// Whether the eye is outside of the box around a mesh, as that of an orthographic view always is.
fn is_outside(bounds: &Bounds, viewpoint: &Viewpoint) -> bool {
    let Viewpoint::Perspective { eye } = viewpoint else { return true };
    let eye = eye.as_dvec3();
    eye.cmplt(bounds.min).any() || eye.cmpgt(bounds.max).any()
}

impl FrameRenderer for Renderer {
    fn prepare(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, view: &FrameView) -> Result<(), RendererError> {
        let Pipelines { options, formats, .. } = &*self.pipelines;
        formats.check(view)?;
        let Some(bounds) = self.mesh.bounds() else { return Ok(()) };
        let frame = self.mesh.frame();
        self.culls = match options.cull {
            CullChoice::Auto => self.is_outward && is_outside(&bounds, &view.viewpoint()),
            CullChoice::None => false,
            CullChoice::Back => true,
        };
        if let Some(interior) = &mut self.interior[usize::from(self.culls)] {
            interior.prepare(device, queue, view)?;
        }
        match &mut self.lines {
            InstanceLines::None => {}
            InstanceLines::Corrected(lines) => {
                let style = style::of_view(options, view, &bounds, frame, formats);
                let camera = CameraUniform::new(frame.to_clip(view));
                lines.prepare(device, queue, view, &camera, style, self.mesh.is_at_rest());
            }
            InstanceLines::AsPrinted(lines) => lines.prepare(queue, view),
        }
        self.viewport = Some(view.viewport());
        Ok(())
    }

    fn encode(&self, encoder: &mut wgpu::CommandEncoder) {
        if let (InstanceLines::Corrected(lines), Some(_)) = (&self.lines, self.viewport) {
            lines.encode(encoder);
        }
    }

    fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        let Some(viewport) = self.viewport else { return };
        if let Some(interior) = &self.interior[usize::from(self.culls)] {
            interior.draw(pass);
        }
        viewport.set(pass);
        match &self.lines {
            InstanceLines::None => {}
            InstanceLines::Corrected(lines) => lines.draw(pass),
            InstanceLines::AsPrinted(lines) => lines.draw(pass),
        }
    }

    fn warning(&self) -> Option<String> {
        let is_behind = matches!(self.lines, InstanceLines::AsPrinted(_)) && !self.mesh.is_at_rest();
        is_behind.then(|| {
            "arithmetic=as-printed draws the lines of the mesh at rest; choose arithmetic=corrected for one that moves".to_owned()
        })
    }
}
