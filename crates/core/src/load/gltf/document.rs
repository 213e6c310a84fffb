//! [`parsed`]: the JSON of a document, read in pieces, so that reading can stop between them: nodes and buffers as text can be hundreds of
//! megabytes.

use crate::load::error::{Located, Problem};
use crate::progress::{Cancelled, Progress};
use serde::de::DeserializeOwned;
use std::io::{self, BufReader, Read};

/// Bytes between two questions whether to go on: some milliseconds of parsing.
const PIECE: usize = 256 * 1024;

/// What a document says of some of its members; `expected` names them where they are not there.
pub(super) fn parsed<T: DeserializeOwned>(
    json: &[u8],
    expected: &'static str,
    progress: &dyn Progress,
) -> Result<T, Located> {
    let asking = BufReader::with_capacity(PIECE, Asking { left: json, progress });
    serde_json::from_reader(asking).map_err(|error| {
        if error.is_io() {
            return Problem::Cancelled(Cancelled).into();
        }
        // The reader looks a byte ahead, past the end of a line at times; the bytes themselves say where it is.
        let error = serde_json::from_slice::<T>(json).err().unwrap_or(error);
        let line = error.line() as u64;
        Problem::Expected { expected, found: error.to_string() }.at_line(line)
    })
}

/// Bytes that are handed out as long as nobody cancels.
struct Asking<'a> {
    left: &'a [u8],
    progress: &'a dyn Progress,
}

impl Read for Asking<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        self.progress.check().map_err(io::Error::other)?;
        self.left.read(buffer)
    }
}
