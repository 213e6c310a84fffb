//! Step 8: pieces joined to chains at mesh vertices.
//!
//! Two pieces of one style that end in the same vertex are joined. Where more than two meet, pairs are formed that go
//! straightest through the vertex in the picture. Pieces that end at a cut are not joined there: what continues beyond it has
//! another invisibility.

use crate::chains::{Chain, ChainStyle, Chains, SegmentSource};
use crate::curves;
use crate::frame::PictureFrame;
use crate::pieces::Piece;
use crate::scene::LineScene;
use crate::stroke::{NO_VERTEX, Strokes};
use silhouette_core::glam::{DVec2, DVec3};

/// An end of a piece: twice the piece's index, plus 1 for its second end.
type End = u32;

/// No end is joined here.
const LOOSE: End = End::MAX;

/// A piece with its ends placed.
struct Placed {
    style: ChainStyle,
    source: SegmentSource,
    points: [DVec3; 2],
    pixels: [DVec2; 2],
    /// Bezier handles of a piece of curve.
    handles: Option<[DVec2; 2]>,
    /// Mesh vertices at its ends, or [`NO_VERTEX`] where it was cut.
    vertices: [u32; 2],
}

/// Joins pieces to chains, ordered by style. O(pieces log pieces).
pub fn join(scene: &LineScene, strokes: &Strokes, pieces: &[Piece], frame: &PictureFrame) -> Chains {
    let placed: Vec<Placed> = pieces.iter().map(|piece| place(scene, strokes, piece, frame)).collect();
    let partner = partners(&placed);
    let mut order: Vec<u32> = (0..placed.len() as u32).collect();
    order.sort_by_key(|&piece| placed[piece as usize].style);
    let mut chains = Chains::default();
    let mut tracer =
        Tracer { placed: &placed, partner: &partner, done: vec![false; placed.len()], chain: Buffers::default() };
    // Open chains from their loose ends first; what remains is closed.
    for &piece in &order {
        for end in [2 * piece, 2 * piece + 1] {
            if partner[end as usize] == LOOSE {
                tracer.trace(end, &mut chains);
            }
        }
    }
    let open = chains;
    let mut closed = Chains::default();
    for &piece in &order {
        tracer.trace(2 * piece, &mut closed);
    }
    merge_by_style(&open, &closed)
}

fn place(scene: &LineScene, strokes: &Strokes, piece: &Piece, frame: &PictureFrame) -> Placed {
    let stroke = &strokes.strokes[piece.stroke as usize];
    let style = ChainStyle { kind: stroke.kind, invisibility: piece.invisibility, object: stroke.object };
    let part = strokes.curve_part(piece.stroke as usize);
    let curve = part.map(|part| (&scene.curves()[part.piece as usize], piece.range.map(|t| part.parameter(t))));
    let (points, pixels) = match curve {
        Some((curve, range)) => {
            let points = range.map(|at| curves::point(curve.control, at));
            (points, points.map(|point| frame.map(point).pixel()))
        }
        None => {
            let points = piece.range.map(|t| stroke.at(t));
            (points, points.map(|point| frame.drawn_pixel(point)))
        }
    };
    let reaches = [piece.range[0] <= 0.0, piece.range[1] >= 1.0];
    Placed {
        style,
        source: stroke.source,
        points,
        pixels,
        handles: curve.map(|(curve, range)| curves::handles(curve, range, frame)),
        vertices: [0, 1].map(|end| if reaches[end] { stroke.vertices[end] } else { NO_VERTEX }),
    }
}

