//! [`Refinement::refine`]: measures more values of swept options, where the front of time and error is coarse, as long as time remains.
//!
//! Which value is next follows from what was measured ([`gap`]). Each that is measured becomes a cell of the scene: a
//! comparison of the refined scene measures the same cells without refining. Every value is measured on all meshes, since a front of
//! one mesh is of little use beside one of others with other values.

use super::gap::{self, Candidate, Errors};
use super::run::ShardError;
use super::store::CellStore;
use crate::machine::RunDescription;
use crate::record::Cell;
use crate::registry::Registry;
use crate::runner::{Bench, CompareConfig, Comparison, Subject};
use crate::scene::cells::MAX_CHOICES;
use crate::scene::{MethodSpec, OptionSpread, Scene};
use silhouette_core::Progress;
use silhouette_render::Gpu;
use std::time::{Duration, Instant};

/// How long to refine, and in which errors.
#[derive(Debug, Clone, Copy)]
pub struct Budget {
    /// Time of measuring, beyond that of the scene's own cells. What was measured before an interruption counts with the time that it
    /// took then. A value is begun only where what remains is expected to suffice.
    pub time: Duration,
    /// The errors of the fronts.
    pub errors: Errors,
}

/// What a comparison is refined with.
pub struct Refinement<'a> {
    /// What was asked for.
    pub config: &'a CompareConfig,
    /// The meshes.
    pub subjects: &'a [Subject],
    /// The methods.
    pub registry: &'a Registry,
    /// What draws.
    pub gpu: &'a Gpu,
    /// Where it stands, and what may stop it.
    pub progress: &'a dyn Progress,
}

impl Refinement<'_> {
    /// Adds cells to a comparison whose own are in `store`, which keeps the others too; yields how many values were added. Cells and
    /// the methods of the scene stay in one order.
    ///
    /// # Errors
    /// [`ShardError`]; what was finished before is in the store.
    pub fn refine(&self, store: &CellStore, comparison: &mut Comparison, budget: &Budget) -> Result<usize, ShardError> {
        let run = RunDescription::of_this_process(self.gpu.adapter());
        let mut benches: Vec<Option<Bench<'_>>> = self.subjects.iter().map(|_| None).collect();
        let mut spent = Duration::ZERO;
        let mut added = 0;
        while self.config.methods().len() + added < MAX_CHOICES {
            let Some(candidate) = gap::next(&comparison.cells, &budget.errors, self.registry) else { break };
            let spec = spec_of(&candidate);
            let scene = Scene { methods: vec![spec.clone()], ..self.config.scene().clone() };
            let config = CompareConfig::new(scene, self.registry)?;
            let kept = store.nested(store.key().with_methods(&config))?;
            let cells = kept.key().cells();
            let is_whole = (0..cells).all(|cell| kept.holds(cell));
            if !is_whole && spent + expected(&comparison.cells, &candidate.method) > budget.time {
                break;
            }
            for cell in (0..cells).filter(|&cell| !kept.holds(cell)).collect::<Vec<_>>() {
                let (mesh, method) = (cell / config.methods().len(), cell % config.methods().len());
                let start = Instant::now();
                if benches[mesh].is_none() {
                    let subject = &self.subjects[mesh];
                    benches[mesh] = Some(Bench::new(self.config.scene(), subject, self.gpu, self.progress)?);
                }
                let Some(bench) = &mut benches[mesh] else { continue };
                let outcome = bench.run_cell(&config.methods()[method])?;
                kept.put(cell, &run, start.elapsed(), &outcome)?;
            }
            for cell in 0..cells {
                let kept = kept.read(cell)?;
                spent += kept.took;
                comparison.add(&kept.run, kept.outcome);
            }
            let methods = &mut comparison.scene.methods;
            let last = methods.iter().rposition(|other| other.name == spec.name);
            methods.insert(last.map_or(methods.len(), |last| last + 1), spec);
            added += 1;
        }
        self.arrange(comparison)?;
        Ok(added)
    }

    /// Puts cells, with their pictures, in the order in which their scene would have measured them.
    fn arrange(&self, comparison: &mut Comparison) -> Result<(), ShardError> {
        let config = CompareConfig::new(comparison.scene.clone(), self.registry)?;
        let place = |cell: &Cell| {
            let mesh = self.subjects.iter().position(|subject| subject.mesh.name == cell.mesh.name);
            let method = config.methods().iter().position(|choice| {
                choice.entry.info().name == cell.method
                    && choice.picture == cell.picture
                    && crate::options::OptionSettings::from(&choice.options) == cell.options
            });
            (mesh, method)
        };
        let cells = std::mem::take(&mut comparison.cells);
        let mut paired: Vec<_> = cells.into_iter().zip(std::mem::take(&mut comparison.pictures)).collect();
        paired.sort_by_key(|(cell, _)| place(cell));
        (comparison.cells, comparison.pictures) = paired.into_iter().unzip();
        Ok(())
    }
}

fn spec_of(candidate: &Candidate) -> MethodSpec {
    let options = candidate.options.0.iter().map(|(name, value)| (name.clone(), OptionSpread::One(value.clone())));
    MethodSpec { name: candidate.method.clone(), options: options.collect() }
}

/// How long a value of a method takes on all meshes, going by its slowest cell on each.
fn expected(cells: &[Cell], method: &str) -> Duration {
    let milliseconds = |cell: &Cell| {
        let frames = f64::from(cell.frame.frames) * cell.frame.frame_ms.median;
        cell.prepare.prepare_ms + cell.prepare.renderer_ms + frames
    };
    let mut slowest: Vec<(&str, f64)> = Vec::new();
    for cell in cells.iter().filter(|cell| cell.method == method) {
        match slowest.iter_mut().find(|(mesh, _)| *mesh == cell.mesh.name) {
            Some((_, slowest)) => *slowest = slowest.max(milliseconds(cell)),
            None => slowest.push((&cell.mesh.name, milliseconds(cell))),
        }
    }
    Duration::try_from_secs_f64(slowest.iter().map(|(_, ms)| ms).sum::<f64>() / 1000.0).unwrap_or(Duration::MAX)
}
