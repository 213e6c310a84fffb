//! [`Tracer`]: lines and curves as polylines within the picture.
//!
//! What lies farther outside than the pen is wide leaves no ink. It is cut off while it is read, so that coordinates of any size
//! cost no more than those inside.

use super::error::ForeignFault;
use crate::truth::pen::PenPath;
use crate::truth::view_facts::part_within;
use glam::DVec2;

/// Farthest that a chord strays from its curve, in pixels: a tenth of what a picture of this size can show.
pub const CHORD_PX: f64 = 0.01;

/// Most points that are kept of a file, after curves became chords: some 32 MiB.
pub const MAX_POINTS: usize = 2_000_000;

/// Halvings of a curve: enough for one that is a million pixels long.
const MAX_HALVINGS: u32 = 20;

/// The picture that lines are drawn in.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// Width of the pen in pixels.
    pub pen_width_px: f64,
}

impl Frame {
    /// How far outside of the picture the middle of a line may lie and leave ink inside.
    fn margin_px(&self) -> f64 {
        self.pen_width_px + 1.0
    }

    /// The lower right corner of where the middle of a line may lie.
    fn corner(&self) -> DVec2 {
        DVec2::from(self.size.map(f64::from)) + self.margin_px()
    }
}

/// A line in pixels, origin at the top left of the picture, centres of pixels at .5.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Polyline {
    /// Its points: at least two.
    pub points: Vec<DVec2>,
    /// Whether the last point is joined to the first.
    pub closed: bool,
}

impl<'a> From<&'a Polyline> for PenPath<'a> {
    fn from(line: &'a Polyline) -> Self {
        Self { points: &line.points, closed: line.closed }
    }
}

/// Follows lines point by point and keeps what can leave ink.
#[derive(Debug)]
pub struct Tracer {
    frame: Frame,
    lines: Vec<Polyline>,
    /// What is drawn since the pen was last set down, if it is down.
    drawn: Vec<DVec2>,
    start: DVec2,
    at: DVec2,
    /// Whether all since the start is in `drawn`.
    is_whole: bool,
    /// Segments since the start, kept or not.
    segments: usize,
    kept: usize,
    /// Lines with at least one segment, kept or not.
    followed: usize,
}

impl Tracer {
    /// A tracer without lines.
    pub fn new(frame: Frame) -> Self {
        Self {
            frame,
            lines: Vec::new(),
            drawn: Vec::new(),
            start: DVec2::ZERO,
            at: DVec2::ZERO,
            is_whole: true,
            segments: 0,
            kept: 0,
            followed: 0,
        }
    }

    /// Begins a line.
    pub fn move_to(&mut self, point: DVec2) {
        self.finish();
        (self.start, self.at) = (point, point);
    }

    /// Goes straight on.
    ///
    /// # Errors
    /// [`TooMany`] after [`MAX_POINTS`].
    pub fn line_to(&mut self, to: DVec2) -> Result<(), TooMany> {
        let from = self.at;
        self.at = to;
        self.segments += 1;
        let Some([begin, end]) = part_within([from, to], self.frame.size, self.frame.margin_px()) else {
            // One without length interrupts nothing.
            if from != to {
                self.lift();
            }
            return Ok(());
        };
        if begin > 0.0 {
            self.lift();
        }
        if self.drawn.is_empty() {
            self.keep(if begin > 0.0 { from.lerp(to, begin) } else { from })?;
        }
        self.keep(if end < 1.0 { from.lerp(to, end) } else { to })?;
        if end < 1.0 {
            self.lift();
        }
        Ok(())
    }

    /// Goes on along a cubic Bezier curve, in chords that stray by at most [`CHORD_PX`].
    ///
    /// # Errors
    /// [`TooMany`] after [`MAX_POINTS`].
    pub fn curve_to(&mut self, handles: [DVec2; 2], to: DVec2) -> Result<(), TooMany> {
        self.curve([self.at, handles[0], handles[1], to], MAX_HALVINGS)
    }

    fn curve(&mut self, [a, b, c, d]: [DVec2; 4], halvings: u32) -> Result<(), TooMany> {
        // A curve that runs evenly along its chord has its handles at the thirds of it, and strays by less than they do.
        let strays = b.distance(a.lerp(d, 1.0 / 3.0)).max(c.distance(a.lerp(d, 2.0 / 3.0)));
        if halvings == 0 || strays <= CHORD_PX || !self.may_show([a, b, c, d]) {
            return self.line_to(d);
        }
        let [ab, bc, cd] = [a.midpoint(b), b.midpoint(c), c.midpoint(d)];
        let [abc, bcd] = [ab.midpoint(bc), bc.midpoint(cd)];
        let middle = abc.midpoint(bcd);
        self.curve([a, ab, abc, middle], halvings - 1)?;
        self.curve([middle, bcd, cd, d], halvings - 1)
    }

