//! Reading: nothing that a file states is used before it is checked.
//!
//! 1. The header: signature, version, length of the file, and the checksum of header and table.
//! 2. The table: sections follow one another without gaps and fill the file; none is there twice, none that must be understood is
//!    unknown.
//! 3. `SIZE`: sizes within the limits. Every section has just the length that follows from them.
//! 4. Each section: its values, its checksum.
//! 5. Values: `check`.

use super::check;
use super::error::{Place, Problem, Range, SiltexError};
use super::format::{
    ENTRY, Entry, Form, HEADER, HEADER_CHECKSUM, MAX_SECTIONS, REQUIRED, RULES, SIGNATURE, SIZE_VALUES, SectionType,
    Sizes, VERSION, aligned_end, part,
};
use super::metadata::{self, Metadata};
use super::section_reader::SectionReader;
use super::stored::Stored;
use crate::hull::Hull;
use crate::silhouette_texture::{Angles, Parts, SilhouetteTexture, Terms};
use crate::volume_size::VolumeSize;
use silhouette_core::TriangleMesh;
use std::collections::BTreeMap;
use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom};
use std::path::Path;

/// What a file holds.
#[derive(Debug, Clone)]
pub struct Siltex {
    /// The texture. Its hull is [trusted](Hull::trusted): whether it encloses the object is for the bake to see to.
    pub texture: SilhouetteTexture,
    /// What it was baked from and how.
    pub metadata: Metadata,
}

/// Reads a file. O(bytes), with memory of about the file's length.
///
/// # Errors
/// [`SiltexError`], one line that names the file, the place and the remedy.
pub fn read(path: &Path) -> Result<Siltex, SiltexError> {
    let opened = File::open(path).map_err(|error| match error.kind() {
        io::ErrorKind::NotFound => Place::File.error(Problem::Missing),
        _ => Place::File.error(Problem::Read(error)),
    });
    opened.and_then(read_from).map_err(|error| error.in_file(path))
}

/// Reads what an open file, or [`Cursor`](io::Cursor) over bytes, holds from its first byte to its last.
///
/// # Errors
/// [`SiltexError`], which names no file.
pub fn read_from(mut reader: impl Read + Seek) -> Result<Siltex, SiltexError> {
    let entries = table(&mut reader)?;
    let mut file = Sections { reader, entries };
    let sizes = file.sizes()?;
    for (&kind, entry) in &file.entries {
        if let Some(expected) = sizes.bytes_of(kind)
            && entry.length != expected
        {
            return Err(Place::Section(kind).error(Problem::SectionLength { found: entry.length, expected }));
        }
    }

    let texels = sizes.volume.texels();
    let details = texels * u64::from(sizes.detail) * u64::from(sizes.detail);
    let (vertices, faces) = (u64::from(sizes.vertices), u64::from(sizes.faces));
    let positions = file.values(SectionType::POSITIONS, vertices)?;
    let triangles = file.values(SectionType::TRIANGLES, faces)?;
    let mesh =
        TriangleMesh::new(positions, triangles).map_err(|error| Place::Section(SectionType::TRIANGLES).error(error))?;
    let texel_centers = match file.entries.contains_key(&SectionType::TEXEL_CENTERS) {
        true => Some(file.values(SectionType::TEXEL_CENTERS, texels)?),
        false => None,
    };
    let parts = Parts {
        hull: Hull::trusted(mesh),
        centers: file.values(SectionType::CENTERS, vertices)?,
        tangents: file.values(SectionType::TANGENTS, vertices)?,
        places: file.values(SectionType::PLACES, faces)?,
        size: sizes.volume,
        rule: sizes.rule,
        angles: file.angles(&sizes)?,
        texel_centers,
        gaps: file.values(SectionType::GAPS, texels)?,
        detail: sizes.detail,
        colors: file.values(SectionType::COLORS, details)?,
        normals: file.values(SectionType::NORMALS, details)?,
    };
    check::values(&parts)?;
    let texture = SilhouetteTexture::new(parts).map_err(|error| Place::File.error(error))?;
    Ok(Siltex { texture, metadata: file.metadata()? })
}

/// The known sections of a file, by type.
fn table(reader: &mut (impl Read + Seek)) -> Result<BTreeMap<SectionType, Entry>, SiltexError> {
    let unread = |error| Place::Header.error(Problem::Read(error));
    let length = reader.seek(SeekFrom::End(0)).map_err(unread)?;
    reader.seek(SeekFrom::Start(0)).map_err(unread)?;
    let mut header = [0; HEADER];
    let found = &mut header[..length.min(HEADER as u64) as usize];
    reader.read_exact(found).map_err(unread)?;
    let header_error = |problem| Err(Place::Header.error(problem));

    if !found.starts_with(&SIGNATURE) {
        return header_error(Problem::NoSignature);
    }
    let too_short = |expected| header_error(Problem::FileLength { found: length, expected });
    if found.len() < HEADER {
        return too_short(HEADER as u64);
    }
    let [major, minor] = [8, 10].map(|at| u16::from_le_bytes(part(&header, at)));
    if major != VERSION.0 {
        return header_error(Problem::Version { major, minor });
    }
    let count = u32::from_le_bytes(part(&header, 12));
    let stated = u64::from_le_bytes(part(&header, 16));
    if stated != length {
        return too_short(stated);
    }
    if count > MAX_SECTIONS {
        return header_error(Problem::SectionCount { found: count });
    }
    let end = (HEADER + count as usize * ENTRY) as u64;
    if end > length {
        return too_short(end);
    }
    let mut table = vec![0; count as usize * ENTRY];
    reader.read_exact(&mut table).map_err(unread)?;
    let mut hasher = crc32fast::Hasher::new();
    hasher.update(&header[..HEADER_CHECKSUM]);
    hasher.update(&table);
    if hasher.finalize() != u32::from_le_bytes(part(&header, HEADER_CHECKSUM)) {
        return header_error(Problem::Checksum);
    }
    if u32::from_le_bytes(part(&header, 24)) != 0 {
        return header_error(Problem::Reserved);
    }
    entries(&table, end, length)
}

