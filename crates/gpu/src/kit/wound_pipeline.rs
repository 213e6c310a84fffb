//! [`WoundPipeline`]: a pipeline that culls by winding, for views that mirror and views that do not.

use std::fmt;
use std::sync::OnceLock;

/// A render pipeline with either winding as the front: the usual one is built at once, that of mirrored views when the first such
/// view is prepared.
pub struct WoundPipeline {
    device: wgpu::Device,
    build: Box<Build>,
    usual: wgpu::RenderPipeline,
    mirrored: OnceLock<wgpu::RenderPipeline>,
}

type Build = dyn Fn(&wgpu::Device, wgpu::FrontFace) -> wgpu::RenderPipeline + Send + Sync;

impl WoundPipeline {
    /// `build` makes the pipeline for the winding that front faces have in the image.
    pub fn new(
        device: &wgpu::Device,
        build: impl Fn(&wgpu::Device, wgpu::FrontFace) -> wgpu::RenderPipeline + Send + Sync + 'static,
    ) -> Self {
        let usual = build(device, wgpu::FrontFace::Ccw);
        Self { device: device.clone(), build: Box::new(build), usual, mirrored: OnceLock::new() }
    }

    /// The pipeline for views in which front faces run clockwise (`is_mirrored`) or counter-clockwise.
    pub fn get(&self, is_mirrored: bool) -> &wgpu::RenderPipeline {
        if is_mirrored {
            self.mirrored.get_or_init(|| (self.build)(&self.device, wgpu::FrontFace::Cw))
        } else {
            &self.usual
        }
    }
}

impl fmt::Debug for WoundPipeline {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("WoundPipeline").field("usual", &self.usual).finish_non_exhaustive()
    }
}
