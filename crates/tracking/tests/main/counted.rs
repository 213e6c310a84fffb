use crate::scenes::{Scene, options};
use silhouette_core::glam::DVec3;
use silhouette_tracking::TestedEdges;

/// Speed-up counted in faces: all of them over those that a frame evaluates, over one flight around the mesh, 3 radii away
/// and level with it, in steps of 0.1 degrees whose first frame is found by brute force and not counted. What the paper
/// prints is set beside such counts in `silhouette-papers`.
fn counted(scene: &Scene, level_rad: f32, frames: u32) -> f64 {
    let mut tracker = scene.tracker(options(level_rad, TestedEdges::All));
    let mut evaluated = 0;
    for frame in 0..=frames {
        let (sin, cos) = (24.0 + 0.1 * f64::from(frame)).to_radians().sin_cos();
        tracker.update(&scene.view(DVec3::new(cos, 0.0, sin), 3.0));
        assert_eq!(tracker.stats().brute_force.is_some(), frame == 0);
        evaluated += if frame > 0 { tracker.stats().faces_evaluated } else { 0 };
    }
    (scene.mesh.face_count() as u64 * u64::from(frames)) as f64 / evaluated as f64
}

/// Each level evaluates fewer faces than the one below, and brute force all of them.
#[test]
fn higher_levels_evaluate_less() {
    let scene = Scene::builtin("blob:4000");
    let counts = [0.0, 0.01, 0.1, 0.2, 0.5, 1.0].map(|level_rad| counted(&scene, level_rad, 360));
    assert!(counts.is_sorted(), "{counts:?}");
    assert!(counts[0] > 1.05 && counts[5] > 1.5 * counts[0], "{counts:?}");
    let mut brute_force = scene.brute_force();
    brute_force.update(&scene.orbit(0.0, 1).next().unwrap());
    assert_eq!(brute_force.stats().faces_evaluated, 4000);
}
