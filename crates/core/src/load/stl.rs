//! STL, binary and text: triangles as loose corners, joined where their positions are equal.
//!
//! The format has no vertex numbers, so a vertex id is the rank of its position's first appearance; 0.0 and -0.0 are
//! the same position. Stored normals and attribute bytes are passed over: facing follows from the winding. Of a text,
//! lines mean nothing but the end of a solid's name.

use super::assembly::{Assembly, LabelledMesh};
use super::error::{Located, Problem, quote};
use super::lines::{Words, text_start};
use super::placing::Placing;
use super::steps::Steps;
use crate::weld::ExactPositions;
use glam::Vec3;

/// Bytes before the first triangle of a binary file: 80 of free text and a 32-bit count.
const HEADER: usize = 84;
/// Bytes of a binary triangle: normal and three corners as 32-bit floats, and two attribute bytes.
const TRIANGLE: usize = 50;
/// Offset of the first corner in a binary triangle, behind the normal.
const CORNERS: usize = 12;
/// How far to look for a zero byte, which no text has and every binary header of interest does.
const PROBE: usize = 1024;

/// Reads an STL file. O(bytes) expected, by hashing of positions.
pub(super) fn read(bytes: &[u8], placing: Placing, steps: &mut Steps<'_>) -> Result<LabelledMesh, Located> {
    if is_text(bytes) { read_text(bytes, placing, steps) } else { read_binary(bytes, placing, steps) }
}

/// Some binary files begin with `solid`, as text files must. A length that fits the count decides first; a cut binary
/// file with such a header is known by its zero bytes.
fn is_text(bytes: &[u8]) -> bool {
    let fits_count = triangle_count(bytes).is_some_and(|count| bytes.len() as u64 == binary_length(count));
    let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes).trim_ascii_start();
    let solid = text.get(..5).is_some_and(|word| word.eq_ignore_ascii_case(b"solid"));
    !fits_count && solid && !bytes[..bytes.len().min(PROBE)].contains(&0)
}

fn triangle_count(bytes: &[u8]) -> Option<u32> {
    bytes[..].get(HEADER - 4..HEADER).and_then(|count| count.try_into().ok()).map(u32::from_le_bytes)
}

fn binary_length(count: u32) -> u64 {
    HEADER as u64 + TRIANGLE as u64 * u64::from(count)
}

fn read_binary(bytes: &[u8], placing: Placing, steps: &mut Steps<'_>) -> Result<LabelledMesh, Located> {
    let found = bytes.len() as u64;
    let Some(count) = triangle_count(bytes) else {
        return Err(Problem::Truncated { within: "the STL header", needed: HEADER as u64, found }.at_byte(0));
    };
    if found < binary_length(count) {
        let (needed, found) = (binary_length(count) - HEADER as u64, found - HEADER as u64);
        return Err(Problem::Truncated { within: "the triangles its header promises", needed, found }.at_byte(HEADER));
    }
    let mut joiner = Joiner::new(placing);
    joiner.assembly.triangles.reserve_exact(count as usize);
    for (face, triangle) in bytes[HEADER..].chunks_exact(TRIANGLE).take(count as usize).enumerate() {
        let offset = HEADER + face * TRIANGLE;
        let (numbers, _) = triangle[CORNERS..].as_chunks::<4>();
        let mut ids = [0; 3];
        for (slot, id) in ids.iter_mut().enumerate() {
            let coordinates = [0, 1, 2].map(|axis| f32::from_le_bytes(numbers[3 * slot + axis]));
            let place = |axis: usize| joiner.assembly.placing.place(axis, coordinates[axis].into());
            let position = Vec3::from([0, 1, 2].map(place));
            *id = joiner.corner(position).map_err(|problem| problem.at_byte(offset + CORNERS + 12 * slot))?;
        }
        joiner.assembly.triangles.push(ids);
        steps.reach(offset)?;
    }
    joiner.assembly.finish()
}

/// Text, word by word, however the words are spread over lines; several solids one after another are one mesh.
fn read_text(bytes: &[u8], placing: Placing, steps: &mut Steps<'_>) -> Result<LabelledMesh, Located> {
    let start = text_start(bytes)?;
    let mut words = Words::new(&bytes[start..], 1);
    let mut joiner = Joiner::new(placing);
    let mut corners: Vec<u32> = Vec::new();
    // Whether the facet that has begun and not ended has had a loop.
    let mut facet_has_loop: Option<bool> = None;
    while !words.is_empty() {
        let word = words.word();
        let keyword = Keyword::of(word, &mut words);
        let ends_facet = matches!(keyword, Some(Keyword::Facet | Keyword::EndFacet | Keyword::EndSolid));
        if ends_facet && facet_has_loop.take() == Some(false) {
            joiner.assembly.polygon(&[], || words.place());
        }
        match keyword {
            Some(Keyword::Solid) => pass_over_name(&mut words),
            Some(Keyword::EndSolid) => {
                joiner.assembly.has_no_end = false;
                pass_over_name(&mut words);
            }
            Some(Keyword::Facet) => {
                facet_has_loop = Some(false);
                pass_over_normal(&mut words);
            }
            Some(Keyword::EndFacet) => {}
            Some(Keyword::Outer) => {
                read_loop(&mut words, &mut joiner, &mut corners)?;
                joiner.assembly.polygon(&corners, || words.place());
                joiner.assembly.has_no_end = true;
                facet_has_loop = facet_has_loop.and(Some(true));
            }
            _ => return Err(words.locate(Problem::expected("facet, outer loop, endfacet or endsolid", word))),
        }
        steps.reach(start + words.offset())?;
    }
    if facet_has_loop.is_some() {
        return Err(words.locate(Problem::expected("endfacet", b"")));
    }
    joiner.assembly.finish()
}

