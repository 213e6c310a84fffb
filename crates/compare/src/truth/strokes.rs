//! The silhouette as connected, oriented lines.

use silhouette_core::loops::start_vertex;
use silhouette_core::{EdgeId, HalfEdgeId, SilhouetteLoops, Topology, TriangleMesh, VertexId};
use std::collections::HashSet;

/// An edge with the direction in which it is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Segment {
    /// The edge.
    pub edge: EdgeId,
    /// Its end points, a front face on the left of the way from the first to the second.
    pub ends: [VertexId; 2],
}

/// Segments of which each begins where the one before ended.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Stroke {
    /// The segments in order, at least one.
    pub segments: Vec<Segment>,
    /// Whether the last segment ends where the first begins.
    pub closed: bool,
}

/// Strokes along `loops` that hold each silhouette edge once.
///
/// On a consistently wound manifold mesh a stroke is a loop. Elsewhere a loop is parted where its half-edges do not
/// connect, and where it comes to an edge that was drawn before (a non-manifold edge may have two front faces). O(S).
///
/// # Panics
/// If the three are not of one mesh.
pub fn strokes(mesh: &TriangleMesh, topology: &Topology, loops: &SilhouetteLoops) -> Vec<Stroke> {
    let mut drawn = HashSet::new();
    let mut strokes = Vec::new();
    for half_edges in loops.iter() {
        let mut parts: Vec<Stroke> = Vec::new();
        for &half_edge in half_edges {
            let segment = segment(mesh, topology, half_edge);
            if !drawn.insert(segment.edge) {
                continue;
            }
            match parts.last_mut() {
                Some(stroke) if connects(stroke, segment) => stroke.segments.push(segment),
                _ => parts.push(Stroke { segments: vec![segment], closed: false }),
            }
        }
        if let [whole] = &mut parts[..] {
            whole.closed = whole.segments.len() > 1 && connects(whole, whole.segments[0]);
        }
        strokes.append(&mut parts);
    }
    strokes
}

fn segment(mesh: &TriangleMesh, topology: &Topology, half_edge: HalfEdgeId) -> Segment {
    let ends = [start_vertex(mesh, half_edge), start_vertex(mesh, half_edge.next_in_face())];
    Segment { edge: topology.edge_of(half_edge), ends }
}

fn connects(stroke: &Stroke, next: Segment) -> bool {
    stroke.segments.last().is_some_and(|last| last.ends[1] == next.ends[0])
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use silhouette_core::glam::Vec3;
    use silhouette_core::loops::LoopWalker;
    use silhouette_core::{FaceFacings, SilhouetteEdges};

    fn strokes_of(triangles: Vec<[u32; 3]>, front: &[bool]) -> (Vec<Stroke>, SilhouetteEdges) {
        let positions = (0..12).map(|i| Vec3::new(i as f32, (i * i) as f32, 0.0)).collect();
        let mesh = TriangleMesh::new(positions, triangles).unwrap();
        let topology = Topology::new(&mesh);
        let facings = FaceFacings::from_fn(mesh.face_count(), |face| front[face.index()]);
        let edges = SilhouetteEdges::of(&topology, &facings);
        let mut loops = SilhouetteLoops::default();
        LoopWalker::default().walk(&topology, &facings, &edges, &mut loops);
        (strokes(&mesh, &topology, &loops), edges)
    }

    #[test]
    fn a_square_is_one_closed_stroke() {
        let (strokes, _) = strokes_of(vec![[0, 1, 2], [0, 2, 3]], &[true, true]);
        assert_eq!((strokes.len(), strokes[0].segments.len(), strokes[0].closed), (1, 4, true));
    }

    #[test]
    fn inconsistent_winding_parts_a_loop() {
        let (strokes, _) = strokes_of(vec![[0, 1, 2], [0, 3, 2]], &[true, true]);
        assert!(strokes.iter().all(|stroke| !stroke.closed), "{strokes:?}");
    }

    proptest! {
        #[test]
        fn strokes_hold_every_silhouette_edge_once_and_hang_together(
            triangles in prop::collection::vec(prop::array::uniform3(0_u32..12), 1..20),
            front in prop::collection::vec(any::<bool>(), 20),
        ) {
            let (strokes, edges) = strokes_of(triangles, &front);
            let mut drawn: Vec<EdgeId> =
                strokes.iter().flat_map(|stroke| &stroke.segments).map(|segment| segment.edge).collect();
            drawn.sort_unstable();
            prop_assert_eq!(&drawn[..], edges.as_slice());
            for stroke in &strokes {
                prop_assert!(stroke.segments.windows(2).all(|pair| pair[0].ends[1] == pair[1].ends[0]));
                if stroke.closed {
                    prop_assert_eq!(stroke.segments[0].ends[0], stroke.segments[stroke.segments.len() - 1].ends[1]);
                }
            }
        }
    }
}
