//! Truth, loops, layers, paths and artefacts on screen.

use crate::stage::{choose, look, picture_rect, press, settle, window, window_of};
use eframe::egui::{self, Role, Theme, Vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use image::RgbaImage;
use silhouette_compare::metrics::PictureMetrics;
use silhouette_compare::picture::{MISSED, SPURIOUS};
use silhouette_viewer::viewer::Viewer;

/// How many pixels of the picture of these methods are of a colour.
fn count(window: &Harness<'_, Viewer>, screen: &RgbaImage, methods: &str, color: [u8; 4]) -> usize {
    let rect = picture_rect(window, methods);
    let is_within = |x: u32, y: u32| rect.contains(egui::pos2(x as f32 + 0.5, y as f32 + 0.5));
    screen.enumerate_pixels().filter(|(x, y, pixel)| is_within(*x, *y) && pixel.0 == color).count()
}

/// Brute force misses nothing; `jump-flood` draws the outline alone, and none of the lines inside it.
#[test]
fn what_is_missed_is_red_and_has_its_figures() {
    let Some(mut window) = window("what_is_missed_is_red", "builtin:gear", &["brute-force"]) else { return };
    press(&mut window, Role::DisclosureTriangle, "Truth");
    let before = look(&mut window, "truth_off");
    assert_eq!(count(&window, &before, "brute-force", MISSED), 0);
    press(&mut window, Role::CheckBox, "Measure against the truth");
    let missed = |window: &Harness<'_, Viewer>| {
        let score = window.state().panes()[0].score().expect("the view is measured");
        let PictureMetrics::Lines(lines) = &score.metrics else { panic!("a picture of lines") };
        (lines.missed_1px, score.true_length_px.unwrap())
    };
    let (exact, length) = missed(&window);
    assert!(exact < 0.02 && length > 1000.0, "{exact} of {length}");
    choose(&mut window, "method", "jump-flood");
    let screen = look(&mut window, "truth");
    let (outline, same) = missed(&window);
    let red = count(&window, &screen, "jump-flood", MISSED);
    assert!((same - length).abs() < 1e-9, "the truth is the view's, not the method's");
    assert!(outline > 0.1 && red > 200, "{outline} {red}");
    let text = format!("missed at 1 px: {:.2} %", 100.0 * outline);
    assert!(window.query_by_label_contains(&text).is_some(), "{text}");
    press(&mut window, Role::CheckBox, "Show missed and spurious");
    let bare = look(&mut window, "truth_hidden");
    let colored = |screen: &RgbaImage| {
        [MISSED, SPURIOUS].map(|color| count(&window, screen, "jump-flood", color)).iter().sum::<usize>()
    };
    assert!(colored(&bare) == 0 && colored(&screen) >= red, "{red}");
}

#[test]
fn filled_pictures_are_measured_by_their_area() {
    let Some(mut window) = window("filled_pictures_are_measured", "builtin:icosphere:1", &["smoothing"]) else {
        return;
    };
    press(&mut window, Role::DisclosureTriangle, "Truth");
    press(&mut window, Role::CheckBox, "Measure against the truth");
    let score = window.state().panes()[0].score().expect("the view is measured");
    let PictureMetrics::Fill(fill) = &score.metrics else { panic!("a filled picture") };
    // A smoothed sphere covers more than the coarse mesh that it is measured against.
    assert!(fill.xor_share > 1e-3 && fill.xor_share < 0.2, "{}", fill.xor_share);
    assert!(window.query_by_label_contains("XOR area").is_some());
}

#[test]
fn loops_have_colours_and_their_events_are_listed() {
    let Some(mut window) = window("loops_have_colours", "builtin:knot", &["tracking"]) else { return };
    press(&mut window, Role::DisclosureTriangle, "Loops and flicker");
    press(&mut window, Role::CheckBox, "Track loops");
    let loops = window.state().tracked().loops().expect("they are tracked").loops.len();
    assert!(loops >= 1 && window.query_by_label(&format!("{loops} loops in this view")).is_some());
    let born = window.state().tracked().events.all().filter(|event| event.starts_with("birth")).count();
    assert!(born >= loops, "{born} {loops}");
    let colored = look(&mut window, "tracking");
    press(&mut window, Role::CheckBox, "Track loops");
    let plain = look(&mut window, "tracking_off");
    let colors = |screen: &RgbaImage| {
        let rect = picture_rect(&window, "tracking");
        let is_within = |x: u32| x as f32 > rect.min.x;
        let is_colored = |pixel: &[u8; 4]| pixel[..3].iter().max().unwrap() - pixel[..3].iter().min().unwrap() > 100;
        screen.enumerate_pixels().filter(|(x, _, pixel)| is_within(*x) && is_colored(&pixel.0)).count()
    };
    assert!(colors(&colored) > 300 && colors(&plain) == 0, "{} {}", colors(&colored), colors(&plain));
}

