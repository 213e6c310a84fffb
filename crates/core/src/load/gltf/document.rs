//! [`parsed`]: the JSON of a document, read in pieces where it holds many values, so that reading can stop between them: nodes can be
//! hundreds of megabytes of text.

use crate::load::error::{Located, Problem};
use crate::progress::{Cancelled, Progress};
use serde::de::DeserializeOwned;
use std::io::{self, BufReader, Read};

/// Bytes between two questions whether to go on: some milliseconds of parsing.
const PIECE: usize = 256 * 1024;

/// Commas up to which a document is parsed in one go, which takes some hundredths of a second. Long texts, such as buffers in base 64,
/// are taken from a slice as they are, and from a reader byte by byte.
const FEW_COMMAS: usize = 1 << 18;

/// What a document says of some of its members; `expected` names them where they are not there.
pub(super) fn parsed<T: DeserializeOwned>(
    json: &[u8],
    expected: &'static str,
    progress: &dyn Progress,
) -> Result<T, Located> {
    progress.check().map_err(Problem::Cancelled)?;
    let commas = json.iter().filter(|&&byte| byte == b',').count();
    if commas > FEW_COMMAS {
        let asking = BufReader::with_capacity(PIECE, Asking { left: json, progress });
        match serde_json::from_reader(asking) {
            Ok(parsed) => return Ok(parsed),
            Err(error) if error.is_io() => return Err(Problem::Cancelled(Cancelled).into()),
            // The reader looks a byte ahead, past the end of a line at times; the bytes themselves say where the error is.
            Err(_) => {}
        }
    }
    serde_json::from_slice(json).map_err(|error| {
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
