//! Two objects and a camera, as matrices.

use crate::device::Device;
use silhouette_core::glam::dcamera::rh::{proj, view};
use silhouette_core::glam::{DMat4, DQuat, DVec3, Mat4};
use silhouette_core::mesh::Bounds;
use silhouette_core::view::DepthDirection;
use silhouette_core::{TriangleMesh, shapes};
use silhouette_gpu::{FrameView, FrameViewError, Viewport};
use std::error::Error;
use std::sync::Arc;

/// Width and height of the pictures.
pub const SIZE: [u32; 2] = [640, 400];

/// Depth of the near plane; the far one is infinitely far.
const NEAR: f64 = 0.1;

/// How far a vertex of the moving object may come from where it rests.
const SWAY: f64 = 0.15;

/// A mesh of the scene.
pub struct Object {
    pub mesh: Arc<TriangleMesh>,
    /// The mesh's own space to the world.
    pub model: DMat4,
    /// sRGB, as displayed.
    pub color: [f32; 3],
    /// Positions in the mesh's own space, as the engine's vertex stage takes them.
    pub positions: wgpu::Buffer,
    pub indices: wgpu::Buffer,
}

/// What is drawn.
pub struct Scene {
    /// A torus at rest, and a knot that moves.
    pub objects: [Object; 2],
    rest: wgpu::Buffer,
    time: wgpu::Buffer,
    sway: wgpu::ComputePipeline,
    sway_group: wgpu::BindGroup,
    view: DMat4,
    projection: DMat4,
}

impl Scene {
    pub fn new(device: &Device) -> Result<Self, Box<dyn Error>> {
        let turned = DMat4::from_scale_rotation_translation(
            DVec3::new(1.0, 0.6, 1.4),
            DQuat::from_rotation_x(0.9),
            DVec3::new(-1.4, 0.0, 0.0),
        );
        let mirrored = DMat4::from_translation(DVec3::new(1.5, 0.0, -0.5))
            * DMat4::from_rotation_y(0.4)
            * DMat4::from_scale(DVec3::new(-0.8, 0.8, 0.8));
        let torus = Object::new(device, "torus", turned, [0.75, 0.55, 0.35])?;
        let knot = Object::new(device, "knot", mirrored, [0.4, 0.6, 0.75])?;
        let rest = buffer(device, bytemuck::cast_slice(knot.mesh.positions()), wgpu::BufferUsages::STORAGE);
        let time = buffer(device, &[0; 16], wgpu::BufferUsages::UNIFORM);
        let module = device.device.create_shader_module(wgpu::include_wgsl!("sway.wgsl"));
        let sway = device.device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: Some("sway"),
            layout: None,
            module: &module,
            entry_point: Some("sway"),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            cache: None,
        });
        let entry =
            |binding, buffer| wgpu::BindGroupEntry { binding, resource: wgpu::Buffer::as_entire_binding(buffer) };
        let sway_group = device.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("sway"),
            layout: &sway.get_bind_group_layout(0),
            entries: &[entry(0, &time), entry(1, &rest), entry(2, &knot.positions)],
        });
        let view = view::look_at_mat4(DVec3::new(0.3, 1.8, 6.0), DVec3::ZERO, DVec3::Y);
        let aspect = f64::from(SIZE[0]) / f64::from(SIZE[1]);
        let projection = proj::directx::perspective_infinite_reverse(0.7, aspect, NEAR);
        Ok(Self { objects: [torus, knot], rest, time, sway, sway_group, view, projection })
    }

    /// World to clip space, as an engine has it.
    pub fn to_clip(&self, object: &Object) -> Mat4 {
        (self.projection * self.view * object.model).as_mat4()
    }

    /// The same for this workspace's renderers.
    pub fn frame_view(&self, object: &Object) -> Result<FrameView, FrameViewError> {
        FrameView::from_matrices(self.view, self.projection, DepthDirection::Reversed, Viewport::whole(SIZE))?
            .with_model(object.model)
    }

    /// Where the moving object can be, whatever the time.
    pub fn moving_bounds(&self) -> Option<Bounds> {
        let bounds = self.objects[1].mesh.bounds()?;
        let (min, max) = (bounds.min - SWAY, bounds.max + SWAY);
        Some(Bounds { min, max, radius: bounds.radius + SWAY, ..bounds })
    }

    /// Records the stage that moves the knot.
    pub fn animate(&self, device: &Device, encoder: &mut wgpu::CommandEncoder, seconds: f32) {
        device.queue.write_buffer(&self.time, 0, bytemuck::bytes_of(&[seconds, SWAY as f32, 0.0, 0.0]));
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
        pass.set_pipeline(&self.sway);
        pass.set_bind_group(0, &self.sway_group, &[]);
        pass.dispatch_workgroups((self.rest.size() / 12).div_ceil(64) as u32, 1, 1);
    }
}

impl Object {
    fn new(device: &Device, shape: &str, model: DMat4, color: [f32; 3]) -> Result<Self, Box<dyn Error>> {
        let mesh = Arc::new(shapes::by_name(shape)?);
        let usage = wgpu::BufferUsages::VERTEX | wgpu::BufferUsages::STORAGE;
        Ok(Self {
            positions: buffer(device, bytemuck::cast_slice(mesh.positions()), usage),
            indices: buffer(device, bytemuck::cast_slice(mesh.triangles()), wgpu::BufferUsages::INDEX),
            mesh,
            model,
            color,
        })
    }
}

/// A buffer that holds these bytes.
pub fn buffer(device: &Device, bytes: &[u8], usage: wgpu::BufferUsages) -> wgpu::Buffer {
    let buffer = device.device.create_buffer(&wgpu::BufferDescriptor {
        label: None,
        size: bytes.len() as u64,
        usage: usage | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    device.queue.write_buffer(&buffer, 0, bytes);
    buffer
}
