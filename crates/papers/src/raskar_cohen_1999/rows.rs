//! The tables: the paper's frame rates beside ours, then what its pictures show.

use super::lost::{FINE_PX, Lost, SIZES_PX};
use super::measure::{MeshResult, VariantResult};
use super::printed::{PaperRow, ROWS};
use super::score::Score;
use super::soup::SoupResult;
use super::spheres::{Around, SphereResult, VIEWS};
use super::variants::{UNORIENTED, VARIANTS};
use crate::chart::Chart;
use crate::chart::bars::{self, Bar};
use crate::paper::Measured;
use crate::table::{Cell, Column, Comparable, Range, Row, Table};

/// The section of the paper that holds its frame rates.
const PERFORMANCE: &str = "5. Performance";

/// What the ranges are over.
const OVER_VIEWS: &str = "twelve views spread evenly";

const fn column(title: &'static str, metric: &'static str, unit: &'static str, meaning: &'static str) -> Column {
    Column { title, metric, unit, digits: 2, meaning }
}

const RATE: Column = Column {
    digits: 3,
    ..column("rate", "frame rate over plain rendering", "×", "frame rate with silhouettes over that without, 0 to 1")
};
const WIDTH: Column = column("width", "mean width", "px", "mean width of the drawn lines where they are drawn");
const DEVIATION: Column = column("deviation", "deviation of width", "px", "standard deviation of that width");
const THROUGH: Column =
    column("through", "shows through", "%", "ink farther than 5 px from every silhouette edge, visible or not");
