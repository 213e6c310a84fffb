//! Section 3.3: back faces fattened in their own plane, so far that each edge's strip is as wide in the image as asked.
//!
//! A polygon of n corners becomes a fan of 2 n triangles about its middle: one over each pushed edge, one over each gap
//! between two pushed edges. Adjacency is not needed. The fan may fold over for skewed polygons, so facing is decided
//! once, from the polygon, and the fan is drawn without culling.
//!
//! 1. `cut_triangles.wgsl` classifies every polygon once. A fattened triangle is a hexagon of pushed edges and the bevels between
//!    them. If it is convex, every second side, extended, bounds a triangle around it. Where that has at most three times the
//!    area, as for most triangles except needles, it is drawn in place of the hexagon, and the three corners outside the hexagon
//!    are discarded per pixel. On a software adapter a frame takes a quarter to a half less than with fans alone.
//! 2. `fans.wgsl` makes fans of all other polygons. A convex one has 2 n - 2 triangles about its first corner, which cover the
//!    same part of the plane as the paper's 2 n.
//! 3. `fatten.wgsl` draws both.
//!
//! The picture is that of the paper's fans, except for single pixels along edges. `fatten-law=as-printed` and textures, which
//! run along edges, use fans of 2 n triangles throughout; only targets with one or four samples per pixel cut triangles.
//!
//! [`push`] is the law, as the stages compute it. The printed one, `K z sin(a) / (V.N)`, is exact only for edges whose
//! strip lies parallel to the image plane; see [`FattenLaw`].
//!
//! # What fattening in the plane cannot do
//! The strip slides along its edge by `w |cos(a)| sqrt(sin²(a) - (V.N)²) / V.N` ([`slip`]): for the nearly edge-on faces
//! of a fine smooth mesh many times its width, which are the spikes that stand off its outlines; they grow as the mesh is
//! refined. `fatten-clamp` trades spikes for thinness. [`screen`](crate::screen) has neither. Corners are bevelled, a turn
//! of b is `w cos(b / 2)` wide.

use silhouette_core::glam::DVec3;

/// How far an edge is pushed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FattenLaw {
    /// So that the strip is as wide as asked at the middle of the edge, measured across the edge in the image.
    Exact,
    /// `K z sin(a) / (V.N)` with the distance from the camera as z, as printed.
    AsPrinted,
    /// `K z / (V.N)`, the paper's first approximation, without the sine.
    WithoutSine,
}

/// An edge of a polygon in the camera's frame: the eye at the origin, the viewing axis along -z.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FattenedEdge {
    /// Its middle.
    pub middle: DVec3,
    /// Unit direction, counter-clockwise around the polygon seen from outside.
    pub along: DVec3,
    /// Unit normal of the polygon, outward.
    pub normal: DVec3,
}

/// How far to push an edge within its plane for a strip of `width_px` in a perspective with a focal length of `focal_px`;
/// `None` where no push reaches: the plane's horizon is nearer than the width.
///
/// With X the edge's middle, Z its depth, V = X / |X|, a the angle between V and the edge, m = unit(X x E), and d the
/// direction of the push, the strip of a push D is `f D |V.N| / (sin(a) (Z + D dz) sqrt(1 - mz²))` wide.
pub fn push(edge: &FattenedEdge, width_px: f64, focal_px: f64, law: FattenLaw) -> Option<f64> {
    let FattenedEdge { middle, along, normal } = *edge;
    let depth = -middle.z;
    let view = middle.normalize();
    let facing = view.dot(normal).abs();
    let across = view.cross(along);
    let sine = across.length();
    if law != FattenLaw::Exact {
        let sine = if law == FattenLaw::AsPrinted { sine } else { 1.0 };
        return Some(width_px / focal_px * middle.length() * sine / facing).filter(|push| push.is_finite());
    }
    let leaning = across.normalize_or_zero().z;
    let s = sine * (1.0 - leaning * leaning).sqrt();
    let recedes = -along.cross(normal).z;
    let room = focal_px * facing - width_px * recedes * s;
    (room > 0.0).then(|| width_px * depth * s / room)
}

/// How far the strip slides along its edge, over its width.
pub fn slip(edge: &FattenedEdge) -> f64 {
    let view = edge.middle.normalize();
    let facing = view.dot(edge.normal).abs();
    let cosine = view.dot(edge.along);
    let sine_squared = 1.0 - cosine * cosine;
    cosine.abs() * (sine_squared - facing * facing).max(0.0).sqrt() / facing
}

