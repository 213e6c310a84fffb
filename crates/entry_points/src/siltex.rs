//! [`siltex`].

use silhouette_texture::siltex::fuzz;

/// Reads the bytes behind the first as a silhouette texture. `r` first sets their checksums right, so that what is behind those is
/// reached.
///
/// What is read can be written, and is then read as the same texture; an error is one line.
pub fn siltex(bytes: &[u8]) -> bool {
    match bytes.split_first() {
        Some((b'r', bytes)) => fuzz::read_repaired(bytes).is_ok(),
        Some((_, bytes)) => fuzz::read(bytes).is_ok(),
        None => false,
    }
}
