//! Wavefront OBJ: `v` rows and `f` rows; `usemtl` and `g` rows, whose names make labels; `o` and `g` rows, which name parts; `s`
//! and `l` rows, which make feature edges; every other row is passed over.
//!
//! A vertex id is the rank of its `v` row, whatever groups and objects stand between. Of a corner `v/vt/vn` only `v`
//! counts. A face may name vertices by number from 1, in rows that come later too, or backwards from the row reached so
//! far (-1 is the vertex last read). A line that names no vertex there joins nothing. A `\` at the end of a row, or before
//! nothing but spaces, joins the next one to it.

use super::assembly::{Assembly, LabelledMesh};
use super::error::{Located, Problem};
use super::feature_edges::FeatureEdges;
use super::lines::{Lines, Words};
use super::parts::{PartRows, words_of};
use super::placing::Placing;
use super::steps::Steps;
use std::collections::HashMap;

/// Reads an OBJ file. O(bytes).
pub(super) fn read(bytes: &[u8], placing: Placing, steps: &mut Steps<'_>) -> Result<LabelledMesh, Located> {
    let mut lines = Lines::new(bytes)?;
    let mut joined = Vec::new();
    let mut reader = Reader::new(placing);
    while let Some(line) = lines.next_line() {
        let first_number = lines.number();
        if line.trim_ascii_end().ends_with(b"\\") && !ends_in_comment(line) {
            join(line, &mut lines, &mut joined);
            reader.row(Words::new(&joined, first_number))?;
        } else {
            reader.row(Words::new(line, first_number))?;
        }
        steps.reach(lines.offset())?;
    }
    reader.finish()
}

/// Whether a word of the row begins a comment.
fn ends_in_comment(line: &[u8]) -> bool {
    line.split(u8::is_ascii_whitespace).any(|word| word.starts_with(b"#"))
}

/// Collects a row and the rows that its trailing backslashes join to it.
fn join<'a>(first: &'a [u8], lines: &mut Lines<'a>, joined: &mut Vec<u8>) {
    joined.clear();
    let mut line = first;
    while let Some(continued) = line.trim_ascii_end().strip_suffix(b"\\").filter(|_| !ends_in_comment(line)) {
        joined.extend_from_slice(continued);
        joined.push(b' ');
        line = lines.next_line().unwrap_or_default();
    }
    joined.extend_from_slice(line);
}

struct Reader {
    assembly: Assembly,
    /// Corners of the face being read; kept to spare an allocation per face.
    corners: Vec<u32>,
    /// Faces read so far, as the file counts them.
    faces: u64,
    /// The highest vertex number that was named before its row was read.
    ahead: Option<Ahead>,
    sorts: Sorts,
    parts: PartRows,
    feature_edges: FeatureEdges,
}

/// What distinguishes faces besides their corners.
#[derive(Default)]
struct Sorts {
    /// The numbers of the material and of the groups that hold for the faces to come; 0 where none was named.
    current: [u32; 2],
    has_changed: bool,
    /// Numbers from 1 of the materials and of the groups named so far.
    numbers: [HashMap<Vec<u8>, u32>; 2],
    /// The label of each pair that a face had, in order of appearance.
    labels: HashMap<[u32; 2], u32>,
}

const MATERIAL: usize = 0;
const GROUPS: usize = 1;

impl Sorts {
    /// Changes the material or the groups to what a row names.
    fn name(&mut self, which: usize, words: Words<'_>) {
        let mut of_row = words_of(words);
        if which == GROUPS {
            // A set of names, in any order; this one stands for none.
            of_row.sort_unstable();
            of_row.dedup();
            of_row.retain(|&word| word != b"default");
        }
        let name = of_row.join(&b' ');
        let next = self.numbers[which].len() as u32 + 1;
        self.current[which] = if name.is_empty() { 0 } else { *self.numbers[which].entry(name).or_insert(next) };
        self.has_changed = true;
    }

    /// The label of the next face, if it may be another than that of the last.
    fn changed_label(&mut self) -> Option<u32> {
        if !std::mem::replace(&mut self.has_changed, false) {
            return None;
        }
        let next = self.labels.len() as u32 + 1;
        Some(if self.current == [0; 2] { 0 } else { *self.labels.entry(self.current).or_insert(next) })
    }
}

/// A vertex named before its row.
struct Ahead {
    number: i64,
    face: u64,
    line: u64,
}

impl Reader {
    fn new(placing: Placing) -> Self {
        Self {
            assembly: Assembly::new(placing),
            corners: Vec::new(),
            faces: 0,
            ahead: None,
            sorts: Sorts::default(),
            feature_edges: FeatureEdges::default(),
            parts: PartRows::default(),
        }
    }

