//! [`Viewpoint`], which decides facing, and [`Camera`], which is a viewpoint with a projection and a viewport.
//!
//! World and view space are right-handed; a camera looks down its own -Z, so *depth* is `-z` in view space, the distance
//! along the axis, not along the ray. Pixels have their origin at the top left and their centres at `.5`. Clip space is
//! WebGPU's: y up, depth 0 to 1.

mod camera;
mod preset;

pub use camera::{Camera, ClipRange, DepthDirection, FRAMING_MARGIN, Framing, MAX_VIEWPORT, Projected, Projection};
pub use preset::{UpAxis, ViewPreset};

use glam::Vec3;

/// Where a mesh is seen from: all that facing depends on.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Viewpoint {
    /// From a point, in object space.
    Perspective {
        /// The eye (Hall's P).
        eye: Vec3,
    },
    /// From infinitely far, along a direction in object space.
    Orthographic {
        /// Direction from the object *towards* the viewer; any length but zero.
        toward_viewer: Vec3,
    },
}

/// Why a camera cannot be made.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ViewError {
    /// Eye, target or up is not finite.
    #[error("eye, target and up must be finite")]
    NotFinite,
    /// What is to be seen is so large or so far off that 32-bit numbers cannot hold an eye that sees it.
    #[error("the mesh is too large to be seen whole by a camera in 32-bit numbers; scale it down")]
    TooLarge,
    /// There is no direction to look in.
    #[error("eye and target are the same point; move one of them")]
    NoDirection,
    /// Up is zero or along the viewing direction.
    #[error("up is zero or parallel to the viewing direction; choose another up")]
    NoUp,
    /// Field of view outside ]0, 180[ degrees, or height not above 0.
    #[error("the field of view must lie between 0 and 180 degrees, an orthographic height above 0")]
    Projection,
    /// A viewport without pixels or beyond [`MAX_VIEWPORT`].
    #[error("the viewport must be 1x1 to 16384x16384 pixels")]
    Viewport,
}
