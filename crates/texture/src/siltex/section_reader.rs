//! [`SectionReader`]: a section's values in their order, and at its end the check of its bytes.

use super::error::Problem;
use super::format::{ALIGNMENT, Entry};
use super::stored::Stored;
use crc32fast::Hasher;
use std::io::{Read, Seek, SeekFrom};

/// Bytes that are read before they are decoded.
const CHUNK: usize = 1 << 16;

/// Reads one section from its begin to its end.
pub(super) struct SectionReader<'a, R> {
    reader: &'a mut R,
    left: u64,
    padding: u64,
    checksum: u32,
    hasher: Hasher,
}

impl<'a, R: Read + Seek> SectionReader<'a, R> {
    /// A section that lies within the file.
    pub(super) fn new(reader: &'a mut R, entry: &Entry) -> Result<Self, Problem> {
        reader.seek(SeekFrom::Start(entry.offset)).map_err(Problem::Read)?;
        let padding = entry.length.next_multiple_of(ALIGNMENT) - entry.length;
        Ok(Self { reader, left: entry.length, padding, checksum: entry.checksum, hasher: Hasher::new() })
    }

    /// The next `count` values. Memory is taken only for values that the section has bytes for.
    pub(super) fn values<T: Stored>(&mut self, count: u64) -> Result<Vec<T>, Problem> {
        let bytes = count.saturating_mul(T::BYTES as u64);
        if bytes > self.left {
            return Err(Problem::SectionLength { found: self.left, expected: bytes });
        }
        self.left -= bytes;
        let mut values = Vec::new();
        let fits = usize::try_from(count).is_ok_and(|count| values.try_reserve_exact(count).is_ok());
        if !fits {
            return Err(Problem::Memory { bytes });
        }
        let most = (CHUNK / T::BYTES * T::BYTES) as u64;
        let mut chunk = vec![0; bytes.min(most) as usize];
        let mut left = bytes;
        while left > 0 {
            let piece = &mut chunk[..left.min(most) as usize];
            self.fill(piece)?;
            values.extend(piece.chunks_exact(T::BYTES).map(T::take));
            left -= piece.len() as u64;
        }
        Ok(values)
    }

    /// Checks that nothing is left, and the checksum.
    pub(super) fn finish(mut self) -> Result<(), Problem> {
        debug_assert_eq!(self.left, 0, "sections are as long as their values");
        let mut padding = [0; ALIGNMENT as usize];
        self.fill(&mut padding[..self.padding as usize])?;
        if self.hasher.finalize() == self.checksum { Ok(()) } else { Err(Problem::Checksum) }
    }

    fn fill(&mut self, bytes: &mut [u8]) -> Result<(), Problem> {
        self.reader.read_exact(bytes).map_err(Problem::Read)?;
        self.hasher.update(bytes);
        Ok(())
    }
}
