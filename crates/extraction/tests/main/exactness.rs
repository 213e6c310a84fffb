use proptest::prelude::*;
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::method::ExtractionStats;
use silhouette_core::{ExtractsEdges, Method, PreparedMesh, SilhouetteEdges, TriangleMesh, Viewpoint};
use silhouette_extraction::{BruteForce, BruteForceSimd, ClusterCones};
use silhouette_testing::edits::{keeping, transformed};
use silhouette_testing::prepare::{method, prepared};
use silhouette_testing::strategies::{lattice_viewpoint, soup};
use silhouette_testing::views::{hard_viewpoints, seen_from};
use silhouette_testing::{builtin, with_threads, zoo};
use std::sync::Arc;

/// Every exact method of the crate, and all views through the same instances, so that nothing may linger.
fn check(name: &str, mesh: TriangleMesh, views: &[Viewpoint]) {
    let mesh = prepared(mesh);
    let mut oracle: BruteForce = method(&mesh);
    let mut simd: BruteForceSimd = method(&mesh);
    let mut cones: ClusterCones = method(&mesh);
    let methods: [(&str, &mut dyn ExtractsEdges); 2] =
        [(BruteForceSimd::INFO.name, &mut simd), (ClusterCones::INFO.name, &mut cones)];
    let (mut expected, mut found) = (SilhouetteEdges::default(), SilhouetteEdges::default());
    for (method, extractor) in methods {
        for view in views {
            oracle.extract_edges(view, &mut expected);
            extractor.extract_edges(view, &mut found);
            assert_eq!(found, expected, "{method} on {name} from {view:?}");
        }
    }
}

#[test]
fn hard_viewpoints_at_every_scale_and_offset() {
    for (name, mesh) in zoo::all() {
        for scale in [1e-9, 1.0, 1e9] {
            let moved = transformed(&mesh, scale, DVec3::ZERO);
            let views = hard_viewpoints(&moved, 12);
            check(&format!("{name} x {scale:e}"), moved, &views);
        }
        for offset in [1.0, 1e3, 1e6] {
            let moved = transformed(&mesh, 1.0, DVec3::new(offset, -2.0 * offset, offset * 0.5));
            let views = hard_viewpoints(&moved, 12);
            check(&format!("{name} + {offset:e}"), moved, &views);
        }
    }
}

#[test]
fn invalid_views_are_alike_to_every_method() {
    let bad = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY].map(Vec3::splat);
    let mut views: Vec<_> = bad.into_iter().map(seen_from).collect();
    views.push(seen_from([f32::INFINITY, 0.0, 1.0]));
    views.push(seen_from(Vec3::splat(f32::MAX)));
    views.push(Viewpoint::Orthographic { toward_viewer: Vec3::ZERO });
    views.push(Viewpoint::Orthographic { toward_viewer: Vec3::splat(f32::from_bits(1)) });
    for (name, mesh) in zoo::all() {
        check(name, mesh, &views);
    }
    check("empty", zoo::empty(), &views);
}

#[test]
fn coordinates_at_both_ends_of_f32() {
    let (huge, tiny) = (1e38, f32::from_bits(3));
    for size in [huge, tiny] {
        let positions = [Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z].map(|p| p * size).to_vec();
        let mesh = TriangleMesh::new(positions, vec![[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]).unwrap();
        let views = hard_viewpoints(&mesh, 20);
        check("tetrahedron", mesh, &views);
    }
}

#[test]
fn a_fan_of_a_thousand_faces_at_one_edge() {
    let turn = |i: u32| f64::from(i) * std::f64::consts::TAU / 1000.0;
    let rim = (0..1000).map(|i| DVec3::new(turn(i).cos(), turn(i).sin(), 0.5).as_vec3());
    let positions = [Vec3::ZERO, Vec3::Z].into_iter().chain(rim).collect();
    let mesh = TriangleMesh::new(positions, (0..1000).map(|i| [0, 1, i + 2]).collect()).unwrap();
    let views = hard_viewpoints(&mesh, 10);
    check("fan", mesh, &views);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn any_soup(mesh in soup(150), views in prop::collection::vec(lattice_viewpoint(4), 1..20)) {
        check("soup", mesh, &views);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    /// Enough patches for a tree of several levels, some faces removed so that the mesh is open.
    #[test]
    fn open_meshes_of_many_patches(
        kept in prop::collection::vec(prop::bool::weighted(0.9), 6000),
        eyes in prop::collection::vec(prop::array::uniform3(-2.0_f32..2.0), 8),
    ) {
        let views: Vec<_> = eyes.into_iter().map(seen_from).collect();
        check("open blob", keeping(&builtin("blob:6000"), |face| kept[face]), &views);
    }
}

/// What `M` finds and counts on `threads` threads.
fn extract<M: Method + ExtractsEdges>(mesh: &Arc<PreparedMesh>, threads: usize) -> (SilhouetteEdges, ExtractionStats) {
    let view = seen_from([1.0, 2.0, 3.0]);
    with_threads(threads, || {
        let mut edges = SilhouetteEdges::default();
        let stats = method::<M>(mesh).extract_edges(&view, &mut edges);
        (edges, stats)
    })
}

#[test]
fn any_number_of_threads_gives_the_same_edges_and_counters() {
    let shape = || prepared(builtin("blob:300000"));
    let mesh = shape();
    let all = extract::<BruteForceSimd>(&mesh, 1);
    assert!(all.0.len() > 1000 && all.1.faces_tested > 300_000, "{:?}", all.1);
    let some = extract::<ClusterCones>(&mesh, 1);
    assert!(some.1.nodes_visited > 0 && some.1.faces_tested < 60_000, "{:?}", some.1);
    assert_eq!(some.0, all.0);
    // Built anew, so that the patches and the tree are compared as well.
    let again = shape();
    assert_eq!(extract::<BruteForceSimd>(&again, 3), all);
    assert_eq!(extract::<ClusterCones>(&again, 3), some);
}
