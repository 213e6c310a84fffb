use crate::scenes::{Oracle, Scene, ordered, real_meshes, zoo};
use silhouette_core::glam::{DVec3, Quat, Vec3};
use silhouette_core::prepared::Artefact;
use silhouette_core::{ExtractsEdges, FaceId, Method, NoOptions, SilhouetteEdges, Viewpoint};
use silhouette_testing::edits::with_positions;
use silhouette_testing::prepare::prepared;
use silhouette_testing::views::{hard_eye, seen_from};
use silhouette_testing::{Random, builtin};
use silhouette_tracking::{Accuracy, BruteForceReason, ExactTracking, TrackedEdges, TrackerOptions};

fn exact() -> TrackerOptions {
    TrackerOptions { accuracy: Accuracy::Exact, ..TrackerOptions::default() }
}

/// Around, in through the surface and out again, a walk without aim, and a turn of parallel views.
fn paths(scene: &Scene, frames: u32) -> Vec<(&'static str, Vec<Viewpoint>)> {
    let bounds = scene.mesh.bounds().unwrap();
    let dolly = |frame: u32| {
        let way = f64::from(frame) / f64::from(frames) * 2.0 - 1.0;
        scene.view(DVec3::new(0.3, 0.5, 1.0), if way == 0.0 { 1e-3 } else { 2.5 * way })
    };
    let mut random = Random::new(frames.into());
    let mut at = bounds.center + DVec3::new(0.9, 1.1, -0.8) * bounds.radius;
    let mut walk = |_| {
        at += random.vector() * (0.02 * bounds.radius);
        seen_from(at.as_vec3())
    };
    let parallel = |frame: u32| {
        let (sin, cos) = (f64::from(frame) * 0.004).sin_cos();
        let length = 1.0 + 0.5 * f64::from(frame % 7);
        Viewpoint::Orthographic { toward_viewer: (DVec3::new(cos, 0.4, sin) * length).as_vec3() }
    };
    vec![
        ("orbit of 0.1 degrees", scene.orbit(0.1, frames).collect()),
        ("orbit of 1 degree", scene.orbit(1.0, frames).collect()),
        ("orbit of 10 degrees", scene.orbit(10.0, frames / 4).collect()),
        ("dolly", (0..frames).map(dolly).collect()),
        ("random walk", (0..frames).map(&mut walk).collect()),
        ("parallel", (0..frames).map(parallel).collect()),
    ]
}

/// Every frame of every path must have the oracle's loops. Meshes with defects are cut, so that what they are compared with
/// is cut too.
fn equals_brute_force(scene: &Scene, frames: u32) {
    let mut oracle = Oracle::default();
    let topology = scene.table.topology();
    for (name, views) in paths(scene, frames) {
        let mut tracker = scene.tracker(exact());
        for (frame, view) in views.iter().enumerate() {
            let expected = oracle.look(&scene.mesh, topology, view);
            let found = ordered(topology, tracker.update(view));
            assert!(found == *expected, "{}, {name}, frame {frame}, {view:?}", scene.name);
            assert_eq!(tracker.ids().len(), found.len());
            let reason = tracker.stats().brute_force;
            assert_eq!(reason, (frame == 0).then_some(BruteForceReason::FirstFrame), "{}, {name}", scene.name);
        }
    }
}

/// Frames per path: few unless `SILHOUETTES_EXACT_FRAMES` says how many.
fn frames(few: u32) -> u32 {
    std::env::var("SILHOUETTES_EXACT_FRAMES").map_or(few, |frames| frames.parse().expect("a number of frames"))
}

#[test]
fn no_loop_is_missed_on_built_in_shapes() {
    for scene in zoo() {
        equals_brute_force(&scene, frames(400));
    }
}

#[test]
fn no_loop_is_missed_on_real_meshes() {
    for scene in real_meshes("no_loop_is_missed_on_real_meshes") {
        equals_brute_force(&scene, frames(if scene.mesh.face_count() < 15_000 { 200 } else { 40 }));
    }
}

