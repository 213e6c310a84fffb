//! [`LineStyle`]: what options that the line methods share come to on a device.

use silhouette_core::line_style::{InteriorChoice, LineWidth};
use silhouette_gpu::{Color, Cull, FillPipelines, FillStyle, TargetFormats};
use std::sync::Arc;

/// Width, ink and interior of a method's lines.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct LineStyle {
    /// How wide lines are.
    pub width: LineWidth,
    /// Ink.
    pub ink: Color,
    /// What is drawn where the mesh is.
    pub interior: InteriorChoice,
}

impl LineStyle {
    /// How ink joins what the target holds.
    pub fn blend(&self) -> Option<wgpu::BlendState> {
        (self.ink.alpha < 1.0).then_some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING)
    }

    /// What fills the mesh, without the faces that `cull` says; `None` where nothing does.
    pub fn interior(&self, device: &wgpu::Device, formats: TargetFormats, cull: Cull) -> Option<Arc<FillPipelines>> {
        let style = match self.interior {
            InteriorChoice::Paper => FillStyle { cull, ..FillStyle::PAPER },
            InteriorChoice::DepthOnly => FillStyle { cull, ..FillStyle::DEPTH },
            InteriorChoice::None => return None,
        };
        Some(Arc::new(FillPipelines::new(device, formats, style)))
    }
}
