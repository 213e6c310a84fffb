//! The GLB container: a document and its binary buffer in one file.

use serde_json::Value;
use std::io::{self, Write};

/// Bytes of the container's header and of the header of each chunk.
const HEADER: usize = 12;
const CHUNK_HEADER: usize = 8;

/// Writes a document and the bytes of its first buffer, which has no `uri`; no bytes, no second chunk. O(bytes).
///
/// # Errors
/// Those of `out`; [`io::ErrorKind::InvalidInput`], before anything is written, beyond the 4 GiB that a container can hold.
pub fn write_container(document: &Value, binary: &[u8], out: &mut dyn Write) -> io::Result<()> {
    let mut text = serde_json::to_vec(document)?;
    text.resize(text.len().next_multiple_of(4), b' ');
    let padding = &[0; 4][..binary.len().next_multiple_of(4) - binary.len()];
    let of_binary = if binary.is_empty() { 0 } else { CHUNK_HEADER + binary.len() + padding.len() };
    let total = u32::try_from(HEADER + CHUNK_HEADER + text.len() + of_binary)
        .map_err(|_| io::Error::new(io::ErrorKind::InvalidInput, "glTF holds at most 4 GiB"))?;
    out.write_all(b"glTF")?;
    for number in [2, total, text.len() as u32] {
        out.write_all(&number.to_le_bytes())?;
    }
    out.write_all(b"JSON")?;
    out.write_all(&text)?;
    if !binary.is_empty() {
        out.write_all(&((binary.len() + padding.len()) as u32).to_le_bytes())?;
        out.write_all(b"BIN\0")?;
        out.write_all(binary)?;
        out.write_all(padding)?;
    }
    Ok(())
}
