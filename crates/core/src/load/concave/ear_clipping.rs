//! Triangles of a simple polygon by ear clipping (Meisters, "Polygons have ears", American Mathematical Monthly 82, 1975).
//!
//! An *ear* is a corner whose triangle with its two neighbours is counter-clockwise and holds no other corner, not even on
//! its border. Cutting it off leaves a simple polygon of one corner fewer, and a simple polygon of more than three corners
//! has two ears at least.
//!
//! Corners may lie on a line with their neighbours, and a polygon may touch itself, such as one that reaches a hole by way
//! of a bridge: none of its corners is lost, because neighbouring polygons may need it. Only if there is no ear left are
//! corners of no area cut off too.
//!
//! Candidates wait in a queue, a tree of boxes finds the corners that a triangle may hold, and the work is bounded.

use super::box_tree::BoxTree;
use super::plane::{Point, orientation};
use std::collections::VecDeque;

/// Corners and boxes looked at, per corner of a polygon, after which it counts as one that crosses itself. A spiral of
/// 10,000 corners takes 300, one of 100,000 takes 900; the most that was seen is a quarter of the corners, for a comb whose
/// teeth stand on a line askew to all boxes. Without a bound, work could grow with the square of the corners.
pub(super) const MOST_STEPS: u64 = 1024;

/// Clips polygons one after another, and keeps its memory between them.
#[derive(Default)]
pub(super) struct EarClipping {
    points: Vec<Point>,
    /// The corners before and after each corner that is left.
    before: Vec<u32>,
    after: Vec<u32>,
    is_left: Vec<bool>,
    /// Whether the interior angle is 180 degrees or more: only such corners keep others from being ears.
    is_blunt: Vec<bool>,
    /// The corners that were left when it was last built.
    tree: BoxTree,
    queue: VecDeque<u32>,
    triangles: Vec<[u32; 3]>,
    steps_left: u64,
}

impl EarClipping {
    /// Where to put the corners of the next polygon, counter-clockwise.
    pub(super) fn points(&mut self) -> &mut Vec<Point> {
        &mut self.points
    }

    /// The triangles of the polygon, counter-clockwise, two fewer than corners, as ranks of corners. `None` if it crosses
    /// itself.
    pub(super) fn clip(&mut self) -> Option<&[[u32; 3]]> {
        self.begin();
        let mut left = self.points.len();
        let mut has_cut = true;
        let mut takes_flat = false;
        while left > 3 {
            let Some(corner) = self.queue.pop_front() else {
                // A corner may have become an ear by a cut far away.
                if !has_cut && std::mem::replace(&mut takes_flat, true) {
                    return None;
                }
                has_cut = false;
                self.queue.extend(corners_left(&self.is_left));
                continue;
            };
            if !self.is_left[corner as usize] {
                continue;
            }
            self.steps_left = self.steps_left.checked_sub(1)?;
            let turn = self.turn(corner);
            if (turn > 0.0 && !self.is_blocked(corner)?) || (turn == 0.0 && takes_flat) {
                self.cut(corner);
                left -= 1;
                has_cut = true;
                if self.tree.len() > 2 * left {
                    self.tree.build(corners_left(&self.is_left), |corner| self.points[corner as usize].flat);
                }
            }
        }
        let last = self.is_left.iter().position(|&is_left| is_left)? as u32;
        let is_over = self.turn(last) >= 0.0;
        self.triangles.push(self.triangle(last));
        is_over.then_some(self.triangles.as_slice())
    }

    fn begin(&mut self) {
        let corners = self.points.len() as u32;
        let refill = |ranks: &mut Vec<u32>, shift: u32| {
            ranks.clear();
            ranks.extend((0..corners).map(|corner| (corner + shift) % corners));
        };
        refill(&mut self.before, corners - 1);
        refill(&mut self.after, 1);
        self.is_left.clear();
        self.is_left.resize(corners as usize, true);
        self.is_blunt.clear();
        for corner in 0..corners {
            let is_blunt = self.turn(corner) <= 0.0;
            self.is_blunt.push(is_blunt);
        }

        self.tree.build(0..corners, |corner| self.points[corner as usize].flat);

        // Every second corner first: cut one after another, they would make a fan of slivers.
        self.queue.clear();
        self.queue.extend((0..corners).step_by(2).chain((1..corners).step_by(2)));
        self.triangles.clear();
        self.steps_left = MOST_STEPS * u64::from(corners);
    }

    fn triangle(&self, corner: u32) -> [u32; 3] {
        [self.before[corner as usize], corner, self.after[corner as usize]]
    }

    fn orientation(&self, [a, b, c]: [u32; 3]) -> f64 {
        let [a, b, c] = [a, b, c].map(|corner| &self.points[corner as usize]);
        orientation(a, b, c)
    }

    /// Positive at a corner where the polygon turns left, 0 where it goes straight on or back.
    fn turn(&self, corner: u32) -> f64 {
        self.orientation(self.triangle(corner))
    }

    /// Whether the triangle of a corner holds another corner. `None` when out of steps.
    fn is_blocked(&mut self, corner: u32) -> Option<bool> {
        let triangle = self.triangle(corner);
        let flat = triangle.map(|corner| self.points[corner as usize].flat);
        let mut steps_left = self.steps_left;
        let is_blocked = self.tree.any_within(flat, &mut steps_left, |other| {
            let is_candidate = self.is_left[other as usize] && self.is_blunt[other as usize];
            is_candidate && !triangle.contains(&other) && self.blocks(other, triangle)
        });
        self.steps_left = steps_left;
        is_blocked
    }

    /// Whether another corner lies in a counter-clockwise triangle. One that lies at a corner of the triangle does if the
    /// polygon runs from there into its interior.
    fn blocks(&self, other: u32, [a, b, c]: [u32; 3]) -> bool {
        if [[a, b], [b, c], [c, a]].into_iter().any(|[from, to]| self.orientation([from, to, other]) < 0.0) {
            return false;
        }
        let flat = |corner: u32| self.points[corner as usize].flat;
        let corners = [[a, b, c], [b, c, a], [c, a, b]];
        let Some([at, left, right]) = corners.into_iter().find(|&[at, ..]| flat(at) == flat(other)) else {
            return true;
        };
        let neighbours = [self.before[other as usize], self.after[other as usize]];
        let leads_inside =
            |&to: &u32| self.orientation([at, left, to]) > 0.0 && self.orientation([at, to, right]) > 0.0;
        neighbours.iter().any(leads_inside)
    }

    /// Cuts off the triangle of a corner.
    fn cut(&mut self, corner: u32) {
        let [before, _, after] = self.triangle(corner);
        self.triangles.push([before, corner, after]);
        self.is_left[corner as usize] = false;
        self.after[before as usize] = after;
        self.before[after as usize] = before;
        for neighbour in [before, after] {
            self.is_blunt[neighbour as usize] = self.turn(neighbour) <= 0.0;
            self.queue.push_back(neighbour);
        }
    }
}

/// The corners that have not been cut off.
fn corners_left(is_left: &[bool]) -> impl Iterator<Item = u32> {
    is_left.iter().enumerate().filter(|&(_, &is_left)| is_left).map(|(corner, _)| corner as u32)
}
