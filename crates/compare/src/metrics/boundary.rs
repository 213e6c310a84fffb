//! How far the boundaries of two filled shapes lie apart.
//!
//! A boundary is where coverage, linear between pixel centres, passes one half (marching squares: W. Lorensen and H. Cline,
//! "Marching Cubes", SIGGRAPH 1987, in the plane), so distances below a pixel are measured; from a straight edge it strays by at
//! most [`STRAY_PX`]. Where the frame cuts a shape there is no boundary.

use super::ink::{INK_THRESHOLD, Ink};
use super::separation::{HAUSDORFF_SHARE, Separation};
use glam::DVec2;

/// Farthest that a boundary strays from a straight edge, 3/2 - sqrt(2), reached by edges along rows and columns: where a
/// share p >= 1/2 of a pixel is covered and nothing of the next, the edge lies p - 1/2 from the pixel's centre and the
/// boundary 1 - 1/(2p), which differ most at p = 1/sqrt(2). Edges at other angles have smoother coverage.
pub const STRAY_PX: f64 = 1.5 - std::f64::consts::SQRT_2;

/// Side of the square cells that segments are looked up by, in pixels.
const CELL_PX: f64 = 8.0;

/// Chamfer and 95 % Hausdorff distance between the boundaries of two shapes; every point of a boundary counts by the length
/// that it stands for. The picture's diagonal where exactly one of the two has a boundary, 0 where neither has.
/// O(pixels + boundary in pixels), unless the boundaries lie far apart.
///
/// # Panics
/// If the pictures differ in size.
pub fn separation(drawn: &Ink, truth: &Ink) -> Separation {
    assert_eq!((drawn.width(), drawn.height()), (truth.width(), truth.height()), "pictures of one view");
    let size = [drawn.width(), drawn.height()];
    let [drawn_boundary, true_boundary] = [drawn, truth].map(boundary);
    let diagonal = drawn.diagonal_px();
    match (drawn_boundary.is_empty(), true_boundary.is_empty()) {
        (true, true) => Separation { chamfer_px: 0.0, hausdorff_95_px: 0.0 },
        (false, false) => {
            let to_truth = directed(&drawn_boundary, &SegmentGrid::new(&true_boundary, size));
            let to_drawn = directed(&true_boundary, &SegmentGrid::new(&drawn_boundary, size));
            Separation {
                chamfer_px: 0.5 * (to_truth.mean + to_drawn.mean),
                hausdorff_95_px: to_truth.percentile.max(to_drawn.percentile),
            }
        }
        _ => Separation { chamfer_px: diagonal, hausdorff_95_px: diagonal },
    }
}

/// A straight piece of a boundary, no longer than the diagonal of a pixel.
pub(crate) type Segment = [DVec2; 2];

/// The boundary of a shape, in pixel coordinates. O(pixels).
pub(crate) fn boundary(coverage: &Ink) -> Vec<Segment> {
    let [width, height] = [coverage.width(), coverage.height()].map(i64::from);
    let mut segments = Vec::new();
    for y in 0..height - 1 {
        for x in 0..width - 1 {
            let corners = [(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)];
            let values = corners.map(|(x, y)| f64::from(coverage.coverage(x, y) - INK_THRESHOLD));
            if values.iter().all(|&value| value >= 0.0) || values.iter().all(|&value| value < 0.0) {
                continue;
            }
            // Top, right, bottom, left: between a corner and the next.
            let crossings = [0, 1, 2, 3].map(|at| {
                let next = (at + 1) % 4;
                let [from, to] = [corners[at], corners[next]].map(|(x, y)| DVec2::new(x as f64, y as f64) + 0.5);
                let differs = (values[at] >= 0.0) != (values[next] >= 0.0);
                differs.then(|| from.lerp(to, values[at] / (values[at] - values[next])))
            });
            match crossings {
                [Some(top), Some(right), Some(bottom), Some(left)] => {
                    // The middle belongs to one pair of opposite corners; the other two are cut off.
                    let middle_is_as_first = (values.iter().sum::<f64>() >= 0.0) == (values[0] >= 0.0);
                    let cut = if middle_is_as_first {
                        [[top, right], [bottom, left]]
                    } else {
                        [[left, top], [right, bottom]]
                    };
                    segments.extend(cut);
                }
                crossings => {
                    let mut ends = crossings.into_iter().flatten();
                    if let (Some(from), Some(to)) = (ends.next(), ends.next()) {
                        segments.push([from, to]);
                    }
                }
            }
        }
    }
    segments
}

