//! [`FrameViewError`]: why matrices do not make a view.

use silhouette_core::view::DepthDirection;

/// Why matrices do not make a view.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum FrameViewError {
    /// An entry of a matrix is NaN or infinite.
    #[error("the {matrix} matrix has an entry that is not finite")]
    NotFinite {
        /// `"view"`, `"projection"` or `"model"`.
        matrix: &'static str,
    },
    /// A matrix maps space to a plane, a line or a point.
    #[error("the {matrix} matrix is singular; give one that can be inverted")]
    Singular {
        /// `"view"`, `"projection"` or `"model"`.
        matrix: &'static str,
    },
    /// View and model must be affine.
    #[error("the last row of the {matrix} matrix is not (0, 0, 0, 1); put perspective into the projection")]
    NotAffine {
        /// `"view"` or `"model"`.
        matrix: &'static str,
    },
    /// The projection's last two rows are not those of a perspective or of an orthographic view.
    #[error("depth and w of the projection must depend on view-space z alone, and w on z or on nothing")]
    Projection,
    /// The near plane is not nearer than the far plane in the direction stated.
    #[error("the projection's near and far plane do not fit the depth direction {0:?}")]
    Depths(DepthDirection),
    /// The viewport has no pixel.
    #[error("the viewport has no pixel")]
    Viewport,
}
