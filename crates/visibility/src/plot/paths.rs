//! [`Paths`]: what a pen draws without being lifted, in page units.

use silhouette_core::glam::DVec2;
use std::ops::Range;

/// One path, borrowed from [`Paths`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Path<'a> {
    /// Whether a last segment leads back to the first point.
    pub closed: bool,
    /// At least two points in page units, origin at the page's top left.
    pub points: &'a [DVec2],
    /// Both Bezier handles of each segment, the closing one included; empty for straight segments.
    pub handles: &'a [[DVec2; 2]],
}

/// A straight segment, or a cubic Bezier curve where it has handles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Segment {
    /// Where it begins.
    pub from: DVec2,
    /// Where it ends.
    pub to: DVec2,
    /// Handles of its beginning and its end.
    pub handles: Option<[DVec2; 2]>,
}

/// Chords that a curve's length is measured by.
const CHORDS: u32 = 16;

impl Segment {
    /// Length in page units; of a curve along 16 chords.
    pub fn length(&self) -> f64 {
        if self.handles.is_none() {
            return self.from.distance(self.to);
        }
        let points = (0..=CHORDS).map(|chord| self.at(f64::from(chord) / f64::from(CHORDS)));
        let mut last = self.from;
        points.map(|point| std::mem::replace(&mut last, point).distance(point)).sum()
    }

    /// The point at a parameter from 0 to 1; the ends exactly.
    pub fn at(&self, t: f64) -> DVec2 {
        match self.handles {
            _ if t <= 0.0 => self.from,
            _ if t >= 1.0 => self.to,
            None => self.from.lerp(self.to, t),
            Some([a, b]) => {
                let s = 1.0 - t;
                self.from * (s * s * s) + a * (3.0 * s * s * t) + b * (3.0 * s * t * t) + self.to * (t * t * t)
            }
        }
    }

    /// The part between two parameters, `from_t < to_t`.
    pub fn part(&self, from_t: f64, to_t: f64) -> Self {
        let (from, to) = (self.at(from_t), self.at(to_t));
        let handles = self.handles.map(|_| {
            let third = (to_t - from_t) / 3.0;
            [from + self.velocity(from_t) * third, to - self.velocity(to_t) * third]
        });
        Self { from, to, handles }
    }

    /// Derivative by the parameter.
    fn velocity(&self, t: f64) -> DVec2 {
        let Some([a, b]) = self.handles else { return self.to - self.from };
        let s = 1.0 - t;
        3.0 * ((a - self.from) * (s * s) + (b - a) * (2.0 * s * t) + (self.to - b) * (t * t))
    }

    /// The same segment from its end.
    #[must_use]
    pub fn reversed(&self) -> Self {
        Self { from: self.to, to: self.from, handles: self.handles.map(|[a, b]| [b, a]) }
    }
}

impl Path<'_> {
    /// Number of segments.
    pub fn segment_count(&self) -> usize {
        self.points.len() - usize::from(!self.closed)
    }

    /// A segment by its index.
    ///
    /// # Panics
    /// If there is no such segment.
    pub fn segment(&self, index: usize) -> Segment {
        let to = if index + 1 == self.points.len() { 0 } else { index + 1 };
        Segment { from: self.points[index], to: self.points[to], handles: self.handles.get(index).copied() }
    }

    /// All segments in order.
    pub fn segments(&self) -> impl DoubleEndedIterator<Item = Segment> {
        (0..self.segment_count()).map(|index| self.segment(index))
    }

    /// Length in page units.
    pub fn length(&self) -> f64 {
        self.segments().map(|segment| segment.length()).sum()
    }

    /// Where the pen is put down.
    pub fn start(&self) -> DVec2 {
        self.points[0]
    }

    /// Where the pen is lifted.
    pub fn end(&self) -> DVec2 {
        if self.closed { self.points[0] } else { self.points[self.points.len() - 1] }
    }
}

#[derive(Debug, Clone, PartialEq, Eq)]
struct Header {
    closed: bool,
    points: Range<usize>,
    handles: Range<usize>,
}

/// Paths in flat arrays.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Paths {
    headers: Vec<Header>,
    points: Vec<DVec2>,
    handles: Vec<[DVec2; 2]>,
}

