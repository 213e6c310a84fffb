//! [`TargetFormats`]: what a renderer must know of the pass that it draws into.

use crate::frame_view::FrameView;
use crate::renderer_error::RendererError;
use silhouette_core::view::DepthDirection;
use wgpu::CompareFunction;

/// The attachments of the render pass that a renderer draws into.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct TargetFormats {
    /// Format of the only colour attachment; colours are premultiplied by alpha ([`is_linear`](Self::is_linear) says in which space).
    pub color: wgpu::TextureFormat,
    /// Format of the depth attachment, cleared to [`clear_depth`](Self::clear_depth).
    pub depth: wgpu::TextureFormat,
    /// Which end of the depth buffer is near.
    pub depth_direction: DepthDirection,
    /// Samples per pixel of both attachments.
    pub samples: u32,
}

impl TargetFormats {
    /// The farthest value of the depth buffer.
    pub const fn clear_depth(&self) -> f32 {
        match self.depth_direction {
            DepthDirection::Standard => 1.0,
            DepthDirection::Reversed => 0.0,
        }
    }

    /// The depth test that lets through what is nearer than everything before ("less" in a standard buffer).
    pub const fn nearer(&self) -> CompareFunction {
        match self.depth_direction {
            DepthDirection::Standard => CompareFunction::Less,
            DepthDirection::Reversed => CompareFunction::Greater,
        }
    }

    /// The depth test that lets through what is nearer or as near ("less or equal" in a standard buffer).
    pub const fn nearer_or_equal(&self) -> CompareFunction {
        match self.depth_direction {
            DepthDirection::Standard => CompareFunction::LessEqual,
            DepthDirection::Reversed => CompareFunction::GreaterEqual,
        }
    }

    /// The depth state of a pipeline that tests with `compare` and writes what passes.
    pub fn depth_state(&self, compare: CompareFunction) -> wgpu::DepthStencilState {
        wgpu::DepthStencilState {
            format: self.depth,
            depth_write_enabled: Some(true),
            depth_compare: Some(compare),
            stencil: wgpu::StencilState::default(),
            bias: wgpu::DepthBiasState::default(),
        }
    }

    /// The depth state of a pipeline that neither tests nor writes depth.
    pub fn untested_depth_state(&self) -> wgpu::DepthStencilState {
        wgpu::DepthStencilState { depth_write_enabled: Some(false), ..self.depth_state(CompareFunction::Always) }
    }

    /// Whether fragments yield linear light: for formats that the hardware encodes (`...Srgb`), and for floats. Other formats
    /// store sRGB-encoded values as they are.
    pub fn is_linear(&self) -> bool {
        use wgpu::TextureFormat::{R16Float, R32Float, Rg11b10Ufloat, Rg16Float, Rg32Float, Rgba16Float, Rgba32Float};
        let is_float = matches!(
            self.color,
            R16Float | R32Float | Rg11b10Ufloat | Rg16Float | Rg32Float | Rgba16Float | Rgba32Float
        );
        is_float || self.color.is_srgb()
    }

    /// Whether `view` was made for a depth buffer like this one.
    ///
    /// # Errors
    /// [`RendererError::DepthDirection`].
    pub fn check(&self, view: &FrameView) -> Result<(), RendererError> {
        let (target, view) = (self.depth_direction, view.depth_direction());
        if target == view { Ok(()) } else { Err(RendererError::DepthDirection { target, view }) }
    }

    /// The multisample state of a pipeline.
    pub fn multisample_state(&self) -> wgpu::MultisampleState {
        wgpu::MultisampleState { count: self.samples, ..Default::default() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_clear_value_loses_against_everything_nearer() {
        for (depth_direction, nearer_value) in [(DepthDirection::Standard, 0.5), (DepthDirection::Reversed, 0.5_f32)] {
            let formats = TargetFormats {
                color: wgpu::TextureFormat::Rgba8Unorm,
                depth: wgpu::TextureFormat::Depth32Float,
                depth_direction,
                samples: 1,
            };
            let passes = |compare, value: f32| match compare {
                CompareFunction::Less => value < formats.clear_depth(),
                CompareFunction::Greater => value > formats.clear_depth(),
                CompareFunction::LessEqual => value <= formats.clear_depth(),
                CompareFunction::GreaterEqual => value >= formats.clear_depth(),
                other => panic!("{other:?} is no nearness test"),
            };
            assert!(passes(formats.nearer(), nearer_value));
            assert!(!passes(formats.nearer(), formats.clear_depth()));
            assert!(passes(formats.nearer_or_equal(), formats.clear_depth()));
        }
    }
}
