//! L. Wang, C. Tu, W. Wang, X. Meng, B. Chan, D. Yan, "Silhouette Smoothing for Real-time Rendering of Mesh Surfaces", 2008:
//! Table I, the figures that compare methods, and the equations.
//!
//! The paper prints triangle counts and frames per second of a GeForce 7800 GT, for coarse meshes that are not available, and
//! neither the tolerance nor the views. Beside each row stands a built-in mesh with exactly as many faces, or the file of a model
//! of that name, simplified; the growth in triangles is a range over views and tolerances. What the paper shows as pictures is
//! measured here: outlines against fine meshes, and how polygonal they are close by.
//!
//! 1. `printed`: Table I. `subjects`: what is drawn for it. `window`: how it is seen.
//! 2. `measure`: Table I of a mesh. `copies`: sixty of them in a frame; `timed`: the methods in turn; `growth`: triangles;
//!    `steps`: what each step of smoothing takes.
//! 3. `drawn`: Figs. 22 and 24. `outlines`: spheres.
//! 4. `equations`: as printed and corrected. `tangents`: Eq. 1; `residuals`: Eq. 7; `sampled`: Eq. 8; `cells`: clusters;
//!    `lowered`: perturbation.
//! 5. `table_one` and `rows`: the tables.

mod cells;
mod copies;
mod drawn;
mod equations;
mod growth;
mod lowered;
mod measure;
mod outlines;
mod printed;
mod residuals;
mod rows;
mod sampled;
mod steps;
mod subjects;
mod table_one;
mod tangents;
mod timed;
mod window;

use self::drawn::PaperFigure;
use self::measure::MeshResult;
use self::subjects::Subject;
use self::window::Window;
use crate::chart::Chart;
use crate::chart::bars::{self, Bar};
use crate::error::{Cause, PaperError};
use crate::paper::{Measured, Paper, Run};
use crate::table::Table;
use silhouette_core::{Method, Progress};
use silhouette_render::Gpu;
use silhouette_smoothing::Smoothing;

/// The paper.
pub static PAPER: Paper = Paper {
    name: Smoothing::INFO.name,
    source: Smoothing::INFO.source,
    about: "The paper's triangle counts and frame rates stand beside ours, and beside what it shows as pictures only: how far \
            outlines are from those of fine meshes, how polygonal they are close by, and what its equations yield as printed.",
    reading: &[
        "A built-in mesh with exactly as many faces stands in for a model of the paper: a sphere, a knot, a torus, a blob for the \
         bear and a fine one for the hippo. A file is drawn as it is if it has 600 faces or fewer. Otherwise it is simplified, to \
         the faces of the paper's model of that name or to 500, drawn as that, and once in full.",
        "Sixty copies of a coarse mesh lie at the same place, each turned by another angle and smoothed for itself, with pipelines \
         and mesh buffers shared. Direct drawing is PN triangles with no points inserted: the same vertices and the same shader. \
         What methods add to that shows in ratios; how much of a frame goes to covering pixels depends on the device.",
        "The paper triangulates the visible part of silhouette triangles; here the invisible part counts as well, \
         except, on closed meshes, its triangles that are seen from behind, which are left out. Growth depends on the tolerance, which the \
         paper leaves open between 0.5 and 2 px.",
        "Of the paper's 4 % it is not known whether the time of one copy or of sixty is meant, or how fast its processor was beside \
         its card. The share of the CPU's time is the stricter reading.",
    ],
    default_meshes: &subjects::DEFAULT_MESHES,
    needs_gpu: true,
    measure,
};

const FIG_22: &str = "Fig. 22";
const FIG_24: &str = "Fig. 24";

/// Draws a figure of a mesh.
type Draw = fn(&Gpu, &Subject, &Window, &dyn Progress) -> Result<PaperFigure, Cause>;

fn measure(run: &Run<'_>) -> Result<Measured, PaperError> {
    let (gpu, progress) = (run.gpu()?, run.progress);
    let (subjects, mut notes) = subjects::subjects(run.meshes)?;
    let mut meshes = Vec::new();
    for subject in subjects {
        let label = subject.label.clone();
        let result = measure::measure(gpu, run.profile, subject, progress);
        meshes.push(result.map_err(PaperError::of::<Cause>(&label))?);
    }
    let adapter = &gpu.adapter().name;
    let growth_and_rates = [table_one::table_one(adapter, &meshes), table_one::ratios(adapter, &meshes)];
    let mut measured = Measured {
        setting: "1280 x 800 pixels, frames by all methods in turn in the same run".to_owned(),
        tables: growth_and_rates
            .into_iter()
            .chain([table_one::by_tolerance(&meshes), table_one::steps(&meshes)])
            .collect(),
        ..Measured::default()
    };
    for (model, name, draw) in [("Knot", FIG_22, drawn::fig_22 as Draw), ("Bear", FIG_24, drawn::fig_24)] {
        match of_model(&meshes, model) {
            Some(MeshResult { subject, window, .. }) => {
                progress.stage(name, 1);
                let figure = draw(gpu, subject, window, progress).map_err(PaperError::of::<Cause>(&subject.label))?;
                progress.advance(1);
                let about = format!("{} faces, {}; outlines at 16 samples per pixel", subject.faces(), subject.origin);
                measured.tables.push(rows::figure(name, subject.label.clone(), about, &figure));
                measured.pictures.extend(figure.pictures);
            }
            None => notes.push(format!(
                "{name} is not drawn: none of these meshes is a {} that a fine one is known for",
                model.to_lowercase()
            )),
        }
    }
    measured.tables.extend(equations::measure(&meshes, progress)?);
    measured.charts = charts(&measured.tables);
    measured.notes = notes;
    Ok(measured)
}

/// The first coarse mesh that stands for a model and whose fine surface is known.
fn of_model<'a>(meshes: &'a [MeshResult], model: &str) -> Option<&'a MeshResult> {
    let stands_for = |mesh: &&MeshResult| mesh.subject.row.is_some_and(|row| row.model == model);
    meshes.iter().filter(|mesh| mesh.subject.fine.is_some()).find(stands_for)
}

fn charts(tables: &[Table]) -> Vec<Chart> {
    let bar = |metric, title, end, step, asked| Bar { metric, deviation: None, title, end, step, asked };
    let ratios = [
        bar(table_one::OVER_DIRECT, "frame rate over direct drawing", 1.5, 0.25, Some(1.0)),
        bar(table_one::OVER_PN, "frame rate over PN triangles", 4.0, 1.0, Some(1.0)),
    ];
    let outline = bar(rows::OUTLINE.metric, "outline off the fine mesh, px", 10.0, 2.0, None);
    let polygonal = bar(rows::POLYGONAL.metric, "outline off its own limit, px (95 %)", 5.0, 1.0, Some(1.0));
    let named = |word: &'static str| tables.iter().filter(move |table| table.name.starts_with(word));
    vec![
        Chart {
            file_name: "rates.svg",
            title: "Smoothing in perspective, frame rates",
            svg: bars::draw(named(table_one::RATIOS), &ratios),
        },
        Chart {
            file_name: "outlines.svg",
            title: "Fig. 22: how far outlines are from those of fine meshes",
            svg: bars::draw(named(FIG_22), &[outline]),
        },
        Chart {
            file_name: "close.svg",
            title: "Fig. 24: how polygonal outlines are",
            svg: bars::draw(named(FIG_24), &[polygonal]),
        },
    ]
}
