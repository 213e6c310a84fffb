//! OFF, the Object File Format of Geomview, as text: `OFF` and its variants `[ST][C][N]OFF`.
//!
//! A keyword (which may be missing), the numbers of vertices, faces and edges, one row per vertex and one row per face.
//! What follows a vertex's three coordinates (normal, colour, texture coordinates) and a face's corners (colour) is
//! passed over. `#` begins a comment anywhere.

use super::assembly::{Assembly, LabelledMesh, check_promise, vertex_id};
use super::error::{Located, Problem};
use super::lines::{Lines, Words};
use super::steps::Steps;
use glam::Vec3;

/// Least bytes of a vertex row, `0 0 0` and the line end.
const LEAST_VERTEX: u64 = 6;
/// Least bytes of a face row, `0` and the line end; that such a face is refused is for the face's own message.
const LEAST_FACE: u64 = 2;
/// Least bytes of a face that is taken, `3 0 0 0` and the line end. Memory is reserved for so many at most.
const LEAST_TRIANGLE: usize = 8;

/// Reads an OFF file. O(bytes).
pub(super) fn read(bytes: &[u8], steps: &mut Steps<'_>) -> Result<LabelledMesh, Located> {
    let mut lines = Lines::new(bytes)?;
    let mut counts = counts_row(&mut lines)?;
    let vertices = count(&mut counts, "the number of vertices")?;
    let faces = count(&mut counts, "the number of faces")?;

    let at_counts = |problem: Problem| problem.at_line(counts.line());
    let vertices_here = check_promise("vertices", vertices, LEAST_VERTEX, lines.remaining()).map_err(at_counts)?;
    check_promise("faces", faces, LEAST_FACE, lines.remaining()).map_err(at_counts)?;

    let mut assembly = Assembly::default();
    assembly.positions.reserve_exact(vertices_here);
    for vertex in 0..vertices_here {
        let mut row = next_row(&mut lines, "vertices", vertices, vertex as u64)?;
        let mut coordinate = || row.coordinate(vertex);
        assembly.positions.push(Vec3::new(coordinate()?, coordinate()?, coordinate()?));
        steps.reach(lines.offset())?;
    }

    assembly.triangles.reserve((lines.remaining() / LEAST_TRIANGLE).min(usize::try_from(faces).unwrap_or(usize::MAX)));
    let mut corners = Vec::new();
    for face in 0..faces {
        let mut row = next_row(&mut lines, "faces", faces, face)?;
        let line = row.line();
        let size = row.integer("the number of corners of a face")?;
        corners.clear();
        for _ in 0..size {
            let index = row.integer("a vertex number")?;
            corners.push(vertex_id(index, face, vertices).map_err(|problem| problem.at_line(line))?);
        }
        assembly.polygon(face, &corners).map_err(|problem| problem.at_line(line))?;
        steps.reach(lines.offset())?;
    }
    assembly.finish()
}

/// Reads the keyword, if there is one, and returns the words that follow it: the counts.
fn counts_row<'a>(lines: &mut Lines<'a>) -> Result<Words<'a>, Located> {
    let end = |lines: &Lines<'_>| Problem::expected("the keyword OFF", b"").at_line(lines.number());
    let first = lines.next_words().ok_or_else(|| end(lines))?;
    let mut after_keyword = first.clone();
    let keyword = after_keyword.word();
    if keyword.first().is_some_and(u8::is_ascii_digit) && !keyword.ends_with(b"OFF") {
        return Ok(first);
    }
    check_keyword(keyword).map_err(|problem| problem.at_line(first.line()))?;
    if after_keyword.is_empty() {
        return lines
            .next_words()
            .ok_or_else(|| Problem::expected("the number of vertices", b"").at_line(lines.number()));
    }
    if after_keyword.clone().word() == b"BINARY" {
        let what = "binary OFF".to_owned();
        return Err(Problem::Unsupported { what, mend: "save it as text OFF or as PLY" }.at_line(first.line()));
    }
    Ok(after_keyword)
}

/// Takes `[ST][C][N]OFF`; `4` and `n` variants have other than three coordinates.
fn check_keyword(keyword: &[u8]) -> Result<(), Problem> {
    let bare = keyword.strip_prefix(b"ST").unwrap_or(keyword);
    let bare = bare.strip_prefix(b"C").unwrap_or(bare);
    let bare = bare.strip_prefix(b"N").unwrap_or(bare);
    match bare {
        b"OFF" | b"off" => Ok(()),
        b"4OFF" | b"nOFF" | b"4nOFF" => Err(Problem::Unsupported {
            what: format!("{} (other than three coordinates a vertex)", String::from_utf8_lossy(keyword)),
            mend: "save it as plain OFF",
        }),
        _ => Err(Problem::expected("the keyword OFF", keyword)),
    }
}

fn count(words: &mut Words<'_>, expected: &'static str) -> Result<u64, Located> {
    let word = words.clone().word();
    u64::try_from(words.integer(expected)?).map_err(|_| Problem::expected(expected, word).at_line(words.line()))
}

/// The next row with words; a file that ends before keeps fewer rows than it promises.
fn next_row<'a>(lines: &mut Lines<'a>, what: &str, promised: u64, possible: u64) -> Result<Words<'a>, Located> {
    lines
        .next_words()
        .ok_or_else(|| Problem::Promise { what: what.to_owned(), promised, possible }.at_line(lines.number()))
}
