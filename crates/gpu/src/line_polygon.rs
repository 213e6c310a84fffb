//! [`LinePolygon`]: lines of any width as convex polygons in the image. Twin of `shaders/shared/line_polygon.wgsl`.
//!
//! wgpu draws lines one pixel wide. A stage that imports the shared part draws each line as a polygon around its projection: the line
//! is clipped at the near plane, has the same width in pixels along its length or thins with depth, and its ends are rounded by as
//! few triangles as the width needs ([`Rounding`]), so that consecutive lines join without gaps. A line has the depth of its
//! edge, so that what lies before the edge hides it.

use crate::frame_view::FrameView;
use crate::local_frame::LocalFrame;
use crate::width_over_depth::WidthOverDepth;
use bytemuck::{Pod, Zeroable};
use std::f64::consts::FRAC_PI_2;

/// Greatest distance between a rounded end and its arc, in pixels.
const ROUNDING_PX: f64 = 0.2;

/// Most sides around the end of a line.
const MAX_END_SIDES: u32 = 16;

/// How the lines of a draw are shaped; part of a stage's uniform.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
pub struct LineShape {
    /// Width and height of the viewport in pixels.
    pub viewport_px: [f32; 2],
    /// How far ink reaches beside the line, in pixels: the first at every depth, plus the second over clip-space w.
    pub reach: [f32; 2],
    /// Unit direction in the image towards a light (y up) times the share, 0 to 1, by which lines facing it are thinned; zero
    /// where no line is thinned.
    pub light: [f32; 2],
    /// Lines are clipped where their clip-space w is below this; above 0.
    pub near_w: f32,
    /// Added to depth-buffer values, which are clamped to 0 to 1.
    pub lift: f32,
    /// Sides around either end, 1 to 16.
    pub end_sides: u32,
    _pad: [u32; 3],
}

/// Shape of lines with the table of their rounded ends; what a stage's uniform holds (320 bytes, aligned to 16).
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
pub struct LinePolygon {
    /// The shape.
    pub shape: LineShape,
    /// Points around an end, in reaches from there: beside the line, beyond its end, two zeros.
    pub rim: [[f32; 4]; MAX_END_SIDES as usize + 1],
}

impl LinePolygon {
    /// Lines of a viewport of this many pixels, with ink as far beside them as `reach` says, clipped at `near_w`; neither thinned by
    /// light nor lifted.
    pub fn new(viewport_px: [f32; 2], reach: [f32; 2], near_w: f32, rounding: Rounding) -> Self {
        let mut polygon = Self {
            shape: LineShape { viewport_px, reach, light: [0.0; 2], near_w, lift: 0.0, end_sides: 1, _pad: [0; 3] },
            rim: [[0.0; 4]; MAX_END_SIDES as usize + 1],
        };
        polygon.round(rounding);
        polygon
    }

    /// Lines of `width` in a view of a mesh with this frame; ink reaches the share `reach` of the width beside them, to both sides
    /// where it `is_centred`, otherwise to the left alone. Ends are rounded for the width at the near plane.
    pub fn of_view(view: &FrameView, frame: &LocalFrame, width: &WidthOverDepth, reach: f64, is_centred: bool) -> Self {
        let law = view.depth_law();
        let near = law.range().near;
        let depth_per_w = frame.depth_per_w(view);
        let near_w = if view.is_perspective() { near / depth_per_w } else { 0.5 * law.w_at(0.0) };
        let reach_px = [width.constant_px, width.px_at_depth_1 / depth_per_w].map(|part| (reach * part) as f32);
        let viewport_px = view.viewport().size_px.map(|side| side as f32);
        let rounding = Rounding::new(reach * width.px_at(near.abs()), is_centred);
        Self::new(viewport_px, reach_px, near_w as f32, rounding)
    }

    /// Rounds the ends in this way.
    pub fn round(&mut self, rounding: Rounding) {
        self.shape.end_sides = rounding.end_sides;
        self.rim = rounding.rim();
    }

    /// Vertices that a stage draws per line, as a list of triangles.
    pub fn vertices_per_line(&self) -> u32 {
        6 * self.shape.end_sides
    }
}

/// How the end of a line is rounded: a polygon around an arc whose radius is how far the line reaches beside its edge.
///
/// The outer corners reach beyond the end, so that lines that turn a little meet without a gap; the sides go on from there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rounding {
    /// How far outer corners reach beyond the end of the line, over its reach beside it.
    corner: f64,
    /// Sides around the end, 1 to 16.
    end_sides: u32,
    /// Whether ink lies on both sides of the edge, so that the arc is half a turn; otherwise a quarter.
    is_centred: bool,
}

