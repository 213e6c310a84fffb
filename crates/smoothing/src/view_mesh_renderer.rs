//! [`ViewMeshRenderer`]: draws the triangles that a [`Remesher`] makes for each view. Stage: `shaders/smoothing/view_mesh.wgsl`.

use crate::eye::{Eye, SmoothingView};
use crate::view_mesh::{Remesher, ViewMesh};
use silhouette_core::glam::Vec3;
use silhouette_core::mesh::Bounds;
use silhouette_core::view::{Camera, ClipRange};
use silhouette_gpu::kit::RenderStage;
use silhouette_gpu::{
    CameraBinding, CameraUniform, Color, FrameRenderer, FrameView, LocalFrame, MeshBuffers, MeshTooLarge,
    RendererError, Shade, SurfaceUniform, TargetFormats, Viewport,
};
use std::sync::Arc;

/// Bytes of a vertex: position in the local frame, then the normal.
pub(crate) const VERTEX_BYTES: u64 = 24;

/// Bytes of a triangle.
pub(crate) const TRIANGLE_BYTES: u64 = 12;

const VERTEX_LAYOUT: wgpu::VertexBufferLayout<'static> = wgpu::VertexBufferLayout {
    array_stride: VERTEX_BYTES,
    step_mode: wgpu::VertexStepMode::Vertex,
    attributes: &wgpu::vertex_attr_array![0 => Float32x3, 1 => Float32x3],
};

impl SmoothingView {
    /// The view of a frame, in the mesh's own space whatever its model matrix.
    pub fn from_frame(frame: &FrameView) -> Self {
        let eye = frame.object_eye();
        let eye = if frame.is_perspective() { eye } else { eye.truncate().normalize_or_zero().extend(0.0) };
        Self::new(Eye::new(eye), frame.object_to_clip(), frame.viewport().size_px)
    }
}

/// The pipeline of a colour, for all meshes.
#[derive(Debug)]
pub struct ViewMeshPipelines {
    pub(crate) pipeline: wgpu::RenderPipeline,
    pub(crate) formats: TargetFormats,
    shade: Shade,
}

impl ViewMeshPipelines {
    /// Builds the pipeline, which draws both sides of each triangle. Some milliseconds.
    pub fn new(device: &wgpu::Device, formats: TargetFormats, shade: Shade) -> Self {
        let is_opaque = match shade {
            Shade::Flat(color) | Shade::Lit(color) => color.alpha >= 1.0,
            Shade::DepthOnly => true,
        };
        let writes = if shade == Shade::DepthOnly { wgpu::ColorWrites::empty() } else { wgpu::ColorWrites::ALL };
        let pipeline = RenderStage {
            label: "view mesh",
            wgsl: silhouette_shaders::smoothing::VIEW_MESH,
            vertex: "view_mesh_vertex",
            fragment: if matches!(shade, Shade::Lit(_)) { "view_mesh_lit" } else { "view_mesh_flat" },
            bindings: &[Some(&CameraBinding::layout(device))],
            vertex_buffers: &[Some(VERTEX_LAYOUT)],
            depth: Some(formats.depth_state(formats.nearer())),
            color: formats.color,
            blend: (!is_opaque).then_some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING),
            writes,
            samples: formats.samples,
            ..RenderStage::default()
        }
        .build(device);
        Self { pipeline, formats, shade }
    }

    /// Uploads what the stages know of a view of a mesh in `frame`.
    pub(crate) fn write(&self, queue: &wgpu::Queue, binding: &CameraBinding, frame: &LocalFrame, view: &FrameView) {
        let color = match self.shade {
            Shade::Flat(color) | Shade::Lit(color) => color,
            Shade::DepthOnly => Color::TRANSPARENT,
        };
        let uniform = SurfaceUniform::new(frame, view, color, self.formats.is_linear());
        binding.write(queue, &CameraUniform::new(frame.to_clip(view)), &uniform);
    }
}