struct Directed {
    mean: f64,
    percentile: f64,
}

/// Mean and 95th percentile, by length, of the distances from the middles of segments to the nearest of others.
fn directed(from: &[Segment], to: &SegmentGrid<'_>) -> Directed {
    let measure = |[a, b]: &Segment| (to.distance(a.midpoint(*b)), a.distance(*b));
    let mut found: Vec<(f64, f64)> = from.iter().map(measure).collect();
    found.sort_unstable_by(|one, other| one.0.total_cmp(&other.0));
    let length: f64 = found.iter().map(|(_, length)| length).sum();
    let last = found[found.len() - 1].0;
    if length <= 0.0 {
        return Directed { mean: last, percentile: last };
    }
    let mut reached = 0.0;
    let percentile = found.iter().find(|(_, length_px)| {
        reached += length_px;
        reached >= HAUSDORFF_SHARE * length
    });
    Directed {
        mean: found.iter().map(|(distance, length)| distance * length).sum::<f64>() / length,
        percentile: percentile.map_or(last, |(distance, _)| *distance),
    }
}

/// Segments by the square cell that holds their middle.
struct SegmentGrid<'a> {
    segments: &'a [Segment],
    cells: Vec<Vec<u32>>,
    columns: i64,
    rows: i64,
}

impl<'a> SegmentGrid<'a> {
    fn new(segments: &'a [Segment], [width, height]: [u32; 2]) -> Self {
        let [columns, rows] = [width, height].map(|side| (f64::from(side) / CELL_PX) as i64 + 1);
        let mut cells = vec![Vec::new(); (columns * rows) as usize];
        for (at, [a, b]) in (0..).zip(segments) {
            let [x, y] = Self::cell(a.midpoint(*b));
            cells[(y * columns + x) as usize].push(at);
        }
        Self { segments, cells, columns, rows }
    }

    fn cell(point: DVec2) -> [i64; 2] {
        (point / CELL_PX).floor().as_i64vec2().to_array()
    }

    /// Distance to the nearest segment; infinite where there is none.
    fn distance(&self, point: DVec2) -> f64 {
        let [x, y] = Self::cell(point);
        let mut nearest = f64::INFINITY;
        for ring in 0..=self.columns.max(self.rows) {
            // Whatever lies in this ring or beyond is at least so far away; segments reach a pixel beyond their cell.
            if (ring - 1) as f64 * CELL_PX - 1.0 > nearest {
                break;
            }
            for row in (y - ring).max(0)..=(y + ring).min(self.rows - 1) {
                let is_edge_row = (row - y).abs() == ring;
                let step = if is_edge_row || ring == 0 { 1 } else { 2 * ring };
                for column in (x - ring..=x + ring).step_by(step as usize) {
                    if (0..self.columns).contains(&column) {
                        for &at in &self.cells[(row * self.columns + column) as usize] {
                            nearest = nearest.min(distance(point, self.segments[at as usize]));
                        }
                    }
                }
            }
        }
        nearest
    }
}

fn distance(point: DVec2, [a, b]: Segment) -> f64 {
    let along = b - a;
    let length_squared = along.length_squared();
    let share = if length_squared > 0.0 { ((point - a).dot(along) / length_squared).clamp(0.0, 1.0) } else { 0.0 };
    point.distance(a + along * share)
}

#[cfg(test)]
mod tests {
    use super::super::sample_fill::{SIZE, disc, square};
    use super::*;
    use proptest::prelude::*;
    use std::f64::consts::PI;

    #[test]
    fn a_straight_edge_is_found_within_the_bound() {
        let mut farthest: f64 = 0.0;
        for at in 0..20 {
            let corner = DVec2::new(20.0 + f64::from(at) / 20.0, -20.0);
            let segments = boundary(&square(corner, 200.0));
            let stray = segments.iter().flatten().map(|point| (point.x - corner.x).abs()).fold(0.0, f64::max);
            assert!(stray < STRAY_PX + 1e-2, "{corner}: {stray}");
            farthest = farthest.max(stray);
        }
        assert!(farthest > 0.9 * STRAY_PX, "the bound is reached: {farthest}");
    }