/// Presses the slider of the camera path at a share of its length.
fn scrub(window: &mut Harness<'_, Viewer>, share: f32) {
    window.get_by_role_and_label(Role::Slider, "frame").scroll_to_me();
    window.run_steps(30);
    let rail = window.get_by_role_and_label(Role::Slider, "frame").rect();
    let place = rail.min + egui::vec2(1.0 + share * (rail.width() - 2.0), rail.height() / 2.0);
    window.hover_at(place);
    window.drag_at(place);
    window.step();
    window.drop_at(place);
    window.step();
    settle(window);
}

#[test]
fn a_path_is_stepped_scrubbed_and_played_and_layers_are_drawn() {
    let Some(mut window) = window("a_path_is_stepped", "builtin:gear", &["brute-force"]) else { return };
    let gray = |window: &mut Harness<'_, Viewer>, name: &str| {
        let screen = look(window, name);
        let rect = picture_rect(window, "brute-force");
        let is_within = |x: u32, y: u32| x as f32 > rect.min.x && y as f32 > rect.min.y + 30.0;
        screen.enumerate_pixels().filter(|(x, y, p)| is_within(*x, *y) && (90..250).contains(&p.0[0])).count()
    };
    let bare = gray(&mut window, "bare");
    press(&mut window, Role::DisclosureTriangle, "Pen and layers");
    for layer in ["shading", "hidden lines", "creases"] {
        press(&mut window, Role::CheckBox, layer);
    }
    let layered = gray(&mut window, "layers");
    assert!(layered > bare + 10_000, "{bare} {layered}");
    press(&mut window, Role::DisclosureTriangle, "Camera path");
    let eye = window.state().view().unwrap().camera().eye();
    press(&mut window, Role::Button, "Step");
    assert_eq!(window.state().path().frame(), 1);
    assert!(window.state().view().unwrap().camera().eye() != eye);
    press(&mut window, Role::Button, "Step back");
    assert_eq!((window.state().path().frame(), window.state().path().is_playing()), (0, false));
    scrub(&mut window, 0.5);
    let (middle, last) = (window.state().path().frame(), window.state().path().frames() - 1);
    assert!((last / 3..=2 * last / 3).contains(&middle), "{middle} of {last}");
    assert!(window.state().path().is_on(window.state().view().unwrap()), "the view is that of the frame");
    scrub(&mut window, 0.0);
    assert_eq!(window.state().path().frame(), 0);
    press(&mut window, Role::Button, "Play");
    let begin = std::time::Instant::now();
    while window.state().path().frame() < 4 {
        window.step();
        std::thread::sleep(std::time::Duration::from_millis(2));
        assert!(begin.elapsed() < std::time::Duration::from_secs(60), "it does not play");
    }
    press(&mut window, Role::Button, "Pause");
    assert!(!window.state().path().is_playing());
}

#[test]
fn artefacts_are_listed_with_who_asked() {
    let Some(mut window) = window("artefacts_are_listed", "builtin:torus", &["tracking"]) else { return };
    press(&mut window, Role::DisclosureTriangle, "Artefacts");
    for name in ["topology", "tracking"] {
        assert!(window.query_all_by_label_contains(name).next().is_some(), "no {name}");
    }
}

#[test]
fn light_and_dark_at_any_scale() {
    for (name, theme, scale) in [("light", Theme::Light, 1.0), ("dark_high_dpi", Theme::Dark, 2.0)] {
        let build = |builder: egui_kittest::HarnessBuilder<Viewer>| {
            builder.with_size(Vec2::new(900.0, 640.0)).with_theme(theme).with_pixels_per_point(scale)
        };
        let methods = ["brute-force", "inverted-hull"];
        let Some(mut window) = window_of("light_and_dark", "builtin:knot", &methods, build) else { return };
        press(&mut window, Role::CheckBox, "plots");
        settle(&mut window);
        let screen = look(&mut window, name);
        let sizes = window.state().panes().iter().map(|pane| pane.frame().unwrap().camera.size()[0]).sum::<u32>();
        let width = picture_rect(&window, "brute-force and inverted-hull").width() * scale;
        assert_eq!(sizes, width as u32, "a pixel of the picture is a pixel of the window");
        let side = screen.get_pixel(screen.width() / 8, screen.height() - 300 * scale as u32).0;
        assert_eq!(side[0] > 128, theme == Theme::Light, "{name}: {side:?}");
    }
}
