//! Spheres from many sides: how far the farthest spike of the printed law reaches, and which of some sixty faces a picture
//! loses, goes with the view.

use super::derived;
use super::lost::{self, LostError};
use super::variants::AS_PRINTED;
use glam::{DVec3, Vec3};
use silhouette_compare::drawing::DrawError;
use silhouette_compare::registry;
use silhouette_core::view::{Camera, ViewError};
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
    /// Faces that pictures lose; `None` for spheres beside which no prediction stands.
    pub lost: Option<LostOverViews>,
}

/// Shares of the front faces that pictures of [`lost::SIZES_PX`] lose, see [`Lost::share`](super::lost::Lost::share).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LostOverViews {
    /// Means over [`VIEWS`] views.
    pub mean: [f64; 3],
    /// Least of them.
    pub least: [f64; 3],
    /// Most of them.
    pub most: [f64; 3],
}

/// [`VIEWS`] directions, spread evenly.
fn directions() -> impl Iterator<Item = DVec3> {
    let golden = std::f64::consts::PI * (3.0 - 5.0_f64.sqrt());
    (0..VIEWS).map(move |view| {
        let height = 1.0 - (2.0 * f64::from(view) + 1.0) / f64::from(VIEWS);
        let (sine, cosine) = (golden * f64::from(view)).sin_cos();
        let across = (1.0 - height * height).sqrt();
        DVec3::new(across * cosine, height, across * sine)
    })
}

/// The camera of the predictions in a direction from the sphere.
pub(super) fn camera(direction: DVec3) -> Result<Camera, ViewError> {
    camera_through(direction, derived::FOV_Y_RAD)
}

/// The same with another field of view.
fn camera_through(direction: DVec3, fov_y_rad: f64) -> Result<Camera, ViewError> {
    let eye = direction.normalize() * derived::DISTANCE;
    let projection = Projection::Perspective { fov_y_rad };
    let up = if direction.y.abs() > 0.9 * direction.length() { Vec3::X } else { Vec3::Y };
    Camera::new(eye.as_vec3(), Vec3::ZERO, up, projection, [derived::SIZE_PX; 2])
}

/// Draws an icosphere around the origin from every direction.
pub(super) fn measure(
    gpu: &Gpu,
    name: &str,
    mesh: &Arc<PreparedMesh>,
    progress: &dyn Progress,
) -> Result<SphereViews, LostError> {
    let lost = derived::lost(name).map(|_| measure_lost(gpu, mesh, progress)).transpose()?;
    let entry = registry::find("image-precision")?;
    let radius = derived::outline_radius_px();
    let middle = 0.5 * f64::from(derived::SIZE_PX);
    let mut all = SphereViews { mean_width_px: 0.0, farthest_px: [f64::INFINITY, 0.0], lost };
    for direction in directions() {
        let camera = camera(direction)?;
        let ink = lost::draw(gpu, mesh, entry, &AS_PRINTED, &camera, progress)?;
        let from_middle = |(x, y): (u32, u32)| (f64::from(x) + 0.5 - middle).hypot(f64::from(y) + 0.5 - middle);
        let farthest = ink.ink_pixels().map(|pixel| from_middle(pixel) - radius).fold(0.0, f64::max);
        let width = ink.ink_pixels().count() as f64 / (std::f64::consts::TAU * radius);
        all.mean_width_px += width / f64::from(VIEWS);
        all.farthest_px = [all.farthest_px[0].min(farthest), all.farthest_px[1].max(farthest)];
    }
    Ok(all)
}

/// Counts the faces of an icosphere around the origin that pictures lose, from every direction through
/// [`derived::LOST_FOV_Y_RAD`]. Four pictures a view, one of them of [`lost::FINE_PX`]: half a second a view in software.
fn measure_lost(gpu: &Gpu, mesh: &PreparedMesh, progress: &dyn Progress) -> Result<LostOverViews, LostError> {
    let mut all = LostOverViews { mean: [0.0; 3], least: [1.0; 3], most: [0.0; 3] };
    for direction in directions() {
        progress.check().map_err(|cancelled| DrawError::Prepare(cancelled.into()))?;
        let camera = camera_through(direction, derived::LOST_FOV_Y_RAD)?;
        for (at, share) in lost::shares(gpu, mesh, &camera)?.into_iter().enumerate() {
            all.mean[at] += share / f64::from(VIEWS);
            all.least[at] = all.least[at].min(share);
            all.most[at] = all.most[at].max(share);
        }
    }
    Ok(all)
}
