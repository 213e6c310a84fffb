//! Views in the paper's window: the model covers half of it, the middle of the 40 to 60 % that the paper names.

use super::printed::WINDOW_PX;
use crate::error::Cause;
use silhouette_compare::drawing::DrawError;
use silhouette_core::PreparedMesh;
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::mesh::Bounds;
use silhouette_core::view::{Camera, Framing, Projection, ViewPreset};
use silhouette_gpu::MeshBuffers;
use silhouette_render::{FaceIdPass, Gpu};

/// Share of the window that a model covers in the view that its size is chosen by.
const COVERED: f64 = 0.5;

/// Vertical field of view in radians that fits a model's bounding sphere, which sets the distance of the eye: that of every
/// comparison here, as the paper names none.
const FOV_Y_RAD: f64 = std::f64::consts::FRAC_PI_4;

/// How far a model may be magnified beyond its bounding sphere to cover its share.
const MOST_ZOOM: f64 = 4.0;

/// Halvings of the range of magnifications.
const STEPS: u32 = 9;

/// The two projections of Table I.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Parallel.
    Orthographic,
    /// Perspective.
    Perspective,
}

/// Both, in the order of the table.
pub const KINDS: [Kind; 2] = [Kind::Orthographic, Kind::Perspective];

/// How a model is seen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Window {
    bounds: Bounds,
    /// Magnifications by [`KINDS`].
    zooms: [f64; 2],
}

impl Window {
    /// Chooses the size at which the model covers half of the window, seen from the three-quarter view; less for a model that
    /// is too thin. The eye of a perspective stays where it is, its field of view changes.
    ///
    /// # Errors
    /// [`Cause`]: no faces, no camera, or a device that failed.
    pub fn new(gpu: &Gpu, mesh: &PreparedMesh) -> Result<Self, Cause> {
        let bounds = mesh.mesh().bounds().ok_or(Cause::EmptyMesh)?;
        let buffers = MeshBuffers::new(gpu.device(), gpu.queue(), mesh.mesh()).map_err(DrawError::from)?;
        let mut pass = FaceIdPass::new(gpu).map_err(DrawError::from)?;
        let direction = ViewPreset::default().directions().0;
        let mut zooms = [1.0; 2];
        for kind in KINDS {
            let (mut low, mut high) = (1.0 / MOST_ZOOM, MOST_ZOOM);
            for _ in 0..STEPS {
                let middle: f64 = 0.5 * (low + high);
                zooms[kind as usize] = middle;
                let camera = Self { bounds, zooms }.camera(direction, kind)?;
                let camera = camera.with_size(WINDOW_PX.map(|side| side / 4))?;
                let ids = pass.draw(gpu, &buffers, &camera, 1).map_err(DrawError::from)?.values;
                let covered = ids.iter().filter(|&&id| id > 0).count() as f64 / ids.len() as f64;
                if covered < COVERED {
                    low = middle;
                } else {
                    high = middle;
                }
            }
        }
        Ok(Self { bounds, zooms })
    }

    /// The bounding sphere fits the window.
    #[cfg(test)]
    pub fn unmagnified(bounds: Bounds) -> Self {
        Self { bounds, zooms: [1.0; 2] }
    }

    /// The camera in a direction from the middle of the mesh.
    ///
    /// # Errors
    /// [`Cause::View`].
    pub fn camera(&self, direction: DVec3, kind: Kind) -> Result<Camera, Cause> {
        let up = if direction.normalize().y.abs() > 0.95 { Vec3::X } else { Vec3::Y };
        let framing = match kind {
            Kind::Orthographic => Framing::Orthographic,
            Kind::Perspective => Framing::Perspective { fov_y_rad: FOV_Y_RAD },
        };
        let framed = Camera::framing(&self.bounds, direction, up, framing, WINDOW_PX)?;
        Ok(zoomed(&framed, framed.target(), self.zooms[kind as usize])?)
    }
}

/// The camera at the same place, looking at another point and magnifying it.
///
/// # Errors
/// [`ViewError`](silhouette_core::view::ViewError): the point is where the eye is.
pub fn zoomed(camera: &Camera, target: Vec3, zoom: f64) -> Result<Camera, silhouette_core::view::ViewError> {
    let (projection, eye) = match camera.projection() {
        Projection::Perspective { fov_y_rad } => {
            let fov_y_rad = 2.0 * ((0.5 * fov_y_rad).tan() / zoom).atan();
            (Projection::Perspective { fov_y_rad }, camera.eye())
        }
        Projection::Orthographic { height } => {
            (Projection::Orthographic { height: height / zoom }, camera.eye() + (target - camera.target()))
        }
    };
    Camera::new(eye, target, camera.up(), projection, camera.size())
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::glam::DVec2;
    use silhouette_core::shapes;
    use silhouette_testing::gpu_or_skip;

    #[test]
    fn models_cover_half_of_the_window_and_zoomed_views_magnify() {
        let Some(gpu) = gpu_or_skip("models_cover_half_of_the_window_and_zoomed_views_magnify") else { return };
        for name in ["knot:2,3,40,6", "blob:500", "torus:24,12"] {
            let mesh = PreparedMesh::new(shapes::by_name(name).unwrap());
            let window = Window::new(gpu, &mesh).unwrap();
            let buffers = MeshBuffers::new(gpu.device(), gpu.queue(), mesh.mesh()).unwrap();
            for kind in KINDS {
                let camera = window.camera(ViewPreset::default().directions().0, kind).unwrap();
                let ids = FaceIdPass::new(gpu).unwrap().draw(gpu, &buffers, &camera, 1).unwrap().values;
                let share = ids.iter().filter(|&&id| id > 0).count() as f64 / ids.len() as f64;
                assert!((0.48..0.52).contains(&share), "{name} {kind:?}: {share}");
                let target = mesh.mesh().positions()[0];
                let close = zoomed(&camera, target, 8.0).unwrap();
                let at = close.project(target.as_dvec3()).unwrap();
                assert!(at.pixel.distance(DVec2::new(640.0, 400.0)) < 0.1, "{name}");
                let [far, near] = [camera, close].map(|camera| camera.pixels_per_unit(at.depth));
                assert!((near / far - 8.0).abs() < 0.1, "{name} {kind:?}: {}", near / far);
            }
        }
    }
}
