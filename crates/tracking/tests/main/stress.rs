use crate::scenes::{Scene, ordered, real_meshes, zoo};
use proptest::prelude::*;
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::{FaceId, TriangleMesh, Viewpoint};
use silhouette_testing::Random;
use silhouette_testing::strategies::{lattice_viewpoint, soup};
use silhouette_testing::views::{hard_eye, seen_from};
use silhouette_tracking::{Concavity, TestedEdges, TrackerOptions};

/// A view that is hard to get right: far, near, inside, on a vertex, an edge or a face, in a plane, or no view at all;
/// or, half the time, a small step from the last one.
fn next_view(scene: &Scene, random: &mut Random, last: &Viewpoint) -> Viewpoint {
    let bounds = scene.mesh.bounds().unwrap();
    let place = |p: DVec3| seen_from(p.as_vec3());
    let around = |random: &mut Random, radii: f64| place(bounds.center + random.vector() * (radii * bounds.radius));
    match random.below(20) {
        0 => around(random, 1.0),
        1 => around(random, 5.0),
        2 => around(random, 1e7),
        3..=6 => seen_from(hard_eye(&scene.mesh, random)),
        7 => Viewpoint::Orthographic { toward_viewer: random.vector().as_vec3() },
        8 => {
            let [a, b, _] = scene.mesh.corners(FaceId::from_usize(random.below(scene.mesh.face_count())));
            Viewpoint::Orthographic { toward_viewer: b - a }
        }
        9 if random.one_in(8) => seen_from([f32::NAN, f32::INFINITY, 0.0]),
        _ => {
            let step = 10.0_f64.powi(-(random.below(7) as i32)) * bounds.radius;
            match *last {
                Viewpoint::Perspective { eye } => place(eye.as_dvec3() + random.vector() * step),
                Viewpoint::Orthographic { toward_viewer } => {
                    let turned = toward_viewer.as_dvec3() + random.vector() * 0.05;
                    Viewpoint::Orthographic { toward_viewer: turned.as_vec3() }
                }
            }
        }
    }
}

/// Random updates; whatever is found is silhouette, no walk takes more than it may, memory does not grow.
fn stress(scene: &Scene, updates: u32, seed: u64) {
    let mut random = Random::new(seed);
    let mut tracker = scene.tracker(TrackerOptions::default());
    let mut brute_force = scene.brute_force();
    let mut view = seen_from(Vec3::ONE);
    let topology = scene.table.topology();
    let most_steps = 12 * scene.mesh.face_count() as u64;
    let most_half_edges = topology.half_edge_count();
    let mut missed = 0;
    for update in 0..updates {
        view = next_view(scene, &mut random, &view);
        if random.one_in(50) {
            let levels = [Concavity::Above(0.0), Concavity::Above(0.3), Concavity::Ignored];
            tracker.set_concavity(levels[random.below(3)]);
        }
        if random.one_in(300) {
            tracker.reset();
        }
        let found = tracker.update(&view).half_edges().len();
        let stats = *tracker.stats();
        let context = format!("{}, update {update}, {view:?}, {stats:?}", scene.name);
        assert!(stats.walk_steps <= most_steps, "{context}");
        assert!(stats.faces_evaluated <= scene.mesh.face_count() as u64, "{context}");
        // Each half-edge at most once in each of three lists of 4 bytes, ids and events beside them.
        assert!(tracker.bytes() <= 60 * most_half_edges + 4096, "{context}");
        if update % 7 == 0 || stats.brute_force.is_some() {
            let all = ordered(topology, brute_force.update(&view));
            let all: std::collections::BTreeSet<&[_]> = all.iter().collect();
            let found_loops = ordered(topology, tracker.loops());
            assert!(found_loops.iter().all(|half_edges| all.contains(half_edges)), "{context}");
            let complete = found_loops.len() == all.len();
            assert!(complete || stats.brute_force.is_none(), "{context}: {} of {}", found_loops.len(), all.len());
            missed += usize::from(!complete && tracker.options().concavity == Concavity::Above(0.0));
        }
        assert!(found <= most_half_edges);
    }
    assert!(missed <= updates as usize / 100, "{}: {missed} frames of {updates} miss loops at level 0", scene.name);
}

/// Random updates that the normal run makes on each mesh; `SILHOUETTES_STRESS` asks for another number.
fn updates(default: u32) -> u32 {
    std::env::var("SILHOUETTES_STRESS").ok().and_then(|count| count.parse().ok()).unwrap_or(default)
}

#[test]
fn random_updates_of_built_in_shapes() {
    for (seed, scene) in zoo().into_iter().chain([Scene::builtin("moebius")]).enumerate() {
        stress(&scene, updates(500), seed as u64);
    }
}

#[test]
fn random_updates_of_real_meshes() {
    for (seed, scene) in real_meshes("random_updates_of_real_meshes").into_iter().enumerate() {
        stress(&scene, updates(60), 1000 + seed as u64);
    }
}

#[test]
fn a_mesh_without_faces_has_no_silhouette() {
    let scene = Scene::new("empty", TriangleMesh::new(vec![Vec3::ONE], vec![]).unwrap());
    let mut tracker = scene.tracker(TrackerOptions::default());
    for eye in [Vec3::ZERO, Vec3::X, Vec3::NAN] {
        assert!(tracker.update(&seen_from(eye)).is_empty());
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    /// Triangles over few vertices on a coarse grid: every kind of defect, and eyes in most planes.
    #[test]
    fn any_soup(
        mesh in soup(80),
        views in prop::collection::vec(lattice_viewpoint(4), 1..20),
        single in any::<bool>(),
    ) {
        let scene = Scene::new("soup", mesh);
        let tested_edges = if single { TestedEdges::Single } else { TestedEdges::All };
        let mut tracker = scene.tracker(TrackerOptions { tested_edges, jump: 100.0, ..TrackerOptions::default() });
        let mut brute_force = scene.brute_force();
        for view in views {
            let all = ordered(scene.table.topology(), brute_force.update(&view));
            let all: std::collections::BTreeSet<&[_]> = all.iter().collect();
            let found = ordered(scene.table.topology(), tracker.update(&view));
            prop_assert!(found.iter().all(|half_edges| all.contains(half_edges)));
            prop_assert!(tracker.stats().brute_force.is_none() || found.len() == all.len());
        }
    }
}
