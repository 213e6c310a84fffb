//! [`Renderer`]: interior and lines in the caller's render pass, and what comes before it.

use crate::as_printed::AsPrintedLines;
use crate::edge_record::OfBackFaces;
use crate::lines::Lines;
use crate::method::EdgeMesh;
use crate::options::{ArithmeticChoice, CullChoice};
use crate::pipelines::{Pipelines, Stages};
use crate::style;
use silhouette_core::Viewpoint;
use silhouette_core::glam::DVec3;
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
    /// Whether the interior of the view last prepared leaves back faces out.
    culls: bool,
    /// Whether all back faces of the view last prepared are hidden.
    hides_back_faces: bool,
    /// What is drawn of back faces, where they are hidden and where not.
    of_back: [OfBackFaces; 2],
    /// Whether faces point outwards at rest, all around.
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
        let is_other = mesh.vertex_count() < method.mesh().vertex_count() && mesh.face_count() > 0;
        if is_other || mesh.face_count() as usize != method.mesh().face_count() {
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
            hides_back_faces: false,
            of_back: [true, false].map(|hides_them| method.of_back_faces(hides_them)),
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

    /// Whether all back faces of the view last prepared are hidden: the mesh is closed, outward and at rest, the eye outside of its
    /// bounds, and the near plane before them. The interior then leaves them out by default, and features between two of them are not
    /// drawn.
    pub fn hides_back_faces(&self) -> bool {
        self.hides_back_faces
    }

    /// The facings of the view last encoded, on the device: one bit per face, set for front faces; face `f` is bit `f % 32` of
    /// word `f / 32`. `None` for a mesh without triangles, and for the article's arithmetic.
    pub fn facings(&self) -> Option<&wgpu::Buffer> {
        if let InstanceLines::Corrected(lines) = &self.lines { Some(lines.facing()) } else { None }
    }
}

/// Share of a radius that rounding may move a near plane by.
const ROUNDING: f64 = 1e-6;

/// Whether the eye is outside of the box around a mesh, as that of an orthographic view always is, and the near plane cuts nothing
/// off the box or nothing off the sphere around it, so that a closed mesh shows no back face.
fn is_whole_from_outside(bounds: &Bounds, view: &FrameView) -> bool {
    let is_outside = match view.viewpoint() {
        Viewpoint::Perspective { eye } => {
            let eye = eye.as_dvec3();
            eye.cmplt(bounds.min).any() || eye.cmpgt(bounds.max).any()
        }
        Viewpoint::Orthographic { .. } => true,
    };
    let depth_of_corner = |corner: u32| {
        let pick = DVec3::new(f64::from(corner & 1), f64::from(corner >> 1 & 1), f64::from(corner >> 2));
        view.depth(bounds.min + pick * (bounds.max - bounds.min))
    };
    let of_box = (0..8).map(depth_of_corner).fold(f64::INFINITY, f64::min);
    let radius = bounds.radius * view.largest_scale();
    let nearest = of_box.max(view.depth(bounds.center) - radius);
    // A near plane that touches the sphere may lie behind it by rounding.
    is_outside && nearest >= view.depth_law().range().near - ROUNDING * radius
}

impl FrameRenderer for Renderer {
    fn prepare(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, view: &FrameView) -> Result<(), RendererError> {
        let Pipelines { options, formats, .. } = &*self.pipelines;
        formats.check(view)?;
        let Some(bounds) = self.mesh.bounds() else { return Ok(()) };
        let frame = self.mesh.frame();
        self.hides_back_faces = self.is_outward && self.mesh.is_at_rest() && is_whole_from_outside(&bounds, view);
        self.culls = match options.cull {
            CullChoice::Auto => self.hides_back_faces,
            CullChoice::None => false,
            CullChoice::Back => true,
        };
        if let Some(interior) = &mut self.interior[usize::from(self.culls)] {
            interior.prepare(device, queue, view)?;
        }
        match &mut self.lines {
            InstanceLines::None => {}
            InstanceLines::Corrected(lines) => {
                let mut style = style::of_view(options, view, &bounds, frame, formats);
                let of_back = self.of_back[usize::from(!self.hides_back_faces)];
                style.back_features = u32::from(of_back.features);
                style.back_boundaries = u32::from(of_back.boundaries);
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
