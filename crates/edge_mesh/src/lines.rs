//! Steps 2 to 4 on the device, for one renderer. Stage of step 4: `shaders/edge_mesh/lines.wgsl`.

use crate::chunks::{ChunkIndices, chunks, point_bits};
use crate::drawn_edges::{DrawnEdgesStage, DrawnLists};
use crate::edge_buffers::EdgeBuffers;
use crate::face_planes::FacePlanes;
use crate::method::EdgeMesh;
use crate::options::{CreasesChoice, EdgeMeshOptions, FacingChoice, PathChoice};
use crate::silhouette_chunks::SilhouetteChunks;
use crate::style::StyleUniform;
use silhouette_core::{FaceFacings, TriangleMesh, Viewpoint};
use silhouette_gpu::kit::{RenderStage, bind_layout, buffers_group, storage_buffer, storage_entry};
use silhouette_gpu::{CameraBinding, CameraUniform, FrameView, MeshBinding, MeshBuffers, MeshTooLarge, TargetFormats};
use std::sync::Arc;

/// The stages of lines, for all renderers.
#[derive(Debug)]
pub(crate) struct LineStages {
    options: EdgeMeshOptions,
    edges: wgpu::BindGroupLayout,
    face_planes: FacePlanes,
    /// Where a compute pass lists what is drawn.
    drawn_edges: Option<DrawnEdgesStage>,
    silhouettes: wgpu::RenderPipeline,
    features: Option<wgpu::RenderPipeline>,
}

impl LineStages {
    pub fn new(device: &wgpu::Device, options: &EdgeMeshOptions, formats: TargetFormats) -> Self {
        let (camera, mesh) = (CameraBinding::layout(device), MeshBinding::layout(device));
        let edges = bind_layout(device, "edges", &[0, 1, 2].map(|binding| storage_entry(binding, true)));
        let drawn_edges =
            (options.path == PathChoice::Compacted).then(|| DrawnEdgesStage::new(device, [&camera, &mesh, &edges]));
        let list = drawn_edges.as_ref().map(DrawnEdgesStage::drawing_layout);
        let mut bindings = vec![Some(&camera), Some(&mesh), Some(&edges)];
        bindings.extend(list.map(Some));
        let stage = |vertex, fragment, writes_depth| {
            let mut depth = formats.depth_state(formats.nearer_or_equal());
            depth.depth_write_enabled = Some(writes_depth);
            RenderStage {
                label: "edge mesh: lines",
                wgsl: silhouette_shaders::edge_mesh::LINES,
                vertex,
                fragment,
                bindings: &bindings,
                depth: Some(depth),
                color: formats.color,
                blend: (options.ink_alpha < 1.0).then_some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING),
                samples: formats.samples,
                ..RenderStage::default()
            }
            .build(device)
        };
        let is_listed = list.is_some();
        let silhouettes = if is_listed { "listed_silhouette" } else { "silhouette_of_edge" };
        let features = if is_listed { "listed_feature" } else { "feature_of_edge" };
        let draws_features = options.draws_by_angle() || options.creases == CreasesChoice::Given;
        Self {
            options: *options,
            silhouettes: stage(silhouettes, "silhouette_ink", true),
            // Features lie on faces whose depth is there already; without depth of their own, silhouettes cover them.
            features: draws_features.then(|| stage(features, "feature_ink", false)),
            face_planes: FacePlanes::new(device),
            edges,
            drawn_edges,
        }
    }
}

/// The lines of one instance.
#[derive(Debug)]
pub(crate) struct Lines {
    stages: Arc<LineStages>,
    at_rest: Arc<TriangleMesh>,
    /// Held so that the next renderer finds the records on the device.
    _edges: Arc<EdgeBuffers>,
    counts: Counts,
    facings: FaceFacings,
    facing: wgpu::Buffer,
    normals: wgpu::Buffer,
    /// The viewpoint for which `facing` holds exact facings.
    exact_for: Option<Viewpoint>,
    chunks: SilhouetteChunks,
    binding: CameraBinding,
    mesh: MeshBinding,
    bound_edges: wgpu::BindGroup,
    planes: wgpu::BindGroup,
    indices: [ChunkIndices; 2],
    lists: Option<DrawnLists>,
    /// What the view last prepared draws.
    drawn: Drawn,
}

#[derive(Debug, Clone, Copy)]
struct Counts {
    faces: u32,
    edges: u32,
    /// Records that are features at rest.
    features: u32,
    /// Records that may be features when the mesh moves.
    moving_features: u32,
}

#[derive(Debug, Clone, Copy, Default)]
struct Drawn {
    /// Whether faces are classified on the device.
    on_device: bool,
    /// Whether ridges and valleys are found from this frame's normals.
    bends_now: bool,
    /// Records that may be features.
    features: u32,
}

