//! Depth buffers: few bits, either direction, planes very close to the eye and at infinity.

use crate::cell::Aspect::{Fill, Lines};
use crate::cell::Outcome::{Differs, Empty, Refused};
use crate::meshes::torus;
use crate::row::{Row, Who};
use crate::scene::Scene;
use silhouette_core::view::{ClipRange, DepthDirection};
use silhouette_gpu::TargetFormats;
use silhouette_render::DEFAULT_FORMATS;
use wgpu::TextureFormat::{Depth16Unorm, Depth24Plus, Depth32Float};

fn formats(depth: wgpu::TextureFormat, depth_direction: DepthDirection) -> TargetFormats {
    TargetFormats { depth, depth_direction, ..DEFAULT_FORMATS }
}

fn with(depth: wgpu::TextureFormat, direction: DepthDirection, range: Option<ClipRange>) -> Scene {
    Scene { range, ..Scene::of(torus()).with_formats(formats(depth, direction)) }
}

/// Planes 1e-7 of each other's depth.
const CLOSE: Option<ClipRange> = Some(ClipRange { near: 1e-6, far: 10.0 });

/// A far plane at infinity.
const INFINITE: Option<ClipRange> = Some(ClipRange { near: 0.5, far: f64::INFINITY });

const COARSE: &str = "a depth step at half the far plane is a seventh of its depth and more: what is nearer hides nothing; draw with near \
                      at 1 and 32 bits, or with planes closer to each other";
const ONE_STEP: &str = "all of the torus is in the farthest step of the buffer, where it is no nearer than the ground";

/// What is expected of a buffer whose steps are coarser than the mesh.
fn coarse(row: Row) -> Row {
    let lines = ["brute-force", "image-precision", "edge-mesh", "inverted-hull", "gbuffer-filter"];
    row.expect_of(Lines, &lines, Differs, COARSE)
}

/// The rows.
pub fn rows() -> Vec<Row> {
    use DepthDirection::{Reversed, Standard};
    vec![
        Row::new("16 bit", "16 bits, planes tight around the torus", || with(Depth16Unorm, Standard, None)),
        Row::new("24 bit", "24 bits, planes tight around the torus", || with(Depth24Plus, Standard, None)),
        Row::new("32 bit", "32-bit floats, near at 0", || with(Depth32Float, Standard, None)),
        Row::new("infinite", "32-bit floats, near at 1, far at infinity", || with(Depth32Float, Reversed, INFINITE)),
        Row::new("infinite, standard", "32-bit floats, near at 0, far at infinity", || {
            with(Depth32Float, Standard, INFINITE)
        }),
        Row::new("1e-7, reversed", "near over far is 1e-7; 32-bit floats, near at 1", || {
            with(Depth32Float, Reversed, CLOSE)
        }),
        coarse(Row::new("1e-7, 32 bit", "near over far is 1e-7; 32-bit floats, near at 0", || {
            with(Depth32Float, Standard, CLOSE)
        })),
        coarse(Row::new("1e-7, 24 bit", "near over far is 1e-7; 24 bits", || with(Depth24Plus, Standard, CLOSE))),
        coarse(Row::new("1e-7, 16 bit", "near over far is 1e-7; 16 bits", || with(Depth16Unorm, Standard, CLOSE)))
            .expect_of(Lines, &["inverted-hull", "texture-lines"], Empty, ONE_STEP)
            .expect(Who::Every(Fill), Empty, ONE_STEP),
        Row::new("planes swapped", "a far plane nearer than the near plane", || {
            with(Depth32Float, Reversed, Some(ClipRange { near: 10.0, far: 1.0 }))
        })
        .expect(Who::Every(Lines), Refused, "")
        .expect(Who::Every(Fill), Refused, ""),
        Row::new("wrong direction", "a view with near at 0 for a target with near at 1", || {
            let view_formats = formats(Depth32Float, Standard);
            Scene { view_formats, ..Scene::of(torus()) }
        })
        .expect(Who::Every(Lines), Refused, "")
        .expect(Who::Every(Fill), Refused, ""),
    ]
}
