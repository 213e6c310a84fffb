//! The layout of the file: header, table of sections, and how long each section must be. See `docs/formats/siltex.md`.

use super::stored::Stored as _;
use crate::silhouette_texture::{Angles, FacePlace, Parts, VisibilityRule};
use crate::volume_size::VolumeSize;
use glam::Vec3;
use half::f16;
use silhouette_core::glam;
use std::fmt;

/// First bytes of a file. The first is no text and the last a line's end, so that a transfer as text is noticed.
pub(super) const SIGNATURE: [u8; 8] = *b"\x89SILTEX\n";

/// The version that is written: major and minor. A minor version adds optional sections only; a major one may change everything
/// after the version itself.
pub const VERSION: (u16, u16) = (1, 0);

/// Bytes of the header, of an entry of the table, and that sections begin at multiples of.
pub(super) const HEADER: usize = 32;
pub(super) const ENTRY: usize = 32;
pub(super) const ALIGNMENT: u64 = 8;

/// Where in the header its checksum stands: of the bytes before it, then of the table.
pub(super) const HEADER_CHECKSUM: usize = 28;

/// Most sections of a file.
pub const MAX_SECTIONS: u32 = 256;

/// Most texels of colours and normals along a texel's side. Sizes of sections stay far below 2^64.
pub const MAX_DETAIL: u32 = 4096;

/// Bit of an entry's flags: readers that do not know the section must refuse the file.
pub(super) const REQUIRED: u32 = 1;

/// What a section holds: four ASCII letters.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct SectionType(pub [u8; 4]);

impl SectionType {
    pub(super) const SIZE: Self = Self(*b"SIZE");
    pub(super) const POSITIONS: Self = Self(*b"POSI");
    pub(super) const TRIANGLES: Self = Self(*b"TRIA");
    pub(super) const CENTERS: Self = Self(*b"CENT");
    pub(super) const TANGENTS: Self = Self(*b"TANG");
    pub(super) const PLACES: Self = Self(*b"PLAC");
    pub(super) const ANGLES: Self = Self(*b"ANGL");
    pub(super) const TEXEL_CENTERS: Self = Self(*b"TCEN");
    pub(super) const GAPS: Self = Self(*b"GAPS");
    pub(super) const COLORS: Self = Self(*b"COLO");
    pub(super) const NORMALS: Self = Self(*b"NORM");
    pub(super) const METADATA: Self = Self(*b"META");

    /// Those of version 1, in the order in which they are written.
    pub(super) const KNOWN: [Self; 12] = [
        Self::SIZE,
        Self::POSITIONS,
        Self::TRIANGLES,
        Self::CENTERS,
        Self::TANGENTS,
        Self::PLACES,
        Self::ANGLES,
        Self::TEXEL_CENTERS,
        Self::GAPS,
        Self::COLORS,
        Self::NORMALS,
        Self::METADATA,
    ];

    /// Whether files need not have it.
    pub(super) fn may_be_missing(self) -> bool {
        matches!(self, Self::TEXEL_CENTERS | Self::METADATA)
    }
}

impl fmt::Display for SectionType {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.0.escape_ascii())
    }
}

/// An entry of the table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Entry {
    pub(super) kind: SectionType,
    pub(super) flags: u32,
    pub(super) offset: u64,
    pub(super) length: u64,
    pub(super) checksum: u32,
    /// Zero in version 1.
    pub(super) reserved: u32,
}

impl Entry {
    pub(super) fn put(&self, bytes: &mut Vec<u8>) {
        bytes.extend(self.kind.0);
        self.flags.put(bytes);
        bytes.extend(self.offset.to_le_bytes());
        bytes.extend(self.length.to_le_bytes());
        self.checksum.put(bytes);
        self.reserved.put(bytes);
    }

    pub(super) fn take(bytes: &[u8; ENTRY]) -> Self {
        Self {
            kind: SectionType(part(bytes, 0)),
            flags: u32::from_le_bytes(part(bytes, 4)),
            offset: u64::from_le_bytes(part(bytes, 8)),
            length: u64::from_le_bytes(part(bytes, 16)),
            checksum: u32::from_le_bytes(part(bytes, 24)),
            reserved: u32::from_le_bytes(part(bytes, 28)),
        }
    }
}