/// Draws fattened polygons by two stages of `shaders/image_precision/fatten.wgsl`, vertex and fragment.
#[cfg(feature = "gpu")]
pub(crate) fn pipeline(
    device: &wgpu::Device,
    label: &str,
    [vertex, fragment]: [&str; 2],
    vertex_buffers: &[Option<wgpu::VertexBufferLayout<'static>>],
    blend: Option<wgpu::BlendState>,
    formats: silhouette_gpu::TargetFormats,
) -> wgpu::RenderPipeline {
    silhouette_gpu::kit::RenderStage {
        label,
        wgsl: silhouette_shaders::image_precision::FATTEN,
        vertex,
        fragment,
        bindings: &[Some(&silhouette_gpu::CameraBinding::layout(device))],
        vertex_buffers,
        depth: Some(formats.depth_state(formats.nearer_or_equal())),
        color: formats.color,
        blend,
        samples: formats.samples,
        ..silhouette_gpu::kit::RenderStage::default()
    }
    .build(device)
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::glam::DVec2;

    const FOCAL_PX: f64 = 900.0;

    /// Width of the strip of a push, measured in the image: how far the pushed line is from the edge's, at its middle.
    fn strip_px(edge: &FattenedEdge, push: f64) -> f64 {
        let image = |p: DVec3| DVec2::new(p.x, p.y) / -p.z * FOCAL_PX;
        let outward = edge.along.cross(edge.normal);
        let step = 1e-6 * edge.middle.length();
        let way = (image(edge.middle + edge.along * step) - image(edge.middle - edge.along * step)).normalize();
        (image(edge.middle + outward * push) - image(edge.middle)).perp_dot(way).abs()
    }

    /// Edges in the view of a wide lens, a fixed sequence of them.
    fn edges() -> impl Iterator<Item = FattenedEdge> {
        let mut state = 1_u64;
        let mut next = move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 53) as f64 * 2.0 - 1.0
        };
        let edge = std::iter::repeat_with(move || {
            let middle = DVec3::new(2.0 * next(), 1.5 * next(), -2.0 - next());
            let along = DVec3::new(next(), next(), next()).normalize();
            let normal = along.cross(DVec3::new(next(), next(), next())).normalize();
            FattenedEdge { middle, along, normal }
        });
        edge.filter(|edge| edge.middle.normalize().dot(edge.normal) > 0.02 && edge.along.z.abs() < 0.9).take(4000)
    }

    #[test]
    fn the_exact_law_is_exact_wherever_a_push_reaches() {
        let mut reached = 0;
        for edge in edges() {
            let Some(push) = push(&edge, 2.0, FOCAL_PX, FattenLaw::Exact) else { continue };
            let drawn = strip_px(&edge, push);
            assert!((drawn / 2.0 - 1.0).abs() < 1e-5, "{edge:?}: {drawn}");
            reached += 1;
        }
        assert!(reached > 3500, "{reached}");
    }

    #[test]
    fn the_printed_law_is_too_wide_off_the_axis_and_the_simple_one_aslant() {
        let share = |law| {
            let mut widths: Vec<f64> = edges()
                .filter(|edge| edge.middle.normalize().dot(edge.normal) > 0.2)
                .map(|edge| strip_px(&edge, push(&edge, 0.02, FOCAL_PX, law).unwrap()) / 0.02)
                .collect();
            widths.sort_by(f64::total_cmp);
            [widths[0], widths[widths.len() / 2], widths[widths.len() - 1]]
        };
        let [least, median, most] = share(FattenLaw::AsPrinted);
        assert!(least > 0.99 && median > 1.02 && most > 1.3, "{least} {median} {most}");
        assert!(share(FattenLaw::WithoutSine)[1] > median);
        assert!(share(FattenLaw::Exact).iter().all(|width| (width - 1.0).abs() < 1e-4));
    }

    #[test]
    fn a_plane_whose_horizon_is_near_cannot_be_fattened() {
        let normal = DVec3::new(0.0, 1.0, -1e-4).normalize();
        let middle = DVec3::new(0.0, 1e-4, -3.0);
        let edge = FattenedEdge { middle, along: -DVec3::X, normal };
        assert!(edge.along.cross(normal).z < 0.0, "receding");
        assert_eq!(push(&edge, 2.0, FOCAL_PX, FattenLaw::Exact), None);
        assert!(slip(&FattenedEdge { along: DVec3::new(1.0, 0.0, -1.0).normalize(), ..edge }) > 100.0);
    }
}
