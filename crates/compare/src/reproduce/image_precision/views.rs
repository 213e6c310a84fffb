//! Spheres fattened by the printed law, from many sides: a single view's farthest spike is a matter of chance.

use super::lost::{self, LostError};
use super::predicted;
use super::variants::Variant;
use crate::registry;
use glam::{DVec3, Vec3};
use silhouette_core::view::Camera;
use silhouette_core::{PreparedMesh, Progress, Projection};
use silhouette_render::Gpu;
use std::sync::Arc;

/// Number of views.
pub const VIEWS: u32 = 12;

/// What the views of a sphere show.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SphereViews {
    /// Ink over the length of the smooth outline in pixels, the mean over all views.
    pub mean_width_px: f64,
    /// Distance of the farthest ink outside of the smooth outline in pixels: least and most of all views.
    pub farthest_px: [f64; 2],
}

/// The camera of the predictions in a direction from the sphere.
pub(super) fn camera(direction: DVec3) -> Result<Camera, silhouette_core::view::ViewError> {
    let eye = direction.normalize() * predicted::DISTANCE;
    let projection = Projection::Perspective { fov_y_rad: predicted::FOV_Y_RAD };
    let up = if direction.y.abs() > 0.9 * direction.length() { Vec3::X } else { Vec3::Y };
    Camera::new(eye.as_vec3(), Vec3::ZERO, up, projection, [predicted::SIZE_PX; 2])
}

/// Draws an icosphere around the origin from [`VIEWS`] directions, spread evenly.
pub(super) fn measure(
    gpu: &Gpu,
    mesh: &Arc<PreparedMesh>,
    variant: &Variant,
    progress: &dyn Progress,
) -> Result<SphereViews, LostError> {
    let entry = registry::find("image-precision")?;
    let radius = predicted::outline_radius_px();
    let middle = 0.5 * f64::from(predicted::SIZE_PX);
    let golden = std::f64::consts::PI * (3.0 - 5.0_f64.sqrt());
    let mut all = SphereViews { mean_width_px: 0.0, farthest_px: [f64::INFINITY, 0.0] };
    for view in 0..VIEWS {
        let height = 1.0 - (2.0 * f64::from(view) + 1.0) / f64::from(VIEWS);
        let (sine, cosine) = (golden * f64::from(view)).sin_cos();
        let across = (1.0 - height * height).sqrt();
        let camera = camera(DVec3::new(across * cosine, height, across * sine))?;
        let ink = lost::draw(gpu, mesh, entry, variant, &camera, progress)?;
        let from_middle = |(x, y): (u32, u32)| (f64::from(x) + 0.5 - middle).hypot(f64::from(y) + 0.5 - middle);
        let farthest = ink.ink_pixels().map(|pixel| from_middle(pixel) - radius).fold(0.0, f64::max);
        let width = ink.ink_pixels().count() as f64 / (std::f64::consts::TAU * radius);
        all.mean_width_px += width / f64::from(VIEWS);
        all.farthest_px = [all.farthest_px[0].min(farthest), all.farthest_px[1].max(farthest)];
    }
    Ok(all)
}
