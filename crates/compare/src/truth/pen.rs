//! Visible lines drawn with a pen: the exact share of each pixel that the ink covers.
//!
//! 1. A line becomes convex pieces: a rectangle for each segment, a sector of a disc on the outer side of each turn and,
//!    for a pen that is centred on its line, half a disc at each end. What a centred pen covers is therefore all that lies
//!    within half its width of the line. A pen on one side covers the strip of its width on that side and ends with the line.
//! 2. In bands of rows, the pieces are united (`i_overlay`), so that overlapping ink counts once.
//! 3. The union's area in each pixel is [accumulated](super::coverage).
//!
//! Arcs are drawn as chords that stray by at most [`ARC_PX`], coordinates are rounded to at most 2^-14 px (2^-19 px in a
//! picture of 512 x 512). Bands are independent, so the result is the same bits for any number of threads.

use super::coverage::CoverageRows;
use super::visible::VisibleLine;
use crate::metrics::ink::Ink;
use glam::DVec2;
use i_overlay::core::fill_rule::FillRule;
use i_overlay::core::overlay::{Overlay, ShapeType};
use i_overlay::core::overlay_rule::OverlayRule;
use i_overlay::i_float::int::point::IntPoint;
use rayon::prelude::*;
use silhouette_gpu::{Pen, PenPlacement};
use std::f64::consts::PI;

/// Farthest that a chord strays from its arc, in pixels: it misses less than 1e-3 px² of a pen's round end.
pub const ARC_PX: f64 = 1e-4;

/// Rows that are drawn at a time: enough that few pieces reach into two bands, few enough that all threads have work.
const BAND_ROWS: u32 = 32;

/// Where a pen goes without being lifted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PenPath<'a> {
    /// Its points in pixels.
    pub points: &'a [DVec2],
    /// Whether the last point is joined to the first.
    pub closed: bool,
}

impl<'a> From<&'a VisibleLine> for PenPath<'a> {
    fn from(line: &'a VisibleLine) -> Self {
        Self { points: &line.points, closed: line.closed }
    }
}

impl PenPath<'_> {
    fn segments(&self) -> impl Iterator<Item = [DVec2; 2]> + '_ {
        let count = if self.closed { self.points.len() } else { self.points.len().saturating_sub(1) };
        (0..count).map(|at| [at, (at + 1) % self.points.len()].map(|at| self.points[at]))
    }
}

/// Draws paths in a picture of `size` pixels. No point may lie farther outside of it than the pen is wide and a pixel.
/// O(pixels + n log n) for n pieces.
pub fn draw<'a, P: Into<PenPath<'a>>>(paths: impl IntoIterator<Item = P>, pen: Pen, size: [u32; 2]) -> Ink {
    let [width, height] = size;
    let mut outline = PenOutline::new(pen, size);
    for path in paths {
        outline.add(&path.into());
    }
    let mut bands: Vec<Vec<u32>> = vec![Vec::new(); height.div_ceil(BAND_ROWS) as usize];
    for (piece, &[low, high]) in (0..).zip(&outline.rows) {
        let band = |y: f64| (y.max(0.0) as u32 / BAND_ROWS) as usize;
        if high >= 0.0 && band(low) < bands.len() {
            let last = band(high).min(bands.len() - 1);
            bands[band(low)..=last].iter_mut().for_each(|band| band.push(piece));
        }
    }
    let draw_band = |(band, pieces): (usize, Vec<u32>)| {
        let first_row = band as u32 * BAND_ROWS;
        let mut rows = CoverageRows::new(width, first_row, BAND_ROWS.min(height - first_row));
        outline.unite(&pieces, &mut rows);
        rows.into_shares()
    };
    let shares: Vec<Vec<f32>> = bands.into_par_iter().enumerate().map(draw_band).collect();
    let shares = shares.concat();
    Ink::from_fn(width, height, |x, y| shares[y as usize * width as usize + x as usize])
}

