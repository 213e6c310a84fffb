//! The silhouette is the cut between front and back faces: what follows from that alone, for any view and even for random
//! labels.

use crate::seen::look;
use glam::{DVec3, Vec3};
use proptest::prelude::*;
use silhouette_core::loops::{LoopWalker, start_vertex};
use silhouette_core::{FaceFacings, FaceId, HalfEdgeId, SilhouetteEdges, SilhouetteLoops, Topology, TriangleMesh};
use silhouette_testing::directions::spread;
use silhouette_testing::edits::inside_out;
use silhouette_testing::views::{seen_from, seen_from_radii};
use silhouette_testing::{builtin, real_meshes, strategies, zoo};
use std::collections::{BTreeMap, BTreeSet};

/// Vertices of a half-edge: where it starts, where it ends.
fn ends(mesh: &TriangleMesh, half_edge: HalfEdgeId) -> [u32; 2] {
    [half_edge, half_edge.next_in_face()].map(|h| start_vertex(mesh, h).get())
}

/// Loops partition the silhouette half-edges; on a consistently wound mesh consecutive ones meet.
fn check_loops(mesh: &TriangleMesh, topology: &Topology, facings: &FaceFacings, wound: bool) {
    let edges = SilhouetteEdges::of(topology, facings);
    let mut loops = SilhouetteLoops::default();
    LoopWalker::default().walk(topology, facings, &edges, &mut loops);
    let mut by_edges = SilhouetteLoops::default();
    LoopWalker::default().walk_complete(topology, |face| facings.is_front(face), &edges, &mut by_edges);
    assert_eq!(by_edges, loops, "by the bit of each edge as by facings");
    let expected: BTreeSet<_> = edges
        .iter()
        .flat_map(|edge| topology.half_edges(edge).iter().copied())
        .filter(|half_edge| facings.is_front(half_edge.face()))
        .collect();
    let walked: BTreeSet<_> = loops.half_edges().iter().copied().collect();
    assert_eq!(walked.len(), loops.half_edges().len(), "no half-edge twice");
    assert_eq!(walked, expected);
    for half_edges in loops.iter() {
        let next = half_edges.iter().cycle().skip(1);
        for (&half_edge, &next) in half_edges.iter().zip(next) {
            assert!(!wound || ends(mesh, half_edge)[1] == ends(mesh, next)[0], "{half_edge:?} then {next:?}");
        }
    }
}

/// How often each vertex ends a silhouette edge.
fn degrees(topology: &Topology, edges: &SilhouetteEdges) -> BTreeMap<u32, usize> {
    let mut degrees = BTreeMap::new();
    for vertex in edges.iter().flat_map(|edge| topology.end_points(edge)) {
        *degrees.entry(vertex.get()).or_default() += 1;
    }
    degrees
}

/// V - E + F of the closed region that some faces cover.
fn euler_characteristic(mesh: &TriangleMesh, faces: impl Iterator<Item = usize>) -> i64 {
    let (mut vertices, mut edges, mut count) = (BTreeSet::new(), BTreeSet::new(), 0);
    for [a, b, c] in faces.map(|face| mesh.triangles()[face]) {
        vertices.extend([a, b, c]);
        edges.extend([(a, b), (b, c), (c, a)].map(|(a, b)| (a.min(b), a.max(b))));
        count += 1;
    }
    vertices.len() as i64 - edges.len() as i64 + count
}