/// The known ones of the table's entries, whose sections must fill the file from `begin` to `length`.
fn entries(table: &[u8], begin: u64, length: u64) -> Result<BTreeMap<SectionType, Entry>, SiltexError> {
    let (mut all, mut expected) = (BTreeMap::new(), begin);
    for (index, bytes) in table.chunks_exact(ENTRY).enumerate() {
        let entry = Entry::take(&part(bytes, 0));
        let error = |problem| Err(Place::Entry(index as u32).error(problem));
        let Entry { kind, flags, offset, length: bytes, reserved, .. } = entry;
        if flags & !REQUIRED != 0 || reserved != 0 {
            return error(Problem::Reserved);
        }
        let end = aligned_end(offset, bytes).filter(|&end| end <= length);
        let Some(end) = end.filter(|_| offset == expected) else {
            return error(Problem::Misplaced { kind, offset, length: bytes, expected, room: length - expected });
        };
        expected = end;
        if all.insert(kind, entry).is_some() {
            return error(Problem::Duplicate(kind));
        }
        if flags & REQUIRED != 0 && !SectionType::KNOWN.contains(&kind) {
            return error(Problem::Unknown(kind));
        }
    }
    if expected != length {
        return Err(Place::File.error(Problem::FileLength { found: length, expected }));
    }
    all.retain(|kind, _| SectionType::KNOWN.contains(kind));
    if let Some(&missing) = SectionType::KNOWN.iter().find(|kind| !kind.may_be_missing() && !all.contains_key(kind)) {
        return Err(Place::Section(missing).error(Problem::NoSection));
    }
    Ok(all)
}

/// A file whose table has been read.
struct Sections<R> {
    reader: R,
    entries: BTreeMap<SectionType, Entry>,
}

impl<R: Read + Seek> Sections<R> {
    /// What `take` takes from a section that is there.
    fn section<T>(
        &mut self,
        kind: SectionType,
        take: impl FnOnce(&mut SectionReader<'_, R>) -> Result<T, Problem>,
    ) -> Result<T, SiltexError> {
        let entry = self.entries.get(&kind).ok_or(Problem::NoSection);
        let read = entry.and_then(|entry| {
            let mut section = SectionReader::new(&mut self.reader, entry)?;
            let taken = take(&mut section)?;
            section.finish()?;
            Ok(taken)
        });
        read.map_err(|problem| Place::Section(kind).error(problem))
    }

    fn values<T: Stored>(&mut self, kind: SectionType, count: u64) -> Result<Vec<T>, SiltexError> {
        self.section(kind, |section| section.values(count))
    }

    fn sizes(&mut self) -> Result<Sizes, SiltexError> {
        let kind = SectionType::SIZE;
        let values = self.section(kind, |section| section.values::<[u32; SIZE_VALUES]>(1));
        let [width, height, azimuths, pages, detail, vertices, faces, rule, form, terms] = values?[0];
        let choice = |what, found: u32, count: usize| {
            let range = Range(0, count as u32 - 1);
            Place::Section(kind).error(Problem::Range { what, found: u64::from(found), range })
        };
        let rule = *RULES.get(rule as usize).ok_or_else(|| choice("the visibility rule", rule, RULES.len()))?;
        let form =
            *Form::ALL.get(form as usize).ok_or_else(|| choice("the form of the angles", form, Form::ALL.len()))?;
        let volume = VolumeSize { width, height, azimuths, pages };
        let sizes = Sizes { volume, detail, vertices, faces, rule, form, terms };
        check::sizes(&sizes)?;
        Ok(sizes)
    }

    fn angles(&mut self, sizes: &Sizes) -> Result<Angles, SiltexError> {
        let (samples, texels, azimuths) = (sizes.volume.samples(), sizes.volume.texels(), sizes.volume.azimuths);
        let count = u64::from(sizes.terms);
        self.section(SectionType::ANGLES, |section| {
            Ok(match sizes.form {
                Form::Unorm8 => Angles::Unorm8(section.values(samples)?),
                Form::Float16 => Angles::Float16(section.values(samples)?),
                Form::Terms => Angles::Terms(Terms {
                    functions: (0..count).map(|_| section.values(u64::from(azimuths))).collect::<Result<_, _>>()?,
                    offsets: section.values(count)?,
                    scales: section.values(count)?,
                    weights: section.values(texels * count)?,
                }),
            })
        })
    }

    fn metadata(&mut self) -> Result<Metadata, SiltexError> {
        let kind = SectionType::METADATA;
        let Some(&Entry { length, .. }) = self.entries.get(&kind) else { return Ok(Metadata::new()) };
        metadata::decode(&self.values(kind, length)?).map_err(|problem| Place::Section(kind).error(problem))
    }
}
