//! [`FrameRenderer`], and the capabilities that yield one: [`DrawsLines`] and [`FillsImage`].

use crate::formats::TargetFormats;
use crate::frame_view::FrameView;
use crate::mesh_buffers::MeshBuffers;
use crate::pen::PenPlacement;
use crate::renderer_error::RendererError;
use silhouette_core::method::Method;
use silhouette_core::view::{Camera, ClipRange};
use std::sync::Arc;

/// Draws frames into a render pass of the caller's.
///
/// Once per frame: [`prepare`](Self::prepare), [`encode`](Self::encode) with the encoder that the pass will be begun with, then
/// [`draw`](Self::draw) in the pass. Nothing is submitted and nothing is read back. Colours are premultiplied by alpha.
pub trait FrameRenderer: Send {
    /// Uploads what changed since the last call. It takes effect with the next submission.
    ///
    /// # Errors
    /// [`RendererError`]: the view's depth direction is not the target's, or the device has no room for what the view needs.
    fn prepare(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, view: &FrameView) -> Result<(), RendererError>;

    /// Records what the view last prepared needs before its render pass: compute passes, and render passes into textures of
    /// the renderer's own. Nothing, unless a renderer says so.
    fn encode(&self, _encoder: &mut wgpu::CommandEncoder) {}

    /// Records the draws of the view last prepared. Sets the pass's viewport; leaves pipeline, bind groups and buffers changed.
    fn draw(&self, pass: &mut wgpu::RenderPass<'_>);

    /// What the user should know of the view last prepared: why its lines may be wrong, and what to choose instead.
    fn warning(&self) -> Option<String> {
        None
    }

    /// The depths that a view from `camera` should hold so that nothing is clipped, given those that hold the mesh. Whoever
    /// draws several meshes with one depth buffer takes the union of theirs.
    fn clip_range(&self, _camera: &Camera, mesh: ClipRange) -> ClipRange {
        mesh
    }
}

/// A method that draws the lines of a view itself.
///
/// [`pipelines`](Self::pipelines) are made once for each device, formats and options, [`MeshBuffers`] once for each mesh; both
/// are shared by all renderers, of which each instance in a scene has one.
pub trait DrawsLines: Method {
    /// What all renderers with the same options, on the same device and formats, share.
    type Pipelines: Send + Sync + 'static;
    /// Its renderer.
    type Renderer: FrameRenderer + 'static;

    /// On which side of the true line its ink lies.
    fn pen_placement(&self) -> PenPlacement;

    /// Builds the pipelines. Some milliseconds.
    ///
    /// # Errors
    /// [`RendererError`]: the device lacks what the options ask for.
    fn pipelines(&self, device: &wgpu::Device, formats: TargetFormats) -> Result<Self::Pipelines, RendererError>;

    /// A renderer of one instance of the mesh.
    ///
    /// # Errors
    /// [`RendererError`]: what is derived from the mesh is too large for the device.
    fn renderer(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        pipelines: &Arc<Self::Pipelines>,
        mesh: &Arc<MeshBuffers>,
    ) -> Result<Self::Renderer, RendererError>;
}

/// A method that fills the image of the mesh: its surface, with a silhouette of its own.
///
/// Shared as with [`DrawsLines`].
pub trait FillsImage: Method {
    /// What all renderers with the same options, on the same device and formats, share.
    type Pipelines: Send + Sync + 'static;
    /// Its renderer.
    type Renderer: FrameRenderer + 'static;

    /// Builds the pipelines. Some milliseconds.
    ///
    /// # Errors
    /// [`RendererError`]: the device lacks what the options ask for.
    fn pipelines(&self, device: &wgpu::Device, formats: TargetFormats) -> Result<Self::Pipelines, RendererError>;

    /// A renderer of one instance of the mesh.
    ///
    /// # Errors
    /// [`RendererError`]: what is derived from the mesh is too large for the device.
    fn renderer(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        pipelines: &Arc<Self::Pipelines>,
        mesh: &Arc<MeshBuffers>,
    ) -> Result<Self::Renderer, RendererError>;
}
