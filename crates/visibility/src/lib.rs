#![doc = include_str!("../README.md")]
//!
//! # Calls
//!
//! [`LineFinder::find`] yields the lines of a view as connected polylines, each with why it is drawn and how many layers hide
//! it; [`LineFinder::outline`] the boundary of what the mesh covers in the picture, as polygons. [`plot`] makes files of them.
//!
//! # When to choose it
//!
//! Where lines are wanted as geometry: plots, technical drawings, a truth to measure pictures against. Drawing from a depth or
//! id buffer is faster on a GPU and wrong within about a pixel of what occludes.
//!
//! # Cost
//!
//! For S drawn edges, C contours and K events: O((S + C + K) log K + S log F) per view and one line of sight per connected
//! set; preparation O(F log F). What would take more than [`MAX_WORK`], [`MAX_EVENTS`] or [`MAX_PIECES`] allow ends in
//! [`LineError::TooCrowded`] or [`LineError::TooManyPieces`] before it is spent: below 1 GB and about ten seconds. The same bits for any number of threads.
//!
//! # How it works
//!
//! A. Appel, "The notion of quantitative invisibility and the machine rendering of solids", ACM National Conference 1967, is
//! where invisibility is counted along lines; L. Markosian et al., "Real-Time Nonphotorealistic Rendering", SIGGRAPH 1997,
//! section 3, where it is propagated along the silhouette alone. The steps, one file each:
//!
//! 1. `viewed_mesh.rs`, `contours.rs`: edges at which the number of surface layers changes in the picture, and by how much.
//! 2. `select.rs`, `feature_edges.rs`: which edges are drawn, and why; with `intersections.rs` and `curves.rs`, lines that are
//!    no edges. `surface.rs`: the surface beside an edge.
//! 3. `frame.rs`, `picture_grid.rs`: edges clipped before they are divided, contours by place in the picture.
//! 4. `crossing.rs`, `piercing.rs`: where a stroke crosses a nearer contour, and where it passes through a face.
//! 5. `cut.rs`: the candidates for these; `clear_edges.rs`, `face_tree.rs`, `fan.rs`: which faces an edge may meet.
//! 6. `gaps.rs`: a stroke parted at its events.
//! 7. `propagate.rs`, `around_vertex.rs`: layers propagated from stroke to stroke; `sight.rs`: one line of sight for each set
//!    that is connected.
//! 8. `pieces.rs`, `join.rs`: stretches of one invisibility, joined to chains.
//!
//! `outline/` takes the contours of step 1 and goes its own way. `section/` cuts meshes open beforehand.
//!
//! # What is exact
//!
//! Whether edges cross, which is nearer, whether a face is passed through, and whether it hides a point are signs of
//! determinants of the 32-bit input; all are exact ([`silhouette_core::orientation`]). So is the number of layers in front of
//! every piece. *Where* a piece ends is a ratio of two such determinants, rounded to about `1e-9` of its edge; events closer
//! together than that are one. Coordinates of the output are rounded besides, pixels to `f64`.
//!
//! # Ties
//!
//! Every predicate about the picture is decided as seen by one viewer who stands infinitesimally nearer to the middle of the
//! scene than the camera ([`DisplacedViewer`](silhouette_core::DisplacedViewer)). So no face is ever edge-on, no vertex lies
//! on an edge in the picture, and a drawing along an axis is the limit of drawings from nearby. What touches in space is
//! decided by the surface beside an edge: an edge is as visible as that surface close to it, and not hidden by a face in the
//! same plane. Neither winding nor the order of vertices and faces decides anything that is drawn.
//!
//! # Departures from Appel and Markosian
//!
//! 1. Layers of front and of back faces are counted apart, so that open meshes, non-manifold edges and an eye inside of a
//!    solid are ordinary cases.
//! 2. Events are found by a grid over the picture instead of by sweeping.
//! 3. No vertex is a special case: what changes there is counted face by face.
//! 4. Faces that pass through each other change invisibility where a line pierces them.
//! 5. A silhouette edge is drawn by where its faces lie in the picture, not by their winding; and where the camera sees a wall
//!    exactly edge-on, its near rim is drawn whatever the displaced viewer sees of the wall.

mod around_vertex;
mod cache;
mod candidate;
mod chains;
mod clear_edges;
mod contours;
mod crossing;
mod curve_part;
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
mod inward;
mod join;
mod kind;
mod layers;
mod line_error;
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
mod section;
mod select;
mod sheets;
mod sight;
mod stroke;
mod surface;
mod unpaired;
mod vertex_faces;
mod viewed_mesh;
mod visible_lines;

pub use cache::LineCache;
pub use chains::{Chain, ChainStyle, Chains, SegmentSource};
pub use face_tree::FaceTree;
pub use finder::LineFinder;
pub use intersections::{FaceIntersections, Intersection, IntersectionEnd};
pub use kind::LineKind;
pub use line_error::{LineError, MAX_EVENTS, MAX_PIECES, MAX_WORK};
pub use lines::{LineStats, Lines};
pub use options::LineOptions;
pub use outline::Outline;
pub use quick::{FaceIds, FaceIdsError, QuickLineFinder};
pub use scene::{CurvePiece, LineScene, SceneError};
pub use section::{ParseSectionPlaneError, SectionPlane, SectionedMesh};
pub use unpaired::UnpairedEdges;
pub use vertex_faces::{VertexFace, VertexFaces};
pub use visible_lines::visible_lines;
