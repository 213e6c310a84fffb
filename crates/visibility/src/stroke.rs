//! [`Stroke`]: a straight edge to be drawn, whatever it comes from.

use crate::chains::SegmentSource;
use crate::curve_part::CurvePart;
use crate::kind::LineKind;
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::orientation::turn;
use silhouette_core::{FaceId, Viewpoint};
use std::ops::Range;
use std::sync::OnceLock;

/// No mesh vertex: an end of a stroke that is not a mesh edge.
pub const NO_VERTEX: u32 = u32::MAX;

/// A straight edge to be drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct Stroke {
    /// Its ends in object space.
    pub ends: [Vec3; 2],
    /// Mesh vertices at its ends, higher numbers for other places in which strokes meet, or [`NO_VERTEX`].
    pub vertices: [u32; 2],
    /// What it lies on.
    pub source: SegmentSource,
    /// Why it is drawn.
    pub kind: LineKind,
    /// The object it belongs to.
    pub object: u32,
    /// Faces that it lies on and that therefore do not hide it, in [`Strokes::faces`].
    pub own: Range<u32>,
    /// The apex of the wing that it belongs to, computed on first use. See [`Sight::surface`](crate::sight::Sight::surface).
    pub surface: OnceLock<Option<Vec3>>,
}

impl Stroke {
    /// The point at a parameter from 0 at the first end to 1 at the second.
    pub fn at(&self, t: f64) -> DVec3 {
        self.ends[0].as_dvec3().lerp(self.ends[1].as_dvec3(), t)
    }

    /// Whether the stroke's line passes through the viewer, so that all of it appears as a point. Exact. O(1).
    pub fn is_seen_end_on(&self, viewpoint: &Viewpoint) -> bool {
        let [a, b] = self.ends;
        let step = a.abs().max(b.abs()).max_element();
        // A plane through the line that holds one more point along each axis is no plane.
        [0, 1, 2].into_iter().all(|axis| {
            let mut beside = a;
            beside[axis] += if a[axis] > 0.0 { -step } else { step };
            turn(viewpoint, a, b, beside) == 0.0
        })
    }
}

/// Faces that a stroke lies on.
#[derive(Debug, Clone, Copy)]
pub struct OwnFaces<'a>(&'a [FaceId]);

impl OwnFaces<'_> {
    /// Whether a face is one of them. O(log faces), since an edge may have thousands.
    #[inline]
    pub fn contains(self, face: FaceId) -> bool {
        self.0.binary_search(&face).is_ok()
    }
}

/// The strokes of a view: mesh edges first, ascending, then intersections, then curves.
#[derive(Debug, Clone, Default)]
pub struct Strokes {
    /// The strokes.
    pub strokes: Vec<Stroke>,
    /// Faces that strokes lie on, ascending for each.
    faces: Vec<FaceId>,
    /// Parts of curves that the last strokes stand for, one each.
    pub curve_parts: Vec<CurvePart>,
}

impl Strokes {
    /// The faces that a stroke lies on.
    #[inline]
    pub fn own_faces(&self, stroke: &Stroke) -> OwnFaces<'_> {
        OwnFaces(&self.faces[stroke.own.start as usize..stroke.own.end as usize])
    }

    /// The part of a curve that a stroke stands for, by its index.
    pub fn curve_part(&self, stroke: usize) -> Option<CurvePart> {
        stroke.checked_sub(self.strokes.len() - self.curve_parts.len()).map(|index| self.curve_parts[index])
    }

    /// Appends a stroke along a curve. No other stroke may follow.
    pub fn push_curve(&mut self, stroke: Stroke, faces: impl IntoIterator<Item = FaceId>, part: CurvePart) {
        self.push(stroke, faces);
        self.curve_parts.push(part);
    }

    /// Appends a stroke on these faces.
    pub fn push(&mut self, mut stroke: Stroke, faces: impl IntoIterator<Item = FaceId>) {
        let begin = self.faces.len();
        self.faces.extend(faces);
        self.faces[begin..].sort_unstable();
        stroke.own = begin as u32..self.faces.len() as u32;
        self.strokes.push(stroke);
    }
}
