//! Pictures of one pixel and of many, and lines of no width and of many pixels.

use crate::cell::Found;
use crate::meshes::torus;
use crate::row::Row;
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

/// The rows.
pub fn rows() -> Vec<Row> {
    vec![
        Row::new("1 x 1", "a picture of one pixel", || sized([1, 1])),
        Row::new("2 x 3", "a picture of six pixels", || sized([2, 3])),
        Row::new("16384 x 96", "a picture as wide as any", || sized([16_384, 96])),
        Row::fallible("16385 x 96", "a picture wider than any", || {
            let camera = Scene::of(torus()).camera.with_size([16_385, 96]);
            camera.map(|camera| Scene::seen(torus(), camera)).map_err(|error| Found::refused(&error))
        }),
        Row::new("4 samples", "four samples per pixel", || {
            Scene::of(torus()).with_formats(TargetFormats { samples: 4, ..DEFAULT_FORMATS })
        }),
        Row::new("width 0", "lines of no width", || wide(0.0, "width=0")),
        Row::new("width 0.01", "lines of a hundredth of a pixel", || wide(0.01, "width=0.01")),
        Row::new("width 500", "lines of 500 pixels in a picture of 96", || wide(500.0, "width=500")),
    ]
}
