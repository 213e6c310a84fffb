//! [`InvertedHullRenderer`]: all steps in the caller's render pass, and the normals of a mesh that moves before it.

use super::hull::{self, HullUniform};
use super::method::{HullNormals, InvertedHull};
use super::outline_normals::OutlineNormals;
use silhouette_core::mesh::Bounds;
use silhouette_gpu::kit::{
    WoundPipeline, bind_layout, buffers_group, compute_pipeline, storage_buffer, storage_entry, workgroups,
};
use silhouette_gpu::{
    CameraBinding, CameraUniform, Cull, DrawsLines, FillPipelines, FillRenderer, FrameRenderer, FrameView, MeshBinding,
    MeshBuffers, MeshTooLarge, PenPlacement, RendererError, TargetFormats, Viewport,
};
use silhouette_shaders::baselines::OUTLINE_NORMALS;
use std::sync::Arc;

/// What all renderers with the same options, on the same device and formats, share.
#[derive(Debug)]
pub struct InvertedHullPipelines {
    formats: TargetFormats,
    interior: Option<Arc<FillPipelines>>,
    hull: WoundPipeline,
    find_normals: Option<NormalsStage>,
}

/// The stage that makes the normals of a mesh that moves.
#[derive(Debug)]
struct NormalsStage {
    layout: wgpu::BindGroupLayout,
    pipeline: wgpu::ComputePipeline,
}

impl NormalsStage {
    fn new(device: &wgpu::Device) -> Self {
        let layout = bind_layout(device, "finding normals", &[0, 1, 2].map(|at| storage_entry(at, at < 2)));
        let (camera, mesh) = (CameraBinding::layout(device), MeshBinding::layout(device));
        let bindings = [Some(&camera), Some(&mesh), Some(&layout)];
        let pipeline = compute_pipeline(device, OUTLINE_NORMALS, "find_outline_normals", &bindings);
        Self { layout, pipeline }
    }
}

/// The places of a mesh's vertices on the device, with their normals.
#[derive(Debug)]
struct Normals {
    places: u32,
    finding: wgpu::BindGroup,
    drawing: wgpu::BindGroup,
}

impl Normals {
    fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        stage: &NormalsStage,
        normals: &OutlineNormals,
    ) -> Result<Self, MeshTooLarge> {
        let upload = |label, bytes: &[u8]| {
            let buffer = storage_buffer(device, label, bytes.len() as u64, wgpu::BufferUsages::empty())?;
            queue.write_buffer(&buffer, 0, bytes);
            Ok(buffer)
        };
        let at_rest: Vec<[f32; 4]> = normals.normals().iter().map(|normal| normal.extend(0.0).to_array()).collect();
        let place_of = upload("places of vertices", bytemuck::cast_slice(normals.place_of()))?;
        let first_corners = upload("first corners of places", bytemuck::cast_slice(normals.first_corners()))?;
        let corners = upload("corners of places", bytemuck::cast_slice(normals.corners()))?;
        let held = upload("outline normals", bytemuck::cast_slice(&at_rest))?;
        Ok(Self {
            // A mesh has fewer than 2^32 vertices, by validation.
            places: normals.places() as u32,
            finding: buffers_group(device, "finding normals", &stage.layout, &[&first_corners, &corners, &held]),
            drawing: buffers_group(device, "outline normals", &hull::normals_layout(device), &[&place_of, &held]),
        })
    }
}

impl DrawsLines for InvertedHull {
    type Pipelines = InvertedHullPipelines;
    type Renderer = InvertedHullRenderer;

    fn pen_placement(&self) -> PenPlacement {
        PenPlacement::Outside
    }

    fn pipelines(&self, device: &wgpu::Device, formats: TargetFormats) -> Result<InvertedHullPipelines, RendererError> {
        let is_welded = self.options.normals == HullNormals::Welded;
        Ok(InvertedHullPipelines {
            formats,
            interior: self.options.line_style().interior(device, formats, Cull::Back),
            hull: hull::pipeline(device, formats, &self.options, is_welded),
            find_normals: is_welded.then(|| NormalsStage::new(device)),
        })
    }

