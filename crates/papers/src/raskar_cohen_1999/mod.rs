//! R. Raskar and M. Cohen, "Image precision silhouette edges", 1999: the frame rates of section 5, and what the pictures show.
//!
//! The paper prints frames per second with and without silhouettes on three models that are not available. Frame times over
//! plain rendering stand beside its ratios, on built-in meshes of the same size and on any mesh that is named. The paper
//! measures no picture; here every variant is scored by its width, what it misses, what it adds and what shows through from
//! behind, and on spheres beside what follows from the geometry.
//!
//! 1. `printed`: the paper's numbers. `variants`: what is drawn.
//! 2. `measure`: every variant of every mesh. `score`: one picture; `timed`: frames over plain ones; `lost`: faces
//!    that a picture is too coarse for; `soup`: triangles whose winding says nothing.
//! 3. `spheres`: icospheres from many sides, beside the ink that `derived` and `fattened` compute without drawing.
//! 4. `rows`: the tables.

mod derived;
mod fattened;
mod lost;
mod measure;
mod printed;
mod rows;
mod score;
mod soup;
mod spheres;
mod timed;
mod variants;

use crate::error::{Cause, PaperError};
use crate::paper::{Measured, Paper, Run};
use silhouette_core::Method;
use silhouette_image_precision::ImagePrecision;

/// The paper.
pub static PAPER: Paper = Paper {
    name: ImagePrecision::INFO.name,
    source: ImagePrecision::INFO.source,
    about: "The paper's frame rates over plain rendering stand beside ours, and beside what it does not print: how wide each \
            variant's lines are, what they miss, and what shows through from behind.",
    reading: &[
        "Plain rendering draws all faces once, in one colour. The paper's fattening subdivided polygons on the CPU; here \
         the GPU does it.",
        "Lines are asked for 2 pixels wide; variants that pull have no width of their own. The true lines are the exact \
         visible silhouette, drawn with the method's own pen. A one-sided pen inks both sides where the silhouette of a fine \
         mesh zigzags, so that spurious ink is underestimated there; stray ink is not.",
        "Unoriented variants draw a soup: the same triangles without shared vertices, in a random order, half of them turned \
         inside out.",
    ],
    default_meshes: &["builtin:blob:5672", "builtin:blob:13408", "builtin:machine-room"],
    needs_gpu: true,
    measure,
};

/// Levels of the icospheres that are drawn.
const LEVELS: std::ops::RangeInclusive<u32> = 2..=5;

fn measure(run: &Run<'_>) -> Result<Measured, PaperError> {
    let (gpu, progress) = (run.gpu()?, run.progress);
    let meshes = measure::meshes(run, gpu)?;
    progress.stage("icospheres", LEVELS.count() as u64);
    let spheres = LEVELS.map(|level| spheres::measure(gpu, level, spheres::VIEWS, progress)).collect::<Result<_, _>>();
    let spheres: Vec<_> = spheres.map_err(PaperError::of::<Cause>("icospheres"))?;
    Ok(rows::measured(&gpu.adapter().name, &meshes, &spheres))
}
