//! [`Metadata`]: what a texture was baked from, with which options and by what.

use super::error::Problem;
use super::stored::Stored as _;
use std::collections::BTreeMap;

/// Free text by key, such as `mesh` or `version`. Keys are not empty. Nothing in it changes how a texture is drawn.
pub type Metadata = BTreeMap<String, String>;

/// The bytes of section `META`: for each key in ascending order of its bytes, the length of the key in bytes, the key, the length
/// of the value, the value.
pub(super) fn encode(metadata: &Metadata) -> Result<Vec<u8>, Problem> {
    let mut bytes = Vec::new();
    for (key, value) in metadata {
        if key.is_empty() {
            return Err(Problem::Metadata(EMPTY_KEY));
        }
        for text in [key, value] {
            u32::try_from(text.len()).map_err(|_| Problem::Metadata("a text is longer than 4 GiB"))?.put(&mut bytes);
            bytes.extend_from_slice(text.as_bytes());
        }
    }
    Ok(bytes)
}

const EMPTY_KEY: &str = "a key is empty";

/// Inverse of [`encode`]; refuses whatever it cannot yield.
pub(super) fn decode(bytes: &[u8]) -> Result<Metadata, Problem> {
    let mut rest = bytes;
    let mut metadata = Metadata::new();
    while !rest.is_empty() {
        let key = text(&mut rest)?;
        let value = text(&mut rest)?;
        if key.is_empty() {
            return Err(Problem::Metadata(EMPTY_KEY));
        }
        if metadata.last_key_value().is_some_and(|(last, _)| last.as_str() >= key) {
            return Err(Problem::Metadata("keys are not in ascending order"));
        }
        metadata.insert(key.to_owned(), value.to_owned());
    }
    Ok(metadata)
}

/// The next text, taken from the front.
fn text<'a>(rest: &mut &'a [u8]) -> Result<&'a str, Problem> {
    let cut = Problem::Metadata("a text ends beyond its section");
    let Some((length, after)) = rest.split_at_checked(u32::BYTES) else { return Err(cut) };
    let Some((bytes, after)) = after.split_at_checked(u32::take(length) as usize) else { return Err(cut) };
    *rest = after;
    std::str::from_utf8(bytes).map_err(|_| Problem::Metadata("a text is not UTF-8"))
}