/// `N` of the bytes, from `start` on.
pub(super) fn part<const N: usize>(bytes: &[u8], start: usize) -> [u8; N] {
    std::array::from_fn(|index| bytes[start + index])
}

/// Where the section after one of `length` bytes begins; `None` beyond 64 bits.
pub(super) fn aligned_end(offset: u64, length: u64) -> Option<u64> {
    offset.checked_add(length)?.checked_next_multiple_of(ALIGNMENT)
}

/// How angles are stored.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Form {
    Unorm8,
    Float16,
    Terms,
}

impl Form {
    pub(super) const ALL: [Self; 3] = [Self::Unorm8, Self::Float16, Self::Terms];
}

/// The visibility rules, by their number in the file.
pub(super) const RULES: [VisibilityRule; 2] = [VisibilityRule::Interior, VisibilityRule::Exterior];

/// The section `SIZE`: everything that the lengths of the others follow from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Sizes {
    pub(super) volume: VolumeSize,
    pub(super) detail: u32,
    pub(super) vertices: u32,
    pub(super) faces: u32,
    pub(super) rule: VisibilityRule,
    pub(super) form: Form,
    /// 0 in the other forms.
    pub(super) terms: u32,
}

/// Values of 32 bits in `SIZE`.
pub(super) const SIZE_VALUES: usize = 10;

impl Sizes {
    /// Of a texture. Its counts fit: ids of vertices and faces are 32 bits wide, terms are at most as many as azimuths once
    /// checked.
    pub(super) fn of(parts: &Parts) -> Self {
        let (form, terms) = match &parts.angles {
            Angles::Unorm8(_) => (Form::Unorm8, 0),
            Angles::Float16(_) => (Form::Float16, 0),
            Angles::Terms(terms) => (Form::Terms, terms.functions.len() as u32),
        };
        Self {
            volume: parts.size,
            detail: parts.detail,
            vertices: parts.hull.mesh().vertex_count() as u32,
            faces: parts.hull.mesh().face_count() as u32,
            rule: parts.rule,
            form,
            terms,
        }
    }

    pub(super) fn values(&self) -> [u32; SIZE_VALUES] {
        let VolumeSize { width, height, azimuths, pages } = self.volume;
        let (rule, form) = (self.rule as u32, self.form as u32);
        [width, height, azimuths, pages, self.detail, self.vertices, self.faces, rule, form, self.terms]
    }

    /// Bytes of a known section; `None` where any length is right. Sizes must have been checked.
    pub(super) fn bytes_of(&self, kind: SectionType) -> Option<u64> {
        let bytes = |count: u64, each: usize| Some(count * each as u64);
        let (vertices, faces, texels) = (u64::from(self.vertices), u64::from(self.faces), self.volume.texels());
        let details = texels * u64::from(self.detail) * u64::from(self.detail);
        match kind {
            SectionType::SIZE => bytes(SIZE_VALUES as u64, u32::BYTES),
            SectionType::POSITIONS | SectionType::CENTERS | SectionType::TANGENTS => bytes(vertices, Vec3::BYTES),
            SectionType::TRIANGLES => bytes(faces, <[u32; 3]>::BYTES),
            SectionType::PLACES => bytes(faces, FacePlace::BYTES),
            SectionType::ANGLES => match self.form {
                Form::Unorm8 => bytes(self.volume.samples(), u8::BYTES),
                Form::Float16 => bytes(self.volume.samples(), f16::BYTES),
                Form::Terms => {
                    let functions = u64::from(self.volume.azimuths + 2) * f32::BYTES as u64;
                    bytes(u64::from(self.terms) * (functions + texels), 1)
                }
            },
            SectionType::TEXEL_CENTERS => bytes(texels, <[f16; 4]>::BYTES),
            SectionType::GAPS => bytes(texels, f16::BYTES),
            SectionType::COLORS => bytes(details, <[u8; 4]>::BYTES),
            SectionType::NORMALS => bytes(details, <[f16; 4]>::BYTES),
            _ => None,
        }
    }
}
