//! Table I beside ours, in three tables: triangles and frame rates, ratios of frame rates, and triangles by tolerance; and the
//! shares of the steps, of which the paper says that they are below 4 %.

use super::growth::{Growth, OVER_VIEWS, TOLERANCES_PX};
use super::measure::MeshResult;
use super::printed::{COPIES, LARGEST_SHARE_PERCENT, PaperFps, PaperRow, ROWS};
use super::timed::FrameTimes;
use super::window::{KINDS, Kind};
use crate::table::{Cell, Column, Comparable, Range, Row, Table};

/// The table of the paper.
pub const TABLE: &str = "Table I";

/// The table of ratios.
pub const RATIOS: &str = "Table I, ratios of its frame rates";

/// Metrics that charts read.
pub const OVER_DIRECT: &str = "frame rate over direct drawing";
/// As [`OVER_DIRECT`].
pub const OVER_PN: &str = "frame rate over PN triangles";

/// The card that the paper's frames were drawn by.
const PAPER_CARD: &str = "a GeForce 7800 GT";

const COUNT: Column = Column { digits: 0, ..Column::new("", "", "", "") };
const FPS: Column = Column { digits: 1, unit: "frames/s", ..COUNT };

const COLUMNS: [Column; 9] = [
    Column { title: "faces", metric: "triangles", meaning: "faces of the mesh", ..COUNT },
    Column {
        title: "PN",
        metric: "triangles, PN",
        meaning: "triangles that PN triangles draw, at the paper's level",
        ..COUNT
    },
    Column {
        title: "ours",
        metric: "triangles, smoothing",
        meaning: "triangles that smoothing draws in perspective at a tolerance of 1 px",
        ..COUNT
    },
    GROWTH,
    Column {
        title: "direct",
        metric: "frame rate, direct drawing",
        meaning: "frames per second of the mesh as it is, with interpolated normals; from the median time",
        ..FPS
    },
    Column {
        title: "boundary curve",
        metric: "frame rate, boundary curves",
        meaning: "the same by the method of B. Wang et al. 2003, as far as the paper describes it",
        ..FPS
    },
    Column { title: "PN", metric: "frame rate, PN triangles", meaning: "the same by PN triangles", ..FPS },
    Column {
        title: "ours, ortho",
        metric: "frame rate, smoothing, orthographic",
        meaning: "the same by smoothing, in parallel projection",
        ..FPS
    },
    Column {
        title: "ours, persp.",
        metric: "frame rate, smoothing, perspective",
        meaning: "the same by smoothing, in perspective",
        ..FPS
    },
];

/// Triangles drawn by smoothing over those of the mesh.
pub const GROWTH: Column =
    Column::new("growth", "growth", "×", "triangles that smoothing draws over those of the mesh");

const RATIO_COLUMNS: [Column; 5] = [
    ratio("ours/direct", OVER_DIRECT, "frame rate of smoothing in perspective over that of direct drawing"),
    ratio("ours/boundary curve", "frame rate over boundary curves", "the same over that of boundary curves"),
    ratio("ours/PN", OVER_PN, "the same over that of PN triangles"),
    ratio(
        "PN/direct",
        "frame rate of PN triangles over direct drawing",
        "frame rate of PN triangles over that of direct drawing",
    ),
    ratio(
        "persp./ortho",
        "frame rate, perspective over orthographic",
        "frame rate of smoothing in perspective over that in parallel projection",
    ),
];

const fn ratio(title: &'static str, metric: &'static str, meaning: &'static str) -> Column {
    Column::new(title, metric, "×", meaning)
}

/// Triangles and frame rates of every mesh, then what the paper prints of models that nothing stands for.
pub fn table_one(adapter: &str, meshes: &[MeshResult]) -> Table {
    let missing = |row: &&PaperRow| meshes.iter().all(|mesh| mesh.subject.row != Some(*row));
    let printed_only = ROWS.iter().filter(missing).map(|row| {
        let cells = printed_counts(row).into_iter().chain(rates(&row.fps));
        let cell = |value| {
            Cell::default().beside(Some(value), Comparable::Yes).noted("not measured: the model is not available")
        };
        Row::new(row.model, cells.map(cell).collect())
    });
    Table {
        name: TABLE,
        about: format!(
            "{COPIES} copies of coarse meshes, fine ones once; 1280 x 800 pixels, of which the mesh covers half; counts over \
             {OVER_VIEWS}, at a tolerance of 1 px; {adapter} draws"
        ),
        columns: COLUMNS.to_vec(),
        rows: meshes.iter().map(|mesh| row(adapter, mesh)).chain(printed_only).collect(),
        ..Table::default()
    }
}

