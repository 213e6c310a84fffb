//! The figures of the paper's table with ours, one row a figure.

use super::measure::{MeshResult, Reproduction, VariantResult};
use super::printed::{BUNNY, LEVELS_RAD, OTHERS, PaperModel, model_of};
use crate::Figure;

/// The section of the paper that holds the table.
const TABLE: &str = "Performance";

const COUNTED: &str = "speed-up, counted";
const WALL: &str = "speed-up, wall time";

/// Every figure: the paper's with ours, ours that the paper lacks, and the paper's that cannot be had.
pub fn figures(reproduction: &Reproduction) -> Vec<Figure> {
    let mut figures = Vec::new();
    for mesh in &reproduction.meshes {
        let model = model_of(mesh.faces);
        for result in &mesh.variants {
            figures.extend(of_variant(reproduction, mesh, result, model));
        }
    }
    if !reproduction.meshes.iter().any(|mesh| mesh.faces == BUNNY.faces) {
        figures.extend(printed_only(&BUNNY, "not measured: pass the bunny's file, which has 69451 faces"));
    }
    for model in &OTHERS {
        figures.extend(printed_only(model, "not measured: the model cannot be had"));
    }
    figures
}

fn figure(row: String, metric: &str, unit: &str) -> Figure {
    Figure {
        method: "tracking".to_owned(),
        table: TABLE.to_owned(),
        row,
        metric: metric.to_owned(),
        unit: unit.to_owned(),
        paper: None,
        ours: None,
        comparable: true,
        note: String::new(),
    }
}

/// A number that can be stored; what is not finite was not measured.
fn finite(value: f64) -> Option<f64> {
    value.is_finite().then_some(value)
}

fn of_variant(
    reproduction: &Reproduction,
    mesh: &MeshResult,
    result: &VariantResult,
    model: Option<&PaperModel>,
) -> Vec<Figure> {
    let named = model.map_or_else(|| mesh.name.clone(), |model| model.name.to_owned());
    let row = format!("{named}, {}", result.variant.label());
    let printed = model.zip(result.variant.paper_column());
    let speed_up = printed.map(|(model, column)| model.speed_ups[column]);
    let fallbacks = result.counted.fallbacks;
    let mut counted_note = if fallbacks > 0 { format!("; {fallbacks} frames by brute force") } else { String::new() };
    if let Some([least, greatest]) = result.counted_range {
        let range =
            format!("; {least:.2} to {greatest:.2} over twenty circles, since the paper does not tell its path");
        counted_note.push_str(&range);
    }
    let percent = |metric: &str, percent: f64| Figure { ours: Some(percent), ..figure(row.clone(), metric, "%") };
    vec![
        Figure {
            paper: speed_up,
            ours: result.counted.speed_up(),
            note: format!("faces of the mesh over faces evaluated a frame{counted_note}"),
            ..figure(row.clone(), COUNTED, "")
        },
        Figure {
            paper: speed_up,
            ours: finite(result.speed_up),
            note: format!("over brute force in the same run, one thread; another machine: {}", reproduction.machine),
            ..figure(row.clone(), WALL, "")
        },
        Figure {
            paper: printed.map(|(model, column)| model.fps[column]),
            ours: finite(1e6 / result.median_us),
            comparable: false,
            note: format!("the paper's frames are drawn too; another machine: {}", reproduction.machine),
            ..figure(row.clone(), "frame rate", "frames/s")
        },
        percent("edges missed", result.missed.edges.percent()),
        percent("loops missed", result.missed.loops.percent()),
        percent("length missed", result.missed.length.percent()),
        percent("visible length missed", result.missed_visible),
    ]
}

/// The paper's speed-ups without ours.
fn printed_only(model: &PaperModel, why: &str) -> Vec<Figure> {
    let note = if model.note.is_empty() { why.to_owned() } else { format!("{why}; {}", model.note) };
    let figure = |(level_rad, speed_up): (f32, f64)| Figure {
        paper: Some(speed_up),
        note: note.clone(),
        ..figure(format!("{}, tracking, N = {level_rad}", model.name), WALL, "")
    };
    LEVELS_RAD.into_iter().zip(model.speed_ups).map(figure).collect()
}

#[cfg(test)]
mod tests {
    use super::super::measure::tests::reproduction;
    use super::*;

    /// The small reproduction with its first mesh passed off as the bunny.
    fn with_a_bunny() -> Reproduction {
        let mut flown = reproduction().clone();
        flown.meshes[0].faces = BUNNY.faces;
        flown
    }

    #[test]
    fn the_paper_stands_beside_the_bunny_and_beside_no_other_mesh() {
        let figures = figures(&with_a_bunny());
        let printed = |metric: &str, with_ours: bool| {
            let of_metric = figures.iter().filter(move |figure| figure.metric == metric);
            of_metric
                .filter(|figure| figure.paper.is_some() && figure.ours.is_some() == with_ours)
                .map(|figure| figure.paper.unwrap())
                .collect::<Vec<_>>()
        };
        for metric in [COUNTED, WALL] {
            assert_eq!(printed(metric, true), BUNNY.speed_ups, "{metric}");
        }
        assert_eq!(printed("frame rate", true), BUNNY.fps);
        assert_eq!(printed(WALL, false), [OTHERS[0].speed_ups, OTHERS[1].speed_ups].concat());
        assert!(figures.iter().filter(|figure| figure.row.starts_with("gear")).all(|figure| figure.paper.is_none()));
        let level = figures.iter().find(|figure| figure.row == "Bunny, tracking, N = 0.1").unwrap();
        assert_eq!((level.paper, level.comparable), (Some(2.60), true));
        assert_eq!(level.ratio(), Some(level.ours.unwrap() / 2.60));
    }

    #[test]
    fn without_a_bunny_its_row_says_how_to_have_it() {
        let figures = figures(reproduction());
        let missing: Vec<_> = figures.iter().filter(|figure| figure.row.starts_with("Bunny")).collect();
        assert_eq!(missing.len(), 6);
        assert!(missing.iter().all(|figure| figure.ours.is_none() && figure.note.contains("69451 faces")));
    }

    #[test]
    fn every_share_missed_is_there_for_every_variant() {
        let figures = figures(reproduction());
        for metric in ["edges missed", "loops missed", "length missed", "visible length missed"] {
            let missed = figures.iter().filter(|figure| figure.metric == metric);
            assert!(missed.clone().all(|figure| figure.ours.is_some_and(|percent| (0.0..=100.0).contains(&percent))));
            assert_eq!(missed.count(), 2 * reproduction().meshes[0].variants.len(), "{metric}");
        }
    }

    #[test]
    fn times_are_comparable_as_ratios_only() {
        for figure in figures(&with_a_bunny()) {
            assert_eq!(figure.comparable, figure.metric != "frame rate", "{figure:?}");
        }
    }
}
