//! Exact visible and hidden lines of a triangle mesh, as geometry.
//!
//! A. Appel, "The notion of quantitative invisibility and the machine rendering of solids", ACM National Conference 1967, is
//! where invisibility is counted along lines; L. Markosian et al., "Real-Time Nonphotorealistic Rendering", SIGGRAPH 1997,
//! section 3, where it is told along the silhouette alone. The steps, one file each:
//!
//! 1. `contours.rs`: edges at which the number of surface layers changes in the picture, and by how much.
//! 2. `select.rs`: which edges are drawn, and why; with `intersections.rs` and `curves.rs`, lines that are no edges.
//! 3. `frame.rs`, `picture_grid.rs`: edges clipped before they are divided, contours by place in the picture.
//! 4. `events.rs`: where a stroke crosses a nearer contour, and where it passes through a face.
//! 5. `cutter.rs`: the candidates for these; `clear_edges.rs`: edges that pass through nothing.
//! 6. `gaps.rs`: a stroke parted at its events.
//! 7. `propagate.rs`: layers told from stroke to stroke; `sight.rs`: one line of sight for each set that is connected.
//! 8. `pieces.rs`, `join.rs`: stretches of one invisibility, joined to chains. `outline.rs`: the outermost ones as polygons.
//!
//! # What is exact
//!
//! Whether edges cross, which is nearer, whether a face is passed through, and whether it hides a point are signs of
//! determinants of the 32-bit input; all are exact ([`silhouette_core::orientation`]). So is the number of layers in front of
//! every piece. *Where* a piece ends is a ratio of two such determinants, rounded to about `1e-9` of its edge; events closer
//! together than that are one. Coordinates of the output are rounded besides, pixels to `f64`.
//!
//! Ties are broken as if each line were moved by less than any number towards the surface that it bounds, so that an edge is
//! as visible as that surface next to it. A face seen edge-on hides nothing, nor does one on which the eye lies.
//!
//! # Departures from Appel and Markosian
//!
//! 1. Layers of front and of back faces are counted apart, so that open meshes, non-manifold edges and an eye inside of a
//!    solid are ordinary cases. 2. Events are found by a grid over the picture instead of by sweeping. 3. No vertex is a
//!    special case: what changes there is counted face by face. 4. Faces that pass through each other change invisibility
//!    where a line pierces them.
//!
//! # Cost
//!
//! For S drawn edges, C contours and K events: O((S + C + K) log K + S log F) a view and one line of sight a connected set;
//! preparation O(F log F). Hostile pictures in which very many edges lie over each other end in
//! [`LineError::TooCrowded`]. The same bits for any number of threads.
//!
//! # When to choose it
//!
//! Where lines are wanted as geometry: plots, technical drawings, a truth to measure pictures against. Drawing from a depth or
//! id buffer is faster on a GPU and wrong within about a pixel of what occludes.

mod around_vertex;
mod cache;
mod chains;
mod clear_edges;
mod contours;
mod crossing;
mod curves;
mod cut;
mod decide;
mod face_tree;
mod fan;
mod feature_edges;
mod finder;
mod frame;
mod gaps;
mod intersections;
mod join;
mod kind;
mod layers;
mod lines;
mod options;
mod outline;
mod picture_grid;
mod pieces;
mod piercing;
pub mod plot;
mod propagate;
mod quick;
mod scene;
mod select;
mod sheets;
mod sight;
mod stroke;
mod surface;
mod unpaired;
mod vertex_faces;
mod viewed_mesh;

pub use cache::LineCache;
pub use chains::{Chain, ChainStyle, Chains, SegmentSource};
pub use face_tree::FaceTree;
pub use finder::{LineError, LineFinder, MAX_EVENTS, MAX_PIECES, MAX_WORK};
pub use intersections::{FaceIntersections, Intersection, IntersectionEnd};
pub use kind::LineKind;
pub use lines::{LineStats, Lines};
pub use options::LineOptions;
pub use outline::Outline;
pub use quick::{FaceIds, FaceIdsError, QuickLineFinder};
pub use scene::{CurvePiece, LineScene, SceneError};
pub use unpaired::UnpairedEdges;
pub use vertex_faces::{VertexFace, VertexFaces};