/// The depths of `mesh` and of all that reaches at most `reach` beyond its bounds.
pub(crate) fn widened(camera: &Camera, bounds: &Bounds, reach: f64, mesh: ClipRange) -> ClipRange {
    let widened = camera.clip_range(&Bounds { radius: bounds.radius + reach, ..*bounds });
    ClipRange { near: widened.near.min(mesh.near), far: widened.far.max(mesh.far) }
}

/// Draws what a [`Remesher`] makes, lit by Lambert's law with interpolated normals, nearest in front.
///
/// Triangles are made on the CPU from the mesh at rest. Of a mesh whose positions were replaced on the device they are still
/// those of the mesh at rest, with a [warning](FrameRenderer::warning). They are uploaded when they may differ from those of
/// the frame before: 24 bytes per vertex and 12 per triangle.
pub struct ViewMeshRenderer<R> {
    pipelines: Arc<ViewMeshPipelines>,
    mesh: Arc<MeshBuffers>,
    remesher: R,
    reach: f64,
    triangles: ViewMesh,
    buffers: Option<Buffers>,
    binding: CameraBinding,
    /// Of the view last prepared.
    viewport: Option<Viewport>,
    is_moved: bool,
}

/// Vertices and triangles on the device; they have room for more than they hold.
#[derive(Debug)]
struct Buffers {
    vertices: wgpu::Buffer,
    indices: wgpu::Buffer,
    /// Indices that are drawn.
    count: u32,
}

impl<R: Remesher> ViewMeshRenderer<R> {
    /// A renderer of one instance of a mesh, which `remesher` was made for. Its triangles lie at most `reach` outside of the
    /// mesh's bounds, in the mesh's own units: [`view_mesh::reach`](crate::view_mesh::reach), unless they may reach farther.
    pub fn new(
        device: &wgpu::Device,
        pipelines: &Arc<ViewMeshPipelines>,
        mesh: &Arc<MeshBuffers>,
        remesher: R,
        reach: f64,
    ) -> Self {
        Self {
            pipelines: Arc::clone(pipelines),
            mesh: Arc::clone(mesh),
            remesher,
            reach,
            triangles: ViewMesh::default(),
            buffers: None,
            binding: CameraBinding::new(device, &CameraBinding::layout(device), size_of::<SurfaceUniform>()),
            viewport: None,
            is_moved: false,
        }
    }

    /// The triangles of the view last prepared.
    pub fn view_mesh(&self) -> &ViewMesh {
        &self.triangles
    }
}

impl<R: Remesher> FrameRenderer for ViewMeshRenderer<R> {
    fn prepare(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, view: &FrameView) -> Result<(), RendererError> {
        self.pipelines.formats.check(view)?;
        self.viewport = None;
        let may_differ = self.remesher.remesh(&SmoothingView::from_frame(view), &mut self.triangles);
        let frame = self.mesh.frame();
        if may_differ || self.buffers.is_none() {
            // If there is no room, the next frame tries again.
            let grown = Buffers::for_room(device, self.buffers.take(), &self.triangles)?;
            self.buffers = Some(grown.filled(queue, frame, &self.triangles));
        }
        self.pipelines.write(queue, &self.binding, frame, view);
        self.viewport = Some(view.viewport());
        self.is_moved = !self.mesh.is_at_rest();
        Ok(())
    }

    fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        let (Some(viewport), Some(buffers)) = (&self.viewport, &self.buffers) else { return };
        if buffers.count == 0 {
            return;
        }
        viewport.set(pass);
        pass.set_pipeline(&self.pipelines.pipeline);
        pass.set_bind_group(0, self.binding.bind_group(), &[]);
        pass.set_vertex_buffer(0, buffers.vertices.slice(..));
        pass.set_index_buffer(buffers.indices.slice(..), wgpu::IndexFormat::Uint32);
        pass.draw_indexed(0..buffers.count, 0, 0..1);
    }

    fn warning(&self) -> Option<String> {
        let text = "the vertices have been moved on the device, but the surface is made on the CPU from the mesh at rest; \
                    make a new mesh of the moved vertices";
        self.is_moved.then(|| text.to_owned())
    }

    fn clip_range(&self, camera: &Camera, mesh: ClipRange) -> ClipRange {
        self.mesh.bounds().map_or(mesh, |bounds| widened(camera, &bounds, self.reach, mesh))
    }
}

