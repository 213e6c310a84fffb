//! L. Wang, C. Tu, W. Wang, X. Meng, B. Chan, D. Yan, "Silhouette Smoothing for Real-time Rendering of Mesh Surfaces", 2008.

mod copies;
mod growth;
mod measure;
mod printed;
mod steps;
mod subjects;
mod table_one;
mod timed;
mod window;

use crate::error::{Cause, PaperError};
use crate::paper::{Measured, Paper, Run};
use silhouette_core::Method;
use silhouette_smoothing::Smoothing;

/// The paper.
pub static PAPER: Paper = Paper {
    name: Smoothing::INFO.name,
    source: Smoothing::INFO.source,
    about: "",
    reading: &[],
    default_meshes: &subjects::DEFAULT_MESHES,
    needs_gpu: true,
    measure,
};

fn measure(run: &Run<'_>) -> Result<Measured, PaperError> {
    let (gpu, progress) = (run.gpu()?, run.progress);
    let (subjects, notes) = subjects::subjects(run.meshes)?;
    let mut meshes = Vec::new();
    for subject in subjects {
        let label = subject.label.clone();
        let result = measure::measure(gpu, run.profile, subject, progress);
        meshes.push(result.map_err(PaperError::of::<Cause>(&label))?);
    }
    let adapter = &gpu.adapter().name;
    let tables = vec![
        table_one::table_one(adapter, &meshes),
        table_one::ratios(adapter, &meshes),
        table_one::by_tolerance(&meshes),
        table_one::steps(&meshes),
    ];
    Ok(Measured { setting: String::new(), notes, tables, charts: Vec::new() })
}
