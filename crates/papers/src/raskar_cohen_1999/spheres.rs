//! Icospheres from many sides, drawn, beside what follows from the geometry. Views are many because spikes are few: each
//! depends on how its edge lies in the view.

use super::derived::{DISTANCE, outline_radius_px, scaled_width_px};
use super::fattened;
use super::variants::{AS_PRINTED, SCALE_95, SCALE_99, SCREEN, Variant, style};
use crate::directions::spread;
use crate::error::Cause;
use silhouette_compare::metrics::Ink;
use silhouette_compare::runner::DEFAULT_PEN_WIDTH_PX;
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::shapes::Sphere;
use silhouette_core::view::{Camera, ViewError};
use silhouette_core::{PreparedMesh, Progress, Projection};
use silhouette_render::Gpu;
use std::sync::Arc;

/// Number of views.
pub const VIEWS: u32 = 12;

/// Side of the pictures in pixels.
const SIZE_PX: u32 = 512;
/// Vertical field of view in radians: that of every comparison.
const FOV_Y_RAD: f64 = std::f64::consts::FRAC_PI_4;

/// What is drawn of a sphere, and where a law says how wide it is.
const DRAWN: [(Variant, Option<Law>); 4] = [
    (SCREEN, None),
    (SCALE_99, Some(Law::Scaled(0.99))),
    (SCALE_95, Some(Law::Scaled(0.95))),
    (AS_PRINTED, Some(Law::Fattened)),
];

#[derive(Debug, Clone, Copy)]
enum Law {
    Scaled(f64),
    Fattened,
}

/// What one variant draws of one sphere.
#[derive(Debug, Clone)]
pub struct SphereResult {
    /// The variant.
    pub variant: Variant,
    /// Level of the icosphere.
    pub level: u32,
    /// What each view shows.
    pub drawn: Vec<Around>,
    /// What follows from the geometry for each view; empty where no law is known.
    pub derived: Vec<Around>,
}

/// The ink around a sphere in one view.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Around {
    /// Ink over the length of the smooth outline, in pixels.
    pub width_px: f64,
    /// Distance of the farthest ink outside of the smooth outline in pixels, 0 where none is; `None` where it is not derived.
    pub farthest_px: Option<f64>,
}

impl Around {
    fn of(pixels: impl Iterator<Item = (u32, u32)>) -> Self {
        let (middle, radius) = (0.5 * f64::from(SIZE_PX), outline_radius_px(focal_px()));
        let (mut count, mut farthest) = (0_u32, 0.0_f64);
        for (x, y) in pixels {
            count += 1;
            farthest = farthest.max((f64::from(x) + 0.5 - middle).hypot(f64::from(y) + 0.5 - middle) - radius);
        }
        Self { width_px: f64::from(count) / (std::f64::consts::TAU * radius), farthest_px: Some(farthest) }
    }
}

fn focal_px() -> f64 {
    0.5 * f64::from(SIZE_PX) / (0.5 * FOV_Y_RAD).tan()
}

/// The camera in a unit direction from the sphere.
fn camera(direction: DVec3) -> Result<Camera, ViewError> {
    let up = if direction.y.abs() > 0.9 { Vec3::X } else { Vec3::Y };
    let projection = Projection::Perspective { fov_y_rad: FOV_Y_RAD };
    Camera::new((direction * DISTANCE).as_vec3(), Vec3::ZERO, up, projection, [SIZE_PX; 2])
}

/// Draws an icosphere from `views` sides by [`SCREEN`], two scalings, and fattening as printed.
///
/// # Errors
/// [`Cause`]: cancelled, or a device that failed.
pub fn measure(gpu: &Gpu, level: u32, views: u32, progress: &dyn Progress) -> Result<Vec<SphereResult>, Cause> {
    let results = DRAWN.map(|drawn| of_variant(gpu, level, drawn, views, progress)).into_iter().collect();
    progress.advance(1);
    results
}

fn of_variant(
    gpu: &Gpu,
    level: u32,
    (variant, law): (Variant, Option<Law>),
    views: u32,
    progress: &dyn Progress,
) -> Result<SphereResult, Cause> {
    let mesh = Arc::new(PreparedMesh::new(Sphere::default().icosphere(level)?));
    let mut result = SphereResult { variant, level, drawn: Vec::new(), derived: Vec::new() };
    let mut drawing = variant.drawing(gpu, &mesh, style([SIZE_PX; 2], 1), progress)?;
    for direction in spread(views) {
        progress.check()?;
        let camera = camera(direction)?;
        drawing.draw(gpu, &camera)?;
        let ink = Ink::from_picture(&drawing.picture(gpu)?);
        result.drawn.push(Around::of(ink.ink_pixels()));
        result.derived.extend(law.map(|law| derived(law, &mesh, &camera)));
    }
    Ok(result)
}

fn derived(law: Law, mesh: &PreparedMesh, camera: &Camera) -> Around {
    match law {
        Law::Scaled(k) => Around { width_px: scaled_width_px(k, focal_px()), farthest_px: None },
        Law::Fattened => {
            Around::of(fattened::ink(mesh.mesh(), camera, DEFAULT_PEN_WIDTH_PX).into_iter().map(|[x, y]| (x, y)))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::NoProgress;
    use silhouette_testing::gpu_or_skip;

    fn widths(around: &[Around]) -> Vec<f64> {
        around.iter().map(|around| around.width_px).collect()
    }

    /// Drawn and computed ink are counted at the same pixel centres, of the same triangles: they differ where 32 bits move an
    /// edge across a centre.
    #[test]
    fn fattening_as_printed_draws_what_the_law_computes_in_every_view() {
        let test = "fattening_as_printed_draws_what_the_law_computes_in_every_view";
        let Some(gpu) = gpu_or_skip(test) else { return };
        for level in [2, 4] {
            let results = measure(gpu, level, 4, &NoProgress).unwrap();
            let [screen, .., fattened] = &results[..] else { panic!("{results:?}") };
            assert!(widths(&screen.drawn).iter().all(|width| (1.9..2.1).contains(width)), "{screen:?}");
            for (drawn, derived) in fattened.drawn.iter().zip(&fattened.derived) {
                assert!((drawn.width_px / derived.width_px - 1.0).abs() < 0.02, "{level}: {drawn:?} {derived:?}");
                let [drawn_px, derived_px] = [drawn, derived].map(|around| around.farthest_px.unwrap());
                assert!((drawn_px - derived_px).abs() < 2.0, "{level}: {drawn:?} {derived:?}");
                assert!(drawn.width_px > 1.2 * widths(&screen.drawn)[0], "the control: it is no even line");
            }
        }
    }

    /// The rim of a scaled sphere is a few facets wide at level 5. Each level halves the facets, and with them the error.
    #[test]
    fn scaling_converges_to_the_width_of_the_smooth_sphere() {
        let Some(gpu) = gpu_or_skip("scaling_converges_to_the_width_of_the_smooth_sphere") else { return };
        let error = |level| {
            let scaled = (SCALE_95, Some(Law::Scaled(0.95)));
            let scaled = of_variant(gpu, level, scaled, 4, &NoProgress).unwrap();
            let mean = widths(&scaled.drawn).iter().sum::<f64>() / 4.0;
            (mean / scaled.derived[0].width_px - 1.0).abs()
        };
        let errors = [5, 6, 7].map(error);
        assert!(errors.windows(2).all(|pair| pair[1] < 0.75 * pair[0]) && errors[2] < 0.05, "{errors:?}");
    }
}