impl Buffers {
    /// The buffers themselves if they have room for `mesh`, or new ones with some to spare.
    fn for_room(device: &wgpu::Device, buffers: Option<Self>, mesh: &ViewMesh) -> Result<Self, MeshTooLarge> {
        let limit = device.limits().max_buffer_size;
        let with_room = |buffer: Option<wgpu::Buffer>, what, count: usize, bytes_each: u64, usage| {
            let bytes = count as u64 * bytes_each;
            if bytes > limit {
                return Err(MeshTooLarge { what, bytes, limit });
            }
            Ok(buffer.filter(|buffer| buffer.size() >= bytes).unwrap_or_else(|| {
                device.create_buffer(&wgpu::BufferDescriptor {
                    label: Some(what),
                    size: (bytes + bytes / 4).clamp(bytes_each, limit).next_multiple_of(4),
                    usage: usage | wgpu::BufferUsages::COPY_DST,
                    mapped_at_creation: false,
                })
            }))
        };
        let (vertices, indices) = buffers.map(|Self { vertices, indices, .. }| (vertices, indices)).unzip();
        Ok(Self {
            vertices: with_room(
                vertices,
                "vertices of the surface",
                mesh.positions.len(),
                VERTEX_BYTES,
                wgpu::BufferUsages::VERTEX,
            )?,
            indices: with_room(
                indices,
                "triangles of the surface",
                mesh.triangles.len(),
                TRIANGLE_BYTES,
                wgpu::BufferUsages::INDEX,
            )?,
            count: 0,
        })
    }

