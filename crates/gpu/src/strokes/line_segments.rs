//! Projects polylines, clips them before the division, drops sub-pixel steps, and makes one quad of each segment.
//!
//! All of it in 64 bits and on the CPU: lines change with every view, and what is uploaded are pixels.
//! Twin of `shaders/gpu/line_segments.wgsl` as to the instance.

use super::line_joins::JoinInstance;
use super::polylines::Polylines;
use super::style::Cap;
use crate::frame_view::FrameView;
use bytemuck::{Pod, Zeroable};
use glam::{DMat4, DVec2, DVec3, DVec4};
use silhouette_core::view::DepthDirection;

/// A segment of a line in a viewport: pixel coordinates and depth-buffer values of its ends, both affine in between.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ScreenSegment {
    /// First end: x, y (down) in pixels, depth-buffer value.
    pub a: DVec3,
    /// Second end.
    pub b: DVec3,
}

impl ScreenSegment {
    /// The pixel position at `t`, 0 at the first end, 1 at the second.
    pub fn at(&self, t: f64) -> DVec2 {
        self.a.lerp(self.b, t).truncate()
    }

    /// Length in pixels.
    pub fn length_px(&self) -> f64 {
        self.a.truncate().distance(self.b.truncate())
    }
}

/// The quad of one segment. Twin of the struct in `shaders/gpu/line_segments.wgsl`.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
pub(crate) struct SegmentInstance {
    pub a: [f32; 3],
    pub b: [f32; 3],
    /// Bit 0: round cap at `a`, bit 1: at `b`.
    pub caps: u32,
}

impl SegmentInstance {
    pub const LAYOUT: wgpu::VertexBufferLayout<'static> = wgpu::VertexBufferLayout {
        array_stride: size_of::<Self>() as u64,
        step_mode: wgpu::VertexStepMode::Instance,
        attributes: &wgpu::vertex_attr_array![0 => Float32x3, 1 => Float32x3, 2 => Uint32],
    };
}

/// A mesh's own space to pixels of the viewport, with clipping.
#[derive(Debug, Clone, Copy)]
pub struct Projector {
    to_clip: DMat4,
    viewport_px: DVec2,
    direction: DepthDirection,
    /// How far beyond the viewport's sides lines are kept, as a share of half the viewport.
    guard: DVec2,
}

impl Projector {
    /// For strokes that reach `reach_px` pixels away from their lines.
    pub fn new(view: &FrameView, reach_px: f64) -> Self {
        let viewport_px = DVec2::from_array(view.viewport().size_px.map(f64::from));
        // Two pixels more, so that a cut end is never seen.
        let guard = DVec2::ONE + 2.0 * (reach_px + 2.0) / viewport_px;
        Self { to_clip: view.object_to_clip(), viewport_px, direction: view.depth_direction(), guard }
    }

    fn to_clip(self, object: DVec3) -> DVec4 {
        self.to_clip * object.extend(1.0)
    }

    /// The part of the segment in front of the near plane and around the viewport, with the share of the segment at
    /// which it begins and ends; `None` where there is none. Clipping before the division keeps a line that passes
    /// the eye from being stretched across the picture.
    fn clip(self, a: DVec4, b: DVec4) -> Option<(ScreenSegment, f64, f64)> {
        let planes = |p: DVec4| {
            let near = match self.direction {
                DepthDirection::Standard => p.z,
                DepthDirection::Reversed => p.w - p.z,
            };
            let [x, y] = [self.guard.x * p.w, self.guard.y * p.w];
            [near, x - p.x, x + p.x, y - p.y, y + p.y]
        };
        let (mut begin, mut end) = (0.0_f64, 1.0_f64);
        for (at_a, at_b) in planes(a).into_iter().zip(planes(b)) {
            if !(at_a.is_finite() && at_b.is_finite()) || (at_a < 0.0 && at_b < 0.0) {
                return None;
            }
            if at_a < 0.0 {
                begin = begin.max(at_a / (at_a - at_b));
            } else if at_b < 0.0 {
                end = end.min(at_a / (at_a - at_b));
            }
        }
        if begin > end {
            return None;
        }
        let at = |t: f64| {
            if t <= 0.0 {
                a
            } else if t >= 1.0 {
                b
            } else {
                a.lerp(b, t)
            }
        };
        let segment = ScreenSegment { a: self.to_pixel(at(begin))?, b: self.to_pixel(at(end))? };
        Some((segment, begin, end))
    }

