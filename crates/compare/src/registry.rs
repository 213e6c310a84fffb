//! The one list of methods. To add one, add a line to `ENTRIES`.

use silhouette_core::method::{ExtractionStats, MethodOptions, OptionValues, PrepareError};
use silhouette_core::{ExtractsEdges, ExtractsLoops, Method, MethodInfo, PreparedMesh, Progress};
use silhouette_core::{SilhouetteEdges, Viewpoint};
use silhouette_extraction::{BruteForce, BruteForceSimd, ClusterCones, Randomized};
use silhouette_gpu::{DrawsLines, LineRenderer, PenPlacement, RendererError, TargetFormats};
use silhouette_image_precision::ImagePrecision;
use silhouette_render::Gpu;
use silhouette_tracking::{ExactTracking, Tracking};
use std::sync::Arc;

/// Every method, in the order in which they are listed and compared.
static ENTRIES: [Entry; 7] = [
    Entry::loops::<BruteForce>(),
    Entry::loops::<BruteForceSimd>(),
    Entry::loops::<ClusterCones>(),
    Entry::edges::<Randomized>(),
    Entry::loops::<Tracking>(),
    Entry::loops::<ExactTracking>(),
    Entry::lines::<ImagePrecision>(),
];

/// The baseline: speeds are stated as ratios to it.
pub const BASELINE: &str = BruteForce::INFO.name;

/// Every method, in the order in which they are listed and compared.
pub fn all() -> &'static [Entry] {
    &ENTRIES
}

/// The method of this name.
///
/// # Errors
/// [`UnknownMethod`] lists the names that exist.
pub fn find(name: &str) -> Result<&'static Entry, UnknownMethod> {
    let known = || all().iter().map(|entry| entry.info.name).collect::<Vec<_>>().join(", ");
    all()
        .iter()
        .find(|entry| entry.info.name == name)
        .ok_or_else(|| UnknownMethod { name: name.to_owned(), known: known() })
}

/// There is no method of this name.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("there is no method '{name}'; there are {known}")]
pub struct UnknownMethod {
    /// What was asked for.
    pub name: String,
    /// The names that exist, separated by commas.
    pub known: String,
}

/// What a method yields.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Yields {
    /// Silhouette edges.
    Edges,
    /// Silhouette edges and loops of them.
    Loops,
    /// Ink.
    Lines,
}

/// A method of the registry.
#[derive(Debug, Clone, Copy)]
pub struct Entry {
    /// What the method says of itself.
    pub info: &'static MethodInfo,
    /// What it yields.
    pub yields: Yields,
    prepare: PrepareFn,
}

/// A method of the registry, prepared for a mesh.
pub enum Prepared {
    /// One that extracts edges, and perhaps loops.
    Edges(Box<dyn EdgeMethod>),
    /// One that draws lines itself.
    Lines(Box<dyn LineMethod>),
}

impl Entry {
    /// An entry for a method that extracts edges.
    pub const fn edges<M: Method + ExtractsEdges>() -> Self {
        let prepare: PrepareFn = |mesh, options, progress| {
            Ok(Prepared::Edges(Box::new(EdgesOnly(M::prepare(mesh, &M::Options::read(options)?, progress)?))))
        };
        Self { info: const { &M::INFO }, yields: Yields::Edges, prepare }
    }

    /// An entry for a method that extracts edges and loops.
    pub const fn loops<M: Method + ExtractsLoops>() -> Self {
        let prepare: PrepareFn = |mesh, options, progress| {
            Ok(Prepared::Edges(Box::new(WithLoops(M::prepare(mesh, &M::Options::read(options)?, progress)?))))
        };
        Self { info: const { &M::INFO }, yields: Yields::Loops, prepare }
    }

    /// An entry for a method that draws lines.
    pub const fn lines<M: DrawsLines>() -> Self {
        let prepare: PrepareFn = |mesh, options, progress| {
            Ok(Prepared::Lines(Box::new(M::prepare(mesh, &M::Options::read(options)?, progress)?)))
        };
        Self { info: const { &M::INFO }, yields: Yields::Lines, prepare }
    }

    /// Prepares the method for a mesh.
    ///
    /// # Errors
    /// [`PrepareError`]: cancelled, an option that does not fit, or a mesh that the method is not defined for.
    pub fn prepare(
        &self,
        mesh: &Arc<PreparedMesh>,
        options: &OptionValues,
        progress: &dyn Progress,
    ) -> Result<Prepared, PrepareError> {
        (self.prepare)(mesh, options, progress)
    }
}

type PrepareFn = fn(&Arc<PreparedMesh>, &OptionValues, &dyn Progress) -> Result<Prepared, PrepareError>;

