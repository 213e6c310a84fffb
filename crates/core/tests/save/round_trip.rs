//! A file that is read back is the same mesh, to the bit, with the same hard edges.

use crate::{glb, hard_edges};
use proptest::prelude::*;
use silhouette_core::glam::DVec3;
use silhouette_core::id::PerEdge;
use silhouette_core::load::{Format, LabelledMesh, read_labelled};
use silhouette_core::save::write_glb;
use silhouette_core::{NoProgress, Topology, TriangleMesh};
use silhouette_testing::{real_meshes, strategies, zoo};

fn read(bytes: &[u8]) -> LabelledMesh {
    read_labelled(Format::Gltf, "round-trip.glb", bytes, &NoProgress).unwrap_or_else(|error| panic!("{error}"))
}

/// The edges for which `is_hard` holds, without sides from a vertex to itself.
fn pairs(topology: &Topology, is_hard: &PerEdge<bool>) -> Vec<[u32; 2]> {
    let hard = is_hard.iter().filter(|(_, is_hard)| **is_hard).map(|(edge, _)| topology.edges()[edge]);
    hard.filter(|[a, b]| a != b).collect()
}

fn bits(mesh: &TriangleMesh) -> Vec<[u32; 3]> {
    mesh.positions().iter().map(|position| position.to_array().map(f32::to_bits)).collect()
}

fn assert_returns(name: &str, mesh: &TriangleMesh) {
    let topology = Topology::new(mesh);
    let back = read(&glb(mesh));
    // What is a single point far from zero is read as one that counts from there.
    let at_same_place = back.mesh.relative_to(mesh.origin()).unwrap();
    assert_eq!(bits(&at_same_place), bits(mesh), "{name}");
    assert_eq!(back.mesh.triangles(), mesh.triangles(), "{name}");
    assert_eq!(back.feature_edges, pairs(&topology, &hard_edges(mesh, &topology)), "{name}");
}

#[test]
fn the_zoo_and_real_meshes_return() {
    for (name, mesh) in zoo::all() {
        assert_returns(name, &mesh);
    }
    for (name, mesh) in real_meshes("files with edges, read back") {
        assert_returns(&name, &mesh);
    }
}

#[test]
fn a_mesh_far_from_zero_returns_to_its_place() {
    let origin = DVec3::new(500_000.0, 5_400_000.0, -1000.0);
    let mesh = zoo::closed().remove(0).1.with_origin(origin);
    let back = read(&glb(&mesh)).mesh;
    for (here, there) in mesh.positions().iter().zip(back.positions()) {
        let (here, there) = (mesh.origin() + here.as_dvec3(), back.origin() + there.as_dvec3());
        assert!(here.distance(there) < 1e-6, "{here} and {there}");
    }
}

proptest! {
    #[test]
    fn any_mesh_returns(
        mesh in prop_oneof![strategies::closed_mesh(), strategies::open_mesh(), strategies::soup(40)],
    ) {
        prop_assume!(mesh.face_count() > 0);
        assert_returns("generated", &mesh);
    }

    /// Whatever edges are hard, those are read.
    #[test]
    fn any_hard_edges_return(mesh in strategies::soup(40), chosen in prop::collection::vec(any::<bool>(), 120)) {
        prop_assume!(mesh.face_count() > 0);
        let topology = Topology::new(&mesh);
        let is_hard = PerEdge::from(chosen[..topology.edge_count()].to_vec());
        let mut bytes = Vec::new();
        write_glb(&mesh, &topology, &is_hard, &mut bytes).unwrap();
        prop_assert_eq!(read(&bytes).feature_edges, pairs(&topology, &is_hard));
    }
}
