//! Bytes that nobody wrote: random ones, and good files cut, overwritten and extended, never make a reader panic or
//! take more memory than its bytes could fill.

use crate::expectations::square_rows;
use proptest::prelude::*;
use silhouette_core::NoProgress;
use silhouette_core::load::{Format, read};
use silhouette_testing::mutations::WORDS;

/// Good files of every format and encoding.
pub fn good_files() -> Vec<(Format, Vec<u8>)> {
    let obj = square_rows("v ") + "o a\ns 1\nf 1/1 2/2 -2 \\\n4\ns off\nf 1 2 3\nl 1 -3 4/1\n";
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
        (Format::Gltf, crate::gltf_edges::every_member().glb()),
        (Format::Gltf, crate::gltf_edges::every_member().embedded().into_bytes()),
    ]
}

/// Most bytes of memory for a file of so many: what its densest notation unfolds into, with room for growing arrays.
///
/// A glTF primitive takes about 40 bytes and may name all of a buffer again; other formats are far below.
fn most_memory(bytes: usize) -> u64 {
    64 * 1024 + 48 * (bytes * (1 + bytes / 40)) as u64
}

/// Reads the bytes: into a mesh or a line that names the file, in memory that fits them.
fn check(format: Format, bytes: &[u8]) -> Result<(), TestCaseError> {
    let mut line = None;
    let memory = allocation_counter::measure(|| line = read(format, "fuzzed", bytes, &NoProgress).err());
    let most = most_memory(bytes.len());
    prop_assert!(memory.bytes_max <= most, "{format}: {} bytes of memory for {}", memory.bytes_max, bytes.len());
    if let Some(error) = line {
        let line = error.to_string();
        prop_assert!(line.starts_with("fuzzed") && !line.contains('\n'), "{line:?}");
    }
    Ok(())
}

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

/// Headers that promise four billion of something, on top of a few bytes.
#[test]
fn promises_take_no_memory() {
    let ply = |encoding: &str, element: &str, property: &str| {
        let xyz = "property float x\nproperty float y\nproperty float z\n";
        let elements = format!("element vertex 1\n{xyz}element {element} 4294967295\n{property}end_header\n");
        (Format::Ply, format!("ply\nformat {encoding} 1.0\n{elements}0 0 0\n      3 0 0 0").into_bytes())
    };
    let list = "property list uchar int vertex_indices\n";
    let mut stl = crate::stl::binary(b"", &crate::stl::square());
    stl[80..84].fill(0xff);
    let gltf = crate::gltf::square(5125).embedded();
    let files = [
        (Format::Off, b"OFF\n4294967295 4294967295 0\n0 0 0\n".to_vec()),
        (Format::Off, b"OFF\n1 4294967295 0\n0 0 0\n3 0 0 0\n".to_vec()),
        (Format::Off, b"OFF\n1 1 0\n0 0 0\n4294967295 0 0 0\n".to_vec()),
        ply("ascii", "face", list),
        ply("binary_little_endian", "face", list),
        ply("binary_big_endian", "tristrips", list),
        ply("binary_little_endian", "nothing", ""),
        (Format::Stl, stl),
        (Format::Gltf, gltf.replace(r#""count":4"#, r#""count":4294967295"#).into_bytes()),
        (
            Format::Gltf,
            gltf.replace(r#""bufferView":0,"#, "").replace(r#""count":4"#, r#""count":4294967295"#).into_bytes(),
        ),
    ];
    for (format, bytes) in files {
        assert!(check(format, &bytes).is_ok(), "{format} takes memory on a header's word");
        assert!(read(format, "promise", &bytes, &NoProgress).is_err(), "{format}");
    }
}

#[test]
fn good_files_are_good() {
    for (format, bytes) in good_files() {
        assert!(read(format, "good", &bytes, &NoProgress).is_ok(), "{format}");
    }
}
