//! The rows of numbers of a text, whether or not each stands on a line of its own.
//!
//! OFF and text PLY are written with one row per line, and words behind the last number that counts (colours, normals)
//! can then be passed over. But some writers break rows, or put everything on one line. [`read_rows`] therefore reads a
//! text line by line first. Where that fails, it reads the text as one stream of words, none of which may be left over.

use super::error::{Located, Place, Problem};
use super::lines::{Lines, Words};

/// Reads rows with `read`: one per line if that succeeds, otherwise from one stream of words.
///
/// `read` is also given where to put the number of rows that the text promises. If it succeeds neither way, this number
/// decides which of the two errors describes the file: a text with fewer lines than rows was meant as a stream. A `#`
/// begins a comment if `has_comments`. O(bytes) for each way.
pub(super) fn read_rows<T>(
    lines: &Lines<'_>,
    has_comments: bool,
    mut read: impl FnMut(Rows<'_>, &mut u64) -> Result<T, Located>,
) -> Result<T, Located> {
    let is_final = |read: &Result<T, Located>| match read {
        Ok(_) => true,
        Err(error) => matches!(error.problem, Problem::Cancelled(_)),
    };
    let mut promised = 0;
    let by_line = read(Rows::by_line(lines.clone(), has_comments), &mut promised);
    if is_final(&by_line) {
        return by_line;
    }
    let without_comments = if has_comments { blank_comments(lines.rest()) } else { Vec::new() };
    let text = if has_comments { &without_comments } else { lines.rest() };
    let as_stream = read(Rows::stream(text, lines), &mut 0);
    if is_final(&as_stream) || has_fewer_lines(text, promised) { as_stream } else { by_line }
}

/// The text with spaces in place of comments.
fn blank_comments(text: &[u8]) -> Vec<u8> {
    let mut is_comment = false;
    let blank = |&byte: &u8| {
        is_comment = (is_comment || byte == b'#') && byte != b'\n' && byte != b'\r';
        if is_comment { b' ' } else { byte }
    };
    text.iter().map(blank).collect()
}

/// Whether the text has fewer lines with words than `rows`.
fn has_fewer_lines(text: &[u8], rows: u64) -> bool {
    let mut lines = text.split(|&b| b == b'\n' || b == b'\r').filter(|line| !line.trim_ascii().is_empty());
    (lines.by_ref().count() as u64) < rows
}

/// A cursor over rows of words.
#[derive(Clone)]
pub(super) struct Rows<'a> {
    source: Source<'a>,
    words: Words<'a>,
}

#[derive(Clone)]
enum Source<'a> {
    /// A row per line.
    Lines { lines: Lines<'a>, has_comments: bool },
    /// All rows are in `words`, which begin at this offset in the file.
    Stream { start: usize },
}

impl<'a> Rows<'a> {
    fn by_line(lines: Lines<'a>, has_comments: bool) -> Self {
        let words = Words::new(b"", lines.number().max(1));
        Self { source: Source::Lines { lines, has_comments }, words }
    }

    /// The words of `text`, which stands in place of what is left of `lines`.
    fn stream(text: &'a [u8], lines: &Lines<'_>) -> Self {
        Self { source: Source::Stream { start: lines.offset() }, words: Words::new(text, lines.number() + 1) }
    }

    /// Goes to the next row that has words; false if there is none. What is left of the row before is passed over, unless
    /// this is a stream.
    pub(super) fn next_row(&mut self) -> bool {
        if let Source::Lines { lines, has_comments } = &mut self.source {
            loop {
                let next = if *has_comments {
                    lines.next_words()
                } else {
                    lines.next_line().map(|line| Words::new(line, lines.number()))
                };
                let Some(words) = next else { return false };
                self.words = words;
                if !self.words.is_empty() {
                    break;
                }
            }
        }
        !self.words.is_empty()
    }

    /// The words of the row that are left; in a stream, those of all rows.
    pub(super) fn words(&mut self) -> &mut Words<'a> {
        &mut self.words
    }

    /// Whether a row need not end with its line.
    pub(super) fn is_stream(&self) -> bool {
        matches!(self.source, Source::Stream { .. })
    }

    /// Refuses words behind the last row of a stream. Behind the last line that is a row there may be anything.
    pub(super) fn finish(mut self) -> Result<(), Located> {
        if !self.is_stream() || self.words.is_empty() {
            return Ok(());
        }
        let word = self.words.word();
        Err(self.locate(Problem::expected("the end of the file", word)))
    }

    /// Bytes read.
    pub(super) fn offset(&self) -> usize {
        match &self.source {
            Source::Lines { lines, .. } => lines.offset(),
            Source::Stream { start } => start + self.words.offset(),
        }
    }

    /// Bytes not read yet.
    pub(super) fn remaining(&self) -> usize {
        match &self.source {
            Source::Lines { lines, .. } => lines.rest().len(),
            Source::Stream { .. } => self.words.remaining(),
        }
    }

    /// The line of the last word.
    pub(super) fn place(&self) -> Place {
        self.words.place()
    }

    /// Puts a problem on the line of the last word.
    pub(super) fn locate(&self, problem: Problem) -> Located {
        self.words.locate(problem)
    }
}
