//! Good files of OBJ, PLY, OFF and STL, changed in ways in which files go bad: each is read, or refused in one line, within
//! memory that grows with its length.

use crate::robustness::good_files;
use silhouette_core::NoProgress;
use silhouette_core::load::{Format, read};
use silhouette_testing::mutations::mutate;
use silhouette_testing::random::Random;
use std::io::Write as _;
use std::time::{Duration, Instant};

/// Changed files per format; the variable `SILHOUETTES_MUTATIONS` overrides this.
const USUAL: usize = 4000;

/// Most bytes of memory: for each byte of a file, what a corner of a polygon takes that is cut into triangles, spelt in two
/// bytes, in arrays that have just grown; and what a reader takes at any rate.
fn most_memory(bytes: usize) -> u64 {
    4096 + 256 * bytes as u64
}

/// Files with polygons that are concave, cross themselves or have too few corners, on one line where that is allowed.
fn more_files() -> Vec<(Format, Vec<u8>)> {
    let rows: String = (0..12).map(|i| format!("{} {} {}\n", i * 7 % 5, i * i % 11, i % 3)).collect();
    let obj: String = rows.lines().map(|row| format!("v {row}\n")).collect();
    let obj = obj + "g a\nf 1 2 3 4 5 6 7 8 9 10 11 12\nf 1 1\ns 3\nf 12/1 10/2 8/3 6/4 -8 2\nf 3\n";
    let faces = "12 0 1 2 3 4 5 6 7 8 9 10 11\n5 4 3 9 1 11\n2 1 2\n";
    let off = format!("OFF12 3 0\n{rows}{faces}");
    let ply = "ply\nformat ascii 1.0\nelement vertex 12\nproperty double x\nproperty int64 y\nproperty uint8 z\nelement face 3\n\
               property list uint64 int64 vertex_indices\nend_header\n"
        .to_owned();
    let stl = "solid a facet normal 0 0 1 outer loop vertex 0 0 0 vertex 4 4 0 vertex 0 2 0 vertex -4 4 0 end loop endfacet\n\
               facet outer loop vertex 1 0 0 vertex 1 1 0 endloop endfacet endsolida solid b endsolid";
    let comb: String = (0..150).map(|i| format!("v {} {} 0\n", i, i % 2 * 90)).collect();
    let comb = comb + "v 75 -9 1\nf" + &(1..=151).map(|corner| format!(" {corner}")).collect::<String>();
    vec![
        (Format::Obj, obj.into_bytes()),
        (Format::Obj, comb.into_bytes()),
        (Format::Off, off.replace('\n', " ").into_bytes()),
        (Format::Off, off.into_bytes()),
        (Format::Ply, (ply.clone() + &(rows.clone() + faces).replace('\n', " ")).into_bytes()),
        (Format::Ply, (ply + &rows + faces).replace('\n', "\r").into_bytes()),
        (Format::Stl, stl.as_bytes().to_vec()),
    ]
}

#[test]
fn mutated_files_are_read_or_refused() {
    let count = std::env::var("SILHOUETTES_MUTATIONS").ok().and_then(|count| count.parse().ok()).unwrap_or(USUAL);
    let files: Vec<(Format, Vec<u8>)> = good_files().into_iter().chain(more_files()).collect();
    for format in [Format::Obj, Format::Off, Format::Ply, Format::Stl] {
        let good: Vec<&Vec<u8>> = files.iter().filter(|file| file.0 == format).map(|file| &file.1).collect();
        let mut random = Random::new(format as u64);
        let (mut accepted, mut slowest, mut most) = (0, Duration::ZERO, 0.0_f64);
        for seed in 0..count {
            let mut bytes = good[seed % good.len()].clone();
            for _ in 0..=random.below(4) {
                mutate(&mut bytes, &mut random);
            }
            let start = Instant::now();
            let mut result = None;
            let memory = allocation_counter::measure(|| result = Some(read(format, "mutated", &bytes, &NoProgress)));
            slowest = slowest.max(start.elapsed());
            most = most.max(memory.bytes_max as f64 / most_memory(bytes.len()) as f64);
            assert!(most <= 1.0, "{format}: {} bytes of memory for {bytes:?}", memory.bytes_max);
            match result.unwrap() {
                Ok(_) => accepted += 1,
                Err(error) => {
                    let line = error.to_string();
                    assert!(line.starts_with("mutated") && !line.contains('\n'), "{format}: {line:?} for {bytes:?}");
                }
            }
        }
        // Both happen, or the changes are too many or too few.
        assert!(accepted > count / 50 && accepted < count - count / 50, "{format}: {accepted} of {count} are read");
        let mut stderr = std::io::stderr();
        writeln!(
            stderr,
            "{format}: {count} files, {accepted} read, slowest {slowest:?}, most memory {:.0} % of the bound",
            100.0 * most
        )
        .unwrap();
    }
}
