//! [`RendererError`]: why a renderer cannot be made on a device, or a view prepared.

use crate::frame_view_error::FrameViewError;
use crate::mesh_buffers::MeshTooLarge;
use silhouette_core::view::DepthDirection;

/// Why a renderer cannot be made, or a view prepared.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum RendererError {
    /// The device's buffers cannot hold the mesh, or what is derived from it.
    #[error(transparent)]
    MeshTooLarge(#[from] MeshTooLarge),
    /// A texture of what is drawn is larger than the device's can be.
    #[error(
        "{what} of this texture are {texels} texels along a side; a texture of this device has at most {limit}; {instead}"
    )]
    TextureTooLarge {
        /// What is too large, in the plural.
        what: &'static str,
        /// Texels along the longest side, or layers.
        texels: u32,
        /// What the device takes.
        limit: u32,
        /// What to do instead, as a clause.
        instead: &'static str,
    },
    /// Pipelines were made for what is stored in another form.
    #[error("the pipelines were made for {what} of another form; make them for the form of this one")]
    OtherForm {
        /// What the renderer draws, in the plural.
        what: &'static str,
    },
    /// There are more of something than the textures of a renderer can hold.
    #[error("{count} {what}; at most {limit} can be drawn together")]
    TooMany {
        /// What there are too many of, in the plural.
        what: &'static str,
        /// How many there are.
        count: usize,
        /// How many there may be.
        limit: usize,
    },
    /// The options need a feature that the device was made without.
    #[error("{what} needs the adapter feature {feature}, which this device lacks; {instead}")]
    MissingFeature {
        /// What was asked for.
        what: &'static str,
        /// Name of the feature in wgpu.
        feature: &'static str,
        /// What to choose instead, as a clause.
        instead: &'static str,
    },
    /// The view's projection fills the depth buffer from the other end than the target says.
    #[error("the view's depth is {view:?}, the target's {target:?}; make both the same")]
    DepthDirection {
        /// Direction of the target.
        target: DepthDirection,
        /// Direction of the view.
        view: DepthDirection,
    },
    /// A view derived from the caller's cannot be made.
    #[error(transparent)]
    View(#[from] FrameViewError),
}
