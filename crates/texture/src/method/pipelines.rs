//! [`MethodPipelines`]: pipelines of a method, with the texture that it draws on a device.

use crate::gpu::{Filtering, TexturePipelines, TextureRenderer, TextureStyle, TextureVolume, VolumeForm};
use crate::silhouette_texture::SilhouetteTexture;
use silhouette_gpu::{MeshBuffers, RendererError, TargetFormats};
use std::sync::{Arc, OnceLock};

/// The pipelines of a method that was prepared for a mesh, and its texture, which is uploaded with the first renderer and shared by
/// all.
#[derive(Debug)]
pub struct MethodPipelines {
    texture: Arc<SilhouetteTexture>,
    filtering: Filtering,
    pipelines: Arc<TexturePipelines>,
    volume: OnceLock<Arc<TextureVolume>>,
}

impl MethodPipelines {
    pub(super) fn new(
        device: &wgpu::Device,
        formats: TargetFormats,
        style: TextureStyle,
        texture: &Arc<SilhouetteTexture>,
        filtering: Filtering,
    ) -> Self {
        let form = VolumeForm::new(texture, filtering);
        Self {
            texture: Arc::clone(texture),
            filtering,
            pipelines: Arc::new(TexturePipelines::new(device, formats, style, form)),
            volume: OnceLock::new(),
        }
    }

    /// The texture on the device, uploaded now if it was not.
    fn volume(&self, device: &wgpu::Device, queue: &wgpu::Queue) -> Result<&Arc<TextureVolume>, RendererError> {
        if let Some(volume) = self.volume.get() {
            return Ok(volume);
        }
        // Of two threads that both upload, one drops what it has.
        let volume = Arc::new(TextureVolume::new(device, queue, &self.texture, self.filtering)?);
        Ok(self.volume.get_or_init(|| volume))
    }

    pub(super) fn renderer(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        mesh: &Arc<MeshBuffers>,
    ) -> Result<TextureRenderer, RendererError> {
        let volume = self.volume(device, queue)?;
        TextureRenderer::new(device, &self.pipelines, volume, Some(mesh))
    }
}
