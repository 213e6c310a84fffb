//! Follows the camera's path, frame by frame: each frame is drawn and timed, and what a scored one shows is kept.
//!
//! Scored frames are frames of the timed path, in its order. A method that keeps state from frame to frame is thus scored while
//! it does so, and its time and its accuracy are of the same frames.

use super::frame_source::FrameSource;
use crate::cost::FrameSample;
use crate::drawing::DrawError;
use silhouette_core::{Camera, Cancelled, Progress, SilhouetteEdges};
use silhouette_render::{Gpu, Image};

/// The frames of a cell.
#[derive(Debug)]
pub struct Followed {
    /// What each frame took, warm-up frames too.
    pub samples: Vec<FrameSample>,
    /// The scored frames in order.
    pub scored: Vec<ScoredFrame>,
}

/// A frame that was drawn, timed and kept.
#[derive(Debug)]
pub struct ScoredFrame {
    /// Its index among all frames.
    pub index: usize,
    /// What was drawn.
    pub picture: Image,
    /// The edges found, for a method that extracts edges.
    pub edges: Option<SilhouetteEdges>,
}

/// Why a path was not followed to its end.
#[derive(Debug, thiserror::Error)]
pub enum FollowError {
    /// Stopped by the progress.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// A frame failed.
    #[error(transparent)]
    Draw(#[from] DrawError),
}

/// Draws a frame for each camera and keeps those of the indices in `scored`, ascending. Pictures are read back between frames,
/// outside of their clocks.
///
/// # Errors
/// [`FollowError`].
pub fn follow(
    source: &mut dyn FrameSource,
    cameras: &[Camera],
    scored: &[usize],
    gpu: &Gpu,
    progress: &dyn Progress,
) -> Result<Followed, FollowError> {
    let mut followed =
        Followed { samples: Vec::with_capacity(cameras.len()), scored: Vec::with_capacity(scored.len()) };
    for (index, camera) in cameras.iter().enumerate() {
        progress.check()?;
        followed.samples.push(source.draw(gpu, camera)?);
        if scored.binary_search(&index).is_ok() {
            let picture = source.picture(gpu)?;
            followed.scored.push(ScoredFrame { index, picture, edges: source.edges().cloned() });
        }
        progress.advance(1);
    }
    Ok(followed)
}
