//! A frame: everything in one submission.

use crate::device::Device;
use crate::lines::Lines;
use crate::picture::Picture;
use crate::scene::{SIZE, Scene};
use crate::shading::{DEPTH, Shading};
use std::error::Error;

/// Samples per pixel.
const SAMPLES: u32 = 4;

/// What a frame shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shown {
    /// The engine's own picture.
    Shading,
    /// The same with lines.
    LinesOverShading,
    /// Lines on a transparent ground.
    Lines,
}

/// Targets and renderers.
pub struct Frame {
    color: wgpu::TextureFormat,
    scene: Scene,
    shading: Shading,
    depth_pass: Shading,
    over: Lines,
    alone: Lines,
    samples: wgpu::TextureView,
    resolved: wgpu::Texture,
    depth: wgpu::TextureView,
    scene_depth: wgpu::TextureView,
}

impl Frame {
    pub fn new(device: &Device, color: wgpu::TextureFormat) -> Result<Self, Box<dyn Error>> {
        let texture = |format, samples, usage| {
            device.device.create_texture(&wgpu::TextureDescriptor {
                label: None,
                size: wgpu::Extent3d { width: SIZE[0], height: SIZE[1], depth_or_array_layers: 1 },
                mip_level_count: 1,
                sample_count: samples,
                dimension: wgpu::TextureDimension::D2,
                format,
                usage: usage | wgpu::TextureUsages::RENDER_ATTACHMENT,
                view_formats: &[],
            })
        };
        let view = |texture: wgpu::Texture| texture.create_view(&wgpu::TextureViewDescriptor::default());
        let none = wgpu::TextureUsages::empty();
        let scene_depth = view(texture(DEPTH, 1, wgpu::TextureUsages::TEXTURE_BINDING));
        let scene = Scene::new(device)?;
        let mut over = Lines::new(device, &scene, color, SAMPLES, false)?;
        let mut alone = Lines::new(device, &scene, color, SAMPLES, true)?;
        over.hide_behind(scene_depth.clone());
        alone.hide_behind(scene_depth.clone());
        Ok(Self {
            color,
            shading: Shading::new(device, Some(color), SAMPLES),
            depth_pass: Shading::new(device, None, 1),
            over,
            alone,
            scene,
            samples: view(texture(color, SAMPLES, none)),
            resolved: texture(color, 1, wgpu::TextureUsages::COPY_SRC),
            depth: view(texture(DEPTH, SAMPLES, none)),
            scene_depth,
        })
    }

    /// Draws the scene at a time, and reads it back.
    pub fn draw(&mut self, device: &Device, shown: Shown, seconds: f32) -> Result<Picture, Box<dyn Error>> {
        let lines = match shown {
            Shown::Shading => None,
            Shown::LinesOverShading => Some(&mut self.over),
            Shown::Lines => Some(&mut self.alone),
        };
        let mut encoder = device.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        self.scene.animate(device, &mut encoder, seconds);
        self.shading.prepare(device, &self.scene);
        self.depth_pass.prepare(device, &self.scene);
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            depth_stencil_attachment: Some(attachment(&self.scene_depth)),
            ..Default::default()
        });
        self.depth_pass.draw(&mut pass, &self.scene);
        drop(pass);
        let lines = lines.map(|lines| lines.prepare(device, &self.scene).map(|()| &*lines)).transpose()?;
        if let Some(lines) = lines {
            lines.encode(&mut encoder);
        }

        let resolved = self.resolved.create_view(&wgpu::TextureViewDescriptor::default());
        let ground = if shown == Shown::Lines { wgpu::Color::TRANSPARENT } else { wgpu::Color::WHITE };
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &self.samples,
                depth_slice: None,
                resolve_target: Some(&resolved),
                ops: wgpu::Operations { load: wgpu::LoadOp::Clear(ground), store: wgpu::StoreOp::Discard },
            })],
            depth_stencil_attachment: Some(attachment(&self.depth)),
            ..Default::default()
        });
        if shown != Shown::Lines {
            self.shading.draw(&mut pass, &self.scene);
        }
        if let Some(lines) = lines {
            lines.draw(&mut pass);
        }
        drop(pass);
        device.queue.submit([encoder.finish()]);
        Picture::read(device, &self.resolved, self.color)
    }
}

/// Depth cleared to the farthest value of a reversed buffer.
fn attachment(view: &wgpu::TextureView) -> wgpu::RenderPassDepthStencilAttachment<'_> {
    wgpu::RenderPassDepthStencilAttachment {
        view,
        depth_ops: Some(wgpu::Operations { load: wgpu::LoadOp::Clear(0.0), store: wgpu::StoreOp::Store }),
        stencil_ops: None,
    }
}