    fn to_pixel(self, clip: DVec4) -> Option<DVec3> {
        let ndc = clip.truncate() / clip.w;
        let pixel = DVec2::new(ndc.x + 1.0, 1.0 - ndc.y) * 0.5 * self.viewport_px;
        (clip.w > 0.0 && ndc.is_finite()).then(|| pixel.extend(ndc.z))
    }

    /// The part of a segment that lies in front of the near plane and around the viewport; `None` where there is none.
    pub fn project(self, a: DVec3, b: DVec3) -> Option<ScreenSegment> {
        self.clip(self.to_clip(a), self.to_clip(b)).map(|(segment, ..)| segment)
    }
}

/// Steps shorter than this many pixels are merged with the next: their direction is noise, and a join
/// would follow it. A thirtieth of a pixel cannot be seen.
const MERGE_PX: f64 = 1.0 / 32.0;

/// What is drawn of some polylines, with the memory to make it. Steady views allocate nothing.
#[derive(Debug, Default)]
pub(crate) struct Strokes {
    pub segments: Vec<SegmentInstance>,
    pub joins: Vec<JoinInstance>,
    clip_points: Vec<DVec4>,
    run: Vec<DVec3>,
}

impl Strokes {
    /// Replaces the strokes by those of `lines`. O(points).
    pub fn build(&mut self, lines: &Polylines, projector: Projector, cap: Cap) {
        self.segments.clear();
        self.joins.clear();
        for (points, closed) in lines.iter() {
            self.add(points, closed, projector, cap);
        }
    }

    fn add(&mut self, points: &[DVec3], closed: bool, projector: Projector, cap: Cap) {
        let count = points.len();
        if count < 2 {
            return;
        }
        self.clip_points.clear();
        self.clip_points.extend(points.iter().map(|&point| projector.to_clip(point)));
        let steps = if closed { count } else { count - 1 };
        let ends = |step: usize, clip: &[DVec4]| (clip[step % count], clip[(step + 1) % count]);
        let begins_outside = |step: usize, clip: &[DVec4]| {
            let (a, b) = ends(step, clip);
            projector.clip(a, b).is_none_or(|(_, begin, _)| begin > 0.0)
        };

        // Start a closed line where it comes back into view, if it leaves it, so that no run is cut at the first point.
        let gap = if closed { (0..steps).find(|&step| begins_outside(step, &self.clip_points)) } else { None };
        let first = gap.unwrap_or(0);
        let is_ring = closed && gap.is_none();

        self.run.clear();
        let mut starts_at_end = !closed;
        for step in first..first + steps {
            let (a, b) = ends(step, &self.clip_points);
            let Some((segment, begin, end)) = projector.clip(a, b) else {
                self.flush(false, starts_at_end, false, cap);
                continue;
            };
            if begin > 0.0 && !self.run.is_empty() {
                self.flush(false, starts_at_end, false, cap);
            }
            if self.run.is_empty() {
                starts_at_end = !closed && step == 0 && begin <= 0.0;
                self.run.push(segment.a);
            }
            append(&mut self.run, segment.b);
            if end < 1.0 {
                self.flush(false, starts_at_end, false, cap);
            }
        }
        let reaches_end = !closed && !self.run.is_empty();
        self.flush(is_ring, starts_at_end, reaches_end, cap);
    }

    /// Makes strokes of the run and empties it.
    fn flush(&mut self, is_ring: bool, starts_at_end: bool, reaches_end: bool, cap: Cap) {
        if is_ring && self.run.len() > 2 {
            // The last point repeats the first one; sub-pixel merging may have moved it.
            self.run.pop();
        }
        let run = &self.run;
        let count = run.len();
        let is_ring = is_ring && count > 2;
        let steps = if is_ring { count } else { count.saturating_sub(1) };
        let point = |i: usize| run[i % count].as_vec3().to_array();
        for step in 0..steps {
            let round = |ends: bool, bit: u32| if ends && cap == Cap::Round { bit } else { 0 };
            let caps = round(starts_at_end && step == 0, 1) | round(reaches_end && step + 1 == steps, 2);
            self.segments.push(SegmentInstance { a: point(step), b: point(step + 1), caps });
        }
        let corners = if is_ring { 0..count } else { 0..count.saturating_sub(2) };
        self.joins.extend(corners.filter_map(|i| {
            let [before, corner, after] = [i, i + 1, i + 2].map(|k| run[k % count]);
            JoinInstance::new(before, corner, after)
        }));
        self.run.clear();
    }
}

