//! [`Parts`]: what a file calls the parts of a mesh.

use super::lines::Words;
use crate::id::FaceId;
use std::collections::HashMap;
use std::sync::Arc;

/// A part of a mesh.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Part {
    /// Its names: OBJ's `g` may give several, and a node of glTF may have none.
    pub names: Arc<[String]>,
    /// The part that it belongs to, by its index: a group's object, a node's parent.
    pub parent: Option<u32>,
}

/// The named parts of a mesh: objects and groups of OBJ (`o` and `g`), nodes of glTF, which go by their mesh's name where they have
/// none.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Parts {
    parts: Vec<Part>,
    /// The part of each face, or [`NO_PART`].
    of_face: Vec<u32>,
}

/// The face belongs to no part.
pub(super) const NO_PART: u32 = u32::MAX;

impl Parts {
    pub(super) fn new(parts: Vec<Part>, of_face: Vec<u32>) -> Self {
        Self { parts, of_face }
    }

    /// The parts, parents before what belongs to them.
    pub fn as_slice(&self) -> &[Part] {
        &self.parts
    }

    /// The part that a face belongs to, by its index.
    ///
    /// # Panics
    /// If the mesh has no such face.
    pub fn of(&self, face: FaceId) -> Option<u32> {
        Some(self.of_face[face.index()]).filter(|&part| part != NO_PART)
    }

    /// The parts of another mesh, each of whose faces is one of this mesh, or a piece of it. O(faces).
    ///
    /// # Panics
    /// If the mesh has no such face.
    #[must_use]
    pub fn of_faces(&self, faces: impl IntoIterator<Item = FaceId>) -> Self {
        let of_face = faces.into_iter().map(|face| self.of_face[face.index()]).collect();
        Self { parts: self.parts.clone(), of_face }
    }

    /// For each part whether it, or one that it belongs to, has a name for which `is_named` holds. O(names).
    pub fn named(&self, is_named: impl Fn(&Part) -> bool) -> Vec<bool> {
        let mut named: Vec<bool> = Vec::with_capacity(self.parts.len());
        for part in &self.parts {
            named.push(is_named(part) || part.parent.is_some_and(|parent| named[parent as usize]));
        }
        named
    }
}

/// Follows the rows `o` and `g` of an OBJ file.
#[derive(Default)]
pub(super) struct PartRows {
    /// Objects and sets of groups named so far.
    levels: [Level; 2],
    has_changed: bool,
    /// The part of each pair of an object and a set of groups that a face had.
    known: HashMap<[u32; 2], u32>,
    pub(super) parts: Vec<Part>,
}

/// Names of one kind of row.
#[derive(Default)]
struct Level {
    /// Which one holds for the faces to come, counted from 1; 0 for none.
    current: u32,
    numbers: HashMap<Vec<u8>, u32>,
    names: Vec<Arc<[String]>>,
}

impl PartRows {
    /// An `o` row: the rest of it is one name.
    pub(super) fn object(&mut self, words: Words<'_>) {
        let words = words_of(words);
        let name = words.join(&b' ');
        self.begin(0, &name, || [String::from_utf8_lossy(&name).into_owned()].into());
    }

    /// A `g` row: each word is a name, and `default` stands for none.
    pub(super) fn groups(&mut self, words: Words<'_>) {
        let mut words = words_of(words);
        words.retain(|&word| word != b"default");
        let name = words.join(&b' ');
        self.begin(1, &name, || words.iter().map(|word| String::from_utf8_lossy(word).into_owned()).collect());
    }

    fn begin(&mut self, level: usize, name: &[u8], names: impl FnOnce() -> Arc<[String]>) {
        self.has_changed = true;
        let level = &mut self.levels[level];
        level.current = match level.numbers.get(name) {
            _ if name.is_empty() => 0,
            Some(&number) => number,
            None => {
                level.names.push(names());
                let number = level.names.len() as u32;
                level.numbers.insert(name.to_vec(), number);
                number
            }
        };
    }

    /// The part of the next face, or [`NO_PART`], if it may be another than that of the last.
    pub(super) fn changed_part(&mut self) -> Option<u32> {
        if !std::mem::replace(&mut self.has_changed, false) {
            return None;
        }
        let [object, groups] = [0, 1].map(|level| self.levels[level].current);
        let parent = if object > 0 { Some(self.part([object, 0], None)) } else { None };
        if groups > 0 { Some(self.part([object, groups], parent)) } else { parent.or(Some(NO_PART)) }
    }

    fn part(&mut self, key: [u32; 2], parent: Option<u32>) -> u32 {
        let next = self.parts.len() as u32;
        let part = *self.known.entry(key).or_insert(next);
        if part == next {
            let level = usize::from(key[1] > 0);
            self.parts.push(Part { names: Arc::clone(&self.levels[level].names[key[level] as usize - 1]), parent });
        }
        part
    }
}

/// The words of a row up to a comment.
pub(super) fn words_of(mut words: Words<'_>) -> Vec<&[u8]> {
    let mut of_row = Vec::new();
    while !words.is_empty() {
        let word = words.word();
        if word.starts_with(b"#") {
            break;
        }
        of_row.push(word);
    }
    of_row
}
