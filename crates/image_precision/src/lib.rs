#![doc = include_str!("../README.md")]
//!
//! # Steps
//!
//! Ramesh Raskar and Michael Cohen, "Image precision silhouette edges", Symposium on Interactive 3D Graphics 1999: every
//! variant of it, and `screen`, the corrected one.
//!
//! 1. The background is cleared to white, depth to the farthest value: the application's render pass.
//! 2. `front_faces.rs`: front faces, white or shaded, depth test "nearer".
//! 3. Back faces, black, depth test "nearer or equal", by variant.
//!
//! A back face is hidden by the front faces before it, except along a silhouette edge, where the two meet and the variant
//! puts a strip of it in front, or beside.
//!
//! | variant | section | step 3 | ink |
//! |---|---|---|---|
//! | [`screen`] | ours | edges of back faces expanded in the image plane | outside, as wide as asked |
//! | [`equal`] | 3.1 | depth test "equal" | (almost) none |
//! | [`wireframe`] | 3.2 | edges of back faces as lines | half of the width shows outside |
//! | [`fixed_pull`] | 3.2 | moved towards the camera | inside, its width depends on the shape |
//! | [`scale`] | 3.2 | scaled about the eye | the same |
//! | [`depth_range`] | 3.2 | other near or far plane | the same |
//! | [`offset`] | 3.2 | polygon offset | the same |
//! | [`fatten`] | 3.3 | polygons fattened in their plane | outside, with spikes |
//! | [`charcoal`] | 4 | the same, with front faces nearly edge-on | both sides |
//! | [`unoriented`] | 4 | all faces that are not in the nearest layer | as for `scale` |
//!
//! # When to choose it
//! For a triangle soup: positions and triangles are enough, without adjacency or preparation. O(F) per view on the GPU and
//! nothing on the CPU, unless the eye is within the mesh's bounding box, where an O(F) test finds out whether it is inside.
//! Positions may change every frame (`MeshBuffers::set_positions`, or the application's own buffer). `screen` draws even
//! lines; the paper's variants are for comparison, for their look, and for adapters without compute stages.
//!
//! # Depth
//! Near and far plane are the application's; `Renderer::clip_range` says which depths hold what is pulled too. Pulls smaller
//! than one depth step are reported ([`depth_step`], `Renderer::pull_below_depth_step`).
//!
//! # Departures from the paper
//! 1. Near and far should be widened, so that what is pulled across the near plane is not clipped. The paper does not mention it.
//! 2. With the eye inside a closed mesh only back faces are in sight, and the paper's method turns the view black.
//!    [`eye_inside`] detects that without adjacency, and step 3 is skipped; `eye-inside=draw` draws it nevertheless.
//! 3. Each variant's departures are listed in its module.
//!
//! # Input and output
//! Triangles counter-clockwise from outside; model matrices that mirror are taken into account. Facing of drawn faces is
//! decided by the rasteriser, of listed faces by the sign of their plane at the eye; they differ at most for faces that are
//! edge-on, which cover no pixel. Objects that touch or intersect get lines along their contact as well.
//!
//! # Failures
//! Open meshes: a back face seen through a hole is black all over by every pull, and boundary edges of front faces get no
//! ink unless `extra-edges` asks for them, which builds the topology. An eye on the surface may count as outside or inside.
//!
//! Pulls bleed: a back face behind a front face shows through it where the two are closer along the line of sight than the
//! pull. A plate of thickness 0.02 seen from 4 is black all over below a scale of 0.995.

#[cfg(feature = "gpu")]
mod back_edges;
#[cfg(feature = "gpu")]
mod back_faces;
pub mod charcoal;
#[cfg(feature = "gpu")]
mod cut_triangles;
pub mod depth_range;
#[cfg(feature = "gpu")]
pub mod depth_step;
pub mod equal;
pub mod eye_inside;
#[cfg(feature = "gpu")]
mod face_list;
#[cfg(feature = "gpu")]
mod fans;
#[cfg(feature = "gpu")]
mod fat_polygons;
pub mod fatten;
pub mod feature_edges;
#[cfg(feature = "gpu")]
mod first_layer;
pub mod fixed_pull;
#[cfg(feature = "gpu")]
mod front_faces;
#[cfg(feature = "gpu")]
mod ink;
#[cfg(feature = "gpu")]
mod later_faces;
#[cfg(feature = "gpu")]
mod mark_seen;
mod method;
pub mod offset;
pub mod options;
#[cfg(feature = "gpu")]
mod pipelines;
mod polygons;
mod published;
#[cfg(feature = "gpu")]
mod renderer;
pub mod scale;
pub mod screen;
mod settings;
#[cfg(feature = "gpu")]
mod style;
pub mod unoriented;
pub mod wireframe;

pub use method::ImagePrecision;
pub use options::ImagePrecisionOptions;
#[cfg(feature = "gpu")]
pub use pipelines::Pipelines;
pub use polygons::Polygons;
#[cfg(feature = "gpu")]
pub use renderer::Renderer;
pub use settings::{ExtraEdges, Interior, Settings, Variant};
