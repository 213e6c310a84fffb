//! The true visible lines of a view, in pixels: what a drawn picture is measured against.
//!
//! 1. [`strokes`]: the exact silhouette as connected, oriented lines, each edge once.
//! 2. [`sampling`]: each edge projected, clipped to the viewport and sampled every quarter of a pixel; each sample visible
//!    or not.
//! 3. [`pen`]: the strokes drawn with a method's own kind of pen by the supersampling reference renderer.
//!
//! Which edges are silhouette edges is exact. Which of their points are visible is decided by sampling a supersampled
//! depth picture, so a sample within about a sample's width of an occluding line can be judged wrongly. Exact visible
//! lines, computed in object space, will take this place.

pub mod pen;
pub mod sampling;
pub mod strokes;

use glam::DVec2;
use silhouette_core::EdgeId;
use std::ops::Range;

/// A point of a visible true line, standing for a short stretch around it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TrueSample {
    /// Where it appears, in pixels.
    pub pixel: DVec2,
    /// Unit direction of the line in the picture.
    pub tangent: DVec2,
    /// Length of the stretch in pixels, at most [`SPACING_PX`](sampling::SPACING_PX).
    pub length_px: f64,
    /// The silhouette edge that it lies on.
    pub edge: EdgeId,
}

/// A visible true line without interruption.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Run {
    /// Its samples in order, indices into [`TrueLines::samples`].
    pub samples: Range<usize>,
    /// Whether the last sample is followed by the first.
    pub closed: bool,
}

/// The visible true lines of a view.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct TrueLines {
    /// Visible samples, run after run.
    pub samples: Vec<TrueSample>,
    /// Uninterrupted lines; together they hold every sample.
    pub runs: Vec<Run>,
}

impl TrueLines {
    /// Length of all visible true lines in pixels.
    pub fn total_length_px(&self) -> f64 {
        self.samples.iter().map(|sample| sample.length_px).sum()
    }

    /// Appends a line, given as its samples in order with `None` where it is hidden: one run for each visible stretch. A
    /// closed line that is hidden nowhere makes one closed run.
    pub fn push_line(&mut self, line: &[Option<TrueSample>], closed: bool) {
        let hidden = line.iter().position(Option::is_none);
        // A closed line starts where it is hidden, so that no visible stretch is cut in two.
        let start = if closed { hidden.unwrap_or(0) } else { 0 };
        let mut first = self.samples.len();
        for sample in line[start..].iter().chain(&line[..start]) {
            match sample {
                Some(sample) => self.samples.push(*sample),
                None => first = self.end_run(first, false),
            }
        }
        self.end_run(first, closed && hidden.is_none());
    }

    fn end_run(&mut self, first: usize, closed: bool) -> usize {
        let end = self.samples.len();
        if end > first {
            self.runs.push(Run { samples: first..end, closed });
        }
        end
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sample(at: u32) -> Option<TrueSample> {
        Some(TrueSample {
            pixel: DVec2::new(f64::from(at), 0.0),
            tangent: DVec2::X,
            length_px: 1.0,
            edge: EdgeId::new(at),
        })
    }

    #[test]
    fn hidden_samples_part_a_line_into_runs() {
        let mut lines = TrueLines::default();
        lines.push_line(&[sample(0), None, sample(2), sample(3), None, None, sample(6)], false);
        assert_eq!(lines.runs.iter().map(|run| run.samples.clone()).collect::<Vec<_>>(), [0..1, 1..3, 3..4]);
        assert!((lines.total_length_px() - 4.0).abs() < 1e-12);
    }

    #[test]
    fn a_closed_line_is_not_cut_where_it_starts() {
        let mut lines = TrueLines::default();
        lines.push_line(&[sample(0), None, sample(2), sample(3)], true);
        let edges: Vec<u32> = lines.samples.iter().map(|sample| sample.edge.get()).collect();
        assert_eq!((edges, lines.runs.len(), lines.runs[0].closed), (vec![2, 3, 0], 1, false));
        lines.push_line(&[sample(0), sample(1)], true);
        assert_eq!(lines.runs[1], Run { samples: 3..5, closed: true });
        lines.push_line(&[None], true);
        lines.push_line(&[], false);
        assert_eq!(lines.runs.len(), 2);
    }
}
