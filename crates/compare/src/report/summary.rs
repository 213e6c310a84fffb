//! Cells of a mesh, with what is derived from them for people.

use crate::cost::Spread;
use crate::metrics::PictureKind;
use crate::metrics::table::PictureMetrics;
use crate::options::OptionSettings;
use crate::record::label::{distinguishing_options, label};
use crate::record::{Cell, MeshRecord};
use crate::registry;

/// A mesh with its cells of one run: times of different machines are not compared.
#[derive(Debug, Clone)]
pub struct MeshSummary<'a> {
    /// The mesh.
    pub mesh: &'a MeshRecord,
    /// Which run measured its cells.
    pub run: usize,
    /// Visible silhouette averaged over the scored frames, in pixels.
    pub visible_length_px: f64,
    /// Its cells, in the order of the comparison.
    pub cells: Vec<CellSummary<'a>>,
}

/// A cell.
#[derive(Debug, Clone)]
pub struct CellSummary<'a> {
    /// The cell.
    pub cell: &'a Cell,
    /// Its line in `results.jsonl`, from 1.
    pub row: usize,
    /// Which series of the page it is: one for each method with its options, whatever the mesh; decides colour and shape.
    pub series: usize,
    /// The method's name, with the options that distinguish it from others of the method.
    pub label: String,
    /// Those options.
    pub options: OptionSettings,
    /// Metrics averaged over the scored frames, each counting the same.
    pub metrics: PictureMetrics,
    /// Median frame time over that of the [baseline](baseline) on the same mesh in the same run.
    pub frame_ratio: Option<f64>,
    /// The same ratio of median times of the extraction alone.
    pub extract_ratio: Option<f64>,
}

/// The method that speeds of one kind of picture are stated as ratios to.
pub fn baseline(kind: PictureKind) -> &'static str {
    match kind {
        PictureKind::Lines => registry::BASELINE,
        PictureKind::Fill => "fine-mesh",
    }
}

impl<'a> MeshSummary<'a> {
    /// The cells whose pictures are of one kind.
    pub fn of_kind(&self, kind: PictureKind) -> Vec<&CellSummary<'a>> {
        self.cells.iter().filter(|summary| summary.cell.picture == kind).collect()
    }
}

/// Groups cells by mesh and run, in the order of each group's first cell. O(cells squared).
pub fn summarise(cells: &[Cell]) -> Vec<MeshSummary<'_>> {
    let mut meshes: Vec<MeshSummary<'_>> = Vec::new();
    let mut choices: Vec<(&str, &OptionSettings)> = Vec::new();
    for (at, cell) in cells.iter().enumerate() {
        let choice = (cell.method.as_str(), &cell.options);
        let series = choices.iter().position(|known| *known == choice).unwrap_or_else(|| {
            choices.push(choice);
            choices.len() - 1
        });
        let row = at + 1;
        let Some(metrics) = cell.mean_metrics() else { continue };
        let mesh =
            meshes.iter().position(|mesh| *mesh.mesh == cell.mesh && mesh.run == cell.run).unwrap_or_else(|| {
                let lengths = || cell.views.iter().map(|view| view.truth.visible_length_px);
                let visible_length_px = lengths().sum::<f64>() / lengths().count() as f64;
                meshes.push(MeshSummary { mesh: &cell.mesh, run: cell.run, visible_length_px, cells: Vec::new() });
                meshes.len() - 1
            });
        meshes[mesh].cells.push(CellSummary {
            cell,
            row,
            series,
            label: label(cell, cells),
            options: distinguishing_options(cell, cells),
            metrics,
            frame_ratio: None,
            extract_ratio: None,
        });
    }
    meshes.iter_mut().for_each(state_ratios);
    meshes
}

fn state_ratios(mesh: &mut MeshSummary<'_>) {
    for kind in PictureKind::ALL {
        let is_baseline = |cell: &&Cell| cell.picture == kind && cell.method == baseline(kind);
        let Some(baseline) = mesh.cells.iter().map(|summary| summary.cell).find(is_baseline) else { continue };
        let ratio = |ours: Spread, theirs: Spread| Some(ours.median / theirs.median).filter(|ratio| ratio.is_finite());
        for summary in mesh.cells.iter_mut().filter(|summary| summary.cell.picture == kind) {
            let (ours, theirs) = (&summary.cell.frame, &baseline.frame);
            summary.frame_ratio = ratio(ours.frame_ms, theirs.frame_ms);
            let extract = ours.extract_ms.zip(theirs.extract_ms);
            summary.extract_ratio = extract.and_then(|(ours, theirs)| ratio(ours, theirs));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::options::OptionSetting;
    use crate::record::tests::{cell, fill_cell, with_option};

    #[test]
    fn cells_are_grouped_by_mesh_and_set_beside_their_baseline() {
        let cells = [
            cell("a", registry::BASELINE, 4.0, 1.0),
            cell("a", "fast", 1.0, 5.0),
            cell("b", "fast", 1.0, 0.0),
            fill_cell("a", "fine-mesh", 8.0, 0.0),
            fill_cell("a", "texture", 2.0, 0.5),
        ];
        let meshes = summarise(&cells);
        assert_eq!(meshes.iter().map(|mesh| mesh.cells.len()).collect::<Vec<_>>(), [4, 1]);
        let ratios = |mesh: usize| meshes[mesh].cells.iter().map(|cell| cell.frame_ratio).collect::<Vec<_>>();
        assert_eq!(ratios(0), [Some(1.0), Some(0.25), Some(1.0), Some(0.25)], "each kind has its own baseline");
        assert_eq!(ratios(1), [None], "no baseline on this mesh");
        assert_eq!(meshes[0].cells[1].extract_ratio, Some(0.25));
        assert_eq!(meshes[0].of_kind(PictureKind::Fill).len(), 2);
    }

    #[test]
    fn a_method_is_one_series_on_every_mesh_and_rows_count_all_cells() {
        let level = |mesh, level| with_option(cell(mesh, "m", 1.0, 0.0), "level", OptionSetting::Number(level));
        let cells = [level("a", 1.0), level("a", 2.0), cell("a", "n", 1.0, 0.0), level("b", 2.0)];
        let meshes = summarise(&cells);
        let places = |mesh: usize| meshes[mesh].cells.iter().map(|cell| (cell.row, cell.series)).collect::<Vec<_>>();
        assert_eq!((places(0), places(1)), (vec![(1, 0), (2, 1), (3, 2)], vec![(4, 1)]));
    }

    #[test]
    fn times_of_different_machines_are_not_compared() {
        let elsewhere = |cell: Cell| Cell { run: 1, ..cell };
        let cells = [cell("a", registry::BASELINE, 4.0, 1.0), elsewhere(cell("a", "fast", 1.0, 5.0))];
        let meshes = summarise(&cells);
        assert_eq!(meshes.iter().map(|mesh| mesh.cells.len()).collect::<Vec<_>>(), [1, 1]);
        assert_eq!(meshes[1].cells[0].frame_ratio, None, "its baseline was measured elsewhere");
    }

    #[test]
    fn a_method_with_several_options_is_several_cells() {
        let level = |level: f64| with_option(cell("a", "m", level, level), "level", OptionSetting::Number(level));
        let cells = [level(1.0), level(2.0)];
        let meshes = summarise(&cells);
        let labels: Vec<_> = meshes[0].cells.iter().map(|cell| cell.label.as_str()).collect();
        assert_eq!(labels, ["m (level=1)", "m (level=2)"]);
    }
}
