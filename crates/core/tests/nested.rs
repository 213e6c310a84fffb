//! Closed parts inside of each other by the thousand: memory grows with the faces, and the work can be stopped.

use silhouette_core::glam::Vec3;
use silhouette_core::inside_out::{inside_out_faces, inside_out_faces_with_progress};
use silhouette_core::inspect::{inspect, inspect_with_progress};
use silhouette_core::{Topology, TriangleMesh, shapes};
use silhouette_testing::Cancelling;
use silhouette_testing::edits::{inside_out, joined, mapped};

/// Octahedra, each a little larger than the one before, all of which point outward.
fn shells(count: usize) -> TriangleMesh {
    let corners = [Vec3::X, Vec3::NEG_X, Vec3::Y, Vec3::NEG_Y, Vec3::Z, Vec3::NEG_Z];
    let faces = [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];
    let (mut positions, mut triangles) = (Vec::new(), Vec::new());
    for shell in 0..count {
        let first = positions.len() as u32;
        positions.extend(corners.map(|corner| corner * (1.0 + shell as f32 / count as f32)));
        triangles.extend(faces.map(|face| face.map(|vertex: u32| vertex + first)));
    }
    TriangleMesh::new(positions, triangles).unwrap()
}

#[test]
fn memory_grows_with_the_faces() {
    let mesh = shells(1500);
    let topology = Topology::new(&mesh);
    let mut turned = Vec::new();
    let memory = allocation_counter::measure(|| turned = inside_out_faces(&mesh, &topology));
    assert!(!turned.contains(&true), "a shell around others that points as they do is an object of its own");
    let most = 512 * mesh.face_count() as u64;
    assert!(memory.bytes_max < most, "{} bytes for {} faces", memory.bytes_max, mesh.face_count());
}

/// Every second shell of a few points inward: solids with cavities, of which nothing is wrong.
#[test]
fn walls_of_cavities_are_found_by_the_smallest_part_around_them() {
    let cube = shapes::by_name("cube").unwrap();
    let parts: Vec<TriangleMesh> = (0..6)
        .map(|rank| {
            let scaled = mapped(&cube, |position| position * (6 - rank) as f32);
            if rank % 2 == 1 { inside_out(&scaled) } else { scaled }
        })
        .collect();
    let mesh = joined(&parts.iter().collect::<Vec<_>>());
    let found = inspect(&mesh, &Topology::new(&mesh));
    assert_eq!((found.inside_out_faces, found.cavities), (0, 3));
}

#[test]
fn it_can_be_stopped() {
    let mesh = shells(400);
    let topology = Topology::new(&mesh);
    let progress = Cancelling::at_poll(3);
    assert!(inside_out_faces_with_progress(&mesh, &topology, &progress).is_err());
    assert!(inspect_with_progress(&mesh, &topology, &Cancelling::at_poll(4)).is_err());
    assert_eq!(inspect_with_progress(&mesh, &topology, &Cancelling::at_poll(1 << 40)), Ok(inspect(&mesh, &topology)));
}
