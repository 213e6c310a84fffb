//! Bytes that nobody wrote: random ones, and good files cut, overwritten and extended, never make a reader panic or
//! yield a mesh that is larger than its bytes could describe.

use crate::common::square_rows;
use proptest::prelude::*;
use silhouette_core::NoProgress;
use silhouette_core::load::{Format, read};

/// Good files of every format and encoding.
fn good_files() -> Vec<(Format, Vec<u8>)> {
    let obj = square_rows("v ") + "o a\nf 1/1 2/2 -2 \\\n4\nf 1 2 3\n";
    let off = "OFF\n4 2 0\n".to_owned() + &square_rows("") + "4 0 1 2 3\n3 0 1 2\n";
    let ply = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n\
               element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
        .to_owned();
    let ply = ply + &square_rows("") + "8 0 1 2 3 -1 0 2 3\n";
    vec![
        (Format::Obj, obj.into_bytes()),
        (Format::Off, off.into_bytes()),
        (Format::Ply, ply.into_bytes()),
        (Format::Ply, crate::ply::binary("binary_little_endian")),
        (Format::Ply, crate::ply::binary("binary_big_endian")),
        (Format::Stl, crate::stl::binary(b"solid?", &crate::stl::square())),
        (Format::Stl, crate::stl::text(&crate::stl::square()).into_bytes()),
        (Format::Gltf, crate::gltf::square(5123).glb()),
        (Format::Gltf, crate::gltf::square(5121).embedded().into_bytes()),
    ]
}

/// Reads the bytes; the mesh, if there is one, is no larger than the format's densest notation allows.
fn check(format: Format, bytes: &[u8]) -> Result<(), TestCaseError> {
    // A glTF primitive takes about 40 bytes and may name all of a buffer again; the rest is much below.
    let most = 12 * bytes.len() * (1 + bytes.len() / 40);
    match read(format, "fuzzed", bytes, &NoProgress) {
        Ok(mesh) => prop_assert!(mesh.bytes() <= most, "{format}: {} bytes from {}", mesh.bytes(), bytes.len()),
        Err(error) => {
            let line = error.to_string();
            prop_assert!(line.starts_with("fuzzed") && !line.contains('\n'), "{line:?}");
        }
    }
    Ok(())
}

/// Words that sit where readers make decisions: huge, negative, odd, missing.
const WORDS: [&str; 14] = [
    "4294967295",
    "-1",
    "0",
    "99999999999999999999",
    "nan",
    "1e39",
    " ",
    "\n",
    "\\\n",
    "#",
    "list",
    "/",
    "\0",
    "\u{ff}",
];

proptest! {
    #![proptest_config(ProptestConfig { cases: 512, ..ProptestConfig::default() })]

    #[test]
    fn random_bytes_never_panic(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
        for (format, good) in good_files() {
            check(format, &bytes)?;
            // Behind a good beginning, random bytes get further.
            check(format, &[&good[..good.len() / 2], &bytes].concat())?;
        }
    }

    #[test]
    fn cut_files_never_panic(share in 0.0..1.0_f64) {
        for (format, good) in good_files() {
            check(format, &good[..(good.len() as f64 * share) as usize])?;
        }
    }

    #[test]
    fn overwritten_files_never_panic(edits in prop::collection::vec((0.0..1.0_f64, any::<u8>()), 1..8)) {
        for (format, mut bytes) in good_files() {
            for &(share, value) in &edits {
                let at = (bytes.len() as f64 * share) as usize;
                bytes[at] = value;
            }
            check(format, &bytes)?;
        }
    }

    #[test]
    fn respelt_files_never_panic(edits in prop::collection::vec((0.0..1.0_f64, 0..WORDS.len(), 0..3_usize), 1..4)) {
        for (format, mut bytes) in good_files() {
            for &(share, word, dropped) in &edits {
                let at = (bytes.len() as f64 * share) as usize;
                let end = (at + dropped).min(bytes.len());
                bytes.splice(at..end, WORDS[word].bytes());
            }
            check(format, &bytes)?;
        }
    }
}

#[test]
fn good_files_are_good() {
    for (format, bytes) in good_files() {
        assert!(read(format, "good", &bytes, &NoProgress).is_ok(), "{format}");
    }
}
