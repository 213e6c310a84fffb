//! `--measure`, without a display.

use crate::stage::viewer;
use egui_kittest::Harness;
use silhouette_testing::shared_gpu_or_skip;
use silhouette_viewer::viewer::{Outcome, Start};
use silhouettes::application::Failure;
use std::time::{Duration, Instant};

/// Runs a window until its measurement ends.
fn outcome(test: &str, mesh: &str) -> Option<Result<String, Failure>> {
    let gpu = shared_gpu_or_skip(test)?;
    let builder = Harness::builder().wgpu_setup(silhouette_viewer::setup(gpu));
    let mut window = builder.build_eframe(|context| {
        let measure = Some(Duration::from_millis(400));
        viewer(context, gpu, mesh, &["brute-force"], |start| Start { measure, ..start })
    });
    let outcome: Outcome = window.state().outcome();
    let begin = Instant::now();
    loop {
        window.step();
        if let Some(outcome) = outcome.lock().unwrap().take() {
            return Some(outcome);
        }
        assert!(begin.elapsed() < Duration::from_secs(120), "it does not end");
    }
}

#[test]
fn a_measurement_moves_the_eye_and_reports_every_stretch_and_the_method() {
    let Some(outcome) = outcome("a_measurement_moves_the_eye", "builtin:gear") else { return };
    let report = outcome.unwrap();
    let begins = ["builtin:gear, ", "start: ", "preparing: ", "first picture: ", "orbit: ", "brute-force: "];
    assert_eq!(report.lines().count(), begins.len(), "{report}");
    assert!(report.lines().zip(begins).all(|(line, begin)| line.starts_with(begin)), "{report}");
    let rate = report.lines().last().unwrap().split([' ', ',']).nth(1).unwrap().parse::<f64>().unwrap();
    assert!(rate > 0.0, "{report}");
}

#[test]
fn a_mesh_that_cannot_be_read_ends_a_measurement() {
    let Some(outcome) = outcome("a_mesh_that_cannot_be_read_ends_a_measurement", "missing.obj") else { return };
    assert!(outcome.unwrap_err().to_string().contains("missing.obj"));
}