/// Passes over the name of a solid: up to the end of the line, or to what can be no name.
fn pass_over_name(words: &mut Words<'_>) {
    let goes_on = |words: &Words<'_>| {
        let mut ahead = words.clone();
        let word = ahead.word();
        let is_facet = || word.eq_ignore_ascii_case(b"facet") && ahead.peek().eq_ignore_ascii_case(b"normal");
        begins(word, b"endsolid") || is_facet()
    };
    while !words.is_at_line_start() && !goes_on(words) {
        words.word();
    }
}

/// Passes over `normal` and three words, if they are there. Some writers spell numbers there that are none.
fn pass_over_normal(words: &mut Words<'_>) {
    if !words.peek().eq_ignore_ascii_case(b"normal") {
        return;
    }
    words.word();
    for _ in 0..3 {
        if !words.peek().eq_ignore_ascii_case(b"outer") {
            words.word();
        }
    }
}

/// Reads the vertices of a loop, up to and with its end.
fn read_loop(words: &mut Words<'_>, joiner: &mut Joiner, corners: &mut Vec<u32>) -> Result<(), Located> {
    corners.clear();
    if words.peek().eq_ignore_ascii_case(b"loop") {
        words.word();
    }
    loop {
        let word = words.word();
        match Keyword::of(word, words) {
            Some(Keyword::Vertex) => {
                let vertex = joiner.assembly.positions.len();
                let position = words.position(vertex, &mut joiner.assembly.placing)?;
                corners.push(joiner.corner(position).map_err(|problem| words.locate(problem))?);
            }
            Some(Keyword::EndLoop) => return Ok(()),
            _ => return Err(words.locate(Problem::expected("a vertex or endloop", word))),
        }
    }
}

/// The words of a text file that are no numbers and no names.
#[derive(Clone, Copy)]
enum Keyword {
    Vertex,
    Outer,
    EndLoop,
    Facet,
    EndFacet,
    Solid,
    EndSolid,
}

impl Keyword {
    /// The keyword that a word is, in upper or lower case. The name of a solid may stand against `solid` and `endsolid`.
    /// An `end` of its own is taken with the word that follows.
    fn of(word: &[u8], words: &mut Words<'_>) -> Option<Self> {
        let is = |keyword: &[u8]| word.eq_ignore_ascii_case(keyword);
        Some(match word.first()?.to_ascii_lowercase() {
            b'v' if is(b"vertex") => Self::Vertex,
            b'o' if is(b"outer") || is(b"outerloop") => Self::Outer,
            b'f' if is(b"facet") => Self::Facet,
            b's' if begins(word, b"solid") => Self::Solid,
            b'e' if is(b"endloop") => Self::EndLoop,
            b'e' if is(b"endfacet") => Self::EndFacet,
            b'e' if begins(word, b"endsolid") => Self::EndSolid,
            b'e' if is(b"end") => {
                let next = words.peek();
                let end = match () {
                    () if next.eq_ignore_ascii_case(b"loop") => Self::EndLoop,
                    () if next.eq_ignore_ascii_case(b"facet") => Self::EndFacet,
                    () if begins(next, b"solid") => Self::EndSolid,
                    () => return None,
                };
                words.word();
                end
            }
            _ => return None,
        })
    }
}
/// Whether a word begins with a keyword, in upper or lower case.
fn begins(word: &[u8], keyword: &[u8]) -> bool {
    word.get(..keyword.len()).is_some_and(|begin| begin.eq_ignore_ascii_case(keyword))
}

/// Gives each position one id, in the order of first appearance.
struct Joiner {
    assembly: Assembly,
    known: ExactPositions,
}

impl Joiner {
    fn new(placing: Placing) -> Self {
        Self { assembly: Assembly::new(placing), known: ExactPositions::default() }
    }

    fn corner(&mut self, position: Vec3) -> Result<u32, Problem> {
        let vertex = self.assembly.positions.len();
        if let Some(value) = position.to_array().into_iter().find(|value| !value.is_finite()) {
            return Err(Problem::NotFinite { vertex: vertex as u64, value: quote(value.to_string().as_bytes()) });
        }
        let id = self.known.id_of(position);
        if id as usize == vertex {
            self.assembly.positions.push(position);
        }
        Ok(id)
    }
}
