//! What the render pipelines of this crate have in common, written once.

/// A pipeline as far as it differs from the others: one WGSL text, one bind group at index 0, the mesh
/// at index 1 where a stage pulls it.
pub(crate) struct Stage<'a> {
    pub label: &'a str,
    pub wgsl: &'a str,
    pub vertex: &'a str,
    pub fragment: &'a str,
    pub buffers: &'a [Option<wgpu::VertexBufferLayout<'a>>],
    /// Bind group at index 1, for stages that pull the mesh.
    pub mesh: Option<&'a wgpu::BindGroupLayout>,
    pub topology: wgpu::PrimitiveTopology,
    pub cull_mode: Option<wgpu::Face>,
    pub depth: Option<wgpu::DepthStencilState>,
    pub color: wgpu::TextureFormat,
    pub writes: wgpu::ColorWrites,
    pub samples: u32,
}

impl Default for Stage<'_> {
    /// A full-screen pass into one colour attachment; label, texts and format are to be filled in.
    fn default() -> Self {
        Self {
            label: "",
            wgsl: "",
            vertex: "full_screen",
            fragment: "",
            buffers: &[],
            mesh: None,
            topology: wgpu::PrimitiveTopology::TriangleList,
            cull_mode: None,
            depth: None,
            color: wgpu::TextureFormat::Rgba8Unorm,
            writes: wgpu::ColorWrites::ALL,
            samples: 1,
        }
    }
}

impl Stage<'_> {
    pub(crate) fn build(self, device: &wgpu::Device, bindings: &wgpu::BindGroupLayout) -> wgpu::RenderPipeline {
        let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some(self.label),
            source: wgpu::ShaderSource::Wgsl(self.wgsl.into()),
        });
        let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some(self.label),
            bind_group_layouts: &[Some(bindings), self.mesh][..1 + usize::from(self.mesh.is_some())],
            immediate_size: 0,
        });
        device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some(self.label),
            layout: Some(&layout),
            vertex: wgpu::VertexState {
                module: &module,
                entry_point: Some(self.vertex),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                buffers: self.buffers,
            },
            primitive: wgpu::PrimitiveState {
                topology: self.topology,
                cull_mode: self.cull_mode,
                ..wgpu::PrimitiveState::default()
            },
            depth_stencil: self.depth,
            multisample: wgpu::MultisampleState { count: self.samples, ..Default::default() },
            fragment: Some(wgpu::FragmentState {
                module: &module,
                entry_point: Some(self.fragment),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                targets: &[Some(wgpu::ColorTargetState { format: self.color, blend: None, write_mask: self.writes })],
            }),
            multiview_mask: None,
            cache: None,
        })
    }
}

/// Binding of a depth texture that is read texel by texel.
pub(crate) fn depth_texture_entry(binding: u32) -> wgpu::BindGroupLayoutEntry {
    texture_entry(binding, wgpu::TextureSampleType::Depth)
}

/// Binding of a texture that is read texel by texel.
pub(crate) fn texture_entry(binding: u32, sample_type: wgpu::TextureSampleType) -> wgpu::BindGroupLayoutEntry {
    wgpu::BindGroupLayoutEntry {
        binding,
        visibility: wgpu::ShaderStages::FRAGMENT,
        ty: wgpu::BindingType::Texture {
            sample_type,
            view_dimension: wgpu::TextureViewDimension::D2,
            multisampled: false,
        },
        count: None,
    }
}

/// Binding of a uniform for both stages.
pub(crate) fn uniform_entry(binding: u32) -> wgpu::BindGroupLayoutEntry {
    wgpu::BindGroupLayoutEntry {
        binding,
        visibility: wgpu::ShaderStages::VERTEX_FRAGMENT,
        ty: wgpu::BindingType::Buffer {
            ty: wgpu::BufferBindingType::Uniform,
            has_dynamic_offset: false,
            min_binding_size: None,
        },
        count: None,
    }
}

/// A uniform buffer of `size` bytes.
pub(crate) fn uniform_buffer(device: &wgpu::Device, label: &str, size: usize) -> wgpu::Buffer {
    device.create_buffer(&wgpu::BufferDescriptor {
        label: Some(label),
        size: size as u64,
        usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    })
}
