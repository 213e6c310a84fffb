//! The visible chains of a view as lines with the front face on their left.

use glam::{DVec2, DVec3, Vec3};
use silhouette_core::inspect::has_zero_area;
use silhouette_core::loops::start_vertex;
use silhouette_core::{EdgeId, FaceFacings, HalfEdgeId, SilhouetteEdges, Topology, TriangleMesh};
use silhouette_visibility::{Chain, Chains, SegmentSource};
use std::collections::HashSet;

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

/// The silhouette of a view by Hall's definition, and how its edges run.
#[derive(Debug, Clone, Copy)]
pub struct Silhouette<'a> {
    /// The mesh.
    pub mesh: &'a TriangleMesh,
    /// Its topology.
    pub topology: &'a Topology,
    /// Exact facings in the view.
    pub facings: &'a FaceFacings,
    /// The silhouette edges that follow from them.
    pub edges: &'a SilhouetteEdges,
}

impl Silhouette<'_> {
    /// The silhouette edge at a place of an edge: this edge, or one beyond faces without area that lies on it there. Such a face has
    /// two of its sides on the third: it makes no difference in the picture which of them is drawn, and by facing the other one may
    /// be the silhouette edge. O(1), or O(faces without area that are joined to the edge).
    fn at(&self, edge: EdgeId, place: DVec3) -> Option<EdgeId> {
        if self.edges.contains(edge) {
            return Some(edge);
        }
        let line = self.ends(edge);
        let is_on_line = |point: Vec3| has_zero_area([line[0], line[1], point]);
        let mut met = vec![edge];
        let mut seen = HashSet::from([edge]);
        while let Some(edge) = met.pop() {
            let ends = self.ends(edge);
            if self.edges.contains(edge) && ends.into_iter().all(is_on_line) && is_between(place, ends) {
                return Some(edge);
            }
            let flat = |half_edge: &&HalfEdgeId| has_zero_area(self.mesh.corners(half_edge.face()));
            for half_edge in self.topology.half_edges(edge).iter().filter(flat) {
                let next = half_edge.next_in_face();
                let others = [next, next.next_in_face()].map(|half_edge| self.topology.edge_of(half_edge));
                met.extend(others.into_iter().filter(|&other| seen.insert(other)));
            }
        }
        None
    }

    /// From where to where a silhouette edge runs in space with a front face on its left. At a non-manifold edge the first of several
    /// front faces decides.
    fn direction(&self, edge: EdgeId) -> Option<DVec3> {
        let half_edges = self.topology.half_edges(edge);
        let half_edge = half_edges.iter().find(|half_edge| self.facings.is_front(half_edge.face()))?;
        let [from, to] = [*half_edge, half_edge.next_in_face()]
            .map(|half_edge| self.mesh.positions()[start_vertex(self.mesh, half_edge).index()].as_dvec3());
        Some(to - from)
    }

    fn ends(&self, edge: EdgeId) -> [Vec3; 2] {
        self.topology.end_points(edge).map(|vertex| self.mesh.positions()[vertex.index()])
    }
}

/// Whether a point on the line through two others is between them.
fn is_between(point: DVec3, ends: [Vec3; 2]) -> bool {
    let [from, to] = ends.map(Vec3::as_dvec3);
    (0.0..=from.distance_squared(to)).contains(&(point - from).dot(to - from))
}

/// How a segment of a chain runs along a silhouette edge.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Way {
    /// With a front face on its left.
    Forward,
    /// With a front face on its right.
    Backward,
}

/// The silhouette edge that a segment lies on and how it runs; `None` for a segment on anything else.
type Placed = Option<(EdgeId, Way)>;

/// The chains of at most this invisibility, each parted where the side of its front face changes (at inconsistently wound
/// faces) and where it leaves the silhouette. O(segments log S).
///
/// The chains hold a few edges that are no silhouette edges by Hall's definition, such as the near rim of a wall seen
/// edge-on; they are left out.
///
/// # Panics
/// If the chains are of another mesh.
pub fn visible_lines(chains: &Chains, max_invisibility: u32, silhouette: &Silhouette<'_>) -> Vec<VisibleLine> {
    let mut lines = Vec::new();
    for chain in chains.iter().filter(|chain| chain.style.invisibility <= max_invisibility) {
        let segments: Vec<Placed> = (0..chain.sources.len()).map(|at| placed(&chain, at, silhouette)).collect();
        part(chain.pixels, &segments, chain.closed, &mut lines);
    }
    lines
}

