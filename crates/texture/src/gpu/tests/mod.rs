mod lines;
mod outline;
mod scene;
mod styles;
mod twin;

use super::{Drawing, Filtering, Shading, TexturePipelines, TextureRenderer, TextureStyle, TextureVolume};
use crate::SilhouetteTexture;
use silhouette_gpu::{Color, TargetFormats};
use silhouette_render::Gpu;
use std::sync::Arc;

/// White where the object is.
pub(super) fn flat() -> TextureStyle {
    TextureStyle::new(Drawing::Surface(Shading::Flat(Color::WHITE)))
}

pub(super) fn volume(gpu: &Gpu, texture: &SilhouetteTexture, filtering: Filtering) -> Arc<TextureVolume> {
    Arc::new(TextureVolume::new(gpu.device(), gpu.queue(), texture, filtering).unwrap())
}

pub(super) fn renderer(
    gpu: &Gpu,
    formats: TargetFormats,
    style: TextureStyle,
    volume: &Arc<TextureVolume>,
) -> TextureRenderer {
    let pipelines = Arc::new(TexturePipelines::new(gpu.device(), formats, style, volume.form()));
    TextureRenderer::new(gpu.device(), &pipelines, volume, None).unwrap()
}
