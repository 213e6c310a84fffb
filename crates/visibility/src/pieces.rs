//! Step 8: runs of gaps of one invisibility.

use crate::contours::Layers;
use crate::gaps::Gap;

/// A part of a stroke with one invisibility.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Piece {
    /// The stroke, by its index.
    pub stroke: u32,
    /// Parameters at both ends.
    pub range: [f64; 2],
    /// Layers in front of it where it begins.
    pub layers: Layers,
    /// The contour at each end whose projection is crossed there, by its index; `None` at a vertex, at the border of the
    /// picture, and where a face is pierced.
    pub crossed: [Option<u32>; 2],
}

/// Appends the pieces of a stroke whose gaps have been told the layers of their spans: a piece for each run of gaps of one
/// invisibility. `layers` yields those of a gap, by its index.
pub fn emit(stroke: u32, range: [f64; 2], gaps: &[Gap], layers: impl Fn(usize) -> Layers, out: &mut Vec<Piece>) {
    let mut current: Option<Piece> = None;
    for (index, gap) in gaps.iter().enumerate().filter(|(_, gap)| gap.length() > 0.0) {
        let layers = layers(index);
        if current.as_ref().is_some_and(|piece| piece.layers.invisibility() == layers.invisibility()) {
            continue;
        }
        let begin = if current.is_none() { (range[0], None) } else { (gap.range[0], gap.crossed) };
        if let Some(mut piece) = current.take() {
            (piece.range[1], piece.crossed[1]) = begin;
            out.push(piece);
        }
        current = Some(Piece { stroke, range: [begin.0, range[1]], layers, crossed: [begin.1, None] });
    }
    out.extend(current);
}