    /// The same buffers with `mesh` in them, for which they have room.
    fn filled(self, queue: &wgpu::Queue, frame: &LocalFrame, mesh: &ViewMesh) -> Self {
        let size = wgpu::BufferSize::new(VERTEX_BYTES * mesh.positions.len() as u64);
        if let Some(mut view) = size.and_then(|size| queue.write_buffer_with(&self.vertices, 0, size)) {
            let vertex = |(position, normal): (&Vec3, &Vec3)| {
                bytemuck::cast([frame.to_local(position.as_dvec3()).to_array(), normal.to_array()])
            };
            let (places, _) = view.slice(..).into_chunks::<{ VERTEX_BYTES as usize }>();
            places.write_iter(mesh.positions.iter().zip(&mesh.normals).map(vertex));
        }
        if !mesh.triangles.is_empty() {
            queue.write_buffer(&self.indices, 0, bytemuck::cast_slice(&mesh.triangles));
        }
        Self { count: 3 * mesh.triangles.len() as u32, ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shading_mesh::ShadingMesh;
    use crate::shading_normals::NormalWeights;
    use crate::view_mesh::Origin;
    use crate::view_mesh::reach;
    use silhouette_core::TriangleMesh;
    use silhouette_core::glam::{DMat4, DQuat, DVec3};
    use silhouette_core::view::{DepthDirection, Framing};
    use silhouette_core::{FaceId, NoProgress, PreparedMesh};
    use silhouette_gpu::{Cull, FillPipelines, FillRenderer, FillStyle};
    use silhouette_render::{DEFAULT_FORMATS, DepthImage, Gpu, Image, Load, Target};
    use silhouette_testing::views::{PERSPECTIVE, three_quarter};
    use silhouette_testing::{builtin, gpu_or_skip, zoo};

    const WHITE: Shade = Shade::Lit(Color::WHITE);

    /// The mesh as it is, up to a number of faces that grows from call to call.
    struct AsItIs {
        mesh: ShadingMesh,
        faces: usize,
        step: usize,
    }

    impl AsItIs {
        fn new(mesh: &TriangleMesh) -> Self {
            let prepared = PreparedMesh::new(mesh.clone());
            let mesh = ShadingMesh::new(&prepared, 75.0, NormalWeights::Area, "test", &NoProgress).unwrap();
            Self { faces: mesh.triangles().len(), step: 0, mesh }
        }
    }

    impl Remesher for AsItIs {
        fn remesh(&mut self, _view: &SmoothingView, out: &mut ViewMesh) -> bool {
            let is_first = out.triangles.is_empty();
            out.clear();
            let origin = Origin { face: FaceId::new(0), weights: [1.0, 0.0, 0.0] };
            for (position, normal) in self.mesh.positions().iter().zip(self.mesh.normals()) {
                out.push_vertex(position.as_dvec3(), normal.as_dvec3(), origin);
            }
            self.mesh.triangles().iter().take(self.faces).for_each(|&corners| out.push_triangle(corners));
            self.faces += self.step;
            is_first || self.step > 0
        }
    }

    fn buffers(gpu: &Gpu, mesh: &TriangleMesh) -> Arc<MeshBuffers> {
        Arc::new(MeshBuffers::new(gpu.device(), gpu.queue(), mesh).unwrap())
    }

    fn renderer(gpu: &Gpu, formats: TargetFormats, mesh: &TriangleMesh) -> ViewMeshRenderer<AsItIs> {
        let pipelines = Arc::new(ViewMeshPipelines::new(gpu.device(), formats, WHITE));
        ViewMeshRenderer::new(gpu.device(), &pipelines, &buffers(gpu, mesh), AsItIs::new(mesh), reach(mesh))
    }

    fn picture(
        gpu: &Gpu,
        formats: TargetFormats,
        renderer: &mut dyn FrameRenderer,
        view: &FrameView,
    ) -> (Image, DepthImage) {
        renderer.prepare(gpu.device(), gpu.queue(), view).unwrap();
        let target = Target::new(gpu, view.viewport().size_px, formats).unwrap();
        gpu.draw(&target, Load::Clear([0.0; 4]), |pass| renderer.draw(pass)).unwrap();
        (target.read_color(gpu).unwrap(), target.read_depth(gpu).unwrap())
    }

    fn covered(image: &Image) -> Vec<bool> {
        image.rgba.chunks_exact(4).map(|pixel| pixel[3] > 0).collect()
    }

    fn view(mesh: &TriangleMesh, framing: Framing, direction: DepthDirection, scale: DVec3) -> FrameView {
        let camera = three_quarter(mesh, framing, [150, 110]);
        let mut range = camera.clip_range(&mesh.bounds().unwrap());
        range.near *= 0.8;
        let model =
            DMat4::from_scale_rotation_translation(scale, DQuat::from_rotation_x(0.6), DVec3::new(0.1, -0.2, 0.05));
        FrameView::from_camera(&camera, range, direction).unwrap().with_model(model).unwrap()
    }

    #[test]
    fn a_mesh_that_nothing_is_done_to_covers_the_pixels_that_its_faces_fill_at_the_same_depths() {
        let Some(gpu) = gpu_or_skip("a_mesh_that_nothing_is_done_to_covers_the_pixels") else { return };
        for (name, is_flat) in [("cube", true), ("torus:16,10", false), ("gear", false)] {
            let mesh = builtin(name);
            for (scale, framing, depth_direction) in [
                (DVec3::ONE, PERSPECTIVE, DepthDirection::Reversed),
                (DVec3::new(1.2, 0.5, 0.9), Framing::Orthographic, DepthDirection::Standard),
                (DVec3::new(0.8, 0.7, -1.1), PERSPECTIVE, DepthDirection::Standard),
            ] {
                let formats = TargetFormats { depth_direction, ..DEFAULT_FORMATS };
                let view = view(&mesh, framing, depth_direction, scale);
                let style = FillStyle { shade: WHITE, cull: Cull::None };
                let pipelines = Arc::new(FillPipelines::new(gpu.device(), formats, style));
                let mut fill = FillRenderer::new(gpu.device(), &pipelines, &buffers(gpu, &mesh));
                let expected = picture(gpu, formats, &mut fill, &view);
                let found = picture(gpu, formats, &mut renderer(gpu, formats, &mesh), &view);
                let pixels = covered(&expected.0).into_iter().filter(|covered| *covered).count();
                assert!(pixels > 1000, "{name}: {pixels}");
                assert!(covered(&expected.0) == covered(&found.0) && expected.1 == found.1, "{name} {scale}");
                // Where normals are those of faces, light is too; through the inverse transpose of the matrix.
                let off = expected.0.rgba.iter().zip(&found.0.rgba).map(|(a, b)| a.abs_diff(*b)).max().unwrap();
                assert_eq!(off <= 2, is_flat, "{name} {scale}: {off}");
            }
        }
    }

    #[test]
    fn triangles_that_become_more_are_uploaded_and_those_that_stay_are_kept() {
        let Some(gpu) = gpu_or_skip("triangles_that_become_more_are_uploaded") else { return };
        let mesh = builtin("icosphere:2");
        let view = view(&mesh, PERSPECTIVE, DEFAULT_FORMATS.depth_direction, DVec3::ONE);
        let whole = picture(gpu, DEFAULT_FORMATS, &mut renderer(gpu, DEFAULT_FORMATS, &mesh), &view);
        let mut growing = renderer(gpu, DEFAULT_FORMATS, &mesh);
        (growing.remesher.faces, growing.remesher.step) = (0, 107);
        let mut last = 0;
        for round in 0..4 {
            let found = picture(gpu, DEFAULT_FORMATS, &mut growing, &view);
            let count = covered(&found.0).into_iter().filter(|covered| *covered).count();
            assert!(if round == 0 { count == 0 } else { count > last }, "{round}: {count}");
            last = count;
        }
        growing.remesher.step = 0;
        for _ in 0..2 {
            assert!(picture(gpu, DEFAULT_FORMATS, &mut growing, &view) == whole);
        }
        let empty = zoo::empty();
        let none = picture(gpu, DEFAULT_FORMATS, &mut renderer(gpu, DEFAULT_FORMATS, &empty), &view);
        assert!(covered(&none.0).into_iter().all(|covered| !covered));
    }

    #[test]
    fn vertices_that_moved_on_the_device_are_warned_of() {
        let Some(gpu) = gpu_or_skip("vertices_that_moved_on_the_device_are_warned_of") else { return };
        let mesh = builtin("cube");
        let mut renderer = renderer(gpu, DEFAULT_FORMATS, &mesh);
        let view = view(&mesh, PERSPECTIVE, DEFAULT_FORMATS.depth_direction, DVec3::ONE);
        renderer.prepare(gpu.device(), gpu.queue(), &view).unwrap();
        assert_eq!(renderer.warning(), None);
        let moved: Vec<_> = mesh.positions().iter().map(|position| 0.5 * position).collect();
        renderer.mesh.set_positions(gpu.queue(), &moved).unwrap();
        renderer.prepare(gpu.device(), gpu.queue(), &view).unwrap();
        assert!(renderer.warning().unwrap().contains("at rest"));
    }

    #[test]
    fn views_of_frames_are_views_of_their_cameras() {
        let mesh = builtin("torus");
        for framing in [PERSPECTIVE, Framing::Orthographic] {
            let camera = three_quarter(&mesh, framing, [150, 110]);
            let range = camera.clip_range(&mesh.bounds().unwrap());
            let frame = FrameView::from_camera(&camera, range, DepthDirection::Reversed).unwrap();
            let [found, expected] = [SmoothingView::from_frame(&frame), SmoothingView::from_camera(&camera)];
            let point = DVec3::new(0.3, -0.4, 0.5);
            assert!(found.pixel(point).0.distance(expected.pixel(point).0) < 1e-9);
            assert!(found.eye().toward(point).distance(expected.eye().toward(point)) < 1e-6);
            // The same mesh twice as large, drawn at half its size.
            let halved = SmoothingView::from_frame(&frame.with_model(DMat4::from_scale(DVec3::splat(0.5))).unwrap());
            assert!(halved.pixel(2.0 * point).0.distance(expected.pixel(point).0) < 1e-9);
        }
    }
}
