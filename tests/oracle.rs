//! Every extractor against a naive evaluation that shares no code with any: maps of vertex pairs, integer arithmetic.

use glam::Vec3;
use proptest::prelude::*;
use silhouette_compare::registry::Registry;
use silhouette_core::method::{OptionValues, PrepareError};
use silhouette_core::{NoProgress, SilhouetteEdges, Topology, TriangleMesh, VertexId, Viewpoint};
use silhouette_testing::prepare::{artefact, prepared};
use silhouette_testing::views::seen_from;
use silhouette_testing::zoo;
use std::collections::BTreeMap;
use std::sync::Arc;

type Integers = [i128; 3];

fn sub(a: Integers, b: Integers) -> Integers {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn determinant(a: Integers, b: Integers, c: Integers) -> i128 {
    c[0] * (a[1] * b[2] - a[2] * b[1]) + c[1] * (a[2] * b[0] - a[0] * b[2]) + c[2] * (a[0] * b[1] - a[1] * b[0])
}

/// All silhouette edges, and the boundary ones among them, of triangles over integer points.
fn naive(points: &[Integers], triangles: &[[u32; 3]], viewpoint: Integers, is_point: bool) -> [Vec<[u32; 2]>; 2] {
    let mut sides = BTreeMap::<[u32; 2], Vec<bool>>::new();
    for &[a, b, c] in triangles {
        let [p, q, r] = [a, b, c].map(|v| points[v as usize]);
        let toward_viewer = if is_point { sub(viewpoint, p) } else { viewpoint };
        let front = determinant(sub(q, p), sub(r, p), toward_viewer) > 0;
        for (v, w) in [(a, b), (b, c), (c, a)] {
            sides.entry([v.min(w), v.max(w)]).or_default().push(front);
        }
    }
    let of = |wanted: fn(&[bool]) -> bool| sides.iter().filter(|(_, s)| wanted(s)).map(|(&edge, _)| edge).collect();
    [of(|s| if s.len() == 1 { s[0] } else { s.contains(&true) && s.contains(&false) }), of(|s| s == [true])]
}

fn check(points: &[[i32; 3]], triangles: &[[u32; 3]], viewpoint: [i32; 3]) {
    let float = |p: [i32; 3]| Vec3::from(p.map(|c| c as f32));
    let mesh = TriangleMesh::new(points.iter().copied().map(float).collect(), triangles.to_vec()).unwrap();
    let prepared = prepared(mesh);
    let topology: Arc<Topology> = artefact(&prepared);
    let integers: Vec<Integers> = points.iter().map(|p| p.map(i128::from)).collect();
    for entry in Registry::builtin().entries().iter().filter(|entry| entry.capabilities().edges) {
        let info = entry.info();
        let method = match entry.prepare(&prepared, &OptionValues::defaults(info.options), &NoProgress) {
            Ok(prepared) => prepared.into_edges(),
            // Not defined for this mesh.
            Err(PrepareError::Mesh(_)) => continue,
            Err(error) => panic!("{}: {error}", info.name),
        };
        let Some(mut method) = method else { continue };
        for is_point in [true, false] {
            let view = if is_point {
                seen_from(float(viewpoint))
            } else {
                Viewpoint::Orthographic { toward_viewer: float(viewpoint) }
            };
            let mut edges = SilhouetteEdges::default();
            method.extract_edges(&view, &mut edges);
            let pairs = |edge| topology.end_points(edge).map(VertexId::get);
            let found = [edges.iter().map(pairs).collect::<Vec<_>>(), edges.boundary(&topology).map(pairs).collect()];
            let expected = naive(&integers, triangles, viewpoint.map(i128::from), is_point);
            if info.exact {
                assert_eq!(found, expected, "{} {view:?}", info.name);
            } else {
                let no_others = found.iter().zip(&expected).all(|(f, e)| f.iter().all(|edge| e.contains(edge)));
                assert!(no_others, "{} {view:?}: {found:?} is no part of {expected:?}", info.name);
            }
        }
    }
}

fn points(range: i32, count: usize) -> impl Strategy<Value = Vec<[i32; 3]>> {
    prop::collection::vec(prop::array::uniform3(-range..=range), count)
}

proptest! {
    #[test]
    fn soups_of_few_distinct_coordinates(
        points in points(2, 10),
        triangles in prop::collection::vec(prop::array::uniform3(0_u32..10), 0..40),
        viewpoint in prop::array::uniform3(-3..=3),
    ) {
        check(&points, &triangles, viewpoint);
    }

    #[test]
    fn soups_of_24_bit_coordinates(
        points in points((1 << 24) - 1, 10),
        triangles in prop::collection::vec(prop::array::uniform3(0_u32..10), 0..40),
        viewpoint in prop::array::uniform3(-(1 << 24)..=1 << 24),
    ) {
        check(&points, &triangles, viewpoint);
    }
}

#[test]
fn built_in_shapes_on_an_integer_lattice() {
    for (_, mesh) in zoo::all() {
        let points: Vec<_> =
            mesh.positions().iter().map(|p| (*p * 4000.0).round().to_array().map(|c| c as i32)).collect();
        for viewpoint in [[9000, 4000, 7000], [0, 0, 12_000], [100, 3, -50], [4000, 4000, 4000]] {
            check(&points, mesh.triangles(), viewpoint);
        }
    }
}
