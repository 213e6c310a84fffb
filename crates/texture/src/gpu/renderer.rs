//! [`TextureRenderer`]: one instance of an object.

use super::hull_uniform::HullUniform;
use super::pipelines::TexturePipelines;
use super::style::{Drawing, Shading};
use super::volume::TextureVolume;
use silhouette_core::view::{Camera, ClipRange};
use silhouette_gpu::kit::{UniformBlock, bind_group};
use silhouette_gpu::{
    CameraBinding, CameraUniform, Color, FillRenderer, FrameRenderer, FrameView, MeshBuffers, RendererError,
    SurfaceUniform, Viewport,
};
use std::sync::Arc;

/// Draws one instance of a silhouette texture.
///
/// A frame uploads 400 bytes, allocates nothing on the device and reads nothing back. Where the near plane meets the hull the
/// fine mesh is drawn, if there is one, with a [warning](FrameRenderer::warning).
pub struct TextureRenderer {
    pipelines: Arc<TexturePipelines>,
    volume: Arc<TextureVolume>,
    camera: CameraBinding,
    hull: UniformBlock<HullUniform>,
    hull_group: wgpu::BindGroup,
    mesh: Option<Arc<MeshBuffers>>,
    near: Option<FillRenderer>,
    prepared: Option<Prepared>,
}

/// The view last prepared.
#[derive(Debug, Clone, Copy)]
struct Prepared {
    viewport: Viewport,
    is_mirrored: bool,
    is_near: bool,
}

impl TextureRenderer {
    /// A renderer of one instance. `mesh` is the fine mesh, for views from inside the hull.
    ///
    /// # Errors
    /// [`RendererError::OtherForm`]: the pipelines were not made for the volume's [form](TextureVolume::form).
    pub fn new(
        device: &wgpu::Device,
        pipelines: &Arc<TexturePipelines>,
        volume: &Arc<TextureVolume>,
        mesh: Option<&Arc<MeshBuffers>>,
    ) -> Result<Self, RendererError> {
        if pipelines.form != volume.form() {
            return Err(RendererError::OtherForm { what: "silhouette textures" });
        }
        let hull = UniformBlock::new(device, "hull uniform");
        let hull_group = bind_group(device, "silhouette texture: hull", &pipelines.hull_layout, &[hull.binding()]);
        let near = mesh.zip(pipelines.near.as_ref()).map(|(mesh, near)| FillRenderer::new(device, near, mesh));
        Ok(Self {
            camera: CameraBinding::new(device, &CameraBinding::layout(device), size_of::<SurfaceUniform>()),
            pipelines: Arc::clone(pipelines),
            volume: Arc::clone(volume),
            hull,
            hull_group,
            mesh: mesh.cloned(),
            near,
            prepared: None,
        })
    }

    /// Whether the fine mesh takes the hull's place in the view last prepared.
    pub fn is_near(&self) -> bool {
        self.prepared.is_some_and(|prepared| prepared.is_near)
    }
}

impl FrameRenderer for TextureRenderer {
    fn prepare(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, view: &FrameView) -> Result<(), RendererError> {
        let TexturePipelines { formats, style, .. } = &*self.pipelines;
        formats.check(view)?;
        self.prepared = None;
        let volume = &*self.volume;
        let is_near = volume.is_met_by(view);
        if is_near && let Some(near) = &mut self.near {
            near.prepare(device, queue, view)?;
        }
        let color = match &style.drawing {
            Drawing::Surface(Shading::Flat(color)) | Drawing::Hull(Shading::Flat(color)) => *color,
            _ => Color::WHITE,
        };
        let surface = SurfaceUniform::new(volume.frame(), view, color, formats.is_linear());
        self.camera.write(queue, &CameraUniform::new(volume.frame().to_clip(view)), &surface);
        self.hull.write(queue, &HullUniform::new(volume, style, view));
        self.prepared = Some(Prepared { viewport: view.viewport(), is_mirrored: view.is_mirrored(), is_near });
        Ok(())
    }

    fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        let Some(prepared) = &self.prepared else { return };
        if prepared.is_near && self.mesh.is_some() {
            if let Some(near) = &self.near {
                near.draw(pass);
            }
            return;
        }
        prepared.viewport.set(pass);
        for stage in &self.pipelines.stages {
            pass.set_pipeline(stage.get(prepared.is_mirrored));
            pass.set_bind_group(0, self.camera.bind_group(), &[]);
            pass.set_bind_group(1, &self.hull_group, &[]);
            self.volume.draw(pass);
        }
    }

    fn warning(&self) -> Option<String> {
        let has_lines = matches!(self.pipelines.style.drawing, Drawing::Outlines(_));
        let text = match (self.is_near(), &self.mesh) {
            (true, None) => {
                "the near plane meets the hull, which has holes there; move back, or give the fine mesh too"
            }
            (true, Some(_)) if has_lines => "the near plane meets the hull: no outlines are drawn; move back",
            (true, Some(_)) => "the near plane meets the hull: the fine mesh is drawn instead; move back",
            (false, Some(mesh)) if !mesh.is_at_rest() => {
                "the vertices have been moved on the device, but the texture shows the mesh that was baked; bake it again"
            }
            (false, _) if self.pipelines.lacks_samples() => {
                "soft edges need a target with 4 samples per pixel; edges are hard"
            }
            (false, _) => return None,
        };
        Some(text.to_owned())
    }

    fn clip_range(&self, camera: &Camera, mesh: ClipRange) -> ClipRange {
        let Some(bounds) = self.volume.bounds() else { return mesh };
        let hull = camera.clip_range(&bounds);
        ClipRange { near: hull.near.min(mesh.near), far: hull.far.max(mesh.far) }
    }
}