/// A prepared method that extracts edges, its type erased.
pub trait EdgeMethod: Send {
    /// Bytes it holds beyond the artefacts of its mesh.
    fn bytes(&self) -> usize;
    /// See [`ExtractsEdges::extract_edges`].
    fn extract_edges(&mut self, viewpoint: &Viewpoint, out: &mut SilhouetteEdges) -> ExtractionStats;
    /// The method as one that extracts loops, where it does.
    fn as_loops(&mut self) -> Option<&mut dyn ExtractsLoops>;
}

/// A prepared method that draws lines, its type erased.
pub trait LineMethod: Send {
    /// Bytes it holds beyond the artefacts of its mesh, the renderer left out.
    fn bytes(&self) -> usize;
    /// See [`DrawsLines::pen_placement`].
    fn pen_placement(&self) -> PenPlacement;
    /// See [`DrawsLines::renderer`].
    ///
    /// # Errors
    /// [`RendererError`]: the mesh is too large for the device, or the device lacks what the options ask for.
    fn renderer(&self, gpu: &Gpu, formats: TargetFormats) -> Result<Box<dyn LineRenderer>, RendererError>;
}

struct EdgesOnly<M>(M);
struct WithLoops<M>(M);

impl<M: Method + ExtractsEdges> EdgeMethod for EdgesOnly<M> {
    fn bytes(&self) -> usize {
        self.0.bytes()
    }
    fn extract_edges(&mut self, viewpoint: &Viewpoint, out: &mut SilhouetteEdges) -> ExtractionStats {
        self.0.extract_edges(viewpoint, out)
    }
    fn as_loops(&mut self) -> Option<&mut dyn ExtractsLoops> {
        None
    }
}

impl<M: Method + ExtractsLoops> EdgeMethod for WithLoops<M> {
    fn bytes(&self) -> usize {
        self.0.bytes()
    }
    fn extract_edges(&mut self, viewpoint: &Viewpoint, out: &mut SilhouetteEdges) -> ExtractionStats {
        self.0.extract_edges(viewpoint, out)
    }
    fn as_loops(&mut self) -> Option<&mut dyn ExtractsLoops> {
        Some(&mut self.0)
    }
}

impl<M: DrawsLines> LineMethod for M {
    fn bytes(&self) -> usize {
        Method::bytes(self)
    }
    fn pen_placement(&self) -> PenPlacement {
        DrawsLines::pen_placement(self)
    }
    fn renderer(&self, gpu: &Gpu, formats: TargetFormats) -> Result<Box<dyn LineRenderer>, RendererError> {
        Ok(Box::new(DrawsLines::renderer(self, gpu.device(), gpu.queue(), formats)?))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::{NoProgress, TriangleMesh};
    use std::collections::BTreeSet;

    #[test]
    fn names_are_unique_in_kebab_case_and_found() {
        let names: BTreeSet<_> = all().iter().map(|entry| entry.info.name).collect();
        assert_eq!(names.len(), all().len());
        for name in names {
            assert!(name.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-'), "{name}");
            assert_eq!(find(name).unwrap().info.name, name);
        }
        assert_eq!(find(BASELINE).unwrap().yields, Yields::Loops);
    }

    #[test]
    fn an_unknown_name_is_answered_with_the_known_ones() {
        let error = find("brute-farce").unwrap_err().to_string();
        assert!(all().iter().all(|entry| error.contains(entry.info.name)), "{error}");
    }

    #[test]
    fn every_method_is_prepared_as_what_it_yields() {
        let mesh = Arc::new(PreparedMesh::new(TriangleMesh::new(vec![], vec![]).unwrap()));
        for entry in all() {
            let options = OptionValues::defaults(entry.info.options);
            let prepared = entry.prepare(&mesh, &options, &NoProgress).unwrap();
            let yields = match prepared {
                Prepared::Edges(mut method) => {
                    if method.as_loops().is_some() {
                        Yields::Loops
                    } else {
                        Yields::Edges
                    }
                }
                Prepared::Lines(_) => Yields::Lines,
            };
            assert_eq!(yields, entry.yields, "{}", entry.info.name);
        }
    }

    #[test]
    fn preparation_asks_for_what_the_method_says_it_needs_and_no_more() {
        for entry in all() {
            let mesh = Arc::new(PreparedMesh::new(silhouette_core::shapes::by_name("cube").unwrap()));
            entry.prepare(&mesh, &OptionValues::defaults(entry.info.options), &NoProgress).unwrap();
            let report = mesh.report();
            let asked: BTreeSet<_> =
                report.iter().filter(|a| a.asked_by.contains(entry.info.name)).map(|a| a.name).collect();
            assert_eq!(asked, BTreeSet::from_iter(entry.info.needs.iter().copied()), "{}", entry.info.name);
            assert!(!entry.info.needs.is_empty() || report.is_empty(), "{} needs triangles only", entry.info.name);
        }
    }
}
