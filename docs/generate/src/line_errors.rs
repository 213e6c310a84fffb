//! What methods miss and draw besides, mesh by mesh, from `line-errors.csv`.

use crate::number::percent;
use crate::results::{ResultError, Sheet};
use std::path::Path;

/// The committed rows.
pub const FILE: &str = "docs/results/2026-11-27-amd-epyc-2-cores/line-errors.csv";

const MESHES: [&str; 6] = ["spot.obj", "fandisk.obj", "hand.off", "suzanne.obj", "teapot.obj", "boeing.off"];

const METHODS: [&str; 6] =
    ["image-precision", "edge-mesh", "inverted-hull", "gbuffer-filter", "jump-flood", "tracking"];

const TRUE: [&str; 3] = ["true_silhouette_px", "true_crease_px", "true_boundary_px"];
const MISSED: [&str; 3] = ["missed_silhouette_px", "missed_crease_px", "missed_boundary_px"];
const SPURIOUS: [&str; 4] =
    ["spurious_silhouette_px", "spurious_crease_px", "spurious_boundary_px", "spurious_nothing_px"];

/// Per method three rows, per mesh a column: shares of the true length, over all scored frames.
///
/// # Errors
/// [`ResultError`].
pub fn table(root: &Path) -> Result<String, ResultError> {
    let sheet = Sheet::read(root.join(FILE))?;
    let stems = MESHES.map(|mesh| mesh.split('.').next().unwrap_or(mesh));
    let mut table = format!("| method | | {} |\n|---|---|{}\n", stems.join(" | "), "---|".repeat(MESHES.len()));
    for method in METHODS {
        let (mut missed, mut of_these, mut spurious) = (Vec::new(), Vec::new(), Vec::new());
        let mut level = "";
        for mesh in MESHES {
            let rows = sheet.rows(mesh, method)?;
            let all = rows.sum(&TRUE)?;
            let share = |columns: &[&str]| rows.sum(columns).map(|length| percent(length / all));
            let (of_all, open, inside) =
                (share(&MISSED)?, share(&["missed_open_boundary_px"])?, share(&["missed_inner_px"])?);
            of_these.push(if of_all == "0" { String::new() } else { format!("{open}; {inside}") });
            missed.push(of_all);
            spurious.push(share(&SPURIOUS)?);
            if method == "tracking" && rows.text("tracking.concavity") == "0.5" {
                level = ", level 0.5";
            }
        }
        table += &format!("| `{method}`{level} | missed, % | {} |\n", missed.join(" | "));
        table += &format!("| | of these open; inside | {} |\n", of_these.join(" | "));
        table += &format!("| | spurious, % | {} |\n", spurious.join(" | "));
    }
    Ok(table)
}
