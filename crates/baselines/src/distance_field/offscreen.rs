//! [`Offscreen`]: what a method draws of its meshes before it plants seeds.

use super::field::texture;
use wgpu::{TextureFormat, TextureView};

/// Format of the depth of offscreen pictures, whatever the target's.
pub(crate) const OFFSCREEN_DEPTH: TextureFormat = TextureFormat::Depth32Float;

/// A picture with depth, for stages to read.
#[derive(Debug)]
pub(crate) struct Offscreen {
    label: &'static str,
    /// What is drawn; nothing where its parts are zero.
    pub color: TextureView,
    /// Depth, from `OFFSCREEN_DEPTH`.
    pub depth: TextureView,
}

impl Offscreen {
    /// Makes the textures.
    pub fn new(
        device: &wgpu::Device,
        label: &'static str,
        format: TextureFormat,
        samples: u32,
        size_px: [u32; 2],
    ) -> Self {
        let usage = wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::TEXTURE_BINDING;
        let view = |format| texture(device, label, format, samples, size_px, usage);
        Self { label, color: view(format), depth: view(OFFSCREEN_DEPTH) }
    }

    /// Begins the pass that draws into it, where there is nothing yet.
    pub fn begin_pass<'a>(&self, encoder: &'a mut wgpu::CommandEncoder, clear_depth: f32) -> wgpu::RenderPass<'a> {
        encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some(self.label),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &self.color,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations {
                    load: wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT),
                    store: wgpu::StoreOp::Store,
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
