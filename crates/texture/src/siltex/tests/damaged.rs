//! Files cut short, files with wrong bytes: refused in one line, with no more memory than a multiple of their length.

use super::textures::{Form, Recipe, SMALL, recipes, same_bits};
use crate::VolumeSize;
use crate::siltex::{Problem, fuzz, read_from};
use proptest::prelude::*;
use silhouette_testing::Random;
use std::io::Cursor;

/// Bytes that reading may hold at once: buffers of constant size, and a small multiple of the file.
fn allowed(file: usize) -> u64 {
    (1 << 17) + 8 * file as u64
}

/// Memory that reading holds at once, at most.
fn held(bytes: &[u8]) -> u64 {
    allocation_counter::measure(|| drop(read_from(Cursor::new(bytes)))).bytes_max
}

#[test]
fn every_wrong_byte_is_found() {
    let bytes = SMALL.file();
    assert!(fuzz::read(&bytes).is_ok());
    for at in 0..bytes.len() {
        for flip in [1, 0x10, 0x80, 0xff] {
            let mut wrong = bytes.clone();
            wrong[at] ^= flip;
            assert!(fuzz::read(&wrong).is_err(), "byte {at} with {flip:#x} flipped");
            assert!(held(&wrong) <= allowed(wrong.len()), "byte {at}");
        }
    }
}

#[test]
fn every_file_cut_short_is_refused_and_so_is_a_longer_one() {
    let bytes = SMALL.file();
    for length in 0..bytes.len() {
        let error = fuzz::read(&bytes[..length]).unwrap_err();
        let expected = if length < 8 {
            matches!(error.problem, Problem::NoSignature)
        } else {
            matches!(error.problem, Problem::FileLength { .. })
        };
        assert!(expected, "{length} bytes: {error}");
        // The same with a header that agrees.
        let mut shorter = bytes[..length].to_vec();
        if length >= 24 {
            shorter[16..24].copy_from_slice(&(length as u64).to_le_bytes());
        }
        assert!(fuzz::read_repaired(&shorter).is_err(), "{length} bytes");
        assert!(held(&shorter) <= allowed(length));
    }
    assert!(fuzz::read(&[&bytes[..], b"\0"].concat()).is_err());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    /// With the checksums set right, a mutated file may be another texture, never a panic.
    #[test]
    fn mutated_files_are_refused_or_read(recipe in recipes(), seed: u64, mutations in 1_usize..6) {
        let original = recipe.file();
        let mut bytes = original.clone();
        let mut random = Random::new(seed);
        for _ in 0..mutations {
            mutate(&mut bytes, &mut random);
        }
        if let Ok(file) = fuzz::read(&bytes) {
            prop_assert!(same_bits(&file.texture, &recipe.texture()), "damage went unnoticed");
        }
        prop_assert!(held(&bytes) <= allowed(bytes.len()));
        let _ = fuzz::read_repaired(&bytes);
    }
}

/// One change of the kinds that break readers.
fn mutate(bytes: &mut Vec<u8>, random: &mut Random) {
    if bytes.is_empty() {
        return;
    }
    let at = random.below(bytes.len());
    let word = at & !3;
    match random.below(7) {
        0 => bytes[at] ^= 1 << random.below(8),
        1 => bytes[at] = random.bits() as u8,
        2 => bytes.truncate(at),
        3 => drop(bytes.splice(at..at, [0; 4])),
        4 if word + 4 <= bytes.len() => {
            let values = [0, 1, 7, 0x7fff_ffff, 0x8000_0000, u32::MAX, 0x7fc0_0000, 0x7f80_0000];
            bytes[word..word + 4].copy_from_slice(&values[random.below(values.len())].to_le_bytes());
        }
        5 => {
            let from = random.below(bytes.len());
            let length = random.below(64).min(bytes.len() - at.max(from));
            bytes.copy_within(from..from + length, at);
        }
        _ => {
            // In header and table.
            let at = random.below(bytes.len().min(32 * 13));
            bytes[at] = random.bits() as u8;
        }
    }
}

/// Most mutations would stop at the first check; these reach every kind of problem that bytes can cause.
#[test]
fn mutations_reach_the_checks_behind_the_checksums() {
    let mut random = Random::new(3);
    let mut seen = std::collections::BTreeMap::new();
    for round in 0..20_000 {
        let mut bytes = Recipe { seed: round, form: Form::Float16, ..SMALL }.file();
        mutate(&mut bytes, &mut random);
        let outcome = match fuzz::read_repaired(&bytes) {
            Ok(_) => "read",
            Err(error) => match error.problem {
                Problem::NoSignature => "signature",
                Problem::Version { .. } => "version",
                Problem::FileLength { .. } => "file length",
                Problem::SectionCount { .. } => "section count",
                Problem::Misplaced { .. } => "misplaced",
                Problem::Unknown(_) => "unknown",
                Problem::Reserved => "reserved",
                Problem::SectionLength { .. } => "section length",
                Problem::Size(_) => "size",
                Problem::Range { .. } => "range",
                Problem::Hull(_) => "hull",
                Problem::Value { .. } => "value",
                Problem::Metadata(_) => "metadata",
                _ => "another",
            },
        };
        *seen.entry(outcome).or_insert(0) += 1;
    }
    assert!(seen.len() >= 14, "{seen:?}");
}

/// The bound is no accident of small files: what is held grows with what is read, and with nothing else.
#[test]
fn memory_follows_the_file() {
    let size = VolumeSize { width: 128, height: 64, azimuths: 16, pages: 1 };
    let bytes = Recipe { size, form: Form::Unorm8, ..SMALL }.file();
    let held = held(&bytes);
    let length = bytes.len() as u64;
    assert!(held >= length / 2 && held <= length + (1 << 17) + (1 << 14), "{held} of {length}");
}
