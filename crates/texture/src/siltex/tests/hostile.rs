//! Files made to hurt, with checksums that are right: each is refused for its own reason.

use super::textures::{Form, Recipe, SMALL};
use crate::siltex::format::{ENTRY, Entry, HEADER, SectionType, part};
use crate::siltex::{Place, Problem, SiltexError, fuzz, read_from};
use std::io::Cursor;

/// Where the entry of a section stands.
fn entry_at(bytes: &[u8], kind: [u8; 4]) -> usize {
    (HEADER..).step_by(ENTRY).find(|&at| bytes[at..at + 4] == kind).unwrap()
}

/// Where the bytes of a section begin.
fn section_at(bytes: &[u8], kind: [u8; 4]) -> usize {
    Entry::take(&part(bytes, entry_at(bytes, kind))).offset as usize
}

fn put<const N: usize>(bytes: &mut [u8], at: usize, value: [u8; N]) {
    bytes[at..at + N].copy_from_slice(&value);
}

/// Appends a section, moves the others by the new entry, and states the new length.
pub fn add_section(bytes: &mut Vec<u8>, kind: [u8; 4], flags: u32, content: &[u8]) {
    let count = u32::from_le_bytes(part(bytes, 12));
    let table_end = HEADER + count as usize * ENTRY;
    for at in (HEADER..table_end).step_by(ENTRY) {
        let offset = u64::from_le_bytes(part(bytes, at + 8)) + ENTRY as u64;
        put(bytes, at + 8, offset.to_le_bytes());
    }
    let (offset, length) = ((bytes.len() + ENTRY) as u64, content.len() as u64);
    let mut entry = Vec::new();
    Entry { kind: SectionType(kind), flags, offset, length, checksum: 0, reserved: 0 }.put(&mut entry);
    bytes.splice(table_end..table_end, entry);
    bytes.extend(content);
    bytes.resize(bytes.len().next_multiple_of(8), 0);
    put(bytes, 12, (count + 1).to_le_bytes());
    let length = bytes.len() as u64;
    put(bytes, 16, length.to_le_bytes());
}

/// Reads a small file after `change`, with its checksums set right.
fn after(recipe: Recipe, change: impl Fn(&mut Vec<u8>)) -> SiltexError {
    let mut bytes = recipe.file();
    change(&mut bytes);
    fuzz::read_repaired(&bytes).map(|_| "a texture").unwrap_err()
}

#[test]
fn a_future_major_version_is_named() {
    let error = after(SMALL, |bytes| bytes[8] = 2);
    assert!(matches!(error.problem, Problem::Version { major: 2, minor: 0 }));
    assert_eq!(
        error.to_string(),
        "header: the file has version 2.0 of the format, and this build reads version 1; update it, or bake the texture again"
    );
    // Whatever else that version changes, even the checksum.
    let mut bytes = SMALL.file();
    bytes[8] = 2;
    bytes.truncate(40);
    assert!(matches!(read_from(Cursor::new(&bytes)).unwrap_err().problem, Problem::Version { .. }));
}

#[test]
fn tables_that_lie_are_refused() {
    let required = after(SMALL, |bytes| add_section(bytes, *b"NEW!", 1, &[1]));
    assert!(matches!(required.problem, Problem::Unknown(SectionType([b'N', ..]))));
    let twice = after(SMALL, |bytes| add_section(bytes, *b"GAPS", 1, &[0; 4]));
    assert!(matches!(twice.problem, Problem::Duplicate(SectionType::GAPS)));
    let flags = after(SMALL, |bytes| add_section(bytes, *b"NEW!", 2, &[1]));
    assert!(matches!(flags.problem, Problem::Reserved));
    let many = after(SMALL, |bytes| put(bytes, 12, u32::MAX.to_le_bytes()));
    assert!(matches!(many.problem, Problem::SectionCount { found: u32::MAX }));
    let beyond = after(SMALL, |bytes| put(bytes, 12, 200_u32.to_le_bytes()));
    assert!(matches!(beyond.problem, Problem::FileLength { .. }));

    // Overlapping, beyond the end, beyond 64 bits.
    for (field, value) in [(8, 0), (8, 64), (8, u64::MAX), (16, u64::MAX), (16, u64::MAX - 400), (16, 1 << 40)] {
        let error = after(SMALL, |bytes| {
            let at = entry_at(bytes, *b"CENT");
            put(bytes, at + field, value.to_le_bytes());
        });
        assert!(matches!(error.problem, Problem::Misplaced { kind: SectionType::CENTERS, .. }), "{error}");
    }
    for kind in SectionType::KNOWN {
        // Renamed to an optional section that nobody knows.
        let mut bytes = SMALL.file();
        let at = entry_at(&bytes, kind.0);
        put(&mut bytes, at, *b"NEW!\0\0\0\0");
        match fuzz::read_repaired(&bytes) {
            Ok(_) => assert!(kind.may_be_missing()),
            Err(error) => {
                assert!(matches!(error.problem, Problem::NoSection), "{error}");
                assert_eq!(error.place, Place::Section(kind));
            }
        }
    }
}

