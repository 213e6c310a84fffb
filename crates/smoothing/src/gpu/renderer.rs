//! [`SmoothingRenderer`]: records a frame's stages and its draw.

use crate::SmoothingView;
use crate::gpu::buffers::FrameBuffers;
use crate::gpu::pipelines::SmoothingPipelines;
use crate::gpu::room::Room;
use crate::gpu::settings::SmoothingUniform;
use crate::perturbation::Perturbation;
use crate::smoothing::Smoothing;
use crate::view_mesh::reach;
use crate::view_mesh_renderer::widened;
use silhouette_core::mesh::Bounds;
use silhouette_core::view::{Camera, ClipRange};
use silhouette_gpu::kit::workgroups;
use silhouette_gpu::{
    CameraBinding, CameraUniform, FrameRenderer, FrameView, MeshBinding, MeshBuffers, RendererError, SurfaceUniform,
    Viewport,
};
use std::sync::Arc;

/// Draws a mesh with smooth silhouettes, lit by Lambert's law with interpolated normals; see [the module](crate::gpu).
///
/// A view uploads about 500 bytes and allocates nothing. Vertices that are moved on the device
/// ([`MeshBuffers::set_positions`], or the caller's own buffer) are followed.
#[derive(Debug)]
pub struct SmoothingRenderer {
    pipelines: Arc<SmoothingPipelines>,
    mesh: Arc<MeshBuffers>,
    /// `None` for a mesh without triangles.
    bound: Option<Bound>,
    perturbs: bool,
    /// Whether there are views in which parts may be left out.
    may_leave_out: bool,
    /// How far the surface may reach beyond the mesh at rest, over the mesh's radius.
    reach: f64,
    /// Of the view last prepared, with whether the mesh had moved.
    prepared: Option<(Viewport, bool)>,
}

#[derive(Debug)]
struct Bound {
    mesh: MeshBinding,
    buffers: FrameBuffers,
    /// The camera with the settings of the stages, and with the light of the surface.
    settings: CameraBinding,
    surface: CameraBinding,
}

impl SmoothingRenderer {
    /// A renderer of one instance of the mesh that `method` was prepared for. O(V + F); per face of a closed mesh about 200 bytes
    /// on the device, and up to 2 MiB beyond.
    ///
    /// # Errors
    /// [`RendererError`]: what is derived from the mesh is too large for the device.
    pub fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        method: &Smoothing,
        pipelines: &Arc<SmoothingPipelines>,
        mesh: &Arc<MeshBuffers>,
    ) -> Result<Self, RendererError> {
        Self::with_room(device, queue, method, pipelines, mesh, Room::for_mesh(method))
    }

    /// The same with another [`Room`]; where it is smaller than what the mesh takes with each curve in one piece, it becomes that.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn with_room(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        method: &Smoothing,
        pipelines: &Arc<SmoothingPipelines>,
        mesh: &Arc<MeshBuffers>,
        room: Room,
    ) -> Result<Self, RendererError> {
        let least = Room::worst(method, 1);
        let room = Room { triangles: room.triangles.max(least.triangles), vertices: room.vertices.max(least.vertices) };
        let bound = match MeshBinding::new(device, &MeshBinding::layout(device), mesh, None)? {
            Some(binding) => {
                let layout = CameraBinding::layout(device);
                Some(Bound {
                    mesh: binding,
                    buffers: FrameBuffers::new(device, queue, pipelines, method, mesh.frame(), room)?,
                    settings: CameraBinding::new(device, &layout, size_of::<SmoothingUniform>()),
                    surface: CameraBinding::new(device, &layout, size_of::<SurfaceUniform>()),
                })
            }
            None => None,
        };
        let mesh_at_rest = method.shading_mesh().mesh();
        let reach = reach(mesh_at_rest).max(method.features().reach());
        let radius = mesh_at_rest.bounds().map_or(0.0, |bounds| bounds.radius);
        Ok(Self {
            pipelines: Arc::clone(pipelines),
            mesh: Arc::clone(mesh),
            bound,
            may_leave_out: method.may_leave_out(),
            perturbs: method.options().perturbation != Perturbation::Off,
            reach: if radius > 0.0 { reach / radius } else { 0.0 },
            prepared: None,
        })
    }

    #[cfg(test)]
    pub(crate) fn buffers(&self) -> &FrameBuffers {
        &self.bound.as_ref().unwrap().buffers
    }
}

