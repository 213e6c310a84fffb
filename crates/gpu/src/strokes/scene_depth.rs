//! [`SceneDepthTexture`]: the depth that hides lines, drawn before the caller's pass.

use crate::formats::TargetFormats;
use crate::mesh_buffers::MeshTooLarge;

/// A depth texture as large as the viewport.
#[derive(Debug)]
pub(super) struct SceneDepthTexture {
    size_px: [u32; 2],
    color: wgpu::TextureView,
    depth: wgpu::TextureView,
}

impl SceneDepthTexture {
    /// The depth of `slot`, made anew where it is not of this size.
    ///
    /// # Errors
    /// [`MeshTooLarge`] where the device has no texture of this size.
    pub fn resized(
        slot: &mut Option<Self>,
        device: &wgpu::Device,
        size_px: [u32; 2],
        formats: TargetFormats,
    ) -> Result<wgpu::TextureView, MeshTooLarge> {
        if let Some(kept) = slot.as_ref().filter(|kept| kept.size_px == size_px) {
            return Ok(kept.depth.clone());
        }
        let limit = device.limits().max_texture_dimension_2d;
        if let Some(&side) = size_px.iter().find(|&&side| side > limit) {
            let [bytes, limit] = [side, limit].map(|side| 4 * u64::from(side));
            return Err(MeshTooLarge { what: "rows of the depth that hides lines", bytes, limit });
        }
        let view = |label, format, usage| {
            let texture = device.create_texture(&wgpu::TextureDescriptor {
                label: Some(label),
                size: wgpu::Extent3d { width: size_px[0], height: size_px[1], depth_or_array_layers: 1 },
                mip_level_count: 1,
                sample_count: formats.samples,
                dimension: wgpu::TextureDimension::D2,
                format,
                usage: usage | wgpu::TextureUsages::RENDER_ATTACHMENT,
                view_formats: &[],
            });
            texture.create_view(&wgpu::TextureViewDescriptor::default())
        };
        let color = view("colour that is not written", formats.color, wgpu::TextureUsages::empty());
        let depth = view("depth that hides lines", formats.depth, wgpu::TextureUsages::TEXTURE_BINDING);
        *slot = Some(Self { size_px, color, depth: depth.clone() });
        Ok(depth)
    }

    /// Begins the pass that draws the depth.
    pub fn begin_pass<'a>(&self, encoder: &'a mut wgpu::CommandEncoder, clear_depth: f32) -> wgpu::RenderPass<'a> {
        encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("depth that hides lines"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &self.color,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations {
                    load: wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT),
                    store: wgpu::StoreOp::Discard,
                },
            })],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &self.depth,
                depth_ops: Some(wgpu::Operations {
                    load: wgpu::LoadOp::Clear(clear_depth),
                    store: wgpu::StoreOp::Store,
                }),
                stencil_ops: None,
            }),
            ..Default::default()
        })
    }
}
