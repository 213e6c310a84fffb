use crate::scenes::{Oracle, Scene};
use silhouette_core::HalfEdgeId;
use silhouette_core::glam::Vec3;
use silhouette_testing::builtin;
use silhouette_testing::edits::{joined, moved};
use silhouette_testing::views::seen_from;

fn loops_from(scene: &Scene, eye: [f32; 3]) -> usize {
    Oracle::default().look(&scene.mesh, scene.table.topology(), &seen_from(eye)).len()
}

/// Hall: at most one silhouette for a convex model, at most 1 + C for one with C concave edges. The first holds for one
/// closed mesh, seen from outside; the second fails for several.
#[test]
fn two_spheres_have_more_silhouettes_than_one_and_their_concave_edges() {
    let sphere = builtin("icosphere:3");
    let one = Scene::new("sphere", sphere.clone());
    assert_eq!(one.edges.concave().len(), 0);
    assert_eq!([loops_from(&one, [3.0, 1.0, 0.5]), loops_from(&one, [0.1, 0.0, 0.0])], [1, 0], "outside, inside");
    let two = Scene::new("two spheres", joined(&[&sphere, &moved(&sphere, Vec3::new(3.0, 0.0, 0.0))]));
    assert_eq!(two.edges.concave().len(), 0);
    assert_eq!(loops_from(&two, [1.5, 5.0, 0.3]), 2);
}

/// Hall: one convex loop at most. A torus seen along its axis has two, and neither holds a concave edge.
#[test]
fn a_torus_seen_along_its_axis_has_two_silhouettes_without_a_concave_edge() {
    let scene = Scene::builtin("torus:48,32");
    let view = seen_from([0.003, 9.0, 0.001]);
    let mut oracle = Oracle::default();
    let loops = oracle.look(&scene.mesh, scene.table.topology(), &view);
    let is_concave =
        |half_edge: &HalfEdgeId| scene.edges.concave().iter().any(|concave| concave.half_edges.contains(half_edge));
    let concave_edges = |half_edges: &[HalfEdgeId]| half_edges.iter().filter(|half_edge| is_concave(half_edge)).count();
    assert_eq!(loops.iter().map(concave_edges).collect::<Vec<_>>(), [0, 0]);
    assert!(!scene.edges.concave().is_empty(), "the inside of the ring is concave");
}
