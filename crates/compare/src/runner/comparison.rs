//! [`Comparison`]: what a comparison found.

use crate::machine::RunDescription;
use crate::metrics::PictureKind;
use crate::options::OptionSettings;
use crate::record::Cell;
use crate::registry::Entry;
use crate::scaling::ExtractionRow;
use crate::scene::Scene;
use silhouette_render::Image;

/// What a comparison found.
#[derive(Debug, Clone)]
pub struct Comparison {
    /// What was asked for.
    pub scene: Scene,
    /// Machines, adapters and programs that measured, each once: one, where no [sweep](crate::sweep) was merged of several.
    pub runs: Vec<RunDescription>,
    /// The methods in the order in which they are reported, each once.
    pub methods: Vec<Entry>,
    /// One cell per mesh and choice of a method with options, in this order.
    pub cells: Vec<Cell>,
    /// One set of pictures per cell, in the same order.
    pub pictures: Vec<PictureSet>,
    /// What is missing: methods that refuse a mesh. Neither cells nor pictures hold anything of them.
    pub left_out: Vec<LeftOut>,
    /// Extraction timings of other tools or other runs, for the report; [`run`](super::run()) leaves it empty.
    pub peers: Vec<ExtractionRow>,
}

/// What measuring a cell yields.
#[derive(Debug, Clone)]
pub enum Outcome {
    /// Numbers and pictures.
    Measured {
        /// The numbers.
        cell: Box<Cell>,
        /// The pictures.
        pictures: Box<PictureSet>,
    },
    /// The method is not defined for the mesh.
    LeftOut(LeftOut),
}

impl Comparison {
    /// A comparison that holds nothing yet.
    pub(crate) fn new(scene: Scene) -> Self {
        Self {
            scene,
            runs: Vec::new(),
            methods: Vec::new(),
            cells: Vec::new(),
            pictures: Vec::new(),
            left_out: Vec::new(),
            peers: Vec::new(),
        }
    }

    /// Adds a method unless it is there.
    pub(crate) fn add_method(&mut self, entry: &Entry) {
        if self.methods.iter().all(|known| known.info().name != entry.info().name) {
            self.methods.push(entry.clone());
        }
    }

    /// Adds the next cell, measured by `run`.
    pub(crate) fn add(&mut self, run: &RunDescription, outcome: Outcome) {
        let known = self.runs.iter().position(|known| known == run);
        let run = known.unwrap_or_else(|| {
            self.runs.push(run.clone());
            self.runs.len() - 1
        });
        match outcome {
            Outcome::Measured { cell, pictures } => {
                self.cells.push(Cell { run, ..*cell });
                self.pictures.push(*pictures);
            }
            Outcome::LeftOut(left_out) => self.left_out.push(left_out),
        }
    }
}

/// A method that a comparison leaves out on a mesh, because it is not defined for it.
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct LeftOut {
    /// Name of the mesh.
    pub mesh: String,
    /// Name of the method.
    pub method: String,
    /// Why, with the elements at fault.
    pub reason: String,
}

impl std::fmt::Display for LeftOut {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { mesh, method, reason } = self;
        write!(f, "{mesh}: {method} is left out: {reason}")
    }
}

/// Pictures of the [worst scored view](Cell::worst_view) of a cell.
#[derive(Debug, Clone)]
pub struct PictureSet {
    /// Name of the mesh.
    pub mesh: String,
    /// Name of the method.
    pub method: String,
    /// Its options.
    pub options: OptionSettings,
    /// What the pictures show.
    pub picture: PictureKind,
    /// Which of the timed frames.
    pub frame: u32,
    /// What the method drew.
    pub drawn: Image,
    /// What was to be drawn.
    pub truth: Image,
    /// False colours, see [`picture::difference`](crate::picture::difference()).
    pub difference: Image,
}