    /// Whether the box around some points meets the picture.
    fn may_show(&self, points: [DVec2; 4]) -> bool {
        let margin = self.frame.margin_px();
        let low = points.into_iter().fold(DVec2::INFINITY, DVec2::min);
        let high = points.into_iter().fold(DVec2::NEG_INFINITY, DVec2::max);
        low.cmple(self.frame.corner()).all() && high.cmpge(DVec2::splat(-margin)).all()
    }

    /// Goes straight back to where the line began, and ends it.
    ///
    /// # Errors
    /// [`TooMany`] after [`MAX_POINTS`].
    pub fn close(&mut self) -> Result<(), TooMany> {
        let start = self.start;
        if self.at != start {
            self.line_to(start)?;
        }
        if self.is_whole && self.drawn.len() > 2 {
            // The last point repeats the first.
            self.drawn.pop();
            let points = std::mem::take(&mut self.drawn);
            self.lines.push(Polyline { points, closed: true });
        }
        self.move_to(start);
        Ok(())
    }

    /// Ends a line.
    fn finish(&mut self) {
        self.followed += usize::from(self.segments > 0);
        self.lift();
        (self.segments, self.is_whole) = (0, true);
    }

    fn lift(&mut self) {
        self.is_whole = false;
        let points = std::mem::take(&mut self.drawn);
        if points.len() > 1 {
            self.lines.push(Polyline { points, closed: false });
        }
    }

    fn keep(&mut self, point: DVec2) -> Result<(), TooMany> {
        self.kept += 1;
        // Where a segment is so long that its ends are rounded by pixels, so is the point at which it is cut.
        self.drawn.push(point.clamp(DVec2::splat(-self.frame.margin_px()), self.frame.corner()));
        if self.kept > MAX_POINTS { Err(TooMany) } else { Ok(()) }
    }

    /// What is drawn, and how many lines there were, inside of the picture or not.
    pub fn into_lines(mut self) -> (Vec<Polyline>, usize) {
        self.finish();
        (self.lines, self.followed)
    }
}

impl Tracer {
    /// What is drawn; nothing where no line was begun.
    ///
    /// # Errors
    /// [`ForeignFault::NoLines`] where all lines lie outside of the picture.
    pub fn finished(self) -> Result<Vec<Polyline>, ForeignFault> {
        match self.into_lines() {
            (lines, followed) if lines.is_empty() && followed > 0 => Err(ForeignFault::all_outside(followed)),
            (lines, _) => Ok(lines),
        }
    }
}

/// There are more points than are kept.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TooMany;

