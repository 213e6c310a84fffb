//! The window that the outline is followed in: the picture and what is around it. A chain that leaves it is closed along its
//! border.
//!
//! Contours say by how much the number of layers changes, not how many there are: around an eye inside of a solid there need
//! not be any. Where all that the scene holds lies inside of the window, there are none on its border. Otherwise they are
//! counted at one place of the border, face by face, and from there on contour by contour along all of it.

use super::lattice::{DirectedEdge, Point, pixel, snap};
use crate::frame::{Homogeneous, PictureFrame};
use crate::viewed_mesh::ViewedMesh;
use rayon::prelude::*;
use silhouette_core::glam::DVec2;
use silhouette_core::{FaceId, Facing};

/// How far beyond the picture the outline is followed, in pictures.
const SURROUNDINGS: f64 = 8.0;

/// Most places on the border at which layers are counted until one count is certain.
const TRIALS: usize = 8;

/// Distance of those places, as a share of the stretch they lie in: the golden ratio, whose multiples modulo 1 are spread
/// evenly and avoid the middle, where symmetric scenes have edges.
const TRIAL_STEP: f64 = 0.618_033_988_749_895;

/// Faces that a task takes: some 0.05 ms of work.
const FACES_PER_TASK: usize = 2048;

/// Lattice lines by which a point that was cut off may miss the border.
const ON_BORDER: u64 = 1 << 20;

/// By how much a determinant of homogeneous pixels may err, in units of the product of its rows' lengths.
const DETERMINANT_ERROR: f64 = 64.0 * f64::EPSILON;

/// A rectangle of the picture's plane.
#[derive(Debug, Clone, Copy)]
pub struct Window {
    /// Pixels at the top left and at the bottom right.
    pixels: [DVec2; 2],
    /// Lattice points at the bottom left and at the top right.
    corners: [Point; 2],
    /// Depths below which a point has no certain place in the picture.
    least_w: f64,
}

/// Where a chain crosses the border.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Crossing {
    /// How far along the border, from the bottom left and counter-clockwise.
    at: i64,
    /// How many layers more there are beyond.
    change: i32,
}

/// A chain cut off at the border of a window, not yet closed.
#[derive(Debug, Default)]
pub struct CutChain {
    edges: Vec<DirectedEdge>,
    crossings: Vec<Crossing>,
}

impl Window {
    /// The window of a picture.
    pub fn around(frame: &PictureFrame) -> Self {
        let margin = frame.size().max_element() * SURROUNDINGS;
        let pixels = [DVec2::splat(-margin), frame.size() + margin];
        let ([left, top], [right, bottom]) = (snap(pixels[0]), snap(pixels[1]));
        Self { pixels, corners: [[left, bottom], [right, top]], least_w: frame.least_w() }
    }

    /// Whether a point certainly lies inside. Never behind the eye.
    pub fn holds(&self, point: &Homogeneous) -> bool {
        self.heights(point).iter().all(|&height| height > 0.0)
    }

    /// How far a point lies inside of each side, times its depth, and beyond the least depth.
    fn heights(&self, &Homogeneous { scaled_pixel, w, .. }: &Homogeneous) -> [f64; 5] {
        let (low, high) = (scaled_pixel - self.pixels[0] * w, self.pixels[1] * w - scaled_pixel);
        [low.x, low.y, high.x, high.y, w - self.least_w]
    }

    /// The share of a line between two points that lies inside, and whether it was cut at either end; `None` if there is none.
    fn clip(&self, ends: [&Homogeneous; 2]) -> Option<([f64; 2], [bool; 2])> {
        let ([mut from, mut to], mut cut) = ([0.0_f64, 1.0], [false; 2]);
        let [of_a, of_b] = ends.map(|end| self.heights(end));
        for (at_a, at_b) in of_a.into_iter().zip(of_b) {
            match (at_a > 0.0, at_b > 0.0) {
                (true, true) => {}
                (false, false) => return None,
                (false, true) => (from, cut[0]) = (from.max(at_a / (at_a - at_b)), true),
                (true, false) => (to, cut[1]) = (to.min(at_a / (at_a - at_b)), true),
            }
        }
        (from < to).then_some(([from, to], cut))
    }

    /// The place of the border nearest to a point: how far along it is, and the place itself.
    fn on_border(&self, [x, y]: Point) -> (i64, Point) {
        let [[left, bottom], [right, top]] = self.corners;
        let (x, y) = (x.clamp(left, right), y.clamp(bottom, top));
        let (width, height) = (right - left, top - bottom);
        let sides = [
            (y - bottom, x - left, [x, bottom]),
            (right - x, width + (y - bottom), [right, y]),
            (top - y, width + height + (right - x), [x, top]),
            (x - left, 2 * width + height + (top - y), [left, y]),
        ];
        let nearest = sides.into_iter().min_by_key(|(distance, ..)| *distance);
        nearest.map_or((0, self.corners[0]), |(_, at, place)| (at % self.length(), place))
    }

