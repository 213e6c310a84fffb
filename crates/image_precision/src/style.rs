//! [`StyleUniform`]: the style of lines, which every stage binds. Twin: `shaders/image_precision/style.wgsl`.

use crate::depth_range;
use crate::fatten::FattenLaw;
use crate::settings::{Settings, Texture, Variant};
use crate::{fixed_pull, scale};
use bytemuck::{Pod, Zeroable};
use silhouette_core::glam::{DMat4, DVec3};
use silhouette_core::mesh::Bounds;
use silhouette_core::view::{Camera, ClipRange, DepthDirection, Projection};
use silhouette_gpu::{LinePolygon, LocalFrame, Rounding};

/// Direction towards the light in the image, y up: the upper left.
const LIGHT: [f64; 2] = [-0.6, 0.8];

/// Twin of the struct in `style.wgsl`.
#[repr(C)]
#[derive(Debug, Clone, Copy, Pod, Zeroable)]
pub(crate) struct StyleUniform {
    pub back_to_clip: [[f32; 4]; 4],
    pub eye: [f32; 4],
    pub axis: [f32; 4],
    pub ink: [f32; 4],
    pub line: LinePolygon,
    pub fade: [f32; 3],
    pub clamp_edges: f32,
    pub band: f32,
    pub law: u32,
    pub texture: u32,
    pub faces: u32,
    pub slot_mask: u32,
    pub corner_mask: u32,
    pub polygon_corners: u32,
    pub noted: u32,
    pub most_around: f32,
    pub _pad: [u32; 3],
}

/// Depths that are drawn, and how back faces are mapped to clip space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Pulled {
    pub range: ClipRange,
    pub view_to_clip: DMat4,
}

impl Pulled {
    /// For one view of a mesh with these bounds, within `range` or else within depths that hold what is pulled too.
    pub fn new(
        variant: Variant,
        camera: &Camera,
        bounds: &Bounds,
        range: Option<ClipRange>,
        direction: DepthDirection,
    ) -> Self {
        if let Some(range) = range {
            return Self::within(variant, camera, bounds, range, direction);
        }
        let tight = camera.clip_range(bounds);
        let range = match variant {
            Variant::FixedPull { radii } => fixed_pull::widened(camera, tight, radii * bounds.radius),
            Variant::Scale { k } | Variant::Unoriented { k: Some(k) } => scale::widened(camera, tight, k),
            Variant::DepthRange { plane, factor } => depth_range::widened(tight, plane, factor),
            _ => tight,
        };
        Self::within(variant, camera, bounds, range, direction)
    }

    fn within(variant: Variant, camera: &Camera, bounds: &Bounds, range: ClipRange, direction: DepthDirection) -> Self {
        let view_to_clip = match variant {
            Variant::FixedPull { radii } => fixed_pull::clip(camera, range, direction, radii * bounds.radius),
            Variant::Scale { k } | Variant::Unoriented { k: Some(k) } => scale::clip(camera, range, direction, k),
            Variant::DepthRange { plane, factor } => depth_range::clip(camera, range, direction, plane, factor),
            _ => camera.clip_matrix(range, direction),
        };
        Self { range, view_to_clip }
    }
}

/// How far lines reach beside their edges, as a share of their width: those of a wireframe lie on both sides.
pub(crate) fn reach(variant: Variant) -> f64 {
    if matches!(variant, Variant::Wireframe { .. }) { 0.5 } else { 1.0 }
}

/// How lines are rounded that are at most so wide. Lines of a wireframe end bluntly.
fn rounding(variant: Variant, widest_px: f64) -> Rounding {
    if matches!(variant, Variant::Wireframe { .. }) { Rounding::BLUNT } else { Rounding::new(widest_px, false) }
}

/// Fills in what a view decides; counts of the mesh and of tables are the caller's.
pub(crate) fn of_view(
    settings: &Settings,
    camera: &Camera,
    bounds: &Bounds,
    frame: &LocalFrame,
    pulled: &Pulled,
) -> StyleUniform {
    let unit = frame.clip_unit(camera);
    let axis = (camera.target().as_dvec3() - camera.eye().as_dvec3()).normalize();
    let (eye, px_per_unit) = match camera.projection() {
        Projection::Perspective { .. } => {
            (frame.to_local(camera.eye().as_dvec3()).extend(1.0), camera.pixels_per_unit(1.0))
        }
        Projection::Orthographic { .. } => (-axis.as_vec3().extend(0.0), camera.pixels_per_unit(1.0) * frame.unit()),
    };
    let width = settings.width.over_depth(camera, bounds);
    let rounding = rounding(settings.variant, width.px_at(pulled.range.near.abs()));
    let reach = reach(settings.variant);
    let depth = (bounds.center - camera.eye().as_dvec3()).dot(axis);
    let law = match settings.variant {
        Variant::Fatten { law } | Variant::Charcoal { law, .. } => law,
        _ => FattenLaw::Exact,
    };
    let [red, green, blue] = settings.ink;
    let near_w = match camera.projection() {
        Projection::Perspective { .. } => (pulled.range.near / unit) as f32,
        Projection::Orthographic { .. } => 0.5,
    };
    let reach_px = [width.constant_px, width.px_at_depth_1 / unit].map(|part| (reach * part) as f32);
    let mut line = LinePolygon::new(camera.size().map(|side| side as f32), reach_px, near_w, rounding);
    line.shape.light = LIGHT.map(|part| (part * settings.light_thinning) as f32);
    StyleUniform {
        back_to_clip: frame.through(camera, pulled.view_to_clip).as_mat4().to_cols_array_2d(),
        eye: eye.to_array(),
        axis: axis.as_vec3().extend(px_per_unit as f32).to_array(),
        ink: DVec3::new(red, green, blue).as_vec3().extend(1.0).to_array(),
        line,
        fade: [(depth - bounds.radius) / unit, (depth + bounds.radius) / unit, settings.depth_fade]
            .map(|part| part as f32),
        clamp_edges: settings.fatten_clamp as f32,
        band: if let Variant::Charcoal { band, .. } = settings.variant { band as f32 } else { 0.0 },
        law: match law {
            FattenLaw::Exact => 0,
            FattenLaw::AsPrinted => 1,
            FattenLaw::WithoutSine => 2,
        },
        texture: match settings.texture {
            Texture::Solid => 0,
            Texture::Dashes => 1,
            Texture::Stipple => 2,
        },
        faces: 0,
        slot_mask: 0,
        corner_mask: 0,
        polygon_corners: 3,
        noted: 0,
        most_around: 0.0,
        _pad: [0; 3],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::mem::offset_of;

    #[test]
    fn the_uniform_is_laid_out_as_its_wgsl_twin() {
        macro_rules! members {
            ($($name:ident),*) => { [$((stringify!($name), offset_of!(StyleUniform, $name))),*] };
        }
        let members = members!(
            back_to_clip,
            eye,
            axis,
            ink,
            line,
            fade,
            clamp_edges,
            band,
            law,
            texture,
            faces,
            slot_mask,
            corner_mask,
            polygon_corners,
            noted,
            most_around
        );
        let stage = silhouette_shaders::image_precision::SCREEN;
        let size = size_of::<StyleUniform>();
        assert!(silhouette_shaders::layout::matches(stage, "StyleUniform", size, &members));
    }
}
