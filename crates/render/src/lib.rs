#![doc = include_str!("../README.md")]
//!
//! # What lies where
//!
//! 1. [`Gpu`]: an adapter by preference, a device whose errors come back as values, GPU timestamps.
//! 2. [`Target`]: colour and depth textures; a pass drawn into them is submitted and waited for by [`Gpu::draw`].
//!    [`Image`] and [`DepthImage`] are read back from it.
//!    [`view_of_mesh`] is a camera's view with depths tight around a mesh.
//! 3. [`FaceIdPass`]: which face is nearest at each pixel.
//! 4. [`ReferenceRenderer`]: fill and lines at n x n samples per pixel, in tiles, for any size; and the depth of all
//!    samples as a [`ReferenceDepth`], which answers visibility on the CPU as the strokes' shader does on the GPU.
//!
//! Raster output is the same bits from run to run on one adapter; between adapters it may differ by a rounding.

mod adapter;
mod adapter_choice;
mod depth_readback;
mod error;
mod face_ids;
mod gpu;
mod image;
mod read_back;
mod reference;
mod submit;
mod target;
mod timestamps;
mod view;

pub use adapter::AdapterDescription;
pub use adapter_choice::AdapterChoice;
pub use error::GpuError;
pub use face_ids::FaceIdPass;
pub use gpu::{DEFAULT_MEMORY_BUDGET, Gpu};
pub use image::{DepthImage, IdImage, Image, ImageError};
pub use reference::{DEFAULT_SUPERSAMPLING, ReferenceDepth, ReferencePicture, ReferenceRenderer};
pub use submit::{Load, PassTime};
pub use target::{DEFAULT_FORMATS, Target};
pub use view::view_of_mesh;
