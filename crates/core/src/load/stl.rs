//! STL, binary and text: triangles as loose corners, joined where their positions are equal.
//!
//! The format has no vertex numbers, so a vertex id is the rank of its position's first appearance; 0.0 and -0.0 are
//! the same position. Stored normals and attribute bytes are passed over: facing follows from the winding.

use super::assembly::{Assembly, LabelledMesh};
use super::error::{Located, Problem, quote};
use super::lines::{Lines, Words};
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
pub(super) fn read(bytes: &[u8], steps: &mut Steps<'_>) -> Result<LabelledMesh, Located> {
    if is_text(bytes) { read_text(bytes, steps) } else { read_binary(bytes, steps) }
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

fn read_binary(bytes: &[u8], steps: &mut Steps<'_>) -> Result<LabelledMesh, Located> {
    let found = bytes.len() as u64;
    let Some(count) = triangle_count(bytes) else {
        return Err(Problem::Truncated { within: "the STL header", needed: HEADER as u64, found }.at_byte(0));
    };
    if found < binary_length(count) {
        let (needed, found) = (binary_length(count) - HEADER as u64, found - HEADER as u64);
        return Err(Problem::Truncated { within: "the triangles its header promises", needed, found }.at_byte(HEADER));
    }
    let mut joiner = Joiner::default();
    joiner.assembly.triangles.reserve_exact(count as usize);
    for (face, triangle) in bytes[HEADER..].chunks_exact(TRIANGLE).take(count as usize).enumerate() {
        let offset = HEADER + face * TRIANGLE;
        let (numbers, _) = triangle[CORNERS..].as_chunks::<4>();
        let mut ids = [0; 3];
        for (slot, id) in ids.iter_mut().enumerate() {
            let [x, y, z] = [0, 1, 2].map(|axis| f32::from_le_bytes(numbers[3 * slot + axis]));
            *id = joiner.corner(Vec3::new(x, y, z)).map_err(|problem| problem.at_byte(offset + CORNERS + 12 * slot))?;
        }
        joiner.assembly.triangles.push(ids);
        steps.reach(offset)?;
    }
    joiner.assembly.finish()
}

/// Text, row by row; several solids one after another are one mesh.
fn read_text(bytes: &[u8], steps: &mut Steps<'_>) -> Result<LabelledMesh, Located> {
    let mut lines = Lines::new(bytes)?;
    let mut joiner = Joiner::default();
    let mut corners: Vec<u32> = Vec::new();
    let mut faces = 0;
    let (mut inside, mut complete) = (false, false);
    while let Some(line) = lines.next_line() {
        let mut words = Words::new(line, lines.number());
        let word = words.word();
        let wrong = |expected| Err(Problem::expected(expected, line).at_line(lines.number()));
        match word.to_ascii_lowercase().as_slice() {
            b"vertex" if inside => {
                let vertex = joiner.assembly.positions.len();
                let mut coordinate = || words.coordinate(vertex);
                let position = Vec3::new(coordinate()?, coordinate()?, coordinate()?);
                corners.push(joiner.corner(position).map_err(|problem| problem.at_line(lines.number()))?);
            }
            b"outer" if !inside => inside = true,
            b"endloop" if inside => {
                joiner.assembly.polygon(faces, &corners).map_err(|problem| problem.at_line(lines.number()))?;
                corners.clear();
                faces += 1;
                inside = false;
            }
            _ if inside => return wrong("a vertex row or endloop"),
            b"solid" => complete = false,
            b"endsolid" => complete = true,
            b"" | b"facet" | b"endfacet" => {}
            _ => return wrong("facet, outer loop, endfacet or endsolid"),
        }
        steps.reach(lines.offset())?;
    }
    if inside {
        return Err(Problem::expected("a vertex row or endloop", b"").at_line(lines.number()));
    }
    if !complete {
        // Cut between two facets, the rest would look like a whole mesh with a hole.
        return Err(Problem::expected("a facet or endsolid", b"").at_line(lines.number()));
    }
    joiner.assembly.finish()
}

/// Gives each position one id, in the order of first appearance.
#[derive(Default)]
struct Joiner {
    assembly: Assembly,
    known: ExactPositions,
}

impl Joiner {
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
