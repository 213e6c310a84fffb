use crate::scenes::{Scene, options};
use silhouette_core::glam::Vec3;
use silhouette_core::{ExtractsEdges, ExtractsLoops, SilhouetteEdges, SilhouetteLoops};
use silhouette_tracking::{Accuracy, Concavity, ErrorBudget, TestedEdges, TrackerOptions, Tracking};

#[test]
fn a_steady_frame_allocates_nothing() {
    for name in ["blob:5000", "torus:40,24", "grid:20,14"] {
        let scene = Scene::builtin(name);
        let views: Vec<_> = scene.orbit(1.0, 360).collect();
        let budget = ErrorBudget { missed_share: 0.01, audit_share: 0.2 };
        let by_accuracy = |accuracy| TrackerOptions { accuracy, ..TrackerOptions::default() };
        for options in [
            options(0.05, TestedEdges::All),
            options(0.05, TestedEdges::Single),
            by_accuracy(Accuracy::Exact),
            by_accuracy(Accuracy::Budget(budget)),
        ] {
            let mut method = Tracking::from(scene.tracker(options));
            let (mut edges, mut loops) = (SilhouetteEdges::default(), SilhouetteLoops::default());
            let mut brute_force = scene.brute_force();
            let mut fly = || {
                for (frame, view) in views.iter().enumerate() {
                    if frame % 2 == 0 {
                        method.extract_edges(view, &mut edges);
                    } else {
                        method.extract_loops(view, &mut loops);
                    }
                    let level_rad = if frame % 5 == 0 { 0.0 } else { 0.05 };
                    method.tracker_mut().set_concavity(Concavity::Above(level_rad));
                    brute_force.update(view);
                }
            };
            let counts = [0, 1, 2].map(|_| allocation_counter::measure(&mut fly).count_total);
            assert!(counts[0] > 0, "the counter counts");
            assert_eq!(counts[2], 0, "{name}, {options:?}: buffers have grown after two turns, {counts:?}");
        }
    }
}

#[test]
fn moving_a_mesh_again_allocates_nothing() {
    let scene = Scene::builtin("blob:3000");
    let mut tracker = scene.tracker(options(0.0, TestedEdges::All));
    let shapes = [1.0, 1.3, 0.7].map(|stretch| -> Vec<_> {
        let stretched = |p: &Vec3| p.with_y(p.y * stretch);
        scene.mesh.positions().iter().map(stretched).collect()
    });
    let view = scene.orbit(0.0, 1).next().unwrap();
    let mut play = || {
        for positions in &shapes {
            tracker.move_mesh(positions).unwrap();
            tracker.update(&view);
        }
    };
    let counts = [0, 1, 2].map(|_| allocation_counter::measure(&mut play).count_total);
    assert!(counts[0] > 0, "the counter counts");
    assert_eq!(counts[2], 0, "{counts:?}");
}
