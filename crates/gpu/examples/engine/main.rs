//! Lines in an engine of one's own: its device, its passes, its matrices, its shading.
//!
//! ```text
//! cargo run --release -p silhouette-gpu --example engine -- out/engine
//! ```
//!
//! Two objects, seen with reversed depth and an infinite far plane, four samples per pixel: a torus with a rotation and a
//! non-uniform scale, whose silhouette edges are found on the CPU, and a mirrored knot whose vertices a compute stage moves in a
//! buffer of the engine's, with lines of image precision. In both colour formats, three pictures: lines over the engine's own
//! shading, the shading without lines, and lines only on a transparent ground.
//!
//! 1. [`device`]: the engine's adapter and device. 2. [`scene`]: objects, matrices, what moves. 3. [`shading`]: how the engine
//!    draws them. 4. [`lines`]: what this crate adds. 5. [`frame`]: a frame in one submission. 6. [`picture`]: files.

mod device;
mod frame;
mod lines;
mod picture;
mod scene;
mod shading;
#[cfg(test)]
mod tests;

use device::Device;
use frame::{Frame, Shown};
use std::error::Error;
use std::path::PathBuf;

/// The two kinds of target that engines have: linear light, and bytes that the hardware encodes.
const COLORS: [wgpu::TextureFormat; 2] = [wgpu::TextureFormat::Rgba16Float, wgpu::TextureFormat::Bgra8UnormSrgb];

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args_os().nth(1).map_or_else(|| PathBuf::from("out/engine"), PathBuf::from);
    std::fs::create_dir_all(&folder)?;
    let device = Device::new()?;
    for color in COLORS {
        let mut frame = Frame::new(&device, color)?;
        for (shown, name) in [(Shown::LinesOverShading, "over"), (Shown::Shading, "shading"), (Shown::Lines, "lines")] {
            let picture = frame.draw(&device, shown, 0.4)?;
            picture.save(&folder.join(format!("{color:?}-{name}.png").to_lowercase()))?;
        }
    }
    Ok(())
}
