//! Finds the points of a plane that a triangle may hold.

use glam::DVec2;

/// Points of a leaf: few enough that boxes do not take more time than points.
const LEAF: usize = 8;

/// Points in nested boxes.
#[derive(Default)]
pub(super) struct BoxTree {
    /// Ranks of points, box by box.
    ranks: Vec<u32>,
    /// In preorder.
    boxes: Vec<NestedBox>,
    /// Ranges of `ranks` that are yet to become boxes, with the box in which they end.
    pending: Vec<Pending>,
}

struct NestedBox {
    low: DVec2,
    high: DVec2,
    /// The range of ranks inside.
    begin: u32,
    end: u32,
    /// The box that follows those inside this one. The next one if there are none, and then this is a leaf.
    skip: u32,
}

enum Pending {
    Range { begin: usize, end: usize },
    End { of: usize },
}

impl BoxTree {
    /// Replaces the points by those of these ranks among `points`. O(n log n).
    pub(super) fn build(&mut self, ranks: impl Iterator<Item = u32>, points: impl Fn(u32) -> DVec2) {
        self.ranks.clear();
        self.ranks.extend(ranks);
        self.boxes.clear();
        self.pending.push(Pending::Range { begin: 0, end: self.ranks.len() });
        while let Some(pending) = self.pending.pop() {
            let (begin, end) = match pending {
                Pending::End { of } => {
                    self.boxes[of].skip = self.boxes.len() as u32;
                    continue;
                }
                Pending::Range { begin, end } => (begin, end),
            };
            let inside = &mut self.ranks[begin..end];
            let none = (DVec2::INFINITY, DVec2::NEG_INFINITY);
            let within = inside.iter().map(|&rank| points(rank));
            let (low, high) = within.fold(none, |(low, high), point| (low.min(point), high.max(point)));
            self.pending.push(Pending::End { of: self.boxes.len() });
            self.boxes.push(NestedBox { low, high, begin: begin as u32, end: end as u32, skip: 0 });
            if inside.len() > LEAF {
                let axis = usize::from(high.y - low.y > high.x - low.x);
                let middle = inside.len() / 2;
                inside.select_nth_unstable_by(middle, |&a, &b| {
                    points(a)[axis].total_cmp(&points(b)[axis]).then(a.cmp(&b))
                });
                let middle = begin + middle;
                self.pending.push(Pending::Range { begin: middle, end });
                self.pending.push(Pending::Range { begin, end: middle });
            }
        }
    }

    /// How many points there are.
    pub(super) fn len(&self) -> usize {
        self.ranks.len()
    }

    /// Whether `holds` is true of a point; it is asked of all in or on the border of a counter-clockwise triangle, and of
    /// some that are near. Each box and point takes a step from `steps_left`; `None` if they do not suffice.
    pub(super) fn any_within(
        &self,
        triangle: [DVec2; 3],
        steps_left: &mut u64,
        holds: impl Fn(u32) -> bool,
    ) -> Option<bool> {
        let sides = triangle_sides(triangle);
        let mut place = 0;
        while let Some(node) = self.boxes.get(place) {
            *steps_left = steps_left.checked_sub(1)?;
            if sides.iter().any(|side| side.is_left_behind(node)) {
                place = node.skip as usize;
                continue;
            }
            place += 1;
            if node.skip as usize == place {
                let inside = &self.ranks[node.begin as usize..node.end as usize];
                *steps_left = steps_left.checked_sub(inside.len() as u64)?;
                if inside.iter().any(|&rank| holds(rank)) {
                    return Some(true);
                }
            }
        }
        Some(false)
    }
}

/// A half-plane: where `normal . p >= least`.
struct HalfPlane {
    normal: DVec2,
    least: f64,
}

impl HalfPlane {
    /// Whether all of a box lies outside.
    fn is_left_behind(&self, node: &NestedBox) -> bool {
        let farthest = DVec2::select(self.normal.cmpgt(DVec2::ZERO), node.high, node.low);
        self.normal.dot(farthest) < self.least
    }
}

/// Half-planes whose intersection holds a counter-clockwise triangle, its border and what rounding could move there.
fn triangle_sides(triangle: [DVec2; 3]) -> [HalfPlane; 3] {
    [0, 1, 2].map(|i| {
        let (from, to) = (triangle[i], triangle[(i + 1) % 3]);
        let normal = (to - from).perp();
        let size = triangle.iter().map(|point| point.abs().max_element()).fold(0.0, f64::max);
        // Every term and every sum is off by a few units in the last place of the largest product.
        let slack = 16.0 * f64::EPSILON * size * (normal.x.abs() + normal.y.abs());
        HalfPlane { normal, least: normal.dot(from) - slack }
    })
}
