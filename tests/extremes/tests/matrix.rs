//! Every method at every extreme does what is expected of it, and `docs/STABILITY.md` says so.

use silhouette_docs::region::replaced;
use silhouette_extremes::cell::{Aspect, Found, Outcome};
use silhouette_extremes::families::{ALL, Family};
use silhouette_extremes::row::{Row, Who};
use silhouette_extremes::scene::Scene;
use silhouette_extremes::{growth, matrix, meshes, page};
use silhouette_testing::gpu_or_skip;
use std::path::Path;

fn check(title: &str) {
    let Some(gpu) = gpu_or_skip(title) else { return };
    let family: &Family = ALL.iter().find(|family| family.title == title).unwrap();
    let rows = (family.rows)();
    let cells = matrix::run(gpu, &rows);
    assert!(cells.len() >= 26 * rows.len(), "{} cells in {} rows", cells.len(), rows.len());
    let surprises = matrix::surprises(&rows, &cells);
    assert!(surprises.is_empty(), "{}", surprises.join("\n"));
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(page::FILE);
    let committed = std::fs::read_to_string(file).unwrap();
    let made = replaced(&committed, title, &page::section(family, &rows, &cells)).unwrap();
    let (committed, made) = (page::comparable(&committed), page::comparable(&made));
    let first = committed.lines().zip(made.lines()).find(|(committed, made)| committed != made);
    assert!(committed == made, "cargo run -p silhouette-extremes writes another page: {first:#?}");
}

macro_rules! families {
    ($($name:ident: $title:literal),*) => {
        $(#[test] fn $name() { check($title); })*

        #[test]
        fn every_family_is_checked() {
            assert_eq!(ALL.each_ref().map(|family| family.title), [$($title),*]);
        }
    };
}

families! {
    scale_and_offset: "Scale and offset",
    places_of_the_eye: "Places of the eye",
    bad_triangles: "Bad triangles",
    topology: "Topology",
    projection_and_model_matrices: "Projection and model matrices",
    depth: "Depth",
    viewport_and_widths: "Viewport and widths",
    parameters_of_methods: "Parameters of methods"
}

/// Every outcome but exact, same and an evident one has its reason.
#[test]
fn no_outcome_is_unexplained() {
    let mut explained = 0;
    for family in &ALL {
        for row in (family.rows)() {
            for expectation in &row.expected {
                let is_evident = matches!(expectation.outcome, Outcome::Exact | Outcome::Same | Outcome::Refused);
                assert!(is_evident || !expectation.why.is_empty(), "{}: {expectation:?}", row.name);
                explained += usize::from(!expectation.why.is_empty());
            }
        }
    }
    assert!(explained > 50, "{explained}");
}

/// Charts that no device has a part in are the same bits; those of pictures are there, and no others.
#[test]
fn committed_charts_are_those_of_the_code() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(growth::FOLDER);
    let charts = growth::exact_charts();
    for chart in &charts {
        let committed = std::fs::read_to_string(folder.join(chart.file)).unwrap();
        assert!(committed == chart.svg(), "cargo run -p silhouette-extremes -- --charts draws another {}", chart.file);
        let of =
            |wanted: bool| chart.panels.iter().flat_map(|panel| &panel.series).filter(move |s| s.is_control == wanted);
        let worst = |points: &[[f64; 2]]| points.iter().map(|point| point[1]).fold(0.0, f64::max);
        assert!(of(true).any(|control| worst(&control.points) > 0.05), "{}: naive arithmetic errs", chart.file);
        let exact = of(false).filter(|series| series.name != "randomized");
        assert!(exact.into_iter().all(|series| worst(&series.points) < 1e-4), "{}: ours does not", chart.file);
    }
    let mut found: Vec<_> = folder.read_dir().unwrap().map(|file| file.unwrap().file_name()).collect();
    found.sort();
    assert_eq!(found, ["displaced-vertices.svg", "lost-lines.svg", "misclassified-edges.svg", "outlines.svg"]);
}

/// A wrong expectation, and a panic, are seen.
#[test]
fn what_is_not_expected_is_seen() {
    let Some(gpu) = gpu_or_skip("what_is_not_expected_is_seen") else { return };
    let torus = || Scene::of(meshes::torus()).with_options(["concavity=0"]);
    let row = || Row::new("plain", "the torus", torus).about_options();
    let wrong = row().expect(Who::Every(Aspect::Edges), Outcome::Differs, "a control");
    let refused = Row::fallible("refused", "nothing", || Err(Found::new(Outcome::Refused, "a line"))).about_options();
    let panics = Row::fallible("panics", "a scene that panics", || panic!("a control"));
    let panics_beside = row().beside("none", || panic!("a control"));
    for (row, count) in [(row(), 0), (wrong, 1), (refused, 26), (panics, 26), (panics_beside, 26)] {
        let rows = [row];
        assert_eq!(matrix::surprises(&rows, &matrix::run(gpu, &rows)).len(), count, "{}", rows[0].name);
    }
}
