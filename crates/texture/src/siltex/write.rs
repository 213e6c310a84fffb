//! Writing: a texture becomes a file, whole or not at all.

use super::error::{Place, Problem, SiltexError};
use super::format::{
    ALIGNMENT, ENTRY, Entry, HEADER, HEADER_CHECKSUM, REQUIRED, SIGNATURE, SectionType, Sizes, VERSION, aligned_end,
};
use super::metadata::{self, Metadata};
use super::stored::Stored;
use super::{MAX_SECTIONS, check};
use crate::silhouette_texture::{Angles, SilhouetteTexture};
use crc32fast::Hasher;
use silhouette_core::Progress;
use std::io::{self, Write};
use std::path::Path;

/// Bytes that are encoded before they are passed on: few enough to stay in the cache, enough for a call to the system.
const CHUNK: usize = 1 << 16;

/// Writes a file, or replaces it in one step: the bytes go to a temporary file in the same folder, which takes the path's place
/// once it is complete and on disk. Whatever fails, and if `progress` cancels, the folder is left as it was. A link stays a link:
/// what it points to is replaced.
///
/// `progress` gets one stage, in bytes. O(bytes), in two passes, with 64 KiB of memory beside the metadata.
///
/// # Errors
/// [`SiltexError`]: the place cannot be written to, the work was cancelled, or the texture has values that [`read`](super::read)
/// would refuse.
pub fn write(
    path: &Path,
    texture: &SilhouetteTexture,
    metadata: &Metadata,
    progress: &dyn Progress,
) -> Result<(), SiltexError> {
    replace(path, |file| write_to(file, texture, metadata, progress)).map_err(|error| error.in_file(path))
}

/// Writes the bytes of a file to `sink`. What has been written before an error stays there.
///
/// # Errors
/// [`SiltexError`], as [`write()`]'s.
pub fn write_to(
    sink: &mut dyn Write,
    texture: &SilhouetteTexture,
    metadata: &Metadata,
    progress: &dyn Progress,
) -> Result<(), SiltexError> {
    let parts = texture.parts();
    let sizes = Sizes::of(parts);
    check::sizes(&sizes)?;
    check::values(parts)?;
    let metadata =
        metadata::encode(metadata).map_err(|problem| Place::Section(SectionType::METADATA).error(problem))?;
    let size_values = sizes.values();
    let sections = sections(texture, &size_values, &metadata);
    let (head, length) = head(&sections, progress)?;

    progress.stage("writing the texture", length);
    let mut out = |bytes: &[u8]| {
        progress.check()?;
        sink.write_all(bytes).map_err(Problem::Write)?;
        progress.advance(bytes.len() as u64);
        Ok(())
    };
    out(&head).map_err(|problem| Place::Header.error(problem))?;
    for section in &sections {
        section.encode(&mut out).map_err(|problem| Place::Section(section.kind).error(problem))?;
    }
    Ok(())
}

/// Where bytes go, in pieces.
type Sink<'a> = dyn FnMut(&[u8]) -> Result<(), Problem> + 'a;

/// Values of one type, whichever.
trait Array {
    fn bytes(&self) -> u64;
    fn encode(&self, sink: &mut Sink<'_>) -> Result<(), Problem>;
}

impl<T: Stored> Array for &[T] {
    fn bytes(&self) -> u64 {
        (self.len() * T::BYTES) as u64
    }

    fn encode(&self, sink: &mut Sink<'_>) -> Result<(), Problem> {
        let mut bytes = Vec::with_capacity(CHUNK.min(self.len() * T::BYTES));
        for values in self.chunks(CHUNK / T::BYTES) {
            bytes.clear();
            for value in values {
                value.put(&mut bytes);
            }
            sink(&bytes)?;
        }
        Ok(())
    }
}

/// A section: arrays one after another.
struct Section<'a> {
    kind: SectionType,
    flags: u32,
    arrays: Vec<Box<dyn Array + 'a>>,
}

impl Section<'_> {
    fn length(&self) -> u64 {
        self.arrays.iter().map(|array| array.bytes()).sum()
    }

    /// The bytes and the zeros up to the next section.
    fn encode(&self, sink: &mut Sink<'_>) -> Result<(), Problem> {
        for array in &self.arrays {
            array.encode(sink)?;
        }
        let padding = self.length().next_multiple_of(ALIGNMENT) - self.length();
        if padding > 0 { sink(&[0; ALIGNMENT as usize][..padding as usize]) } else { Ok(()) }
    }
}