impl TooMany {
    /// The fault at a place of a file.
    pub fn at(self, place: impl Into<String>) -> ForeignFault {
        ForeignFault::TooManyPoints { place: place.into(), limit: MAX_POINTS }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FRAME: Frame = Frame { size: [100, 50], pen_width_px: 2.0 };

    fn traced(draw: impl FnOnce(&mut Tracer) -> Result<(), TooMany>) -> (Vec<Polyline>, usize) {
        let mut tracer = Tracer::new(FRAME);
        draw(&mut tracer).unwrap();
        tracer.into_lines()
    }

    fn point(x: f64, y: f64) -> DVec2 {
        DVec2::new(x, y)
    }

    #[test]
    fn what_lies_outside_is_cut_off_and_what_lies_inside_is_kept_to_the_bit() {
        let points = [point(10.1, 10.3), point(1e9, 10.3), point(50.0, 1e9), point(50.7, 20.9), point(60.0, 20.0)];
        let (lines, followed) = traced(|tracer| {
            tracer.move_to(points[0]);
            points[1..].iter().try_for_each(|&to| tracer.line_to(to))
        });
        assert_eq!((lines.len(), followed), (2, 1));
        assert_eq!((lines[0].points[0], lines[1].points[1..].to_vec()), (points[0], points[3..].to_vec()));
        let inside = |point: &DVec2| (-3.001..=103.001).contains(&point.x) && (-3.001..=53.001).contains(&point.y);
        assert!(lines.iter().flat_map(|line| &line.points).all(inside), "{lines:?}");
        let outside = traced(|tracer| {
            tracer.move_to(point(-10.0, 0.0));
            tracer.line_to(point(-10.0, 40.0))
        });
        assert_eq!(outside, (vec![], 1));
    }

    #[test]
    fn segments_that_are_rounded_by_pixels_are_cut_within_the_picture() {
        let mut strayed = 0;
        for step in 0..200 {
            let far = DVec2::from_angle(0.1 + 0.03 * f64::from(step)) * 7.7e16;
            // One of the nearer ends lies within the picture, one above it.
            let [within, above] = [point(50.0, 25.0), point(9.3, -6.5)];
            for [from, to] in [[within, far], [far, within], [above, far], [far, above], [far, -far]] {
                let (lines, _) = traced(|tracer| {
                    tracer.move_to(from);
                    tracer.line_to(to)
                });
                let is_inside = |p: &DVec2| (-3.0..=103.0).contains(&p.x) && (-3.0..=53.0).contains(&p.y);
                assert!(lines.iter().flat_map(|line| &line.points).all(is_inside), "{lines:?}");
                let cuts = part_within([from, to], FRAME.size, FRAME.margin_px());
                strayed += usize::from(cuts.is_some_and(|cuts| cuts.iter().any(|&t| !is_inside(&from.lerp(to, t)))));
            }
        }
        assert!(strayed > 100, "{strayed}");
    }

    #[test]
    fn closed_lines_stay_closed_unless_something_is_cut_off() {
        let triangle = |apex: DVec2| {
            traced(|tracer| {
                tracer.move_to(point(10.0, 10.0));
                tracer.line_to(point(30.0, 10.0))?;
                tracer.line_to(apex)?;
                tracer.close()?;
                // A line goes on from where the last was closed.
                tracer.line_to(point(5.0, 5.0))
            })
        };
        let (lines, followed) = triangle(point(20.0, 30.0));
        assert_eq!((lines.len(), followed), (2, 2));
        assert!(lines[0].closed && lines[0].points.len() == 3 && !lines[1].closed);
        assert_eq!(lines[1].points, [point(10.0, 10.0), point(5.0, 5.0)]);
        let (cut, _) = triangle(point(20.0, 900.0));
        assert!(cut.len() == 3 && cut.iter().all(|line| !line.closed), "{cut:?}");
    }

    #[test]
    fn chords_keep_to_their_curve() {
        // Bernstein's cubic, evaluated beside the halvings.
        let [a, b, c, d] = [point(5.0, 5.0), point(40.0, 90.0), point(-20.0, 40.0), point(90.0, 20.0)];
        let at = |t: f64| {
            let s = 1.0 - t;
            a * (s * s * s) + b * (3.0 * s * s * t) + c * (3.0 * s * t * t) + d * (t * t * t)
        };
        let (lines, _) = traced(|tracer| {
            tracer.move_to(a);
            tracer.curve_to([b, c], d)
        });
        let chords: Vec<_> = lines.iter().flat_map(|line| line.points.windows(2)).collect();
        assert!((10..500).contains(&chords.len()), "{}", chords.len());
        for step in 0..=1000 {
            let on_curve = at(f64::from(step) / 1000.0);
            if on_curve.y > 52.0 {
                continue;
            }
            let distance = |chord: &&[DVec2]| {
                let along = chord[1] - chord[0];
                let share = ((on_curve - chord[0]).dot(along) / along.length_squared()).clamp(0.0, 1.0);
                on_curve.distance(chord[0] + along * share)
            };
            let nearest = chords.iter().map(distance).fold(f64::INFINITY, f64::min);
            assert!(nearest <= CHORD_PX, "{nearest} at {on_curve}");
        }
    }

    #[test]
    fn huge_curves_cost_no_more_than_what_shows_of_them() {
        let (lines, _) = traced(|tracer| {
            tracer.move_to(point(-1e12, -3e11));
            tracer.curve_to([point(1e12, 4e12), point(-7e12, 1e12)], point(1e12, 2e12))?;
            tracer.move_to(point(-1e5, 20.0));
            tracer.curve_to([point(0.0, 30.0), point(10.0, 20.0)], point(1e5, 25.0))
        });
        let points: usize = lines.iter().map(|line| line.points.len()).sum();
        assert!((2..10_000).contains(&points), "{points}");
    }

    #[test]
    fn more_points_than_are_kept_are_refused() {
        let mut tracer = Tracer::new(FRAME);
        tracer.move_to(DVec2::ZERO);
        let refused = (0..=MAX_POINTS).map(|at| tracer.line_to(point((at % 90) as f64, 7.0))).find(Result::is_err);
        assert_eq!(refused, Some(Err(TooMany)));
    }
}
