#![doc = include_str!("../README.md")]
//!
//! # The method
//!
//! [`Smoothing`] is the method of Wang et al. 2008. It needs no fine mesh: curves are laid through
//! the triangles that the silhouette crosses, and those triangles alone are replaced by finer ones.
//!
//! With the feature `gpu`, which is on by default, every method but [`InterpolatedContours`] fills images in your own wgpu pass
//! (`silhouette_gpu::FillsImage`). [`Smoothing`] makes its triangles on the GPU (`gpu`), unless the option `path` says `cpu`.
//!
//! # The steps
//!
//! | step | paper | file |
//! |---|---|---|
//! | feature edges, chained to polylines, each edge replaced by a curve; once per mesh | II, III-A | [`feature_edges`](mod@silhouette_core::feature_edges), [`feature_polylines`](mod@feature_polylines), [`feature_segments`] |
//! | shading normals, one for each vertex and group of faces; once per mesh | III-B | [`shading_normals`](mod@shading_normals), [`shading_mesh`] |
//! | which vertices are visible, in clusters | III-B | [`vertex_visibility`] |
//! | silhouette triangles: faces with visible and invisible vertices | II | [`silhouette_triangles`](mod@silhouette_triangles) |
//! | bridges over their mixed sides | III-C | [`bridges`], [`hermite`] |
//! | silhouette points on the bridges, silhouette segments between them | III-D | [`silhouette_points`], [`emerging_points`], [`silhouette_segments`] |
//! | how finely curves are sampled | III-E | [`sampling`], [`feature_samples`] |
//! | local re-meshing | III-E | [`remeshing`] |
//! | concave segments, and vertices lowered below them | III-E | [`concavity`], [`perturbation`] |
//!
//! Each file lists where it departs from the paper, and why; printed formulas stay available as options with the value
//! `as-printed`. Beside them:
//!
//! 1. Parts that are wound inside out are turned ([`silhouette_core::inside_out`]).
//! 2. Feature polylines end at sharp turns (option `corner`), so that the corners of a sheet stay.
//! 3. Curves of features are output as well, and chained ([`curves`]).
//!
//! # The rivals
//!
//! | method | source | draws | its outline |
//! |---|---|---|---|
//! | [`PnTriangles`] | Vlachos et al. 2001 | every face as (level + 1)² triangles | smooth until one looks closely |
//! | [`PhongTessellation`] | Boubekeur and Alexa 2008 | the same | somewhat flatter |
//! | [`AdaptiveRefinement`] | Dyken et al. 2008 | faces near the silhouette finer | as PN triangles |
//! | [`BoundaryCurve`] | Wang et al. 2003 | curves through the vertices of silhouette edges | jumps from edge to edge |
//! | [`InterpolatedContours`] | Hertzmann and Zorin 2000 | nothing; yields chords | continuous, as coarse as the mesh |
//!
//! # When it fails
//!
//! The method smooths towards what the normals say. Where a coarse mesh has few vertices around a sharp bend, as simplified meshes
//! have at thin parts, normals are wrong and outlines bulge; `docs/methods/smoothing.md` in the repository has figures. Neither
//! hidden parts of curves nor farther faces that hide a concave segment are found.

pub mod bridges;
pub mod concavity;
pub mod curves;
pub mod emerging_points;
pub mod eye;
pub mod feature_polylines;
pub mod feature_samples;
pub mod feature_segments;
pub mod hermite;
pub mod options;
pub mod perturbation;
mod published;
pub mod remeshing;
mod rounding;
pub mod sampling;
pub mod shading_mesh;
pub mod shading_normals;
pub mod silhouette_points;
pub mod silhouette_segments;
pub mod silhouette_triangles;
pub mod smoothing;
pub mod vertex_visibility;
pub mod view_mesh;

pub use eye::{Eye, SmoothingView};
pub use hermite::Hermite;
pub use options::SmoothingOptions;
pub use shading_mesh::ShadingMesh;
pub use smoothing::{DrawnSmoothing, Smoothing};
pub use view_mesh::{MakesTriangles, Origin, Remesher, ViewMesh};

#[cfg(feature = "gpu")]
mod fills_image;
#[cfg(feature = "gpu")]
pub mod gpu;
#[cfg(feature = "gpu")]
pub mod view_mesh_renderer;
#[cfg(feature = "gpu")]
pub use gpu::{ImagePipelines, ImageRenderer, SmoothingPipelines, SmoothingRenderer};
#[cfg(feature = "gpu")]
pub use view_mesh_renderer::{ViewMeshPipelines, ViewMeshRenderer};

pub mod adaptive_refinement;
pub mod boundary_curve;
pub mod face_splitter;
pub mod interpolated_contours;
pub mod phong_tessellation;
pub mod pn_triangles;
pub mod side_curves;
pub mod tessellation;

pub use adaptive_refinement::{AdaptiveRefinement, AdaptiveRefinementOptions};
pub use boundary_curve::{BoundaryCurve, BoundaryCurveOptions};
pub use interpolated_contours::{InterpolatedContours, InterpolatedContoursOptions};
pub use phong_tessellation::{PhongTessellation, PhongTessellationOptions};
pub use pn_triangles::{PnTriangles, PnTrianglesOptions};

#[cfg(test)]
mod tests;