/// Appends a point, replacing the one before where both would be less than [`MERGE_PX`] apart and another precedes it.
fn append(run: &mut Vec<DVec3>, point: DVec3) {
    let near = |p: &DVec3| p.truncate().distance_squared(point.truncate()) < MERGE_PX * MERGE_PX;
    if run.last().is_some_and(near) {
        if run.len() > 1 {
            run.pop();
        } else {
            return;
        }
    }
    run.push(point);
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;
    use silhouette_core::view::{Camera, ClipRange, Projection};

    fn projector(direction: DepthDirection) -> (Camera, Projector) {
        let projection = Projection::Perspective { fov_y_rad: 1.0 };
        let camera = Camera::new(Vec3::new(0.0, 0.0, 5.0), Vec3::ZERO, Vec3::Y, projection, [200, 100]).unwrap();
        let view = FrameView::from_camera(&camera, ClipRange { near: 2.5, far: 7.5 }, direction).unwrap();
        (camera, Projector::new(&view, 4.0))
    }

    fn strokes(lines: &[(&[DVec3], bool)], cap: Cap) -> Strokes {
        let mut polylines = Polylines::new();
        for &(points, closed) in lines {
            polylines.push(points.iter().copied(), closed);
        }
        let mut strokes = Strokes::default();
        strokes.build(&polylines, projector(DepthDirection::Reversed).1, cap);
        strokes
    }

    #[test]
    fn points_land_where_the_camera_projects_them() {
        for direction in [DepthDirection::Standard, DepthDirection::Reversed] {
            let (camera, projector) = projector(direction);
            let (a, b) = (DVec3::new(-0.5, 0.2, 0.0), DVec3::new(0.7, -0.3, 1.0));
            let segment = projector.project(a, b).unwrap();
            assert!((segment.a.truncate() - camera.project(a).unwrap().pixel).length() < 1e-9);
            assert!((segment.b.truncate() - camera.project(b).unwrap().pixel).length() < 1e-9);
        }
    }

    #[test]
    fn a_line_past_the_eye_is_cut_and_one_behind_it_vanishes() {
        for direction in [DepthDirection::Standard, DepthDirection::Reversed] {
            let (_, projector) = projector(direction);
            let cut = projector.project(DVec3::ZERO, DVec3::new(0.0, 1.0, 50.0)).unwrap();
            assert!(cut.a.truncate().distance(DVec2::new(100.0, 50.0)) < 1e-9);
            assert!(cut.length_px() < 70.0, "cut at the guard band: {cut:?}");
            assert_eq!(projector.project(DVec3::new(0.0, 0.0, 6.0), DVec3::new(0.0, 1.0, 50.0)), None);
            assert_eq!(projector.project(DVec3::splat(f64::NAN), DVec3::ZERO), None);
        }
    }

    #[test]
    fn caps_sit_at_true_ends_only() {
        let bent = [DVec3::new(-1.0, 0.0, 0.0), DVec3::ZERO, DVec3::new(0.0, 1.0, 0.0)];
        let open = strokes(&[(&bent, false)], Cap::Round);
        assert_eq!(open.segments.iter().map(|s| s.caps).collect::<Vec<_>>(), [1, 2]);
        assert_eq!(open.joins.len(), 1);
        let ring = strokes(&[(&bent, true)], Cap::Round);
        assert_eq!((ring.segments.len(), ring.joins.len()), (3, 3));
        assert!(ring.segments.iter().all(|s| s.caps == 0));
        // The second end is behind the eye.
        let cut = strokes(&[(&[DVec3::ZERO, DVec3::new(0.0, 0.1, 50.0)], false)], Cap::Round);
        assert_eq!(cut.segments.iter().map(|s| s.caps).collect::<Vec<_>>(), [1]);
        assert_eq!(strokes(&[(&bent, false)], Cap::Butt).segments[0].caps, 0);
    }

    #[test]
    fn a_ring_with_a_gap_keeps_its_join_at_the_first_point() {
        let behind = DVec3::new(0.0, 0.5, 50.0);
        let ring = [DVec3::Y * 0.5, DVec3::X, behind, DVec3::NEG_X];
        let strokes = strokes(&[(&ring, true)], Cap::Round);
        // From behind to -X, to the first point, to X, and back behind: three corners in sight.
        assert_eq!((strokes.segments.len(), strokes.joins.len()), (4, 3));
    }

    #[test]
    fn sub_pixel_steps_are_merged_and_empty_lines_ignored() {
        let tiny: Vec<_> = (0..=1000).map(|i| DVec3::X * 1e-6 * f64::from(i)).collect();
        assert!(strokes(&[(&tiny, false)], Cap::Butt).segments.len() < 4);
        let none = strokes(&[(&[], false), (&[DVec3::ZERO], true), (&[DVec3::ZERO; 5], true)], Cap::Round);
        assert!(none.segments.is_empty() && none.joins.is_empty());
    }
}
