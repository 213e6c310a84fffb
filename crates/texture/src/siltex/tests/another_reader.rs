//! The format's description is enough: a reader in another language, of that page alone, finds the same in the same files.

use super::textures::{Form, Recipe, SMALL};
use crate::VolumeSize;
use crate::compression::shares;
use silhouette_core::glam::Vec3;
use silhouette_testing::skipped;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn reader() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/independent/read_siltex.py")
}

fn run(file: &Path) -> Option<Output> {
    let output = Command::new("python3").env("PYTHONIOENCODING", "utf-8").arg(reader()).arg(file).output();
    output.map_err(|error| skipped("another_reader", &format!("python3: {error}"))).ok()
}

fn mean(values: impl ExactSizeIterator<Item = f64>) -> f64 {
    let count = values.len();
    values.sum::<f64>() / count as f64
}

#[test]
fn a_reader_in_another_language_finds_the_same() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.siltex");
    let size = VolumeSize { width: 5, height: 3, azimuths: 7, pages: 2 };
    for form in [Form::Unorm8, Form::Float16, Form::Terms(3)] {
        let recipe = Recipe { vertices: 5, faces: 4, size, form, detail: 2, ..SMALL };
        std::fs::write(&path, recipe.file()).unwrap();
        let Some(output) = run(&path) else { return };
        let found = String::from_utf8(output.stdout).unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));

        let texture = recipe.texture();
        let parts = texture.parts();
        let coordinates: Vec<_> = parts.hull.mesh().positions().iter().flat_map(Vec3::to_array).collect();
        let means = [
            mean(coordinates.iter().map(|&x| x.into())),
            mean(shares(&parts.angles, size).into_iter().map(f64::from)),
            mean(parts.gaps.iter().map(|gap| gap.to_f64())),
            mean(parts.colors.as_flattened().iter().map(|&value| value.into())),
        ];
        let (number, terms) = match form {
            Form::Unorm8 => (0, 0),
            Form::Float16 => (1, 0),
            Form::Terms(terms) => (2, terms),
        };
        let mut lines = found.lines();
        let counts = format!("5 vertices, 4 faces, rule 1, form {number}, {terms} terms, detail 2");
        assert_eq!(lines.next(), Some(counts.as_str()));
        assert_eq!(lines.next(), Some("2 pages of 5 x 3 x 7"));
        let stated = lines.next().unwrap().split([' ', ',']).filter_map(|word| word.parse::<f64>().ok());
        for (stated, mean) in stated.zip(means) {
            assert!((stated - mean).abs() < 2e-6 * mean.abs().max(1.0), "{found}{means:?}");
        }
        assert_eq!(lines.collect::<Vec<_>>(), ["mesh = 'a.obj'", "note = '\u{e9}\\n'"]);
    }

    // It refuses what we refuse.
    let mut bytes = SMALL.file();
    *bytes.last_mut().unwrap() ^= 1;
    std::fs::write(&path, bytes).unwrap();
    let output = run(&path).unwrap();
    assert!(!output.status.success() && String::from_utf8_lossy(&output.stderr).contains("checksum of META"));
}
