//! [`VertexClusters`]: a hierarchy of cells on a sphere, decided by their corners.

use super::chart::{Chart, Coordinates};
use super::{Cells, Tested};

/// Points of the sphere S^(N - 1), one for each shading vertex, in a hierarchy of cells.
#[derive(Debug, Clone)]
pub struct VertexClusters<const N: usize> {
    /// Shading vertices, those of a cell next to each other.
    vertices: Vec<u32>,
    /// Parents before their children; the first [`roots`](Self::roots) have no parent.
    cells: Vec<Cell<N>>,
    roots: usize,
    /// Cells to look at, with what is known of them; kept for its memory.
    stack: Vec<(u32, Answer)>,
}

/// What the last view knew of all vertices in a cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Answer {
    Visible,
    Invisible,
    Differs,
}

#[derive(Debug, Clone)]
struct Cell<const N: usize> {
    /// The vertices in it: a range of [`VertexClusters::vertices`].
    range: [u32; 2],
    /// The cells that it is divided into: a range of [`VertexClusters::cells`]; empty for a leaf.
    children: [u32; 2],
    chart: Chart,
    /// Its box: lowest and highest coordinates.
    extent: [Coordinates<N>; 2],
    last: Answer,
}

/// A cell of no more vertices is not divided.
const LEAF: usize = 12;

/// Nor is one at this depth, where many vertices have one normal.
const DEEPEST: u32 = 24;

/// Share of the largest summand within which the sign of a corner is not certain: far above the rounding of four products,
/// and of coordinates to the box.
const MARGIN: f64 = 1e-12;

impl<const N: usize> VertexClusters<N> {
    /// Sorts points into cells; leaves out those without a direction. O(V log V).
    pub fn new(points: &[[f64; N]], cells: Cells) -> Self {
        let charts: Vec<Chart> = match cells {
            Cells::AsPrinted => vec![Chart::Angles],
            Cells::Gnomonic | Cells::None => {
                (0..2 * N).map(|face| Chart::Gnomonic { axis: face / 2, is_negative: face % 2 == 1 }).collect()
            }
        };
        let chart_of = |point: &[f64; N]| if charts.len() == 1 { charts[0] } else { Chart::gnomonic_at(point) };
        let placed: Vec<_> = points.iter().map(|point| (chart_of(point), chart_of(point).coordinates(point))).collect();
        let mut clusters =
            Self { vertices: Vec::with_capacity(points.len()), cells: Vec::new(), roots: 0, stack: Vec::new() };
        let (low, high) = match cells {
            Cells::AsPrinted => (-std::f64::consts::PI, std::f64::consts::PI),
            Cells::Gnomonic | Cells::None => (-1.0, 1.0),
        };
        // Cells to divide: the box that halves them, whatever their points' own box.
        let mut open = Vec::new();
        for chart in charts {
            let begin = clusters.vertices.len();
            let has_direction = |vertex: usize| points[vertex].iter().any(|&x| x != 0.0);
            let here = placed.iter().enumerate().filter(|&(vertex, (of, _))| *of == chart && has_direction(vertex));
            clusters.vertices.extend(here.map(|(vertex, _)| vertex as u32));
            if clusters.vertices.len() > begin {
                open.push((clusters.cells.len(), [[low; N], [high; N]], 0));
                clusters.push_cell(chart, [begin, clusters.vertices.len()], &placed);
            }
        }
        clusters.roots = clusters.cells.len();
        while let Some((cell, extent, depth)) = open.pop() {
            let [begin, end] = clusters.cells[cell].range.map(|at| at as usize);
            if end - begin <= LEAF || depth == DEEPEST {
                continue;
            }
            let middle: [f64; N] = std::array::from_fn(|place| 0.5 * (extent[0][place] + extent[1][place]));
            let child_of = |vertex: u32| {
                let coordinates = &placed[vertex as usize].1;
                (0..N - 1).fold(0, |child, place| child | usize::from(coordinates[place] >= middle[place]) << place)
            };
            clusters.vertices[begin..end].sort_by_key(|&vertex| child_of(vertex));
            let first_child = clusters.cells.len();
            let mut from = begin;
            for child in 0..1 << (N - 1) {
                let count = clusters.vertices[from..end].partition_point(|&vertex| child_of(vertex) == child);
                if count > 0 {
                    let mut part = extent;
                    for place in 0..N - 1 {
                        part[usize::from(child >> place & 1 == 0)][place] = middle[place];
                    }
                    open.push((clusters.cells.len(), part, depth + 1));
                    clusters.push_cell(clusters.cells[cell].chart, [from, from + count], &placed);
                    from += count;
                }
            }
            clusters.cells[cell].children = [first_child as u32, clusters.cells.len() as u32];
        }
        clusters
    }

