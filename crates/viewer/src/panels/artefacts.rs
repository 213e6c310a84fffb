//! What was built for the mesh on screen: bytes, time, and who asked.

use eframe::egui;
use silhouette_core::PreparedMesh;

/// Shows a table of what was built, in the order in which it was finished.
pub fn show(ui: &mut egui::Ui, mesh: &PreparedMesh) {
    let report = mesh.report();
    if report.is_empty() {
        ui.label("Nothing yet: the methods on screen need triangles only.");
        return;
    }
    egui::Grid::new("artefacts").num_columns(4).striped(true).show(ui, |ui| {
        for title in ["artefact", "bytes", "ms", "asked for by"] {
            ui.strong(title);
        }
        ui.end_row();
        for artefact in &report {
            ui.label(artefact.name);
            ui.label(in_bytes(artefact.bytes));
            ui.label(format!("{:.1}", artefact.build_time.as_secs_f64() * 1e3));
            ui.label(artefact.asked_by.iter().copied().collect::<Vec<_>>().join(", "));
            ui.end_row();
        }
    });
}

/// Bytes with the largest unit that leaves a whole number.
fn in_bytes(bytes: usize) -> String {
    const UNITS: [(&str, f64); 3] = [("GB", 1e9), ("MB", 1e6), ("kB", 1e3)];
    let bytes = bytes as f64;
    let unit = UNITS.iter().find(|(_, size)| bytes >= *size);
    unit.map_or_else(|| format!("{bytes} B"), |(name, size)| format!("{:.1} {name}", bytes / size))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_have_units() {
        assert_eq!(
            [0, 999, 1000, 1_234_567, 2_000_000_000].map(in_bytes),
            ["0 B", "999 B", "1.0 kB", "1.2 MB", "2.0 GB"]
        );
    }
}
