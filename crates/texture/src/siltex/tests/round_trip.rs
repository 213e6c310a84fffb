//! What is written is read again, bit for bit.

use super::textures::{Recipe, SMALL, file_of, recipes, same_bits};
use crate::siltex::format::{ENTRY, HEADER};
use crate::siltex::{Metadata, Problem, fuzz, read, read_from, write, write_to};
use crate::{Angles, SilhouetteTexture, VolumeSize};
use proptest::prelude::*;
use silhouette_core::NoProgress;
use std::io::Cursor;

proptest! {
    #[test]
    fn a_texture_is_read_as_it_was_written(
        recipe in recipes(),
        metadata in prop::collection::btree_map(".{1,8}", ".{0,20}", 0..4),
    ) {
        let texture = recipe.texture();
        let bytes = file_of(&texture, &metadata);
        let file = fuzz::read(&bytes).unwrap();
        prop_assert!(same_bits(&file.texture, &texture));
        prop_assert_eq!(&file.metadata, &metadata);
        prop_assert_eq!(file_of(&file.texture, &file.metadata), bytes);
        // The comparison can fail.
        let other = Recipe { seed: recipe.seed ^ 1, ..recipe }.texture();
        prop_assert!(!same_bits(&file.texture, &other));
    }
}

#[test]
fn a_path_holds_what_was_written() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("small.siltex");
    for recipe in [SMALL, Recipe { seed: 2, ..SMALL }] {
        write(&path, &recipe.texture(), &Metadata::new(), &NoProgress).unwrap();
        let file = read(&path).unwrap();
        assert!(same_bits(&file.texture, &recipe.texture()) && file.metadata.is_empty());
        assert_eq!(folder.path().read_dir().unwrap().count(), 1);
    }
}

/// The size of a file is the size of its arrays and a table: nothing is stored twice.
#[test]
fn a_file_is_as_long_as_its_arrays() {
    let size = VolumeSize { width: 32, height: 32, azimuths: 64, pages: 1 };
    let recipe = Recipe { size, form: super::textures::Form::Unorm8, ..SMALL };
    let arrays = 3 * 12 * 3 + 12 + 28 + 32 * 32 * (64 + 8 + 2 + 4 + 8);
    let length = file_of(&recipe.texture(), &Metadata::new()).len();
    assert!((arrays..arrays + HEADER + 12 * (ENTRY + 8) + 40).contains(&length), "{length}");
}

#[test]
fn what_could_not_be_read_is_not_written() {
    let refused = |change: &dyn Fn(&mut crate::Parts)| {
        let mut parts = SMALL.texture().into_parts();
        change(&mut parts);
        let texture = SilhouetteTexture::new(parts).unwrap();
        write_to(&mut Vec::new(), &texture, &Metadata::new(), &NoProgress).unwrap_err().problem
    };
    assert!(matches!(refused(&|parts| parts.centers[1].x = f32::NAN), Problem::Value { index: 1, .. }));
    assert!(matches!(refused(&|parts| parts.places[0].page = 1), Problem::Value { index: 0, .. }));
    let no_terms = |parts: &mut crate::Parts| {
        if let Angles::Terms(terms) = &mut parts.angles {
            (terms.functions, terms.weights) = (Vec::new(), Vec::new());
            (terms.offsets, terms.scales) = (Vec::new(), Vec::new());
        }
    };
    assert!(matches!(refused(&no_terms), Problem::Range { found: 0, .. }));
    let metadata = Metadata::from([(String::new(), "no key".into())]);
    let error = write_to(&mut Vec::new(), &SMALL.texture(), &metadata, &NoProgress).unwrap_err();
    assert!(matches!(error.problem, Problem::Metadata(_)));
}

/// Readers of today skip what minor versions of tomorrow add.
#[test]
fn an_optional_section_of_a_later_minor_version_is_skipped() {
    let mut bytes = SMALL.file();
    super::hostile::add_section(&mut bytes, *b"NEW!", 0, &[1, 2, 3]);
    bytes[10] = 7;
    let file = fuzz::read_repaired(&bytes).unwrap();
    assert!(same_bits(&file.texture, &SMALL.texture()));
    assert!(read_from(Cursor::new(SMALL.file())).is_ok());
}
