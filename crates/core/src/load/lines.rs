//! A cursor over the lines of a text file that knows their numbers, and over the words of a line.

use super::error::{Located, Problem, quote};

/// Lines of a file, numbered from 1; `\n` and `\r\n` end a line. Nothing is copied.
pub(super) struct Lines<'a> {
    bytes: &'a [u8],
    /// Offset of the next line.
    offset: usize,
    /// Number of the line last returned.
    number: u64,
}

impl<'a> Lines<'a> {
    /// From the start of a text, behind its byte-order mark.
    ///
    /// UTF-16 is refused here, because read as bytes it would look like a text without a single known word.
    pub(super) fn new(bytes: &'a [u8]) -> Result<Self, Located> {
        if bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) {
            return Err(Problem::NotText.at_line(1));
        }
        let offset = if bytes.starts_with(&[0xef, 0xbb, 0xbf]) { 3 } else { 0 };
        Ok(Self { bytes, offset, number: 0 })
    }

    /// The next line without its end.
    pub(super) fn next_line(&mut self) -> Option<&'a [u8]> {
        let rest = &self.bytes[self.offset..];
        if rest.is_empty() {
            return None;
        }
        let end = rest.iter().position(|&b| b == b'\n').unwrap_or(rest.len());
        self.offset += (end + 1).min(rest.len());
        self.number += 1;
        Some(rest[..end].strip_suffix(b"\r").unwrap_or(&rest[..end]))
    }

    /// The words of the next line that has any, once what follows a `#` is cut off.
    pub(super) fn next_words(&mut self) -> Option<Words<'a>> {
        loop {
            let line = self.next_line()?;
            let end = line.iter().position(|&b| b == b'#').unwrap_or(line.len());
            let words = Words::new(&line[..end], self.number);
            if !words.is_empty() {
                return Some(words);
            }
        }
    }

    /// Offset of the next line, in bytes.
    pub(super) fn offset(&self) -> usize {
        self.offset
    }

    /// Number of the line last returned, from 1.
    pub(super) fn number(&self) -> u64 {
        self.number
    }

    /// Bytes not read yet.
    pub(super) fn remaining(&self) -> usize {
        self.bytes.len() - self.offset
    }
}

/// Words of a line, separated by white space.
#[derive(Clone)]
pub(super) struct Words<'a> {
    rest: &'a [u8],
    line: u64,
}

impl<'a> Words<'a> {
    pub(super) fn new(line: &'a [u8], number: u64) -> Self {
        Self { rest: line.trim_ascii_start(), line: number }
    }

    /// Whether no word is left.
    pub(super) fn is_empty(&self) -> bool {
        self.rest.is_empty()
    }

    /// The line's number, from 1.
    pub(super) fn line(&self) -> u64 {
        self.line
    }

    /// The next word; an empty one at the end of the line.
    pub(super) fn word(&mut self) -> &'a [u8] {
        let end = self.rest.iter().position(u8::is_ascii_whitespace).unwrap_or(self.rest.len());
        let (word, rest) = self.rest.split_at(end);
        self.rest = rest.trim_ascii_start();
        word
    }

    /// The next word as a coordinate of `vertex`, rounded once, correctly, to 32 bits.
    pub(super) fn coordinate(&mut self, vertex: usize) -> Result<f32, Located> {
        let word = self.word();
        coordinate(word, vertex).map_err(|problem| problem.at_line(self.line))
    }

    /// The next word as a whole number; `expected` names it in the message.
    pub(super) fn integer(&mut self, expected: &'static str) -> Result<i64, Located> {
        let word = self.word();
        integer(word, expected).map_err(|problem| problem.at_line(self.line))
    }
}

/// The word as a finite coordinate of `vertex`.
pub(super) fn coordinate(word: &[u8], vertex: usize) -> Result<f32, Problem> {
    let value: f32 = parse(word, "a coordinate")?;
    if value.is_finite() { Ok(value) } else { Err(Problem::NotFinite { vertex: vertex as u64, value: quote(word) }) }
}

/// The word as a whole number.
pub(super) fn integer(word: &[u8], expected: &'static str) -> Result<i64, Problem> {
    parse(word, expected)
}

fn parse<T: std::str::FromStr>(word: &[u8], expected: &'static str) -> Result<T, Problem> {
    let text = std::str::from_utf8(word).map_err(|_| Problem::NotText)?;
    text.parse().map_err(|_| Problem::expected(expected, word))
}