/// Jumps anywhere: inside, onto vertices, into planes of faces, to eyes that are not finite, between kinds of view.
#[test]
fn any_view_may_follow_any_other() {
    for scene in zoo() {
        let mut tracker = scene.tracker(exact());
        let mut oracle = Oracle::default();
        let mut random = Random::new(scene.mesh.face_count() as u64);
        let (center, radius) = scene.mesh.bounds().map(|bounds| (bounds.center, bounds.radius)).unwrap();
        for frame in 0..120 {
            let view = match random.below(6) {
                0 => seen_from((center + random.vector() * radius).as_vec3()),
                1 | 2 => seen_from(hard_eye(&scene.mesh, &mut random)),
                3 => {
                    let [a, b, _] = scene.mesh.corners(FaceId::from_usize(random.below(scene.mesh.face_count())));
                    Viewpoint::Orthographic { toward_viewer: b - a }
                }
                4 => seen_from([f32::NAN, 0.0, f32::INFINITY]),
                _ => Viewpoint::Orthographic { toward_viewer: random.vector().as_vec3() },
            };
            let topology = scene.table.topology();
            let expected = oracle.look(&scene.mesh, topology, &view);
            assert!(ordered(topology, tracker.update(&view)) == *expected, "{}, frame {frame}, {view:?}", scene.name);
        }
    }
}

#[test]
fn a_frame_costs_what_changes() {
    let scene = Scene::builtin("blob:20000");
    let mut tracker = scene.tracker(exact());
    let mut shares = Vec::new();
    for view in scene.orbit(0.1, 200) {
        tracker.update(&view);
        shares.push(tracker.stats().faces_evaluated as f64 / scene.mesh.face_count() as f64);
        tracker.update(&view);
        assert_eq!((tracker.stats().faces_evaluated, tracker.stats().walks), (0, 0), "the eye rests");
        assert!(tracker.events().is_empty());
    }
    assert!(shares[0] > 0.999, "the first frame looks at every face");
    let mean = shares[1..].iter().sum::<f64>() / 199.0;
    assert!((0.001..0.05).contains(&mean), "{mean} of the faces per frame");
}

/// A mesh that is turned before a resting eye is seen as if the eye had gone around it.
#[test]
fn a_moving_mesh_is_followed() {
    let scene = Scene::builtin("blob:3000");
    let mut tracker = scene.tracker(exact());
    let mut oracle = Oracle::default();
    let view = scene.view(DVec3::new(0.2, 0.3, 1.0), 3.0);
    for frame in 0..30 {
        let turn = Quat::from_rotation_y(frame as f32 * 0.05);
        let positions: Vec<Vec3> = scene.mesh.positions().iter().map(|&position| turn * position).collect();
        tracker.move_mesh(&positions).unwrap();
        let mesh = with_positions(&scene.mesh, positions);
        let topology = scene.table.topology();
        let expected = oracle.look(&mesh, topology, &view);
        assert!(ordered(topology, tracker.update(&view)) == *expected, "frame {frame}");
    }
}

/// The exact mode finds no concave edges, and needs none.
#[test]
fn the_method_prepares_no_more_than_it_says() {
    let mesh = prepared(builtin("blob:1000"));
    let mut method = ExactTracking::new(&mesh, NoOptions).unwrap();
    let mut edges = SilhouetteEdges::default();
    method.extract_edges(&seen_from([3.0, 1.0, 0.0]), &mut edges);
    assert!(!edges.is_empty());
    let built: Vec<_> = mesh.report().iter().map(|artefact| artefact.name).collect();
    assert!(ExactTracking::INFO.needs.iter().all(|need| built.contains(need)), "{built:?}");
    assert!(!built.contains(&TrackedEdges::NAME), "{built:?}");
}
