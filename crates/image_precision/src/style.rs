//! [`StyleUniform`]: the style of lines, which every stage binds. Twin: `shaders/image_precision/style.wgsl`.

use crate::fatten::FattenLaw;
use crate::ink::is_on_paper;
use crate::options::Texture;
use crate::settings::{Settings, Variant};
use crate::{depth_range, fixed_pull, scale};
use bytemuck::{Pod, Zeroable};
use silhouette_core::glam::{DMat3, DMat4, DVec3, DVec4, Vec4};
use silhouette_core::mesh::Bounds;
use silhouette_core::view::{Camera, ClipRange};
use silhouette_gpu::{Color, FrameView, LinePolygon, LocalFrame, Rounding, TargetFormats, WidthOverDepth};

/// Direction towards the light in the image, y up: the upper left.
const LIGHT: [f64; 2] = [-0.6, 0.8];

/// Twin of the struct in `style.wgsl`.
#[repr(C)]
#[derive(Debug, Clone, Copy, Pod, Zeroable)]
pub(crate) struct StyleUniform {
    pub back_to_clip: [[f32; 4]; 4],
    pub shape: [[f32; 4]; 4],
    pub shape_to_clip: [[f32; 4]; 4],
    pub local_eye: [f32; 4],
    pub eye: [f32; 4],
    pub axis: [f32; 4],
    pub up: [f32; 4],
    pub ink: [f32; 4],
    pub paper: [f32; 4],
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
    pub turned: u32,
    pub shape_sign: f32,
    pub is_linear: u32,
}

/// Depths that hold what a variant pulls, besides the mesh itself in `mesh`.
pub(crate) fn widened(variant: Variant, camera: &Camera, bounds: &Bounds, mesh: ClipRange) -> ClipRange {
    match variant {
        Variant::FixedPull { radii } => fixed_pull::widened(camera, mesh, radii * bounds.radius),
        Variant::Scale { k } | Variant::Unoriented { k: Some(k) } => scale::widened(camera.projection(), mesh, k),
        Variant::DepthRange { plane, factor } => depth_range::widened(mesh, plane, factor),
        _ => mesh,
    }
}

/// View to clip space as back faces are pulled.
fn pulled(variant: Variant, view: &FrameView, bounds: &Bounds) -> DMat4 {
    match variant {
        Variant::FixedPull { radii } => fixed_pull::projection(view, radii * bounds.radius * view.largest_scale()),
        Variant::Scale { k } | Variant::Unoriented { k: Some(k) } => {
            scale::projection(view, k, view.depth(bounds.center))
        }
        Variant::DepthRange { plane, factor } => depth_range::projection(view, plane, factor),
        _ => view.projection(),
    }
}

/// How far lines reach beside their edges, as a share of their width: those of a wireframe lie on both sides and end bluntly.
pub(crate) fn reach(variant: Variant) -> f64 {
    if matches!(variant, Variant::Wireframe { .. }) { 0.5 } else { 1.0 }
}

/// Where the viewer is in the frame of a mesh and in its shape: eyes with w = 1, or directions towards the viewer with w = 0.
struct Viewer {
    local_eye: Vec4,
    eye: DVec4,
    /// Unit viewing axis, away from the viewer, and the direction up in the image, in the shape.
    axis: DVec3,
    up: DVec3,
}

impl Viewer {
    fn new(view: &FrameView, frame: &LocalFrame) -> Self {
        let to_world = DMat3::from_mat4(view.object_to_view() * view.model().inverse()).inverse();
        let axis = (to_world * DVec3::Z * view.depth_law().view_z_of_depth(1.0)).normalize();
        let up = (to_world * DVec3::Y).normalize();
        let local_eye = frame.viewer(view);
        let eye = if view.is_perspective() {
            (frame.shape(view) * local_eye.truncate().as_dvec3()).extend(1.0)
        } else {
            (-axis).extend(0.0)
        };
        Self { local_eye, eye, axis, up }
    }
}

/// Fills in what a view decides; counts of the mesh and of tables are the caller's.
pub(crate) fn of_view(
    settings: &Settings,
    view: &FrameView,
    bounds: &Bounds,
    frame: &LocalFrame,
    formats: &TargetFormats,
) -> StyleUniform {
    let depth_per_w = frame.depth_per_w(view);
    let Viewer { local_eye, eye, axis, up } = Viewer::new(view, frame);
    let px_per_unit = view.pixels_per_unit(1.0) * if view.is_perspective() { 1.0 } else { frame.unit() };
    let width = WidthOverDepth::new(&settings.width, view, bounds);
    let (depth, radius) = (view.depth(bounds.center), bounds.radius * view.largest_scale());
    let law = match settings.variant {
        Variant::Fatten { law } | Variant::Charcoal { law, .. } => law,
        _ => FattenLaw::Exact,
    };
    let mut line = LinePolygon::of_view(view, frame, &width, reach(settings.variant), false);
    if matches!(settings.variant, Variant::Wireframe { .. }) {
        line.round(Rounding::BLUNT);
    }
    line.shape.light = LIGHT.map(|part| (part * settings.light_thinning) as f32);
    let shape = DMat4::from_mat3(frame.shape(view));
    let columns = |matrix: DMat4| matrix.as_mat4().to_cols_array_2d();
    StyleUniform {
        back_to_clip: columns(frame.through(view, pulled(settings.variant, view, bounds))),
        shape: columns(shape),
        shape_to_clip: columns(frame.to_clip(view) * shape.inverse()),
        local_eye: local_eye.to_array(),
        eye: eye.as_vec4().to_array(),
        axis: axis.as_vec3().extend(px_per_unit as f32).to_array(),
        up: up.as_vec3().extend(0.0).to_array(),
        ink: Color { srgb: settings.ink, alpha: settings.ink_alpha }.for_target(formats),
        paper: (if is_on_paper(settings) { Color::WHITE } else { Color::TRANSPARENT }).for_target(formats),
        line,
        fade: [(depth - radius) / depth_per_w, (depth + radius) / depth_per_w, settings.depth_fade]
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
        turned: u32::from(view.is_mirrored()),
        shape_sign: shape.determinant().signum() as f32,
        is_linear: u32::from(formats.is_linear()),
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
            shape,
            shape_to_clip,
            local_eye,
            eye,
            axis,
            up,
            ink,
            paper,
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
            most_around,
            turned,
            shape_sign,
            is_linear
        );
        let stage = silhouette_shaders::image_precision::SCREEN;
        let size = size_of::<StyleUniform>();
        assert!(silhouette_shaders::layout::matches(stage, "StyleUniform", size, &members));
    }
}