/// Convex pieces that together cover what a pen covers. Each runs clockwise as seen in the picture.
struct PenOutline {
    pen: Pen,
    /// Distances to the left of the line that are covered.
    span: [f64; 2],
    /// Steps per pixel: a power of two.
    scale: f64,
    points: Vec<IntPoint>,
    /// Where each piece ends in `points`.
    ends: Vec<u32>,
    /// Lowest and highest ordinate of each piece, in pixels.
    rows: Vec<[f64; 2]>,
}

impl PenOutline {
    fn new(pen: Pen, [width, height]: [u32; 2]) -> Self {
        // The solver takes coordinates below 2^30.
        let reach = f64::from(width.max(height)) + 2.0 * pen.width_px.max(0.0) + 2.0;
        let scale = 2.0_f64.powi(29 - reach.log2().ceil() as i32);
        Self { pen, span: pen.span_px(), scale, points: Vec::new(), ends: Vec::new(), rows: Vec::new() }
    }

    fn add(&mut self, path: &PenPath<'_>) {
        // Segments without direction have no side; their neighbours are joined.
        let segments: Vec<[DVec2; 2]> =
            path.segments().filter(|[from, to]| (to - from).try_normalize().is_some()).collect();
        let direction = |[from, to]: [DVec2; 2]| (to - from).normalize();
        for &segment in &segments {
            self.add_rectangle(segment, left_of(direction(segment)));
        }
        for pair in segments.windows(2) {
            self.add_turn(pair[1][0], direction(pair[0]), direction(pair[1]));
        }
        if let [first, .., last] | [first @ last] = segments[..] {
            let (first_direction, last_direction) = (direction(first), direction(last));
            if path.closed {
                self.add_turn(first[0], last_direction, first_direction);
            } else if self.pen.placement == PenPlacement::Centred {
                self.add_turn(first[0], -first_direction, first_direction);
                self.add_turn(last[1], last_direction, -last_direction);
            }
        }
    }

    fn add_rectangle(&mut self, [from, to]: [DVec2; 2], left: DVec2) {
        let [low, high] = self.span.map(|distance| left * distance);
        self.add_piece([from + high, to + high, to + low, from + low].into_iter());
    }

    /// The sector that the pen covers beyond both strokes at a turn.
    fn add_turn(&mut self, corner: DVec2, incoming: DVec2, outgoing: DVec2) {
        let angle = incoming.perp_dot(outgoing).atan2(incoming.dot(outgoing));
        // Turning clockwise leaves the gap on the left and the other way round.
        let (outward, radius) =
            if angle > 0.0 { (left_of(incoming), self.span[1]) } else { (-left_of(incoming), -self.span[0]) };
        if radius <= 0.0 || angle == 0.0 {
            return;
        }
        let chords = arc_chords(angle.abs(), radius);
        let arc = (0..=chords as u32)
            .map(move |step| corner + DVec2::from_angle(angle * f64::from(step) / chords).rotate(outward * radius));
        if angle > 0.0 {
            self.add_piece([corner].into_iter().chain(arc));
        } else {
            self.add_piece([corner].into_iter().chain(arc.rev()));
        }
    }

    fn add_piece(&mut self, points: impl Iterator<Item = DVec2>) {
        let mut rows = [f64::INFINITY, f64::NEG_INFINITY];
        for point in points {
            rows = [rows[0].min(point.y), rows[1].max(point.y)];
            let [x, y] = (point * self.scale).round().to_array();
            self.points.push(IntPoint::new(x as i32, y as i32));
        }
        self.ends.push(self.points.len() as u32);
        self.rows.push(rows);
    }

