//! [`Chains`]: the lines of a view as connected polylines, each with one kind and one invisibility.

use crate::kind::LineKind;
use silhouette_core::EdgeId;
use silhouette_core::glam::{DVec2, DVec3};
use std::ops::Range;

/// What a segment of a chain lies on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum SegmentSource {
    /// A mesh edge.
    Edge(EdgeId),
    /// A piece of a curve supplied by the caller, by its index.
    Curve(u32),
    /// The line in which two faces intersect, by its index among those found.
    Intersection(u32),
}

/// What all of a chain has in common.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ChainStyle {
    /// Why it is drawn.
    pub kind: LineKind,
    /// Quantitative invisibility: 0 where it is visible, otherwise how many solids or sheets lie in front.
    pub invisibility: u32,
    /// The object it belongs to, by its index in the scene.
    pub object: u32,
}

/// One connected polyline: borrowed from [`Chains`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Chain<'a> {
    /// Kind, invisibility and object.
    pub style: ChainStyle,
    /// Whether the last point is joined to the first by a segment of its own.
    pub closed: bool,
    /// Points in object space, at least two. Mesh vertices are exact; ends of visible stretches are rounded.
    pub points: &'a [DVec3],
    /// The same points in pixels, origin at the top left, pixel centres at .5.
    pub pixels: &'a [DVec2],
    /// What each segment lies on: one fewer than points, or as many in a closed chain.
    pub sources: &'a [SegmentSource],
    /// Bezier handles of each segment in pixels, for chains along curves; empty for straight ones.
    pub handles: &'a [[DVec2; 2]],
}

impl<'a> Chain<'a> {
    /// The points of a segment in pixels, closing segment included.
    ///
    /// # Panics
    /// If there is no such segment.
    pub fn segment_pixels(&self, segment: usize) -> [DVec2; 2] {
        [self.pixels[segment], self.pixels[(segment + 1) % self.pixels.len()]]
    }

    /// Length in pixels, of curves along their chords.
    pub fn length_px(&self) -> f64 {
        (0..self.sources.len()).map(|segment| self.segment_pixels(segment)).map(|[from, to]| from.distance(to)).sum()
    }
}

#[derive(Debug, Clone, PartialEq, Eq)]
struct Header {
    style: ChainStyle,
    closed: bool,
    points: Range<usize>,
    sources: Range<usize>,
    handles: Range<usize>,
}

/// Polylines in flat arrays.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Chains {
    headers: Vec<Header>,
    points: Vec<DVec3>,
    pixels: Vec<DVec2>,
    sources: Vec<SegmentSource>,
    handles: Vec<[DVec2; 2]>,
}

impl Chains {
    /// Number of chains.
    pub fn len(&self) -> usize {
        self.headers.len()
    }

    /// Whether there is no chain.
    pub fn is_empty(&self) -> bool {
        self.headers.is_empty()
    }

    /// Number of points of all chains.
    pub fn point_count(&self) -> usize {
        self.points.len()
    }

    /// The chain at an index.
    ///
    /// # Panics
    /// If there is no such chain.
    pub fn get(&self, index: usize) -> Chain<'_> {
        let header = &self.headers[index];
        Chain {
            style: header.style,
            closed: header.closed,
            points: &self.points[header.points.clone()],
            pixels: &self.pixels[header.points.clone()],
            sources: &self.sources[header.sources.clone()],
            handles: &self.handles[header.handles.clone()],
        }
    }

    /// All chains in order.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = Chain<'_>> {
        (0..self.headers.len()).map(|index| self.get(index))
    }

    /// Removes all chains; keeps the memory.
    pub fn clear(&mut self) {
        self.headers.clear();
        self.points.clear();
        self.pixels.clear();
        self.sources.clear();
        self.handles.clear();
    }

    /// Appends a copy of a chain.
    ///
    /// # Panics
    /// If it has fewer than two points or its arrays do not fit each other.
    pub fn push(&mut self, chain: Chain<'_>) {
        let segments = chain.points.len() - usize::from(!chain.closed);
        assert!(chain.points.len() >= 2 && chain.points.len() == chain.pixels.len(), "two points, each with its pixel");
        assert!(chain.sources.len() == segments, "a source a segment");
        assert!(chain.handles.is_empty() || chain.handles.len() == segments, "handles for no segment or for each");
        let begin = (self.points.len(), self.sources.len(), self.handles.len());
        self.points.extend_from_slice(chain.points);
        self.pixels.extend_from_slice(chain.pixels);
        self.sources.extend_from_slice(chain.sources);
        self.handles.extend_from_slice(chain.handles);
        self.headers.push(Header {
            style: chain.style,
            closed: chain.closed,
            points: begin.0..self.points.len(),
            sources: begin.1..self.sources.len(),
            handles: begin.2..self.handles.len(),
        });
    }

    /// Bytes held.
    pub fn bytes(&self) -> usize {
        size_of_val(self.headers.as_slice())
            + size_of_val(self.points.as_slice())
            + size_of_val(self.pixels.as_slice())
            + size_of_val(self.sources.as_slice())
            + size_of_val(self.handles.as_slice())
    }
}
