//! What front faces leave in the target.

use crate::scene::{count, draw, framed, ink, torus};
use silhouette_render::DEFAULT_FORMATS;
use silhouette_testing::gpu_or_skip;

/// Values of a pixel of the ground, which [`draw`] clears to, and of paper.
const GROUND: u8 = 128;
const WHITE: u8 = 255;

#[test]
fn depth_only_faces_hide_lines_and_leave_the_ground_visible() {
    let Some(gpu) = gpu_or_skip("depth_only_faces_hide_lines_and_leave_the_ground_visible") else { return };
    let mesh = torus();
    let camera = framed(&mesh, 128);
    for variant in ["variant=screen", "variant=scale", "variant=charcoal"] {
        let [paper, depth_only] = ["interior=paper", "interior=depth-only"]
            .map(|interior| draw(gpu, &mesh, &camera, &[variant, interior], DEFAULT_FORMATS).image);
        assert!(count(&paper, |value| value == WHITE) > 1000, "{variant}: the control is opaque");
        assert_eq!(count(&depth_only, |value| value == WHITE), 0, "{variant}");
        for (paper, depth_only) in paper.rgba.chunks_exact(4).zip(depth_only.rgba.chunks_exact(4)) {
            let expected = if paper[0] == WHITE { GROUND } else { paper[0] };
            assert_eq!(depth_only[0], expected, "{variant}: lines are the same, and paper is ground");
        }
    }
}

#[test]
fn faces_that_are_not_drawn_hide_nothing() {
    let Some(gpu) = gpu_or_skip("faces_that_are_not_drawn_hide_nothing") else { return };
    let mesh = torus();
    let camera = framed(&mesh, 128);
    let [depth_only, none] = ["interior=depth-only", "interior=none"]
        .map(|interior| draw(gpu, &mesh, &camera, &["variant=fixed-pull", interior], DEFAULT_FORMATS).image);
    assert!(ink(&none) > 2 * ink(&depth_only), "all back faces show");
    assert_eq!(count(&none, |value| value == WHITE), 0);
}
