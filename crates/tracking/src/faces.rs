//! The faces of one view: facing on demand, each evaluated at most once.

use crate::complete_silhouette::Asked;
use crate::connectivity_table::{ConnectivityTable, Side};
use crate::plane_test::PlaneTest;
use silhouette_core::facing::Facing;
use silhouette_core::glam::Vec3;
use silhouette_core::method::ExtractionStats;
use silhouette_core::{FaceId, FacingMemo, HalfEdgeId, Viewpoint};

/// What a frame sees of the mesh.
#[derive(Clone, Copy)]
pub(crate) struct Surface<'a> {
    pub positions: &'a [Vec3],
    pub triangles: &'a [[u32; 3]],
    pub table: &'a ConnectivityTable,
}

impl Surface<'_> {
    pub fn corners(&self, face: FaceId) -> [Vec3; 3] {
        self.triangles[face.index()].map(|vertex| self.positions[vertex as usize])
    }
}

/// Facings of one view of a surface, and what finding them took.
pub(crate) struct Faces<'a> {
    pub surface: Surface<'a>,
    test: PlaneTest,
    memo: &'a mut FacingMemo,
    pub stats: ExtractionStats,
}

impl<'a> Faces<'a> {
    /// Nothing is known of the view yet.
    pub fn new(surface: Surface<'a>, viewpoint: &Viewpoint, memo: &'a mut FacingMemo) -> Self {
        memo.begin_view(surface.triangles.len());
        Self { surface, test: surface.table.test(viewpoint), memo, stats: ExtractionStats::default() }
    }

    /// Whether a face is front.
    #[inline]
    pub fn is_front(&mut self, face: FaceId) -> bool {
        let Self { surface, test, memo, stats } = self;
        memo.is_front_by(face, |face| test.judge(surface.table.plane(face), || surface.corners(face)), stats)
    }

    /// Whether a face is front that was asked for before.
    #[inline]
    pub fn recall(&self, face: FaceId) -> bool {
        self.memo.recall(face)
    }

    /// Evaluates faces of which nothing is known yet, each named once, by their planes: without the question whether it
    /// is known, whose answer no branch predictor could guess.
    pub fn evaluate(&mut self, planes: impl ExactSizeIterator<Item = (FaceId, [f32; 4])>) {
        let Self { surface, test, memo, stats } = self;
        let (surface, test) = (*surface, *test);
        stats.faces_tested += planes.len() as u64;
        for (face, plane) in planes {
            let judgement = test.judge(plane, || surface.corners(face));
            stats.exact_fallbacks += u64::from(judgement.exact_fallback);
            memo.record(face, judgement.facing == Facing::Front);
        }
    }

    /// Evaluates the faces of a trail, each at most once, and lists the places in it at which the answer is new. As
    /// [`evaluate`](Self::evaluate), without questions that no branch predictor could answer: a face that is known, or
    /// is named again, is computed again, and counted once.
    pub fn compare(&mut self, trail: &[Asked], news: &mut Vec<u32>) {
        let (table, test) = (self.surface.table, self.test);
        let mut first_asked = 0;
        for (place, asked) in trail.iter().enumerate() {
            let face = asked.face();
            let is_front = match test.certified(table.plane(face)) {
                Some(is_front) => {
                    first_asked += u64::from(self.memo.record(face, is_front));
                    is_front
                }
                None => self.is_front(face),
            };
            if is_front != asked.was_front() {
                news.push(place as u32);
            }
        }
        self.stats.faces_tested += first_asked;
    }

    /// Length of half-edges in object space. O(their number).
    pub fn length_of(&self, half_edges: &[HalfEdgeId]) -> f64 {
        let length = |half_edge: &HalfEdgeId| {
            let corners = self.surface.corners(half_edge.face());
            let [a, b] = [half_edge, &half_edge.next_in_face()].map(|end| corners[end.slot() as usize]);
            a.as_dvec3().distance(b.as_dvec3())
        };
        half_edges.iter().map(length).sum()
    }

    /// The half-edge across, if there is a face across.
    #[inline]
    pub fn twin(&self, half_edge: HalfEdgeId) -> Option<HalfEdgeId> {
        self.surface.table.twin(half_edge)
    }

    /// The side across, if there is a face across.
    #[inline]
    pub fn across(&self, side: Side) -> Option<Side> {
        self.surface.table.across(side)
    }
}
