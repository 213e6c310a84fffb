//! How steadily pictures follow a path, from `coherence-512.csv`.

use crate::number::{one_decimal, percent};
use crate::results::{ResultError, Rows, Sheet};
use std::path::Path;

/// The committed rows.
pub const FILE: &str = "docs/results/2026-11-27-amd-epyc-2-cores/coherence-512.csv";

const MESHES: [(&str, &str); 3] =
    [("spot.obj", "spot"), ("stanford-bunny.obj", "bunny"), ("builtin:blob:20000", "blob")];

const METHODS: [&str; 7] =
    ["brute-force-simd", "tracking", "image-precision", "jump-flood", "texture-lines", "texture", "smoothing"];

const MOTIONS: [&str; 4] = ["orbit", "dolly", "jitter", "wave"];

/// One row per mesh and method.
///
/// # Errors
/// [`ResultError`].
pub fn table(root: &Path) -> Result<String, ResultError> {
    let sheet = Sheet::read(root.join(FILE))?;
    let mut table =
        "| mesh | method | movement p99; max, rpx: orbit | dolly | jitter | wave | flicker, % | dropouts, % | \
                     loops lost, %: orbit | dolly | jitter | wave |\n"
            .to_owned();
    table += &format!("{}\n", "|---".repeat(12) + "|");
    for (mesh, name) in MESHES {
        for method in METHODS {
            let rows = sheet.rows(mesh, method)?;
            let mut cells = vec![name.to_owned(), called(method, &rows)];
            for motion in MOTIONS {
                cells.push(movement(&rows, motion)?);
            }
            for what in ["flicker", "dropouts"] {
                cells.push(worst(&rows, what)?);
            }
            for motion in MOTIONS {
                let lost = rows.first(&format!("{motion}_loops_lost"))?;
                cells.push(lost.map_or("–".to_owned(), percent));
            }
            table += &format!("| {} |\n", cells.join(" | "));
        }
    }
    Ok(table)
}

fn called(method: &str, rows: &Rows<'_>) -> String {
    let filled = if rows.text("picture") == "fill" { " (filled)" } else { "" };
    let level = if rows.text("tracking.concavity") == "0.5" { ", level 0.5" } else { "" };
    format!("`{method}`{level}{filled}")
}

fn movement(rows: &Rows<'_>, motion: &str) -> Result<String, ResultError> {
    let [p99, most] = ["p99", "max"].map(|what| rows.first(&format!("{motion}_movement_{what}_rpx")));
    Ok(match (p99?, most?) {
        (Some(p99), Some(most)) => format!("{}; {}", one_decimal(p99), one_decimal(most)),
        _ => "cannot follow".to_owned(),
    })
}

/// The worst motion's share in per cent; `0` is none at all.
fn worst(rows: &Rows<'_>, what: &str) -> Result<String, ResultError> {
    let mut worst: f64 = 0.0;
    for motion in MOTIONS {
        worst = worst.max(rows.first(&format!("{motion}_{what}"))?.unwrap_or(0.0));
    }
    Ok(if worst == 0.0 { "0".to_owned() } else { format!("{:.2}", 100.0 * worst) })
}