const TIME: Column = column(
    "time",
    "frame time over plain rendering",
    "×",
    "median frame time over that of plain rendering of all faces, in the same run",
);
const TIME_CULLED: Column = column(
    "time, culled",
    "frame time over plain rendering of front faces",
    "×",
    "median frame time over that of plain rendering with back faces culled, in the same run",
);
const SCORES: [Column; 9] = [
    WIDTH,
    DEVIATION,
    column("ink/length", "ink over length", "px", "all ink over the length of all visible lines"),
    column("missed", "missed at 1 px", "%", "visible length without ink within 1 px"),
    column("spurious", "spurious at 1 px", "%", "ink farther than 1 px from the true pen"),
    column("stray", "stray", "%", "ink farther than the pen's width and 1 px from every visible line"),
    column("gaps", "gaps", "per 1000 px", "stretches longer than 1 px without ink"),
    THROUGH,
    Column {
        digits: 0,
        ..column("farthest", "farthest ink", "px", "distance of the farthest ink from every silhouette edge")
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

/// Everything that was measured.
pub struct Results {
    /// The adapter that drew.
    pub adapter: String,
    /// The meshes.
    pub meshes: Vec<MeshResult>,
    /// Spheres, one list of variants per level.
    pub spheres: Vec<Vec<SphereResult>>,
    /// Level of an icosphere, and the shares of its front faces that pictures lose, one per view; often empty.
    pub lost: (u32, Vec<[f64; 3]>),
    /// A soup of a million triangles, one per variant of [`UNORIENTED`]; often empty.
    pub soups: Vec<SoupResult>,
}

/// What was measured, as tables and a chart.
pub fn measured(results: &Results) -> Measured {
    let mut tables = vec![performance(results)];
    for mesh in &results.meshes {
        tables.extend([pictures(mesh), smooth_pictures(mesh), lost_faces(mesh)]);
    }
    tables.push(spheres(&results.spheres));
    let of_many = [lost_over_views(&results.lost), soup(&results.soups)];
    tables.extend(of_many.into_iter().filter(|table| !table.rows.is_empty()));
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
    let size = results.meshes.first().map_or(0, |mesh| mesh.size_px);
    Measured {
        setting: format!("{size} x {size} pixels, frames over plain rendering in the same run"),
        notes: Vec::new(),
        charts: vec![Chart { file_name: "variants.svg", title: "Width, and what shows through", svg }],
        tables,
    }
}

/// Frame rate with silhouettes over the rate without, of each row of the paper and of the mesh that stands in for its model.
fn performance(Results { adapter, meshes, .. }: &Results) -> Table {
    let row = |row: &PaperRow| {
        let mesh = meshes.iter().find(|mesh| mesh.name == row.stand_in);
        let ours = mesh.and_then(|mesh| rate_kept(mesh, row.variant));
        let why = format!(
            "the models are not available, built-in meshes with as many triangles stand in for them; {adapter} draws \
             instead of an InfiniteReality"
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

const LOST: &str = "lost faces";
const LOST_SHARE: Column =
    column("lost", "front faces lost", "%", "front faces visible at 4096 x 4096 pixels that the picture lacks");

fn lost_faces(mesh: &MeshResult) -> Table {
    const fn pixels(title: &'static str, metric: &'static str) -> Column {
        let meaning = "pixels that it inks and its oriented counterpart does not, on the consistently wound mesh";
        Column { digits: 0, ..column(title, metric, "px", meaning) }
    }
    let extra = [
        pixels(UNORIENTED[0].variant.label, "ink of unoriented by lost faces"),
        pixels(UNORIENTED[1].variant.label, "ink of unoriented, screen by lost faces"),
    ];
    let row = |lost: &Lost| {
        let cells = [100.0 * lost.share].into_iter().chain(lost.extra_px.map(|pixels| pixels as f64));
        Row::new(size_name(lost.size_px), cells.map(Cell::one).collect())
    };
    Table {
        name: LOST,
        subject: mesh.name.clone(),
        columns: [LOST_SHARE].into_iter().chain(extra).collect(),
        rows: mesh.lost.iter().map(row).collect(),
        ..Table::default()
    }
}

fn size_name(size_px: u32) -> String {
    format!("{size_px} x {size_px}")
}

fn spheres(levels: &[Vec<SphereResult>]) -> Table {
    let far = |title, metric, meaning| Column { digits: 0, ..column(title, metric, "px", meaning) };
    let columns = vec![
        column("drawn", "ink over outline", "px", "ink over the length of the smooth sphere's outline"),
        column("derived", "ink over outline, derived", "px", "the same from the geometry, nothing drawn"),
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

fn lost_over_views((level, shares): &(u32, Vec<[f64; 3]>)) -> Table {
    let row = |(at, size_px): (usize, u32)| {
        let range = Range::of(shares.iter().map(|shares| 100.0 * shares[at]), OVER_VIEWS)?;
        Some(Row::new(size_name(size_px), vec![Cell::range(Some(range))]))
    };
    Table {
        name: LOST,
        subject: format!("icosphere {level}"),
        about: format!(
            "ranges over {VIEWS} views spread evenly, 45°, 3 radii away; beside the fine picture, {FINE_PX} px a side"
        ),
        columns: vec![LOST_SHARE],
        rows: SIZES_PX.into_iter().enumerate().filter_map(row).collect(),
        ..Table::default()
    }
}

fn soup(soups: &[SoupResult]) -> Table {
    let share = |count: usize, all: usize| 100.0 * count as f64 / all.max(1) as f64;
    let row = |soup: &SoupResult| {
        let values = [soup.ink_px as f64, share(soup.false_px, soup.ink_px), share(soup.lacking_px, soup.expected_px)];
        Row::new(soup.variant.label, values.map(Cell::one).to_vec())
    };
    Table {
        name: "soup of a million triangles",
        about: soups.first().map_or_else(String::new, |soup| {
            format!("{} triangles in a random order, half of them turned, beside the oriented mesh", soup.triangles)
        }),
        columns: vec![
            Column { digits: 0, ..column("ink", "ink", "px", "pixels with ink") },
            column("false", "false ink", "%", "ink of the soup that the oriented mesh does not have"),
            column("lacking", "ink that lacks", "%", "ink of the oriented mesh that the soup does not have"),
        ],
        rows: soups.iter().map(row).collect(),
        ..Table::default()
    }
}

#[cfg(test)]
mod tests {
    use super::super::measure::tests::measured as meshes;
    use super::*;
    use crate::figure::figures;

    /// The measured mesh, and made-up values of everything else.
    fn results(test: &str) -> Option<Results> {
        let around = |width_px| Around { width_px, farthest_px: Some(40.0) };
        let sphere =
            SphereResult { variant: VARIANTS[0], level: 2, drawn: vec![around(2.0)], derived: vec![around(3.0)] };
        let soup = SoupResult {
            variant: UNORIENTED[0].variant,
            triangles: 9,
            ink_px: 8,
            expected_px: 4,
            false_px: 6,
            lacking_px: 1,
        };
        Some(Results {
            adapter: "an adapter".to_owned(),
            meshes: meshes(test)?.to_vec(),
            spheres: vec![vec![sphere]],
            lost: (4, vec![[0.1, 0.2, 0.3], [0.3, 0.2, 0.1]]),
            soups: vec![soup],
        })
    }

    #[test]
    fn printed_rates_stand_beside_stand_ins_that_are_not_comparable() {
        let test = "printed_rates_stand_beside_stand_ins_that_are_not_comparable";
        let Some(results) = results(test) else { return };
        let figures = figures("image-precision", &measured(&results).tables);
        let printed: Vec<_> = figures.iter().filter(|figure| figure.paper.is_some()).collect();
        assert_eq!(printed.len(), ROWS.len());
        for figure in printed {
            let is_venus = figure.row.starts_with("Venus");
            assert_eq!((figure.ours.is_some(), figure.comparable, figure.ratio), (is_venus, false, None), "{figure:?}");
            let reason = if is_venus { "an adapter draws instead of an InfiniteReality" } else { "not measured: name" };
            assert!(figure.note.contains(reason), "{figure:?}");
        }
    }

    #[test]
    fn every_variant_has_its_scores_and_all_values_are_numbers() {
        let Some(results) = results("every_variant_has_its_scores_and_all_values_are_numbers") else { return };
        let tables = measured(&results).tables;
        let names: Vec<_> = tables.iter().map(|table| (table.name, table.rows.len())).collect();
        let [all, oriented] = [VARIANTS.len() + UNORIENTED.len(), VARIANTS.len()];
        let expected = [
            (PERFORMANCE, 5),
            (PICTURES, all),
            ("pictures, 4 samples per pixel", oriented),
            (LOST, 3),
            ("spheres", 1),
            (LOST, 3),
            ("soup of a million triangles", 2 - 1),
        ];
        assert_eq!(names, expected);
        assert!(tables.iter().all(|table| table.rows.iter().all(|row| row.cells.len() == table.columns.len())));
        let figures = figures("image-precision", &tables);
        let of = |row: &str, metric: &str| {
            let found = figures.iter().find(|figure| figure.row == row && figure.metric == metric);
            found.unwrap_or_else(|| panic!("{row}, {metric}")).ours.unwrap()
        };
        assert_eq!(of("unoriented", "false ink"), 75.0);
        assert_eq!(of("unoriented", "ink that lacks"), 25.0);
        assert_eq!(of("icosphere 4, 256 x 256", "front faces lost, most"), 30.0);
        assert_eq!(of("icosphere 2, screen", "ink over outline, derived"), 3.0);
    }
}
