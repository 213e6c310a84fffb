//! Random triangles with whole coordinates, where ties are common: edges over edges, faces in one plane, faces edge-on,
//! vertices on edges, faces that pass through each other.

use crate::rays::compare;
use crate::scenes::all_lines;
use proptest::prelude::*;
use silhouette_core::glam::Vec3;
use silhouette_core::{Camera, Projection, TriangleMesh};
use silhouette_visibility::LineOptions;

/// Triangles over a few points of a coarse lattice. Where `shared`, they share vertices; otherwise each has its own.
fn soup(points: &[[i32; 3]], triangles: &[[usize; 3]], shared: bool) -> TriangleMesh {
    let place = |point: [i32; 3]| Vec3::from(point.map(|c| c as f32));
    if shared {
        let corner = |index: usize| (index % points.len()) as u32;
        let triangles = triangles.iter().map(|triangle| triangle.map(corner)).collect();
        TriangleMesh::new(points.iter().copied().map(place).collect(), triangles).unwrap()
    } else {
        let positions = triangles.iter().flatten().map(|&index| place(points[index % points.len()])).collect();
        let triangles = (0..triangles.len() as u32).map(|face| [3 * face, 3 * face + 1, 3 * face + 2]).collect();
        TriangleMesh::new(positions, triangles).unwrap()
    }
}

/// A camera at whole coordinates that looks at whole coordinates; `None` where both are the same.
fn camera(eye: [i32; 3], target: [i32; 3], perspective: bool) -> Option<Camera> {
    let [eye, target] = [eye, target].map(|point| Vec3::from(point.map(|c| c as f32)));
    let projection = if perspective {
        Projection::Perspective { fov_y_rad: 1.4 }
    } else {
        Projection::Orthographic { height: 12.0 }
    };
    let up = (target - eye).any_orthogonal_vector();
    (eye != target).then(|| Camera::new(eye, target, up, projection, [512, 512]).unwrap())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(600))]

    #[test]
    fn soups_agree_with_brute_force(
        points in prop::collection::vec(prop::array::uniform3(0_i32..5), 4..16),
        triangles in prop::collection::vec(prop::array::uniform3(0_usize..16), 2..14),
        shared: bool,
        eye in prop::array::uniform3(-6_i32..11),
        target in prop::array::uniform3(0_i32..5),
        perspective: bool,
        mesh_edges: bool,
    ) {
        let Some(camera) = camera(eye, target, perspective) else { return Ok(()) };
        let mesh = soup(&points, &triangles, shared);
        let options = LineOptions { mesh: mesh_edges, ..LineOptions::default() };
        let lines = all_lines(&mesh, &camera, &options);
        let tally = compare(&mesh, &lines, 150);
        prop_assert_eq!(tally.wrong, 0, "{:?}", tally);
    }
}