/// For each end the end it is joined with.
fn partners(placed: &[Placed]) -> Vec<End> {
    let vertex_of = |end: End| placed[end as usize / 2].vertices[end as usize % 2];
    let style_of = |end: End| placed[end as usize / 2].style;
    let mut ends: Vec<End> = (0..2 * placed.len() as u32).filter(|&end| vertex_of(end) != NO_VERTEX).collect();
    ends.sort_unstable_by_key(|&end| (vertex_of(end), style_of(end), end));
    let mut partner = vec![LOOSE; 2 * placed.len()];
    let mut join = |one: End, other: End| {
        partner[one as usize] = other;
        partner[other as usize] = one;
    };
    for group in ends.chunk_by(|&one, &other| vertex_of(one) == vertex_of(other) && style_of(one) == style_of(other)) {
        match *group {
            [one, other] => join(one, other),
            [] | [_] => {}
            _ => straightest(placed, group, &mut join),
        }
    }
    partner
}

/// Ends at a vertex beyond which pairs are formed in the order given: a fan of more lines has no straight continuation to
/// speak of, and comparing all pairs would be quadratic.
const MAX_COMPARED: usize = 32;

fn straightest(placed: &[Placed], group: &[End], join: &mut impl FnMut(End, End)) {
    let direction = |end: End| {
        let [from, to] = placed[end as usize / 2].pixels;
        let away = if end.is_multiple_of(2) { to - from } else { from - to };
        away.normalize_or_zero()
    };
    if group.len() > MAX_COMPARED {
        group.chunks_exact(2).for_each(|pair| join(pair[0], pair[1]));
        return;
    }
    let mut pairs: Vec<(f64, End, End)> = Vec::new();
    for (index, &one) in group.iter().enumerate() {
        for &other in &group[index + 1..] {
            // Opposite directions away from the vertex go straight through it; a piece is not joined with itself.
            if one / 2 != other / 2 {
                pairs.push((direction(one).dot(direction(other)), one, other));
            }
        }
    }
    pairs.sort_by(|one, other| one.0.total_cmp(&other.0).then((one.1, one.2).cmp(&(other.1, other.2))));
    let mut taken: Vec<End> = Vec::new();
    for (_, one, other) in pairs {
        if !taken.contains(&one) && !taken.contains(&other) {
            join(one, other);
            taken.extend([one, other]);
        }
    }
}

#[derive(Default)]
struct Buffers {
    points: Vec<DVec3>,
    pixels: Vec<DVec2>,
    sources: Vec<SegmentSource>,
    handles: Vec<[DVec2; 2]>,
}

struct Tracer<'a> {
    placed: &'a [Placed],
    partner: &'a [End],
    done: Vec<bool>,
    chain: Buffers,
}

impl Tracer<'_> {
    /// Appends the chain that begins at an end, unless it has been traced.
    fn trace(&mut self, start: End, chains: &mut Chains) {
        if self.done[start as usize / 2] {
            return;
        }
        let Buffers { points, pixels, sources, handles } = &mut self.chain;
        points.clear();
        pixels.clear();
        sources.clear();
        handles.clear();
        let mut end = start;
        let closed = loop {
            let (piece, side) = (&self.placed[end as usize / 2], end as usize % 2);
            self.done[end as usize / 2] = true;
            points.push(piece.points[side]);
            pixels.push(piece.pixels[side]);
            sources.push(piece.source);
            handles
                .extend(piece.handles.map(|[first, second]| if side == 0 { [first, second] } else { [second, first] }));
            let far = end ^ 1;
            let next = self.partner[far as usize];
            if next == start {
                break true;
            }
            if next == LOOSE {
                points.push(piece.points[1 - side]);
                pixels.push(piece.pixels[1 - side]);
                break false;
            }
            end = next;
        };
        let style = self.placed[start as usize / 2].style;
        chains.push(Chain { style, closed, points, pixels, sources, handles });
    }
}

fn merge_by_style(open: &Chains, closed: &Chains) -> Chains {
    let mut merged = Chains::default();
    let mut order: Vec<(ChainStyle, bool, usize)> = Vec::new();
    order.extend(closed.iter().enumerate().map(|(index, chain)| (chain.style, false, index)));
    order.extend(open.iter().enumerate().map(|(index, chain)| (chain.style, true, index)));
    order.sort_unstable();
    for (_, is_open, index) in order {
        merged.push(if is_open { open.get(index) } else { closed.get(index) });
    }
    merged
}
