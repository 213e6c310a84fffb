//! The table of the paper with ours, one per mesh; below it the rows of models that are not available.

use super::circles::{CIRCLE, STEP_DEG};
use super::counted::{Counted, flight_frames};
use super::measure::{MeshResult, VariantResult, frames};
use super::printed::{BUNNY, LEVELS_RAD, OTHERS, PaperModel, model_of};
use super::variants::{Asked, Extractor, Variant};
use crate::chart::Chart;
use crate::chart::trade::{self, Axes, Series};
use crate::paper::Measured;
use crate::table::{Cell, Column, Comparable, Mark, Range, Row, Table};
use silhouette_compare::Profile;
use silhouette_compare::report::COLORS;
use silhouette_tracking::TestedEdges;

/// The section of the paper that holds the table.
const TABLE: &str = "Performance";

const COUNTED: Column = Column::new(
    "counted",
    "speed-up, counted",
    "×",
    "faces of the mesh over faces evaluated in a frame, over twenty circles; the same on every machine; extractors of today \
     may count a face twice",
);
const COUNTED_HERE: Column = Column::new(
    "counted here",
    "speed-up, counted, on the measured circle",
    "×",
    "the same on the one circle that the columns to the right are measured on",
);
const WALL: Column = Column::new(
    "wall",
    "speed-up, wall time",
    "×",
    "median frame time of Hall's brute force over this one's, in the same run",
);
const RATE: Column =
    Column::new("rate", "frame rate", "frames/s", "frames per second, from the median time; nothing is drawn");
const TIME: Column = Column { digits: 1, ..Column::new("time", "frame time", "µs", "median time of a frame") };
const EDGES: Column = Column::new("edges", "edges missed", "%", "silhouette edges that were not found");
const LOOPS: Column = Column::new("loops", "loops missed", "%", "silhouette loops of which no edge was found");
const LENGTH: Column =
    Column::new("length", "length missed", "%", "length in space that was not found, hidden parts included");
const VISIBLE: Column =
    Column::new("visible", "visible length missed", "%", "visible length in the picture that was not found");

/// The machine that the paper's times were taken on.
const PAPER_MACHINE: &str = "a Pentium III of 650 MHz";

/// What the ranges are over.
const CIRCLES: &str = "twenty circles";

const SERIES: [Series; 9] = [
    Series::new("brute force (Hall; in fours)", COLORS[6], 5, 180),
    Series { is_joined: true, ..Series::new("tracking by level N", COLORS[0], 24, 0) },
    Series::new("tracking, single edges", COLORS[1], 4, 45),
    Series::new("tracking, exact", COLORS[2], 4, 0),
    Series::new("tracking, 1 % budget", COLORS[3], 3, 180),
    Series { is_hollow: true, ..Series::new("brute-force-simd, edges", COLORS[5], 3, 0) },
    Series::new("brute-force-simd, loops", COLORS[5], 3, 0),
    Series { is_hollow: true, ..Series::new("cluster-cones, edges", COLORS[4], 6, 0) },
    Series::new("cluster-cones, loops", COLORS[4], 6, 0),
];

/// Which of [`SERIES`] a variant belongs to, and what stands beside its mark.
fn mark(variant: Variant) -> Mark {
    let series = match variant {
        Variant::BruteForce | Variant::BruteForceInFours => 0,
        Variant::Level(_, TestedEdges::All) => 1,
        Variant::Level(_, TestedEdges::Single) => 2,
        Variant::Exact => 3,
        Variant::Budget => 4,
        Variant::Today(Extractor::BruteForceSimd, Asked::Edges) => 5,
        Variant::Today(Extractor::BruteForceSimd, Asked::Loops) => 6,
        Variant::Today(Extractor::ClusterCones, Asked::Edges) => 7,
        Variant::Today(Extractor::ClusterCones, Asked::Loops) => 8,
    };
    let label = match variant {
        Variant::Level(Some(level_rad), _) => level_rad.to_string(),
        Variant::Level(None, _) => "none".to_owned(),
        _ => String::new(),
    };
    Mark { series, label }
}

