//! Pictures of one pixel and of many, and lines of no width and of many pixels.

use crate::cell::Aspect::{Fill, Lines};
use crate::cell::Found;
use crate::cell::Outcome::{Differs, Empty, Refused};
use crate::meshes::torus;
use crate::row::{Row, Who};
use crate::scene::Scene;
use silhouette_gpu::TargetFormats;
use silhouette_render::DEFAULT_FORMATS;
use silhouette_testing::views::{PERSPECTIVE, three_quarter};

fn sized(size: [u32; 2]) -> Scene {
    let mesh = torus();
    let camera = three_quarter(&mesh, PERSPECTIVE, size);
    Scene::seen(mesh, camera)
}

fn wide(pen_px: f64, option: &'static str) -> Scene {
    Scene { pen_px, ..Scene::of(torus()).with_options([option]) }
}

const ONE_SAMPLE: &str = "each pixel has one sample, which is covered or not, and the truth has the share";
const BEHIND: &str = "the one sample shows the torus, in front of its outline";
const NO_WIDTH: &str = "lines of no width have no ink";
const HARDLY: &str =
    "few samples lie on lines so thin; the true pen covers no pixel by half, so that all ink is spurious";

/// The rows.
pub fn rows() -> Vec<Row> {
    vec![
        Row::new("1 x 1", "a picture of one pixel", || sized([1, 1]))
            .expect(Who::Every(Fill), Differs, ONE_SAMPLE)
            .expect_of(Lines, &["brute-force", "image-precision", "edge-mesh", "jump-flood"], Empty, BEHIND),
        Row::new("2 x 3", "a picture of six pixels", || sized([2, 3])).expect(Who::Every(Fill), Differs, ONE_SAMPLE),
        Row::new("16384 x 96", "a picture as wide as any", || sized([16_384, 96])).expect_of(
            Lines,
            &["gbuffer-filter", "jump-flood"],
            Refused,
            "it looks beyond the rim of the picture, and no texture of this device is so wide",
        ),
        Row::fallible("16385 x 96", "a picture wider than any", || {
            let camera = Scene::of(torus()).camera.with_size([16_385, 96]);
            camera.map(|camera| Scene::seen(torus(), camera)).map_err(|error| Found::refused(&error))
        })
        .expect(Who::All, Refused, ""),
        Row::new("4 samples", "four samples per pixel", || {
            Scene::of(torus()).with_formats(TargetFormats { samples: 4, ..DEFAULT_FORMATS })
        }),
        Row::new("width 0", "lines of no width", || wide(0.0, "width=0")).expect(Who::Every(Lines), Empty, NO_WIDTH),
        Row::new("width 0.01", "lines of a hundredth of a pixel", || wide(0.01, "width=0.01")).expect(
            Who::Every(Lines),
            Differs,
            HARDLY,
        ),
        Row::new("width 500", "lines of 500 pixels in a picture of 96", || wide(500.0, "width=500"))
            .expect_of(
                Lines,
                &["image-precision", "edge-mesh"],
                Differs,
                "a line has the depth of its edge, and the torus hides what of it lies over nearer faces",
            )
            .expect_of(Lines, &["inverted-hull"], Differs, "the pushed faces pass through each other and the eye"),
    ]
}
