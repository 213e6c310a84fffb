//! [`SiltexError`]: which file, where in it, what is wrong and how to mend it, in one line.

use super::format::{MAX_SECTIONS, SectionType, VERSION};
use crate::volume_size::VolumeSizeError;
use silhouette_core::load::OneLine;
use silhouette_core::{Cancelled, MeshError};
use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

/// Why a silhouette texture is not read or written. Displays as one line: `file, place: problem; mend`.
#[derive(Debug, thiserror::Error)]
#[error("{}{place}: {problem}", Named(file.as_deref()))]
pub struct SiltexError {
    /// The file; `None` of bytes without a path.
    pub file: Option<PathBuf>,
    /// Where in the file.
    pub place: Place,
    /// What is wrong.
    pub problem: Problem,
}

impl SiltexError {
    /// Whether nothing is at fault: the work was stopped by its [`Progress`](silhouette_core::Progress).
    pub fn is_cancelled(&self) -> bool {
        matches!(self.problem, Problem::Cancelled(_))
    }

    pub(super) fn in_file(self, path: &Path) -> Self {
        Self { file: Some(path.to_owned()), ..self }
    }
}

/// A part of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Place {
    /// All of it.
    File,
    /// The header, bytes 0 to 31.
    Header,
    /// An entry of the table of sections, from 0.
    Entry(u32),
    /// A section.
    Section(SectionType),
}

impl Place {
    pub(super) fn error(self, problem: impl Into<Problem>) -> SiltexError {
        SiltexError { file: None, place: self, problem: problem.into() }
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::File => f.write_str("silhouette texture"),
            Self::Header => f.write_str("header"),
            Self::Entry(index) => write!(f, "entry {index} of the table of sections"),
            Self::Section(kind) => write!(f, "section {kind}"),
        }
    }
}

/// What is wrong with a file, or with a texture that is to be written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Problem {
    /// There is no such file.
    #[error("there is no such file; check the path, or bake one")]
    Missing,
    /// The operating system refused to read.
    #[error("cannot be read ({0}); check the path, its permissions and the disk")]
    Read(io::Error),
    /// The operating system refused to write.
    #[error("cannot be written ({}); name a place that can be, with room enough", .0.kind())]
    Write(io::Error),
    /// Writing was stopped.
    #[error("writing was cancelled and has changed nothing; run it again")]
    Cancelled(#[from] Cancelled),
    /// It does not begin with the signature.
    #[error("this is not a .siltex file; name one that a bake has written")]
    NoSignature,
    /// Made by a later version, which may have changed anything.
    #[error(
        "the file has version {major}.{minor} of the format, and this build reads version {}; update it, or bake the texture again",
        VERSION.0
    )]
    Version {
        /// Its major version.
        major: u16,
        /// Its minor version.
        minor: u16,
    },
    /// The file's length is not the length that its header states, or is too short for a header or table.
    #[error(
        "the file has {found} bytes instead of {expected}; it is cut short or damaged: copy it again, or bake it again"
    )]
    FileLength {
        /// Bytes it has.
        found: u64,
        /// Bytes it should have, or the fewest it could have.
        expected: u64,
    },
    /// Bytes do not fit their checksum.
    #[error("the bytes do not match their checksum; the file is damaged: copy it again, or bake it again")]
    Checksum,
    /// More sections than are supported.
    #[error("{found} sections, at most {MAX_SECTIONS} are supported; the file is damaged: bake it again")]
    SectionCount {
        /// How many.
        found: u32,
    },
    /// A section does not begin where the one before it ends, or ends beyond the file.
    #[error(
        "section {kind} is given as {length} bytes from byte {offset} on, where the file has {room} from byte {expected} on; the \
         file is damaged: bake it again"
    )]
    Misplaced {
        /// The section.
        kind: SectionType,
        /// Where it begins.
        offset: u64,
        /// How long it is.
        length: u64,
        /// Where it should begin.
        expected: u64,
        /// Bytes that the file has from there on.
        room: u64,
    },
    /// Two sections of one type.
    #[error("there is a section {0} already; the file is damaged: bake it again")]
    Duplicate(SectionType),
    /// A section that must be understood is not.
    #[error("section {0} must be understood and is not by this build; update it, or bake the texture again")]
    Unknown(SectionType),
    /// Bits that have no meaning yet are set.
    #[error("bits that should be 0 are not; the file is damaged: bake it again")]
    Reserved,
    /// A section that every file has is not there.
    #[error("the section is missing; bake the texture again")]
    NoSection,
    /// A section's length does not follow from the sizes in section `SIZE`.
    #[error("{found} bytes where the sizes ask for {expected}; the file is damaged: bake it again")]
    SectionLength {
        /// Its length.
        found: u64,
        /// The length that the sizes ask for.
        expected: u64,
    },
    /// A texture of a size beyond the limits.
    #[error("{0}; bake the texture again")]
    Size(VolumeSizeError),
    /// A number beyond its range.
    #[error("{what} is {found}, {range} is supported; bake the texture again")]
    Range {
        /// What the number is.
        what: &'static str,
        /// The number.
        found: u64,
        /// Smallest and largest supported.
        range: Range,
    },
    /// The hull is no mesh.
    #[error("{0}; bake the texture again")]
    Hull(MeshError),
    /// A value that no bake yields.
    #[error("{what} {index} is not {rule}; bake the texture again")]
    Value {
        /// Which kind of value.
        what: &'static str,
        /// Which of them, from 0.
        index: usize,
        /// What it should be.
        rule: &'static str,
    },
    /// Arrays that do not fit each other.
    #[error("{0}; bake the texture again")]
    Parts(crate::silhouette_texture::PartsError),
    /// Metadata whose keys are out of order or empty, whose lengths do not add up, or that is not UTF-8.
    #[error("{0}; bake the texture again")]
    Metadata(&'static str),
    /// There is not enough memory for what the file holds.
    #[error("{bytes} bytes do not fit into memory; bake a smaller texture")]
    Memory {
        /// How many are needed for one section.
        bytes: u64,
    },
}

impl From<VolumeSizeError> for Problem {
    fn from(cause: VolumeSizeError) -> Self {
        Self::Size(cause)
    }
}

impl From<MeshError> for Problem {
    fn from(cause: MeshError) -> Self {
        Self::Hull(cause)
    }
}

impl From<crate::silhouette_texture::PartsError> for Problem {
    fn from(cause: crate::silhouette_texture::PartsError) -> Self {
        Self::Parts(cause)
    }
}

/// The smallest and the largest number that is supported.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Range(pub u32, pub u32);

impl fmt::Display for Range {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} to {}", self.0, self.1)
    }
}

/// `path, `, or nothing.
struct Named<'a>(Option<&'a Path>);

impl fmt::Display for Named<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.map_or(Ok(()), |path| write!(f, "{}, ", OneLine(path)))
    }
}