    /// Uploads the places and their normals. Pipelines must be of a method with the same `normals`.
    fn renderer(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        pipelines: &Arc<InvertedHullPipelines>,
        mesh: &Arc<MeshBuffers>,
    ) -> Result<InvertedHullRenderer, RendererError> {
        let placed = self.normals.as_ref().map_or(0, |normals| normals.vertex_count());
        if mesh.face_count() > 0 && placed > mesh.vertex_count() {
            return Err(RendererError::OtherForm { what: "meshes" });
        }
        let normals = match (&pipelines.find_normals, &self.normals) {
            (Some(stage), Some(normals)) => Some(Normals::new(device, queue, stage, normals)?),
            (None, None) => None,
            _ => return Err(RendererError::OtherForm { what: "normals" }),
        };
        Ok(InvertedHullRenderer {
            method: self.clone(),
            interior: pipelines.interior.as_ref().map(|interior| FillRenderer::new(device, interior, mesh)),
            pipelines: Arc::clone(pipelines),
            mesh_binding: MeshBinding::new(device, &MeshBinding::layout(device), mesh, None)?,
            mesh: Arc::clone(mesh),
            binding: CameraBinding::new(device, &CameraBinding::layout(device), size_of::<HullUniform>()),
            normals,
            prepared: None,
        })
    }
}

/// Draws a mesh and its hull.
///
/// While the mesh is [at rest](MeshBuffers::is_at_rest), the normals are those of its preparation; from the first time on that its
/// positions were replaced, they are found anew on the device in every frame, for the places where vertices lay at rest.
#[derive(Debug)]
pub struct InvertedHullRenderer {
    method: InvertedHull,
    pipelines: Arc<InvertedHullPipelines>,
    mesh: Arc<MeshBuffers>,
    mesh_binding: Option<MeshBinding>,
    binding: CameraBinding,
    interior: Option<FillRenderer>,
    normals: Option<Normals>,
    prepared: Option<Prepared>,
}

/// What the view last prepared comes to.
#[derive(Debug)]
struct Prepared {
    viewport: Viewport,
    hull: wgpu::RenderPipeline,
    moves: bool,
    is_eye_within: bool,
}

impl FrameRenderer for InvertedHullRenderer {
    fn prepare(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, view: &FrameView) -> Result<(), RendererError> {
        let InvertedHullPipelines { formats, hull, .. } = &*self.pipelines;
        formats.check(view)?;
        let Some(bounds) = self.mesh.bounds() else { return Ok(()) };
        if let Some(interior) = &mut self.interior {
            interior.prepare(device, queue, view)?;
        }
        let frame = self.mesh.frame();
        let uniform = HullUniform::new(&self.method.options, view, &bounds, frame, formats);
        self.binding.write(queue, &CameraUniform::new(frame.to_clip(view)), &uniform);
        self.prepared = Some(Prepared {
            viewport: view.viewport(),
            hull: hull.get(view.is_mirrored()).clone(),
            moves: !self.mesh.is_at_rest(),
            is_eye_within: is_eye_within(view, &bounds),
        });
        Ok(())
    }

    fn encode(&self, encoder: &mut wgpu::CommandEncoder) {
        let moves = self.prepared.as_ref().is_some_and(|prepared| prepared.moves);
        let (Some(stage), Some(normals), Some(mesh)) =
            (&self.pipelines.find_normals, &self.normals, &self.mesh_binding)
        else {
            return;
        };
        if moves {
            let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
            pass.set_bind_group(0, self.binding.bind_group(), &[]);
            pass.set_bind_group(1, mesh.bind_group(), &[]);
            pass.set_bind_group(2, &normals.finding, &[]);
            pass.set_pipeline(&stage.pipeline);
            let [x, y] = workgroups(normals.places);
            pass.dispatch_workgroups(x, y, 1);
        }
    }

    fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        let (Some(prepared), Some(mesh)) = (&self.prepared, &self.mesh_binding) else { return };
        if let Some(interior) = &self.interior {
            interior.draw(pass);
        }
        prepared.viewport.set(pass);
        pass.set_pipeline(&prepared.hull);
        pass.set_bind_group(0, self.binding.bind_group(), &[]);
        pass.set_bind_group(1, mesh.bind_group(), &[]);
        match &self.normals {
            Some(normals) => {
                pass.set_bind_group(2, &normals.drawing, &[]);
                self.mesh.draw(pass);
            }
            None => pass.draw(0..3 * self.mesh.face_count(), 0..1),
        }
    }

    fn warning(&self) -> Option<String> {
        let is_within = self.prepared.as_ref().is_some_and(|prepared| prepared.is_eye_within);
        is_within.then(|| {
            "the eye is within the bounds of the mesh: from inside, back faces cover the view with ink; use \
             image-precision, which leaves them out"
                .to_owned()
        })
    }
}

/// Whether the eye of a perspective view lies in the box around a mesh.
fn is_eye_within(view: &FrameView, bounds: &Bounds) -> bool {
    let eye = view.object_eye().truncate();
    view.is_perspective() && eye.cmpge(bounds.min).all() && eye.cmple(bounds.max).all()
}