    fn length(&self) -> i64 {
        let [[left, bottom], [right, top]] = self.corners;
        2 * (right - left) + 2 * (top - bottom)
    }

    /// How far along the border its corners are, counter-clockwise, the first being its beginning.
    fn corners_along(&self) -> [(i64, Point); 4] {
        let [[left, bottom], [right, top]] = self.corners;
        let (width, height) = (right - left, top - bottom);
        let at = [0, width, width + height, 2 * width + height];
        [(at[0], [left, bottom]), (at[1], [right, bottom]), (at[2], [right, top]), (at[3], [left, top])]
    }

    /// The place of the border that is so far along.
    fn place(&self, at: i64) -> Point {
        let corners = self.corners_along();
        let side = corners.partition_point(|(corner, _)| *corner <= at) - 1;
        let ((begin, from), (_, to)) = (corners[side], corners[(side + 1) % 4]);
        let toward = [0, 1].map(|axis| (to[axis] - from[axis]).signum());
        [0, 1].map(|axis| from[axis] + toward[axis] * (at - begin))
    }

    /// Where a line through a point inside leaves the window.
    fn exit(&self, from: DVec2, direction: DVec2) -> DVec2 {
        let reach = |axis: usize| {
            let limit = self.pixels[usize::from(direction[axis] > 0.0)][axis];
            if direction[axis] == 0.0 { f64::INFINITY } else { (limit - from[axis]) / direction[axis] }
        };
        from + direction * reach(0).min(reach(1)).max(0.0)
    }

    /// Appends what is inside of a directed edge between two points. `middle` is the middle of the scene.
    ///
    /// An edge through the eye is cut off where it has no certain place any more. The displaced viewer sees its end far away,
    /// straight beyond the place where the edge is seen end on, as seen from the middle of the scene: towards there the eye
    /// moves.
    pub fn push(&self, ends: [&Homogeneous; 2], layers: u32, middle: &Homogeneous, out: &mut CutChain) {
        let Some((range, cut)) = self.clip(ends) else { return };
        let [a, b] = ends;
        let cut_off = |t: f64| a.scaled_pixel.lerp(b.scaled_pixel, t) / (a.w + (b.w - a.w) * t);
        // Ends that stay are where other edges have them, to the bit.
        let pixels = [0, 1].map(|end: usize| if cut[end] { cut_off(range[end]) } else { ends[end].pixel() });
        let mut places = pixels.map(snap);
        for end in [0, 1].into_iter().filter(|&end| cut[end]) {
            let (mut at, mut place) = self.on_border(places[end]);
            if (0..2).any(|axis| places[end][axis].abs_diff(place[axis]) > ON_BORDER) {
                let away = (pixels[end] * middle.w - middle.scaled_pixel).try_normalize().unwrap_or(DVec2::X);
                (at, place) = self.on_border(snap(self.exit(pixels[end], away)));
                let [from, to] = if end == 0 { [place, places[0]] } else { [places[1], place] };
                out.edges.push(DirectedEdge { from, to, layers });
            } else {
                places[end] = place;
            }
            // Beyond an edge that leaves is what it has on its left.
            let change = if end == 0 { -(layers as i32) } else { layers as i32 };
            out.crossings.push(Crossing { at, change });
        }
        let [from, to] = places;
        out.edges.push(DirectedEdge { from, to, layers });
    }

    /// The chain, closed along the border. O(C log C) for C crossings of it, and O(F).
    pub fn close(&self, chain: CutChain, view: &ViewedMesh<'_>, frame: &PictureFrame) -> Vec<DirectedEdge> {
        let CutChain { mut edges, mut crossings } = chain;
        crossings.sort_unstable();
        let (begin, mut layers) = self.known_place(&crossings, view, frame);
        let first = crossings.partition_point(|crossing| crossing.at < begin);
        let around = |crossing: &Crossing| Crossing { at: crossing.at + self.length(), ..*crossing };
        let in_order = crossings[first..].iter().copied().chain(crossings[..first].iter().map(around));
        let mut at = begin;
        for crossing in in_order.chain([Crossing { at: begin + self.length(), change: 0 }]) {
            self.push_border([at, crossing.at], layers, &mut edges);
            layers += crossing.change;
            at = crossing.at;
        }
        edges.retain(|edge| edge.from != edge.to);
        edges
    }

    /// A place of the border at which it is certain how many layers there are, in the longest stretch between crossings.
    fn known_place(&self, crossings: &[Crossing], view: &ViewedMesh<'_>, frame: &PictureFrame) -> (i64, i32) {
        let after_last = crossings.first().map(|first| first.at + self.length());
        let ends = crossings.iter().skip(1).map(|crossing| crossing.at).chain(after_last);
        let stretches = crossings.iter().zip(ends).map(|(begin, end)| (end - begin.at, begin.at));
        let (length, begin) = stretches.max().unwrap_or((self.length(), 0));
        let places = (1..=TRIALS).map(|trial| (trial as f64 * TRIAL_STEP).fract());
        let mut last = (begin, 0);
        for at in places.map(|share| (begin + (length as f64 * share) as i64) % self.length()) {
            let (layers, is_certain) = layers_at(view, frame, pixel(self.place(at)));
            last = (at, layers);
            if is_certain {
                break;
            }
        }
        last
    }