fn printed_counts(row: &PaperRow) -> [f64; 4] {
    [f64::from(row.triangles), f64::from(row.pn_triangles), f64::from(row.ours), row.growth()]
}

fn rates(fps: &PaperFps) -> [f64; 5] {
    [fps.direct, fps.boundary_curve, fps.pn, fps.orthographic, fps.perspective]
}

fn ours(times: &FrameTimes) -> PaperFps {
    let fps = |time: super::copies::FrameTime| 1e3 / time.frame_ms;
    PaperFps {
        direct: fps(times.direct),
        boundary_curve: fps(times.boundary_curve),
        pn: fps(times.pn),
        orthographic: fps(times.orthographic),
        perspective: fps(times.perspective),
    }
}

/// Triangles at the default tolerance.
fn default_growth(mesh: &MeshResult, kind: Kind) -> Option<&Growth> {
    mesh.growth.iter().find(|growth| growth.tolerance_px == TOLERANCES_PX[1] && growth.kind == kind)
}

fn over_faces(triangles: Range, faces: usize) -> Range {
    let share = |count: f64| count / faces as f64;
    let Range { least, median, most, over } = triangles;
    Range { least: share(least), median: share(median), most: share(most), over }
}

fn row(adapter: &str, mesh: &MeshResult) -> Row {
    let subject = &mesh.subject;
    let faces = subject.faces();
    let printed = subject.row.map(printed_counts);
    let of_printed = |at: usize| printed.map(|counts| counts[at]);
    let is_equal = subject.row.is_some_and(|row| row.triangles as usize == faces);
    let counted =
        if is_equal { Comparable::Yes } else { Comparable::No("the mesh has another number of faces".to_owned()) };
    let drawn = default_growth(mesh, Kind::Perspective).map(|growth| growth.triangles);
    let by_view = Comparable::No("the paper's mesh, its view and its tolerance are not known".to_owned());
    let segments = f64::from(subject.pn_level + 1);
    let counts = [
        Cell::one(faces as f64).beside(of_printed(0), counted.clone()).noted(subject.origin.clone()),
        Cell::one(faces as f64 * segments * segments).beside(of_printed(1), counted),
        Cell::range(drawn).beside(of_printed(2), by_view.clone()),
        Cell::range(drawn.map(|drawn| over_faces(drawn, faces))).beside(of_printed(3), by_view),
    ];
    let other_card = Comparable::No(format!("{adapter} draws instead of {PAPER_CARD}"));
    let printed = subject.row.map(|row| rates(&row.fps));
    let rates = rates(&ours(&mesh.times)).into_iter().enumerate();
    let rates = rates.map(|(at, fps)| Cell::one(fps).beside(printed.map(|fps| fps[at]), other_card.clone()));
    Row::new(subject.label.clone(), counts.into_iter().chain(rates).collect())
}

/// Ratios of frame rates.
pub fn ratios(adapter: &str, meshes: &[MeshResult]) -> Table {
    let of = |fps: &PaperFps| {
        [
            fps.perspective / fps.direct,
            fps.perspective / fps.boundary_curve,
            fps.perspective / fps.pn,
            fps.pn / fps.direct,
            fps.perspective / fps.orthographic,
        ]
    };
    let why = Comparable::No(format!(
        "ratios depend on the hardware, here {adapter} with a processor of today, there {PAPER_CARD}; and on the model"
    ));
    let row = |mesh: &MeshResult| {
        let printed = mesh.subject.row.map(|row| of(&row.fps));
        let cells = of(&ours(&mesh.times)).into_iter().enumerate();
        let cells = cells.map(|(at, ratio)| Cell::one(ratio).beside(printed.map(|ratios| ratios[at]), why.clone()));
        Row::new(mesh.subject.label.clone(), cells.collect())
    };
    Table { name: RATIOS, columns: RATIO_COLUMNS.to_vec(), rows: meshes.iter().map(row).collect(), ..Table::default() }
}

