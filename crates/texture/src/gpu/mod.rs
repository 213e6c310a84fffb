//! Draws a [`SilhouetteTexture`](crate::SilhouetteTexture) through the convention of [`silhouette_gpu`], and
//! [bakes](GpuBake) one on a device.
//!
//! 1. A [`TextureVolume`] holds the hull and all that was baked on it on a device ([`Filtering`]: in which form). It is shared by all
//!    instances.
//! 2. [`TexturePipelines`] draw volumes of one [`VolumeForm`] as a [`TextureStyle`] says: the [surface](Drawing::Surface), the
//!    [outlines](Drawing::Outlines) (equation 5), or for comparison the [whole hull](Drawing::Hull).
//! 3. A [`TextureRenderer`] is one instance of an object, with its own model matrix.
//!
//! Departures from the paper:
//!
//! 1. Fragments are discarded before they write depth, so that the front layers of the hull (up to three and more for one pixel)
//!    may be drawn in any order. With a depth buffer that is written first, a layer that shows nothing hides the one behind it.
//! 2. Where the near plane meets the hull, its front faces are cut off or lie behind the eye. The fine mesh is drawn instead.
//! 3. Edges may be cut at each of four samples of a pixel ([`Edge`]): the stored angle minus that of view is a smooth function of
//!    the image. The paper's edges are whole pixels.
//! 4. Outlines have the same width everywhere ([`OutlineWidth`]); the paper's grows with the distance of the hull from the object.

mod bake;
mod hull_uniform;
mod near_plane;
mod pipelines;
mod renderer;
mod style;
mod texture_vertices;
mod volume;

#[cfg(test)]
mod tests;

pub use bake::{GpuBake, GpuBakeError, GpuBakeReport};
pub use pipelines::TexturePipelines;
pub use renderer::TextureRenderer;
pub use style::{Drawing, Edge, OutlineStyle, OutlineWidth, Shading, TextureStyle};
pub use volume::{Filtering, TextureVolume, VolumeForm};
