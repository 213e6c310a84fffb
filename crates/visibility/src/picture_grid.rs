//! Step 3: a grid over the picture that says which contours pass near an edge.

use crate::contours::EDGES_PER_TASK;
use crate::frame::{ClippedEdge, PictureFrame};
use rayon::prelude::*;
use silhouette_core::glam::{DVec2, Vec4, Vec4Swizzles};

/// Cells per contour: at about two, a short edge looks at few contours and the table stays as large as the contours.
const CELLS_PER_CONTOUR: f64 = 2.0;

/// Cells that a contour passes on average, at most: long contours get larger cells, so that the table stays linear.
const CELLS_PASSED: f64 = 7.0;

/// Most cells along an axis.
const MAX_CELLS: f64 = 4096.0;

/// How far outside of its projection an edge is taken to reach, beyond its own doubt, in pixels.
const SLACK_PX: f64 = 1e-3;

/// A rectangle of the picture that holds an edge with all of its doubt, and the least distance of its points from the
/// viewer, rounded outwards: left and top, and right and bottom negated.
#[derive(Debug, Clone, Copy)]
struct EdgeBox {
    sides: Vec4,
    nearest: f32,
    /// The edge.
    index: u32,
}

fn below(value: f64) -> f32 {
    (value as f32).next_down()
}

impl EdgeBox {
    fn of(edge: &ClippedEdge, index: u32) -> Self {
        let [from, to] = edge.pixels;
        let (low, high) = (from.min(to) - edge.doubt_px - SLACK_PX, from.max(to) + edge.doubt_px + SLACK_PX);
        Self { sides: Vec4::from([low.x, low.y, -high.x, -high.y].map(below)), nearest: below(edge.depths[0]), index }
    }

    /// Whether this edge may meet another in the picture, of which `negated` are the sides, negated and in opposite order.
    #[inline]
    fn may_meet(&self, negated: Vec4) -> bool {
        self.sides.cmple(negated).all()
    }
}

/// Contours by cell of the picture.
#[derive(Debug)]
pub struct PictureGrid {
    cells: [usize; 2],
    /// Cells per pixel.
    scale: DVec2,
    /// Items of a cell are `items[first[cell]..first[cell + 1]]`.
    first: Vec<u32>,
    items: Vec<EdgeBox>,
    /// Contours whose place in the picture is too uncertain for cells: near the eye.
    everywhere: Vec<u32>,
}

/// An edge's place is given up beyond this doubt.
const MAX_DOUBT_PX: f64 = 1.0;

impl PictureGrid {
    /// Bins the contours: those edges, by their index in `clipped`, for which `is_contour` holds. `clipped` yields each edge's
    /// part inside the picture. O(edges + cells that contours pass), parallel.
    pub fn new(
        frame: &PictureFrame,
        clipped: &[Option<ClippedEdge>],
        is_contour: impl Fn(usize) -> bool + Sync,
    ) -> Self {
        let size = frame.size();
        let contours = || clipped.iter().enumerate().filter(|(index, _)| is_contour(*index));
        let certain = contours().filter_map(|(_, edge)| edge.as_ref().filter(|edge| is_certain(edge)));
        let (count, length) = certain.fold((0, 0.0), |(count, length), edge| (count + 1, length + edge.length_px()));
        let count = f64::from(count.max(1));
        let side = (size.x * size.y / (count * CELLS_PER_CONTOUR)).sqrt().max(length / (count * CELLS_PASSED));
        let cells = (size / side).ceil().clamp(DVec2::ONE, DVec2::splat(MAX_CELLS));
        let mut grid = Self {
            cells: [cells.x as usize, cells.y as usize],
            scale: cells / size,
            first: vec![0; cells.x as usize * cells.y as usize + 1],
            items: Vec::new(),
            everywhere: Vec::new(),
        };
        let passed = |(chunk, edges): (usize, &[Option<ClippedEdge>])| {
            let mut passed: Vec<(u32, u32)> = Vec::with_capacity(edges.len() * 4);
            for (index, edge) in (chunk * EDGES_PER_TASK..).zip(edges) {
                if let Some(edge) = edge.as_ref().filter(|edge| is_contour(index) && is_certain(edge)) {
                    grid.for_each_cell(edge, |cell| passed.push((cell as u32, index as u32)));
                }
            }
            passed
        };
        let passed: Vec<Vec<(u32, u32)>> = clipped.par_chunks(EDGES_PER_TASK).enumerate().map(passed).collect();
        let uncertain = contours().filter(|(_, edge)| edge.as_ref().is_some_and(|edge| !is_certain(edge)));
        grid.everywhere = uncertain.map(|(index, _)| index as u32).collect();
        // A counting sort: how many, where from, which.
        let mut first = std::mem::take(&mut grid.first);
        passed.iter().flatten().for_each(|&(cell, _)| first[cell as usize + 1] += 1);
        for cell in 1..first.len() {
            first[cell] += first[cell - 1];
        }
        let nowhere = EdgeBox { sides: Vec4::INFINITY, nearest: f32::INFINITY, index: u32::MAX };
        let mut items = vec![nowhere; first.last().map_or(0, |&total| total as usize)];
        let mut next = first.clone();
        for &(cell, index) in passed.iter().flatten() {
            let Some(edge) = &clipped[index as usize] else { continue };
            items[next[cell as usize] as usize] = EdgeBox::of(edge, index);
            next[cell as usize] += 1;
        }
        (grid.first, grid.items) = (first, items);
        grid
    }

