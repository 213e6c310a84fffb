//! The drawing convention between a silhouette method and a wgpu application.
//!
//! A method's renderer is middleware: it creates no device, owns no window, submits nothing and reads nothing back.
//! The application calls [`LineRenderer::prepare`] once a frame, which uploads what changed, begins a render pass whose
//! attachments match [`TargetFormats`], cleared as [`TargetFormats`] says, and calls [`LineRenderer::draw`].

use silhouette_core::method::Method;
use silhouette_core::view::{Camera, DepthDirection};

/// The attachments of the render pass that a renderer draws into.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct TargetFormats {
    /// Format of the only colour attachment, cleared to the paper's colour.
    pub color: wgpu::TextureFormat,
    /// Format of the depth attachment, cleared to [`clear_depth`](Self::clear_depth).
    pub depth: wgpu::TextureFormat,
    /// Which end of the depth buffer is near.
    pub depth_direction: DepthDirection,
    /// Samples a pixel of both attachments.
    pub samples: u32,
}

/// A method that draws the lines of a view itself.
pub trait DrawsLines: Method {
    /// Its renderer on a device.
    type Renderer: LineRenderer + 'static;

    /// Uploads the mesh and builds the pipelines.
    fn renderer(&self, device: &wgpu::Device, queue: &wgpu::Queue, formats: TargetFormats) -> Self::Renderer;
}

/// Draws the lines of a view into somebody's render pass.
pub trait LineRenderer: Send {
    /// Uploads what changed since the last call.
    fn prepare(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, camera: &Camera);

    /// Records the draws of the view last prepared.
    fn draw(&self, pass: &mut wgpu::RenderPass<'_>);
}
