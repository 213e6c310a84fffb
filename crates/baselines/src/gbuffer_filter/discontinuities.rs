//! Step 2: seeds where depth steps or normals turn. Stage: `shaders/baselines/discontinuities.wgsl`.
//!
//! A pixel that shows the mesh beside one that does not is always part of a line. Between two that show it, the step in depth counts
//! as far as it exceeds the steps beside it along the same line of pixels. `roberts` puts the seed within the square of four pixels,
//! between the nearer and the farther ones; `sobel` half a pixel from the nearer one, towards the farther ones, and at the pixel's
//! middle where normals alone turn, on either side of a crease. Its gradient of normals depends a little on the crease's direction in
//! the image, so that angles within a tenth of the threshold may count or not.

use super::gbuffer;
use super::method::{FilteredEdges, GbufferFilterOptions, Operator};
use crate::distance_field::FieldLayouts;
use bytemuck::{Pod, Zeroable};
use silhouette_gpu::kit::compute_pipeline;
use silhouette_gpu::{CameraBinding, FrameView};

/// Twin of the struct `Thresholds` in `discontinuities.wgsl`.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
pub(super) struct ThresholdsUniform {
    depth: f32,
    cosine: f32,
    chord_squared: f32,
    middle: f32,
    middle_beyond_near: f32,
    ground: f32,
    is_perspective: u32,
    finds_turns: u32,
}

impl ThresholdsUniform {
    /// Those of a mesh whose middle is at the depth `middle` and whose radius in view space is `radius`; where there is no mesh the
    /// G-buffer's depth is `ground`.
    pub fn new(options: &GbufferFilterOptions, view: &FrameView, middle: f64, radius: f64, ground: f32) -> Self {
        // No farther from any depth of the mesh than by a factor, wherever the viewer stands.
        let middle = middle.max(radius);
        let angle = options.normal_threshold_deg.to_radians();
        let chord = 2.0 * (0.5 * angle).sin();
        Self {
            depth: (options.depth_threshold * radius) as f32,
            cosine: angle.cos() as f32,
            chord_squared: (chord * chord) as f32,
            middle: middle as f32,
            middle_beyond_near: (middle - view.depth_law().range().near) as f32,
            ground,
            is_perspective: u32::from(view.is_perspective()),
            finds_turns: u32::from(options.edges == FilteredEdges::All),
        }
    }
}

/// The stage that reads the G-buffer as group 1 and plants seeds into group 2.
pub(super) fn pipeline(device: &wgpu::Device, layouts: &FieldLayouts, operator: Operator) -> wgpu::ComputePipeline {
    let entry = match operator {
        Operator::Roberts => "roberts",
        Operator::Sobel => "sobel",
    };
    let (camera, gbuffer) = (CameraBinding::layout(device), gbuffer::layout(device));
    let bindings = [Some(&camera), Some(&gbuffer), Some(&layouts.planting)];
    compute_pipeline(device, silhouette_shaders::baselines::DISCONTINUITIES, entry, &bindings)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::mem::offset_of;

    #[test]
    fn the_uniform_is_laid_out_as_its_wgsl_twin() {
        let members = [
            ("depth", offset_of!(ThresholdsUniform, depth)),
            ("cosine", offset_of!(ThresholdsUniform, cosine)),
            ("chord_squared", offset_of!(ThresholdsUniform, chord_squared)),
            ("middle", offset_of!(ThresholdsUniform, middle)),
            ("middle_beyond_near", offset_of!(ThresholdsUniform, middle_beyond_near)),
            ("ground", offset_of!(ThresholdsUniform, ground)),
            ("is_perspective", offset_of!(ThresholdsUniform, is_perspective)),
            ("finds_turns", offset_of!(ThresholdsUniform, finds_turns)),
        ];
        let stage = silhouette_shaders::baselines::DISCONTINUITIES;
        assert!(silhouette_shaders::layout::matches(stage, "Thresholds", size_of::<ThresholdsUniform>(), &members));
    }
}
