//! The drawing convention between a silhouette method and a wgpu application.
//!
//! A method's renderer is middleware: it creates no device, owns no window, submits nothing and reads nothing back.
//! The application calls [`LineRenderer::prepare`] once a frame, which uploads what changed, then
//! [`LineRenderer::encode`] with its encoder, begins a render pass whose attachments match [`TargetFormats`], cleared as
//! [`TargetFormats`] says, and calls [`LineRenderer::draw`].
//!
//! Beside the convention lies what every renderer of a mesh needs: [`MeshBuffers`] and [`CameraUniform`], both relative
//! to a [`LocalFrame`], so that a mesh far from the origin is drawn as sharply as one at the origin.

mod camera;
mod formats;
pub mod kit;
mod line_polygon;
mod local_frame;
mod mesh_binding;
mod mesh_buffers;
mod pen;
mod renderer_error;

pub use camera::{CameraBinding, CameraUniform};
pub use formats::TargetFormats;
pub use line_polygon::{LinePolygon, LineShape, Rounding};
pub use local_frame::LocalFrame;
pub use mesh_binding::MeshBinding;
pub use mesh_buffers::{MeshBuffers, MeshTooLarge, POSITION_LAYOUT};
pub use pen::{Pen, PenPlacement};
pub use renderer_error::RendererError;

use silhouette_core::method::Method;
use silhouette_core::view::Camera;

/// A method that draws the lines of a view itself.
pub trait DrawsLines: Method {
    /// Its renderer on a device.
    type Renderer: LineRenderer + 'static;

    /// On which side of the true line its ink lies.
    fn pen_placement(&self) -> PenPlacement;

    /// Uploads the mesh and builds the pipelines.
    ///
    /// # Errors
    /// [`RendererError`]: the mesh is too large for the device, or the device lacks what the options ask for.
    fn renderer(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        formats: TargetFormats,
    ) -> Result<Self::Renderer, RendererError>;
}

/// Draws the lines of a view into somebody's render pass.
pub trait LineRenderer: Send {
    /// Uploads what changed since the last call. The viewport of `camera` is the whole target.
    fn prepare(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, camera: &Camera);

    /// Records what the view last prepared needs before its render pass: compute passes, and render passes into textures of
    /// the renderer's own. Nothing, unless a renderer says so.
    fn encode(&self, _encoder: &mut wgpu::CommandEncoder) {}

    /// What the user should know of the view last prepared: why its lines may be wrong, and what to choose instead.
    fn warning(&self) -> Option<String> {
        None
    }

    /// Records the draws of the view last prepared, in the render pass after [`encode`](Self::encode).
    fn draw(&self, pass: &mut wgpu::RenderPass<'_>);
}
