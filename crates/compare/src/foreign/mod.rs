//! What another program drew, scored against the truth of a view: nobody has to link to this workspace to be compared.
//!
//! 1. [`views`]: the scored frames of a scene; [`cameras`]: as another program sets them up.
//! 2. [`file`](mod@file): what a file holds, by its ending. [`edge_list`]: JSON of pairs of vertices, of polylines, and as the commands
//!    `extract` and `lines` write it; [`svg`]: strokes; [`picture`]: PNG. [`trace`]: all lines as polylines within the picture.
//! 3. [`visible_edges`]: the visible parts of edges that are named by their vertices.
//! 4. [`crowding`]: drawings that cannot be inked in seconds are refused.
//! 5. [`score`]: lines drawn with the scene's pen, a picture as it is, and both measured as `compare` measures methods.
//! 6. [`results`]: the files that this yields, in the columns of a comparison.

pub mod cameras;
pub mod crowding;
pub mod edge_list;
pub mod error;
pub mod file;
pub mod picture;
pub mod results;
pub mod score;
pub mod svg;
pub mod trace;
pub mod views;
pub mod visible_edges;

pub use error::{ForeignError, ForeignFault};
pub use file::{ForeignFile, read};
pub use score::{ForeignScore, Scorer};
pub use trace::{Frame, Polyline};
pub use views::ScoredView;

use silhouette_render::Image;

/// What a file holds of a view.
#[derive(Debug, Clone, PartialEq)]
pub enum Drawing {
    /// Lines in pixels, all of which are drawn: within the picture and the pen's width around it.
    Lines(Vec<Polyline>),
    /// Pairs of vertices, of which the visible parts are drawn.
    Edges(Vec<[u32; 2]>),
    /// A picture of the view's size, which is judged as it is.
    Picture(Image),
}
