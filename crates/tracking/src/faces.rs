//! The faces of one view: facing on demand, each evaluated at most once.

use crate::asked::Asked;
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

    /// Evaluates `count` faces of which nothing is known yet, each named once, by their planes: four at a time, and
    /// without the question whether it is known, whose answer no branch predictor could guess.
    pub fn evaluate(&mut self, count: usize, face_and_plane: impl Fn(usize) -> (FaceId, [f32; 4])) {
        for begin in (0..count - count % 4).step_by(4) {
            // Spelled out: the optimiser calls closures that map arrays.
            let [(a, plane_a), (b, plane_b)] = [face_and_plane(begin), face_and_plane(begin + 1)];
            let [(c, plane_c), (d, plane_d)] = [face_and_plane(begin + 2), face_and_plane(begin + 3)];
            let faces = [a, b, c, d];
            match self.test.certified_four([plane_a, plane_b, plane_c, plane_d]) {
                Some(fronts) => {
                    // Nothing was known, so that nothing has to be read.
                    self.memo.record_four(faces, fronts);
                    self.stats.faces_tested += 4;
                }
                None => {
                    for face in faces {
                        self.is_front(face);
                    }
                }
            }
        }
        for index in count - count % 4..count {
            self.is_front(face_and_plane(index).0);
        }
    }

    /// Evaluates all faces, of which nothing is known yet, one after the other.
    pub fn evaluate_one_by_one(&mut self) {
        let (surface, test) = (self.surface, self.test);
        for face in (0..surface.triangles.len()).map(FaceId::from_usize) {
            let judgement = test.judge(surface.table.plane(face), || surface.corners(face));
            self.memo.record(face, judgement.facing == Facing::Front);
            self.stats.exact_fallbacks += u64::from(judgement.exact_fallback);
        }
        self.stats.faces_tested += surface.triangles.len() as u64;
    }

    /// Evaluates the faces of a trail, each at most once, and lists the places in it at which the answer is new,
    /// ascending. Four at a time, and without questions that no branch predictor could answer: a face that is known, or
    /// is named again, is computed again, and counted once.
    pub fn compare(&mut self, trail: &[Asked], news: &mut Vec<u32>) {
        let (table, test) = (self.surface.table, self.test);
        let (fours, rest) = trail.as_chunks::<4>();
        for (four, begin) in fours.iter().zip((0_u32..).step_by(4)) {
            let [a, b, c, d] = *four;
            let faces = [a.face(), b.face(), c.face(), d.face()];
            let [plane_a, plane_b] = [table.plane(faces[0]), table.plane(faces[1])];
            let [plane_c, plane_d] = [table.plane(faces[2]), table.plane(faces[3])];
            match test.certified_four([plane_a, plane_b, plane_c, plane_d]) {
                Some(fronts) => {
                    self.stats.faces_tested += self.memo.record_four(faces, fronts);
                    let were_front =
                        [a, b, c, d].iter().rev().fold(0, |bits, asked| bits << 1 | u32::from(asked.was_front()));
                    let mut changes = fronts ^ were_front;
                    while changes != 0 {
                        news.push(begin + changes.trailing_zeros());
                        changes &= changes - 1;
                    }
                }
                None => self.compare_one_by_one(four, begin, news),
            }
        }
        self.compare_one_by_one(rest, 4 * fours.len() as u32, news);
    }

    #[cold]
    fn compare_one_by_one(&mut self, trail: &[Asked], begin: u32, news: &mut Vec<u32>) {
        for (asked, place) in trail.iter().zip(begin..) {
            if self.is_front(asked.face()) != asked.was_front() {
                news.push(place);
            }
        }
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
