//! Pictures on the CPU.

use crate::device::Device;
use crate::scene::SIZE;
use std::error::Error;
use std::path::Path;

/// Texels as the target stores them, premultiplied, row by row.
#[derive(Debug, Clone, PartialEq)]
pub struct Picture {
    /// Red, green, blue and alpha; linear light, or encoded bytes over 255.
    pub texels: Vec<[f32; 4]>,
    is_linear: bool,
}

impl Picture {
    /// Reads a target of one of the engine's two formats.
    pub fn read(device: &Device, texture: &wgpu::Texture, format: wgpu::TextureFormat) -> Result<Self, Box<dyn Error>> {
        let is_linear = format == wgpu::TextureFormat::Rgba16Float;
        let row = SIZE[0] * if is_linear { 8 } else { 4 };
        let readable = device.device.create_buffer(&wgpu::BufferDescriptor {
            label: None,
            size: u64::from(row) * u64::from(SIZE[1]),
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        let mut encoder = device.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        // Rows of 640 texels of 4 or 8 bytes are multiples of the 256 bytes that copies are aligned to.
        let layout = wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(row), rows_per_image: None };
        let destination = wgpu::TexelCopyBufferInfo { buffer: &readable, layout };
        encoder.copy_texture_to_buffer(texture.as_image_copy(), destination, texture.size());
        device.queue.submit([encoder.finish()]);
        readable.map_async(wgpu::MapMode::Read, .., |_| {});
        device.device.poll(wgpu::PollType::wait_indefinitely())?;
        let bytes = readable.get_mapped_range(..)?;
        let texels = if is_linear {
            bytes.chunks_exact(8).map(|t| [0, 2, 4, 6].map(|at| half(u16::from_le_bytes([t[at], t[at + 1]])))).collect()
        } else {
            bytes.chunks_exact(4).map(|t| [2, 1, 0, 3].map(|at: usize| f32::from(t[at]) / 255.0)).collect()
        };
        Ok(Self { texels, is_linear })
    }

    /// Writes a PNG, with straight alpha.
    pub fn save(&self, path: &Path) -> Result<(), Box<dyn Error>> {
        let bytes = self.texels.iter().flat_map(|&[red, green, blue, alpha]| {
            let straight = [red, green, blue].map(|part| part / alpha.max(1e-6));
            let [r, g, b] = straight.map(|part| if self.is_linear { encoded(part) } else { part });
            [r, g, b, alpha].map(|part| (part.clamp(0.0, 1.0) * 255.0).round() as u8)
        });
        let image = image::RgbaImage::from_raw(SIZE[0], SIZE[1], bytes.collect()).ok_or("as many texels as pixels")?;
        Ok(image.save(path)?)
    }
}

/// The value of a 16-bit float.
fn half(bits: u16) -> f32 {
    let sign = if bits & 0x8000 == 0 { 1.0 } else { -1.0 };
    let (exponent, fraction) = (i32::from((bits >> 10) & 31), f32::from(bits & 1023) / 1024.0);
    sign * if exponent == 0 { fraction * 2.0_f32.powi(-14) } else { (1.0 + fraction) * 2.0_f32.powi(exponent - 15) }
}

/// The sRGB value of linear light.
fn encoded(linear: f32) -> f32 {
    if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 }
}