fn placed(chain: &Chain<'_>, segment: usize, silhouette: &Silhouette<'_>) -> Placed {
    let SegmentSource::Edge(edge) = chain.sources[segment] else { return None };
    let [from, to] = [segment, (segment + 1) % chain.points.len()].map(|at| chain.points[at]);
    let edge = silhouette.at(edge, from.midpoint(to))?;
    let direction = silhouette.direction(edge)?;
    Some((edge, if (to - from).dot(direction) < 0.0 { Way::Backward } else { Way::Forward }))
}

/// Appends a line for each run of segments that go the same way. A closed chain is read from a change, so that no line is
/// cut in two; without a change it is a closed line.
fn part(points: &[DVec2], segments: &[Placed], closed: bool, lines: &mut Vec<VisibleLine>) {
    let count = segments.len();
    let way = |at: usize| segments[at % count].map(|(_, way)| way);
    let change = if closed { (0..count).find(|&at| way(at) != way(at + count - 1)) } else { Some(0) };
    let start = change.unwrap_or(0);
    let mut at = start;
    while at < start + count {
        let end = (at..start + count).find(|&next| way(next) != way(at)).unwrap_or(start + count);
        if let Some(way) = way(at) {
            let mut line = VisibleLine {
                points: (at..=end).map(|at| points[at % points.len()]).collect(),
                edges: (at..end).filter_map(|at| segments[at % count]).map(|(edge, _)| edge).collect(),
                closed: change.is_none(),
            };
            if line.closed {
                // It repeats the first.
                line.points.pop();
            }
            if way == Way::Backward {
                reverse(&mut line);
            }
            lines.push(line);
        }
        at = end;
    }
}

fn reverse(line: &mut VisibleLine) {
    line.points.reverse();
    line.edges.reverse();
    if line.closed {
        // The segment that closed the line now starts at its first point.
        line.edges.rotate_left(1);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use Way::{Backward, Forward};

    /// The edges and points of the lines that a chain with these ways is parted into; segment `i` runs from point `i`
    /// to point `i + 1` along edge `i`.
    fn parted(ways: &[Option<Way>], closed: bool) -> Vec<(Vec<u32>, Vec<u32>, bool)> {
        let count = ways.len();
        let points: Vec<DVec2> = (0..count + usize::from(!closed)).map(|at| DVec2::splat(at as f64)).collect();
        let place = |(at, way): (usize, &Option<Way>)| way.map(|way| (EdgeId::from_usize(at), way));
        let segments: Vec<Placed> = ways.iter().enumerate().map(place).collect();
        let mut lines = Vec::new();
        part(&points, &segments, closed, &mut lines);
        let ids = |line: &VisibleLine| line.edges.iter().map(|edge| edge.get()).collect();
        let places = |line: &VisibleLine| line.points.iter().map(|point| point.x as u32).collect();
        lines.iter().map(|line| (ids(line), places(line), line.closed)).collect()
    }

    #[test]
    fn a_chain_with_one_side_is_one_line() {
        assert_eq!(parted(&[Some(Forward); 2], false), [(vec![0, 1], vec![0, 1, 2], false)]);
        assert_eq!(parted(&[Some(Backward); 2], false), [(vec![1, 0], vec![2, 1, 0], false)]);
        assert_eq!(parted(&[Some(Forward); 3], true), [(vec![0, 1, 2], vec![0, 1, 2], true)]);
        assert_eq!(parted(&[Some(Backward); 3], true), [(vec![1, 0, 2], vec![2, 1, 0], true)]);
        assert_eq!(parted(&[], false), []);
    }

    #[test]
    fn a_chain_is_parted_where_its_side_changes() {
        let open = parted(&[Some(Forward), Some(Backward), Some(Backward), None, Some(Forward)], false);
        let expected = [(vec![0], vec![0, 1], false), (vec![2, 1], vec![3, 2, 1], false), (vec![4], vec![4, 5], false)];
        assert_eq!(open, expected);
        let closed = parted(&[Some(Forward), None, Some(Forward), Some(Forward)], true);
        assert_eq!(closed, [(vec![2, 3, 0], vec![2, 3, 0, 1], false)], "read past the end of the chain");
        assert_eq!(parted(&[None; 3], true), []);
    }

    /// Every segment of a reversed ring still joins the points that its edge joined.
    #[test]
    fn segments_keep_their_edges_when_a_ring_is_reversed() {
        let square = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(|(x, y)| DVec2::new(x, y));
        let segments: Vec<Placed> = (0..4).map(|at| Some((EdgeId::new(at), Backward))).collect();
        let mut lines = Vec::new();
        part(&square, &segments, true, &mut lines);
        for (edge, [from, to]) in lines[0].segments() {
            let at = edge.index();
            assert_eq!([to, from], [square[at], square[(at + 1) % 4]], "{edge:?}");
        }
    }
}
