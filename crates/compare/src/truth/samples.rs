//! [`TrueLines`]: points along the visible lines, each standing for a short stretch.

use super::visible::VisibleLine;
use glam::DVec2;
use silhouette_core::EdgeId;
use std::ops::Range;

/// Distance between samples along a line in the picture, at most.
pub const SPACING_PX: f64 = 0.25;

/// A point of a visible true line, standing for a short stretch around it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TrueSample {
    /// Where it appears, in pixels.
    pub pixel: DVec2,
    /// Unit direction of the line in the picture.
    pub tangent: DVec2,
    /// Length of the stretch in pixels, at most [`SPACING_PX`].
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
    /// Samples of lines, one run per line; none for a line without length. O(length in pixels + segments).
    pub fn of(lines: &[VisibleLine]) -> Self {
        let mut sampled = Self::default();
        for line in lines {
            let first = sampled.samples.len();
            for (edge, ends) in line.segments() {
                sampled.sample_segment(edge, ends);
            }
            let end = sampled.samples.len();
            if end > first {
                sampled.runs.push(Run { samples: first..end, closed: line.closed });
            }
        }
        sampled
    }

    /// Length of all visible true lines in pixels.
    pub fn total_length_px(&self) -> f64 {
        self.samples.iter().map(|sample| sample.length_px).sum()
    }

    /// A segment in equal parts, a sample in the middle of each.
    fn sample_segment(&mut self, edge: EdgeId, [from, to]: [DVec2; 2]) {
        let length = from.distance(to);
        // A line seen end on has no length and no direction: nothing of it is drawn.
        let Some(tangent) = (to - from).try_normalize() else { return };
        let count = (length / SPACING_PX).ceil().max(1.0);
        self.samples.extend((0..count as u32).map(|part| TrueSample {
            pixel: from.lerp(to, (f64::from(part) + 0.5) / count),
            tangent,
            length_px: length / count,
            edge,
        }));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn samples_are_spread_evenly_and_keep_the_length() {
        let points = [(1.0, 2.0), (4.0, 6.0), (4.0, 6.0), (4.0, 6.1)].map(|(x, y)| DVec2::new(x, y)).to_vec();
        let open = VisibleLine { points, edges: [7, 8, 9].map(EdgeId::new).to_vec(), closed: false };
        let triangle = VisibleLine { closed: true, points: open.points[..3].to_vec(), ..open.clone() };
        let lines = TrueLines::of(&[open, triangle]);
        assert!((lines.total_length_px() - 5.1 - 10.0).abs() < 1e-12);
        assert!(lines.samples.iter().all(|sample| sample.length_px <= SPACING_PX));
        assert_eq!(
            lines.runs.iter().map(|run| (run.samples.len(), run.closed)).collect::<Vec<_>>(),
            [(21, false), (40, true)]
        );
        let jumps = lines.samples[..21].windows(2).map(|pair| pair[0].pixel.distance(pair[1].pixel));
        assert!(jumps.fold(0.0, f64::max) <= SPACING_PX + 1e-12);
        assert!(lines.samples[..20].iter().all(|sample| sample.tangent.distance(DVec2::new(0.6, 0.8)) < 1e-12));
        assert_eq!((lines.samples[19].edge, lines.samples[20].edge), (EdgeId::new(7), EdgeId::new(9)));
    }

    #[test]
    fn a_line_seen_end_on_has_no_sample() {
        let dot = VisibleLine { points: vec![DVec2::ONE; 2], edges: vec![EdgeId::new(0)], closed: false };
        assert_eq!(TrueLines::of(&[dot]), TrueLines::default());
    }
}
