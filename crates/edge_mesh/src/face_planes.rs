//! Step 2 on the device: facing and normal of every face, from this frame's positions. Stage: `shaders/edge_mesh/face_planes.wgsl`;
//! [`is_front`] and [`normal`] are its twins.
//!
//! A face whose plane passes within rounding of the viewer may face either way here. Whichever way it is, it is decided once, so
//! that silhouettes stay closed.

use silhouette_core::glam::{Vec3, Vec4};
use silhouette_gpu::kit::{bind_layout, buffers_group, compute_pipeline, storage_entry, workgroups};
use silhouette_gpu::{CameraBinding, MeshBinding};

/// Whether a face with these corners is front for a viewer, both in the mesh's local frame: an eye with w = 1, or a direction
/// towards the viewer with w = 0. In 32 bits, as the stage decides it.
pub fn is_front(corners: [Vec3; 3], viewer: Vec4) -> bool {
    (cross(corners)).dot(viewer.truncate() - corners[0] * viewer.w) > 0.0
}

/// The normal of a face with these corners as it is [stored](crate::oct_normal).
pub fn normal(corners: [Vec3; 3]) -> u32 {
    crate::oct_normal::encode(cross(corners))
}

fn cross([a, b, c]: [Vec3; 3]) -> Vec3 {
    (b - a).cross(c - a)
}

/// The stage, for all renderers.
#[derive(Debug)]
pub(crate) struct FacePlanes {
    layout: wgpu::BindGroupLayout,
    pipeline: wgpu::ComputePipeline,
}

impl FacePlanes {
    pub fn new(device: &wgpu::Device) -> Self {
        let layout = bind_layout(device, "planes of faces", &[storage_entry(0, false), storage_entry(1, false)]);
        let (camera, mesh) = (CameraBinding::layout(device), MeshBinding::layout(device));
        let bindings = [Some(&camera), Some(&mesh), Some(&layout)];
        let wgsl = silhouette_shaders::edge_mesh::FACE_PLANES;
        Self { pipeline: compute_pipeline(device, wgsl, "face_planes", &bindings), layout }
    }

    /// What the stage writes: a bit per face, and a word per face where normals are asked for.
    pub fn bind(&self, device: &wgpu::Device, facing: &wgpu::Buffer, normals: &wgpu::Buffer) -> wgpu::BindGroup {
        buffers_group(device, "planes of faces", &self.layout, &[facing, normals])
    }

    /// Runs the stage, with the camera and the mesh bound.
    pub fn dispatch(&self, pass: &mut wgpu::ComputePass<'_>, written: &wgpu::BindGroup, faces: u32) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(2, written, &[]);
        let [x, y] = workgroups(faces.div_ceil(32));
        pass.dispatch_workgroups(x, y, 1);
    }
}
