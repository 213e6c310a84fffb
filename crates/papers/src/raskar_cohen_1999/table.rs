//! The table for people: a row a variant.

use super::measure::{MeshResult, Reproduction, VariantResult};
use super::printed::ROWS;
use super::rows::rate_kept;
use super::variants::VARIANTS;
use crate::Column;
use std::io::{self, Write};

/// The columns behind the variant's name.
pub const COLUMNS: [Column; 10] = [
    Column { title: "width", unit: "px", meaning: "mean width of the drawn lines where they are drawn" },
    Column { title: "deviation", unit: "px", meaning: "standard deviation of that width" },
    Column { title: "ink/length", unit: "px", meaning: "all ink over the length of all visible lines" },
    Column { title: "missed", unit: "%", meaning: "visible length without ink within 1 px" },
    Column { title: "spurious", unit: "%", meaning: "ink farther than 1 px from the true pen" },
    Column { title: "stray", unit: "%", meaning: "ink farther than the pen's width and 1 px from every visible line" },
    Column { title: "gaps", unit: "/1000 px", meaning: "stretches longer than 1 px without ink" },
    Column { title: "through", unit: "%", meaning: "ink farther than 5 px from every silhouette edge, seen or not" },
    Column { title: "farthest", unit: "px", meaning: "distance of the farthest ink from every silhouette edge" },
    Column {
        title: "time", unit: "×", meaning: "median frame time over plain rendering of all faces in the same run"
    },
];

/// The cells of a variant, in the order of [`COLUMNS`]; a dash where there is nothing to tell.
pub fn cells(mesh: &MeshResult, result: &VariantResult) -> [String; 10] {
    let (score, metrics) = (&result.score, &result.score.metrics);
    let at = VARIANTS.iter().position(|variant| *variant == result.variant);
    let time = mesh.times.as_ref().zip(at).map(|(times, at)| times.variants_ms[at] / times.plain_ms);
    [
        format!("{:.2}", metrics.width_mean_px),
        format!("{:.2}", metrics.width_deviation_px),
        format!("{:.2}", score.ink_over_length_px),
        format!("{:.2}", 100.0 * metrics.missed_1px),
        format!("{:.2}", 100.0 * metrics.spurious_1px),
        format!("{:.2}", 100.0 * score.stray),
        format!("{:.2}", metrics.gaps_per_1000px),
        format!("{:.2}", 100.0 * score.bleed),
        format!("{:.0}", score.farthest_px),
        time.map_or_else(|| "–".to_owned(), |time| format!("{time:.2}")),
    ]
}

/// What is to be known of a mesh, in one sentence.
pub fn describe(mesh: &MeshResult) -> String {
    let MeshResult { faces, visible_px, size_px, .. } = mesh;
    format!("{faces} faces, {visible_px:.0} px of visible lines at {size_px} x {size_px}")
}

/// The paper's rows: label, rate kept as printed, and ours where the stand-in was measured.
pub fn printed_rows(reproduction: &Reproduction) -> Vec<(String, f64, Option<f64>)> {
    let ours = |stand_in: &str, label: &str| {
        let mesh = reproduction.meshes.iter().find(|mesh| mesh.name == stand_in)?;
        rate_kept(mesh, label)
    };
    let row = |row: &super::printed::PaperRow| {
        let label = format!("{} ({} triangles), {}", row.model, row.triangles, row.variant);
        (label, row.rate_kept(), ours(row.stand_in, row.variant))
    };
    ROWS.iter().map(row).collect()
}

/// Writes the table of every mesh.
///
/// # Errors
/// Whatever `out` reports.
pub fn write_table(reproduction: &Reproduction, mut out: impl Write) -> io::Result<()> {
    writeln!(out, "Raskar and Cohen 1999, Image precision silhouette edges")?;
    writeln!(out, "{}; {}; {}", reproduction.program, reproduction.machine, reproduction.adapter)?;
    writeln!(out, "\nframe rate over plain rendering: paper, ours")?;
    for (label, paper, ours) in printed_rows(reproduction) {
        writeln!(out, "{label:<40} {paper:>6.3} {}", ours.map_or("–".to_owned(), |ours| format!("{ours:>6.3}")))?;
    }
    for mesh in &reproduction.meshes {
        writeln!(out, "\n{}: {}", mesh.name, describe(mesh))?;
        write_line(&mut out, "", COLUMNS.each_ref().map(|column| column.title))?;
        write_line(&mut out, "", COLUMNS.each_ref().map(|column| column.unit))?;
        for result in mesh.variants.iter().chain(&mesh.shuffled) {
            write_line(&mut out, result.variant.label, cells(mesh, result).each_ref().map(String::as_str))?;
        }
    }
    Ok(())
}

fn write_line(out: &mut impl Write, label: &str, cells: [&str; 10]) -> io::Result<()> {
    write!(out, "{label:<20}")?;
    for cell in cells {
        write!(out, " {cell:>10}")?;
    }
    writeln!(out)
}
