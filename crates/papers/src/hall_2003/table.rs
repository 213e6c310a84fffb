//! The table for people: a row a variant, the paper's speed-up beside ours.

use super::circles::STEP_DEG;
use super::measure::{MeshResult, Reproduction, VariantResult};
use super::printed::model_of;
use crate::Column;
use std::io::{self, Write};

/// The columns behind the variant's name.
pub const COLUMNS: [Column; 8] = [
    Column { title: "paper", unit: "×", meaning: "speed-up over brute force that the paper prints" },
    Column {
        title: "counted",
        unit: "×",
        meaning: "faces of the mesh over faces evaluated in a frame, the same on every machine, over one flight from a \
                  frame found by brute force; methods of today may count a face twice",
    },
    Column { title: "wall", unit: "×", meaning: "Hall's brute force's time over this one's, in the same run" },
    Column { title: "time", unit: "µs", meaning: "median time of a frame" },
    Column { title: "edges", unit: "% missed", meaning: "silhouette edges that were not found" },
    Column { title: "loops", unit: "% missed", meaning: "silhouette loops of which no edge was found" },
    Column { title: "length", unit: "% missed", meaning: "length in space that was not found, hidden parts included" },
    Column {
        title: "visible",
        unit: "% missed",
        meaning: "length in the picture that was not found, of what can be seen",
    },
];

/// The cells of a variant, in the order of [`COLUMNS`]; a dash where there is nothing to tell.
pub fn cells(mesh: &MeshResult, result: &VariantResult) -> [String; 8] {
    let ratio = |value: Option<f64>| value.map_or_else(|| "–".to_owned(), |value| format!("{value:.2}"));
    let printed = model_of(mesh.faces).zip(result.variant.paper_column());
    let missed = |percent: f64| match percent {
        0.0 => "0".to_owned(),
        small if small < 0.005 => "< 0.01".to_owned(),
        _ => format!("{percent:.2}"),
    };
    let time = result.median_us;
    [
        ratio(printed.map(|(model, column)| model.speed_ups[column])),
        ratio(result.counted.speed_up()),
        ratio(Some(result.speed_up)),
        if time < 100.0 { format!("{time:.1}") } else { format!("{time:.0}") },
        missed(result.missed.edges.percent()),
        missed(result.missed.loops.percent()),
        missed(result.missed.length.percent()),
        missed(result.missed_visible),
    ]
}

/// What is to be known of a mesh, in one sentence.
pub fn describe(mesh: &MeshResult) -> String {
    let MeshResult { faces, concave_edges, boundary_edges, half_edges, loops, .. } = mesh;
    format!(
        "{faces} faces, {concave_edges} concave and {boundary_edges} boundary edges; a frame's silhouette has \
         {half_edges:.0} edges in {loops:.1} loops"
    )
}

/// How counts depend on the path, in one sentence, where that was measured.
pub fn counted_ranges(mesh: &MeshResult) -> Option<String> {
    let range = |result: &VariantResult| {
        let [least, greatest] = result.counted_range?;
        Some(format!("{} {least:.2} to {greatest:.2}", result.variant.label()))
    };
    let ranges: Vec<String> = mesh.variants.iter().filter_map(range).collect();
    let ranges = (!ranges.is_empty()).then(|| ranges.join("; "))?;
    Some(format!("The paper does not tell its path; counted over twenty circles: {ranges}"))
}

/// Writes the table of every mesh.
///
/// # Errors
/// Whatever `out` reports.
pub fn write_table(reproduction: &Reproduction, mut out: impl Write) -> io::Result<()> {
    let Reproduction { machine, program, frames, .. } = reproduction;
    writeln!(out, "Hall 2003, Silhouette Tracking: {frames} frames of {STEP_DEG} degrees, one thread")?;
    writeln!(out, "{program}; {machine}")?;
    for mesh in &reproduction.meshes {
        writeln!(out, "\n{}: {}", mesh.name, describe(mesh))?;
        let head = |text: fn(&Column) -> &'static str| COLUMNS.each_ref().map(text);
        write_line(&mut out, "", head(|column| column.title))?;
        write_line(&mut out, "", head(|column| column.unit))?;
        for result in &mesh.variants {
            write_line(&mut out, &result.variant.label(), cells(mesh, result).each_ref().map(String::as_str))?;
        }
        if let Some(ranges) = counted_ranges(mesh) {
            writeln!(out, "{ranges}")?;
        }
    }
    Ok(())
}

fn write_line(out: &mut impl Write, label: &str, cells: [&str; 8]) -> io::Result<()> {
    write!(out, "{label:<28}")?;
    for cell in cells {
        write!(out, " {cell:>9}")?;
    }
    writeln!(out)
}

#[cfg(test)]
mod tests {
    use super::super::measure::tests::reproduction;
    use super::*;

    #[test]
    fn a_line_a_variant_with_a_cell_a_column() {
        let mut out = Vec::new();
        write_table(reproduction(), &mut out).unwrap();
        let text = String::from_utf8(out).unwrap();
        let variants = reproduction().meshes[0].variants.len();
        assert_eq!(text.lines().count(), 2 + 2 * (4 + variants));
        let row = text.lines().find(|line| line.starts_with("brute force (Hall)")).unwrap();
        let cells: Vec<&str> = row["brute force (Hall)".len()..].split_whitespace().collect();
        assert_eq!((cells.len(), cells[0], cells[1], cells[2]), (8, "–", "1.00", "1.00"));
        assert_eq!(cells[4..], ["0"; 4]);
        let length = |line: &str| line.chars().count();
        assert!(text.lines().filter(|line| line.contains("N = ")).all(|line| length(line) == length(row)), "{text}");
    }

    #[test]
    fn ranges_are_told_where_they_were_measured() {
        let mut mesh = reproduction().meshes[0].clone();
        assert_eq!(counted_ranges(&mesh), None);
        mesh.variants[2].counted_range = Some([1.0, 2.5]);
        let told = counted_ranges(&mesh).unwrap();
        assert!(told.ends_with(&format!("circles: {} 1.00 to 2.50", mesh.variants[2].variant.label())), "{told}");
    }

    #[test]
    fn small_shares_are_not_rounded_to_nothing() {
        let mesh = &reproduction().meshes[0];
        let mut result = mesh.variants[0].clone();
        result.missed_visible = 0.001;
        assert_eq!(cells(mesh, &result)[7], "< 0.01");
        result.missed_visible = 12.345;
        assert_eq!(cells(mesh, &result)[7], "12.35");
    }
}