fn sections<'a>(texture: &'a SilhouetteTexture, sizes: &'a [u32], metadata: &'a [u8]) -> Vec<Section<'a>> {
    let parts = texture.parts();
    let mesh = parts.hull.mesh();
    let arrays = |kind| -> Vec<Box<dyn Array + 'a>> {
        match kind {
            SectionType::SIZE => vec![array(sizes)],
            SectionType::POSITIONS => vec![array(mesh.positions())],
            SectionType::TRIANGLES => vec![array(mesh.triangles())],
            SectionType::CENTERS => vec![array(&parts.centers)],
            SectionType::TANGENTS => vec![array(&parts.tangents)],
            SectionType::PLACES => vec![array(&parts.places)],
            SectionType::ANGLES => angles(&parts.angles),
            SectionType::TEXEL_CENTERS => parts.texel_centers.iter().map(|centers| array(centers)).collect(),
            SectionType::GAPS => vec![array(&parts.gaps)],
            SectionType::COLORS => vec![array(&parts.colors)],
            SectionType::NORMALS => vec![array(&parts.normals)],
            _ => vec![array(metadata)],
        }
    };
    let is_there = |kind| match kind {
        SectionType::TEXEL_CENTERS => parts.texel_centers.is_some(),
        SectionType::METADATA => !metadata.is_empty(),
        _ => true,
    };
    let present = SectionType::KNOWN.into_iter().filter(|&kind| is_there(kind));
    let flags = |kind| if kind == SectionType::METADATA { 0 } else { REQUIRED };
    present.map(|kind| Section { kind, flags: flags(kind), arrays: arrays(kind) }).collect()
}

fn array<T: Stored>(values: &[T]) -> Box<dyn Array + '_> {
    Box::new(values)
}

fn angles(angles: &Angles) -> Vec<Box<dyn Array + '_>> {
    match angles {
        Angles::Unorm8(values) => vec![array(values)],
        Angles::Float16(values) => vec![array(values)],
        Angles::Terms(terms) => {
            let functions = terms.functions.iter().map(|function| array(function));
            functions.chain([array(&terms.offsets), array(&terms.scales), array(&terms.weights)]).collect()
        }
    }
}

/// Header and table, and the length of the file.
fn head(sections: &[Section<'_>], progress: &dyn Progress) -> Result<(Vec<u8>, u64), SiltexError> {
    debug_assert!(sections.len() <= MAX_SECTIONS as usize);
    let mut offset = (HEADER + sections.len() * ENTRY) as u64;
    let mut table = Vec::new();
    for section in sections {
        let mut hasher = Hasher::new();
        let mut hash = |bytes: &[u8]| {
            progress.check()?;
            hasher.update(bytes);
            Ok(())
        };
        section.encode(&mut hash).map_err(|problem| Place::Section(section.kind).error(problem))?;
        let (length, checksum) = (section.length(), hasher.finalize());
        Entry { kind: section.kind, flags: section.flags, offset, length, checksum, reserved: 0 }.put(&mut table);
        // No texture in memory has so many bytes that this overflows.
        offset = aligned_end(offset, length).unwrap_or(u64::MAX);
    }

    let mut head = Vec::with_capacity(HEADER + table.len());
    head.extend(SIGNATURE);
    head.extend(VERSION.0.to_le_bytes());
    head.extend(VERSION.1.to_le_bytes());
    (sections.len() as u32).put(&mut head);
    head.extend(offset.to_le_bytes());
    0_u32.put(&mut head);
    debug_assert_eq!(head.len(), HEADER_CHECKSUM);
    let mut hasher = Hasher::new();
    hasher.update(&head);
    hasher.update(&table);
    hasher.finalize().put(&mut head);
    head.extend(table);
    Ok((head, offset))
}

/// Replaces a file by what `write` writes, if it succeeds.
fn replace(path: &Path, write: impl FnOnce(&mut dyn Write) -> Result<(), SiltexError>) -> Result<(), SiltexError> {
    let cannot = |error: io::Error| Place::File.error(Problem::Write(error));
    let path = path.canonicalize().unwrap_or_else(|_| path.to_owned());
    if path.is_dir() {
        return Err(cannot(io::ErrorKind::IsADirectory.into()));
    }
    if path.exists() && !path.is_file() {
        return Err(cannot(io::Error::new(io::ErrorKind::InvalidInput, "no regular file")));
    }
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let mut builder = tempfile::Builder::new();
    builder.prefix(".siltex-").suffix(".part");
    // As any new file's: by default temporary files are private.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let mut file = builder.tempfile_in(folder).map_err(cannot)?;
    write(&mut file)?;
    file.as_file().sync_all().map_err(cannot)?;
    file.persist(&path).map_err(|error| cannot(error.error))?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A disk that is full after some bytes.
    #[test]
    fn a_write_that_fails_leaves_the_old_file_and_nothing_else() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.siltex");
        for old in [None, Some(b"old")] {
            if let Some(bytes) = old {
                std::fs::write(&path, bytes).unwrap();
            }
            let full = |file: &mut dyn Write| {
                file.write_all(&[7; 100_000]).unwrap();
                Err(Place::File.error(Problem::Write(io::ErrorKind::StorageFull.into())))
            };
            let error = replace(&path, full).unwrap_err();
            assert!(matches!(error.problem, Problem::Write(_)));
            assert_eq!(std::fs::read(&path).ok().as_deref(), old.map(<[u8; 3]>::as_slice));
            assert_eq!(folder.path().read_dir().unwrap().count(), usize::from(old.is_some()));
        }
    }
}
