//! [`SmoothingOptions`]: the options in the words of the command line.
//!
//! The default of both angles lies between those of a hexagon and of a square: what turns by less is taken for smooth, what
//! turns by more for sharp.

use crate::feature_segments::Tangents;
use crate::perturbation::Perturbation;
use crate::sampling::Sampling;
use crate::shading_normals::NormalWeights;
use crate::silhouette_segments::SegmentLaw;
use crate::vertex_visibility::Cells;

silhouette_core::option_choice! {
    /// What makes the triangles of a drawn view.
    pub enum Path {
        /// The GPU, by compute stages in 32 bits; nothing is read back.
        Gpu = "gpu",
        /// The CPU in 64 bits; the triangles are uploaded.
        Cpu = "cpu",
    }
}

silhouette_core::option_choice! {
    /// What a drawn view keeps of the invisible parts of silhouette triangles. Triangles that are written or handed out always have
    /// both parts.
    pub enum Invisible {
        /// What faces the viewer, of a closed mesh that no plane cuts and no eye is in; of any other mesh everything.
        LeftOut = "left-out",
        /// Everything: the surface is closed where the mesh is.
        Kept = "kept",
    }
}

silhouette_core::method_options! {
    /// Options of [`Smoothing`](crate::Smoothing).
    pub struct SmoothingOptions {
        /// How far the polyline that a curve is drawn as may stray from it.
        pub tolerance_px: f64 = number("tolerance", 0.01..=64.0 "px", default 1.0, sweep log 0.1..=16.0),
        /// Steps of Newton's method on the true equation of silhouette points, seen in perspective; 0 leaves the paper's approximation.
        pub newton_steps: u32 = whole("newton", 0..=8, default 3, sweep linear 0..=4),
        /// How a silhouette segment is interpolated between its two points.
        pub segments: SegmentLaw = choice("segments"),
        /// Dihedral angle from which an edge is a feature edge; 180 leaves those that the mesh came with, and where the surface ends or branches.
        pub crease_deg: f64 = number("crease", 0.0..=180.0 "degrees", default 75.0),
        /// Turn from which a feature polyline ends at a vertex; 180 lets it run around all corners.
        pub corner_deg: f64 = number("corner", 0.0..=180.0 "degrees", default 75.0),
        /// How much each face counts in the shading normal of a vertex.
        pub normals: NormalWeights = choice("normals"),
        /// Whether vertices near concave silhouettes are lowered, so that they hide none.
        pub perturbation: Perturbation = choice("perturbation"),
        /// How vertices are clustered to decide their visibility.
        pub cells: Cells = choice("cells"),
        /// How the number of samples of a silhouette segment is found.
        pub sampling: Sampling = choice("sampling"),
        /// The tangent of a feature polyline at a vertex.
        pub tangents: Tangents = choice("tangents"),
        /// What a drawn view keeps of the invisible parts of silhouette triangles.
        pub invisible: Invisible = choice("invisible"),
        /// What makes the triangles of a drawn view.
        pub path: Path = choice("path", sweep ["gpu", "cpu"]),
    }
}
