//! Silhouettes as smooth curves: cubic Bezier pieces in object space, joined to open or closed chains.
//!
//! A piece ends exactly where the next of its chain begins. A straight piece is a cubic too, so that everything that draws,
//! measures or flattens curves has one case. Control points are 32-bit, as positions of a mesh are; evaluation is in 64 bits.
//!
//! For output as polylines, see [`CurveChain::flatten`]; as curves in a picture, [`SmoothPiece::picture`].

mod picture;

use crate::id::{EdgeId, FaceId};
use glam::{DVec3, Vec3};
use std::ops::Range;

/// Why a curve is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum CurveKind {
    /// Front faces meet back faces there.
    Silhouette,
    /// The surface ends there.
    Boundary,
    /// The surface bends sharply there, whatever the view.
    Crease,
}

impl CurveKind {
    /// The name used on command lines and in files.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Silhouette => "silhouette",
            Self::Boundary => "boundary",
            Self::Crease => "crease",
        }
    }
}

/// What a piece of curve stands for in the mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum CurveSource {
    /// A mesh edge, which the piece replaces.
    Edge(EdgeId),
    /// A face, which the piece runs through.
    Face(FaceId),
}

/// A cubic Bezier curve in object space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SmoothPiece {
    /// Control points: the first and the last are the ends.
    pub control: [Vec3; 4],
    /// Why it is drawn.
    pub kind: CurveKind,
    /// What it stands for.
    pub source: CurveSource,
}

/// Most segments that a piece is flattened into, whatever the tolerance.
pub const MAX_SEGMENTS: u32 = 1 << 12;

impl SmoothPiece {
    /// The straight piece between two points, with a constant derivative.
    pub fn line(from: Vec3, to: Vec3, kind: CurveKind, source: CurveSource) -> Self {
        Self { control: [from, from.lerp(to, 1.0 / 3.0), from.lerp(to, 2.0 / 3.0), to], kind, source }
    }

    /// The point at a parameter from 0 at the first end to 1 at the last.
    pub fn point(&self, t: f64) -> DVec3 {
        let [a, b, c, d] = self.control.map(Vec3::as_dvec3);
        let (ab, bc, cd) = (a.lerp(b, t), b.lerp(c, t), c.lerp(d, t));
        ab.lerp(bc, t).lerp(bc.lerp(cd, t), t)
    }

    /// The first derivative by the parameter.
    pub fn derivative(&self, t: f64) -> DVec3 {
        let [ab, bc, cd] = self.differences();
        3.0 * ab.lerp(bc, t).lerp(bc.lerp(cd, t), t)
    }

    /// The unit direction of travel. Where the derivative vanishes, as at an end whose handle coincides with it, this is
    /// the direction in which the curve leaves the point, or reaches it at `t = 1`. `None` if all control points coincide.
    pub fn tangent(&self, t: f64) -> Option<DVec3> {
        let [ab, bc, cd] = self.differences();
        let second = (bc - ab).lerp(cd - bc, t);
        let third = cd - 2.0 * bc + ab;
        let leaving = if t < 1.0 { second } else { -second };
        [self.derivative(t), leaving, third].into_iter().find_map(DVec3::try_normalize)
    }

    fn differences(&self) -> [DVec3; 3] {
        let [a, b, c, d] = self.control.map(Vec3::as_dvec3);
        [b - a, c - b, d - c]
    }

    /// How many segments at equal steps of the parameter keep within `tolerance` of the curve, in units of object space: 1
    /// to [`MAX_SEGMENTS`], the most also where `tolerance` is not above 0.
    ///
    /// A chord over a step h strays by at most h² / 8 times the largest second derivative, which for a cubic is at most six
    /// times the larger second difference of its control points.
    pub fn segments_within(&self, tolerance: f64) -> u32 {
        let [ab, bc, cd] = self.differences();
        let bend = (bc - ab).length().max((cd - bc).length());
        let segments = (6.0 * bend / (8.0 * tolerance)).sqrt().ceil();
        if tolerance > 0.0 && segments <= f64::from(MAX_SEGMENTS) { (segments as u32).max(1) } else { MAX_SEGMENTS }
    }
}

