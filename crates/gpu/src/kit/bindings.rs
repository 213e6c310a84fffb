//! Layouts of bind groups, and bind groups.

use wgpu::{BindGroupLayoutEntry, BindingType, BufferBindingType, ShaderStages};

fn buffer_entry(binding: u32, visibility: ShaderStages, ty: BufferBindingType) -> BindGroupLayoutEntry {
    let ty = BindingType::Buffer { ty, has_dynamic_offset: false, min_binding_size: None };
    BindGroupLayoutEntry { binding, visibility, ty, count: None }
}

/// Entry of a uniform buffer, for vertex, fragment and compute stages.
pub fn uniform_entry(binding: u32) -> BindGroupLayoutEntry {
    let visibility = ShaderStages::VERTEX_FRAGMENT | ShaderStages::COMPUTE;
    buffer_entry(binding, visibility, BufferBindingType::Uniform)
}

/// Entry of a storage buffer: read-only for vertex and compute stages, or read and written by compute stages. (WebGPU lets no
/// vertex stage write.)
pub fn storage_entry(binding: u32, read_only: bool) -> BindGroupLayoutEntry {
    let visibility = if read_only { ShaderStages::VERTEX | ShaderStages::COMPUTE } else { ShaderStages::COMPUTE };
    buffer_entry(binding, visibility, BufferBindingType::Storage { read_only })
}

/// Entry of a two-dimensional texture that fragment and compute stages read texel by texel, without a sampler.
pub fn texture_entry(binding: u32, sample_type: wgpu::TextureSampleType, multisampled: bool) -> BindGroupLayoutEntry {
    BindGroupLayoutEntry {
        binding,
        visibility: ShaderStages::FRAGMENT | ShaderStages::COMPUTE,
        ty: BindingType::Texture { sample_type, view_dimension: wgpu::TextureViewDimension::D2, multisampled },
        count: None,
    }
}

/// Entry of a two-dimensional texture that compute stages write. The formats that every device of WebGPU can write are listed in
/// its specification, section "Plain color formats".
pub fn storage_texture_entry(binding: u32, format: wgpu::TextureFormat) -> BindGroupLayoutEntry {
    BindGroupLayoutEntry {
        binding,
        visibility: ShaderStages::COMPUTE,
        ty: BindingType::StorageTexture {
            access: wgpu::StorageTextureAccess::WriteOnly,
            format,
            view_dimension: wgpu::TextureViewDimension::D2,
        },
        count: None,
    }
}

/// The layout of a bind group with these entries.
pub fn bind_layout(device: &wgpu::Device, label: &str, entries: &[BindGroupLayoutEntry]) -> wgpu::BindGroupLayout {
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: Some(label), entries })
}

/// A bind group of these resources, at bindings 0, 1, …
pub fn bind_group(
    device: &wgpu::Device,
    label: &str,
    layout: &wgpu::BindGroupLayout,
    resources: &[wgpu::BindingResource<'_>],
) -> wgpu::BindGroup {
    let entries: Vec<_> = (0..)
        .zip(resources)
        .map(|(binding, resource)| wgpu::BindGroupEntry { binding, resource: resource.clone() })
        .collect();
    device.create_bind_group(&wgpu::BindGroupDescriptor { label: Some(label), layout, entries: &entries })
}

/// A bind group of these buffers, each as a whole, at bindings 0, 1, …
pub fn buffers_group(
    device: &wgpu::Device,
    label: &str,
    layout: &wgpu::BindGroupLayout,
    buffers: &[&wgpu::Buffer],
) -> wgpu::BindGroup {
    let resources: Vec<_> = buffers.iter().map(|buffer| buffer.as_entire_binding()).collect();
    bind_group(device, label, layout, &resources)
}