    /// Accumulates the union of some pieces.
    fn unite(&self, pieces: &[u32], rows: &mut CoverageRows) {
        let begin = |piece: usize| if piece == 0 { 0 } else { self.ends[piece - 1] as usize };
        let contour = |&piece: &u32| &self.points[begin(piece as usize)..self.ends[piece as usize] as usize];
        let mut overlay = Overlay::new(pieces.iter().map(|piece| contour(piece).len()).sum());
        for piece in pieces {
            overlay.add_contour(contour(piece), ShapeType::Subject);
        }
        for shape in overlay.overlay(OverlayRule::Subject, FillRule::NonZero) {
            for contour in shape {
                let to_px = |point: &IntPoint| DVec2::new(f64::from(point.x), f64::from(point.y)) / self.scale;
                rows.add_polygon(contour.iter().map(to_px));
            }
        }
    }
}

/// The direction to the left of a direction, as seen in the picture.
fn left_of(direction: DVec2) -> DVec2 {
    DVec2::new(direction.y, -direction.x)
}

/// The number of equal chords of an arc, each of which strays by at most [`ARC_PX`] from it.
pub(crate) fn arc_chords(angle_rad: f64, radius_px: f64) -> f64 {
    let chord_angle = 2.0 * (1.0 - ARC_PX / radius_px).clamp(-1.0, 1.0).acos().min(0.25 * PI);
    (angle_rad / chord_angle).ceil()
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::EdgeId;

    const SIZE: [u32; 2] = [40, 40];

    fn line(points: &[(f64, f64)], closed: bool) -> VisibleLine {
        let points: Vec<DVec2> = points.iter().map(|&(x, y)| DVec2::new(x, y)).collect();
        let segments = points.len() - usize::from(!closed);
        VisibleLine { points, edges: vec![EdgeId::new(0); segments], closed }
    }

    fn pen(placement: PenPlacement) -> Pen {
        Pen { width_px: 3.0, placement }
    }

    fn area(lines: &[VisibleLine], pen: Pen) -> f64 {
        let ink = draw(lines, pen, SIZE);
        let pixels = (0..40).flat_map(|y| (0..40).map(move |x| (x, y)));
        pixels.map(|(x, y)| f64::from(ink.coverage(x, y))).sum()
    }

    #[test]
    fn a_centred_pen_covers_a_strip_with_round_ends() {
        let straight = line(&[(8.3, 9.1), (28.3, 24.1)], false);
        let expected = 25.0 * 3.0 + PI * 1.5 * 1.5;
        assert!((area(std::slice::from_ref(&straight), pen(PenPlacement::Centred)) - expected).abs() < 1e-3);
        let dot = line(&[(20.2, 20.7), (20.2 + 1e-5, 20.7)], false);
        assert!((area(&[dot], pen(PenPlacement::Centred)) - PI * 1.5 * 1.5).abs() < 1e-3, "a disc");
        for placement in [PenPlacement::Inside, PenPlacement::Outside] {
            assert!((area(std::slice::from_ref(&straight), pen(placement)) - 75.0).abs() < 1e-4, "no ends");
        }
    }

    #[test]
    fn what_overlaps_counts_once() {
        let (across, down) = (line(&[(5.0, 20.0), (35.0, 20.0)], false), line(&[(20.0, 5.0), (20.0, 35.0)], false));
        let one = 30.0 * 3.0 + PI * 1.5 * 1.5;
        let crossed = area(&[across.clone(), down], pen(PenPlacement::Centred));
        assert!((crossed - (2.0 * one - 9.0)).abs() < 2e-3, "{crossed}");
        let twice = area(&[across.clone(), across.clone()], pen(PenPlacement::Centred));
        assert!((twice - one).abs() < 1e-3, "{twice}");
        // There and back again, in one line: two reversals.
        let back = line(&[(5.0, 20.0), (35.0, 20.0), (12.0, 20.0)], false);
        assert!((area(&[back], pen(PenPlacement::Centred)) - one).abs() < 1e-3);
        // Without the union they would count twice: the control of this test.
        let mut rows = CoverageRows::new(40, 0, 40);
        for _ in 0..2 {
            let mut outline = PenOutline::new(pen(PenPlacement::Centred), SIZE);
            outline.add(&PenPath::from(&across));
            outline.unite(&[0, 1, 2], &mut rows);
        }
        let sum: f64 = rows.into_shares().into_iter().map(f64::from).sum();
        assert!((sum - 2.0 * one).abs() < 2e-3, "{sum}");
    }

    /// A square that runs clockwise in the picture has its inside on the right.
    #[test]
    fn sides_and_turns_of_a_square_are_where_they_belong() {
        let square = line(&[(10.0, 10.0), (30.0, 10.0), (30.0, 30.0), (10.0, 30.0)], true);
        let quarter_turns = PI * 3.0 * 3.0;
        for (placement, expected) in [
            (PenPlacement::Outside, 20.0 * 20.0 - 14.0 * 14.0),
            (PenPlacement::Inside, 4.0 * 20.0 * 3.0 + quarter_turns),
            (PenPlacement::Centred, 20.0 * 20.0 - 17.0 * 17.0 + 4.0 * 20.0 * 1.5 + quarter_turns / 4.0),
        ] {
            let covered = area(std::slice::from_ref(&square), pen(placement));
            assert!((covered - expected).abs() < 2e-3, "{placement:?}: {covered} instead of {expected}");
        }
        let ink = draw(&[square], pen(PenPlacement::Inside), SIZE);
        assert!(ink.is_ink(20, 8) && !ink.is_ink(20, 10), "the left of the upper side is above it");
    }

    #[test]
    fn lines_beyond_the_frame_and_pens_without_width_do_no_harm() {
        let through = line(&[(-20.0, 20.0), (70.0, 20.0)], false);
        let at_the_frame = line(&[(0.0, 0.0), (40.0, 0.0), (40.0, 40.0)], false);
        assert!((area(&[through], pen(PenPlacement::Centred)) - 120.0).abs() < 1e-3);
        assert!((area(&[at_the_frame], pen(PenPlacement::Centred)) - (60.0 + 60.0 - 2.25)).abs() < 1e-3);
        let thin = Pen { width_px: 0.0, placement: PenPlacement::Centred };
        assert!(area(&[line(&[(5.0, 5.0), (9.0, 7.0)], false)], thin).abs() < 1e-9);
        assert!(area(&[], pen(PenPlacement::Centred)).abs() < 1e-12);
    }

    /// Coverage against 64 x 64 points per pixel, for a line that turns by all sorts of angles within its own width.
    #[test]
    fn tangled_lines_cover_what_is_within_half_a_width() {
        let points: Vec<(f64, f64)> = (0..60)
            .map(|at| (f64::from(at) * 2.399_963, 0.2 * f64::from(at)))
            .map(|(angle, radius)| (20.0 + radius * angle.cos(), 20.0 + radius * angle.sin()))
            .collect();
        let line = line(&points, false);
        let ink = draw(std::slice::from_ref(&line), pen(PenPlacement::Centred), SIZE);
        let distance = |p: DVec2, [a, b]: [DVec2; 2]| {
            let share = ((p - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
            p.distance(a.lerp(b, share))
        };
        for (x, y) in [(20, 20), (12, 17), (9, 28), (27, 11), (31, 20), (22, 30)] {
            let inside = (0..4096).filter(|sub| {
                let offset = DVec2::new(f64::from(sub % 64) + 0.5, f64::from(sub / 64) + 0.5) / 64.0;
                let point = DVec2::new(f64::from(x), f64::from(y)) + offset;
                line.segments().any(|(_, ends)| distance(point, ends) <= 1.5)
            });
            let (expected, covered) = (inside.count() as f32 / 4096.0, ink.coverage(x.into(), y.into()));
            assert!((covered - expected).abs() < 2e-3, "pixel {x}, {y}: {covered} instead of {expected}");
        }
    }
}
