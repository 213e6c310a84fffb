//! Edges, and the loops that they form, against integers.

use crate::cell::{Found, Outcome};
use crate::truth::Truth;
use silhouette_compare::registry::Entry;
use silhouette_core::loops::start_vertex;
use silhouette_core::{NoProgress, SilhouetteEdges, SilhouetteLoops, Topology, TriangleMesh};
use silhouette_testing::prepare::artefact;
use std::sync::Arc;

/// What a method that extracts edges yields, against the truth.
pub fn found(entry: &Entry, truth: &Truth<'_>) -> Found {
    extracted(entry, truth).map_or_else(|found| found, |edges| compared(&edges, truth.edges()))
}

/// The edges that a method extracts after two views near by.
///
/// # Errors
/// A refusal, or a fault.
pub fn extracted(entry: &Entry, truth: &Truth<'_>) -> Result<SilhouetteEdges, Found> {
    let scene = truth.scene;
    let options = scene.options_of(entry.info().options).map_err(|error| Found::refused(&error))?;
    let mut method = entry.prepare(&scene.mesh, &options, &NoProgress).map_err(|error| Found::refused(&error))?;
    let viewpoint = scene.viewpoint()?;
    let mut edges = SilhouetteEdges::default();
    for view in scene.before().iter().chain([&viewpoint]) {
        method.edges().expect("it extracts edges").extract_edges(view, &mut edges);
    }
    let topology: Arc<Topology> = artefact(&scene.mesh);
    if let Some(edge) = edges.iter().find(|edge| edge.index() >= topology.edge_count()) {
        return Err(Found::fault(format!("edge {} of {}", edge.index(), topology.edge_count())));
    }
    if let Some(loops) = method.loops() {
        let mut found = SilhouetteLoops::default();
        loops.extract_loops(&viewpoint, &mut found);
        if let Some(fault) = broken_loop(scene.mesh.mesh(), &topology, &found, &edges) {
            return Err(Found::fault(fault));
        }
    }
    Ok(edges)
}

/// How many of the expected edges were not found, and how many others were.
pub fn missed_and_spurious(found: &SilhouetteEdges, expected: &SilhouetteEdges) -> [usize; 2] {
    let missed = expected.iter().filter(|&edge| !found.contains(edge)).count();
    [missed, found.iter().filter(|&edge| !expected.contains(edge)).count()]
}

/// An outcome by what is missing and what is too much.
fn compared(found: &SilhouetteEdges, expected: &SilhouetteEdges) -> Found {
    let [missed, spurious] = missed_and_spurious(found, expected);
    let outcome = match (missed, spurious) {
        (0, 0) if expected.is_empty() => Outcome::Empty,
        (0, 0) => Outcome::Exact,
        (_, 0) => Outcome::Subset,
        _ => Outcome::Differs,
    };
    let text = match outcome {
        Outcome::Empty => String::new(),
        _ => format!("{}/{}", missed + spurious, expected.len()),
    };
    Found::new(outcome, text)
}

/// Why loops are none: half-edges that do not follow each other, or that are not those of the edges.
fn broken_loop(
    mesh: &TriangleMesh,
    topology: &Topology,
    loops: &SilhouetteLoops,
    edges: &SilhouetteEdges,
) -> Option<String> {
    let mut of_loops = SilhouetteEdges::default();
    of_loops.refill(loops.half_edges().iter().map(|&half_edge| topology.edge_of(half_edge)));
    if of_loops != *edges {
        return Some(format!("loops of {} edges, {} edges extracted", of_loops.len(), edges.len()));
    }
    let is_consistent = topology
        .edges()
        .ids()
        .all(|edge| topology.half_edges(edge).len() == 1 || topology.consistent_pair(mesh, edge).is_some());
    let end = |half_edge: silhouette_core::HalfEdgeId| {
        mesh.triangles()[half_edge.face().index()][(half_edge.slot() as usize + 1) % 3]
    };
    let is_open = loops.iter().any(|half_edges| {
        let next = half_edges.iter().cycle().skip(1);
        half_edges.iter().zip(next).any(|(&from, &to)| end(from) != start_vertex(mesh, to).get())
    });
    // Without consistent winding loops close, but neighbours in them need not share a vertex.
    (is_consistent && is_open).then(|| "a loop has a gap".to_owned())
}
