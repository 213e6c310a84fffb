//! [`Renderer`]: both steps in the caller's render pass, and the lists that are made before it.

mod back;
mod extra;

use crate::depth_step::{self, DepthBits, PullBelowDepthStep};
use crate::method::ImagePrecision;
use crate::settings::{ExtraEdges, Settings, Variant};
use crate::style::{self, Pulled, StyleUniform};
use crate::{eye_inside, front_faces};
use back::Back;
use extra::ExtraLines;
use silhouette_core::prepared::PreparedMesh;
use silhouette_core::view::{Camera, ClipRange};
use silhouette_gpu::{
    CameraBinding, CameraUniform, DrawsLines, LineRenderer, MeshBinding, MeshBuffers, PenPlacement, RendererError,
    TargetFormats,
};
use std::sync::Arc;

impl DrawsLines for ImagePrecision {
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

    fn renderer(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        formats: TargetFormats,
    ) -> Result<Renderer, RendererError> {
        Renderer::new(device, queue, self, formats)
    }
}

/// Draws front faces, and back faces or their edges as the variant says.
///
/// Memory on the device: 12 bytes per vertex and per face; in addition per face for `screen` lists and a table of 24 to 32 bytes,
/// for fattening lists of 188 (216 with textures or charcoal), for `unoriented` two lists of 4 and two textures of the
/// target's size, and with `unoriented-lines=screen` also what `screen` takes. A view uploads about 550 bytes.
#[derive(Debug)]
pub struct Renderer {
    mesh: Arc<PreparedMesh>,
    settings: Settings,
    formats: TargetFormats,
    buffers: MeshBuffers,
    mesh_binding: Option<MeshBinding>,
    binding: CameraBinding,
    front: wgpu::RenderPipeline,
    back: Back,
    extra: Option<ExtraLines>,
    range: Option<ClipRange>,
    draws_back_faces: bool,
    below_step: Option<PullBelowDepthStep>,
}

impl Renderer {
    fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        method: &ImagePrecision,
        formats: TargetFormats,
    ) -> Result<Self, RendererError> {
        let settings = *method.settings();
        let buffers = MeshBuffers::new(device, queue, method.mesh().mesh())?;
        let camera_layout = CameraBinding::layout(device);
        let is_oriented = !matches!(settings.variant, Variant::Unoriented { .. });
        let culled = is_oriented.then_some(wgpu::Face::Back);
        let back = Back::new(device, queue, method, &buffers, formats)?;
        let mesh_binding = match &back {
            Back::Faces(_) if settings.extra_edges == ExtraEdges::None => None,
            Back::Faces(_) => MeshBinding::new(device, &MeshBinding::layout(device), &buffers, None)?,
            _ => MeshBinding::new(device, &MeshBinding::layout(device), &buffers, back.corners())?,
        };
        Ok(Self {
            mesh: Arc::clone(method.mesh()),
            settings,
            formats,
            front: front_faces::pipeline(device, formats, settings.interior, culled),
            back,
            extra: ExtraLines::new(device, queue, method.extra_edges(), &settings, formats)?,
            binding: CameraBinding::new(device, &camera_layout, size_of::<StyleUniform>()),
            mesh_binding,
            buffers,
            range: None,
            draws_back_faces: true,
            below_step: None,
        })
    }

    /// Near and far plane of the application, in place of those that fit the mesh tightly; `None` restores the tight fit. Takes
    /// effect with the next [`prepare`](LineRenderer::prepare).
    pub fn set_clip_range(&mut self, range: Option<ClipRange>) {
        self.range = range;
    }

    /// Where the pull of the view last prepared is smaller than one depth step.
    pub fn pull_below_depth_step(&self) -> Option<PullBelowDepthStep> {
        self.below_step
    }

    fn depth_bits(&self) -> DepthBits {
        match self.formats.depth {
            wgpu::TextureFormat::Depth16Unorm => DepthBits::Unorm16,
            wgpu::TextureFormat::Depth24Plus | wgpu::TextureFormat::Depth24PlusStencil8 => DepthBits::Unorm24,
            _ => DepthBits::Float32,
        }
    }
}

impl LineRenderer for Renderer {
    fn prepare(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, camera: &Camera) {
        let Some(bounds) = self.buffers.bounds() else { return };
        let direction = self.formats.depth_direction;
        let pulled = Pulled::new(self.settings.variant, camera, bounds, self.range, direction);
        let frame = self.buffers.frame();
        let camera_uniform = CameraUniform::new(frame.to_clip(camera, pulled.range, direction));
        let mut style = style::of_view(&self.settings, camera, bounds, frame, &pulled);
        self.back.complete(&mut style);
        self.binding.write(queue, &camera_uniform, &style);
        if let Some(extra) = &mut self.extra {
            extra.prepare(queue, camera, bounds, &camera_uniform, &style, pulled.range, direction);
        }
        let is_inside =
            self.settings.skips_inside && eye_inside::is_inside(self.mesh.mesh(), bounds, &camera.viewpoint());
        self.draws_back_faces = !is_inside;
        let variant = self.settings.variant;
        self.below_step = depth_step::check(variant, camera, bounds, pulled.range, direction, self.depth_bits());
        self.back.resize(device, camera.size());
    }

    fn encode(&self, encoder: &mut wgpu::CommandEncoder) {
        if let Some(mesh) = self.mesh_binding.as_ref().filter(|_| self.draws_back_faces) {
            self.back.encode(encoder, &self.binding, mesh);
        }
    }

    fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        pass.set_bind_group(0, self.binding.bind_group(), &[]);
        pass.set_pipeline(&self.front);
        self.buffers.draw(pass);
        if self.draws_back_faces {
            self.back.draw(pass, &self.buffers, self.mesh_binding.as_ref());
        }
        if let (Some(extra), Some(mesh)) = (&self.extra, &self.mesh_binding) {
            extra.draw(pass, mesh);
        }
    }

    fn warning(&self) -> Option<String> {
        self.below_step.map(|warning| warning.to_string())
    }
}
