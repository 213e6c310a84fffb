//! Times of an extraction over the size of the mesh, from rows of `cargo bench --bench extractors` and of `benches/peers`.

use crate::number::{count, time};
use crate::results::{ResultError, lines};
use serde::Deserialize;
use std::path::Path;

/// The folder of the committed rows.
pub const FOLDER: &str = "docs/results/2026-11-22-amd-epyc-2-cores";

const FILES: [&str; 5] = [
    "extraction-to-300-thousand.jsonl",
    "extraction-a-million.jsonl",
    "extraction-ten-million.jsonl",
    "peers-to-300-thousand.jsonl",
    "peers-a-million-and-more.jsonl",
];

/// Meshes of the table, and what it calls them.
const MESHES: [(&str, &str); 10] = [
    ("fandisk.obj", "fandisk"),
    ("dragon.ply", "dragon"),
    ("stanford-bunny.obj", "bunny"),
    ("armadillo.obj", "armadillo"),
    ("stanford-bunny.obj+loop1", "bunny, subdivided once"),
    ("stanford-bunny.obj+loop2", "bunny, subdivided twice"),
    ("builtin:blob:70000", "blob"),
    ("builtin:blob:300000", "blob"),
    ("builtin:blob:1100000", "blob"),
    ("builtin:blob:10000000", "blob"),
];

/// A row of the files, as far as the table needs it.
#[derive(Debug, Clone, Deserialize)]
struct Row {
    method: String,
    mesh: String,
    faces: u64,
    threads: u32,
    median_ms: f64,
    recall: Option<f64>,
}

/// One row per mesh: medians in milliseconds on one thread.
///
/// # Errors
/// [`ResultError`].
pub fn table(root: &Path) -> Result<String, ResultError> {
    let folder = root.join(FOLDER);
    let mut rows: Vec<Row> = Vec::new();
    for file in FILES {
        rows.extend(lines::<Row>(&folder.join(file))?);
    }
    let mut table =
        "| mesh | faces | VTK | numpy float32, float64 | `brute-force` | `brute-force-simd` | `cluster-cones` | \
                     `randomized` (recall) | plain read |\n"
            .to_owned();
    table += &format!("{}\n", "|---".repeat(9) + "|");
    for (mesh, name) in MESHES {
        let of = |method: &str| rows.iter().find(|row| row.mesh == mesh && row.method == method && row.threads == 1);
        let ours = |method: &str| {
            of(method).ok_or_else(|| ResultError::Missing { file: folder.clone(), row: format!("{method} on {mesh}") })
        };
        let peer = |method: &str| of(method).map(|row| time(row.median_ms));
        let numpy = ["planes-xor-float32", "planes-xor-float64"].map(peer);
        let numpy: Vec<String> = numpy.into_iter().flatten().collect();
        let randomized = ours("randomized")?;
        let recall = randomized.recall.map_or(String::new(), |recall| format!(" ({recall:.2})"));
        let cells = [
            name.to_owned(),
            count(randomized.faces),
            peer("vtkPolyDataSilhouette").unwrap_or_default(),
            numpy.join(", "),
            time(ours("brute-force")?.median_ms),
            time(ours("brute-force-simd")?.median_ms),
            time(ours("cluster-cones")?.median_ms),
            time(randomized.median_ms) + &recall,
            time(ours("face-planes")?.median_ms),
        ];
        table += &format!("| {} |\n", cells.join(" | "));
    }
    Ok(table)
}
