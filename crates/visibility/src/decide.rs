//! Steps 4 to 8 for all strokes of a view: from edges in the picture to pieces of one invisibility.

use crate::cut::{CutStats, CutStroke, Cutter};
use crate::line_error::{LineError, MAX_PIECES};
use crate::pieces::{Piece, emit};
use crate::propagate::Propagation;
use crate::vertex_faces::VertexFaces;
use silhouette_core::Progress;

/// The pieces of all strokes, in order, and what they cost.
pub struct Decided {
    /// The pieces.
    pub pieces: Vec<Piece>,
    /// Pairs tested and events found.
    pub stats: CutStats,
    /// Sight lines cast.
    pub sight_lines: u64,
}

/// Cuts all strokes and decides their pieces, of which those up to `max_invisibility` are kept.
///
/// # Errors
/// [`LineError`].
pub fn decide(
    cutter: &Cutter<'_>,
    vertex_faces: &VertexFaces,
    max_invisibility: u32,
    progress: &dyn Progress,
) -> Result<Decided, LineError> {
    let cuts = cutter.cut(progress)?;
    let propagation = Propagation { strokes: cutter.strokes, sight: cutter.sight, vertex_faces };
    let (layers, sight_lines) = propagation.decide(&cuts, progress)?;
    let mut pieces = Vec::with_capacity(cuts.strokes.len());
    for CutStroke { stroke, gaps, range, .. } in &cuts.strokes {
        let layers = &layers[gaps.clone()];
        emit(*stroke, *range, &cuts.gaps[gaps.clone()], layers, max_invisibility, &mut pieces);
        if pieces.len() as u64 > MAX_PIECES + cuts.strokes.len() as u64 {
            return Err(LineError::TooManyPieces);
        }
    }
    Ok(Decided { pieces, stats: cuts.stats, sight_lines })
}
