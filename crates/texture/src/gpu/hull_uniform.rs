//! [`HullUniform`]: what the stages know of a view of the hull. Twin: `shaders/texture/hull.wgsl`.

use super::style::{Drawing, OutlineWidth, TextureStyle};
use super::volume::TextureVolume;
use crate::lookup::AzimuthRule;
use bytemuck::{Pod, Zeroable};
use glam::{DMat3, DVec3};
use silhouette_core::glam;
use silhouette_gpu::{Color, FrameView, Interior};

#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
pub(super) struct HullUniform {
    eye: [f32; 4],
    ink: [f32; 4],
    paper: [f32; 4],
    normal_to_shape: [[f32; 4]; 3],
    azimuth_shift: f32,
    half_width: f32,
    pixel_per_w: f32,
    allowance_per_w: f32,
    gap_unit: f32,
    _pad: [u32; 3],
}

impl HullUniform {
    pub fn new(volume: &TextureVolume, style: &TextureStyle, view: &FrameView) -> Self {
        let frame = volume.frame();
        let eye = view.object_eye();
        let eye = if view.is_perspective() {
            frame.to_local(eye.truncate()).extend(1.0)
        } else {
            eye.truncate().normalize_or_zero().as_vec3().extend(0.0)
        };
        let to_clip = frame.to_clip(view);
        let [up, depth] = [1, 3].map(|row| to_clip.row(row).truncate().length());
        let radius = volume.radius() / frame.unit();
        // One radius everywhere in orthographic views, where w does not grow.
        let depth_per_w = if view.is_perspective() { 1.0 / depth } else { radius };
        let (half_width, sigma, ink, paper) = match &style.drawing {
            Drawing::Surface(_) | Drawing::Hull(_) => (0.0, 0.0, Color::TRANSPARENT, Color::TRANSPARENT),
            Drawing::Outlines(outlines) => {
                let (half_width, sigma) = match outlines.width {
                    OutlineWidth::Gradient { px } | OutlineWidth::Gap { px } => (0.5 * px.max(0.0), 0.0),
                    OutlineWidth::AsPrinted { sigma } => (1.0, sigma.max(0.0)),
                };
                let paper = match outlines.interior {
                    Interior::Paper(color) => color,
                    Interior::DepthOnly | Interior::None => Color::TRANSPARENT,
                };
                (half_width, sigma, outlines.ink, paper)
            }
        };
        Self {
            eye: eye.to_array(),
            ink: straight(ink),
            paper: straight(paper),
            normal_to_shape: normal_matrix(frame.shape(view)),
            // The middle of the first texel, or its outer corner.
            azimuth_shift: match style.azimuths {
                AzimuthRule::Aligned => 0.5 / volume.azimuths() as f32,
                AzimuthRule::AsPrinted => 0.0,
            },
            half_width: half_width as f32,
            pixel_per_w: (2.0 / (f64::from(view.viewport().size_px[1]) * up)) as f32,
            allowance_per_w: (sigma * depth_per_w / radius) as f32,
            gap_unit: (volume.radius() / frame.unit()) as f32,
            _pad: [0; 3],
        }
    }
}

fn straight(color: Color) -> [f32; 4] {
    let [red, green, blue] = color.srgb.map(|part| part as f32);
    [red, green, blue, color.alpha as f32]
}

/// Normals transform by the inverse transpose: by the cofactors of the matrix, which differ from it by a factor only.
fn normal_matrix(shape: DMat3) -> [[f32; 4]; 3] {
    let [x, y, z] = [shape.x_axis, shape.y_axis, shape.z_axis];
    let cofactors = [y.cross(z), z.cross(x), x.cross(y)];
    let largest = cofactors.iter().map(|column| column.length()).fold(f64::MIN_POSITIVE, f64::max);
    cofactors.map(|column: DVec3| (column / largest).as_vec3().extend(0.0).to_array())
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_shaders::layout;
    use silhouette_shaders::texture::{LOOKUP, LOOKUP_TERMS};
    use std::mem::offset_of;

    #[test]
    fn the_uniform_is_laid_out_as_its_wgsl_twin() {
        let members = [
            ("eye", offset_of!(HullUniform, eye)),
            ("ink", offset_of!(HullUniform, ink)),
            ("paper", offset_of!(HullUniform, paper)),
            ("normal_to_shape", offset_of!(HullUniform, normal_to_shape)),
            ("azimuth_shift", offset_of!(HullUniform, azimuth_shift)),
            ("half_width", offset_of!(HullUniform, half_width)),
            ("pixel_per_w", offset_of!(HullUniform, pixel_per_w)),
            ("allowance_per_w", offset_of!(HullUniform, allowance_per_w)),
            ("gap_unit", offset_of!(HullUniform, gap_unit)),
        ];
        for stage in [LOOKUP, LOOKUP_TERMS] {
            assert!(layout::matches(stage, "HullUniform", size_of::<HullUniform>(), &members));
        }
    }
}
