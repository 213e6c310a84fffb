//! Every row times every method.

use crate::cell::{Aspect, Cell, Found, Outcome};
use crate::row::Row;
use crate::scene::Scene;
use crate::truth::Truth;
use crate::{curves, edges, pictures};
use silhouette_compare::registry::{BASELINE, Entry, Registry};
use silhouette_render::Gpu;
use std::any::Any;
use std::collections::HashMap;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// How much farther than in the plain case pictures may be from the truth, as a share of its lines or of its area.
pub const SHARE_BOUND: f64 = 0.02;

/// How much farther curves may be from the truth than in the plain case, in pixels.
pub const CURVE_BOUND_PX: f64 = 0.5;

/// What a method is looked at for. Edges are drawn by one renderer, whoever found them: [`BASELINE`] stands for all.
pub fn aspects(entry: &Entry) -> Vec<Aspect> {
    let can = entry.capabilities();
    let has = |aspect: &Aspect| match aspect {
        Aspect::Edges => can.edges,
        Aspect::Curves => can.curves,
        Aspect::Lines => can.lines || entry.info().name == BASELINE,
        Aspect::Fill => can.fill,
    };
    Aspect::ALL.into_iter().filter(has).collect()
}

/// Errors in the plain case, by plain scene, method and aspect.
type Plain = HashMap<(&'static str, &'static str, Aspect), Option<f64>>;

/// All cells of some rows. A panic becomes the fault of its cell.
pub fn run(gpu: &Gpu, rows: &[Row]) -> Vec<Cell> {
    let registry = Registry::builtin();
    let mut plain = Plain::new();
    let mut cells = Vec::new();
    for row in rows {
        let scene = made(|| (row.scene)());
        let truth = scene.as_ref().map(Truth::new);
        let plain_scene = made(|| Ok((row.plain)()));
        let plain_truth = plain_scene.as_ref().map(Truth::new);
        for entry in registry.entries() {
            let method = entry.info().name;
            for aspect in aspects(entry) {
                let found = caught(|| {
                    let truth = truth.as_ref().map_err(|found| (*found).clone())?;
                    let plain_truth = plain_truth.as_ref().map_err(|found| (*found).clone())?;
                    if row.is_about_options && !truth.scene.concerns(entry.info().options) {
                        return Ok(Found::new(Outcome::NotApplicable, ""));
                    }
                    if aspect == Aspect::Edges {
                        return Ok(edges::found(entry, truth));
                    }
                    let key = (row.plain_name, method, aspect);
                    let error = error(gpu, entry, aspect, truth)?;
                    let known = plain.entry(key);
                    let plain = *known.or_insert_with(|| error_or_none(gpu, entry, aspect, plain_truth));
                    Ok(judged(aspect, error, plain))
                });
                cells.push(Cell { row: row.name, method, aspect, found });
            }
        }
    }
    cells
}

/// The cells whose outcome is not the expected one, as sentences. Of a row about options, methods that have none of them are not
/// concerned.
pub fn surprises(rows: &[Row], cells: &[Cell]) -> Vec<String> {
    let row_of = |cell: &Cell| rows.iter().find(|row| row.name == cell.row);
    let surprise = |cell: &Cell| {
        let Some(row) = row_of(cell) else { return Some(format!("no row is called {}", cell.row)) };
        let expected = row.expected_of(cell.method, cell.aspect).outcome;
        let Found { outcome, text } = &cell.found;
        let is_unconcerned = row.is_about_options && *outcome == Outcome::NotApplicable;
        (*outcome != expected && !is_unconcerned).then(|| {
            let (found, expected) = (outcome.word(), expected.word());
            format!("{}, {} {}: {found} ({text}), not {expected}", cell.row, cell.method, cell.aspect.name())
        })
    };
    cells.iter().filter_map(surprise).collect()
}

/// Makes a scene; a panic is the fault of all its cells.
fn made(scene: impl FnOnce() -> Result<Scene, Found>) -> Result<Scene, Found> {
    let made = catch_unwind(AssertUnwindSafe(scene));
    made.unwrap_or_else(|panic| Err(Found::fault(format!("panicked: {}", message(&*panic)))))
}

/// Runs a cell; a panic is its fault.
fn caught(cell: impl FnOnce() -> Result<Found, Found>) -> Found {
    let found = catch_unwind(AssertUnwindSafe(cell));
    found.map_or_else(
        |panic| Found::fault(format!("panicked: {}", message(&*panic))),
        |found| found.unwrap_or_else(|found| found),
    )
}

fn message(panic: &(dyn Any + Send)) -> String {
    let text = panic.downcast_ref::<&str>().map(|text| (*text).to_owned());
    text.or_else(|| panic.downcast_ref::<String>().cloned()).unwrap_or_default()
}

/// How far a method is from the truth. Of lines, the larger of the shares that are missed and spurious, at 1 pixel; of filled pictures,
/// the area that is covered by one of picture and truth alone, over that of the truth; of curves, a distance in pixels.
fn error(gpu: &Gpu, entry: &Entry, aspect: Aspect, truth: &Truth<'_>) -> Result<f64, Found> {
    match aspect {
        Aspect::Edges | Aspect::Curves => curves::distance_px(entry, truth),
        Aspect::Lines => {
            let metrics = pictures::line_metrics(gpu, entry, truth)?;
            Ok(metrics.missed_1px.max(metrics.spurious_1px))
        }
        Aspect::Fill => Ok(pictures::fill_metrics(gpu, entry, truth)?.xor_share),
    }
}

fn error_or_none(gpu: &Gpu, entry: &Entry, aspect: Aspect, truth: &Truth<'_>) -> Option<f64> {
    error(gpu, entry, aspect, truth).ok()
}

/// An outcome by how much larger the error is than in the plain case.
fn judged(aspect: Aspect, error: f64, plain: Option<f64>) -> Found {
    let bound = if aspect == Aspect::Curves { CURVE_BOUND_PX } else { SHARE_BOUND };
    let outcome = if error <= plain.unwrap_or(0.0) + bound { Outcome::Same } else { Outcome::Differs };
    let text = if aspect == Aspect::Curves { format!("{error:.1} px") } else { format!("{:.1} %", 100.0 * error) };
    Found::new(outcome, text)
}
