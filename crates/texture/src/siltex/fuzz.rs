//! Properties of reading, as functions of arbitrary bytes: the bodies of fuzz targets, and of this crate's own tests over mutated
//! files.
//!
//! A fuzz target is one line, such as `fuzz_target!(|bytes: &[u8]| siltex::fuzz::read_repaired(bytes));`.

use super::format::{ENTRY, Entry, HEADER, HEADER_CHECKSUM, aligned_end, part};
use super::{Siltex, SiltexError, read_from, write_to};
use silhouette_core::NoProgress;
use std::io::Cursor;

/// Reads bytes; what is read can be written, and then gives the same texture.
///
/// # Errors
/// What [`read_from`] says of the bytes.
///
/// # Panics
/// If reading and writing are not each other's inverse, or an error's message is not one line: a bug.
pub fn read(bytes: &[u8]) -> Result<Siltex, SiltexError> {
    let file = read_from(Cursor::new(bytes)).inspect_err(|error| {
        let message = error.to_string();
        assert!(!message.is_empty() && !message.contains(char::is_control), "{message:?}");
    })?;
    let written = bytes_of(&file);
    let again = read_from(Cursor::new(&written)).unwrap_or_else(|error| panic!("what was written is refused: {error}"));
    assert!(written == bytes_of(&again), "what was written is read differently");
    Ok(file)
}

/// [`read`]s bytes whose checksums are set right first, so that the checks behind them are reached.
///
/// # Errors
/// What [`read_from`] says of the repaired bytes.
///
/// # Panics
/// As [`read`].
pub fn read_repaired(bytes: &[u8]) -> Result<Siltex, SiltexError> {
    let mut bytes = bytes.to_vec();
    repair_checksums(&mut bytes);
    read(&bytes)
}

/// Sets the checksums of all sections that lie within the bytes, and that of the header.
fn repair_checksums(bytes: &mut [u8]) {
    if bytes.len() < HEADER {
        return;
    }
    let count = u32::from_le_bytes(part(bytes, 12)) as usize;
    let entries = count.min((bytes.len() - HEADER) / ENTRY);
    for index in 0..entries {
        let at = HEADER + index * ENTRY;
        let Entry { offset, length, .. } = Entry::take(&part(bytes, at));
        let end = aligned_end(offset, length).and_then(|end| usize::try_from(end).ok());
        if let Some(section) = end.and_then(|end| bytes.get(offset as usize..end)) {
            let checksum = crc32fast::hash(section);
            bytes[at + 24..at + 28].copy_from_slice(&checksum.to_le_bytes());
        }
    }
    let mut hasher = crc32fast::Hasher::new();
    hasher.update(&bytes[..HEADER_CHECKSUM]);
    hasher.update(&bytes[HEADER..HEADER + entries * ENTRY]);
    bytes[HEADER_CHECKSUM..HEADER].copy_from_slice(&hasher.finalize().to_le_bytes());
}

fn bytes_of(file: &Siltex) -> Vec<u8> {
    let mut bytes = Vec::new();
    let written = write_to(&mut bytes, &file.texture, &file.metadata, &NoProgress);
    written.unwrap_or_else(|error| panic!("what was read cannot be written: {error}"));
    bytes
}
