//! The series: of every method, and of naive 32-bit arithmetic.

use super::chart::{Chart, Panel, Series};
use super::naive;
use super::sweeps::{self, Sweep};
use crate::cell::{Aspect, Found, Outcome};
use crate::matrix::aspects;
use crate::truth::Truth;
use crate::{edges, pictures};
use silhouette_compare::registry::{Entry, Registry};
use silhouette_core::SilhouetteEdges;
use silhouette_render::Gpu;

/// What naive arithmetic is called.
const NAIVE: &str = "naive 32 bits";

/// Points of a series along a sweep; values that there are none of are left out.
fn series(name: &str, sweep: &Sweep, value: impl Fn(&Truth<'_>) -> Option<f64>) -> Series {
    let points = sweep.scenes.iter().filter_map(|(x, scene)| Some([*x, value(&Truth::new(scene))?]));
    Series { name: name.to_owned(), is_control: name == NAIVE, points: points.collect() }
}

/// Eyes around each scene in which edges are counted.
const EYES: u32 = 16;

/// The edges that are misclassified from all eyes, as a share of the silhouette edges that there are.
fn misclassified(scenes: &[Truth<'_>], found: impl Fn(&Truth<'_>) -> Option<SilhouetteEdges>) -> Option<f64> {
    let (mut wrong, mut all) = (0, 0);
    for truth in scenes {
        wrong += edges::missed_and_spurious(&found(truth)?, truth.edges()).iter().sum::<usize>();
        all += truth.edges().len();
    }
    Some(wrong as f64 / all.max(1) as f64)
}

/// Misclassified edges, as a share of the silhouette edges that exact arithmetic finds from 16 eyes around the mesh.
pub fn edges() -> Chart {
    let registry = Registry::builtin();
    let panel = |sweep: Sweep, eyes: u32| {
        let mut all: Vec<Series> = Vec::new();
        let mut add = |name: &str, found: &dyn Fn(&Truth<'_>) -> Option<SilhouetteEdges>| {
            let points = sweep.scenes.iter().filter_map(|(x, scene)| {
                let scenes = sweeps::around(scene, eyes);
                let truths: Vec<Truth<'_>> = scenes.iter().map(Truth::new).collect();
                Some([*x, misclassified(&truths, found)?])
            });
            all.push(Series { name: name.to_owned(), is_control: name == NAIVE, points: points.collect() });
        };
        add(NAIVE, &|truth| Some(naive::edges(truth.scene)));
        for entry in registry.entries().iter().filter(|entry| entry.capabilities().edges) {
            add(entry.info().name, &|truth| edges::extracted(entry, truth).ok());
        }
        Panel { label: sweep.label, series: all }
    };
    // The eye above a face's plane is what its sweep is about.
    let height = panel(sweeps::height(), 1);
    let sweeps = [sweeps::offset(), sweeps::scale(), sweeps::distance(), sweeps::aspect()];
    Chart {
        file: "misclassified-edges.svg",
        y_label: "misclassified edges over silhouette edges",
        panels: sweeps.into_iter().map(|sweep| panel(sweep, EYES)).chain([height]).collect(),
    }
}

/// How far vertices are from where they should be in the picture.
pub fn places() -> Chart {
    let panel = |sweep: Sweep| {
        let of = |which: usize| {
            move |truth: &Truth<'_>| {
                let range = truth.scene.camera.clip_range(&truth.placed.mesh().bounds()?);
                Some(naive::displacements_px(truth.scene, &truth.scene.view(range).ok()?)[which])
            }
        };
        let all = vec![series(NAIVE, &sweep, of(0)), series("all methods here", &sweep, of(1))];
        Panel { label: sweep.label, series: all }
    };
    let sweeps = [sweeps::offset(), sweeps::scale(), sweeps::distance()];
    Chart {
        file: "displaced-vertices.svg",
        y_label: "farthest displacement of a vertex, in px of 96",
        panels: sweeps.into_iter().map(panel).collect(),
    }
}

/// Lost lines, and errors of outlines.
pub fn pictures(gpu: &Gpu) -> Vec<Chart> {
    let sweeps = || [sweeps::offset(), sweeps::scale(), sweeps::distance(), sweeps::aspect(), sweeps::depth_bits()];
    let lost = |entry: &Entry, truth: &Truth<'_>| match pictures::line_metrics(gpu, entry, truth) {
        Ok(metrics) => Some(metrics.missed_1px.max(metrics.spurious_1px)),
        Err(Found { outcome: Outcome::Empty, .. }) => Some(1.0),
        Err(_) => None,
    };
    let outline = |entry: &Entry, truth: &Truth<'_>| match pictures::fill_metrics(gpu, entry, truth) {
        Ok(metrics) => Some(metrics.boundary_hausdorff_95_px),
        Err(_) => None,
    };
    vec![
        Chart {
            file: "lost-lines.svg",
            y_label: "line missed or ink spurious, the larger share",
            panels: sweeps()
                .into_iter()
                .map(|sweep| panel(Aspect::Lines, Some(&lost_naively), &sweep, &lost))
                .collect(),
        },
        Chart {
            file: "outlines.svg",
            y_label: "distance that 95 % of the outline keep, in px",
            panels: sweeps().into_iter().map(|sweep| panel(Aspect::Fill, None, &sweep, &outline)).collect(),
        },
    ]
}

/// The share of the visible lines whose edges naive arithmetic does not find.
fn lost_naively(truth: &Truth<'_>) -> Option<f64> {
    let (found, lines) = (naive::edges(truth.scene), truth.lines().ok()?);
    let lost = lines.samples.iter().filter(|sample| !found.contains(sample.edge));
    Some(lost.map(|sample| sample.length_px).sum::<f64>() / lines.total_length_px().max(f64::MIN_POSITIVE))
}

type OfTruth<'a> = &'a dyn Fn(&Truth<'_>) -> Option<f64>;
type OfMethod<'a> = &'a dyn Fn(&Entry, &Truth<'_>) -> Option<f64>;

/// Every method that yields this along a sweep, after the control.
fn panel(aspect: Aspect, control: Option<OfTruth<'_>>, sweep: &Sweep, value: OfMethod<'_>) -> Panel {
    let mut all: Vec<Series> = control.map(|control| series(NAIVE, sweep, control)).into_iter().collect();
    for entry in Registry::builtin().entries().iter().filter(|entry| aspects(entry).contains(&aspect)) {
        all.push(series(entry.info().name, sweep, |truth| value(entry, truth)));
    }
    Panel { label: sweep.label, series: all }
}