impl FrameRenderer for SmoothingRenderer {
    fn prepare(&mut self, _device: &wgpu::Device, queue: &wgpu::Queue, view: &FrameView) -> Result<(), RendererError> {
        let surface = &self.pipelines.surface;
        surface.formats.check(view)?;
        if let Some(bound) = &self.bound {
            let frame = self.mesh.frame();
            let is_whole = |bounds: Bounds| {
                SmoothingView::from_frame(view).holds(bounds.center, bounds.radius * (1.0 + self.reach))
            };
            let leaves_out = self.may_leave_out && self.mesh.bounds().is_some_and(is_whole);
            let settings = bound.buffers.settings.of_view(frame, view, leaves_out);
            bound.settings.write(queue, &CameraUniform::new(frame.to_clip(view)), &settings);
            surface.write(queue, &bound.surface, frame, view);
        }
        self.prepared = Some((view.viewport(), !self.mesh.is_at_rest()));
        Ok(())
    }

    /// Records the compute stages of [the module](crate::gpu) in one pass.
    fn encode(&self, encoder: &mut wgpu::CommandEncoder) {
        let (Some(bound), Some((_, is_moved))) = (&self.bound, self.prepared) else { return };
        let (stages, buffers) = (&*self.pipelines, &bound.buffers);
        let settings = &buffers.settings;
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
        pass.set_bind_group(0, bound.settings.bind_group(), &[]);
        pass.set_bind_group(1, bound.mesh.bind_group(), &[]);
        pass.set_bind_group(2, &buffers.frame_group, &[]);
        if is_moved {
            dispatch(&mut pass, &stages.shading_normals, settings.groups);
            dispatch(&mut pass, &stages.feature_segments, settings.features);
        }
        dispatch(&mut pass, &stages.vertex_visibility, settings.groups);
        dispatch(&mut pass, &stages.silhouette_points, settings.points);
        pass.set_bind_group(1, &stages.no_mesh, &[]);
        pass.set_bind_group(3, &buffers.output_group, &[]);
        dispatch(&mut pass, &stages.count_samples, settings.features);
        dispatch(&mut pass, &stages.silhouette_segments, settings.faces);
        stages.sums.dispatch(&mut pass, &buffers.levels);
        dispatch(&mut pass, &stages.place_samples, settings.features);
        if self.perturbs {
            pass.set_bind_group(1, bound.mesh.bind_group(), &[]);
            dispatch(&mut pass, &stages.perturbation, settings.vertices);
            pass.set_bind_group(1, &stages.no_mesh, &[]);
            pass.set_bind_group(3, &buffers.output_group, &[]);
        }
        dispatch(&mut pass, &stages.remeshing, settings.faces);
    }

    fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        let (Some(bound), Some((viewport, _))) = (&self.bound, self.prepared) else { return };
        viewport.set(pass);
        pass.set_pipeline(&self.pipelines.surface.pipeline);
        pass.set_bind_group(0, bound.surface.bind_group(), &[]);
        pass.set_vertex_buffer(0, bound.buffers.vertices.slice(..));
        pass.set_index_buffer(bound.buffers.indices.slice(..), wgpu::IndexFormat::Uint32);
        pass.draw_indexed_indirect(&bound.buffers.arguments, 0);
    }

    /// Of a mesh that moved, the surface counts as reaching out as far as it does at rest in relation to the mesh's radius.
    fn clip_range(&self, camera: &Camera, mesh: ClipRange) -> ClipRange {
        let bounds = self.mesh.bounds();
        bounds.map_or(mesh, |bounds| widened(camera, &bounds, self.reach * bounds.radius, mesh))
    }
}

/// Runs a stage with the groups that are bound, for each of some elements.
fn dispatch(pass: &mut wgpu::ComputePass<'_>, stage: &wgpu::ComputePipeline, elements: u32) {
    if elements > 0 {
        let [x, y] = workgroups(elements);
        pass.set_pipeline(stage);
        pass.dispatch_workgroups(x, y, 1);
    }
}