/// Smooth pieces, chain after chain. Reused from view to view without allocation once it has grown.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SilhouetteCurves {
    pieces: Vec<SmoothPiece>,
    chains: Vec<ChainEnd>,
}

/// Where a chain ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct ChainEnd {
    /// Number of pieces up to its end.
    pieces: usize,
    closed: bool,
}

/// Connected pieces, each beginning where the one before it ends: borrowed from [`SilhouetteCurves`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CurveChain<'a> {
    /// The pieces, at least one.
    pub pieces: &'a [SmoothPiece],
    /// Whether the last piece ends where the first begins, and the chain continues there.
    pub closed: bool,
}

impl SilhouetteCurves {
    /// Removes all pieces; keeps the memory.
    pub fn clear(&mut self) {
        self.pieces.clear();
        self.chains.clear();
    }

    /// Appends a piece to the chain that is being formed.
    pub fn push(&mut self, piece: SmoothPiece) {
        self.pieces.push(piece);
    }

    /// Ends the chain that is being formed.
    ///
    /// # Panics
    /// In builds with debug assertions: if the chain has no piece, a piece does not begin where the one before it ends, or
    /// a closed chain does not end where it begins.
    pub fn end_chain(&mut self, closed: bool) {
        let begin = self.chains.last().map_or(0, |chain| chain.pieces);
        let chain = &self.pieces[begin..];
        debug_assert!(!chain.is_empty(), "a chain has a piece");
        let after_first = chain.iter().skip(1).chain(chain.first().filter(|_| closed));
        debug_assert!(
            chain.iter().zip(after_first).all(|(piece, next)| piece.control[3] == next.control[0]),
            "a piece begins where the one before it ends"
        );
        self.chains.push(ChainEnd { pieces: self.pieces.len(), closed });
    }

    /// Number of chains.
    pub fn len(&self) -> usize {
        self.chains.len()
    }

    /// Whether there is no chain.
    pub fn is_empty(&self) -> bool {
        self.chains.is_empty()
    }

    /// The chains, in the order in which they were formed.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = CurveChain<'_>> {
        self.chains
            .iter()
            .enumerate()
            .map(|(index, chain)| CurveChain { pieces: &self.pieces[self.range(index)], closed: chain.closed })
    }

    /// One chain.
    ///
    /// # Panics
    /// If there is no such chain.
    pub fn get(&self, index: usize) -> CurveChain<'_> {
        CurveChain { pieces: &self.pieces[self.range(index)], closed: self.chains[index].closed }
    }

    fn range(&self, index: usize) -> Range<usize> {
        let begin = if index == 0 { 0 } else { self.chains[index - 1].pieces };
        begin..self.chains[index].pieces
    }

    /// All pieces, chain after chain.
    pub fn pieces(&self) -> &[SmoothPiece] {
        &self.pieces
    }

    /// Bytes held.
    pub fn bytes(&self) -> usize {
        size_of_val(self.pieces.as_slice()) + size_of_val(self.chains.as_slice())
    }
}

