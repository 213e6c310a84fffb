//! The GLB container, and buffers from its binary chunk, from data URIs and from files beside the document.

use super::dangling::dangling;
use crate::load::Beside;
use crate::load::error::{Located, Problem, quote};
use ::gltf::json::{Buffer, Index, Root};
use base64::Engine as _;
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::fs::File;
use std::io::Read as _;
use std::path::{Component, Path, PathBuf};

/// Bytes of the container's header: magic number, version, length.
const HEADER: usize = 12;

/// Splits a GLB file into its document and its binary chunk; a text file is all document.
pub(super) fn split(bytes: &[u8]) -> Result<(&[u8], Option<&[u8]>), Located> {
    if !bytes.starts_with(b"glTF") {
        return Ok((bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes), None));
    }
    let word = |at: usize| bytes.get(at..at + 4).and_then(|word| word.try_into().ok()).map(u32::from_le_bytes);
    let (Some(version), Some(length)) = (word(4), word(8)) else {
        let found = bytes.len() as u64;
        return Err(Problem::Truncated { within: "the GLB header", needed: HEADER as u64, found }.at_byte(0));
    };
    if version != 2 {
        let what = format!("version {version} of GLB");
        return Err(Problem::Unsupported { what, mend: "export glTF 2.0" }.at_byte(4));
    }
    if (length as usize) < HEADER || length as usize > bytes.len() {
        let found = bytes.len() as u64;
        return Err(Problem::Truncated { within: "the GLB container", needed: u64::from(length), found }.at_byte(0));
    }

    // Chunks: the document first, then perhaps the binary one; later ones belong to extensions.
    let mut chunks = Chunks { bytes: &bytes[..length as usize], offset: HEADER };
    let (kind, json) = chunks.next_chunk()?;
    if kind != *b"JSON" {
        return Err(Problem::expected("a JSON chunk", &kind).at_byte(HEADER));
    }
    let binary =
        if chunks.is_at_end() { None } else { Some(chunks.next_chunk()?).filter(|(kind, _)| kind == b"BIN\0") };
    Ok((json, binary.map(|(_, bytes)| bytes)))
}

/// The chunks of a container, one behind another.
struct Chunks<'a> {
    bytes: &'a [u8],
    offset: usize,
}

impl<'a> Chunks<'a> {
    fn is_at_end(&self) -> bool {
        self.offset == self.bytes.len()
    }

    fn next_chunk(&mut self) -> Result<([u8; 4], &'a [u8]), Located> {
        let rest = &self.bytes[self.offset..];
        let truncated = |needed: u64| {
            Problem::Truncated { within: "a GLB chunk", needed, found: rest.len() as u64 }.at_byte(self.offset)
        };
        let (head, body) = rest.split_first_chunk::<8>().ok_or_else(|| truncated(8))?;
        let [l0, l1, l2, l3, kind @ ..] = *head;
        let length = u32::from_le_bytes([l0, l1, l2, l3]) as usize;
        let chunk = body.get(..length).ok_or_else(|| truncated(8 + length as u64))?;
        self.offset += 8 + length;
        Ok((kind, chunk))
    }
}

/// The buffers of a document, each fetched when it is first needed.
pub(super) struct Buffers<'a> {
    blob: Option<&'a [u8]>,
    beside: Beside<'a>,
    fetched: BTreeMap<usize, Cow<'a, [u8]>>,
}

impl<'a> Buffers<'a> {
    pub(super) fn new(blob: Option<&'a [u8]>, beside: Beside<'a>) -> Self {
        Self { blob, beside, fetched: BTreeMap::new() }
    }

    /// Bytes of the buffers fetched from other files so far, or decoded from text.
    pub(super) fn external_bytes(&self) -> u64 {
        self.fetched.values().filter(|bytes| matches!(bytes, Cow::Owned(_))).map(|bytes| bytes.len() as u64).sum()
    }

    /// Bytes of all buffers fetched so far, and of the binary chunk.
    pub(super) fn bytes(&self) -> usize {
        self.external_bytes() as usize + self.blob.map_or(0, <[u8]>::len)
    }

