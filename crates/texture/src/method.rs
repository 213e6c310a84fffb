//! The methods of this crate: [`Texture`], [`TextureLines`] and [`NormalMapHull`].
//!
//! All of them draw a hull with what was baked on it, which [`Textures`] makes or has been given.

mod normal_map_hull;
mod options;
mod pipelines;
mod published;
mod texture;
mod texture_lines;
mod textures;

#[cfg(all(test, feature = "simplify"))]
mod tests;

pub use normal_map_hull::{NormalMapHull, NormalMapHullOptions};
pub use options::{BakeChoice, Inside, WidthLaw};
pub use pipelines::MethodPipelines;
pub use texture::{Texture, TextureOptions};
pub use texture_lines::{TextureLines, TextureLinesOptions};
pub use textures::{TextureError, Textures, bake, hull};