impl CurveChain<'_> {
    /// Appends the points of a polyline that keeps within `tolerance` of the chain, in units of object space: the ends of
    /// every piece, and points at equal steps of the parameter between them. Of a closed chain the first point is not
    /// repeated at the end. The curve is also within `tolerance` of the polyline.
    ///
    /// Each piece takes [`segments_within`](SmoothPiece::segments_within) segments, so the bound does not hold where a piece
    /// would need more than [`MAX_SEGMENTS`]. O(points).
    pub fn flatten(&self, tolerance: f64, out: &mut Vec<DVec3>) {
        for piece in self.pieces {
            let segments = piece.segments_within(tolerance);
            let steps = (0..segments).map(|step| f64::from(step) / f64::from(segments));
            out.extend(steps.map(|t| piece.point(t)));
        }
        if let (false, Some(last)) = (self.closed, self.pieces.last()) {
            out.push(last.control[3].as_dvec3());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Length of the handles of a quarter of the unit circle, such that the middle of the curve is on the circle.
    const KAPPA: f32 = 0.552_284_8;

    /// A quarter of the unit circle in the plane z = 0, after this many quarters.
    fn quarter(turns: i32) -> SmoothPiece {
        let turned = |x: f32, y: f32| match turns.rem_euclid(4) {
            0 => Vec3::new(x, y, 0.0),
            1 => Vec3::new(-y, x, 0.0),
            2 => Vec3::new(-x, -y, 0.0),
            _ => Vec3::new(y, -x, 0.0),
        };
        piece([turned(1.0, 0.0), turned(1.0, KAPPA), turned(KAPPA, 1.0), turned(0.0, 1.0)])
    }

    fn piece(control: [Vec3; 4]) -> SmoothPiece {
        SmoothPiece { control, kind: CurveKind::Silhouette, source: CurveSource::Face(FaceId::new(0)) }
    }

    fn circle() -> SilhouetteCurves {
        let mut curves = SilhouetteCurves::default();
        (0..4).for_each(|turns| curves.push(quarter(turns)));
        curves.end_chain(true);
        curves
    }

    fn distance_to_segment(point: DVec3, [a, b]: [DVec3; 2]) -> f64 {
        let along = (b - a).length_squared();
        let share = if along > 0.0 { ((point - a).dot(b - a) / along).clamp(0.0, 1.0) } else { 0.0 };
        point.distance(a.lerp(b, share))
    }

    /// Largest distance of the points of an open chain from its polyline.
    fn flattening_error(chain: CurveChain<'_>, polyline: &[DVec3]) -> f64 {
        let to_polyline = |point: DVec3| {
            let distances = polyline.windows(2).map(|pair| distance_to_segment(point, [pair[0], pair[1]]));
            distances.fold(f64::INFINITY, f64::min)
        };
        let points = chain.pieces.iter().flat_map(|piece| (0..=500).map(|step| piece.point(f64::from(step) / 500.0)));
        points.map(to_polyline).fold(0.0, f64::max)
    }

    #[test]
    fn a_quarter_circle_is_off_by_the_known_share_of_its_radius() {
        let radii = (0..=1000).map(|step| quarter(0).point(f64::from(step) / 1000.0).length() - 1.0);
        let (low, high) = radii.fold((0.0_f64, 0.0_f64), |(low, high), off| (low.min(off), high.max(off)));
        assert!(low > -1e-7 && (2.7e-4..2.74e-4).contains(&high), "{low} to {high}");
    }

    #[test]
    fn tangents_of_a_circle_are_perpendicular_to_its_radii() {
        for step in 0..=100 {
            let t = f64::from(step) / 100.0;
            let (point, tangent) = (quarter(1).point(t), quarter(1).tangent(t).unwrap());
            assert!((tangent.length() - 1.0).abs() < 1e-12 && tangent.dot(point).abs() < 2e-3, "{t}");
            assert!(point.cross(tangent).z > 0.99, "counter-clockwise");
        }
    }

    #[test]
    fn derivatives_are_limits_of_differences() {
        let piece = piece([Vec3::ZERO, Vec3::new(1.0, 3.0, -1.0), Vec3::new(4.0, -2.0, 0.5), Vec3::new(2.0, 2.0, 2.0)]);
        for t in [0.0, 0.3, 0.7, 1.0] {
            let difference = (piece.point(t + 1e-6) - piece.point(t - 1e-6)) / 2e-6;
            assert!((difference - piece.derivative(t)).length() < 1e-6, "{t}");
        }
    }

    #[test]
    fn a_straight_piece_is_one_segment_of_constant_speed() {
        let (from, to) = (Vec3::new(1.0, 2.0, 3.0), Vec3::new(4.0, -4.0, 0.0));
        let line = SmoothPiece::line(from, to, CurveKind::Crease, CurveSource::Edge(EdgeId::new(7)));
        for t in [0.0, 0.25, 0.5, 1.0] {
            assert!(line.point(t).distance(from.as_dvec3().lerp(to.as_dvec3(), t)) < 1e-6);
            assert!(line.derivative(t).distance((to - from).as_dvec3()) < 1e-5);
        }
        assert_eq!(line.segments_within(1e-5), 1);
        let [start, end] = [0.0, 1.0].map(|t| line.tangent(t).unwrap());
        assert!(start.distance(end) < 1e-6);
    }

    #[test]
    fn tangents_survive_handles_that_coincide_with_ends() {
        let (a, b, d) = (Vec3::ZERO, Vec3::X, Vec3::ONE);
        let begins_at_rest = piece([a, a, b, d]);
        assert!(begins_at_rest.tangent(0.0).unwrap().distance(DVec3::X) < 1e-12);
        let ends_at_rest = piece([a, b, d, d]);
        assert!(ends_at_rest.tangent(1.0).unwrap().distance(DVec3::new(0.0, 1.0, 1.0).normalize()) < 1e-12);
        for t in [0.0, 1.0] {
            assert!(piece([a, a, d, d]).tangent(t).unwrap().distance(DVec3::ONE.normalize()) < 1e-12, "{t}");
            assert!(piece([a, a, a, d]).tangent(t).unwrap().distance(DVec3::ONE.normalize()) < 1e-12, "{t}");
            assert_eq!(piece([d; 4]).tangent(t), None);
        }
    }

    #[test]
    fn a_closed_chain_is_flattened_to_a_polygon_without_a_repeated_point() {
        let curves = circle();
        let mut polygon = Vec::new();
        curves.get(0).flatten(1e-4, &mut polygon);
        let area = |points: &[DVec3]| {
            let next = points.iter().cycle().skip(1);
            points.iter().zip(next).map(|(a, b)| 0.5 * (a.x * b.y - a.y * b.x)).sum::<f64>()
        };
        // The area of the circle, the curve's known excess and the tolerance along the whole length.
        assert!((area(&polygon) - std::f64::consts::PI).abs() < 2.0 * std::f64::consts::PI * 3e-4);
        assert!(polygon.iter().zip(polygon.iter().skip(1)).all(|(a, b)| a.distance(*b) > 1e-3));
        assert!(polygon[0].distance(polygon[polygon.len() - 1]) > 1e-3);
    }

    #[test]
    fn a_finer_tolerance_takes_more_segments_by_its_square_root() {
        let [coarse, fine] = [1e-3, 1e-5].map(|tolerance| f64::from(quarter(0).segments_within(tolerance)));
        assert!((9.0..11.0).contains(&(fine / coarse)), "{coarse} and {fine}");
        assert_eq!(
            [0.0, -1.0, f64::NAN, 1e-30].map(|tolerance| quarter(0).segments_within(tolerance)),
            [MAX_SEGMENTS; 4]
        );
    }

    #[test]
    fn chains_keep_their_pieces_and_refilling_allocates_nothing() {
        let mut curves = circle();
        let fill = |curves: &mut SilhouetteCurves| {
            curves.clear();
            curves.push(quarter(2));
            curves.end_chain(false);
            curves.push(quarter(0));
            curves.push(quarter(1));
            curves.end_chain(false);
        };
        fill(&mut curves);
        assert_eq!(allocation_counter::measure(|| fill(&mut curves)).count_total, 0);
        let lengths: Vec<_> = curves.iter().map(|chain| (chain.pieces.len(), chain.closed)).collect();
        assert_eq!((lengths, curves.len(), curves.pieces().len()), (vec![(1, false), (2, false)], 2, 3));
        assert_eq!(curves.get(1).pieces[0], quarter(0));
        assert!(circle().get(0).closed && !circle().is_empty());
    }

    #[test]
    #[cfg(debug_assertions)]
    #[should_panic(expected = "begins where")]
    fn pieces_that_do_not_meet_make_no_chain() {
        let mut curves = SilhouetteCurves::default();
        curves.push(quarter(0));
        curves.push(quarter(2));
        curves.end_chain(false);
    }

    proptest! {
        #[test]
        fn polylines_keep_within_their_tolerance(
            control in prop::array::uniform4(prop::array::uniform3(-1.0..1.0_f32)),
            tolerance in 1e-4..0.1_f64,
        ) {
            let mut curves = SilhouetteCurves::default();
            curves.push(piece(control.map(Vec3::from)));
            curves.end_chain(false);
            let mut polyline = Vec::new();
            curves.get(0).flatten(tolerance, &mut polyline);
            let error = flattening_error(curves.get(0), &polyline);
            prop_assert!(error <= tolerance, "{error}");
            prop_assert_eq!(polyline.len() as u32, curves.pieces()[0].segments_within(tolerance) + 1);
        }
    }
}
