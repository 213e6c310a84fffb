//! Headless wgpu: one application of the drawing convention in [`silhouette_gpu`].
//!
//! 1. [`Gpu`]: an adapter by preference, a device whose errors come back as values, GPU timestamps.
//! 2. [`Target`]: colour and depth textures; a pass drawn into them is submitted and waited for by [`Gpu::draw`].
//!    [`Image`] and [`DepthImage`] are read back from it.
//! 3. [`FillPass`]: the mesh itself, flat, lit, or depth alone.
//!    [`FaceIdPass`]: which face is nearest at each pixel.
//! 4. [`LinePass`]: polylines as strokes of exact pixel width, hidden where the mesh is in front.
//! 5. [`ReferenceRenderer`]: fill and lines at n x n samples a pixel, in tiles, for any size; and the depth of all
//!    samples as a [`ReferenceDepth`], which answers visibility on the CPU as the lines' shader does on the GPU.
//!
//! What a pass sees is a [`PassView`]. Raster output is the same bits from run to run on one adapter; between adapters
//! it may differ by a rounding.

mod adapter;
mod adapter_choice;
mod depth_readback;
mod error;
mod face_ids;
mod fill;
mod gpu;
mod image;
mod lines;
mod pass_view;
mod read_back;
mod reference;
mod submit;
mod target;
pub mod testing;
mod timestamps;

pub use adapter::AdapterDescription;
pub use adapter_choice::AdapterChoice;
pub use error::GpuError;
pub use face_ids::FaceIdPass;
pub use fill::{Cull, FillPass, FillStyle, Shade};
pub use gpu::{DEFAULT_MEMORY_BUDGET, Gpu};
pub use image::{DepthImage, IdImage, Image, ImageError};
pub use lines::line_visibility::{DepthScale, SceneDepth};
pub use lines::{Cap, Hidden, Join, LinePass, LineStyle, Polylines, ScreenSegment};
pub use pass_view::{PassView, Tile};
pub use reference::{DEFAULT_SUPERSAMPLING, ReferenceDepth, ReferenceRenderer, Scene};
pub use submit::{Load, PassTime};
pub use target::{DEFAULT_FORMATS, Target};
