//! What a frame took, in counts that are the same on every machine.

use silhouette_core::method::ExtractionStats;

/// Why a frame was found by brute force instead of by tracking.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BruteForceReason {
    /// There is no frame before it (or it was forgotten).
    FirstFrame,
    /// The frame before had no silhouette to track.
    NothingToTrack,
    /// The eye moved farther than [`TrackerOptions::jump`](crate::TrackerOptions::jump), or the kind of view changed.
    Jump,
    /// The eye may have crossed the surface.
    MayHaveCrossed,
    /// Walks found so little that looking at every face was cheaper. What had been tracked by then is kept.
    LongWalks,
}

/// What one frame took.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct TrackingStats {
    /// Distinct faces whose facing was evaluated.
    pub faces_evaluated: u64,
    /// Of these, the ones that the plane equation in 32 bits could not certify.
    pub exact_fallbacks: u64,
    /// Edges looked at: old edges that were followed, concave and boundary edges searched, half-edges walked along.
    pub edges_tested: u64,
    /// Walks from an edge that is no silhouette any more.
    pub walks: u64,
    /// Steps of all walks.
    pub walk_steps: u64,
    /// Walks that found no silhouette.
    pub fruitless_walks: u64,
    /// Walks that found one, but across an old silhouette: not what became of their own.
    pub strayed_walks: u64,
    /// Loops completed from old edges.
    pub loops_tracked: u64,
    /// Loops completed from concave or boundary edges.
    pub loops_detected: u64,
    /// Whether the frame was audited, and is exact for it.
    pub audited: bool,
    /// Why the frame was found by brute force, if it was.
    pub brute_force: Option<BruteForceReason>,
}

impl TrackingStats {
    /// Takes over what evaluating facings took.
    pub(crate) fn count(&mut self, faces: &ExtractionStats) {
        self.faces_evaluated = faces.faces_tested;
        self.exact_fallbacks = faces.exact_fallbacks;
    }

    /// The counters that all methods have.
    pub fn extraction(&self) -> ExtractionStats {
        ExtractionStats {
            faces_tested: self.faces_evaluated,
            edges_tested: self.edges_tested,
            nodes_visited: 0,
            exact_fallbacks: self.exact_fallbacks,
        }
    }
}