    /// The buffer's bytes, `byteLength` of them.
    pub(super) fn get(&mut self, root: &Root, index: Index<Buffer>) -> Result<&[u8], Problem> {
        let buffer = root.get(index).ok_or_else(|| dangling("buffers", root.buffers.len()))?;
        if !self.fetched.contains_key(&index.value()) {
            let bytes = self.fetch(buffer, index.value())?;
            self.fetched.insert(index.value(), bytes);
        }
        let bytes = self.fetched.get(&index.value()).map_or(&[][..], |bytes| bytes.as_ref());
        let found = bytes.len() as u64;
        let needed = buffer.byte_length.0;
        let length = usize::try_from(needed).ok().filter(|&length| length <= bytes.len());
        length.map(|length| &bytes[..length]).ok_or(Problem::Truncated { within: "a buffer", needed, found })
    }

    fn fetch(&self, buffer: &Buffer, index: usize) -> Result<Cow<'a, [u8]>, Problem> {
        let Some(uri) = buffer.uri.as_deref() else {
            // Only the first buffer may stand for the container's binary chunk.
            let blob = self.blob.filter(|_| index == 0);
            return blob
                .map(Cow::Borrowed)
                .ok_or_else(|| Problem::expected("a buffer with a uri or a GLB binary chunk", b""));
        };
        match uri.strip_prefix("data:") {
            Some(data) => decode(data).map(Cow::Owned),
            None => self.read_file(uri, buffer.byte_length.0).map(Cow::Owned),
        }
    }

    fn read_file(&self, uri: &str, length: u64) -> Result<Vec<u8>, Problem> {
        let name = unescape(uri);
        let what = || format!("the buffer {}", quote(uri.as_bytes()));
        let Some(folder) = self.beside.folder else {
            return Err(Problem::Unsupported {
                what: what(),
                mend: "load the document from its file, or embed its buffers",
            });
        };
        // A document may name files relative to its own, not any file of the machine that opens it by its path.
        let is_relative = |component| !matches!(component, Component::RootDir | Component::Prefix(_));
        if uri.contains("://") || !Path::new(&name).components().all(is_relative) {
            return Err(Problem::Unsupported { what: what(), mend: "put the buffer beside the document" });
        }
        let path: PathBuf = folder.join(&name);
        let unreadable = |error: std::io::Error| Problem::Unsupported {
            what: format!("{} ({error})", what()),
            mend: "put the buffer beside the document",
        };
        // Asked before opening: to open a pipe is to wait for its writer.
        if !std::fs::metadata(&path).map_err(unreadable)?.is_file() {
            return Err(Problem::Unsupported {
                what: what(),
                mend: "put the buffer beside the document, as a plain file",
            });
        }
        let (found, limit) = (self.external_bytes().saturating_add(length), self.beside.most_bytes);
        if found > limit {
            return Err(Problem::TooLong { found, limit });
        }
        let mut bytes = Vec::new();
        File::open(&path).map_err(unreadable)?.take(length).read_to_end(&mut bytes).map_err(unreadable)?;
        Ok(bytes)
    }
}

/// The bytes of a base64 data URI, without its scheme.
fn decode(data: &str) -> Result<Vec<u8>, Problem> {
    const EXPECTED: &str = "a data URI in base64";
    let (kind, text) = data.split_once(',').ok_or_else(|| Problem::expected(EXPECTED, data.as_bytes()))?;
    if !kind.ends_with(";base64") {
        return Err(Problem::expected(EXPECTED, kind.as_bytes()));
    }
    let engine = &base64::engine::general_purpose::STANDARD;
    engine.decode(text).map_err(|error| Problem::Expected { expected: EXPECTED, found: error.to_string() })
}

/// A relative URI as a file name, its `%xx` escapes undone.
fn unescape(uri: &str) -> String {
    let mut bytes = Vec::with_capacity(uri.len());
    let mut rest = uri.as_bytes();
    while let Some((&byte, tail)) = rest.split_first() {
        let escaped = tail.get(..2).filter(|_| byte == b'%').and_then(|hex| std::str::from_utf8(hex).ok());
        match escaped.and_then(|hex| u8::from_str_radix(hex, 16).ok()) {
            Some(value) => {
                bytes.push(value);
                rest = &tail[2..];
            }
            None => {
                bytes.push(byte);
                rest = tail;
            }
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}