impl Lines {
    /// `None` for a mesh without triangles.
    pub fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        stages: &Arc<LineStages>,
        method: &EdgeMesh,
        mesh: &MeshBuffers,
    ) -> Result<Option<Self>, MeshTooLarge> {
        let Some(mesh_binding) = MeshBinding::new(device, &MeshBinding::layout(device), mesh, None)? else {
            return Ok(None);
        };
        let edges = method.on_devices.get(device, queue, method.records())?;
        // A mesh has fewer than 2^29 faces and 2^31 half-edges.
        let (edge_count, features) = (method.records().len() as u32, method.feature_count() as u32);
        let by_angle = stages.options.draws_by_angle();
        let moving_features = if by_angle { edge_count } else { features };
        let counts = Counts { faces: mesh.face_count(), edges: edge_count, features, moving_features };
        let source = wgpu::BufferUsages::COPY_SRC;
        let facing = storage_buffer(device, "facings", 8 * u64::from(counts.faces.div_ceil(64)), source)?;
        let normal_count = if by_angle { counts.faces } else { 0 };
        let normals = storage_buffer(device, "normals", 4 * u64::from(normal_count), source)?;
        let lists = match &stages.drawn_edges {
            Some(stage) => Some(DrawnLists::new(device, stage, edge_count, moving_features)?),
            None => None,
        };
        let bound = [&edges.records, &facing, &normals];
        Ok(Some(Self {
            at_rest: Arc::clone(method.mesh()),
            facings: FaceFacings::default(),
            exact_for: None,
            chunks: SilhouetteChunks::new(method),
            binding: CameraBinding::new(device, &CameraBinding::layout(device), size_of::<StyleUniform>()),
            mesh: mesh_binding,
            bound_edges: buffers_group(device, "edges", &stages.edges, &bound),
            planes: stages.face_planes.bind(device, &facing, &normals),
            indices: [1, 1].map(|end_sides| ChunkIndices::new(device, queue, end_sides)),
            drawn: Drawn::default(),
            stages: Arc::clone(stages),
            _edges: edges,
            counts,
            facing,
            normals,
            lists,
        }))
    }

    /// Uploads a view whose style is filled in but for counts and bits.
    pub fn prepare(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        view: &FrameView,
        camera: &CameraUniform,
        mut style: StyleUniform,
        is_at_rest: bool,
    ) {
        let on_device = !is_at_rest || self.stages.options.facing == FacingChoice::Device;
        if on_device {
            self.exact_for = None;
        } else {
            self.classify(queue, view.viewpoint());
        }
        let bends_now = !is_at_rest && self.stages.options.draws_by_angle();
        let Counts { features, moving_features, .. } = self.counts;
        self.drawn = Drawn { on_device, bends_now, features: if bends_now { moving_features } else { features } };
        let sides = [0, 1].map(|pen: usize| style.pens[pen].shape.end_sides);
        for (indices, sides) in self.indices.iter_mut().zip(sides) {
            indices.fit(device, queue, sides);
        }
        if let Some(lists) = &mut self.lists {
            lists.prepare(queue, [0, 1].map(|list: usize| self.indices[list].count()));
        }
        [style.silhouette_bits, style.feature_bits] = sides.map(point_bits);
        style.faces = self.counts.faces;
        style.edges = self.counts.edges;
        style.features = self.drawn.features;
        style.bends_now = u32::from(bends_now);
        self.binding.write(queue, camera, &style);
    }

    /// Decides facings by exact arithmetic, and uploads them: a bit per face.
    fn classify(&mut self, queue: &wgpu::Queue, viewpoint: Viewpoint) {
        if self.exact_for != Some(viewpoint) {
            self.facings.classify(&self.at_rest, &viewpoint);
            queue.write_buffer(&self.facing, 0, bytemuck::cast_slice(self.facings.words()));
            if self.lists.is_none() {
                self.chunks.find(&self.facings);
            }
            self.exact_for = Some(viewpoint);
        }
    }

    /// Records what comes before the pass.
    pub fn encode(&self, encoder: &mut wgpu::CommandEncoder) {
        if !self.drawn.on_device && self.lists.is_none() {
            return;
        }
        if let Some(lists) = &self.lists {
            lists.clear(encoder);
        }
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
        pass.set_bind_group(0, self.binding.bind_group(), &[]);
        pass.set_bind_group(1, self.mesh.bind_group(), &[]);
        if self.drawn.on_device {
            self.stages.face_planes.dispatch(&mut pass, &self.planes, self.counts.faces);
        }
        if let (Some(lists), Some(stage)) = (&self.lists, &self.stages.drawn_edges) {
            pass.set_bind_group(2, &self.bound_edges, &[]);
            lists.dispatch(&mut pass, stage);
        }
    }

    /// Records features, then silhouettes.
    pub fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        pass.set_bind_group(0, self.binding.bind_group(), &[]);
        pass.set_bind_group(1, self.mesh.bind_group(), &[]);
        pass.set_bind_group(2, &self.bound_edges, &[]);
        let features = self.stages.features.as_ref().filter(|_| self.drawn.features > 0);
        for (list, pipeline) in [(1, features), (0, Some(&self.stages.silhouettes))] {
            let Some(pipeline) = pipeline else { continue };
            let indices = &self.indices[list];
            pass.set_pipeline(pipeline);
            if let Some(lists) = &self.lists {
                lists.draw(pass, list, indices);
                continue;
            }
            indices.set(pass);
            if list == 0 && self.exact_for.is_some() {
                for chunks in self.chunks.runs() {
                    pass.draw_indexed(0..indices.count(), 0, chunks);
                }
            } else {
                let edges = if list == 0 { self.counts.edges } else { self.drawn.features };
                pass.draw_indexed(0..indices.count(), 0, 0..chunks(edges));
            }
        }
    }

    /// The lists of the view last encoded; `None` where the vertex stage decides.
    pub fn lists(&self) -> Option<[&wgpu::Buffer; 2]> {
        self.lists.as_ref().map(DrawnLists::buffers)
    }

    /// The normals of the view last encoded; `None` where none were asked for.
    pub fn normals(&self) -> Option<&wgpu::Buffer> {
        self.drawn.bends_now.then_some(&self.normals)
    }

    /// The facings of the view last encoded.
    pub fn facing(&self) -> &wgpu::Buffer {
        &self.facing
    }
}
