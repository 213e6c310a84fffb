//! Silhouette texture: detailed outlines from a coarse hull and one texture lookup per fragment.
//!
//! H. Wu, L.-Y. Wei, X. Wang and B. Guo, "Silhouette Texture", Eurographics Symposium on Rendering 2006.

pub mod atlas;
pub mod bake;
pub mod border_search;
pub mod centers;
pub mod checkpoint;
pub mod compression;
pub mod correspondence;
mod directions;
mod fingerprint;
pub mod frame;
#[cfg(feature = "gpu")]
pub mod gpu;
pub mod hull;
pub mod lobe;
pub mod lookup;
#[cfg(feature = "gpu")]
pub mod method;
pub mod sampling_error;
pub mod silhouette_texture;
pub mod siltex;
pub mod tangents;
mod target;
pub mod tile;
mod tile_bytes;
pub mod visibility_function;
pub mod volume_size;

pub use bake::{AngleFormat, Bake, BakeError, BakeOptions, BakeReport, CenterRule};
pub use frame::Frame;
pub use hull::Hull;
pub use lobe::LobeRule;
#[cfg(feature = "gpu")]
pub use method::{
    NormalMapHull, NormalMapHullOptions, Texture, TextureLines, TextureLinesOptions, TextureOptions, Textures,
};
pub use silhouette_texture::{Angles, FacePlace, Parts, SilhouetteTexture, Terms, VisibilityRule};
pub use visibility_function::VisibilityFunction;
pub use volume_size::VolumeSize;