proptest! {
    #[test]
    fn every_vertex_of_a_closed_mesh_has_even_degree(mesh in strategies::closed_mesh(), viewpoint in strategies::viewpoint()) {
        let seen = look(&mesh, &viewpoint);
        prop_assert!(degrees(&seen.topology, &seen.edges).values().all(|degree| degree % 2 == 0));
        check_loops(&mesh, &seen.topology, &seen.facings, true);
    }

    #[test]
    fn boundary_edges_keep_the_degrees_of_open_meshes_even(mesh in strategies::open_mesh(), viewpoint in strategies::viewpoint()) {
        let seen = look(&mesh, &viewpoint);
        prop_assert!(degrees(&seen.topology, &seen.edges).values().all(|degree| degree % 2 == 0));
        check_loops(&mesh, &seen.topology, &seen.facings, true);
    }

    #[test]
    fn random_labels_make_loops_too(mesh in strategies::open_mesh(), labels in any::<u128>()) {
        let facings = FaceFacings::from_fn(mesh.face_count(), |face| labels >> (face.get() % 128) & 1 == 1);
        check_loops(&mesh, &Topology::new(&mesh), &facings, true);
    }

    /// Any triangles over few vertices: non-manifold, inconsistently wound, duplicate and degenerate faces.
    #[test]
    fn any_soup_makes_loops(triangles in prop::collection::vec(prop::array::uniform3(0_u32..9), 0..30), labels in any::<u32>()) {
        let positions = (0..9).map(|i| Vec3::splat(i as f32)).collect();
        let mesh = TriangleMesh::new(positions, triangles).unwrap();
        let facings = FaceFacings::from_fn(mesh.face_count(), |face| labels >> (face.get() % 32) & 1 == 1);
        check_loops(&mesh, &Topology::new(&mesh), &facings, false);
    }

    #[test]
    fn front_and_back_regions_share_the_silhouette(mesh in strategies::closed_mesh(), viewpoint in strategies::viewpoint()) {
        let seen = look(&mesh, &viewpoint);
        let side = |front| {
            let facings = seen.facings.clone();
            let faces = (0..mesh.face_count()).filter(move |&face| facings.is_front(FaceId::from_usize(face)) == front);
            euler_characteristic(&mesh, faces)
        };
        let silhouette = degrees(&seen.topology, &seen.edges).len() as i64 - seen.edges.len() as i64;
        prop_assert_eq!(euler_characteristic(&mesh, 0..mesh.face_count()), side(true) + side(false) - silhouette);
    }

    #[test]
    fn turning_the_mesh_inside_out_keeps_the_edges(mesh in strategies::closed_mesh(), viewpoint in strategies::viewpoint()) {
        let (seen, turned) = (look(&mesh, &viewpoint), look(&inside_out(&mesh), &viewpoint));
        let ties = seen.facings.front_count() + turned.facings.front_count() != mesh.face_count();
        prop_assume!(!ties);
        prop_assert_eq!(seen.edges, turned.edges);
    }
}

#[test]
fn a_convex_body_has_one_loop_from_outside_and_none_from_inside() {
    for name in ["cube", "icosphere:3", "uv-sphere", "ellipsoid", "cylinder", "cone"] {
        let mesh = builtin(name);
        for direction in spread(50).map(DVec3::as_vec3) {
            let outside = look(&mesh, &seen_from(direction * 7.3));
            assert_eq!(outside.loops.len(), 1, "{name} from {direction}");
            let inside = look(&mesh, &seen_from(direction * 0.05));
            assert_eq!(inside.loops.len(), 0, "{name} from inside");
        }
    }
}

#[test]
fn one_triangle_is_outlined_from_the_front_only() {
    let mesh = TriangleMesh::new(vec![Vec3::ZERO, Vec3::X, Vec3::Y], vec![[0, 1, 2]]).unwrap();
    let from = |z| look(&mesh, &seen_from([0.2, 0.2, z]));
    assert_eq!((from(1.0).edges.len(), from(1.0).loops.len()), (3, 1));
    assert_eq!(from(1.0).edges.boundary(&from(1.0).topology).count(), 3);
    assert!(from(-1.0).edges.is_empty() && from(0.0).edges.is_empty());
    assert!(look(&zoo::empty(), &seen_from(Vec3::Z)).loops.is_empty());
}

#[test]
fn built_in_and_real_meshes_make_loops() {
    let real = real_meshes("built_in_and_real_meshes_make_loops").map(|(_, mesh)| mesh);
    for mesh in zoo::all().into_iter().map(|(_, mesh)| mesh).chain(real) {
        let topology = Topology::new(&mesh);
        for direction in spread(3) {
            let facings = FaceFacings::new(&mesh, &seen_from_radii(&mesh, direction, 3.0));
            check_loops(&mesh, &topology, &facings, false);
        }
    }
}