#[test]
fn sizes_that_lie_are_refused_without_memory() {
    // width, height, azimuths, pages, detail, vertices, faces, rule, form, terms.
    for value in 0..10 {
        // 0 is a visibility rule.
        for lie in [if value == 7 { 2 } else { 0 }, 5, 16_000, u32::MAX] {
            let mut bytes = SMALL.file();
            let at = section_at(&bytes, *b"SIZE") + 4 * value;
            put(&mut bytes, at, lie.to_le_bytes());
            let memory = allocation_counter::measure(|| {
                let error = fuzz::read_repaired(&bytes).map(|_| (value, lie)).unwrap_err();
                let expected =
                    matches!(error.problem, Problem::SectionLength { .. } | Problem::Size(_) | Problem::Range { .. });
                assert!(expected, "value {value} = {lie}: {error}");
            });
            assert!(memory.bytes_max < 1 << 18, "value {value} = {lie}: {} bytes", memory.bytes_max);
        }
    }
    let all_largest = after(SMALL, |bytes| {
        let at = section_at(bytes, *b"SIZE");
        for (value, size) in [16_384_u32, 16_384, 31, 1, 4096, u32::MAX, u32::MAX].into_iter().enumerate() {
            put(bytes, at + 4 * value, size.to_le_bytes());
        }
    });
    assert!(matches!(all_largest.problem, Problem::SectionLength { .. }), "{all_largest}");
}

#[test]
fn values_that_no_bake_yields_are_refused() {
    let halves = Recipe { form: Form::Float16, ..SMALL };
    let nan = f32::NAN.to_le_bytes();
    for (recipe, kind, offset, value, expected) in [
        (SMALL, *b"POSI", 4, nan, "vertex 0 has a coordinate that is not a finite 32-bit float"),
        (
            SMALL,
            *b"TRIA",
            4,
            3_u32.to_le_bytes(),
            "face 0 names vertex 3, but there are only 3 vertices (0 is the first)",
        ),
        (SMALL, *b"CENT", 12, nan, "centre 1 is not a unit vector"),
        (SMALL, *b"CENT", 12, 9_f32.to_le_bytes(), "centre 1 is not a unit vector"),
        (SMALL, *b"TANG", 24, f32::INFINITY.to_le_bytes(), "tangent 2 is not a unit vector"),
        (SMALL, *b"PLAC", 0, 1_u32.to_le_bytes(), "place 0 is not on a page of the atlas"),
        (SMALL, *b"PLAC", 8, 1.5_f32.to_le_bytes(), "place 0 is not on a page of the atlas"),
        (SMALL, *b"PLAC", 8, nan, "place 0 is not on a page of the atlas"),
        (SMALL, *b"ANGL", 8, nan, "value of a function 2 is not finite"),
        (SMALL, *b"ANGL", 24, nan, "offset of term 0 is not finite"),
        (SMALL, *b"ANGL", 36, nan, "scale of term 1 is not finite"),
        (halves, *b"ANGL", 0, [0, 0x3c, 1, 0x3c], "angle 1 is not from 0 to 1"),
        (halves, *b"ANGL", 0, [0, 0x80, 0, 0x7e], "angle 1 is not from 0 to 1"),
        (SMALL, *b"TCEN", 8, [0, 0x7e, 0, 0], "centre of texel 1 is not finite"),
        (SMALL, *b"GAPS", 0, [0, 0, 0, 0x7c], "gap 1 is not a finite distance"),
        (SMALL, *b"GAPS", 0, [0, 0xbc, 0, 0], "gap 0 is not a finite distance"),
        (SMALL, *b"NORM", 8, [0, 0, 0, 0x7c], "normal 1 is not finite"),
        (SMALL, *b"META", 0, u32::MAX.to_le_bytes(), "a text ends beyond its section"),
        (SMALL, *b"META", 4, [0xff; 4], "a text is not UTF-8"),
        (SMALL, *b"META", 4, *b"zzzz", "keys are not in ascending order"),
    ] {
        let error = after(recipe, |bytes| {
            let at = section_at(bytes, kind) + offset;
            put(bytes, at, value);
        });
        let text = error.to_string();
        assert!(text.contains(expected) && text.ends_with("bake the texture again"), "{text}");
    }
}
