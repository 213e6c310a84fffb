//! The outermost outline: where the picture of the scene ends, as closed polygons.
//!
//! 1. Every contour becomes a stroke whose surface side is the side with fewer layers.
//! 2. It is cut where it crosses any other contour, nearer or not, and the layers along the whole line of sight are counted
//!    just off it, as for visible lines. Where there are none, the scene ends.
//! 3. What remains is linked end to end: in mesh vertices, and where two contours cross in the picture.
//!
//! Every place where the outline passes from one contour to another is known by the pair of contours, so polygons close by
//! identity and not by distance. Only where rounding could not part several crossings, or the picture's wide surroundings cut
//! the outline, are the loose ends joined by distance.

use crate::chains::SegmentSource;
use crate::contours::{Contour, Layers};
use crate::cutter::StrokeCutter;
use crate::decide::decide;
use crate::finder::LineError;
use crate::frame::PictureFrame;
use crate::kind::LineKind;
use crate::picture_grid::PictureGrid;
use crate::pieces::Piece;
use crate::stroke::{Stroke, Strokes};
use crate::vertex_faces::VertexFaces;
use rayon::prelude::*;
use silhouette_core::glam::{DVec2, Vec3};
use silhouette_core::{EdgeId, Progress};
use std::collections::BTreeMap;

/// How far beyond the picture the outline is followed, in pictures: what is farther out is closed by a straight line.
const SURROUNDINGS: f64 = 8.0;

/// Where a piece of the outline ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Node {
    /// In a mesh vertex, told by its place, so that vertices that coincide are one.
    Vertex([u32; 3]),
    /// Where two contours cross in the picture, the lower one first.
    Crossing(u32, u32),
    /// Somewhere else: an end of its own.
    Loose(u32),
}

/// A piece of the outline, the scene on its left.
struct Side {
    nodes: [Node; 2],
    pixels: [DVec2; 2],
}

/// The outline's polygons in pixels, the scene on the left of each in a picture whose y points up. To be filled by the
/// even-odd rule. O(contours + crossings, log F a sight line).
///
/// # Errors
/// [`LineError`].
pub fn outermost_outline(
    of_view: &StrokeCutter<'_>,
    frame: &PictureFrame,
    vertex_faces: &VertexFaces,
    progress: &dyn Progress,
) -> Result<Vec<Vec<DVec2>>, LineError> {
    let topology = of_view.finder.topology;
    let (mut contours, mut strokes) = (Vec::new(), Strokes::default());
    for (contour, edges) in without_seams(of_view.contours) {
        strokes.push(stroke_of(&contour), edges.iter().flat_map(|&edge| topology.faces(edge)));
        contours.push(contour);
    }
    let margin = frame.size().max_element() * SURROUNDINGS;
    let clip = |contour: &Contour| frame.clip_drawn(contour.ends, margin);
    let clipped: Vec<_> = contours.par_iter().map(clip).collect();
    let grid = PictureGrid::new(frame, &clipped);
    let cutter =
        StrokeCutter { strokes: &strokes, contours: &contours, clipped_contours: &clipped, grid: &grid, ..*of_view };
    let decided = decide(&cutter, vertex_faces, &clipped, progress)?;
    let is_end = |piece: &&Piece| {
        let bounds_something = layers_beyond(&contours[piece.stroke as usize]) != 0;
        piece.layers.invisibility() == 0 && bounds_something
    };
    let ending = decided.pieces.iter().filter(is_end).enumerate();
    let sides: Vec<Side> = ending.map(|(index, piece)| side(&strokes, piece, index as u32, frame)).collect();
    Ok(link(&sides))
}

/// Contours of which those with the same ends are one, whose change is their sum, each with all its edges: where patches
/// meet without being joined, their boundary edges lie on each other, and what one ends the other goes on with.
fn without_seams(contours: &[Contour]) -> Vec<(Contour, Vec<EdgeId>)> {
    let mut at: BTreeMap<[[u32; 3]; 2], (Contour, Vec<EdgeId>)> = BTreeMap::new();
    for contour in contours {
        let [from, to] = contour.ends.map(place_of);
        let (key, direction) = if from < to { ([from, to], 1) } else { ([to, from], -1) };
        let (sum, edges) = at.entry(key).or_insert_with(|| {
            let ends = if direction > 0 { contour.ends } else { [contour.ends[1], contour.ends[0]] };
            let vertices = if direction > 0 { contour.vertices } else { [contour.vertices[1], contour.vertices[0]] };
            (Contour { ends, vertices, to_the_left: Layers::default(), ..*contour }, Vec::new())
        });
        sum.to_the_left.add(contour.to_the_left, direction);
        edges.push(contour.edge);
    }
    let mut merged: Vec<_> = at.into_values().filter(|(sum, _)| sum.to_the_left != Layers::default()).collect();
    merged.sort_unstable_by_key(|(contour, _)| contour.edge);
    merged
}

