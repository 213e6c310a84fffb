//! The article's own arithmetic, for comparison. Stage: `shaders/edge_mesh/as_printed.wgsl`.
//!
//! 1. Each edge between two faces is four vertices of 40 bytes ([`ArticleVertex`]) and two triangles without area: two vertices at
//!    either end, one of each face.
//! 2. The vertex stage evaluates both planes at the vertex. An edge is a silhouette edge if the product is below 0.
//! 3. Vertices move along their face's normal by `0.1 |E| / 75`, those of the back face of a silhouette edge the other way, so that
//!    both come towards the viewer.
//! 4. Edges that are not drawn are displaced and rasterised too; the alpha test discards their pixels.
//!
//! What is wrong with it is numbered in the [crate's documentation](crate). The mesh is drawn as it is at rest.

use crate::edge_record::EdgeRecord;
use crate::method::EdgeMesh;
use bytemuck::{Pod, Zeroable};
use silhouette_core::TriangleMesh;
use silhouette_core::glam::Vec3;
use silhouette_gpu::kit::{RenderStage, UniformBlock, bind_group, bind_layout, storage_buffer, uniform_entry};
use silhouette_gpu::{Color, FrameView, MeshTooLarge, TargetFormats};

/// A vertex of the article's edge mesh.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
pub struct ArticleVertex {
    /// An end of the edge, in the mesh's own space.
    pub position: [f32; 3],
    /// Unit normal of the vertex's face.
    pub normal: [f32; 3],
    /// Unit normal of the other face.
    pub tangent: [f32; 3],
    /// 1 on ridges and valleys, otherwise 0.
    pub ridge: f32,
}

/// Bytes per edge of the article's layout.
pub const BYTES_PER_EDGE: usize = 4 * size_of::<ArticleVertex>();

const VERTEX_LAYOUT: wgpu::VertexBufferLayout<'static> = wgpu::VertexBufferLayout {
    array_stride: size_of::<ArticleVertex>() as u64,
    step_mode: wgpu::VertexStepMode::Vertex,
    attributes: &wgpu::vertex_attr_array![0 => Float32x3, 1 => Float32x3, 2 => Float32x3, 3 => Float32],
};

/// The four vertices of an edge, around its quad: both ends on the first face, then both on the second, back again. `None` for a
/// boundary edge, which the article leaves out.
pub fn article_vertices(mesh: &TriangleMesh, record: &EdgeRecord) -> Option<[ArticleVertex; 4]> {
    let normal = |face| {
        let [a, b, c]: [Vec3; 3] = mesh.corners(face);
        (b - a).cross(c - a).normalize_or_zero().to_array()
    };
    let (first, second) = (normal(record.first_face()), normal(record.second_face()?));
    let ridge = if record.feature().is_some() { 1.0 } else { 0.0 };
    let [a, b] = record.ends().map(|vertex| mesh.positions()[vertex.index()].to_array());
    let vertex = |position, normal, tangent| ArticleVertex { position, normal, tangent, ridge };
    Some([vertex(a, first, second), vertex(b, first, second), vertex(b, second, first), vertex(a, second, first)])
}

/// Twin of the struct in `as_printed.wgsl`.
#[repr(C)]
#[derive(Debug, Clone, Copy, Pod, Zeroable)]
struct AsPrintedUniform {
    model_world: [[f32; 4]; 4],
    transform: [[f32; 4]; 4],
    camera: [f32; 4],
    ink: [f32; 4],
}

/// The article's stages, for all renderers.
#[derive(Debug)]
pub(crate) struct AsPrintedStage {
    layout: wgpu::BindGroupLayout,
    pipeline: wgpu::RenderPipeline,
    ink: [f32; 4],
}

impl AsPrintedStage {
    /// Draws in the colour of silhouettes, opaque.
    pub fn new(device: &wgpu::Device, ink: [f64; 3], formats: TargetFormats) -> Self {
        let layout = bind_layout(device, "edge mesh as printed", &[uniform_entry(0)]);
        let pipeline = RenderStage {
            label: "edge mesh as printed",
            wgsl: silhouette_shaders::edge_mesh::AS_PRINTED,
            vertex: "printed_vertex",
            fragment: "printed_pixel",
            bindings: &[Some(&layout)],
            vertex_buffers: &[Some(VERTEX_LAYOUT)],
            depth: Some(formats.depth_state(formats.nearer_or_equal())),
            color: formats.color,
            samples: formats.samples,
            ..RenderStage::default()
        }
        .build(device);
        Self { layout, pipeline, ink: Color { srgb: ink, alpha: 1.0 }.for_target(&formats) }
    }
}

