//! [`RendererError`]: why a renderer cannot be made on a device.

use crate::MeshTooLarge;

/// Why a renderer cannot be made.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum RendererError {
    /// The device's buffers cannot hold the mesh, or what is derived from it.
    #[error(transparent)]
    MeshTooLarge(#[from] MeshTooLarge),
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
}
