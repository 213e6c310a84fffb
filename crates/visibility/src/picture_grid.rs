//! Step 3: a grid over the picture that says which contours pass near an edge.

use crate::contours::EDGES_PER_TASK;
use crate::events::Depth;
use crate::frame::{ClippedEdge, PictureFrame};
use rayon::prelude::*;
use silhouette_core::glam::{DVec2, Vec4, Vec4Swizzles};

/// Cells a contour: at about two, a short edge looks at few contours and the table stays as large as the contours.
const CELLS_PER_CONTOUR: f64 = 2.0;

/// Cells that a contour passes on the average, at most: long contours get larger cells, so that the table stays linear.
const CELLS_PASSED: f64 = 7.0;

/// Most cells along an axis.
const MAX_CELLS: f64 = 4096.0;

/// How far outside of its projection an edge is taken to reach, beyond its own doubt, in pixels.
const SLACK_PX: f64 = 1e-3;

/// What tells most pairs of edges apart: a rectangle of the picture that holds an edge with all of its doubt, and the depths
/// between which it lies, rounded outwards.
#[derive(Debug, Clone, Copy)]
struct EdgeBox {
    /// Left and top, and right and bottom negated.
    sides: Vec4,
    nearest: f32,
    farthest: f32,
}

impl EdgeBox {
    /// Where no edge is.
    const NOWHERE: Self = Self { sides: Vec4::INFINITY, nearest: f32::INFINITY, farthest: f32::NEG_INFINITY };

    fn of(edge: &ClippedEdge) -> Self {
        let [from, to] = edge.pixels;
        let (low, high) = (from.min(to) - edge.doubt_px - SLACK_PX, from.max(to) + edge.doubt_px + SLACK_PX);
        let below = |value: f64| (value as f32).next_down();
        Self {
            sides: Vec4::from([low.x, low.y, -high.x, -high.y].map(below)),
            nearest: below(edge.depths[0]),
            farthest: -below(-edge.depths[1]),
        }
    }

    /// Whether this edge may meet `other` in the picture, nowhere farther from the viewer if only nearer ones count.
    fn may_meet(&self, other: &Self, depth: Depth) -> bool {
        self.sides.cmple(-other.sides.zwxy()).all() && (depth == Depth::Any || self.nearest <= other.farthest)
    }
}

/// Contours by cell of the picture.
#[derive(Debug)]
pub struct PictureGrid {
    cells: [usize; 2],
    /// Cells a pixel.
    scale: DVec2,
    /// Items of a cell are `items[first[cell]..first[cell + 1]]`.
    first: Vec<u32>,
    items: Vec<u32>,
    /// Of each contour.
    boxes: Vec<EdgeBox>,
    /// Contours whose place in the picture is too uncertain for cells: near the eye.
    everywhere: Vec<u32>,
}

/// An edge's place is given up beyond this doubt.
const MAX_DOUBT_PX: f64 = 1.0;

impl PictureGrid {
    /// Bins the contours. `clipped` yields each contour's part inside the picture. O(contours + cells that they pass),
    /// parallel.
    pub fn new(frame: &PictureFrame, clipped: &[Option<ClippedEdge>]) -> Self {
        let size = frame.size();
        let count = clipped.len().max(1) as f64;
        let length: f64 = clipped.iter().flatten().filter(|edge| is_certain(edge)).map(ClippedEdge::length_px).sum();
        let side = (size.x * size.y / (count * CELLS_PER_CONTOUR)).sqrt().max(length / (count * CELLS_PASSED));
        let cells = (size / side).ceil().clamp(DVec2::ONE, DVec2::splat(MAX_CELLS));
        let mut grid = Self {
            cells: [cells.x as usize, cells.y as usize],
            scale: cells / size,
            first: vec![0; cells.x as usize * cells.y as usize + 1],
            items: Vec::new(),
            boxes: clipped.iter().map(|edge| edge.as_ref().map_or(EdgeBox::NOWHERE, EdgeBox::of)).collect(),
            everywhere: Vec::new(),
        };
        let passed = |(chunk, edges): (usize, &[Option<ClippedEdge>])| {
            let mut passed: Vec<(u32, u32)> = Vec::with_capacity(edges.len() * 4);
            for (index, edge) in (chunk * EDGES_PER_TASK..).zip(edges) {
                if let Some(edge) = edge.as_ref().filter(|edge| is_certain(edge)) {
                    grid.for_each_cell(edge, |cell| passed.push((cell as u32, index as u32)));
                }
            }
            passed
        };
        let passed: Vec<Vec<(u32, u32)>> = clipped.par_chunks(EDGES_PER_TASK).enumerate().map(passed).collect();
        let uncertain = |edge: &Option<ClippedEdge>| edge.as_ref().is_some_and(|edge| !is_certain(edge));
        grid.everywhere = (0..).zip(clipped).filter(|(_, edge)| uncertain(edge)).map(|(index, _)| index).collect();
        // A counting sort: how many, where from, which.
        let mut first = std::mem::take(&mut grid.first);
        passed.iter().flatten().for_each(|&(cell, _)| first[cell as usize + 1] += 1);
        for cell in 1..first.len() {
            first[cell] += first[cell - 1];
        }
        let mut items = vec![0; first.last().map_or(0, |&total| total as usize)];
        let mut next = first.clone();
        for &(cell, index) in passed.iter().flatten() {
            items[next[cell as usize] as usize] = index;
            next[cell as usize] += 1;
        }
        (grid.first, grid.items) = (first, items);
        grid
    }

    /// Appends all contours that may meet an edge in the picture, at a depth that counts, perhaps several times. Yields how
    /// many were looked at.
    pub fn near(&self, edge: &ClippedEdge, depth: Depth, out: &mut Vec<u32>) -> u64 {
        out.extend_from_slice(&self.everywhere);
        if !is_certain(edge) {
            out.extend_from_slice(&self.items);
            return out.len() as u64;
        }
        let mut looked_at = self.everywhere.len() as u64;
        let wanted = EdgeBox::of(edge);
        self.for_each_cell(edge, |cell| {
            let items = &self.items[self.first[cell] as usize..self.first[cell + 1] as usize];
            looked_at += items.len() as u64;
            out.extend(items.iter().filter(|&&item| self.boxes[item as usize].may_meet(&wanted, depth)));
        });
        looked_at
    }

    /// Calls for each cell that the edge may pass, column by column.
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