/// The article's edge mesh of one instance: 160 bytes per edge, and 24 of indices.
#[derive(Debug)]
pub(crate) struct AsPrintedLines {
    pipeline: wgpu::RenderPipeline,
    ink: [f32; 4],
    uniform: UniformBlock<AsPrintedUniform>,
    group: wgpu::BindGroup,
    vertices: wgpu::Buffer,
    indices: wgpu::Buffer,
    count: u32,
}

impl AsPrintedLines {
    pub fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        stage: &AsPrintedStage,
        method: &EdgeMesh,
    ) -> Result<Self, MeshTooLarge> {
        let edges = method.records().iter().filter(|record| record.second_face().is_some()).count();
        let vertices = storage_buffer(device, "vertices", (edges * BYTES_PER_EDGE) as u64, wgpu::BufferUsages::VERTEX)?;
        let indices = storage_buffer(device, "indices", edges as u64 * 24, wgpu::BufferUsages::INDEX)?;
        let quads = method.records().iter().filter_map(|record| article_vertices(method.mesh(), record));
        let quads: Vec<[ArticleVertex; 4]> = quads.collect();
        queue.write_buffer(&vertices, 0, bytemuck::cast_slice(&quads));
        let triangles = (0..edges as u32).flat_map(|edge| [0, 1, 2, 0, 2, 3].map(|corner| 4 * edge + corner));
        let triangles: Vec<u32> = triangles.collect();
        queue.write_buffer(&indices, 0, bytemuck::cast_slice(&triangles));
        let uniform = UniformBlock::new(device, "edge mesh as printed");
        let group = bind_group(device, "edge mesh as printed", &stage.layout, &[uniform.binding()]);
        let count = triangles.len() as u32;
        Ok(Self { pipeline: stage.pipeline.clone(), ink: stage.ink, uniform, group, vertices, indices, count })
    }

    pub fn prepare(&self, queue: &wgpu::Queue, view: &FrameView) {
        let camera = view.model() * view.object_eye();
        let camera = if view.is_perspective() { camera } else { camera.truncate().normalize().extend(0.0) };
        self.uniform.write(
            queue,
            &AsPrintedUniform {
                model_world: view.model().as_mat4().to_cols_array_2d(),
                transform: view.object_to_clip().as_mat4().to_cols_array_2d(),
                camera: camera.as_vec4().to_array(),
                ink: self.ink,
            },
        );
    }

    pub fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &self.group, &[]);
        pass.set_vertex_buffer(0, self.vertices.slice(..));
        pass.set_index_buffer(self.indices.slice(..), wgpu::IndexFormat::Uint32);
        pass.draw_indexed(0..self.count, 0, 0..1);
    }
}

/// Whether the article's test finds a silhouette edge between faces with these normals, seen at `position` from an eye: the
/// product of both planes, in 32 bits.
pub fn is_silhouette_as_printed(position: Vec3, normals: [Vec3; 2], eye: Vec3) -> bool {
    let e = position - eye;
    e.dot(normals[0]) * e.dot(normals[1]) < 0.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::mem::offset_of;

    #[test]
    fn the_uniform_is_laid_out_as_its_wgsl_twin() {
        let members = [
            ("model_world", offset_of!(AsPrintedUniform, model_world)),
            ("transform", offset_of!(AsPrintedUniform, transform)),
            ("camera", offset_of!(AsPrintedUniform, camera)),
            ("ink", offset_of!(AsPrintedUniform, ink)),
        ];
        let stage = silhouette_shaders::edge_mesh::AS_PRINTED;
        let size = size_of::<AsPrintedUniform>();
        assert!(silhouette_shaders::layout::matches(stage, "AsPrintedUniform", size, &members));
    }

    #[test]
    fn an_edge_takes_as_many_bytes_as_in_the_article() {
        assert_eq!((size_of::<ArticleVertex>(), BYTES_PER_EDGE), (40, 160));
    }
}
