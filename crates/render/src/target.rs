//! [`Target`]: the textures that a pass draws into.

use crate::error::GpuError;
use crate::gpu::Gpu;
use silhouette_core::view::DepthDirection;
use silhouette_gpu::TargetFormats;

/// Bytes as written, 32-bit float depth with near at 1, one sample a pixel.
pub const DEFAULT_FORMATS: TargetFormats = TargetFormats {
    color: wgpu::TextureFormat::Rgba8Unorm,
    depth: wgpu::TextureFormat::Depth32Float,
    depth_direction: DepthDirection::Reversed,
    samples: 1,
};

/// Colour and depth of one size. With 4 samples a pixel, colour is resolved to one sample at the end of every pass.
#[derive(Debug)]
pub struct Target {
    size: [u32; 2],
    formats: TargetFormats,
    color: wgpu::Texture,
    color_view: wgpu::TextureView,
    multisampled_view: Option<wgpu::TextureView>,
    depth_view: wgpu::TextureView,
}

impl Target {
    /// Allocates the textures: width and height from 1 to the adapter's limit, 1 or 4 samples a pixel.
    ///
    /// # Errors
    /// [`GpuError::Size`], [`GpuError::Samples`], [`GpuError::OverBudget`] before anything is allocated; otherwise what
    /// the device reports.
    pub fn new(gpu: &Gpu, size: [u32; 2], formats: TargetFormats) -> Result<Self, GpuError> {
        gpu.check_size(size)?;
        if !matches!(formats.samples, 1 | 4) {
            return Err(GpuError::Samples { samples: formats.samples, possible: "1 or 4 a pixel" });
        }
        gpu.check_budget(bytes(size, &formats))?;
        let texture = |label, format, samples, usage| {
            gpu.device().create_texture(&wgpu::TextureDescriptor {
                label: Some(label),
                size: wgpu::Extent3d { width: size[0], height: size[1], depth_or_array_layers: 1 },
                mip_level_count: 1,
                sample_count: samples,
                dimension: wgpu::TextureDimension::D2,
                format,
                usage: usage | wgpu::TextureUsages::RENDER_ATTACHMENT,
                view_formats: &[],
            })
        };
        gpu.scoped(|| {
            let readable = wgpu::TextureUsages::COPY_SRC | wgpu::TextureUsages::TEXTURE_BINDING;
            let color = texture("color", formats.color, 1, readable);
            let multisampled = (formats.samples > 1)
                .then(|| texture("samples", formats.color, formats.samples, wgpu::TextureUsages::empty()));
            let depth = texture("depth", formats.depth, formats.samples, wgpu::TextureUsages::TEXTURE_BINDING);
            let view = |texture: &wgpu::Texture| texture.create_view(&wgpu::TextureViewDescriptor::default());
            Self {
                size,
                formats,
                color_view: view(&color),
                color,
                multisampled_view: multisampled.as_ref().map(view),
                depth_view: view(&depth),
            }
        })
    }

    /// Width and height in pixels.
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// Formats of the attachments.
    pub fn formats(&self) -> TargetFormats {
        self.formats
    }

    /// Bytes on the device.
    pub fn bytes(&self) -> u64 {
        bytes(self.size, &self.formats)
    }

    /// The colour with one sample a pixel.
    pub fn color_view(&self) -> &wgpu::TextureView {
        &self.color_view
    }

    /// The depth attachment; it can be bound as a texture too.
    pub fn depth_view(&self) -> &wgpu::TextureView {
        &self.depth_view
    }

    /// The depth attachment for a `texture_depth_2d`.
    ///
    /// # Errors
    /// [`GpuError::MultisampledDepth`].
    pub(crate) fn single_sample_depth(&self) -> Result<&wgpu::TextureView, GpuError> {
        match self.formats.samples {
            1 => Ok(&self.depth_view),
            samples => Err(GpuError::MultisampledDepth { samples }),
        }
    }

    pub(crate) fn color_texture(&self) -> &wgpu::Texture {
        &self.color
    }

    /// The colour attachment, resolved where there are several samples.
    pub(crate) fn color_attachment(&self, load: wgpu::LoadOp<wgpu::Color>) -> wgpu::RenderPassColorAttachment<'_> {
        let ops = wgpu::Operations { load, store: wgpu::StoreOp::Store };
        let (view, resolve_target) = match &self.multisampled_view {
            Some(multisampled) => (multisampled, Some(&self.color_view)),
            None => (&self.color_view, None),
        };
        wgpu::RenderPassColorAttachment { view, depth_slice: None, resolve_target, ops }
    }
}

/// Bytes of all textures of a target; formats of unknown size count as 16 bytes.
fn bytes([width, height]: [u32; 2], formats: &TargetFormats) -> u64 {
    let pixels = u64::from(width) * u64::from(height);
    let color = u64::from(formats.color.block_copy_size(None).unwrap_or(16));
    let samples = u64::from(formats.samples);
    let resolved = if samples > 1 { color } else { 0 };
    // Depth formats of 16 and 24 bits are stored in 2 and 4 bytes.
    let depth = if formats.depth == wgpu::TextureFormat::Depth16Unorm { 2 } else { 4 };
    pixels * (samples * (color + depth) + resolved)
}
