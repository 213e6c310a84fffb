//! [`compute_pipeline`], and what it shares with render pipelines.

/// A compute pipeline for the entry point `entry` of a complete WGSL module; `bindings` are the layouts of bind groups 0, 1, …,
/// `None` where the stage uses no group of that index. Compiles the text: some milliseconds.
pub fn compute_pipeline(
    device: &wgpu::Device,
    wgsl: &str,
    entry: &str,
    bindings: &[Option<&wgpu::BindGroupLayout>],
) -> wgpu::ComputePipeline {
    device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
        label: Some(entry),
        layout: Some(&pipeline_layout(device, entry, bindings)),
        module: &shader_module(device, entry, wgsl),
        entry_point: Some(entry),
        compilation_options: wgpu::PipelineCompilationOptions::default(),
        cache: None,
    })
}

pub(super) fn shader_module(device: &wgpu::Device, label: &str, wgsl: &str) -> wgpu::ShaderModule {
    device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some(label),
        source: wgpu::ShaderSource::Wgsl(wgsl.into()),
    })
}

pub(super) fn pipeline_layout(
    device: &wgpu::Device,
    label: &str,
    bindings: &[Option<&wgpu::BindGroupLayout>],
) -> wgpu::PipelineLayout {
    device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: Some(label),
        bind_group_layouts: bindings,
        immediate_size: 0,
    })
}
