//! [`Checkpoint`]: finished tiles of a bake in a file, so that an interrupted bake goes on where it was.
//!
//! The file begins with [`MAGIC`], a fingerprint of everything the bake depends on, and the number of tiles. Records follow in the
//! order in which tiles are finished: index, length, bytes and a checksum of these three. All numbers are little-endian. A record
//! that is cut off or damaged, as the last one may be, is dropped with all that follows, and the file is cut back.

use crate::fingerprint::Fingerprint;
use std::fs::{File, OpenOptions};
use std::io::{self, BufReader, Read, Seek, SeekFrom, Write};
use std::path::Path;
use std::sync::Mutex;

/// The first bytes of the file, with its version.
pub const MAGIC: [u8; 8] = *b"SILBAKE1";

/// Bytes before the first record.
const HEADER: u64 = 20;

/// A file of finished tiles, open for more.
#[derive(Debug)]
pub struct Checkpoint {
    file: Mutex<File>,
}

/// A checkpoint that cannot be used.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum CheckpointError {
    /// The file cannot be read or written.
    #[error(transparent)]
    Io(#[from] io::Error),
    /// The file is something else.
    #[error("this is no checkpoint of a bake; choose another name")]
    NoCheckpoint,
    /// The file belongs to another bake.
    #[error("this checkpoint is that of another mesh, hull or choice of options; remove it or choose another name")]
    OtherBake,
}

impl Checkpoint {
    /// Opens or creates the file, and gives each whole record to `restore`, which says whether it is one of the bake's.
    ///
    /// # Errors
    /// [`CheckpointError`]. A file that is not a checkpoint of this very bake is left as it is.
    pub fn open(
        path: &Path,
        fingerprint: u64,
        tiles: u32,
        mut restore: impl FnMut(u32, &[u8]) -> bool,
    ) -> Result<Self, CheckpointError> {
        let mut file = OpenOptions::new().read(true).write(true).create(true).truncate(false).open(path)?;
        let mut header = Vec::with_capacity(HEADER as usize);
        header.extend(MAGIC);
        header.extend(fingerprint.to_le_bytes());
        header.extend(tiles.to_le_bytes());
        let mut found = Vec::new();
        (&file).take(HEADER).read_to_end(&mut found)?;
        let valid = if found == header {
            let length = file.metadata()?.len();
            read_records(BufReader::new(&file), length, &mut restore)?
        } else if header.starts_with(&found) {
            // New, or cut off before the first record.
            file.seek(SeekFrom::Start(0))?;
            file.write_all(&header)?;
            HEADER
        } else if found.starts_with(&MAGIC) {
            return Err(CheckpointError::OtherBake);
        } else {
            return Err(CheckpointError::NoCheckpoint);
        };
        file.set_len(valid)?;
        file.seek(SeekFrom::Start(valid))?;
        Ok(Self { file: Mutex::new(file) })
    }

    /// Appends a finished tile. From any thread.
    ///
    /// # Errors
    /// What the file system reports.
    pub fn append(&self, tile: u32, bytes: &[u8]) -> io::Result<()> {
        let mut record = Vec::with_capacity(bytes.len() + 16);
        record.extend(tile.to_le_bytes());
        record.extend((bytes.len() as u32).to_le_bytes());
        record.extend(bytes);
        let checksum = Fingerprint::default().bytes(&record).finish();
        record.extend(checksum.to_le_bytes());
        // A thread that panicked has written a whole record or a torn last one; both can be followed by no other.
        let mut file = self.file.lock().map_err(|_| io::Error::other("another thread failed while it wrote"))?;
        file.write_all(&record)
    }
}

/// Reads records up to the first that is not whole or not the bake's; bytes up to there.
fn read_records(
    mut from: impl Read,
    length: u64,
    restore: &mut impl FnMut(u32, &[u8]) -> bool,
) -> Result<u64, CheckpointError> {
    let mut valid = HEADER;
    let mut record = Vec::new();
    loop {
        record.clear();
        record.resize(8, 0);
        if !is_read(from.read_exact(&mut record))? {
            return Ok(valid);
        }
        let word = |at: usize| u32::from_le_bytes([record[at], record[at + 1], record[at + 2], record[at + 3]]);
        let (tile, bytes) = (word(0), word(4) as usize);
        // A length that lies must not allocate more than the file holds.
        if valid + 16 + bytes as u64 > length {
            return Ok(valid);
        }
        record.resize(8 + bytes, 0);
        let mut checksum = [0; 8];
        let is_whole = is_read(from.read_exact(&mut record[8..]))? && is_read(from.read_exact(&mut checksum))?;
        let is_intact = is_whole && Fingerprint::default().bytes(&record).finish() == u64::from_le_bytes(checksum);
        if !is_intact || !restore(tile, &record[8..]) {
            return Ok(valid);
        }
        valid += record.len() as u64 + 8;
    }
}

/// Whether as much as was asked for was there.
fn is_read(result: io::Result<()>) -> io::Result<bool> {
    match result {
        Ok(()) => Ok(true),
        Err(error) if error.kind() == io::ErrorKind::UnexpectedEof => Ok(false),
        Err(error) => Err(error),
    }
}
