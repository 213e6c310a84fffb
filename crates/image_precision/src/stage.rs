//! What the pipelines of this crate have in common, written once.

use crate::settings::Settings;

/// A render pipeline as far as it differs from the others.
pub(crate) struct Stage {
    pub label: &'static str,
    pub wgsl: &'static str,
    pub vertex: &'static str,
    pub fragment: &'static str,
    /// Vertex buffers; none where the stage pulls what it needs.
    pub buffers: &'static [Option<wgpu::VertexBufferLayout<'static>>],
    pub culled: Option<wgpu::Face>,
    pub polygon_mode: wgpu::PolygonMode,
    pub depth: wgpu::DepthStencilState,
}

/// Where positions of the mesh come from the vertex buffer.
pub(crate) const POSITIONS: &[Option<wgpu::VertexBufferLayout<'static>>] = &[Some(silhouette_gpu::POSITION_LAYOUT)];

/// The stage of `ink.wgsl` for lines without a texture: what does not fade needs no depth.
pub(crate) fn ink_fragment(settings: &Settings) -> &'static str {
    if settings.depth_fade > 0.0 { "faded_fragment" } else { "solid_fragment" }
}

fn module(device: &wgpu::Device, label: &str, wgsl: &str) -> wgpu::ShaderModule {
    device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some(label),
        source: wgpu::ShaderSource::Wgsl(wgsl.into()),
    })
}

fn pipeline_layout(
    device: &wgpu::Device,
    label: &str,
    layouts: &[Option<&wgpu::BindGroupLayout>],
) -> wgpu::PipelineLayout {
    device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: Some(label),
        bind_group_layouts: layouts,
        immediate_size: 0,
    })
}

impl Stage {
    pub(crate) fn build(
        self,
        device: &wgpu::Device,
        layouts: &[Option<&wgpu::BindGroupLayout>],
        color: wgpu::TextureFormat,
        samples: u32,
    ) -> wgpu::RenderPipeline {
        self.build_for(device, layouts, color.into(), samples)
    }

    /// [`build`](Self::build) for a target with its own blending or write mask.
    pub(crate) fn build_for(
        self,
        device: &wgpu::Device,
        layouts: &[Option<&wgpu::BindGroupLayout>],
        target: wgpu::ColorTargetState,
        samples: u32,
    ) -> wgpu::RenderPipeline {
        let targets = [Some(target)];
        let module = module(device, self.label, self.wgsl);
        device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some(self.label),
            layout: Some(&pipeline_layout(device, self.label, layouts)),
            vertex: wgpu::VertexState {
                module: &module,
                entry_point: Some(self.vertex),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                buffers: self.buffers,
            },
            primitive: wgpu::PrimitiveState {
                cull_mode: self.culled,
                polygon_mode: self.polygon_mode,
                ..wgpu::PrimitiveState::default()
            },
            depth_stencil: Some(self.depth),
            multisample: wgpu::MultisampleState { count: samples, ..Default::default() },
            fragment: Some(wgpu::FragmentState {
                module: &module,
                entry_point: Some(self.fragment),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                targets: &targets,
            }),
            multiview_mask: None,
            cache: None,
        })
    }
}

/// A compute pipeline.
pub(crate) fn compute(
    device: &wgpu::Device,
    wgsl: &'static str,
    entry: &'static str,
    layouts: &[Option<&wgpu::BindGroupLayout>],
) -> wgpu::ComputePipeline {
    device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
        label: Some(entry),
        layout: Some(&pipeline_layout(device, entry, layouts)),
        module: &module(device, entry, wgsl),
        entry_point: Some(entry),
        compilation_options: wgpu::PipelineCompilationOptions::default(),
        cache: None,
    })
}

/// A binding of storage: read-only for vertex stages and compute stages, or read and write for compute stages.
pub(crate) fn storage_entry(binding: u32, read_only: bool) -> wgpu::BindGroupLayoutEntry {
    let visibility =
        if read_only { wgpu::ShaderStages::VERTEX | wgpu::ShaderStages::COMPUTE } else { wgpu::ShaderStages::COMPUTE };
    wgpu::BindGroupLayoutEntry {
        binding,
        visibility,
        ty: wgpu::BindingType::Buffer {
            ty: wgpu::BufferBindingType::Storage { read_only },
            has_dynamic_offset: false,
            min_binding_size: None,
        },
        count: None,
    }
}

/// A bind group of whole buffers, in the order of their bindings.
pub(crate) fn buffers_group(
    device: &wgpu::Device,
    label: &str,
    layout: &wgpu::BindGroupLayout,
    buffers: &[&wgpu::Buffer],
) -> wgpu::BindGroup {
    let entries: Vec<_> = (0..)
        .zip(buffers)
        .map(|(binding, buffer)| wgpu::BindGroupEntry { binding, resource: buffer.as_entire_binding() })
        .collect();
    device.create_bind_group(&wgpu::BindGroupDescriptor { label: Some(label), layout, entries: &entries })
}

/// Least bytes of a buffer that is bound: room for one element of any list.
const LEAST_BYTES: u64 = 64;

/// A buffer for storage that a stage fills.
pub(crate) fn storage_buffer(
    device: &wgpu::Device,
    label: &'static str,
    bytes: u64,
    usage: wgpu::BufferUsages,
) -> Result<wgpu::Buffer, silhouette_gpu::MeshTooLarge> {
    let limits = device.limits();
    let limit = limits.max_storage_buffer_binding_size.min(limits.max_buffer_size);
    if bytes > limit {
        return Err(silhouette_gpu::MeshTooLarge { what: label, bytes, limit });
    }
    Ok(device.create_buffer(&wgpu::BufferDescriptor {
        label: Some(label),
        size: bytes.max(LEAST_BYTES),
        usage: usage | wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    }))
}

/// Invocations of a workgroup of the stages that run once an element.
const WORKGROUP: u32 = 64;

/// Workgroups that run at least once an element, in rows where one row is too long.
pub(crate) fn groups(elements: u32) -> [u32; 2] {
    const LONGEST_ROW: u32 = 32_768;
    let all = elements.div_ceil(WORKGROUP);
    [all.min(LONGEST_ROW), all.div_ceil(LONGEST_ROW)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn workgroups_cover_every_element() {
        for elements in [0, 1, 64, 65, 2_097_152, 2_097_153, u32::MAX] {
            let [x, y] = groups(elements);
            assert!(u64::from(x) * u64::from(y) * u64::from(WORKGROUP) >= u64::from(elements));
            assert!(x <= 32_768 && y <= 32_768);
        }
    }
}
