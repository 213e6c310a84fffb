//! Textures and buffers back on the CPU.

use crate::depth_readback::DepthReader;
use crate::error::GpuError;
use crate::gpu::{Gpu, lock};
use crate::image::{DepthImage, IdImage, Image};
use crate::target::Target;
use std::sync::{Arc, Mutex};

/// Most bytes of the bands of rows that a texture is read in, so that a large one needs no second copy of itself.
const BAND_BYTES: u64 = 64 << 20;

impl Target {
    /// The colour, resolved, after the last pass.
    ///
    /// # Errors
    /// [`GpuError::ColorFormat`] where the colour is not four bytes RGBA; [`GpuError::OverBudget`]; what the device
    /// reports.
    pub fn read_color(&self, gpu: &Gpu) -> Result<Image, GpuError> {
        let format = self.formats().color;
        if !matches!(format, wgpu::TextureFormat::Rgba8Unorm | wgpu::TextureFormat::Rgba8UnormSrgb) {
            return Err(GpuError::ColorFormat(format));
        }
        let rgba = read_texture(gpu, self.color_texture())?;
        let [width, height] = self.size();
        Ok(Image { width, height, rgba })
    }

    /// The colour of an `R32Uint` target after the last pass.
    ///
    /// # Errors
    /// [`GpuError::ColorFormat`] where the colour is of another format; [`GpuError::OverBudget`]; what the device reports.
    pub fn read_ids(&self, gpu: &Gpu) -> Result<IdImage, GpuError> {
        let format = self.formats().color;
        if format != wgpu::TextureFormat::R32Uint {
            return Err(GpuError::ColorFormat(format));
        }
        let bytes = read_texture(gpu, self.color_texture())?;
        let values = bytes.chunks_exact(4).map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect();
        let [width, height] = self.size();
        Ok(IdImage { width, height, values })
    }

    /// The values of the depth buffer after the last pass, in any depth format.
    ///
    /// # Errors
    /// [`GpuError::MultisampledDepth`]; [`GpuError::OverBudget`]; what the device reports.
    pub fn read_depth(&self, gpu: &Gpu) -> Result<DepthImage, GpuError> {
        let depth = self.single_sample_depth()?;
        let [width, height] = self.size();
        gpu.check_budget(4 * u64::from(width) * u64::from(height))?;
        let reader = match gpu.depth_reader.get() {
            Some(reader) => reader,
            None => {
                let built = gpu.scoped(|| DepthReader::new(gpu.device()))?;
                gpu.depth_reader.get_or_init(|| built)
            }
        };
        let (floats, view, bind_group) = gpu.scoped(|| reader.bind(gpu.device(), depth, self.size()))?;
        let attachment = wgpu::RenderPassColorAttachment {
            view: &view,
            depth_slice: None,
            resolve_target: None,
            ops: wgpu::Operations { load: wgpu::LoadOp::Clear(wgpu::Color::BLACK), store: wgpu::StoreOp::Store },
        };
        gpu.submit_pass(&[Some(attachment)], None, |_| {}, |pass| reader.draw(pass, &bind_group))?;
        let bytes = read_texture(gpu, &floats)?;
        let values = bytes.chunks_exact(4).map(|b| f32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect();
        Ok(DepthImage { width, height, values })
    }
}

/// The texels of a texture with four bytes each, row by row without padding.
fn read_texture(gpu: &Gpu, texture: &wgpu::Texture) -> Result<Vec<u8>, GpuError> {
    let (width, height) = (texture.width(), texture.height());
    let row = u64::from(width) * 4;
    gpu.check_budget(row * u64::from(height))?;
    let padded = row.next_multiple_of(u64::from(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT));
    let rows_per_band = (BAND_BYTES / padded).clamp(1, u64::from(height)) as u32;
    let buffer = gpu.scoped(|| {
        gpu.device().create_buffer(&wgpu::BufferDescriptor {
            label: Some("read-back"),
            size: padded * u64::from(rows_per_band),
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        })
    })?;
    let mut texels = Vec::with_capacity((row * u64::from(height)) as usize);
    for first in (0..height).step_by(rows_per_band as usize) {
        let rows = rows_per_band.min(height - first);
        let mut source = texture.as_image_copy();
        source.origin.y = first;
        let submission = gpu.scoped(|| {
            let mut encoder = gpu.device().create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
            let layout =
                wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(padded as u32), rows_per_image: None };
            let destination = wgpu::TexelCopyBufferInfo { buffer: &buffer, layout };
            let size = wgpu::Extent3d { width, height: rows, depth_or_array_layers: 1 };
            encoder.copy_texture_to_buffer(source, destination, size);
            gpu.queue().submit([encoder.finish()])
        })?;
        gpu.wait(&submission)?;
        gpu.read_buffer(&buffer, |bytes| {
            for padded_row in bytes.chunks_exact(padded as usize).take(rows as usize) {
                texels.extend_from_slice(&padded_row[..row as usize]);
            }
        })?;
    }
    Ok(texels)
}

impl Gpu {
    /// Maps a buffer whose writes are done and passes its bytes to `read`.
    pub(crate) fn read_buffer<T>(&self, buffer: &wgpu::Buffer, read: impl FnOnce(&[u8]) -> T) -> Result<T, GpuError> {
        let outcome = Arc::new(Mutex::new(None));
        let sink = Arc::clone(&outcome);
        self.scoped(|| buffer.map_async(wgpu::MapMode::Read, .., move |result| *lock(&sink) = Some(result)))?;
        self.look()?;
        // Waiting for a submission of its own would be waiting for all that others have submitted meanwhile.
        if lock(&outcome).is_none() {
            let submission = self.scoped(|| self.queue().submit([]))?;
            self.wait(&submission)?;
        }
        match lock(&outcome).take() {
            Some(Ok(())) => {}
            Some(Err(error)) => return Err(GpuError::Internal(error.to_string())),
            None => return Err(GpuError::Internal("a buffer was not mapped in time".to_owned())),
        }
        let view = buffer.get_mapped_range(..).map_err(|error| GpuError::Internal(error.to_string()))?;
        let value = read(&view);
        drop(view);
        buffer.unmap();
        Ok(value)
    }
}
