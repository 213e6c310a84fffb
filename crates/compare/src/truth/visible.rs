//! Strokes cut to what is visible of them.

use super::stretches::{Stretch, Stretches};
use super::strokes::{Segment, Stroke};
use glam::DVec2;
use silhouette_core::{EdgeId, TriangleMesh};

/// A visible line without interruption, a front face on its left.
#[derive(Debug, Clone, PartialEq)]
pub struct VisibleLine {
    /// Its points in pixels: at least two.
    pub points: Vec<DVec2>,
    /// The edge that each segment lies on: one fewer than points, or as many in a closed line.
    pub edges: Vec<EdgeId>,
    /// Whether the last point is joined to the first by a segment of its own.
    pub closed: bool,
}

impl VisibleLine {
    /// Its segments in order, each with its edge and its ends in pixels.
    pub fn segments(&self) -> impl Iterator<Item = (EdgeId, [DVec2; 2])> + '_ {
        let count = self.points.len();
        self.edges.iter().enumerate().map(move |(at, &edge)| (edge, [at, (at + 1) % count].map(|at| self.points[at])))
    }
}

/// What follows along a stroke.
enum Item {
    /// A visible stretch of an edge, in the direction of the stroke.
    Seen(EdgeId, [DVec2; 2]),
    /// An interruption.
    Cut,
}

/// The visible parts of strokes, in order. O(segments log stretches).
///
/// # Panics
/// If the three are not of one mesh.
pub fn visible_lines(mesh: &TriangleMesh, strokes: &[Stroke], stretches: &Stretches) -> Vec<VisibleLine> {
    let mut lines = Vec::new();
    let mut items = Vec::new();
    for stroke in strokes {
        items.clear();
        for segment in &stroke.segments {
            append(mesh, segment, stretches.on(segment.edge), &mut items);
        }
        collect(&items, stroke.closed, &mut lines);
    }
    lines
}

fn append(mesh: &TriangleMesh, segment: &Segment, stretches: &[Stretch], items: &mut Vec<Item>) {
    let [from, to] = segment.ends.map(|vertex| mesh.positions()[vertex.index()]);
    if from == to {
        // An edge without length is drawn by nobody and interrupts nothing.
        return;
    }
    let forward = segment.ends[0] < segment.ends[1];
    let mut reached = 0.0;
    for at in 0..stretches.len() {
        let Stretch { edge, range: [begin, end], pixels: [first, last] } =
            stretches[if forward { at } else { stretches.len() - 1 - at }];
        let ([begin, end], pixels) =
            if forward { ([begin, end], [first, last]) } else { ([1.0 - end, 1.0 - begin], [last, first]) };
        if begin > reached {
            items.push(Item::Cut);
        }
        items.push(Item::Seen(edge, pixels));
        reached = end;
    }
    if reached < 1.0 {
        items.push(Item::Cut);
    }
}

/// Makes a line of each uninterrupted part. A closed stroke starts where it is interrupted, so that none is cut in two; one
/// that is interrupted nowhere makes a closed line.
fn collect(items: &[Item], closed: bool, lines: &mut Vec<VisibleLine>) {
    let cut = items.iter().position(|item| matches!(item, Item::Cut));
    let start = if closed { cut.unwrap_or(0) } else { 0 };
    let empty = || VisibleLine { points: Vec::new(), edges: Vec::new(), closed: false };
    let mut line = empty();
    for item in items[start..].iter().chain(&items[..start]).chain([&Item::Cut]) {
        match item {
            Item::Seen(edge, [from, to]) => {
                if line.points.is_empty() {
                    line.points.push(*from);
                }
                line.points.push(*to);
                line.edges.push(*edge);
            }
            Item::Cut if line.points.is_empty() => {}
            Item::Cut => lines.push(std::mem::replace(&mut line, empty())),
        }
    }
    if closed
        && cut.is_none()
        && let Some(line) = lines.last_mut().filter(|line| !items.is_empty() && line.edges.len() == items.len())
        && line.edges.len() > 2
    {
        // The last point repeats the first.
        line.points.pop();
        line.closed = true;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn seen(at: u32) -> Item {
        Item::Seen(EdgeId::new(at), [f64::from(at), f64::from(at) + 1.0].map(DVec2::splat))
    }

    fn collected(items: &[Item], closed: bool) -> Vec<(Vec<u32>, bool)> {
        let mut lines = Vec::new();
        collect(items, closed, &mut lines);
        lines.iter().map(|line| (line.edges.iter().map(|edge| edge.get()).collect(), line.closed)).collect()
    }

    #[test]
    fn interruptions_part_a_stroke_into_lines() {
        let items = [seen(0), Item::Cut, seen(2), seen(3), Item::Cut, Item::Cut, seen(6)];
        assert_eq!(collected(&items, false), [(vec![0], false), (vec![2, 3], false), (vec![6], false)]);
        assert_eq!(collected(&items, true), [(vec![2, 3], false), (vec![6, 0], false)]);
        assert_eq!(collected(&[], true), []);
        assert_eq!(collected(&[Item::Cut], true), []);
    }

    #[test]
    fn a_closed_stroke_without_interruption_is_a_closed_line() {
        let mut lines = Vec::new();
        collect(&[seen(0), seen(1), seen(2)], true, &mut lines);
        assert_eq!((lines[0].closed, lines[0].points.len(), lines[0].edges.len()), (true, 3, 3));
        assert_eq!(lines[0].segments().last().unwrap().1, [DVec2::splat(2.0), DVec2::splat(0.0)]);
    }
}
