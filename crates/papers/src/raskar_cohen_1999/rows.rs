//! The tables: the paper's frame rates beside ours, then what its pictures show.

use super::lost::Lost;
use super::measure::{MeshResult, VariantResult};
use super::printed::{PaperRow, ROWS};
use super::score::Score;
use super::spheres::{Around, SphereResult, VIEWS};
use super::variants::VARIANTS;
use crate::chart::Chart;
use crate::chart::bars::{self, Bar};
use crate::paper::Measured;
use crate::table::{Cell, Column, Comparable, Range, Row, Table};

/// The section of the paper that holds its frame rates.
const PERFORMANCE: &str = "5. Performance";

/// What the ranges are over.
const OVER_VIEWS: &str = "twelve views spread evenly";

const RATE: Column = Column {
    digits: 3,
    ..Column::new("rate", "frame rate over plain rendering", "×", "frame rate with silhouettes over that without")
};
const WIDTH: Column = Column::new("width", "mean width", "px", "mean width of the drawn lines where they are drawn");
const DEVIATION: Column = Column::new("deviation", "deviation of width", "px", "standard deviation of that width");
const THROUGH: Column =
    Column::new("through", "shows through", "%", "ink farther than 5 px from every silhouette edge, visible or not");
const TIME: Column = Column::new(
    "time",
    "frame time over plain rendering",
    "×",
    "median frame time over that of plain rendering of all faces, in the same run",
);
const TIME_CULLED: Column = Column::new(
    "time, culled",
    "frame time over plain rendering of front faces",
    "×",
    "median frame time over that of plain rendering with back faces culled, in the same run",
);
const SCORES: [Column; 9] = [
    WIDTH,
    DEVIATION,
    Column::new("ink/length", "ink over length", "px", "all ink over the length of all visible lines"),
    Column::new("missed", "missed at 1 px", "%", "visible length without ink within 1 px"),
    Column::new("spurious", "spurious at 1 px", "%", "ink farther than 1 px from the true pen"),
    Column::new("stray", "stray", "%", "ink farther than the pen's width and 1 px from every visible line"),
    Column::new("gaps", "gaps", "per 1000 px", "stretches longer than 1 px without ink"),
    THROUGH,
    Column {
        digits: 0,
        ..Column::new("farthest", "farthest ink", "px", "distance of the farthest ink from every silhouette edge")
    },
];

fn scores(Score { metrics, ink_over_length_px, stray, bleed, farthest_px }: &Score) -> [f64; 9] {
    [
        metrics.width_mean_px,
        metrics.width_deviation_px,
        *ink_over_length_px,
        100.0 * metrics.missed_1px,
        100.0 * metrics.spurious_1px,
        100.0 * stray,
        metrics.gaps_per_1000px,
        100.0 * bleed,
        *farthest_px,
    ]
}

/// What was measured, as tables and a chart.
pub fn measured(adapter: &str, meshes: &[MeshResult], levels: &[Vec<SphereResult>]) -> Measured {
    let mut tables = vec![performance(adapter, meshes)];
    tables.extend(meshes.iter().flat_map(|mesh| [pictures(mesh), smooth_pictures(mesh), lost_faces(mesh)]));
    tables.push(spheres(levels));
    let width = Bar {
        metric: WIDTH.metric,
        deviation: Some(DEVIATION.metric),
        title: "mean width and its deviation, px",
        end: 6.0,
        step: 1.0,
        asked: Some(2.0),
    };
    let through = Bar {
        metric: THROUGH.metric,
        deviation: None,
        title: "ink that shows through from behind, %",
        end: 100.0,
        step: 25.0,
        asked: None,
    };
    let svg = bars::draw(tables.iter().filter(|table| table.name == PICTURES), &[width, through]);
    let size = meshes.first().map_or(0, |mesh| mesh.size_px);
    Measured {
        setting: format!("{size} x {size} pixels, frames over plain rendering in the same run"),
        notes: Vec::new(),
        pictures: Vec::new(),
        charts: vec![Chart { file_name: "variants.svg", title: "Width, and what shows through", svg }],
        tables,
    }
}

/// Frame rate with silhouettes over the rate without, of each row of the paper and of the mesh that stands in for its model.
fn performance(adapter: &str, meshes: &[MeshResult]) -> Table {
    let row = |row: &PaperRow| {
        let mesh = meshes.iter().find(|mesh| mesh.name == row.stand_in);
        let ours = mesh.and_then(|mesh| rate_kept(mesh, row.variant));
        let why = format!(
            "the models are not available, built-in meshes with as many triangles stand in for them; {adapter} draws \
             instead of SGI graphics of 1999"
        );
        let note = match ours {
            Some(_) => format!("{} stands in for {}", row.stand_in, row.model),
            None => format!("not measured: name {}", row.stand_in),
        };
        let cell = Cell::one(ours.unwrap_or(f64::NAN)).beside(Some(row.rate_kept()), Comparable::No(why)).noted(note);
        Row::new(format!("{} ({} triangles), {}", row.model, row.triangles, row.variant), vec![cell])
    };
    Table { name: PERFORMANCE, columns: vec![RATE], rows: ROWS.iter().map(row).collect(), ..Table::default() }
}