    #[test]
    fn the_boundary_of_a_disc_is_its_circle() {
        let (center, radius) = (DVec2::new(31.3, 32.9), 20.4);
        let segments = boundary(&disc(center, radius));
        let length: f64 = segments.iter().map(|[a, b]| a.distance(*b)).sum();
        assert!((length / (2.0 * PI * radius) - 1.0).abs() < 5e-3, "{length}");
        let farthest = segments.iter().flatten().map(|point| (point.distance(center) - radius).abs());
        // Between two ends at most sqrt(2) px apart the circle bulges by at most this.
        let bulge = 2.0 / (8.0 * radius);
        let farthest = farthest.fold(0.0, f64::max);
        assert!(farthest < STRAY_PX + bulge, "{farthest}");
    }

    /// A point at angle t of a circle moved by d along x is |d cos t| from the other circle, to first order.
    #[test]
    fn a_disc_moved_by_d_is_two_d_over_pi_apart() {
        let at = |x: f64| disc(DVec2::new(x, 32.0), 20.0);
        for shift in [0.5, 1.0, 2.0, 3.0] {
            let apart = separation(&at(30.0 + shift), &at(30.0));
            let expected = 2.0 * shift / PI;
            assert!((apart.chamfer_px / expected - 1.0).abs() < 0.03, "{shift}: {apart:?}");
            // Of a whole turn 5 % lie where |cos t| exceeds cos(0.025 pi).
            let expected = shift * (0.025 * PI).cos();
            assert!((apart.hausdorff_95_px - expected).abs() < 2.0 * STRAY_PX, "{shift}: {apart:?}");
        }
    }

    #[test]
    fn a_square_that_grows_by_d_is_d_away() {
        let apart = separation(&square(DVec2::splat(19.5), 25.0), &square(DVec2::splat(20.0), 24.0));
        assert!((apart.chamfer_px - 0.5).abs() < STRAY_PX, "{apart:?}");
    }

    #[test]
    fn what_the_frame_cuts_is_no_boundary() {
        let [whole, narrower] = [60.0, 59.0].map(|side| square(DVec2::splat(-20.0), side));
        let apart = separation(&narrower, &whole);
        assert!((apart.chamfer_px - 1.0).abs() < 0.05, "{apart:?}");
        let full = Ink::from_fn(SIZE, SIZE, |_, _| 1.0);
        assert!(boundary(&full).is_empty());
    }

    #[test]
    fn empty_pictures_are_a_diagonal_apart() {
        let (disc, blank) = (disc(DVec2::splat(32.0), 20.0), Ink::blank(SIZE, SIZE));
        for (one, other) in [(&disc, &blank), (&blank, &disc)] {
            let apart = separation(one, other);
            assert!((apart.chamfer_px - blank.diagonal_px()).abs() < 1e-12, "{apart:?}");
            assert!((apart.hausdorff_95_px - blank.diagonal_px()).abs() < 1e-12, "{apart:?}");
        }
        assert!(separation(&blank, &blank).chamfer_px.abs() < 1e-12);
    }

    proptest! {
        #[test]
        fn the_grid_finds_the_nearest_segment(
            ends in prop::collection::vec((0.5_f64..63.5, 0.5_f64..63.5, -0.7_f64..0.7, -0.7_f64..0.7), 1..12),
            at in (0.5_f64..63.5, 0.5_f64..63.5),
        ) {
            let segments: Vec<Segment> =
                ends.iter().map(|&(x, y, dx, dy)| [DVec2::new(x, y), DVec2::new(x + dx, y + dy)]).collect();
            let clamped: Vec<Segment> =
                segments.iter().map(|ends| ends.map(|end| end.clamp(DVec2::splat(0.5), DVec2::splat(63.5)))).collect();
            let point = DVec2::new(at.0, at.1);
            let nearest = clamped.iter().map(|&segment| distance(point, segment)).fold(f64::INFINITY, f64::min);
            let found = SegmentGrid::new(&clamped, [SIZE; 2]).distance(point);
            prop_assert_eq!(found.to_bits(), nearest.to_bits());
        }
    }
}
