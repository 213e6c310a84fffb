//! Step 8: runs of gaps of one invisibility.

use crate::gaps::Gap;
use crate::layers::Layers;

/// A part of a stroke with one invisibility.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Piece {
    /// The stroke, by its index.
    pub stroke: u32,
    /// How many solids or sheets lie in front of it.
    pub invisibility: u32,
    /// Parameters at both ends.
    pub range: [f64; 2],
}

/// Appends the pieces of a stroke of whose gaps the layers are known: one piece for each run of gaps of one invisibility,
/// where it is at most `max_invisibility`.
pub fn emit(
    stroke: u32,
    range: [f64; 2],
    gaps: &[Gap],
    layers: &[Layers],
    max_invisibility: u32,
    out: &mut Vec<Piece>,
) {
    let mut current: Option<Piece> = None;
    let is_wanted = |piece: &Piece| piece.invisibility <= max_invisibility;
    for (gap, layers) in gaps.iter().zip(layers).filter(|(gap, _)| gap.length() > 0.0) {
        let invisibility = layers.invisibility();
        if current.as_ref().is_some_and(|piece| piece.invisibility == invisibility) {
            continue;
        }
        let begin = if current.is_none() { range[0] } else { gap.range[0] };
        if let Some(mut piece) = current.take() {
            piece.range[1] = begin;
            out.extend(Some(piece).filter(is_wanted));
        }
        current = Some(Piece { stroke, invisibility, range: [begin, range[1]] });
    }
    out.extend(current.filter(is_wanted));
}