/// Plain rendering's time over that of a variant.
fn rate_kept(mesh: &MeshResult, label: &str) -> Option<f64> {
    let at = VARIANTS.iter().position(|variant| variant.label == label)?;
    Some(mesh.times.plain_ms / mesh.times.variants_ms.get(at)?)
}

const PICTURES: &str = "pictures";

fn pictures(mesh: &MeshResult) -> Table {
    let times = &mesh.times;
    let row = |(at, VariantResult { variant, score }): (usize, &VariantResult)| {
        let ms = times.variants_ms.get(at).copied().unwrap_or(f64::NAN);
        let cells = scores(score).into_iter().chain([ms / times.plain_ms, ms / times.plain_culled_ms]);
        Row { remark: variant.law, ..Row::new(variant.label, cells.map(Cell::one).collect()) }
    };
    Table {
        columns: SCORES.into_iter().chain([TIME, TIME_CULLED]).collect(),
        rows: mesh.sharp.iter().enumerate().map(row).collect(),
        ..of_mesh(PICTURES, mesh)
    }
}

fn smooth_pictures(mesh: &MeshResult) -> Table {
    let row = |VariantResult { variant, score }: &VariantResult| Row {
        remark: variant.law,
        ..Row::new(variant.label, scores(score).map(Cell::one).to_vec())
    };
    Table {
        columns: SCORES.to_vec(),
        rows: mesh.smooth.iter().map(row).collect(),
        ..of_mesh("pictures, 4 samples per pixel", mesh)
    }
}

/// A table of a mesh's variants, without columns and rows.
fn of_mesh(name: &'static str, mesh: &MeshResult) -> Table {
    let MeshResult { faces, visible_px, size_px, .. } = mesh;
    Table {
        name,
        subject: mesh.name.clone(),
        about: format!("{faces} faces, {visible_px:.0} px of visible lines at {size_px} x {size_px}"),
        remark_title: "what decides the width",
        ..Table::default()
    }
}

fn lost_faces(mesh: &MeshResult) -> Table {
    let share = "ink of the soup that its oriented counterpart does not draw of the mesh";
    let lacking = "ink that its oriented counterpart draws of the mesh and that the soup lacks";
    let row = |Lost { size_px, share, inks }: &Lost| {
        let inks = inks.iter().flat_map(|ink| [ink.false_share, ink.lacking_share]);
        let cells = [*share].into_iter().chain(inks).map(|share| Cell::one(100.0 * share));
        Row::new(format!("{size_px} x {size_px}"), cells.collect())
    };
    Table {
        name: "lost faces",
        subject: mesh.name.clone(),
        columns: vec![
            Column::new(
                "lost",
                "front faces lost",
                "%",
                "front faces visible at 4096 x 4096 pixels that the picture lacks",
            ),
            Column::new("unoriented: false", "false ink, unoriented", "%", share),
            Column::new("lacking", "lacking ink, unoriented", "%", lacking),
            Column::new("screen: false", "false ink, unoriented, screen", "%", share),
            Column::new("lacking", "lacking ink, unoriented, screen", "%", lacking),
        ],
        rows: mesh.lost.iter().map(row).collect(),
        ..Table::default()
    }
}

fn spheres(levels: &[Vec<SphereResult>]) -> Table {
    let far = |title, metric, meaning| Column { digits: 0, ..Column::new(title, metric, "px", meaning) };
    let columns = vec![
        Column::new("drawn", "ink over outline", "px", "ink over the length of the smooth sphere's outline"),
        Column::new("derived", "ink over outline, derived", "px", "the same from the geometry, nothing drawn"),
        far("farthest", "farthest ink outside", "distance of the farthest ink outside of the smooth outline"),
        far("derived", "farthest ink outside, derived", "the same from the geometry, nothing drawn"),
    ];
    let row = |SphereResult { variant, level, drawn, derived }: &SphereResult| {
        let range = |around: &[Around], value: fn(&Around) -> Option<f64>| {
            Cell::range(Range::of(around.iter().filter_map(value), OVER_VIEWS))
        };
        let cells = [drawn, derived].map(|around| range(around, |around| Some(around.width_px)));
        let farthest = [drawn, derived].map(|around| range(around, |around| around.farthest_px));
        Row::new(format!("icosphere {level}, {}", variant.label), cells.into_iter().chain(farthest).collect())
    };
    Table {
        name: "spheres",
        about: format!("ranges over {VIEWS} views spread evenly, 512 x 512 pixels, 45°, 3 radii away"),
        columns,
        rows: levels.iter().flatten().map(row).collect(),
        ..Table::default()
    }
}

