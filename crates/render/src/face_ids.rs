//! [`FaceIdPass`]: which face is nearest at each pixel. Twin of `shaders/render/face_ids.wgsl`.

use crate::error::GpuError;
use crate::gpu::Gpu;
use crate::image::IdImage;
use crate::submit::Load;
use crate::target::{DEFAULT_FORMATS, Target};
use crate::view::view_of_mesh;
use silhouette_core::view::Camera;
use silhouette_gpu::kit::{RenderStage, UniformBlock, bind_group, bind_layout, uniform_entry};
use silhouette_gpu::{CameraUniform, MeshBinding, MeshBuffers, TargetFormats};

/// One id per pixel, with the default depth.
const FORMATS: TargetFormats = TargetFormats { color: wgpu::TextureFormat::R32Uint, ..DEFAULT_FORMATS };

/// Draws the ids of a mesh's faces, both sides of each. The target is kept for the next picture of the same size.
///
/// The ids are read back, so this pass waits for the device. Its stage fetches positions and triangles from storage buffers,
/// which WebGL lacks.
#[derive(Debug)]
pub struct FaceIdPass {
    pipeline: wgpu::RenderPipeline,
    camera: UniformBlock<CameraUniform>,
    camera_binding: wgpu::BindGroup,
    mesh_layout: wgpu::BindGroupLayout,
    target: Option<Target>,
}

impl FaceIdPass {
    /// Builds the pipeline.
    ///
    /// # Errors
    /// What the device reports.
    pub fn new(gpu: &Gpu) -> Result<Self, GpuError> {
        let device = gpu.device();
        gpu.scoped(|| {
            let layout = bind_layout(device, "face ids' camera", &[uniform_entry(0)]);
            let mesh_layout = MeshBinding::layout(device);
            let pipeline = RenderStage {
                label: "face ids",
                wgsl: silhouette_shaders::render::FACE_IDS,
                vertex: "face_vertex",
                fragment: "face_id",
                bindings: &[Some(&layout), Some(&mesh_layout)],
                depth: Some(FORMATS.depth_state(FORMATS.nearer())),
                color: FORMATS.color,
                ..RenderStage::default()
            }
            .build(device);
            let camera = UniformBlock::new(device, "face ids' camera");
            let camera_binding = bind_group(device, "face ids' camera", &layout, &[camera.binding()]);
            Self { pipeline, camera, camera_binding, mesh_layout, target: None }
        })
    }

    /// The id of the nearest face plus one at each pixel, 0 where there is none, at `scale` pixels along each side of a pixel
    /// of the camera (1 or more). O(F + pixels).
    ///
    /// # Errors
    /// [`GpuError::Size`], [`GpuError::OverBudget`], [`GpuError::MeshTooLarge`]; what the device reports.
    pub fn draw(&mut self, gpu: &Gpu, mesh: &MeshBuffers, camera: &Camera, scale: u32) -> Result<IdImage, GpuError> {
        let view = view_of_mesh(camera, mesh)?.tile([0; 2], camera.size(), scale.max(1))?;
        let size = view.viewport().size_px;
        let target = match self.target.take() {
            Some(kept) if kept.size() == size => kept,
            _ => Target::new(gpu, size, FORMATS)?,
        };
        let uniform = CameraUniform::new(mesh.frame().to_clip(&view));
        self.camera.write(gpu.queue(), &uniform);
        let binding = gpu.scoped(|| MeshBinding::new(gpu.device(), &self.mesh_layout, mesh, None))??;
        gpu.draw(&target, Load::Clear([0.0; 4]), |pass| {
            if let Some(binding) = &binding {
                pass.set_pipeline(&self.pipeline);
                pass.set_bind_group(0, &self.camera_binding, &[]);
                pass.set_bind_group(1, binding.bind_group(), &[]);
                pass.draw(0..3 * mesh.face_count(), 0..1);
            }
        })?;
        let ids = target.read_ids(gpu);
        self.target = Some(target);
        ids
    }
}