    fn push_cell(&mut self, chart: Chart, range: [usize; 2], placed: &[(Chart, Coordinates<N>)]) {
        let mut extent = [[f64::INFINITY; N], [f64::NEG_INFINITY; N]];
        for &vertex in &self.vertices[range[0]..range[1]] {
            for (place, &at) in placed[vertex as usize].1.iter().enumerate() {
                extent[0][place] = extent[0][place].min(at);
                extent[1][place] = extent[1][place].max(at);
            }
        }
        let range = range.map(|at| at as u32);
        self.cells.push(Cell { range, children: [0; 2], chart, extent, last: Answer::Differs });
    }

    /// Writes for each vertex whether its point P has P . `eye` >= 0, where a whole cell has and `test` where not. Unless
    /// `is_stale`, `is_visible` must be as the last call left it.
    pub fn decide(
        &mut self,
        eye: [f64; N],
        is_stale: bool,
        test: impl Fn(u32) -> bool,
        is_visible: &mut [bool],
    ) -> Tested {
        let mut tested = Tested::default();
        self.stack.clear();
        for root in 0..self.roots {
            let last = if is_stale { Answer::Differs } else { self.cells[root].last };
            self.stack.push((root as u32, last));
        }
        while let Some((index, last)) = self.stack.pop() {
            let cell = &mut self.cells[index as usize];
            tested.cells += 1;
            let answer = cell.answer(&eye);
            cell.last = answer;
            let [begin, end] = cell.range.map(|at| at as usize);
            let [first, beyond] = cell.children;
            if answer != Answer::Differs {
                if answer != last {
                    let is_seen = answer == Answer::Visible;
                    self.vertices[begin..end].iter().for_each(|&vertex| is_visible[vertex as usize] = is_seen);
                }
            } else if first == beyond {
                tested.vertices += (end - begin) as u64;
                self.vertices[begin..end].iter().for_each(|&vertex| is_visible[vertex as usize] = test(vertex));
            } else {
                for child in first..beyond {
                    // What was known of the whole cell holds for its parts, whatever they remember from before.
                    let known =
                        if last == Answer::Differs && !is_stale { self.cells[child as usize].last } else { last };
                    self.stack.push((child, known));
                }
            }
        }
        tested
    }

    /// Bytes held.
    pub fn bytes(&self) -> usize {
        size_of_val(self.vertices.as_slice()) + size_of_val(self.cells.as_slice())
    }
}

impl<const N: usize> Cell<N> {
    /// What all corners agree on.
    fn answer(&self, eye: &[f64; N]) -> Answer {
        let [low, high] = &self.extent;
        let (mut least, mut most, mut largest) = (f64::INFINITY, f64::NEG_INFINITY, 0.0_f64);
        match self.chart {
            // Linear in the coordinates: each alone decides at which corner the sum is least.
            Chart::Gnomonic { axis, is_negative } => {
                let base = if is_negative { -eye[axis] } else { eye[axis] };
                (least, most, largest) = (base, base, base.abs());
                let others = (0..N).filter(|&other| other != axis);
                for ((low, high), other) in low.iter().zip(high).zip(others) {
                    let ends = [low * eye[other], high * eye[other]];
                    least += ends[0].min(ends[1]);
                    most += ends[0].max(ends[1]);
                    largest = largest.max(ends[0].abs()).max(ends[1].abs());
                }
            }
            Chart::Angles => {
                for corner in 0..1_u32 << (N - 1) {
                    let end = |place: usize| if corner >> place & 1 == 0 { low[place] } else { high[place] };
                    let point: [f64; N] = self.chart.point(&std::array::from_fn(end));
                    let sum: f64 = point.iter().zip(eye).map(|(a, b)| a * b).sum();
                    (least, most) = (least.min(sum), most.max(sum));
                    largest = point.iter().zip(eye).fold(largest, |largest, (a, b)| largest.max((a * b).abs()));
                }
            }
        }
        if least > MARGIN * largest {
            Answer::Visible
        } else if most < -MARGIN * largest {
            Answer::Invisible
        } else {
            Answer::Differs
        }
    }
}
