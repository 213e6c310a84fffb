//! [`StyleUniform`]: what a view decides, which every stage binds. Twin: `shaders/edge_mesh/style.wgsl`.

use crate::oct_normal;
use crate::options::EdgeMeshOptions;
use bytemuck::{Pod, Zeroable};
use silhouette_core::mesh::Bounds;
use silhouette_gpu::{Color, FrameView, LinePolygon, LocalFrame, Rounding, TargetFormats, WidthOverDepth};

/// Twin of the struct in `style.wgsl`.
#[repr(C)]
#[derive(Debug, Clone, Copy, Pod, Zeroable)]
pub(crate) struct StyleUniform {
    pub pens: [LinePolygon; 3],
    pub inks: [[f32; 4]; 3],
    pub viewer: [f32; 4],
    pub faces: u32,
    pub edges: u32,
    pub features: u32,
    pub turned: u32,
    pub silhouette_bits: u32,
    pub feature_bits: u32,
    pub back_features: u32,
    pub back_boundaries: u32,
    pub bends_now: u32,
    pub ridge_cosine: f32,
    pub valley_cosine: f32,
    _pad: u32,
}

/// Fills in what a view decides; counts, bits and what is drawn of back faces are the caller's.
pub(crate) fn of_view(
    options: &EdgeMeshOptions,
    view: &FrameView,
    bounds: &Bounds,
    frame: &LocalFrame,
    formats: &TargetFormats,
) -> StyleUniform {
    let pens = options.pens();
    let widths = pens.map(|pen| WidthOverDepth::new(&pen.width, view, bounds));
    let ink = |index: usize| Color { srgb: pens[index].ink, alpha: options.ink_alpha }.for_target(formats);
    let nearest = nearest_depth(view, bounds);
    let widest_px = widths[1].px_at(nearest).max(widths[2].px_at(nearest));
    let feature = |width: &WidthOverDepth| {
        let mut pen = LinePolygon::of_view(view, frame, width, 0.5, true);
        // Ridges and valleys are drawn together, so that their polygons have as many points.
        pen.round(Rounding::new(0.5 * widest_px, true));
        pen.shape.lift = width.lift(view, bounds).1;
        pen
    };
    let mut silhouette = LinePolygon::of_view(view, frame, &widths[0], 1.0, false);
    silhouette.round(Rounding::new(widths[0].px_at(nearest), false));
    let [ridge_cosine, valley_cosine] = [options.ridge_angle_deg, options.valley_angle_deg].map(least_cosine);
    StyleUniform {
        pens: [silhouette, feature(&widths[1]), feature(&widths[2])],
        inks: [0, 1, 2].map(ink),
        viewer: frame.viewer(view).to_array(),
        faces: 0,
        edges: 0,
        features: 0,
        turned: u32::from(view.is_mirrored()),
        silhouette_bits: 0,
        feature_bits: 0,
        back_features: 0,
        back_boundaries: 0,
        bends_now: 0,
        ridge_cosine,
        valley_cosine,
        _pad: 0,
    }
}

/// The least depth at which a mesh can be seen, for ends that are round enough there.
fn nearest_depth(view: &FrameView, bounds: &Bounds) -> f64 {
    let near = view.depth_law().range().near;
    if view.is_perspective() { near.max(view.depth(bounds.center) - bounds.radius * view.largest_scale()) } else { 1.0 }
}

/// The cosine at or below which two stored normals make the angle; below -1 for 180 degrees, at which nothing is drawn. Either
/// normal may have turned when it was stored.
fn least_cosine(angle_deg: f64) -> f32 {
    if angle_deg >= 180.0 { -2.0 } else { (angle_deg.to_radians() - 2.0 * oct_normal::ERROR_RAD).cos() as f32 }
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
        let members = members![
            pens,
            inks,
            viewer,
            faces,
            edges,
            features,
            turned,
            silhouette_bits,
            feature_bits,
            back_features,
            back_boundaries,
            bends_now,
            ridge_cosine,
            valley_cosine
        ];
        for stage in [silhouette_shaders::edge_mesh::LINES, silhouette_shaders::edge_mesh::DRAWN_EDGES] {
            assert!(silhouette_shaders::layout::matches(stage, "StyleUniform", size_of::<StyleUniform>(), &members));
        }
    }

    #[test]
    fn angles_of_180_degrees_are_reached_by_no_normals() {
        assert!(least_cosine(180.0) < -1.0 && least_cosine(179.9) > -1.0);
        // A cube's ridges are still ridges when their normals are stored.
        assert!(least_cosine(90.0) > 0.0 && least_cosine(90.0) < 2e-4);
    }
}