/// Growth by tolerance and projection: the range that the paper's counts have to be seen in.
pub fn by_tolerance(meshes: &[MeshResult]) -> Table {
    const TITLES: [(&str, &str); 3] =
        [("0.5 px", "growth at 0.5 px"), ("1 px", "growth at 1 px"), ("2 px", "growth at 2 px")];
    let columns = TITLES.map(|(title, metric)| Column { title, metric, ..GROWTH });
    let rows = meshes.iter().flat_map(|mesh| {
        KINDS.map(|kind| {
            let of_kind = mesh.growth.iter().filter(|growth| growth.kind == kind);
            let cell = |growth: &Growth| Cell::range(Some(over_faces(growth.triangles, mesh.subject.faces())));
            let word = if kind == Kind::Orthographic { "orthographic" } else { "perspective" };
            Row::new(format!("{}, {word}", mesh.subject.label), of_kind.map(cell).collect())
        })
    });
    Table {
        name: "growth by tolerance",
        about: format!("triangles drawn over those of the mesh, over {OVER_VIEWS}"),
        columns: columns.to_vec(),
        rows: rows.collect(),
        ..Table::default()
    }
}

/// What each step takes on the CPU.
pub fn steps(meshes: &[MeshResult]) -> Table {
    let us = |title, metric, meaning| Column { digits: 1, ..Column::new(title, metric, "µs", meaning) };
    let percent = |title, metric, meaning| Column::new(title, metric, "%", meaning);
    let columns = vec![
        Column {
            title: "silhouette triangles",
            metric: "silhouette triangles",
            meaning: "averaged over the views",
            ..COUNT
        },
        us("extraction", "time of extraction", "visibility of vertices and silhouette triangles, for one copy"),
        us("curves", "time of curves", "silhouette points and segments"),
        us("sampling", "time of sampling", "number of samples of each curve"),
        us("re-meshing", "time of re-meshing", "samples and triangles, whole faces included"),
        us("perturbation", "time of perturbation", "planes of concave segments and moved vertices"),
        Column {
            digits: 0,
            ..Column::new(
                "all",
                "time per silhouette triangle",
                "ns",
                "all steps over the number of silhouette triangles",
            )
        },
        percent("extraction", "extraction, share of CPU", "of the time of all steps"),
        percent("perturbation", "perturbation, share of CPU", "of the time of all steps"),
        percent("extraction", "extraction, share of the frame", "of a whole frame, drawing and waiting included"),
        percent("perturbation", "perturbation, share of the frame", "of a whole frame, drawing and waiting included"),
    ];
    let row = |mesh: &MeshResult| {
        let steps = &mesh.steps;
        let frame_us = 1e3 * mesh.times.perspective.frame_ms / mesh.subject.copies as f64;
        let share = |part: f64, all: f64| Cell::one(100.0 * part / all);
        let bound = || {
            let why = "the paper says less than 4 %, for meshes that it does not single out, on hardware of 2007";
            Comparable::No(why.to_owned())
        };
        let cells = vec![
            Cell::one(steps.silhouette_triangles),
            Cell::one(steps.extraction_us),
            Cell::one(steps.curves_us),
            Cell::one(steps.sampling_us),
            Cell::one(steps.remeshing_us),
            Cell::one(steps.perturbation_us),
            Cell::one(steps.ns_per_silhouette_triangle()),
            share(steps.extraction_us, steps.total_us()),
            share(steps.perturbation_us, steps.total_us()),
            share(steps.extraction_us, frame_us).beside(Some(LARGEST_SHARE_PERCENT), bound()),
            share(steps.perturbation_us, frame_us).beside(Some(LARGEST_SHARE_PERCENT), bound()),
        ];
        Row::new(mesh.subject.label.clone(), cells)
    };
    Table {
        name: "V. Experiments, shares of the steps",
        about: "one copy in perspective, along a path of fifty views a degree apart; one thread".to_owned(),
        columns,
        rows: meshes.iter().map(row).collect(),
        ..Table::default()
    }
}