    fn row(&mut self, mut words: Words<'_>) -> Result<(), Located> {
        match words.word() {
            b"v" => self.vertex(words),
            b"f" => self.face(words),
            b"usemtl" => {
                self.sorts.name(MATERIAL, words);
                Ok(())
            }
            b"o" => {
                self.parts.object(words);
                Ok(())
            }
            b"g" => {
                self.parts.groups(words.clone());
                self.sorts.name(GROUPS, words);
                Ok(())
            }
            b"s" => {
                self.feature_edges.begin_group(words.word());
                Ok(())
            }
            b"l" => {
                self.line(words);
                Ok(())
            }
            _ => Ok(()),
        }
    }

    fn vertex(&mut self, mut words: Words<'_>) -> Result<(), Located> {
        let vertex = self.assembly.positions.len();
        let position = words.position(vertex, &mut self.assembly.placing)?;
        self.assembly.positions.push(position);
        Ok(())
    }

    fn face(&mut self, mut words: Words<'_>) -> Result<(), Located> {
        self.corners.clear();
        while !words.is_empty() {
            let corner = words.word();
            // A comment may follow the corners.
            if corner.starts_with(b"#") {
                break;
            }
            let vertex = self.resolve(corner, &words)?;
            self.corners.push(vertex);
        }
        if let Some(label) = self.sorts.changed_label() {
            self.assembly.begin_label(label);
        }
        if let Some(part) = self.parts.changed_part() {
            self.assembly.begin_part(part);
        }
        let first = self.assembly.triangles.len();
        self.assembly.polygon(&self.corners, || words.place());
        let triangles = self.assembly.triangles.len() - first;
        if triangles > 0 {
            self.feature_edges.polygon(first, triangles);
        }
        self.faces += 1;
        Ok(())
    }

    /// Takes a line through vertices `v` or `v/vt`.
    fn line(&mut self, mut words: Words<'_>) {
        let mut before = None;
        while !words.is_empty() {
            let word = words.word();
            if word.starts_with(b"#") {
                break;
            }
            let end = self.vertex_of_line(word);
            if let (Some(a), Some(b)) = (before, end) {
                self.feature_edges.line(a, b);
            }
            before = end;
        }
    }

    /// The vertex id that a word of a line names, if it is one; there need be no such vertex.
    fn vertex_of_line(&self, word: &[u8]) -> Option<u32> {
        let number = vertex_number(word).ok().filter(|&number| number != 0)?;
        u32::try_from(self.rank(number)).ok()
    }

    /// The vertex id that a corner `v/vt/vn` names, the word last taken of a row.
    fn resolve(&mut self, corner: &[u8], words: &Words<'_>) -> Result<u32, Located> {
        let number = vertex_number(corner).map_err(|problem| words.locate(problem))?;
        if number == 0 {
            return Err(words.locate(Problem::VertexZero));
        }
        let Ok(id) = u32::try_from(self.rank(number)) else {
            return Err(words.locate(self.out_of_range(self.faces, number)));
        };
        let known = self.assembly.positions.len();
        if id as usize >= known && self.ahead.as_ref().is_none_or(|ahead| number > ahead.number) {
            self.ahead = Some(Ahead { number, face: self.faces, line: words.line() });
        }
        Ok(id)
    }

    /// The rank of the `v` row that a number other than 0 names from the row reached so far; negative if there is none.
    fn rank(&self, number: i64) -> i64 {
        let known = self.assembly.positions.len() as i64;
        // Saturation keeps a number below -2^63 + V out of range.
        if number > 0 { number - 1 } else { known.saturating_add(number) }
    }

    fn out_of_range(&self, face: u64, index: i64) -> Problem {
        let allowed = match self.assembly.positions.len() {
            0 => "there are no vertices".to_owned(),
            count if index < 0 => format!("only -{count} to -1 (or 1 to {count}) exist up to this line"),
            count => format!("only 1 to {count} (or -{count} to -1) exist"),
        };
        Problem::VertexOutOfRange { face, index, allowed }
    }

    fn finish(mut self) -> Result<LabelledMesh, Located> {
        if let Some(ahead) = &self.ahead
            && ahead.number > self.assembly.positions.len() as i64
        {
            return Err(self.out_of_range(ahead.face, ahead.number).at_line(ahead.line));
        }
        self.assembly.parts = self.parts.parts;
        let mut labelled = self.assembly.finish()?;
        labelled.feature_edges = self.feature_edges.of_mesh(labelled.mesh.triangles());
        Ok(labelled)
    }
}

/// The number that a corner `v/vt/vn` begins with.
fn vertex_number(corner: &[u8]) -> Result<i64, Problem> {
    let end = corner.iter().position(|&b| b == b'/').unwrap_or(corner.len());
    super::lines::integer(&corner[..end], "a vertex number")
}