/// What was measured, as tables and a chart.
pub fn measured(profile: Profile, meshes: &[MeshResult]) -> Measured {
    let flown: Vec<Table> = meshes.iter().map(of_mesh).collect();
    let axes = Axes {
        x: [LENGTH.metric, "length of silhouette missed in %"],
        y: [TIME.metric, "median time of a frame in µs"],
    };
    let svg = trade::draw(&flown, axes, &SERIES);
    let chart = Chart { file_name: "trade.svg", title: "Time against what is missed", svg };
    let has_bunny = meshes.iter().any(|mesh| mesh.faces == BUNNY.faces);
    let no_bunny = "The paper's bunny is not among these meshes, so that only its printed values stand here; name the file of \
                    the Stanford bunny at full resolution, which is recognised by its 69451 faces";
    Measured {
        setting: format!(
            "{} frames of {STEP_DEG}° on the circle {} radii from the middle of the mesh and level with it, one thread; \
             counts of {} frames on each of {CIRCLES}",
            frames(profile),
            CIRCLE.distance_radii,
            flight_frames(profile)
        ),
        notes: if has_bunny { Vec::new() } else { vec![no_bunny.to_owned()] },
        tables: flown.into_iter().chain([printed_only(has_bunny)]).collect(),
        charts: vec![chart],
        pictures: Vec::new(),
    }
}

fn of_mesh(mesh: &MeshResult) -> Table {
    let MeshResult { name, faces, concave_edges, boundary_edges, half_edges, loops, variants } = mesh;
    let model = model_of(*faces);
    let by_model =
        model.map_or_else(String::new, |model| format!("The paper's {}, by its number of faces; ", model.name));
    let baseline_us = variants.first().map_or(f64::NAN, |brute_force| brute_force.median_us);
    Table {
        name: TABLE,
        subject: name.clone(),
        about: format!(
            "{by_model}{faces} faces, {concave_edges} concave and {boundary_edges} boundary edges; a frame's silhouette has \
             {half_edges:.0} edges in {loops:.1} loops"
        ),
        columns: vec![COUNTED, COUNTED_HERE, WALL, RATE, TIME, EDGES, LOOPS, LENGTH, VISIBLE],
        remark_title: "",
        rows: variants.iter().map(|result| of_variant(result, model, baseline_us)).collect(),
    }
}

fn of_variant(result: &VariantResult, model: Option<&PaperModel>, baseline_us: f64) -> Row {
    let VariantResult { variant, counted, median_us, missed, missed_visible } = result;
    let printed = model.zip(variant.paper_column());
    let speed_up = printed.map(|(model, column)| model.speed_ups[column]);
    let fps = printed.map(|(model, column)| model.fps[column]);
    let range = Range::of(counted.iter().map(Counted::speed_up), CIRCLES);
    let here = counted.iter().find(|counted| counted.circle == CIRCLE).map_or(f64::NAN, Counted::speed_up);
    let fallbacks: u32 = counted.iter().map(|counted| counted.fallbacks).sum();
    let fell_back = if fallbacks > 0 { format!("{fallbacks} frames were found by brute force") } else { String::new() };
    let other_machine = |what: &str| Comparable::No(format!("{what} on {PAPER_MACHINE}"));
    let cells = vec![
        Cell::range(range).beside(speed_up, Comparable::Yes).noted(fell_back),
        Cell::one(here),
        Cell::one(baseline_us / median_us).beside(speed_up, other_machine("the paper's is a ratio of times")),
        Cell::one(1e6 / median_us).beside(fps, other_machine("the paper draws its frames,")),
        Cell::one(*median_us),
        Cell::one(missed.edges.percent()),
        Cell::one(missed.loops.percent()),
        Cell::one(missed.length.percent()),
        Cell::one(*missed_visible),
    ];
    Row { mark: Some(mark(*variant)), ..Row::new(variant.label(), cells) }
}

/// What the paper prints for models that are not available, the bunny among them where its file was not named.
fn printed_only(has_bunny: bool) -> Table {
    let missing = (!has_bunny).then_some((&BUNNY, "not measured: name the bunny's file, which has 69451 faces"));
    let others = OTHERS.iter().map(|model| (model, "not measured: the model is not available"));
    let rows = missing.into_iter().chain(others).flat_map(|(model, why)| {
        let note = [why, model.note].join(if model.note.is_empty() { "" } else { "; " });
        LEVELS_RAD.into_iter().zip(model.speed_ups).map(move |(level_rad, speed_up)| {
            let printed = Cell::default().beside(Some(speed_up), Comparable::Yes).noted(note.clone());
            Row::new(format!("{}, tracking, N = {level_rad}", model.name), vec![printed])
        })
    });
    let about = "printed values of models that were not measured".to_owned();
    Table { name: TABLE, about, columns: vec![COUNTED], rows: rows.collect(), ..Table::default() }
}

