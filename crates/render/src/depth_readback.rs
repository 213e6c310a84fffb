//! [`DepthReader`]: depth of any format as a float texture. Stage: `shaders/render/depth_readback.wgsl`.

use silhouette_gpu::kit::{RenderStage, bind_group, bind_layout, texture_entry};

/// Copies depth of any format into a float texture: 24-bit depth can be sampled, but not copied.
#[derive(Debug)]
pub(crate) struct DepthReader {
    layout: wgpu::BindGroupLayout,
    pipeline: wgpu::RenderPipeline,
}

impl DepthReader {
    pub(crate) fn new(device: &wgpu::Device) -> Self {
        let layout = bind_layout(device, "depth read-back", &[texture_entry(0, wgpu::TextureSampleType::Depth, false)]);
        let pipeline = RenderStage {
            label: "depth read-back",
            wgsl: silhouette_shaders::render::DEPTH_READBACK,
            vertex: "full_screen",
            fragment: "depth_readback",
            bindings: &[Some(&layout)],
            color: wgpu::TextureFormat::R32Float,
            ..RenderStage::default()
        }
        .build(device);
        Self { layout, pipeline }
    }

    /// A float texture of this size with its view, and the bind group for copying `depth` into it.
    pub(crate) fn bind(
        &self,
        device: &wgpu::Device,
        depth: &wgpu::TextureView,
        [width, height]: [u32; 2],
    ) -> (wgpu::Texture, wgpu::TextureView, wgpu::BindGroup) {
        let floats = device.create_texture(&wgpu::TextureDescriptor {
            label: Some("depth as floats"),
            size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: wgpu::TextureFormat::R32Float,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC,
            view_formats: &[],
        });
        let view = floats.create_view(&wgpu::TextureViewDescriptor::default());
        let source = wgpu::BindingResource::TextureView(depth);
        let bind_group = bind_group(device, "depth read-back", &self.layout, &[source]);
        (floats, view, bind_group)
    }

    /// Records the copy in a pass over the float texture.
    pub(crate) fn draw(&self, pass: &mut wgpu::RenderPass<'_>, bind_group: &wgpu::BindGroup) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, bind_group, &[]);
        pass.draw(0..3, 0..1);
    }
}