/// By how many layers the left of a contour exceeds its right.
fn layers_beyond(contour: &Contour) -> i32 {
    contour.to_the_left.front + contour.to_the_left.back
}

fn stroke_of(contour: &Contour) -> Stroke {
    Stroke {
        ends: contour.ends,
        vertices: contour.vertices,
        source: SegmentSource::Edge(contour.edge),
        kind: LineKind::Silhouette,
        object: 0,
        side: if layers_beyond(contour) > 0 { -1 } else { 1 },
        own: 0..0,
    }
}

/// The bits of a place, both zeros being one.
fn place_of(vertex: Vec3) -> [u32; 3] {
    (vertex + Vec3::ZERO).to_array().map(f32::to_bits)
}

fn side(strokes: &Strokes, piece: &Piece, index: u32, frame: &PictureFrame) -> Side {
    let stroke = &strokes.strokes[piece.stroke as usize];
    let node = |end: usize| match piece.crossed[end] {
        Some(other) => Node::Crossing(other.min(piece.stroke), other.max(piece.stroke)),
        None if piece.range[end] <= 0.0 || piece.range[end] >= 1.0 => Node::Vertex(place_of(stroke.ends[end])),
        None => Node::Loose(2 * index + end as u32),
    };
    let pixel = |t: f64| frame.map(stroke.at(t)).pixel();
    let (nodes, pixels) = ([node(0), node(1)], piece.range.map(pixel));
    // The scene lies away from the side on which nothing is.
    if stroke.side < 0 {
        Side { nodes, pixels }
    } else {
        Side { nodes: [nodes[1], nodes[0]], pixels: [pixels[1], pixels[0]] }
    }
}

/// Polygons through the sides: each ends where another begins.
fn link(sides: &[Side]) -> Vec<Vec<DVec2>> {
    let next = successors(sides);
    let mut done = vec![false; sides.len()];
    let mut polygons = Vec::new();
    for start in 0..sides.len() {
        let mut polygon = Vec::new();
        let mut at = start;
        while !std::mem::replace(&mut done[at], true) {
            let [from, to] = sides[at].pixels;
            polygon.push(from);
            // Both ends of a join are the same place, but for rounding.
            let joins = next[at].is_some_and(|following| sides[following].pixels[0].distance(to) < ROUNDING_PX);
            if !joins {
                polygon.push(to);
            }
            match next[at] {
                Some(following) => at = following,
                None => break,
            }
        }
        if polygon.len() > 2 {
            polygons.push(polygon);
        }
    }
    polygons
}

/// Two ends closer than this are one point of a polygon.
const ROUNDING_PX: f64 = 1e-3;

/// For each side the one that begins where it ends.
fn successors(sides: &[Side]) -> Vec<Option<usize>> {
    let mut beginnings: BTreeMap<Node, Vec<usize>> = BTreeMap::new();
    for (index, side) in sides.iter().enumerate().rev() {
        beginnings.entry(side.nodes[0]).or_default().push(index);
    }
    let mut next: Vec<Option<usize>> =
        sides.iter().map(|side| beginnings.get_mut(&side.nodes[1]).and_then(Vec::pop)).collect();
    // The few that are left, nearest first.
    let loose_ends: Vec<usize> = (0..sides.len()).filter(|&index| next[index].is_none()).collect();
    let loose_beginnings: Vec<usize> = beginnings.into_values().flatten().collect();
    if loose_ends.len() <= MAX_LOOSE {
        let mut pairs: Vec<(f64, usize, usize)> = Vec::new();
        for &end in &loose_ends {
            let distance = |&begin: &usize| sides[end].pixels[1].distance(sides[begin].pixels[0]);
            pairs.extend(loose_beginnings.iter().map(|begin| (distance(begin), end, *begin)));
        }
        pairs.sort_by(|one, other| one.0.total_cmp(&other.0).then((one.1, one.2).cmp(&(other.1, other.2))));
        let mut taken = vec![false; sides.len()];
        for (_, end, begin) in pairs {
            if next[end].is_none() && !std::mem::replace(&mut taken[begin], true) {
                next[end] = Some(begin);
            }
        }
    }
    next
}

/// Loose ends that are compared with each other, which takes quadratic time; more are left as they are.
const MAX_LOOSE: usize = 2000;