impl Paths {
    /// Number of paths.
    pub fn len(&self) -> usize {
        self.headers.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.headers.is_empty()
    }

    /// Number of points of all paths.
    pub fn point_count(&self) -> usize {
        self.points.len()
    }

    /// The path at an index.
    ///
    /// # Panics
    /// If there is no such path.
    pub fn get(&self, index: usize) -> Path<'_> {
        let header = &self.headers[index];
        Path {
            closed: header.closed,
            points: &self.points[header.points.clone()],
            handles: &self.handles[header.handles.clone()],
        }
    }

    /// All paths in order.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = Path<'_>> {
        (0..self.len()).map(|index| self.get(index))
    }

    /// Length of all paths in page units.
    pub fn length(&self) -> f64 {
        self.iter().map(|path| path.length()).sum()
    }

    /// Way of the lifted pen from the end of each path to the start of the next, in page units.
    pub fn pen_up_travel(&self) -> f64 {
        (1..self.len()).map(|index| self.get(index - 1).end().distance(self.get(index).start())).sum()
    }

    /// Appends a path.
    ///
    /// # Panics
    /// If it has fewer than two points, or handles for some segments but not for all.
    pub fn push(&mut self, path: Path<'_>) {
        self.begin();
        self.points.extend_from_slice(path.points);
        self.handles.extend_from_slice(path.handles);
        self.finish(path.closed);
    }

    /// Appends a path run through backwards; a closed one keeps its first point.
    pub fn push_reversed(&mut self, path: Path<'_>) {
        self.begin();
        self.points.push(if path.closed { path.points[0] } else { path.points[path.points.len() - 1] });
        let rest = path.segments().rev().take(path.points.len() - 1);
        self.points.extend(rest.map(|segment| segment.from));
        self.handles.extend(path.handles.iter().rev().map(|&[a, b]| [b, a]));
        self.finish(path.closed);
    }

    /// Appends a closed path that begins at another of its points.
    ///
    /// # Panics
    /// If the path is not closed or has no such point.
    pub fn push_rotated(&mut self, path: Path<'_>, first: usize) {
        assert!(path.closed, "only a closed path may begin anywhere");
        self.begin();
        self.points.extend_from_slice(&path.points[first..]);
        self.points.extend_from_slice(&path.points[..first]);
        if !path.handles.is_empty() {
            self.handles.extend_from_slice(&path.handles[first..]);
            self.handles.extend_from_slice(&path.handles[..first]);
        }
        self.finish(true);
    }

    /// Begins a path that [`extend`](Self::extend) adds to and [`finish`](Self::finish) ends.
    pub(super) fn begin(&mut self) {
        let end = self.headers.last().map_or((0, 0), |header| (header.points.end, header.handles.end));
        debug_assert_eq!(end, (self.points.len(), self.handles.len()), "no path is under way");
        self.headers.push(Header { closed: false, points: end.0..end.0, handles: end.1..end.1 });
    }

    /// Adds a segment to the path under way, whose last point is where the segment begins.
    pub(super) fn extend(&mut self, segment: &Segment) {
        if self.headers.last().is_some_and(|header| header.points.start == self.points.len()) {
            self.points.push(segment.from);
        }
        self.points.push(segment.to);
        self.handles.extend(segment.handles);
    }

    /// Adds a point to the straight path under way.
    pub(super) fn extend_to(&mut self, point: DVec2) {
        self.points.push(point);
    }

    /// Ends the path under way. A closed path's last segment leads to its first point, which is not repeated.
    pub(super) fn finish(&mut self, closed: bool) {
        let header = self.headers.last_mut().expect("a path is under way");
        header.closed = closed;
        header.points.end = self.points.len();
        header.handles.end = self.handles.len();
        let segments = header.points.len() - usize::from(!closed);
        assert!(header.points.len() >= 2, "a path has two points");
        assert!(header.handles.is_empty() || header.handles.len() == segments, "handles for no segment or for each");
    }

    /// Removes the last point of the closed path that [`extend`](Self::extend) has led back to its first point.
    pub(super) fn drop_repeated_point(&mut self) {
        self.points.pop();
    }
}
