//! From a mesh to what a test needs of it, in one call.

use silhouette_core::method::{OptionSpec, OptionValues};
use silhouette_core::prepared::Artefact;
use silhouette_core::{Method, NoProgress, PreparedMesh, TriangleMesh};
use std::sync::Arc;

/// A mesh of which nothing is prepared yet.
pub fn prepared(mesh: TriangleMesh) -> Arc<PreparedMesh> {
    Arc::new(PreparedMesh::new(mesh))
}

/// An artefact of a mesh, built if nothing has asked for it before.
pub fn artefact<A: Artefact>(mesh: &PreparedMesh) -> Arc<A> {
    mesh.artefact("test", &NoProgress).unwrap()
}

/// A method with its default options.
pub fn method<M: Method>(mesh: &Arc<PreparedMesh>) -> M {
    M::new(mesh, M::Options::default()).unwrap()
}

/// Options of methods that would prepare for long by default, and values at which they do not.
const CHEAP: [(&str, &str); 3] = [("hull-vertices", "24"), ("size", "64"), ("azimuths", "8")];

/// The defaults, but for options by which preparation takes seconds.
pub fn cheap_options(specs: &'static [OptionSpec]) -> OptionValues {
    let words = CHEAP.iter().filter(|(name, _)| specs.iter().any(|spec| spec.name == *name));
    let words: Vec<String> = words.map(|(name, value)| format!("{name}={value}")).collect();
    OptionValues::parse(specs, words.iter().map(String::as_str)).unwrap()
}
