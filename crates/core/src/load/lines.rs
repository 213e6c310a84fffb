//! A cursor over the lines of a text file that knows their numbers, and over the words of a text.

use super::error::{Located, Place, Problem, quote};
use super::placing::Placing;
use glam::Vec3;

/// Lines of a file, numbered from 1; `\n`, `\r\n` and `\r` alone end a line. Nothing is copied.
#[derive(Clone)]
pub(super) struct Lines<'a> {
    bytes: &'a [u8],
    /// Offset of the next line.
    offset: usize,
    /// Number of the line last returned.
    number: u64,
    /// Whether the first line ended in `\r` alone. Then so do all: a `\n` behind an `\r` may be the first byte of a
    /// binary body.
    ends_in_cr: bool,
}

impl<'a> Lines<'a> {
    /// From the start of a text, behind its byte-order mark.
    ///
    /// UTF-16 is refused here, because read as bytes it would look like a text without a single known word.
    pub(super) fn new(bytes: &'a [u8]) -> Result<Self, Located> {
        Ok(Self { bytes, offset: text_start(bytes)?, number: 0, ends_in_cr: false })
    }

    /// The next line without its end.
    pub(super) fn next_line(&mut self) -> Option<&'a [u8]> {
        let rest = &self.bytes[self.offset..];
        if rest.is_empty() {
            return None;
        }
        let end = rest.iter().position(|&b| is_line_end(b)).unwrap_or(rest.len());
        let is_cr_lf = rest[end..].starts_with(b"\r\n");
        if self.number == 0 {
            self.ends_in_cr = rest.get(end) == Some(&b'\r') && !is_cr_lf;
        }
        let length = if is_cr_lf && !self.ends_in_cr { 2 } else { 1 };
        self.offset += (end + length).min(rest.len());
        self.number += 1;
        Some(&rest[..end])
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

    /// What has not been read yet.
    pub(super) fn rest(&self) -> &'a [u8] {
        &self.bytes[self.offset..]
    }
}

/// Offset of a text behind its byte-order mark; UTF-16 is refused.
pub(super) fn text_start(bytes: &[u8]) -> Result<usize, Located> {
    if bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) {
        return Err(Problem::NotText.at_line(1));
    }
    Ok(if bytes.starts_with(&[0xef, 0xbb, 0xbf]) { 3 } else { 0 })
}

fn is_line_end(byte: u8) -> bool {
    byte == b'\n' || byte == b'\r'
}

/// Words of a text, separated by white space.
#[derive(Clone)]
pub(super) struct Words<'a> {
    text: &'a [u8],
    rest: &'a [u8],
    /// The number of the text's first line.
    first_line: u64,
}

impl<'a> Words<'a> {
    /// The words of a text whose first line has this number.
    pub(super) fn new(text: &'a [u8], first_line: u64) -> Self {
        Self { text, rest: text.trim_ascii_start(), first_line }
    }

    /// Whether no word is left.
    pub(super) fn is_empty(&self) -> bool {
        self.rest.is_empty()
    }

    /// The number, from 1, of the line in which the last word stands that was taken. O(bytes), for messages.
    pub(super) fn line(&self) -> u64 {
        let taken = self.text[..self.offset()].trim_ascii_end();
        let is_end = |&at: &usize| taken[at] == b'\n' || (taken[at] == b'\r' && taken.get(at + 1) != Some(&b'\n'));
        self.first_line + (0..taken.len()).filter(is_end).count() as u64
    }

    /// Offset of the next word in the text.
    pub(super) fn offset(&self) -> usize {
        self.text.len() - self.rest.len()
    }

    /// Bytes not read yet.
    pub(super) fn remaining(&self) -> usize {
        self.rest.len()
    }

    /// Whether the next word begins a line, or there is none.
    pub(super) fn is_at_line_start(&self) -> bool {
        let before = self.text[..self.offset()].iter().rev();
        self.is_empty() || before.take_while(|b| b.is_ascii_whitespace()).any(|&b| is_line_end(b))
    }

    /// The next word; an empty one at the end of the text.
    pub(super) fn word(&mut self) -> &'a [u8] {
        let end = self.rest.iter().position(u8::is_ascii_whitespace).unwrap_or(self.rest.len());
        let (word, rest) = self.rest.split_at(end);
        self.rest = rest.trim_ascii_start();
        word
    }

    /// The next word, which is not taken.
    pub(super) fn peek(&self) -> &'a [u8] {
        self.clone().word()
    }

    /// Takes the first bytes of the next word.
    pub(super) fn take_prefix(&mut self, length: usize) {
        self.rest = self.rest[length..].trim_ascii_start();
    }

    /// The next three words as the position of `vertex`, rounded once, correctly, to 32 bits.
    #[inline]
    pub(super) fn position(&mut self, vertex: usize, placing: &mut Placing) -> Result<Vec3, Located> {
        let mut coordinate = |axis| self.coordinate(axis, vertex, placing);
        Ok(Vec3::new(coordinate(0)?, coordinate(1)?, coordinate(2)?))
    }

    /// The next word as the coordinate of `vertex` along an axis.
    #[inline]
    pub(super) fn coordinate(&mut self, axis: usize, vertex: usize, placing: &mut Placing) -> Result<f32, Located> {
        let word = self.word();
        coordinate(word, axis, vertex, placing).map_err(|problem| self.locate(problem))
    }

    /// The next word as a whole number; `expected` names it in the message.
    pub(super) fn integer(&mut self, expected: &'static str) -> Result<i64, Located> {
        let word = self.word();
        integer(word, expected).map_err(|problem| self.locate(problem))
    }

    /// The next word as a count; `expected` names it in the message.
    pub(super) fn count(&mut self, expected: &'static str) -> Result<u64, Located> {
        let word = self.peek();
        let count = self.integer(expected)?;
        u64::try_from(count).map_err(|_| self.locate(Problem::expected(expected, word)))
    }

    /// The line of the last word.
    pub(super) fn place(&self) -> Place {
        Place::Line(self.line())
    }

    /// Puts a problem on the line of the last word.
    pub(super) fn locate(&self, problem: Problem) -> Located {
        problem.at_line(self.line())
    }
}

/// The word as a finite coordinate of `vertex`.
#[inline]
fn coordinate(word: &[u8], axis: usize, vertex: usize, placing: &mut Placing) -> Result<f32, Problem> {
    const EXPECTED: &str = "a coordinate";
    let value =
        if placing.is_wide() { placing.place(axis, parse(word, EXPECTED)?) } else { parse::<f32>(word, EXPECTED)? };
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
