//! What a paper supplies, what it gets for a run, and what the run yields.

use crate::chart::Chart;
use crate::error::{Cause, PaperError};
use crate::picture::Picture;
use crate::table::Table;
use silhouette_compare::machine::{describe_machine, describe_program};
use silhouette_compare::{NamedMesh, Profile};
use silhouette_core::Progress;
use silhouette_core::method::Source;
use silhouette_render::Gpu;

/// A paper whose figures are measured again.
#[derive(Debug)]
pub struct Paper {
    /// Name on the command line and in results: that of the method that the paper introduces.
    pub name: &'static str,
    /// Authors, title, venue and year.
    pub source: Source,
    /// What stands beside what, in one or two sentences: the head of the page.
    pub about: &'static str,
    /// How to read the tables, in paragraphs.
    pub reading: &'static [&'static str],
    /// Meshes that are measured where none is named, as the command line names them.
    pub default_meshes: &'static [&'static str],
    /// Whether [`Run::gpu`] has to be there.
    pub needs_gpu: bool,
    /// Measures.
    pub measure: fn(&Run<'_>) -> Result<Measured, PaperError>,
}

/// What a paper is measured with.
#[derive(Clone, Copy)]
pub struct Run<'a> {
    /// How much is measured.
    pub profile: Profile,
    /// What is measured, at least one mesh.
    pub meshes: &'a [NamedMesh],
    /// The device that draws, for papers that [need one](Paper::needs_gpu).
    pub gpu: Option<&'a Gpu>,
    /// Where progress goes.
    pub progress: &'a dyn Progress,
}

/// What the measurement for a paper yields.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Measured {
    /// How it was measured, in one sentence without a full stop.
    pub setting: String,
    /// What the reader has to know of this run: that the paper's model is not among the meshes, for example.
    pub notes: Vec<String>,
    /// The tables, in the order in which they are read.
    pub tables: Vec<Table>,
    /// Charts of the tables.
    pub charts: Vec<Chart>,
    /// Pictures, in the order in which they are looked at.
    pub pictures: Vec<Picture>,
}

/// What was measured for a paper, and where.
#[derive(Debug, Clone)]
pub struct Reproduction {
    /// The paper.
    pub paper: &'static Paper,
    /// How much was measured.
    pub profile: Profile,
    /// The machine in one line.
    pub machine: String,
    /// The graphics adapter in one line, where something was drawn.
    pub adapter: Option<String>,
    /// The program in one line.
    pub program: String,
    /// What was measured.
    pub measured: Measured,
}

impl Run<'_> {
    /// The device.
    ///
    /// # Errors
    /// [`Cause::NoGpu`].
    pub fn gpu(&self) -> Result<&Gpu, Cause> {
        self.gpu.ok_or(Cause::NoGpu)
    }
}

impl Paper {
    /// Measures, and describes where that was done.
    ///
    /// # Errors
    /// [`PaperError`]: no mesh, a mesh that cannot be measured, a cancelled run, or a device that failed.
    pub fn reproduce(&'static self, run: &Run<'_>) -> Result<Reproduction, PaperError> {
        if run.meshes.is_empty() {
            return Err(Cause::NoMesh.into());
        }
        if let Some(empty) = run.meshes.iter().find(|named| named.mesh.mesh().face_count() == 0) {
            return Err(PaperError::of(&empty.name)(Cause::EmptyMesh));
        }
        let measured = (self.measure)(run)?;
        let gpu = run.gpu.filter(|_| self.needs_gpu);
        Ok(Reproduction {
            paper: self,
            profile: run.profile,
            machine: describe_machine(),
            adapter: gpu.map(|gpu| gpu.adapter().to_string()),
            program: describe_program(),
            measured,
        })
    }

    /// Authors, title, venue and year, as a citation.
    pub fn citation(&self) -> String {
        let Source { authors, title, venue, year } = self.source;
        format!("{authors}, “{title}”, {venue}, {year}")
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::table::tests::table;
    use silhouette_core::{NoProgress, PreparedMesh, TriangleMesh, glam};
    use silhouette_render::Image;
    use std::sync::Arc;

    static PAPER: Paper = Paper {
        name: "method",
        source: Source { authors: "A. <Author>", title: "Title", venue: "Venue", year: 1999 },
        about: "About the paper.",
        reading: &["How to read it."],
        default_meshes: &["builtin:cube"],
        needs_gpu: true,
        measure: |run| {
            run.gpu()?;
            Ok(Measured::default())
        },
    };

    /// A reproduction that was not measured, with names that would break out of a page.
    pub fn reproduction() -> Reproduction {
        let text = |text: &str| text.to_owned();
        let chart = Chart { file_name: "chart.svg", title: "A chart", svg: text("<svg></svg>") };
        let measured = Measured {
            setting: text("a setting"),
            notes: vec![text("the model is not among these meshes")],
            tables: vec![table()],
            charts: vec![chart],
            pictures: vec![Picture {
                file_name: "picture.png",
                title: text("a <picture>"),
                image: Image { width: 1, height: 1, rgba: vec![255; 4] },
            }],
        };
        Reproduction {
            paper: &PAPER,
            profile: Profile::Quick,
            machine: text("a <processor>"),
            adapter: Some(text("an adapter")),
            program: text("a program"),
            measured,
        }
    }

    #[test]
    fn no_mesh_an_empty_one_and_a_missing_device_are_refused() {
        let named = |triangles: Vec<[u32; 3]>| {
            let mesh = TriangleMesh::new(vec![glam::Vec3::ZERO; 3], triangles).unwrap();
            [NamedMesh { name: "m".to_owned(), mesh: Arc::new(PreparedMesh::new(mesh)) }]
        };
        let refused = |meshes: &[NamedMesh]| {
            let run = Run { profile: Profile::Quick, meshes, gpu: None, progress: &NoProgress };
            let error = PAPER.reproduce(&run).unwrap_err();
            (error.is_of_input(), error.to_string())
        };
        assert_eq!(refused(&[]), (true, "there is no mesh to measure".to_owned()));
        let (is_of_input, message) = refused(&named(vec![]));
        assert!(is_of_input && message.starts_with("m: the mesh has no triangle"), "{message}");
        let (is_of_input, message) = refused(&named(vec![[0, 1, 2]]));
        assert!(!is_of_input && message.contains("need a graphics adapter"), "{message}");
    }
}
