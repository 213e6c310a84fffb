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
        let scene = (row.scene)();
        let truth = scene.as_ref().map(Truth::new);
        let plain_scene = (row.plain)();
        let plain_truth = Truth::new(&plain_scene);
        for entry in registry.entries() {
            let method = entry.info().name;
            for aspect in aspects(entry) {
                if std::env::var_os("TRACE").is_some() { eprintln!("{method} {}", aspect.name()); }
                let found = caught(|| {
                    let truth = truth.as_ref().map_err(|found| (*found).clone())?;
                    if row.is_about_options && !truth.scene.concerns(entry.info().options) {
                        return Ok(Found::new(Outcome::NotApplicable, ""));
                    }
                    if aspect == Aspect::Edges {
                        return Ok(edges::found(entry, truth));
                    }
                    let key = (row.plain_name, method, aspect);
                    let error = error(gpu, entry, aspect, truth)?;
                    let known = plain.entry(key);
                    let plain = *known.or_insert_with(|| error_or_none(gpu, entry, aspect, &plain_truth));
                    Ok(judged(aspect, error, plain))
                });
                cells.push(Cell { row: row.name, method, aspect, found });
            }
        }
    }
    cells
}

/// Runs a cell; a panic is its fault.
fn caught(cell: impl FnOnce() -> Result<Found, Found>) -> Found {
    let found = catch_unwind(AssertUnwindSafe(cell));
    found.map_or_else(|panic| Found::fault(format!("panicked: {}", message(&*panic))), |found| {
        found.unwrap_or_else(|found| found)
    })
}

fn message(panic: &(dyn Any + Send)) -> String {
    let text = panic.downcast_ref::<&str>().map(|text| (*text).to_owned());
    text.or_else(|| panic.downcast_ref::<String>().cloned()).unwrap_or_default()
}

fn error(gpu: &Gpu, entry: &Entry, aspect: Aspect, truth: &Truth<'_>) -> Result<Option<f64>, Found> {
    match aspect {
        Aspect::Edges | Aspect::Curves => curves::distance_px(entry, truth),
        Aspect::Lines => pictures::line_error(gpu, entry, truth),
        Aspect::Fill => pictures::fill_error(gpu, entry, truth),
    }
}

fn error_or_none(gpu: &Gpu, entry: &Entry, aspect: Aspect, truth: &Truth<'_>) -> Option<f64> {
    error(gpu, entry, aspect, truth).ok().flatten()
}

/// The error of a method in a scene that is plain.
pub fn plain_error(gpu: &Gpu, entry: &Entry, aspect: Aspect, scene: &Scene) -> Option<f64> {
    error_or_none(gpu, entry, aspect, &Truth::new(scene))
}

/// An outcome by how much larger the error is than in the plain case.
fn judged(aspect: Aspect, error: Option<f64>, plain: Option<f64>) -> Found {
    let Some(error) = error else { return Found::new(Outcome::Empty, "") };
    let bound = if aspect == Aspect::Curves { CURVE_BOUND_PX } else { SHARE_BOUND };
    let outcome = if error <= plain.unwrap_or(0.0) + bound { Outcome::Same } else { Outcome::Differs };
    let text = if aspect == Aspect::Curves { format!("{error:.1} px") } else { format!("{:.1} %", 100.0 * error) };
    Found::new(outcome, text)
}
