//! One pass, submitted, waited for, timed and checked.

use crate::error::GpuError;
use crate::gpu::{Gpu, lock};
use crate::target::Target;
use crate::timestamps::Timestamps;
use std::time::Instant;

/// What a pass finds in its target.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Load {
    /// This colour (as the format stores it for `Unorm`, linear for `Srgb`) and the farthest depth.
    Clear([f64; 4]),
    /// What the previous pass left.
    Keep,
}

/// How long a submission took.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PassTime {
    /// On the device from the first command to the last, in milliseconds: whatever comes before the pass included, except on
    /// adapters that can time passes alone. `None` where the adapter has no timestamps.
    pub gpu_ms: Option<f64>,
    /// From recording until the device was done, in milliseconds; timestamps are read back after that.
    pub wall_ms: f64,
}

impl Gpu {
    /// Records a pass over the colour and depth of `target`, submits it and waits until it is done.
    ///
    /// # Errors
    /// Whatever the device reports about the pass, or that it is lost.
    pub fn draw(
        &self,
        target: &Target,
        load: Load,
        record: impl FnOnce(&mut wgpu::RenderPass<'_>),
    ) -> Result<PassTime, GpuError> {
        self.draw_after(target, load, |_| {}, record)
    }

    /// As [`draw`](Self::draw), with what `encode` records before the pass in the same submission.
    ///
    /// # Errors
    /// As [`draw`](Self::draw).
    pub fn draw_after(
        &self,
        target: &Target,
        load: Load,
        encode: impl FnOnce(&mut wgpu::CommandEncoder),
        record: impl FnOnce(&mut wgpu::RenderPass<'_>),
    ) -> Result<PassTime, GpuError> {
        let clear_depth = target.formats().clear_depth();
        let (color, depth) = match load {
            Load::Clear([r, g, b, a]) => {
                (wgpu::LoadOp::Clear(wgpu::Color { r, g, b, a }), wgpu::LoadOp::Clear(clear_depth))
            }
            Load::Keep => (wgpu::LoadOp::Load, wgpu::LoadOp::Load),
        };
        let depth_attachment = wgpu::RenderPassDepthStencilAttachment {
            view: target.depth_view(),
            depth_ops: Some(wgpu::Operations { load: depth, store: wgpu::StoreOp::Store }),
            stencil_ops: None,
        };
        self.submit_pass(&[Some(target.color_attachment(color))], Some(depth_attachment), encode, record)
    }

    /// As [`draw`](Self::draw), over the colour alone, which is kept.
    ///
    /// # Errors
    /// As [`draw`](Self::draw).
    pub fn draw_over(
        &self,
        target: &Target,
        record: impl FnOnce(&mut wgpu::RenderPass<'_>),
    ) -> Result<PassTime, GpuError> {
        self.submit_pass(&[Some(target.color_attachment(wgpu::LoadOp::Load))], None, |_| {}, record)
    }

    pub(crate) fn submit_pass(
        &self,
        color_attachments: &[Option<wgpu::RenderPassColorAttachment<'_>>],
        depth_stencil_attachment: Option<wgpu::RenderPassDepthStencilAttachment<'_>>,
        encode: impl FnOnce(&mut wgpu::CommandEncoder),
        record: impl FnOnce(&mut wgpu::RenderPass<'_>),
    ) -> Result<PassTime, GpuError> {
        let timestamps = self.timestamps.as_ref().map(lock);
        let start = Instant::now();
        let submission = self.scoped(|| {
            let mut encoder = self.device().create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
            if let Some(timestamps) = timestamps.as_deref() {
                timestamps.begin(&mut encoder);
            }
            encode(&mut encoder);
            let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
                color_attachments,
                depth_stencil_attachment,
                timestamp_writes: timestamps.as_deref().and_then(Timestamps::of_pass),
                ..Default::default()
            });
            record(&mut pass);
            drop(pass);
            if let Some(timestamps) = timestamps.as_deref() {
                timestamps.resolve(&mut encoder);
            }
            self.queue().submit([encoder.finish()])
        })?;
        self.wait(&submission)?;
        let wall_ms = start.elapsed().as_secs_f64() * 1e3;
        let read = |timestamps: &Timestamps| self.read_buffer(timestamps.readable(), |b| timestamps.elapsed_ms(b));
        let gpu_ms = timestamps.as_deref().map(read).transpose()?;
        Ok(PassTime { gpu_ms, wall_ms })
    }
}
