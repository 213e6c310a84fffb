//! [`FrameBuffers`]: tables of a mesh, and what a frame makes of them.

use crate::gpu::pipelines::SmoothingPipelines;
use crate::gpu::prefix_sum::{ELEMENT_BYTES, Levels, MOST_ELEMENTS};
use crate::gpu::room::{Room, vertex_count};
use crate::gpu::settings::SmoothingUniform;
use crate::gpu::tables::Tables;
use crate::smoothing::Smoothing;
use crate::view_mesh_renderer::{TRIANGLE_BYTES, VERTEX_BYTES};
use silhouette_core::glam::Vec3;
use silhouette_gpu::kit::{buffers_group, storage_buffer};
use silhouette_gpu::{LocalFrame, MeshTooLarge};
use wgpu::BufferUsages;

/// Bytes of a feature edge's curve: two cubics of four `vec4<f32>`.
const CURVE_BYTES: u64 = 128;

/// Arguments of an indexed draw of nothing.
const NO_DRAW: [u32; 5] = [0, 1, 0, 0, 0];

/// Tests read back what no one else does.
const READ_IN_TESTS: BufferUsages = if cfg!(test) { BufferUsages::COPY_SRC } else { BufferUsages::empty() };

/// The buffers of one renderer, allocated once.
#[derive(Debug)]
pub(crate) struct FrameBuffers {
    /// Shading vertices, silhouette points, and what the view adds.
    pub vertices: wgpu::Buffer,
    pub indices: wgpu::Buffer,
    pub arguments: wgpu::Buffer,
    #[cfg_attr(not(test), expect(dead_code, reason = "read back by tests"))]
    pub state: wgpu::Buffer,
    pub frame_group: wgpu::BindGroup,
    pub output_group: wgpu::BindGroup,
    pub levels: Levels,
    /// Without a view yet.
    pub settings: SmoothingUniform,
}

impl FrameBuffers {
    /// Allocates all buffers, and uploads tables, normals and feature curves for a mesh in `frame`.
    pub fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        pipelines: &SmoothingPipelines,
        method: &Smoothing,
        frame: &LocalFrame,
        room: Room,
    ) -> Result<Self, MeshTooLarge> {
        let tables = Tables::new(method);
        let elements = u64::from(tables.counts.features) + u64::from(tables.counts.faces);
        let (bytes, limit) = (ELEMENT_BYTES * elements, ELEMENT_BYTES * u64::from(MOST_ELEMENTS));
        if bytes > limit {
            return Err(MeshTooLarge { what: "sums of triangles", bytes, limit });
        }
        let levels = Levels::new(elements as u32);
        let settings = SmoothingUniform::new(method.options(), &tables, &levels, room);
        let buffer = |label, bytes, usage| storage_buffer(device, label, bytes, usage | READ_IN_TESTS);
        let none = BufferUsages::empty();
        let vertices = buffer(
            "vertices of the smoothed surface",
            VERTEX_BYTES * vertex_count(&tables, room),
            BufferUsages::VERTEX,
        )?;
        let words = buffer("tables of the mesh", 4 * tables.words.len() as u64, none)?;
        let state = buffer("silhouette segments", 4 * settings.state_words(), none)?;
        let curves = buffer("feature segments", CURVE_BYTES * u64::from(tables.counts.features), none)?;
        let at_concave = buffer("marks of vertices", 4 * u64::from(tables.counts.vertices), none)?;
        let sums = buffer("sums of triangles", levels.bytes(), none)?;
        let indices =
            buffer("triangles of the smoothed surface", TRIANGLE_BYTES * room.triangles, BufferUsages::INDEX)?;
        let arguments = buffer("arguments of the indexed draw", size_of_val(&NO_DRAW) as u64, BufferUsages::INDIRECT)?;
        queue.write_buffer(&words, 0, bytemuck::cast_slice(&tables.words));
        queue.write_buffer(&arguments, 0, bytemuck::cast_slice(&NO_DRAW));
        queue.write_buffer(&vertices, 0, bytemuck::cast_slice(&shading_vertices(method, frame)));
        queue.write_buffer(&curves, 0, bytemuck::cast_slice(&feature_curves(method, frame)));
        let frame_buffers = [&vertices, &words, &state, &curves, &at_concave];
        let frame_group = buffers_group(device, "smoothing: frame", &pipelines.frame_layout, &frame_buffers);
        let output_buffers = [&sums, &indices, &arguments];
        let output_group = buffers_group(device, "smoothing: output", &pipelines.output_layout, &output_buffers);
        Ok(Self { vertices, indices, arguments, state, frame_group, output_group, levels, settings })
    }
}

/// The shading vertices at rest.
fn shading_vertices(method: &Smoothing, frame: &LocalFrame) -> Vec<[Vec3; 2]> {
    let mesh = method.shading_mesh();
    let vertex = |(position, normal): (&Vec3, &Vec3)| [frame.to_local(position.as_dvec3()), *normal];
    mesh.positions().iter().zip(mesh.normals()).map(vertex).collect()
}

/// The curves of feature edges at rest: ends and tangents of two cubics, and in the first w whether there are two.
fn feature_curves(method: &Smoothing, frame: &LocalFrame) -> Vec<[[f32; 4]; 8]> {
    let row = |segment: &crate::feature_segments::FeatureSegment| {
        let mut row = [[0.0; 4]; 8];
        for (half, curve) in segment.curves().enumerate() {
            let ends = curve.ends.map(|end| frame.to_local(end));
            let tangents = curve.tangents.map(|tangent| (tangent / frame.unit()).as_vec3());
            for (place, v) in row[4 * half..].iter_mut().zip([ends[0], ends[1], tangents[0], tangents[1]]) {
                *place = v.extend(0.0).to_array();
            }
        }
        row[0][3] = if segment.curves().len() > 1 { 1.0 } else { 0.0 };
        row
    };
    method.features().segments().iter().map(row).collect()
}
