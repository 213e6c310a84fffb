//! [`LoadError`]: which file, where in it, what is wrong and how to mend it, in one line.

use super::format::Format;
use crate::mesh::MeshError;
use crate::progress::Cancelled;
use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

/// Why a file is no mesh. Displays as one line: `file, place: problem; mend`.
#[derive(Debug, thiserror::Error)]
#[error("{}{}: {problem}", OneLine(file), Comma(place.as_ref()))]
pub struct LoadError {
    /// The file, or the name given for bytes in memory.
    pub file: PathBuf,
    /// Where in the file; `None` where the whole file is at fault.
    pub place: Option<Place>,
    /// What is wrong.
    pub problem: Problem,
}

impl LoadError {
    /// Whether the file is not at fault: the work was stopped by its [`Progress`](crate::progress::Progress).
    pub fn is_cancelled(&self) -> bool {
        matches!(self.problem, Problem::Cancelled(_))
    }
}

/// A place in a file.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum Place {
    /// Line of a text file, from 1.
    Line(u64),
    /// Offset in a binary file, from 0.
    Byte(u64),
    /// Element of a glTF document, such as `meshes[0].primitives[1]`.
    Element(String),
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Line(line) => write!(f, "line {line}"),
            Self::Byte(byte) => write!(f, "byte {byte}"),
            Self::Element(path) => f.write_str(path),
        }
    }
}

/// What is wrong with a file. Vertices and faces are counted from 0 in the file's own order, whatever the format does.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Problem {
    /// There is no such file.
    #[error("there is no such file; check the path")]
    Missing,
    /// The path names a directory.
    #[error("this is a directory; name a mesh file in it")]
    Directory,
    /// The path names a pipe, a device or the like.
    #[error("this is no regular file; copy what it yields to a file and name that")]
    NoRegularFile,
    /// The operating system refused to read.
    #[error("cannot be read ({0}); check its permissions and that the disk is in order")]
    Io(io::Error),
    /// The file has no bytes.
    #[error("the file is empty; export or download it again")]
    Empty,
    /// The name's extension belongs to no known format.
    #[error("unknown extension {extension:?}; rename or convert the file to one of {}", Format::EXTENSIONS.join(" "))]
    UnknownExtension {
        /// The extension without its dot; empty where there is none.
        extension: String,
    },
    /// The format's cargo feature is off in this build.
    #[error("this build does not read {format}; enable the cargo feature `{}` of silhouette-core", format.feature())]
    FeatureOff {
        /// The format.
        format: Format,
    },
    /// Text was expected.
    #[error("this is not UTF-8 text; save the file as UTF-8 (or ASCII), or check that its extension names its format")]
    NotText,
    /// The file ends too early.
    #[error(
        "the file ends within {within} ({needed} bytes are needed, {found} are left); it is cut short, copy it again"
    )]
    Truncated {
        /// What was being read.
        within: &'static str,
        /// Bytes needed from the place on.
        needed: u64,
        /// Bytes left from the place on.
        found: u64,
    },
    /// A header promises more elements than the rest of the file can hold.
    #[error(
        "the header promises {promised} {what}, but the bytes that follow hold at most {possible}; \
         the file is cut short or its header is wrong"
    )]
    Promise {
        /// Plural of what is promised.
        what: String,
        /// How many.
        promised: u64,
        /// How many there can be.
        possible: u64,
    },
    /// Something else stands where the format asks for `expected`.
    #[error("expected {expected}, found {found}; repair the file or export it again")]
    Expected {
        /// What the format asks for.
        expected: &'static str,
        /// What stands there, quoted, shortened.
        found: String,
    },
    /// A coordinate is NaN, infinite or beyond 32-bit floats.
    #[error(
        "vertex {vertex} has the coordinate {value}, no finite 32-bit float; repair the vertex or scale the mesh down"
    )]
    NotFinite {
        /// The vertex, from 0.
        vertex: u64,
        /// The coordinate.
        value: String,
    },
    /// OBJ counts from 1.
    #[error("a face names vertex 0, but OBJ counts vertices from 1; the exporter counts from 0, add 1 to each index")]
    VertexZero,
    /// A face names a vertex that does not exist.
    #[error("face {face} names vertex {index}, but {allowed}; repair the face or restore the missing vertices")]
    VertexOutOfRange {
        /// The face as the file counts it (before polygons are cut into triangles), from 0.
        face: u64,
        /// The vertex as written in the file.
        index: i64,
        /// Which vertices may be named, as a clause.
        allowed: String,
    },
    /// There is no face in the file.
    #[error("the file holds no faces; export the surface too, points and curves alone have no silhouette")]
    NoFaces,
    /// A kind of content that is not read.
    #[error("{what} is not read; {mend}")]
    Unsupported {
        /// What was found.
        what: String,
        /// What to do.
        mend: &'static str,
    },
    /// More elements than a mesh can hold, or (with [`load`](super::load)'s limits) than such a file should unfold into.
    #[error("the file unfolds into {count} {what}, at most {limit} are taken; split the mesh")]
    TooLarge {
        /// Plural of the elements.
        what: &'static str,
        /// How many.
        count: u64,
        /// How many there may be.
        limit: u64,
    },
    /// More bytes than the caller allows.
    #[error(
        "the file has {found} bytes with all that it names, but at most {limit} are to be read; allow more, or simplify it"
    )]
    TooLong {
        /// How many, at least.
        found: u64,
        /// How many were allowed.
        limit: u64,
    },
    /// The arrays were read but make no mesh.
    #[error("{0}; repair the file or export it again")]
    Mesh(MeshError),
    /// The work was stopped by its [`Progress`](crate::progress::Progress).
    #[error("loading was cancelled; run it again to load the file")]
    Cancelled(#[from] Cancelled),
}

