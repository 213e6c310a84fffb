//! What a frame misses of the visible silhouette: length in pixels, hidden parts omitted.

use super::circles::{Frame, Path};
use super::missed::Share;
use crate::error::Cause;
use silhouette_compare::Profile;
use silhouette_compare::truth::{TrueLines, TruthFinder};
use silhouette_core::{PreparedMesh, Progress, SilhouetteEdges};
use std::sync::Arc;

/// The visible lines of some frames: the [truth](silhouette_compare::truth).
#[derive(Debug)]
pub struct VisibleFrames {
    lines: Vec<TrueLines>,
}

/// Which of `measured` frames have their visible lines found: some, evenly spread.
pub fn pictured_frames(profile: Profile, measured: usize) -> Vec<usize> {
    let views = match profile {
        Profile::Quick => 4,
        Profile::Full => 12,
    };
    (0..views).map(|view| (2 * view + 1) * measured / (2 * views)).collect()
}

impl VisibleFrames {
    /// Finds the visible lines of these frames.
    ///
    /// # Errors
    /// [`Cause`]: no camera, a view too crowded to be decided, or cancelled.
    pub fn find(
        mesh: &Arc<PreparedMesh>,
        path: &Path,
        frames: &[Frame],
        size: [u32; 2],
        progress: &dyn Progress,
    ) -> Result<Self, Cause> {
        let mut finder = TruthFinder::new(mesh, progress)?;
        let mut lines = Vec::with_capacity(frames.len());
        for frame in frames {
            lines.push(finder.find(&path.camera(frame, size)?, progress)?.lines);
        }
        Ok(Self { lines })
    }

    /// Share of the visible length that these edges, one set per frame, miss.
    pub fn missed(&self, found: &[SilhouetteEdges]) -> Share {
        let mut share = Share::default();
        for (lines, found) in self.lines.iter().zip(found) {
            for sample in &lines.samples {
                share.add(sample.length_px, found.contains(sample.edge));
            }
        }
        share
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec2;
    use silhouette_compare::truth::TrueSample;
    use silhouette_core::EdgeId;

    #[test]
    fn frames_are_spread_and_within_the_path() {
        assert_eq!(pictured_frames(Profile::Quick, 120), [15, 45, 75, 105]);
        for frames in [1, 2, 504] {
            assert!(pictured_frames(Profile::Full, frames).iter().all(|&frame| frame < frames));
        }
    }

    /// Two edges, one of them twice as long in the picture as the other.
    #[test]
    fn what_is_missed_is_weighed_by_its_visible_length() {
        let sample =
            |edge: u32| TrueSample { pixel: DVec2::ZERO, tangent: DVec2::X, length_px: 0.25, edge: EdgeId::new(edge) };
        let lines = TrueLines { samples: vec![sample(3), sample(5), sample(5)], runs: Vec::new() };
        let missed = |found: &[u32]| {
            let mut edges = SilhouetteEdges::default();
            edges.refill(found.iter().copied().map(EdgeId::new));
            VisibleFrames { lines: vec![lines.clone()] }.missed(&[edges]).percent()
        };
        assert_eq!((missed(&[3, 5]), missed(&[])), (0.0, 100.0));
        assert!((missed(&[5]) - 100.0 / 3.0).abs() < 1e-12 && (missed(&[3, 9]) - 200.0 / 3.0).abs() < 1e-12);
    }
}