    /// Appends the contours of an index not below `from` that may meet an edge in the picture, perhaps several times; of them
    /// only those that may be nearer to the viewer where `must_be_nearer`. Yields how many were looked at.
    pub fn near(&self, edge: &ClippedEdge, from: u32, must_be_nearer: bool, out: &mut Vec<u32>) -> u64 {
        out.extend(self.everywhere.iter().filter(|&&index| index >= from));
        if !is_certain(edge) {
            out.extend(self.items.iter().map(|item| item.index).filter(|&index| index >= from));
            return (self.everywhere.len() + self.items.len()) as u64;
        }
        let mut looked_at = self.everywhere.len() as u64;
        let negated = -EdgeBox::of(edge, 0).sides.zwxy();
        let farthest = if must_be_nearer { -below(-edge.depths[1]) } else { f32::INFINITY };
        self.for_each_cell(edge, |cell| {
            let items = &self.items[self.first[cell] as usize..self.first[cell + 1] as usize];
            looked_at += items.len() as u64;
            let may_meet = |item: &&EdgeBox| item.may_meet(negated) && item.index >= from && item.nearest <= farthest;
            out.extend(items.iter().filter(may_meet).map(|item| item.index));
        });
        looked_at
    }

    /// Calls for each cell that the edge may pass, column by column.
    #[inline]
    fn for_each_cell(&self, edge: &ClippedEdge, mut visit: impl FnMut(usize)) {
        let slack = (edge.doubt_px + SLACK_PX) * self.scale;
        let [from, to] = edge.pixels.map(|pixel| pixel * self.scale);
        let (left, right) = if from.x <= to.x { (from, to) } else { (to, from) };
        let slope = if right.x > left.x { (right.y - left.y) / (right.x - left.x) } else { 0.0 };
        let (low_y, high_y) = (left.y.min(right.y), left.y.max(right.y));
        let bound = |value: f64, axis: usize| (value.max(0.0) as usize).min(self.cells[axis] - 1);
        for column in bound(left.x - slack.x, 0)..=bound(right.x + slack.x, 0) {
            // Rows between the heights at which the edge enters and leaves the column.
            let enter = left.y + slope * (column as f64 - slack.x - left.x).clamp(0.0, right.x - left.x);
            let leave = left.y + slope * (column as f64 + 1.0 + slack.x - left.x).clamp(0.0, right.x - left.x);
            let (mut low, mut high) = (enter.min(leave), enter.max(leave));
            if right.x - left.x <= slack.x {
                (low, high) = (low_y, high_y);
            }
            for row in bound(low - slack.y, 1)..=bound(high + slack.y, 1) {
                visit(row * self.cells[0] + column);
            }
        }
    }
}

fn is_certain(edge: &ClippedEdge) -> bool {
    edge.doubt_px < MAX_DOUBT_PX && edge.pixels.iter().all(|pixel| pixel.is_finite())
}
