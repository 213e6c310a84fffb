//! What a result does not depend on: the order of vertices and faces, the unit of length, a place and quarter turns that
//! coordinates express exactly, the side of a mirror, and the number of threads.

mod change;
mod drawn;
mod made;

use crate::invariance::change::{Change, changes, on_grid};
use crate::seen::look;
use glam::Vec3;
use silhouette_compare::registry::Registry;
use silhouette_core::loops::start_vertex;
use silhouette_core::method::{OptionValues, PrepareError};
use silhouette_core::{
    HalfEdgeId, NoProgress, SilhouetteEdges, SilhouetteLoops, Topology, TriangleMesh, VertexId, Viewpoint,
};
use silhouette_testing::directions::spread;
use silhouette_testing::edits::mapped;
use silhouette_testing::prepare::{artefact, prepared};
use silhouette_testing::views::seen_from;
use silhouette_testing::{Random, with_threads, zoo};
use std::sync::Arc;

/// Edges and loops of a view by the numbers of the unchanged mesh: pairs, and cycles that begin at their least rotation.
#[derive(Debug, PartialEq, Eq)]
struct Found {
    edges: Vec<[u32; 2]>,
    loops: Vec<Vec<u32>>,
}

fn edges_of(change: &Change, topology: &Topology, edges: &SilhouetteEdges) -> Vec<[u32; 2]> {
    let pair = |edge| {
        let mut pair = topology.end_points(edge).map(VertexId::get).map(|vertex| change.original(vertex));
        pair.sort_unstable();
        pair
    };
    let mut pairs: Vec<[u32; 2]> = edges.iter().map(pair).collect();
    pairs.sort_unstable();
    pairs
}

fn loops_of(change: &Change, loops: &SilhouetteLoops) -> Vec<Vec<u32>> {
    let cycle = |half_edges: &[HalfEdgeId]| {
        let start = |half_edge: &HalfEdgeId| change.original(start_vertex(&change.mesh, *half_edge).get());
        let mut cycle: Vec<u32> = half_edges.iter().map(start).collect();
        if change.is_mirrored {
            cycle.reverse();
        }
        let rotations = (0..cycle.len()).map(|by| [&cycle[by..], &cycle[..by]].concat());
        rotations.min().unwrap_or_default()
    };
    let mut cycles: Vec<Vec<u32>> = loops.iter().map(cycle).collect();
    cycles.sort_unstable();
    cycles
}

/// What each exact method finds in each of some views, one after the other.
fn found(change: &Change, views: &[Viewpoint]) -> Vec<(&'static str, Vec<Found>)> {
    let mesh = prepared(change.mesh.clone());
    let topology: Arc<Topology> = artefact(&mesh);
    let mut all = Vec::new();
    for entry in Registry::builtin().entries().iter().filter(|entry| entry.info().exact) {
        let info = entry.info();
        let mut method = match entry.prepare(&mesh, &OptionValues::defaults(info.options), &NoProgress) {
            Ok(method) => method,
            // Not defined for this mesh.
            Err(PrepareError::Mesh(_)) => continue,
            Err(error) => panic!("{}: {error}", info.name),
        };
        let of_view = |viewpoint: &Viewpoint| {
            let viewpoint = change.viewpoint(viewpoint);
            let (mut edges, mut loops) = (SilhouetteEdges::default(), SilhouetteLoops::default());
            method.edges().expect("exact methods yield edges").extract_edges(&viewpoint, &mut edges);
            if let Some(method) = method.loops() {
                method.extract_loops(&viewpoint, &mut loops);
            }
            Found { edges: edges_of(change, &topology, &edges), loops: loops_of(change, &loops) }
        };
        all.push((info.name, views.iter().map(of_view).collect()));
    }
    all
}

/// Eyes that move around a mesh, and directions.
fn views(seed: u64) -> Vec<Viewpoint> {
    let mut random = Random::new(seed);
    let mut views: Vec<Viewpoint> =
        spread(40).step_by(7).map(|direction| seen_from(on_grid((direction * 3.1).as_vec3()))).collect();
    views.extend((0..3).map(|_| seen_from(on_grid((random.vector() * 2.0).as_vec3()))));
    views.extend(spread(3).map(|direction| Viewpoint::Orthographic { toward_viewer: on_grid(direction.as_vec3()) }));
    views
}

fn meshes() -> impl Iterator<Item = (&'static str, TriangleMesh)> {
    let is_small = |(_, mesh): &(&str, TriangleMesh)| mesh.face_count() <= 2500;
    zoo::all().into_iter().filter(is_small).map(|(name, mesh)| (name, mapped(&mesh, on_grid)))
}

#[test]
fn edges_and_loops_do_not_depend_on_the_place_of_a_mesh() {
    let mut compared = 0;
    for (name, mesh) in meshes() {
        let views = views(3);
        let expected = found(&Change::none(&mesh), &views);
        assert!(expected.len() >= 3, "{name}: {} methods", expected.len());
        for change in changes(&mesh) {
            // Of edges with three faces and more, order decides how their loops go on.
            let found = found(&change, &views);
            for ((method, one), (other_method, other)) in expected.iter().zip(&found) {
                assert_eq!(method, other_method);
                for (one, other) in one.iter().zip(other) {
                    assert!(one.edges == other.edges, "{name}, {method}, {}", change.name);
                    let is_manifold = zoo::defective().iter().all(|(defective, _)| *defective != name);
                    assert!(!is_manifold || one.loops == other.loops, "{name}, {method}, {}", change.name);
                    compared += 1;
                }
            }
        }
    }
    eprintln!("{compared} views compared");
    assert!(compared > 2000, "{compared}");
}

#[test]
fn edges_and_loops_do_not_depend_on_the_number_of_threads() {
    for (name, mesh) in meshes() {
        let of = |threads| with_threads(threads, || found(&Change::none(&mesh), &views(4)));
        assert!(of(1) == of(2), "{name}");
    }
}

/// The comparison can fail: an eye beside its place, a scale that rounds, and faces left out have other edges.
#[test]
fn what_is_no_change_of_place_is_told() {
    let mesh = mapped(&zoo::builtin("blob:600"), on_grid);
    let views = views(3);
    let expected = found(&Change::none(&mesh), &views);
    let beside = |view: &Viewpoint| match *view {
        Viewpoint::Perspective { eye } => seen_from(eye + Vec3::X * 0.01),
        other => other,
    };
    let beside: Vec<Viewpoint> = views.iter().map(beside).collect();
    assert!(found(&Change::none(&mesh), &beside) != expected);
    let stretched = Change::of(&mapped(&mesh, |p| p * Vec3::new(1.0, 1.0, 1.001)));
    assert!(found(&stretched, &views) != expected);
    let mut mirrored = changes(&mesh).find(|change| change.is_mirrored).unwrap();
    mirrored.is_mirrored = false;
    assert!(found(&mirrored, &views) != expected);
    assert!(!look(&mesh, &views[0]).edges.is_empty());
}
