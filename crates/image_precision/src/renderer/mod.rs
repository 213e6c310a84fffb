//! [`Renderer`]: both steps in the caller's render pass, and the lists that are made before it.

mod back;
mod extra;

use crate::depth_step::{self, DepthBits, PullBelowDepthStep};
use crate::eye_inside;
use crate::method::ImagePrecision;
use crate::pipelines::Pipelines;
use crate::settings::Variant;
use crate::style::{self, StyleUniform};
use back::Back;
use extra::ExtraLines;
use silhouette_core::prepared::PreparedMesh;
use silhouette_core::view::{Camera, ClipRange};
use silhouette_gpu::{
    CameraBinding, CameraUniform, DrawsLines, FrameRenderer, FrameView, MeshBinding, MeshBuffers, PenPlacement,
    RendererError, TargetFormats, Viewport,
};
use std::sync::Arc;

impl DrawsLines for ImagePrecision {
    type Pipelines = Pipelines;
    type Renderer = Renderer;

    /// Pulled back faces show on the front faces, along their silhouette edges; fattened and expanded ones beyond.
    fn pen_placement(&self) -> PenPlacement {
        match self.settings().variant {
            Variant::Screen | Variant::Fatten { .. } | Variant::Charcoal { .. } | Variant::Unoriented { k: None } => {
                PenPlacement::Outside
            }
            Variant::Wireframe { .. } => PenPlacement::Centred,
            _ => PenPlacement::Inside,
        }
    }

    fn pipelines(&self, device: &wgpu::Device, formats: TargetFormats) -> Result<Pipelines, RendererError> {
        Pipelines::new(device, self.settings(), formats)
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

/// Draws front faces, and back faces or their edges as the variant says.
///
/// Memory on the device, besides the mesh's buffers: per face for `screen` lists and a table of 24 to 32 bytes,
/// for fattening lists of 188 (216 with textures or charcoal), for `unoriented` two lists of 4 and two textures of the
/// viewport's size, and with `unoriented-lines=screen` also what `screen` takes. A view uploads about 750 bytes.
#[derive(Debug)]
pub struct Renderer {
    prepared: Arc<PreparedMesh>,
    pipelines: Arc<Pipelines>,
    mesh: Arc<MeshBuffers>,
    mesh_binding: Option<MeshBinding>,
    binding: CameraBinding,
    back: Back,
    extra: Option<ExtraLines>,
    /// The pipeline of front faces for the view last prepared.
    front: Option<wgpu::RenderPipeline>,
    viewport: Option<Viewport>,
    draws_back_faces: bool,
    below_step: Option<PullBelowDepthStep>,
}

impl Renderer {
    fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        method: &ImagePrecision,
        pipelines: &Arc<Pipelines>,
        mesh: &Arc<MeshBuffers>,
    ) -> Result<Self, RendererError> {
        let back = Back::new(device, queue, &pipelines.back, method, mesh)?;
        let extra = match &pipelines.extra {
            Some(pipeline) => {
                ExtraLines::new(device, queue, pipeline, method.extra_edges(), pipelines.settings.variant)?
            }
            None => None,
        };
        let mesh_binding = if back.pulls_mesh() || extra.is_some() {
            MeshBinding::new(device, &MeshBinding::layout(device), mesh, back.corners())?
        } else {
            None
        };
        Ok(Self {
            prepared: Arc::clone(method.mesh()),
            pipelines: Arc::clone(pipelines),
            mesh: Arc::clone(mesh),
            mesh_binding,
            binding: CameraBinding::new(device, &CameraBinding::layout(device), size_of::<StyleUniform>()),
            back,
            extra,
            front: None,
            viewport: None,
            draws_back_faces: true,
            below_step: None,
        })
    }

    /// Where the pull of the view last prepared is smaller than one depth step.
    pub fn pull_below_depth_step(&self) -> Option<PullBelowDepthStep> {
        self.below_step
    }

    fn depth_bits(&self) -> DepthBits {
        match self.pipelines.formats.depth {
            wgpu::TextureFormat::Depth16Unorm => DepthBits::Unorm16,
            wgpu::TextureFormat::Depth24Plus | wgpu::TextureFormat::Depth24PlusStencil8 => DepthBits::Unorm24,
            _ => DepthBits::Float32,
        }
    }
}

impl FrameRenderer for Renderer {
    /// Whether the eye is inside of the mesh is decided on its positions at rest; of a mesh whose positions were replaced it
    /// counts as outside.
    fn prepare(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, view: &FrameView) -> Result<(), RendererError> {
        let Pipelines { settings, formats, front, back, .. } = &*self.pipelines;
        formats.check(view)?;
        let Some(bounds) = self.mesh.bounds() else { return Ok(()) };
        let frame = self.mesh.frame();
        let camera = CameraUniform::new(frame.to_clip(view));
        let mut style = style::of_view(settings, view, &bounds, frame, formats);
        self.back.complete(&mut style);
        self.binding.write(queue, &camera, &style);
        if let Some(extra) = &mut self.extra {
            extra.prepare(queue, view, &bounds, frame.depth_per_w(view), &camera, &style);
        }
        let is_inside = settings.skips_inside
            && self.mesh.is_at_rest()
            && eye_inside::is_inside(self.prepared.mesh(), &bounds, &view.viewpoint());
        self.draws_back_faces = !is_inside;
        self.below_step = depth_step::check(settings.variant, view, &bounds, self.depth_bits());
        self.back.prepare(device, back, view.is_mirrored(), view.viewport().size_px);
        self.front = front.as_ref().map(|front| front.get(view.is_mirrored()).clone());
        self.viewport = Some(view.viewport());
        Ok(())
    }

    fn encode(&self, encoder: &mut wgpu::CommandEncoder) {
        if self.viewport.is_none() || !self.draws_back_faces {
            return;
        }
        if let Some(mesh) = &self.mesh_binding {
            self.back.encode(encoder, &self.binding, mesh);
        }
    }

    fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        let Some(viewport) = self.viewport else { return };
        viewport.set(pass);
        pass.set_bind_group(0, self.binding.bind_group(), &[]);
        if let Some(front) = &self.front {
            pass.set_pipeline(front);
            self.mesh.draw(pass);
        }
        if self.draws_back_faces {
            self.back.draw(pass, &self.mesh, self.mesh_binding.as_ref());
        }
        if let (Some(extra), Some(mesh)) = (&self.extra, &self.mesh_binding) {
            extra.draw(pass, mesh);
        }
    }

    fn warning(&self) -> Option<String> {
        self.below_step.map(|warning| warning.to_string())
    }

    fn clip_range(&self, camera: &Camera, mesh: ClipRange) -> ClipRange {
        match self.mesh.bounds() {
            Some(bounds) => style::widened(self.pipelines.settings.variant, camera, &bounds, mesh),
            None => mesh,
        }
    }
}
