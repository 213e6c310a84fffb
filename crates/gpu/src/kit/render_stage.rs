//! [`RenderStage`]: a render pipeline by what sets it apart.

use super::compute_pipeline::{pipeline_layout, shader_module};
use wgpu::PipelineCompilationOptions;

/// A render pipeline with one colour attachment, as far as it differs from [`RenderStage::default`].
///
/// ```no_run
/// # use silhouette_gpu::kit::RenderStage;
/// # fn pipeline(device: &wgpu::Device, camera: &wgpu::BindGroupLayout) -> wgpu::RenderPipeline {
/// RenderStage {
///     label: "face ids",
///     wgsl: silhouette_shaders::render::FACE_IDS,
///     vertex: "face_vertex",
///     fragment: "face_id",
///     bindings: &[Some(camera)],
///     color: wgpu::TextureFormat::R32Uint,
///     ..RenderStage::default()
/// }
/// .build(device)
/// # }
/// ```
#[derive(Debug, Clone)]
pub struct RenderStage<'a> {
    /// Name in wgpu's messages.
    pub label: &'a str,
    /// A complete WGSL module with both entry points.
    pub wgsl: &'a str,
    /// Entry point of the vertex stage.
    pub vertex: &'a str,
    /// Entry point of the fragment stage.
    pub fragment: &'a str,
    /// Values of the module's `override` constants, by name; the others keep their defaults.
    pub constants: &'a [(&'a str, f64)],
    /// Layouts of bind groups 0, 1, …; `None` where the stage uses no group of that index.
    pub bindings: &'a [Option<&'a wgpu::BindGroupLayout>],
    /// Layouts of vertex buffers 0, 1, …; none where the stage fetches its data from storage.
    pub vertex_buffers: &'a [Option<wgpu::VertexBufferLayout<'a>>],
    /// How vertices form primitives.
    pub topology: wgpu::PrimitiveTopology,
    /// The winding in the image of the front of triangles.
    pub front_face: wgpu::FrontFace,
    /// The side of triangles that is not drawn.
    pub cull_mode: Option<wgpu::Face>,
    /// Whether triangles are filled. Lines need the device feature `POLYGON_MODE_LINE`.
    pub polygon_mode: wgpu::PolygonMode,
    /// Depth attachment, test and bias; `None` for passes without depth.
    pub depth: Option<wgpu::DepthStencilState>,
    /// Format of the colour attachment.
    pub color: wgpu::TextureFormat,
    /// How colour joins what the attachment holds; `None` replaces it.
    pub blend: Option<wgpu::BlendState>,
    /// Channels that are written.
    pub writes: wgpu::ColorWrites,
    /// Samples per pixel of all attachments.
    pub samples: u32,
}

impl Default for RenderStage<'_> {
    /// Filled triangles from both sides, without constants, vertex buffers, bindings, depth and blending,
    /// into all channels of a single-sample
    /// `Rgba8Unorm`. The text and the entry points are empty.
    fn default() -> Self {
        Self {
            label: "",
            wgsl: "",
            vertex: "",
            fragment: "",
            constants: &[],
            bindings: &[],
            vertex_buffers: &[],
            topology: wgpu::PrimitiveTopology::TriangleList,
            front_face: wgpu::FrontFace::Ccw,
            cull_mode: None,
            polygon_mode: wgpu::PolygonMode::Fill,
            depth: None,
            color: wgpu::TextureFormat::Rgba8Unorm,
            blend: None,
            writes: wgpu::ColorWrites::ALL,
            samples: 1,
        }
    }
}

impl RenderStage<'_> {
    /// Compiles the text and makes the pipeline: some milliseconds, so once per device and set of formats.
    pub fn build(self, device: &wgpu::Device) -> wgpu::RenderPipeline {
        let module = shader_module(device, self.label, self.wgsl);
        let options = PipelineCompilationOptions { constants: self.constants, ..Default::default() };
        let target = wgpu::ColorTargetState { format: self.color, blend: self.blend, write_mask: self.writes };
        device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some(self.label),
            layout: Some(&pipeline_layout(device, self.label, self.bindings)),
            vertex: wgpu::VertexState {
                module: &module,
                entry_point: Some(self.vertex),
                compilation_options: options.clone(),
                buffers: self.vertex_buffers,
            },
            primitive: wgpu::PrimitiveState {
                topology: self.topology,
                front_face: self.front_face,
                cull_mode: self.cull_mode,
                polygon_mode: self.polygon_mode,
                ..wgpu::PrimitiveState::default()
            },
            depth_stencil: self.depth,
            multisample: wgpu::MultisampleState { count: self.samples, ..Default::default() },
            fragment: Some(wgpu::FragmentState {
                module: &module,
                entry_point: Some(self.fragment),
                compilation_options: options,
                targets: &[Some(target)],
            }),
            multiview_mask: None,
            cache: None,
        })
    }
}
