//! The comparison: methods with their options x meshes, along one camera path.
//!
//! For each mesh:
//!
//! 1. the [truth](truths) of every scored frame, once for all methods;
//! 2. for each method with its options, on a mesh that nothing was derived from yet: preparation, timed;
//! 3. the [path followed](follow): warm-up frames, then timed frames; what a scored frame shows is kept right after it was
//!    drawn. Further passes, where the scene asks for them, are of times alone, and of all methods in turn;
//! 4. [motions](crate::coherence) followed for coherence, where the scene asks for them, outside of the clock;
//! 5. pictures kept against the truth of their cameras, edges found against edges to be found.

mod bench;
pub mod coherence_truth;
mod coherent;
pub mod comparison;
pub mod error;
pub mod follow;
pub mod frame_source;
pub mod subject;
pub mod truths;

pub use crate::scene::model::DEFAULT_PEN_WIDTH_PX;
use bench::Begun;
pub(crate) use bench::Bench;
pub use comparison::{Comparison, LeftOut, Outcome, PictureSet};
pub use error::CompareError;
pub use subject::{NamedMesh, SimplifyFault, Subject};

use crate::machine::RunDescription;
use crate::registry::Registry;
use crate::scene::cells::choices;
use crate::scene::{MethodChoice, Scene, SceneFault};
use silhouette_core::Progress;
use silhouette_render::Gpu;

/// What is compared, and how thoroughly: a scene whose methods and options are known to exist.
#[derive(Debug, Clone)]
pub struct CompareConfig {
    scene: Scene,
    methods: Vec<MethodChoice>,
}

impl CompareConfig {
    /// Checks a scene and looks its methods up in `registry`.
    ///
    /// # Errors
    /// [`SceneFault`]: a value, a method or an option does not fit.
    pub fn new(scene: Scene, registry: &Registry) -> Result<Self, SceneFault> {
        scene.check()?;
        let methods = choices(&scene, registry)?;
        Ok(Self { scene, methods })
    }

    /// The scene.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// The methods with their options, in the order in which they are reported.
    pub fn methods(&self) -> &[MethodChoice] {
        &self.methods
    }
}

/// Runs every method with its options on every mesh; the scene's own list of meshes plays no part. Takes about a minute per mesh
/// with [`Profile::Quick`](crate::Profile::Quick) on two cores without a graphics card; memory for one mesh at a time.
///
/// # Errors
/// [`CompareError`]; a failing method fails the comparison. One that is not defined for a mesh does not: it is listed as
/// [left out](Comparison::left_out).
pub fn run(
    config: &CompareConfig,
    subjects: &[Subject],
    gpu: &Gpu,
    progress: &dyn Progress,
) -> Result<Comparison, CompareError> {
    let mut comparison = Comparison::new(config.scene.clone());
    config.methods.iter().for_each(|choice| comparison.add_method(&choice.entry));
    let run = RunDescription::of_this_process(gpu.adapter());
    run_cells(config, subjects, gpu, progress, &|_| true, &mut |_, outcome| {
        comparison.add(&run, outcome);
        Ok::<(), CompareError>(())
    })?;
    Ok(comparison)
}

/// Measures the cells that are due, and hands each to `keep` as soon as it is finished. Cells are numbered from 0: all methods on the
/// first mesh, then all on the second, and so on.
pub(crate) fn run_cells<E: From<CompareError>>(
    config: &CompareConfig,
    subjects: &[Subject],
    gpu: &Gpu,
    progress: &dyn Progress,
    is_due: &dyn Fn(usize) -> bool,
    keep: &mut dyn FnMut(usize, Outcome) -> Result<(), E>,
) -> Result<(), E> {
    check(subjects)?;
    let methods = config.methods.len();
    for (at, subject) in subjects.iter().enumerate() {
        let due: Vec<usize> = (0..methods).filter(|method| is_due(at * methods + method)).collect();
        if due.is_empty() {
            continue;
        }
        let mut bench = Bench::new(&config.scene, subject, gpu, progress)?;
        let mut begun = Vec::new();
        for method in due {
            let cell = at * methods + method;
            match bench.begin(&config.methods[method])? {
                Begun::LeftOut(left_out) => keep(cell, Outcome::LeftOut(left_out))?,
                Begun::Cell(once) if config.scene.path.passes == 1 => keep(cell, bench.finish(*once))?,
                Begun::Cell(once) => begun.push((cell, once)),
            }
        }
        // Further passes of all cells in turn, so that those of one lie apart and whatever slows the machine for a while slows all alike.
        for _ in 1..config.scene.path.passes {
            for (_, begun) in &mut begun {
                bench.follow_again(begun)?;
            }
        }
        for (cell, begun) in begun {
            keep(cell, bench.finish(*begun))?;
        }
    }
    Ok(())
}

fn check(subjects: &[Subject]) -> Result<(), CompareError> {
    if subjects.is_empty() {
        return Err(CompareError::NoMesh);
    }
    let mut names: Vec<&str> = subjects.iter().map(|subject| subject.mesh.name.as_str()).collect();
    names.sort_unstable();
    if let Some(pair) = names.windows(2).find(|pair| pair[0] == pair[1]) {
        return Err(CompareError::SameName { name: pair[0].to_owned() });
    }
    let faces = |subject: &Subject| subject.truth.as_ref().unwrap_or(subject.mesh.mesh.mesh()).face_count();
    let is_empty = |subject: &&Subject| faces(subject) == 0 || subject.mesh.mesh.mesh().face_count() == 0;
    match subjects.iter().find(is_empty) {
        Some(subject) => Err(CompareError::EmptyMesh { mesh: subject.mesh.name.clone() }),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests;
