//! What the publication of a method prints, beside what this run measured.

use super::summary::CellSummary;
use super::text::grouped;
use crate::cost::Spread;
use crate::record::Cell;
use minijinja::{Value, context};
use silhouette_core::method::PublishedRates;

/// The tables that a publication prints, each with a last row of this cell's own ratios to the same method.
pub(super) fn tables(published: &[PublishedRates], cells: &[Cell], summary: &CellSummary<'_>) -> Vec<Value> {
    published
        .iter()
        .map(|rates| {
            let rows = rates.rows.iter().map(|row| {
                context! { model => row.model, setting => row.setting, speed_up => speed_up(row.speed_up()) }
            });
            let against = beside(cells, summary.cell, rates.against);
            context! {
                place => rates.place,
                against => rates.against,
                rows => rows.collect::<Vec<_>>(),
                here => against.map(|against| here(summary, against)),
            }
        })
        .collect()
}

/// The first cell of the method `name` with the same mesh in the same run: times of different machines are not compared.
fn beside<'a>(cells: &'a [Cell], cell: &Cell, name: &str) -> Option<&'a Cell> {
    cells.iter().find(|other| other.method == name && other.run == cell.run && other.mesh == cell.mesh)
}

fn here(summary: &CellSummary<'_>, against: &Cell) -> Value {
    let ratio = |theirs: Spread, ours: Spread| Some(theirs.median / ours.median).filter(|ratio| ratio.is_finite());
    let ours = &summary.cell.frame;
    let extract = against.frame.extract_ms.zip(ours.extract_ms);
    context! {
        model => format!("{}, {} faces", summary.cell.mesh.name, grouped(summary.cell.mesh.faces)),
        setting => summary.options.to_string(),
        speed_up => ratio(against.frame.frame_ms, ours.frame_ms).map(speed_up),
        extract => extract.and_then(|(theirs, ours)| ratio(theirs, ours)).map(speed_up),
    }
}

/// Two decimals, or none where they would say nothing.
fn speed_up(ratio: f64) -> String {
    if ratio < 100.0 { format!("{ratio:.2}") } else { format!("{ratio:.0}") }
}

#[cfg(test)]
mod tests {
    use super::super::summary::summarise;
    use super::super::tests::comparison;
    use super::*;
    use silhouette_core::method::PublishedRate;

    const PRINTED: &[PublishedRates] = &[PublishedRates {
        place: "a paper",
        against: "brute-force",
        rows: &[PublishedRate::new("Bunny", "N = 1", 30.0, 4.0)],
    }];

    fn text(value: &Value, path: &[&str]) -> String {
        path.iter().fold(value.clone(), |value, name| value.get_attr(name).unwrap()).to_string()
    }

    #[test]
    fn the_run_s_ratio_stands_beside_the_printed_one() {
        let comparison = comparison();
        let meshes = summarise(&comparison.cells);
        let ours = meshes[0].cells.iter().find(|cell| cell.cell.method == "image-precision").unwrap();
        let table = &tables(PRINTED, &comparison.cells, ours)[0];
        assert_eq!(
            table
                .get_attr("rows")
                .unwrap()
                .get_item(&Value::from(0))
                .unwrap()
                .get_attr("speed_up")
                .unwrap()
                .to_string(),
            "7.50"
        );
        assert_eq!(text(table, &["here", "speed_up"]), "2.00", "4 ms beside 2 ms");
    }

    #[test]
    fn a_cell_of_another_machine_or_mesh_is_not_compared() {
        let mut comparison = comparison();
        comparison.cells[0].run = 7;
        let ours = comparison.cells[1].clone();
        assert!(beside(&comparison.cells, &ours, "brute-force").is_none());
        comparison.cells[0].run = ours.run;
        assert!(beside(&comparison.cells, &ours, "brute-force").is_some());
        comparison.cells[0].mesh.name.push('2');
        assert!(beside(&comparison.cells, &ours, "brute-force").is_none());
    }

    #[test]
    fn methods_that_publications_compare_with_exist() {
        let methods = comparison().methods;
        let mut compared = 0;
        for rates in methods.iter().flat_map(|entry| entry.info().published) {
            assert!(methods.iter().any(|entry| entry.info().name == rates.against), "{}", rates.against);
            assert!(!rates.place.is_empty() && rates.rows.iter().all(|row| row.fps > 0.0 && row.against_fps > 0.0));
            compared += rates.rows.len();
        }
        assert!(compared > 0, "no method has a published rate");
    }
}
