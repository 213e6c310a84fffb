//! [`FieldUniform`]: what the stages of a field know of the view. Twin: `shaders/baselines/field.wgsl`.

use super::reach::Extent;
use bytemuck::{Pod, Zeroable};
use silhouette_gpu::{FrameView, TargetFormats, WidthOverDepth};

/// A step in depth that no rounding hides, as a share of the depth beyond the near plane plus that of the near plane or the mesh's
/// radius, whichever is smaller; in an orthographic view, of that radius. Sixteen-bit depth buffers have coarser ones in places, and
/// lines there may be off by a pixel.
const DEPTH_STEP: f64 = 1.0 / (1 << 14) as f64;

/// How ink ends across a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Rim {
    /// At the target's samples.
    Samples,
    /// Blended by the share of the pixel that it covers.
    Smooth,
}

/// Twin of the struct in `field.wgsl`.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
pub(crate) struct FieldUniform {
    to_field: [i32; 2],
    size_px: [i32; 2],
    depth_terms: [f32; 4],
    reach: [f32; 2],
    lift: [f32; 2],
    ink: [f32; 4],
    samples: u32,
    is_smooth: u32,
    near: f32,
    _pad: u32,
}

impl FieldUniform {
    /// What a view comes to of objects whose largest radius is `radius` in view space; ink reaches the share `reach` of the width
    /// from its seeds.
    pub fn new(
        view: &FrameView,
        radius: f64,
        extent: &Extent,
        width: &WidthOverDepth,
        reach: f64,
        formats: &TargetFormats,
    ) -> Self {
        let size_px = extent.size_px().map(|side| i32::try_from(side).unwrap_or(i32::MAX));
        let law = view.depth_law();
        let near = law.range().near;
        let lift = if view.is_perspective() {
            [DEPTH_STEP, DEPTH_STEP * near.min(radius)]
        } else {
            [0.0, DEPTH_STEP * radius]
        };
        Self {
            to_field: extent.field_offset(),
            size_px,
            depth_terms: law.depth_beyond_near_terms().map(|term| term as f32),
            reach: [width.constant_px, width.px_at_depth_1].map(|part| (reach * part) as f32),
            lift: lift.map(|part| part as f32),
            ink: [0.0; 4],
            samples: formats.samples,
            is_smooth: 0,
            near: near as f32,
            _pad: 0,
        }
    }

    /// The same with this ink, as the target takes it, and this rim.
    pub fn with_ink(self, ink: [f32; 4], rim: Rim) -> Self {
        Self { ink, is_smooth: u32::from(rim == Rim::Smooth), ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::mem::offset_of;

    #[test]
    fn the_uniform_is_laid_out_as_its_wgsl_twin() {
        let members = [
            ("to_field", offset_of!(FieldUniform, to_field)),
            ("size_px", offset_of!(FieldUniform, size_px)),
            ("depth_terms", offset_of!(FieldUniform, depth_terms)),
            ("reach", offset_of!(FieldUniform, reach)),
            ("lift", offset_of!(FieldUniform, lift)),
            ("ink", offset_of!(FieldUniform, ink)),
            ("samples", offset_of!(FieldUniform, samples)),
            ("is_smooth", offset_of!(FieldUniform, is_smooth)),
            ("near", offset_of!(FieldUniform, near)),
        ];
        use silhouette_shaders::baselines::{BORDER_SEEDS, DISCONTINUITIES, FILTER_INK, FLOOD, OUTLINE_INK};
        for stage in [BORDER_SEEDS, DISCONTINUITIES, FILTER_INK, FLOOD, OUTLINE_INK] {
            let size = size_of::<FieldUniform>();
            assert!(silhouette_shaders::layout::matches(stage, "FieldUniform", size, &members));
        }
    }
}
