//! [`FaceIdPass`]: which face is nearest at each pixel. Twin of `shaders/render/face_ids.wgsl`.

use crate::error::GpuError;
use crate::gpu::Gpu;
use crate::image::IdImage;
use crate::pass_view::{PassView, Tile};
use crate::submit::Load;
use crate::target::{DEFAULT_FORMATS, Target};
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
        let whole = PassView::new(camera, mesh.bounds(), FORMATS.depth_direction);
        let view = whole.with_tile(Tile { scale: scale.max(1), ..whole.tile });
        let size = view.target_px();
        let target = match self.target.take() {
            Some(kept) if kept.size() == size => kept,
            _ => Target::new(gpu, size, FORMATS)?,
        };
        let uniform = CameraUniform::new(view.local_to_clip(mesh.frame()));
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::gpu_or_skip;
    use glam::Vec3;
    use silhouette_core::TriangleMesh;
    use silhouette_core::view::Projection;

    #[test]
    fn each_pixel_holds_the_nearest_face_and_a_hole_nothing() {
        let Some(gpu) = gpu_or_skip("each_pixel_holds_the_nearest_face_and_a_hole_nothing") else { return };
        // A square of two faces seen from both sides, and a nearer face over its middle.
        let corners = [(-1.0, -1.0, 0.0), (1.0, -1.0, 0.0), (1.0, 1.0, 0.0), (-1.0, 1.0, 0.0)];
        let nearer = [(-0.4, -0.4, 1.0), (0.4, -0.4, 1.0), (0.0, 0.4, 1.0)];
        let positions = corners.into_iter().chain(nearer).map(|(x, y, z)| Vec3::new(x, y, z)).collect();
        let mesh = TriangleMesh::new(positions, vec![[0, 1, 2], [0, 3, 2], [4, 5, 6]]).unwrap();
        let buffers = MeshBuffers::new(gpu.device(), gpu.queue(), &mesh).unwrap();
        let projection = Projection::Orthographic { height: 4.0 };
        let camera = Camera::new(Vec3::Z * 5.0, Vec3::ZERO, Vec3::Y, projection, [40, 40]).unwrap();
        let mut pass = FaceIdPass::new(gpu).unwrap();
        for scale in [1, 2] {
            let ids = pass.draw(gpu, &buffers, &camera, scale).unwrap();
            assert_eq!([ids.width, ids.height], [40 * scale; 2]);
            let at = |x: f64, y: f64| {
                let pixel = |along: f64| ((along + 2.0) * 10.0 * f64::from(scale)) as usize;
                ids.values[pixel(-y) * ids.width as usize + pixel(x)]
            };
            assert_eq!([at(0.8, -0.8), at(-0.8, 0.8), at(0.01, -0.1), at(1.5, 0.0)], [1, 2, 3, 0]);
        }
        let empty = TriangleMesh::new(Vec::new(), Vec::new()).unwrap();
        let nothing = MeshBuffers::new(gpu.device(), gpu.queue(), &empty).unwrap();
        assert!(pass.draw(gpu, &nothing, &camera, 1).unwrap().values.iter().all(|&value| value == 0));
        let colour = Target::new(gpu, [4, 4], DEFAULT_FORMATS).unwrap();
        assert!(matches!(colour.read_ids(gpu), Err(GpuError::ColorFormat(_))));
    }
}
