//! OFF, the Object File Format of Geomview, as text: `OFF` and its variants `[ST][C][N]OFF`.
//!
//! A keyword (which may be missing, or stand against the first number), the numbers of vertices, faces and edges, one row
//! per vertex and one row per face. What follows a vertex's three coordinates (normal, colour, texture coordinates) and a
//! face's corners (colour) is passed over. `#` begins a comment anywhere. Counts may stand on any lines; rows may be
//! broken or share lines where nothing has to be passed over.

use super::assembly::{Assembly, LabelledMesh, check_promise, vertex_id};
use super::error::{Located, Problem};
use super::lines::{Lines, Words};
use super::placing::Placing;
use super::rows::{Rows, read_rows};
use super::steps::Steps;

/// Least bytes of a vertex row, `0 0 0` and the line end.
const LEAST_VERTEX: u64 = 6;
/// Least bytes of a face row, `0` and the line end; such a face is left out, which is for its own note.
const LEAST_FACE: u64 = 2;
/// Least bytes of a face that is taken, `3 0 0 0` and the line end. Memory is reserved for so many at most.
const LEAST_TRIANGLE: usize = 8;

/// Reads an OFF file. O(bytes).
pub(super) fn read(bytes: &[u8], placing: Placing, steps: &mut Steps<'_>) -> Result<LabelledMesh, Located> {
    read_rows(&Lines::new(bytes)?, true, |rows, promised| read_from(rows, promised, placing, steps))
}

fn read_from(
    mut rows: Rows<'_>,
    promised: &mut u64,
    placing: Placing,
    steps: &mut Steps<'_>,
) -> Result<LabelledMesh, Located> {
    keyword(&mut rows)?;
    let vertices = count(&mut rows, "the number of vertices")?;
    let faces = count(&mut rows, "the number of faces")?;
    pass_over_edges(&mut rows);
    *promised = vertices.saturating_add(faces);

    let vertices_here =
        check_promise("vertices", vertices, LEAST_VERTEX, rows.remaining()).map_err(|problem| rows.locate(problem))?;
    check_promise("faces", faces, LEAST_FACE, rows.remaining()).map_err(|problem| rows.locate(problem))?;

    let mut assembly = Assembly::new(placing);
    assembly.positions.reserve_exact(vertices_here);
    for vertex in 0..vertices_here {
        next_row(&mut rows, "vertices", vertices, vertex as u64)?;
        assembly.positions.push(rows.words().position(vertex, &mut assembly.placing)?);
        steps.reach(rows.offset())?;
    }

    assembly.triangles.reserve((rows.remaining() / LEAST_TRIANGLE).min(usize::try_from(faces).unwrap_or(usize::MAX)));
    let mut corners = Vec::new();
    for face in 0..faces {
        next_row(&mut rows, "faces", faces, face)?;
        let words = rows.words();
        let size = words.count("the number of corners of a face")?;
        corners.clear();
        for _ in 0..size {
            let index = words.integer("a vertex number")?;
            corners.push(vertex_id(index, face, vertices).map_err(|problem| words.locate(problem))?);
        }
        assembly.polygon(&corners, || words.place());
        steps.reach(rows.offset())?;
    }
    rows.finish()?;
    assembly.finish()
}

/// Takes the keyword, if there is one; a number may stand against it.
fn keyword(rows: &mut Rows<'_>) -> Result<(), Located> {
    if !rows.next_row() {
        return Err(rows.locate(Problem::expected("the keyword OFF", b"")));
    }
    let word = rows.words().peek();
    if word.first().is_some_and(u8::is_ascii_digit) && !word.ends_with(b"OFF") {
        return Ok(());
    }
    let length = word.iter().position(u8::is_ascii_digit).filter(|&letters| letters > 0).unwrap_or(word.len());
    check_keyword(&word[..length]).map_err(|problem| rows.locate(problem))?;
    let words = rows.words();
    words.take_prefix(length);
    if words.peek() == b"BINARY" {
        let what = "binary OFF".to_owned();
        return Err(rows.locate(Problem::Unsupported { what, mend: "save it as text OFF or as PLY" }));
    }
    Ok(())
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

/// The next count, which may stand on a later line.
fn count(rows: &mut Rows<'_>, expected: &'static str) -> Result<u64, Located> {
    if rows.words().is_empty() {
        rows.next_row();
    }
    rows.words().count(expected)
}

/// Passes over the number of edges, which may be missing where each row stands on a line of its own: a line of one word
/// is no vertex.
fn pass_over_edges(rows: &mut Rows<'_>) {
    if !rows.words().is_empty() {
        rows.words().word();
        return;
    }
    let mut ahead = rows.clone();
    if ahead.next_row() && !ahead.is_stream() {
        let is_alone = |words: &mut Words<'_>| {
            words.word();
            words.is_empty()
        };
        if is_alone(ahead.words()) {
            *rows = ahead;
        }
    }
}

/// Goes to the next row; a file that ends before keeps fewer rows than it promises.
fn next_row(rows: &mut Rows<'_>, what: &str, promised: u64, possible: u64) -> Result<(), Located> {
    if rows.next_row() {
        return Ok(());
    }
    Err(rows.locate(Problem::Promise { what: what.to_owned(), promised, possible }))
}
