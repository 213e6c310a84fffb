//! Silhouette texture: detailed outlines from a coarse hull and one texture lookup per fragment.
//!
//! H. Wu, L.-Y. Wei, X. Wang and B. Guo, "Silhouette Texture", Eurographics Symposium on Rendering 2006.

pub mod carving;
pub mod frame;
#[cfg(feature = "gpu")]
pub mod gpu;
pub mod hull;
pub mod silhouette_texture;
pub mod volume_size;

pub use carving::{AzimuthShift, HullPoint};
pub use frame::Frame;
pub use hull::Hull;
pub use silhouette_texture::{Angles, FacePlace, Parts, SilhouetteTexture, Terms, VisibilityRule};
pub use volume_size::VolumeSize;
