//! The drawing convention between a silhouette method and a wgpu application.
//!
//! A method's renderer is middleware: it creates no device, owns no window, submits nothing and reads nothing back.
//! The application calls [`LineRenderer::prepare`] once a frame, which uploads what changed, begins a render pass whose
//! attachments match [`TargetFormats`], cleared as [`TargetFormats`] says, and calls [`LineRenderer::draw`].
//!
//! Beside the convention lies what every renderer of a mesh needs: [`MeshBuffers`] and [`CameraUniform`], both relative
//! to a [`LocalFrame`], so that a mesh far from the origin is drawn as sharply as one at the origin.

mod camera;
mod formats;
mod local_frame;
mod mesh_buffers;
mod pen;

pub use camera::{CameraBinding, CameraUniform};
pub use formats::TargetFormats;
pub use local_frame::LocalFrame;
pub use mesh_buffers::{MeshBuffers, MeshTooLarge, POSITION_LAYOUT};
pub use pen::{Pen, PenPlacement};

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
    /// [`MeshTooLarge`] where the device's buffers cannot hold the mesh.
    fn renderer(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        formats: TargetFormats,
    ) -> Result<Self::Renderer, MeshTooLarge>;
}

/// Draws the lines of a view into somebody's render pass.
pub trait LineRenderer: Send {
    /// Uploads what changed since the last call. The viewport of `camera` is the whole target.
    fn prepare(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, camera: &Camera);

    /// Records the draws of the view last prepared.
    fn draw(&self, pass: &mut wgpu::RenderPass<'_>);
}