#[cfg(test)]
mod tests {
    use super::super::circles::circles;
    use super::super::missed::Missed;
    use super::*;
    use crate::figure::{Figure, figures};

    /// Made-up values of a mesh of this many faces: on circle i every variant evaluates one of i + 1 faces.
    fn made_up(faces: usize) -> MeshResult {
        let counted = |(at, circle): (u64, _)| Counted { circle, evaluated: 100, all: 100 * (at + 1), fallbacks: 0 };
        let result = |(at, variant)| VariantResult {
            variant,
            counted: (0..).zip(circles()).map(counted).collect(),
            median_us: if at == 0 { 40.0 } else { 20.0 },
            missed: Missed::default(),
            missed_visible: 0.5,
        };
        let variants = Variant::all().into_iter().enumerate().map(result).collect();
        let name = format!("{faces} faces");
        MeshResult { name, faces, concave_edges: 3, boundary_edges: 2, half_edges: 10.0, loops: 1.0, variants }
    }

    /// The bunny and another mesh.
    fn with_a_bunny() -> [MeshResult; 2] {
        [BUNNY.faces, 2000].map(made_up)
    }

    fn figures_of(meshes: &[MeshResult]) -> Vec<Figure> {
        figures("tracking", &measured(Profile::Quick, meshes).tables)
    }

    #[test]
    fn the_paper_stands_beside_the_bunny_and_beside_no_other_mesh() {
        let figures = figures_of(&with_a_bunny());
        let printed = |column: Column, with_ours: bool| {
            let of_metric = figures.iter().filter(move |figure| figure.metric == column.metric);
            of_metric.filter(|figure| figure.ours.is_some() == with_ours).filter_map(|figure| figure.paper).collect()
        };
        let printed: [Vec<f64>; 4] =
            [printed(COUNTED, true), printed(WALL, true), printed(RATE, true), printed(COUNTED, false)];
        assert_eq!(printed[..2], [BUNNY.speed_ups; 2]);
        assert_eq!(
            (printed[2].as_slice(), &printed[3]),
            (&BUNNY.fps[..], &OTHERS.map(|model| model.speed_ups).concat())
        );
        assert!(
            figures.iter().filter(|figure| figure.row.starts_with("2000 faces")).all(|figure| figure.paper.is_none())
        );
    }

    #[test]
    fn counts_are_comparable_and_times_are_not() {
        for figure in figures_of(&with_a_bunny()) {
            let both = figure.paper.is_some() && figure.ours.is_some();
            assert_eq!(figure.comparable, both && figure.metric == COUNTED.metric, "{figure:?}");
            assert_eq!(figure.note.contains("Pentium III"), both && !figure.comparable, "{figure:?}");
        }
    }

    #[test]
    fn without_a_bunny_its_rows_say_how_to_get_them() {
        let figures = figures_of(&[made_up(2000)]);
        let missing: Vec<_> = figures.iter().filter(|figure| figure.row.starts_with("Bunny")).collect();
        assert_eq!(missing.len(), 6);
        assert!(missing.iter().all(|figure| figure.ours.is_none() && figure.note.contains("69451 faces")));
        assert!(measured(Profile::Quick, &[made_up(2000)]).notes[0].contains("69451"));
        assert!(measured(Profile::Quick, &with_a_bunny()).notes.is_empty());
    }

    #[test]
    fn every_variant_has_every_value_and_a_mark_of_a_series_that_looks_like_no_other() {
        let measured = measured(Profile::Quick, &[made_up(2000)]);
        for row in &measured.tables[0].rows {
            let values: Vec<f64> = row.cells.iter().filter_map(|cell| Some(cell.ours?.middle())).collect();
            let [wall, us] = if row.label == Variant::BruteForce.label() { [1.0, 40.0] } else { [2.0, 20.0] };
            // Of the speed-ups 1 to 20 the median is 10.5; the measured circle is the tenth.
            assert_eq!(values, [10.5, 10.0, wall, 1e6 / us, us, 0.0, 0.0, 0.0, 0.5], "{}", row.label);
            assert!(SERIES.get(row.mark.as_ref().unwrap().series).is_some());
        }
        assert_eq!(measured.tables[0].rows.len(), Variant::all().len());
        let shape = |series: &Series| (series.corners, series.turned_deg, series.is_hollow);
        for (index, one) in SERIES.iter().enumerate() {
            assert!(SERIES[..index].iter().all(|other| shape(other) != shape(one)), "{}", one.label);
        }
    }
}