impl Rounding {
    /// No rounding: a centred line ends where its edge does.
    pub const BLUNT: Self = Self { corner: 0.0, end_sides: 1, is_centred: true };

    /// Arcs of radius `reach_px` with as few sides as keep the polygon within a fifth of a pixel of them, at most 16. One-sided
    /// lines (ink to their left) are rounded by a quarter of a turn, centred ones by half a turn.
    pub fn new(reach_px: f64, is_centred: bool) -> Self {
        let corner_rad = (reach_px / (reach_px + ROUNDING_PX)).acos();
        let corners = if is_centred { 2.0 } else { 1.0 };
        let sweep = corners * (FRAC_PI_2 - corner_rad);
        // The chord next to a corner begins as far outside of the arc as it may end inside.
        let sagitta = |count: u32| reach_px * (1.0 - (0.5 * sweep / f64::from(count)).cos());
        let end_sides = (1..MAX_END_SIDES).find(|&count| sagitta(count) <= 2.0 * ROUNDING_PX).unwrap_or(MAX_END_SIDES);
        Self { corner: corner_rad.tan(), end_sides, is_centred }
    }

    /// Points of the polygon, from the outer corner to straight ahead, or to the other corner: how far beside the edge and how
    /// far beyond its end, in reaches. Those after the last are zero.
    fn rim(&self) -> [[f32; 4]; MAX_END_SIDES as usize + 1] {
        let first = self.corner.atan();
        let sweep = if self.is_centred { 2.0 } else { 1.0 } * (FRAC_PI_2 - first);
        let mut rim = [[0.0; 4]; MAX_END_SIDES as usize + 1];
        for (step, point) in (0..=self.end_sides).zip(&mut rim) {
            let is_corner = step == 0 || (self.is_centred && step == self.end_sides);
            let radius = if is_corner { self.corner.hypot(1.0) } else { 1.0 };
            let (sine, cosine) = (first + sweep * f64::from(step) / f64::from(self.end_sides)).sin_cos();
            *point = [(radius * cosine) as f32, (radius * sine) as f32, 0.0, 0.0];
        }
        rim
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_shaders::layout;
    use std::mem::offset_of;

    #[test]
    fn wider_lines_take_more_triangles_and_reach_less() {
        let counts = [0.5, 2.0, 5.0, 20.0].map(|reach_px| Rounding::new(reach_px, false).end_sides);
        assert_eq!(counts, [1, 1, 2, 4]);
        assert!(Rounding::new(2.0, true).end_sides > 1 && Rounding::new(1e9, true).end_sides == 16);
        for reach_px in [0.5, 2.0, 20.0, 1000.0] {
            let Rounding { corner, .. } = Rounding::new(reach_px, false);
            let beyond = reach_px * corner.hypot(1.0) - reach_px;
            assert!((beyond - ROUNDING_PX).abs() < 1e-6, "{reach_px}: {beyond}");
        }
        assert!(Rounding::new(0.0, false).corner.is_finite());
    }

    #[test]
    fn rims_stay_near_their_arcs() {
        for (reach_px, is_centred) in [(0.5, false), (2.0, true), (7.0, false), (20.0, true), (60.0, false)] {
            let rounding = Rounding::new(reach_px, is_centred);
            let rim = &rounding.rim()[..=rounding.end_sides as usize];
            let points = || rim.iter().map(|p| glam::DVec2::new(f64::from(p[0]), f64::from(p[1])) * reach_px);
            for (a, b) in points().zip(points().skip(1)) {
                for point in [a, a.lerp(b, 0.5), b] {
                    assert!((point.length() - reach_px).abs() <= 2.0 * ROUNDING_PX, "{reach_px}: {point}");
                }
            }
            let last = points().next_back().unwrap();
            let ahead = if is_centred { -points().next().unwrap().x } else { 0.0 };
            assert!((last.x - ahead).abs() < 1e-4, "{reach_px}: {last}");
        }
    }

    #[test]
    fn the_structs_are_laid_out_as_their_wgsl_twins() {
        let stage = silhouette_shaders::image_precision::SCREEN;
        let shape = [
            ("viewport_px", offset_of!(LineShape, viewport_px)),
            ("reach", offset_of!(LineShape, reach)),
            ("light", offset_of!(LineShape, light)),
            ("near_w", offset_of!(LineShape, near_w)),
            ("lift", offset_of!(LineShape, lift)),
            ("end_sides", offset_of!(LineShape, end_sides)),
        ];
        assert!(layout::matches(stage, "LineShape", size_of::<LineShape>(), &shape));
        let polygon = [("shape", offset_of!(LinePolygon, shape)), ("rim", offset_of!(LinePolygon, rim))];
        assert!(layout::matches(stage, "LinePolygon", size_of::<LinePolygon>(), &polygon));
    }
}