#[cfg(test)]
mod tests {
    use super::super::copies::FrameTime;
    use super::super::steps::Steps;
    use super::super::subjects::{Subject, subjects};
    use super::super::window::Window;
    use super::*;
    use crate::figure::{Figure, figures};
    use silhouette_compare::NamedMesh;
    use silhouette_core::{PreparedMesh, shapes};
    use std::sync::Arc;

    /// The stand-in for the torus with made-up values: each method takes twice as long as the last, 1000 triangles are drawn.
    fn made_up() -> MeshResult {
        let mesh = Arc::new(PreparedMesh::new(shapes::by_name("torus:24,12").unwrap()));
        let window = Window::unmagnified(mesh.mesh().bounds().unwrap());
        let named = NamedMesh { name: "builtin:torus:24,12".to_owned(), mesh };
        let subject: Subject = subjects(&[named]).unwrap().0.remove(0);
        let time = |frame_ms| FrameTime { prepare_ms: 0.1, frame_ms };
        let times = FrameTimes {
            direct: time(1.0),
            boundary_curve: time(2.0),
            pn: time(4.0),
            orthographic: time(8.0),
            perspective: time(16.0),
        };
        let growth = TOLERANCES_PX.into_iter().flat_map(|tolerance_px| {
            KINDS.map(|kind| Growth { tolerance_px, kind, triangles: Range::of([1000.0], OVER_VIEWS).unwrap() })
        });
        let steps = Steps {
            extraction_us: 1.0,
            curves_us: 4.0,
            sampling_us: 2.0,
            remeshing_us: 2.0,
            perturbation_us: 1.0,
            silhouette_triangles: 100.0,
        };
        MeshResult { subject, window, times, growth: growth.collect(), steps }
    }

    fn all() -> (Vec<Table>, Vec<Figure>) {
        let meshes = [made_up()];
        let adapter = "an adapter";
        let tables = vec![table_one(adapter, &meshes), ratios(adapter, &meshes), by_tolerance(&meshes), steps(&meshes)];
        let figures = figures("smoothing", &tables);
        (tables, figures)
    }

    #[test]
    fn counts_of_the_same_number_of_faces_are_comparable_and_nothing_else_is() {
        let (_, figures) = all();
        for figure in figures.iter().filter(|figure| figure.ours.is_some() && figure.paper.is_some()) {
            let is_count = ["triangles", "triangles, PN"].contains(&figure.metric.as_str());
            assert_eq!(figure.comparable, is_count, "{figure:?}");
            assert!(!is_count || figure.ratio == Some(1.0), "{figure:?}");
            assert!(is_count || figure.note.contains("not comparable"), "{figure:?}");
        }
        let printed_only = figures.iter().filter(|figure| figure.ours.is_none()).count();
        assert_eq!(printed_only, COLUMNS.len() * (ROWS.len() - 1), "models that nothing stands for");
    }

    #[test]
    fn every_value_stands_under_its_column() {
        let (tables, figures) = all();
        assert!(tables.iter().all(|table| table.rows.iter().all(|row| row.cells.len() == table.columns.len())));
        for (row, metric, expected) in [
            ("Torus", "triangles, PN", 5184.0),
            ("Torus", "growth", 1000.0 / 576.0),
            ("Torus", "frame rate, direct drawing", 1000.0),
            ("Torus", "frame rate, smoothing, perspective", 62.5),
            ("Torus", OVER_DIRECT, 1.0 / 16.0),
            ("Torus", OVER_PN, 0.25),
            ("Torus", "frame rate, perspective over orthographic", 0.5),
            ("Torus, orthographic", "growth at 2 px", 1000.0 / 576.0),
            ("Torus", "time per silhouette triangle", 100.0),
            ("Torus", "extraction, share of CPU", 10.0),
            ("Torus", "extraction, share of the frame", 100.0 * 60.0 / 16_000.0),
        ] {
            let found = figures.iter().find(|figure| figure.row == row && figure.metric == metric);
            let ours = found.and_then(|figure| figure.ours).unwrap_or(f64::NAN);
            assert!((ours - expected).abs() < 1e-9, "{row}, {metric}: {ours}");
        }
    }
}
