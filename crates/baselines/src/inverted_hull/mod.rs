//! [`InvertedHull`]: the mesh drawn once more, larger and from inside.
//!
//! 1. The mesh's front faces, as the interior says.
//! 2. `outline_normals.rs`: one normal per place, the mean of all faces there; for moving meshes on the device.
//! 3. `hull.rs`: the mesh again with its vertices pushed along their normals, back faces only. They lie behind the mesh, so that
//!    they show beyond its outline and where a part of it stands before a farther one.
//!
//! # Departures from what engines do
//! 1. Engines push in the mesh's own space or in world space, so that width depends on distance and on how far the normal points
//!    at the viewer. `push=image`, the default, moves each vertex by the width in the image, whatever its depth, and back or
//!    forth as the normal leads, by less than that.
//! 2. Engines bake normals for the outline at import, or push along render normals, which tears the hull at hard edges
//!    (`normals=split`). Here they are made from positions alone, and made again on the device while vertices move.

mod method;
mod outline_normals;

#[cfg(feature = "gpu")]
mod hull;
#[cfg(feature = "gpu")]
mod renderer;

pub use method::{HullNormals, InvertedHull, InvertedHullOptions, Push};
pub use outline_normals::OutlineNormals;
#[cfg(feature = "gpu")]
pub use renderer::{InvertedHullPipelines, InvertedHullRenderer};
