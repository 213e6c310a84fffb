//! [`SurfaceUniform`]: the colour and the light of a surface. Twin: `shaders/shared/surface.wgsl`.

use crate::color::Color;
use crate::frame_view::FrameView;
use crate::local_frame::LocalFrame;
use bytemuck::{Pod, Zeroable};
use glam::{DMat3, DVec3};

/// Share of the light that falls on faces turned away from it.
const AMBIENT: f32 = 0.25;

/// Towards the light from the viewer: to the left, upwards and backwards, over the viewer's left shoulder.
const LIGHT: [f64; 3] = [-0.4, 0.6, 1.0];

/// What stages that import `shared/surface.wgsl` know of a surface: its colour, where the light comes from, and the matrix that
/// takes it from the [`LocalFrame`] to its [shape](LocalFrame::shape). For binding 1 of a [`CameraBinding`](crate::CameraBinding).
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
pub struct SurfaceUniform {
    color: [f32; 4],
    light: [f32; 4],
    shape: [[f32; 4]; 3],
    is_linear: u32,
    _pad: [u32; 3],
}

impl SurfaceUniform {
    /// The surface of a mesh whose positions are in `frame`, lit from the upper left of the viewer of `view`. `is_linear` is
    /// the [target's](crate::TargetFormats::is_linear).
    pub fn new(frame: &LocalFrame, view: &FrameView, color: Color, is_linear: bool) -> Self {
        // The light stands still for the viewer. From view space to the axes of the world, in which the shape lies.
        let [left, up, back] = LIGHT;
        let light = DVec3::new(left, up, view.depth_law().view_z_of_depth(-back));
        let world_to_view = DMat3::from_mat4(view.object_to_view() * view.model().inverse());
        let light = (world_to_view.inverse() * light).normalize_or_zero().as_vec3();
        let [red, green, blue] = color.srgb.map(|part| part as f32);
        let columns = frame.shape(view).as_mat3().to_cols_array_2d();
        Self {
            color: [red, green, blue, color.alpha as f32],
            light: light.extend(AMBIENT).to_array(),
            shape: columns.map(|[x, y, z]| [x, y, z, 0.0]),
            is_linear: u32::from(is_linear),
            _pad: [0; 3],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_shaders::layout;
    use std::mem::offset_of;

    #[test]
    fn the_uniform_is_laid_out_as_its_wgsl_twin() {
        let members = [
            ("color", offset_of!(SurfaceUniform, color)),
            ("light", offset_of!(SurfaceUniform, light)),
            ("shape", offset_of!(SurfaceUniform, shape)),
            ("is_linear", offset_of!(SurfaceUniform, is_linear)),
        ];
        let size = size_of::<SurfaceUniform>();
        for stage in [silhouette_shaders::gpu::FILL, silhouette_shaders::smoothing::VIEW_MESH] {
            assert!(layout::matches(stage, "SurfaceUniform", size, &members));
        }
    }
}
