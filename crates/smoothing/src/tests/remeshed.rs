//! What holds of every re-meshed mesh.

use super::smoothing;
use crate::{Remesher, SmoothingOptions, SmoothingView, ViewMesh};
use silhouette_core::glam::Vec3;
use silhouette_core::view::{Camera, Framing};
use silhouette_core::{Topology, TriangleMesh};
use silhouette_testing::directions::spread;
use silhouette_testing::{views, zoo};

fn boundary_edges(mesh: &TriangleMesh) -> usize {
    Topology::new(mesh).boundary_edge_count()
}

#[test]
fn closed_meshes_stay_closed() {
    for (name, original) in zoo::closed() {
        for (crease_deg, corner_deg) in [(75.0, 75.0), (180.0, 75.0), (20.0, 180.0)] {
            let mut method =
                smoothing(original.clone(), SmoothingOptions { crease_deg, corner_deg, ..Default::default() });
            let mut out = ViewMesh::default();
            let before = boundary_edges(&original);
            for (i, direction) in spread(24).enumerate() {
                let framing = if i % 2 == 0 { Framing::Orthographic } else { Framing::Perspective { fov_y_rad: 0.7 } };
                let camera = views::framed(&original, direction, framing, [512; 2]);
                method.remesh(&SmoothingView::from_camera(&camera), &mut out);
                let mesh = out.to_mesh().unwrap();
                assert_eq!(boundary_edges(&mesh), before, "{} {direction}", name);
                println!("{} {crease_deg} {} -> {}", name, original.face_count(), mesh.face_count());
            }
        }
    }
    let _ = (Vec3::ZERO, None::<Camera>);
}