    /// Appends a stretch of the border with so many layers inside, counter-clockwise: the window is on its left.
    fn push_border(&self, [from, to]: [i64; 2], layers: i32, out: &mut Vec<DirectedEdge>) {
        if layers == 0 {
            return;
        }
        let corners = self.corners_along();
        let around = corners.map(|(at, _)| at + self.length());
        let corners = corners.into_iter().map(|(at, _)| at).chain(around);
        let mut begin = from;
        for end in corners.filter(|&corner| from < corner && corner < to).chain([to]) {
            let ends = [begin, end].map(|at| self.place(at % self.length()));
            let [from, to] = if layers > 0 { ends } else { [ends[1], ends[0]] };
            out.push(DirectedEdge { from, to, layers: layers.unsigned_abs() });
            begin = end;
        }
    }
}

/// The number of faces that cover a pixel as the displaced viewer sees it, and whether it is certain. O(F), parallel.
fn layers_at(view: &ViewedMesh<'_>, frame: &PictureFrame, pixel: DVec2) -> (i32, bool) {
    let ray = pixel.extend(1.0);
    let at_face = |face: FaceId| {
        if view.unpaired.is_flat(face) || view.turn(face).is_tie() {
            // Seen edge-on.
            return (0, true);
        }
        let corners = view.mesh.corners(face).map(|corner| {
            let Homogeneous { scaled_pixel, w, .. } = frame.map(corner.as_dvec3());
            scaled_pixel.extend(w)
        });
        // With y down, a front face runs clockwise.
        let turn = if view.facing(face) == Facing::Front { -1.0 } else { 1.0 };
        let (mut least, mut error) = (f64::INFINITY, 0.0_f64);
        for slot in 0..3 {
            let [from, to] = [corners[slot], corners[(slot + 1) % 3]];
            least = least.min(ray.dot(from.cross(to)) * turn);
            error = error.max(ray.length() * from.length() * to.length() * DETERMINANT_ERROR);
        }
        (i32::from(least > 0.0), least.abs() > error)
    };
    let faces = (0..view.mesh.face_count()).into_par_iter().with_min_len(FACES_PER_TASK).map(FaceId::from_usize);
    faces.map(at_face).reduce(|| (0, true), |one, other| (one.0 + other.0, one.1 && other.1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::view::Projection;
    use silhouette_core::{Camera, glam::Vec3};

    fn window() -> Window {
        let projection = Projection::Orthographic { height: 2.0 };
        let camera = Camera::new(Vec3::Z, Vec3::ZERO, Vec3::Y, projection, [64, 32]).unwrap();
        Window::around(&PictureFrame::new(&camera, 1.0))
    }

    #[test]
    fn the_border_leads_around_the_window_with_it_on_the_left() {
        let (window, mut border) = (window(), Vec::new());
        window.push_border([7, 7 + window.length()], 2, &mut border);
        assert_eq!(border.len(), 5);
        let area: f64 = border.iter().map(|edge| pixel(edge.to).perp_dot(pixel(edge.from))).sum::<f64>() * 0.5;
        let [low, high] = window.pixels;
        assert!((area - (high - low).element_product()).abs() < 1e-6, "{area}");
        for edge in &border {
            assert!(edge.layers == 2 && window.place(window.on_border(edge.from).0) == edge.from);
        }
        border.clear();
        window.push_border([7, 9], -1, &mut border);
        assert_eq!(border, [DirectedEdge { from: window.place(9), to: window.place(7), layers: 1 }]);
    }

    #[test]
    fn what_leaves_the_window_changes_the_layers_beyond() {
        let (window, mut chain) = (window(), CutChain::default());
        let at = |x: f64, y: f64| Homogeneous { scaled_pixel: DVec2::new(x, y), w: 1.0, depth: 0.0 };
        // To the right, with something above.
        window.push([&at(10.0, 10.0), &at(1e4, 10.0)], 3, &at(0.0, 0.0), &mut chain);
        window.push([&at(1e4, 20.0), &at(10.0, 20.0)], 3, &at(0.0, 0.0), &mut chain);
        window.push([&at(-1e4, 2e3), &at(1e4, 2e3)], 3, &at(0.0, 0.0), &mut chain);
        chain.crossings.sort_unstable();
        assert_eq!(chain.crossings.iter().map(|crossing| crossing.change).collect::<Vec<_>>(), [-3, 3]);
        assert_eq!(chain.edges.len(), 2);
    }
}