impl From<MeshError> for Problem {
    fn from(cause: MeshError) -> Self {
        Self::Mesh(cause)
    }
}

/// A problem with its place, before the file's name is known.
#[derive(Debug)]
pub(super) struct Located {
    pub(super) place: Option<Place>,
    pub(super) problem: Problem,
}

impl Located {
    pub(super) fn in_file(self, file: &Path) -> LoadError {
        LoadError { file: file.to_owned(), place: self.place, problem: self.problem }
    }
}

/// Whatever is wrong with the whole file has no place.
impl<P: Into<Problem>> From<P> for Located {
    fn from(problem: P) -> Self {
        Self { place: None, problem: problem.into() }
    }
}

impl Problem {
    /// The problem, on this line.
    pub(super) fn at_line(self, line: u64) -> Located {
        Located { place: Some(Place::Line(line)), problem: self }
    }

    /// `expected`, but these bytes stand there instead.
    pub(super) fn expected(expected: &'static str, found: &[u8]) -> Self {
        Self::Expected { expected, found: quote(found) }
    }

    /// The problem, at this offset.
    pub(super) fn at_byte(self, byte: usize) -> Located {
        Located { place: Some(Place::Byte(byte as u64)), problem: self }
    }
}

/// Longest excerpt of a file that a message quotes, in bytes: enough to recognise the spot, short enough for one line.
const EXCERPT: usize = 40;

/// The bytes as quoted text without control characters, shortened; a lack of bytes is spelt out.
pub(super) fn quote(bytes: &[u8]) -> String {
    if bytes.is_empty() {
        return "nothing".to_owned();
    }
    let shown = String::from_utf8_lossy(&bytes[..bytes.len().min(EXCERPT)]);
    if bytes.len() > EXCERPT { format!("{shown:?}...") } else { format!("{shown:?}") }
}

/// A path for a message: its control characters are escaped, so that the message stays one line.
#[derive(Debug, Clone, Copy)]
pub struct OneLine<'a>(pub &'a Path);

impl fmt::Display for OneLine<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for c in self.0.to_string_lossy().chars() {
            if c.is_control() { write!(f, "{}", c.escape_default())? } else { write!(f, "{c}")? }
        }
        Ok(())
    }
}

/// `, place`, or nothing.
struct Comma<'a>(Option<&'a Place>);

impl fmt::Display for Comma<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.map_or(Ok(()), |place| write!(f, ", {place}"))
    }
}
