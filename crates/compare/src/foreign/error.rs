//! Why what another program drew cannot be scored.

use std::io;
use std::path::PathBuf;

/// A file cannot be scored.
#[derive(Debug, thiserror::Error)]
#[error("{}: {fault}", path.display())]
pub struct ForeignError {
    /// The file.
    pub path: PathBuf,
    /// What is wrong.
    pub fault: ForeignFault,
}

/// What is wrong with a file, where in it, and what would fit.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ForeignFault {
    /// It cannot be read.
    #[error(transparent)]
    Io(#[from] io::Error),
    /// It is longer than is read.
    #[error("longer than {limit} bytes; write fewer points, or with fewer decimals")]
    TooLong {
        /// Most bytes that are read.
        limit: u64,
    },
    /// It has more points than are kept.
    #[error("{place}: more than {limit} points; write fewer")]
    TooManyPoints {
        /// Where the limit is passed.
        place: String,
        /// Most points that are kept.
        limit: usize,
    },
    /// Its lines cross each other too often to be inked.
    #[error(
        "its lines cross each other too often to be drawn exactly; leave out what is hidden, or give a picture (.png)"
    )]
    TooCrowded,
    /// Its name ends in nothing that is read.
    #[error("unknown form; lines are read from .json and .svg, pictures from .png")]
    UnknownEnding,
    /// It is JSON of some other form.
    #[error("unknown form: {found}; give one of \"polylines\": [[[x,y]...]...], \"edges\": [[a,b]...] and \"chains\"")]
    UnknownKeys {
        /// Which of the keys it has.
        found: String,
    },
    /// Its text is not of its form.
    #[error("{place}: {message}")]
    Form {
        /// Line, column or key.
        place: String,
        /// What is wrong and what would fit.
        message: String,
    },
    /// It has a number that is none.
    #[error("{place}: {number} is no finite number; leave such points out")]
    NotFinite {
        /// Line, column or key.
        place: String,
        /// What is there.
        number: String,
    },
    /// It is of another size than the view.
    #[error("{found}, but the view is {} x {} pixels; draw it at that size", wanted[0], wanted[1])]
    WrongSize {
        /// What it is.
        found: String,
        /// Width and height of the view in pixels.
        wanted: [u32; 2],
    },
    /// It holds no line, though the view has some.
    #[error("holds no line{why}; {mend}")]
    NoLines {
        /// What it holds instead, after a colon or a space, or nothing.
        why: String,
        /// What would fit.
        mend: &'static str,
    },
    /// It was made of another mesh.
    #[error(
        "{place}: {found}, but {mesh} has {wanted}; name the mesh that it was made of, with its vertices in the same order"
    )]
    OtherMesh {
        /// Where it says so.
        place: String,
        /// What it says.
        found: String,
        /// Name of the mesh.
        mesh: String,
        /// What is so instead.
        wanted: String,
    },
    /// It was made from another viewpoint.
    #[error(
        "{place}: {found}, but frame {frame} has {wanted}; say --frame of the one that it shows, or draw it by that camera (--cameras)"
    )]
    OtherCamera {
        /// Where it says so.
        place: String,
        /// What it says.
        found: String,
        /// The frame that it was given for.
        frame: u32,
        /// What is so instead.
        wanted: String,
    },
}

/// What stands for a drawing that is meant to be empty.
const EMPTY: &str = "for a drawing without lines give a white picture (.png)";

impl ForeignFault {
    /// It holds no line and nothing else.
    pub(super) fn no_lines() -> Self {
        Self::NoLines { why: String::new(), mend: EMPTY }
    }

    /// It holds this many lines, none of them within the picture.
    pub(super) fn all_outside(lines: usize) -> Self {
        let why = format!(" inside of the picture: all {lines} lie beside it");
        Self::NoLines { why, mend: "give pixels, with their origin at the top left" }
    }

    /// The fault with the file where it is.
    pub fn in_file(self, path: impl Into<PathBuf>) -> ForeignError {
        ForeignError { path: path.into(), fault: self }
    }
}