#[cfg(test)]
mod tests {
    use super::super::lost::InkOfSoup;
    use super::super::timed::FrameTimes;
    use super::super::variants::UNORIENTED;
    use super::*;
    use crate::figure::{Figure, figures};
    use silhouette_compare::metrics::LineMetrics;

    /// Tables and figures of made-up values: a stand-in for the paper's Venus, and a sphere.
    fn made_up() -> (Vec<Table>, Vec<Figure>) {
        let metrics = LineMetrics { width_mean_px: 2.0, missed_1px: 0.25, ..LineMetrics::default() };
        let score = Score { metrics, ink_over_length_px: 3.0, stray: 0.1, bleed: 0.05, farthest_px: 7.0 };
        let results = |variants: &[_]| variants.iter().map(|&variant| VariantResult { variant, score }).collect();
        let ink = InkOfSoup { false_share: 0.5, lacking_share: 0.125 };
        let mesh = MeshResult {
            name: "builtin:blob:5672".to_owned(),
            faces: 5672,
            visible_px: 100.0,
            size_px: 512,
            times: FrameTimes { plain_ms: 2.0, plain_culled_ms: 1.0, variants_ms: vec![4.0; VARIANTS.len()] },
            sharp: results(&[&VARIANTS[..], &UNORIENTED.map(|unoriented| unoriented.variant)].concat()),
            smooth: results(&VARIANTS),
            lost: vec![Lost { size_px: 256, share: 0.75, inks: [ink; 2] }],
        };
        let around = |width_px| Around { width_px, farthest_px: Some(40.0) };
        let drawn = [2.0, 1.0, 4.0].map(around).to_vec();
        let sphere = SphereResult { variant: VARIANTS[0], level: 2, drawn, derived: vec![around(3.0)] };
        let tables = measured("an adapter", &[mesh], &[vec![sphere]]).tables;
        let figures = figures("image-precision", &tables);
        (tables, figures)
    }

    #[test]
    fn printed_rates_stand_beside_stand_ins_that_are_not_comparable() {
        let (_, figures) = made_up();
        let printed: Vec<_> = figures.iter().filter(|figure| figure.paper.is_some()).collect();
        assert_eq!(printed.len(), ROWS.len());
        for figure in printed {
            let is_venus = figure.row.starts_with("Venus");
            assert_eq!((figure.ours, figure.comparable, figure.ratio), (is_venus.then_some(0.5), false, None));
            let reason =
                if is_venus { "an adapter draws instead of SGI graphics of 1999" } else { "not measured: name" };
            assert!(figure.note.contains(reason), "{figure:?}");
        }
    }

    #[test]
    fn every_value_stands_under_its_column() {
        let (tables, figures) = made_up();
        let rows: Vec<_> = tables.iter().map(|table| table.rows.len()).collect();
        assert_eq!(rows, [ROWS.len(), VARIANTS.len() + UNORIENTED.len(), VARIANTS.len(), 1, 1]);
        assert!(tables.iter().all(|table| table.rows.iter().all(|row| row.cells.len() == table.columns.len())));
        for (row, metric, expected) in [
            ("builtin:blob:5672, screen", "mean width", 2.0),
            ("builtin:blob:5672, screen", "missed at 1 px", 25.0),
            ("builtin:blob:5672, screen", "shows through", 5.0),
            ("builtin:blob:5672, screen", "farthest ink", 7.0),
            ("builtin:blob:5672, screen", "frame time over plain rendering of front faces", 4.0),
            ("builtin:blob:5672, 256 x 256", "front faces lost", 75.0),
            ("builtin:blob:5672, 256 x 256", "lacking ink, unoriented, screen", 12.5),
            ("icosphere 2, screen", "ink over outline", 2.0),
            ("icosphere 2, screen", "ink over outline, most", 4.0),
            ("icosphere 2, screen", "ink over outline, derived", 3.0),
        ] {
            let found = figures.iter().find(|figure| figure.row == row && figure.metric == metric);
            assert_eq!(found.and_then(|figure| figure.ours), Some(expected), "{row}, {metric}");
        }
        let unoriented_times = |figure: &&Figure| figure.row.contains("unoriented") && figure.metric.contains("time");
        assert_eq!(figures.iter().filter(unoriented_times).count(), 0, "soups are not timed");
    }
}
