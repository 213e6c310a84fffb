//! Copies of a mesh in one frame, each with a model matrix and a renderer of its own; pipelines and mesh buffers are shared.

use super::printed::WINDOW_PX;
use crate::error::Cause;
use silhouette_compare::drawing::DrawError;
use silhouette_core::glam::{DMat4, DVec3};
use silhouette_core::mesh::Bounds;
use silhouette_core::view::Camera;
use silhouette_core::{MethodOptions, PreparedMesh};
use silhouette_gpu::{FillsImage, FrameRenderer, FrameView, MeshBuffers};
use silhouette_render::{DEFAULT_FORMATS, Gpu, Load, Target};
use std::sync::Arc;
use std::time::Instant;

/// Copies at the same place, each turned about the vertical by the golden angle more than the last, so that each shows its own
/// silhouette.
pub struct Copies {
    renderers: Vec<Box<dyn FrameRenderer>>,
    models: Vec<DMat4>,
    bounds: Bounds,
    target: Target,
}

/// What a frame took, in milliseconds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrameTime {
    /// Until every copy is prepared: made on the CPU and handed over for upload.
    pub prepare_ms: f64,
    /// From the beginning until the device is done.
    pub frame_ms: f64,
}

/// What does not change over the methods that are timed.
#[derive(Clone, Copy)]
pub struct Model<'a> {
    /// The mesh.
    pub mesh: &'a Arc<PreparedMesh>,
    /// Its buffers.
    pub buffers: &'a Arc<MeshBuffers>,
    /// How many copies.
    pub copies: usize,
}

impl Copies {
    /// Prepares a method for a mesh, and its renderers.
    ///
    /// # Errors
    /// [`Cause`]: options that do not fit, or a device that failed or cannot hold the mesh.
    pub fn new<M: FillsImage>(gpu: &Gpu, model: Model<'_>, words: &str) -> Result<Self, Cause> {
        let Model { mesh, buffers, copies } = model;
        let method = M::new(mesh, M::Options::parse(words.split_whitespace())?)?;
        let bounds = mesh.mesh().bounds().ok_or(Cause::EmptyMesh)?;
        let pipelines = gpu.scoped(|| method.pipelines(gpu.device(), DEFAULT_FORMATS)).map_err(DrawError::from)?;
        let pipelines = Arc::new(pipelines.map_err(DrawError::from)?);
        let renderer = || -> Result<Box<dyn FrameRenderer>, DrawError> {
            Ok(Box::new(method.renderer(gpu.device(), gpu.queue(), &pipelines, buffers)?))
        };
        Ok(Self {
            renderers: (0..copies).map(|_| renderer()).collect::<Result<_, _>>()?,
            models: (0..copies).map(|copy| turned(bounds.center, copy)).collect(),
            bounds,
            target: Target::new(gpu, WINDOW_PX, DEFAULT_FORMATS).map_err(DrawError::from)?,
        })
    }

    /// Draws all copies in one pass and waits for it.
    ///
    /// # Errors
    /// [`DrawError`]: a camera that sees no depths, or a device that failed.
    pub fn frame(&mut self, gpu: &Gpu, camera: &Camera) -> Result<FrameTime, DrawError> {
        let start = Instant::now();
        let Some(first) = self.renderers.first() else { return Err(DrawError::NoFaces) };
        let range = first.clip_range(camera, camera.clip_range(&self.bounds));
        let view = FrameView::from_camera(camera, range, DEFAULT_FORMATS.depth_direction)?;
        for (renderer, &model) in self.renderers.iter_mut().zip(&self.models) {
            renderer.prepare(gpu.device(), gpu.queue(), &view.with_model(model)?)?;
        }
        let prepare_ms = start.elapsed().as_secs_f64() * 1e3;
        let pass = gpu.draw_after(
            &self.target,
            Load::Clear([1.0; 4]),
            |encoder| self.renderers.iter().for_each(|renderer| renderer.encode(encoder)),
            |pass| self.renderers.iter().for_each(|renderer| renderer.draw(pass)),
        )?;
        Ok(FrameTime { prepare_ms, frame_ms: prepare_ms + pass.wall_ms })
    }

    /// The frame drawn last.
    #[cfg(test)]
    pub fn picture(&self, gpu: &Gpu) -> silhouette_render::Image {
        self.target.read_color(gpu).unwrap()
    }
}

fn turned(center: DVec3, copy: usize) -> DMat4 {
    let golden = std::f64::consts::PI * (3.0 - 5.0_f64.sqrt());
    DMat4::from_translation(center) * DMat4::from_rotation_y(golden * copy as f64) * DMat4::from_translation(-center)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::wang_2008::window::{Kind, Window};
    use silhouette_core::shapes;
    use silhouette_smoothing::{PnTriangles, Smoothing};
    use silhouette_testing::gpu_or_skip;

    /// Turned by the other way, the mesh itself is where its copy is.
    #[test]
    fn a_copy_is_the_mesh_turned_and_copies_cover_more() {
        let Some(gpu) = gpu_or_skip("a_copy_is_the_mesh_turned_and_copies_cover_more") else { return };
        let mesh = Arc::new(PreparedMesh::new(shapes::by_name("knot:2,3,40,6").unwrap()));
        let buffers = Arc::new(MeshBuffers::new(gpu.device(), gpu.queue(), mesh.mesh()).unwrap());
        let window = Window::new(gpu, &mesh).unwrap();
        let camera = window.camera(DVec3::new(0.2, 0.5, 1.0), Kind::Perspective).unwrap();
        let inked = |copies: usize| {
            let model = Model { mesh: &mesh, buffers: &buffers, copies };
            let mut all = Copies::new::<Smoothing>(gpu, model, "").unwrap();
            let time = all.frame(gpu, &camera).unwrap();
            assert!(time.prepare_ms > 0.0 && time.frame_ms > time.prepare_ms);
            all.picture(gpu).rgba.chunks_exact(4).filter(|pixel| pixel[..3] != [255; 3]).count()
        };
        let [one, four] = [1, 4].map(inked);
        assert!(one > 200_000 && four as f64 > 1.2 * one as f64, "{one} {four}");
        let model = Model { mesh: &mesh, buffers: &buffers, copies: 1 };
        assert!(Copies::new::<PnTriangles>(gpu, model, "level=99").is_err());
    }
}
