//! Which stretches of mesh edges the chains of a view cover.

use silhouette_core::glam::{DVec2, DVec3};
use silhouette_core::{EdgeId, Topology, TriangleMesh};
use silhouette_visibility::{Chains, SegmentSource};

/// A stretch of a mesh edge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stretch {
    /// The edge.
    pub edge: EdgeId,
    /// Where it begins and ends along the edge in space, 0 at the vertex of lower id and 1 at the other, exactly.
    pub range: [f64; 2],
    /// Both ends in pixels.
    pub pixels: [DVec2; 2],
}

/// Stretches of edges, ordered by edge and along each.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Stretches(Vec<Stretch>);

impl Stretches {
    /// The stretches that visible chains cover, those along mesh edges. O(n log n).
    ///
    /// # Panics
    /// If the chains are of another mesh.
    pub fn visible(chains: &Chains, mesh: &TriangleMesh, topology: &Topology) -> Self {
        Self::down_to(0, chains, mesh, topology)
    }

    /// The stretches that chains of at most this invisibility cover, those along mesh edges. O(n log n).
    ///
    /// # Panics
    /// If the chains are of another mesh.
    pub fn down_to(invisibility: u32, chains: &Chains, mesh: &TriangleMesh, topology: &Topology) -> Self {
        let mut stretches = Vec::new();
        for chain in chains.iter().filter(|chain| chain.style.invisibility <= invisibility) {
            for (segment, source) in chain.sources.iter().enumerate() {
                if let SegmentSource::Edge(edge) = *source {
                    let ends = topology.end_points(edge).map(|vertex| mesh.positions()[vertex.index()].as_dvec3());
                    let points = [segment, (segment + 1) % chain.points.len()].map(|at| chain.points[at]);
                    let (mut range, mut pixels) =
                        (points.map(|point| parameter(ends, point)), chain.segment_pixels(segment));
                    if range[0] > range[1] {
                        range.reverse();
                        pixels.reverse();
                    }
                    stretches.push(Stretch { edge, range, pixels });
                }
            }
        }
        Self::from_stretches(stretches)
    }

    /// Stretches in any order. O(n log n).
    pub fn from_stretches(mut stretches: Vec<Stretch>) -> Self {
        stretches.sort_by(|one, other| one.edge.cmp(&other.edge).then(one.range[0].total_cmp(&other.range[0])));
        Self(stretches)
    }

    /// The stretches of one edge, in order from the vertex of lower id. O(log n).
    pub fn on(&self, edge: EdgeId) -> &[Stretch] {
        let begin = self.0.partition_point(|stretch| stretch.edge < edge);
        let count = self.0[begin..].partition_point(|stretch| stretch.edge == edge);
        &self.0[begin..begin + count]
    }

    /// Length of all stretches in pixels.
    pub fn length_px(&self) -> f64 {
        self.0.iter().map(|stretch| stretch.pixels[0].distance(stretch.pixels[1])).sum()
    }

    /// Length in pixels of what both cover, on the same edges of the same view. O(n log n).
    pub fn overlap_px(&self, other: &Self) -> f64 {
        let shared = |one: &Stretch| {
            // All stretches of an edge lie on one straight line in the picture.
            let Some(along) = (one.pixels[1] - one.pixels[0]).try_normalize() else { return 0.0 };
            let place = |pixel: DVec2| (pixel - one.pixels[0]).dot(along);
            let [begin, end] = one.pixels.map(place);
            let covered = other.on(one.edge).iter().map(|other| {
                let [from, to] = other.pixels.map(place);
                (end.min(to) - begin.max(from)).max(0.0)
            });
            covered.sum::<f64>()
        };
        self.0.iter().map(shared).sum()
    }

    /// All stretches.
    pub fn as_slice(&self) -> &[Stretch] {
        &self.0
    }
}

/// How far along an edge a point of it lies, 0 and 1 exactly at its ends.
fn parameter([a, b]: [DVec3; 2], point: DVec3) -> f64 {
    if point == a {
        0.0
    } else if point == b {
        1.0
    } else {
        ((point - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn stretches(places: &[(u32, f64, f64)]) -> Stretches {
        let at = |place: f64| DVec2::new(3.0, 1.0) + DVec2::new(6.0, 8.0) * place;
        let stretch = |&(edge, begin, end): &(u32, f64, f64)| Stretch {
            edge: EdgeId::new(edge),
            range: [begin, end],
            pixels: [begin, end].map(at),
        };
        Stretches(places.iter().map(stretch).collect())
    }

    #[test]
    fn stretches_are_found_by_their_edge() {
        let all = stretches(&[(2, 0.0, 0.5), (2, 0.75, 1.0), (7, 0.0, 1.0)]);
        assert_eq!([1, 2, 7, 9].map(|edge| all.on(EdgeId::new(edge)).len()), [0, 2, 1, 0]);
        assert!((all.length_px() - 17.5).abs() < 1e-12);
    }

    #[test]
    fn only_what_both_cover_overlaps() {
        let one = stretches(&[(2, 0.0, 0.5), (2, 0.75, 1.0), (7, 0.0, 1.0)]);
        let other = stretches(&[(2, 0.25, 0.875), (8, 0.0, 1.0)]);
        for (one, other) in [(&one, &other), (&other, &one)] {
            assert!((one.overlap_px(other) - 3.75).abs() < 1e-12);
        }
        assert!((one.overlap_px(&one) - one.length_px()).abs() < 1e-12);
    }

    #[test]
    fn parameters_are_exact_at_the_ends() {
        let ends = [DVec3::new(0.1, 0.2, 0.3), DVec3::new(0.7, -0.9, 0.3)];
        assert_eq!(ends.map(|end| parameter(ends, end).to_bits()), [0.0, 1.0].map(f64::to_bits));
        assert!((parameter(ends, ends[0].lerp(ends[1], 0.3)) - 0.3).abs() < 1e-12);
    }
}
