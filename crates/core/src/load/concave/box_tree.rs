//! Finds the points of a plane that a triangle may hold.

/// Points of a leaf: few enough that boxes do not take more time than points.
const LEAF: usize = 8;

/// Points in nested boxes.
#[derive(Default)]
pub(super) struct BoxTree {
    /// Ranks of points, box by box.
    ranks: Vec<u32>,
    /// In preorder.
    boxes: Vec<Box>,
    /// Ranges of `ranks` that are yet to become boxes, with the box in which they end.
    pending: Vec<Pending>,
}

struct Box {
    low: [f64; 2],
    high: [f64; 2],
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
    pub(super) fn build(&mut self, ranks: impl Iterator<Item = u32>, points: impl Fn(u32) -> [f64; 2]) {
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
            let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
            for point in inside.iter().map(|&rank| points(rank)) {
                for axis in 0..2 {
                    low[axis] = low[axis].min(point[axis]);
                    high[axis] = high[axis].max(point[axis]);
                }
            }
            self.pending.push(Pending::End { of: self.boxes.len() });
            self.boxes.push(Box { low, high, begin: begin as u32, end: end as u32, skip: 0 });
            if inside.len() > LEAF {
                let axis = usize::from(high[1] - low[1] > high[0] - low[0]);
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
        triangle: [[f64; 2]; 3],
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
    normal: [f64; 2],
    least: f64,
}

impl HalfPlane {
    /// Whether all of a box lies outside.
    fn is_left_behind(&self, node: &Box) -> bool {
        let farthest = |axis: usize| if self.normal[axis] > 0.0 { node.high[axis] } else { node.low[axis] };
        self.normal[0] * farthest(0) + self.normal[1] * farthest(1) < self.least
    }
}

/// Half-planes whose intersection holds a counter-clockwise triangle, its border and what rounding could move there.
fn triangle_sides(triangle: [[f64; 2]; 3]) -> [HalfPlane; 3] {
    [0, 1, 2].map(|i| {
        let (from, to) = (triangle[i], triangle[(i + 1) % 3]);
        let normal = [from[1] - to[1], to[0] - from[0]];
        let size = triangle.iter().flatten().fold(0.0_f64, |size, x| size.max(x.abs()));
        // Every term and every sum is off by a few units in the last place of the largest product.
        let slack = 16.0 * f64::EPSILON * size * (normal[0].abs() + normal[1].abs());
        HalfPlane { normal, least: normal[0] * from[0] + normal[1] * from[1] - slack }
    })
}
