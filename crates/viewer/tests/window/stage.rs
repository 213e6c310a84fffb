//! A window without a display, and what tests do with it.

use eframe::CreationContext;
use eframe::egui::{self, Vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};
use image::RgbaImage;
use silhouette_compare::registry::Registry;
use silhouette_render::Gpu;
use silhouette_testing::shared_gpu_or_skip;
use silhouette_viewer::pane::Choice;
use silhouette_viewer::viewer::{Start, Viewer};
use silhouettes::application::{CameraArguments, MeshArgument};
use std::path::PathBuf;
use std::sync::Arc;
use std::time::{Duration, Instant};

/// How long a test waits for the background before it gives up.
const PATIENCE: Duration = Duration::from_secs(120);

/// A window that shows `mesh` by `methods`, or `None` after a line that `test` was skipped.
pub fn window(test: &str, mesh: &str, methods: &[&str]) -> Option<Harness<'static, Viewer>> {
    window_of(test, mesh, methods, |builder| builder.with_size(Vec2::new(900.0, 640.0)))
}

/// The same, built as `build` says.
pub fn window_of(
    test: &str,
    mesh: &str,
    methods: &[&str],
    build: impl FnOnce(egui_kittest::HarnessBuilder<Viewer>) -> egui_kittest::HarnessBuilder<Viewer>,
) -> Option<Harness<'static, Viewer>> {
    let gpu = shared_gpu_or_skip(test)?;
    let builder = build(Harness::builder()).wgpu_setup(silhouette_viewer::setup(gpu));
    let mut window = builder.build_eframe(|context| viewer(context, gpu, mesh, methods, |start| start));
    settle(&mut window);
    Some(window)
}

/// The contents of a window that shows `mesh` by `methods`, and begins as `change` says.
pub fn viewer(
    context: &CreationContext<'_>,
    gpu: &Arc<Gpu>,
    mesh: &str,
    methods: &[&str],
    change: impl FnOnce(Start) -> Start,
) -> Viewer {
    let registry = Registry::builtin();
    let choices = methods.iter().map(|name| Choice::of_words(&registry, name, &[]).unwrap()).collect();
    let (mesh, camera) = (Some(MeshArgument::from(mesh)), CameraArguments::of_words([]).unwrap());
    let start = Start { mesh, scene: None, choices, orient: false, measure: None, camera };
    Viewer::new(context, Arc::clone(gpu), registry, change(start)).unwrap()
}

/// Runs the window until nothing is to come.
pub fn settle(window: &mut Harness<'_, Viewer>) {
    let begin = Instant::now();
    let mut calm = 0;
    while calm < 4 {
        window.step();
        calm = if window.state().is_busy() { 0 } else { calm + 1 };
        assert!(begin.elapsed() < PATIENCE, "the background does not end");
        std::thread::sleep(Duration::from_millis(1));
    }
}

/// Chooses `word` in the choice labelled `label`.
pub fn choose(window: &mut Harness<'_, Viewer>, label: &str, word: &str) {
    window.get_by_role_and_label(egui::Role::ComboBox, label).click();
    window.step();
    window.step();
    press(window, egui::Role::Button, word);
}

/// Presses the control with this role and label, wherever it has scrolled to, and waits for what comes of it.
pub fn press(window: &mut Harness<'_, Viewer>, role: egui::Role, label: &str) {
    window.get_by_role_and_label(role, label).scroll_to_me();
    (0..30).for_each(|_| window.step());
    window.get_by_role_and_label(role, label).click();
    window.step();
    settle(window);
}

/// Where the picture of these methods lies, in pixels.
pub fn picture_rect(window: &Harness<'_, Viewer>, methods: &str) -> egui::Rect {
    let label = format!("Picture of {methods}");
    let node = window.get_by_role_and_label(egui::Role::Canvas, &label);
    let bounds = node.accesskit_node().raw_bounds().unwrap();
    egui::Rect::from_min_max(
        egui::pos2(bounds.x0 as f32, bounds.y0 as f32),
        egui::pos2(bounds.x1 as f32, bounds.y1 as f32),
    )
}

/// The window as it looks; kept where pictures are wanted.
pub fn look(window: &mut Harness<'_, Viewer>, name: &str) -> RgbaImage {
    let picture = window.render().unwrap();
    if let Some(folder) = std::env::var_os("SILHOUETTES_SCREENSHOTS").map(PathBuf::from) {
        std::fs::create_dir_all(&folder).unwrap();
        picture.save(folder.join(format!("{name}.png"))).unwrap();
    }
    picture
}
