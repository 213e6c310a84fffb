#![doc = include_str!("../README.md")]
//!
//! # The method
//!
//! A coarse hull is drawn in
//! place of a fine mesh. At each point of it a *visibility function* says in which directions the mesh is seen there; its border,
//! as an angle per azimuth, is stored in a 3-D texture. Fragments from which the mesh is not seen are discarded.
//!
//! With the feature `gpu`, which is on by default, [`Texture`], [`TextureLines`] and [`NormalMapHull`] draw it in your own wgpu pass
//! through the convention of `silhouette_gpu`; [`gpu`] has what they are made of, for textures from files and for shading of your own.
//!
//! # The steps
//!
//! | step | paper | file |
//! |---|---|---|
//! | a hull that encloses the mesh | 3 | [`hull`](mod@hull) |
//! | the hull as blocks of texels | 3.3 | [`atlas`] |
//! | the visibility function | 3.2 | [`visibility_function`] |
//! | the middle of its lobe, and where azimuths begin | 3.3 | [`centers`], [`tangents`], [`frame`] |
//! | the border of the lobe at each azimuth | 3.3 | [`border_search`], [`lobe`] |
//! | colours and normals | 3.1 | [`correspondence`] |
//! | all of it, on all cores, interrupted and resumed | | [`bake`](mod@bake), [`tile`], [`checkpoint`] |
//! | what sampling costs | Eq. 3 | [`sampling_error`](mod@sampling_error), [`lookup`] |
//! | compression | 3.5 | [`compression`] |
//! | files | | [`siltex`] |
//! | rendering | 3.4, Eqs. 4 and 5, appendix A | `gpu` |
//!
//! Each file lists where it departs from the paper, and why; what is printed stays available as an option with the value
//! `as-printed`.
//!
//! # When it fails
//!
//! Where the hull is far from the mesh, as that of few vertices is in creases, a point of it may show several parts of the mesh in
//! directions that no single lobe holds. Shading is that of one point of the mesh per point of the hull, whatever the view. Other
//! objects between hull and mesh are drawn as behind the hull. Meshes must not move.

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
