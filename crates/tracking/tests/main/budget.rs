use crate::scenes::{Oracle, Scene};
use silhouette_core::{SilhouetteLoops, TriangleMesh};
use silhouette_testing::edges::half_edge_ends;
use silhouette_tracking::{Accuracy, Concavity, ErrorBudget, TrackerOptions};

fn length(mesh: &TriangleMesh, loops: &SilhouetteLoops) -> f64 {
    let length = |&half_edge| {
        let [from, to] = half_edge_ends(mesh, half_edge);
        from.distance(to)
    };
    loops.half_edges().iter().map(length).sum()
}

/// Mean share of length that a tracker misses over an orbit, and mean share of faces that it evaluates.
fn missed_and_evaluated(scene: &Scene, options: TrackerOptions, frames: u32) -> [f64; 2] {
    let mut tracker = scene.tracker(options);
    let mut oracle = Oracle::default();
    let (mut missed, mut evaluated) = (0.0, 0.0);
    for view in scene.orbit(0.5, frames) {
        let whole = length(&scene.mesh, oracle.look(&scene.mesh, scene.table.topology(), &view));
        let found = length(&scene.mesh, tracker.update(&view));
        let share = 1.0 - found / whole;
        if tracker.stats().audited {
            assert!(share.abs() < 1e-9, "an audited frame misses {share}");
        }
        missed += share;
        evaluated += tracker.stats().faces_evaluated as f64 / scene.mesh.face_count() as f64;
    }
    [missed, evaluated].map(|sum| sum / f64::from(frames))
}

fn budget(missed_share: f32) -> TrackerOptions {
    let accuracy = Accuracy::Budget(ErrorBudget { missed_share, audit_share: 0.1 });
    TrackerOptions { accuracy, ..TrackerOptions::default() }
}

#[test]
fn missed_length_stays_within_the_budget_and_saves_work() {
    let scene = Scene::builtin("blob:8000,0.6");
    let level = |concavity| missed_and_evaluated(&scene, TrackerOptions { concavity, ..Default::default() }, 1500);
    let [missed_at_0, evaluated_at_0] = level(Concavity::Above(0.0));
    let [missed_unsearched, evaluated_unsearched] = level(Concavity::Ignored);
    assert!(missed_at_0.abs() < 1e-12);
    let [tight_missed, tight_evaluated] = missed_and_evaluated(&scene, budget(0.002), 1500);
    let [loose_missed, loose_evaluated] = missed_and_evaluated(&scene, budget(0.05), 1500);
    assert!(tight_missed <= 0.002 && loose_missed <= 0.05, "missed {tight_missed} and {loose_missed}");
    // Without a search this mesh would break the tight budget, so that keeping it took work.
    assert!(missed_unsearched > 0.004, "{missed_unsearched}");
    assert!(loose_evaluated <= tight_evaluated && tight_evaluated < 1.2 * evaluated_at_0);
    assert!(loose_evaluated < 0.8 * evaluated_at_0, "{loose_evaluated} of {evaluated_at_0}, {evaluated_unsearched}");
}
