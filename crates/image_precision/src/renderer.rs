//! [`Renderer`]: both steps in somebody's render pass.

use crate::back_faces::{self, BackFacesUniform};
use crate::method::ImagePrecision;
use crate::{eye_inside, front_faces};
use silhouette_core::prepared::PreparedMesh;
use silhouette_core::view::Camera;
use silhouette_gpu::{
    CameraBinding, CameraUniform, DrawsLines, LineRenderer, MeshBuffers, MeshTooLarge, POSITION_LAYOUT, PenPlacement,
    TargetFormats,
};
use std::sync::Arc;

impl DrawsLines for ImagePrecision {
    type Renderer = Renderer;

    /// Ink lies on the front faces, along their silhouette edges.
    fn pen_placement(&self) -> PenPlacement {
        PenPlacement::Inside
    }

    fn renderer(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        formats: TargetFormats,
    ) -> Result<Renderer, MeshTooLarge> {
        let buffers = MeshBuffers::new(device, queue, self.mesh().mesh())?;
        let layout = CameraBinding::layout(device);
        let binding = CameraBinding::new(device, &layout, size_of::<BackFacesUniform>());
        let pipeline_layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some("image precision"),
            bind_group_layouts: &[Some(&layout)],
            immediate_size: 0,
        });
        Ok(Renderer {
            mesh: Arc::clone(self.mesh()),
            scale: self.scale(),
            skips_inside: self.skips_inside(),
            front: front_faces::pipeline(device, &pipeline_layout, formats),
            back: back_faces::pipeline(device, &pipeline_layout, formats),
            formats,
            buffers,
            binding,
            draws_back_faces: true,
        })
    }
}

/// Draws front faces white and back faces black, pulled towards the eye. 12 bytes a vertex and a face on the device, two
/// pipelines; a view uploads 68 bytes.
#[derive(Debug)]
pub struct Renderer {
    mesh: Arc<PreparedMesh>,
    scale: f64,
    skips_inside: bool,
    formats: TargetFormats,
    buffers: MeshBuffers,
    binding: CameraBinding,
    front: wgpu::RenderPipeline,
    back: wgpu::RenderPipeline,
    draws_back_faces: bool,
}

impl LineRenderer for Renderer {
    fn prepare(&mut self, _device: &wgpu::Device, queue: &wgpu::Queue, camera: &Camera) {
        let Some(bounds) = self.buffers.bounds() else { return };
        let direction = self.formats.depth_direction;
        let range = back_faces::widened(camera, camera.clip_range(bounds), self.scale);
        let frame = self.buffers.frame();
        let offset = back_faces::clip_z_offset(camera, range, direction, self.scale) / frame.clip_unit(camera);
        let uniform = BackFacesUniform { clip_z_offset: offset as f32 };
        self.binding.write(queue, &CameraUniform::new(frame.to_clip(camera, range, direction)), &uniform);
        let is_inside = self.skips_inside && eye_inside::is_inside(self.mesh.mesh(), bounds, &camera.viewpoint());
        self.draws_back_faces = !is_inside;
    }

    fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        pass.set_bind_group(0, self.binding.bind_group(), &[]);
        pass.set_pipeline(&self.front);
        self.buffers.draw(pass);
        if self.draws_back_faces {
            pass.set_pipeline(&self.back);
            self.buffers.draw(pass);
        }
    }
}

/// What the two pipelines differ in.
pub(crate) struct Stage {
    pub label: &'static str,
    pub wgsl: &'static str,
    pub vertex: &'static str,
    pub fragment: &'static str,
    pub culled: wgpu::Face,
    pub compare: wgpu::CompareFunction,
}

impl Stage {
    pub(crate) fn build(
        self,
        device: &wgpu::Device,
        layout: &wgpu::PipelineLayout,
        formats: TargetFormats,
    ) -> wgpu::RenderPipeline {
        let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some(self.label),
            source: wgpu::ShaderSource::Wgsl(self.wgsl.into()),
        });
        device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some(self.label),
            layout: Some(layout),
            vertex: wgpu::VertexState {
                module: &module,
                entry_point: Some(self.vertex),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                buffers: &[Some(POSITION_LAYOUT)],
            },
            primitive: wgpu::PrimitiveState { cull_mode: Some(self.culled), ..wgpu::PrimitiveState::default() },
            depth_stencil: Some(formats.depth_state(self.compare)),
            multisample: formats.multisample_state(),
            fragment: Some(wgpu::FragmentState {
                module: &module,
                entry_point: Some(self.fragment),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                targets: &[Some(formats.color.into())],
            }),
            multiview_mask: None,
            cache: None,
        })
    }
}
