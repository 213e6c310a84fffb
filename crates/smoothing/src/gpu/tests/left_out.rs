//! What the GPU leaves out of invisible parts.

use super::scene::{Scene, cameras, method, pipelines};
use crate::options::Invisible;
use crate::{Remesher as _, SmoothingOptions, SmoothingView, ViewMesh};
use silhouette_core::glam::Vec3;
use silhouette_core::view::{Camera, Projection};
use silhouette_testing::gpu_or_skip;

#[test]
fn the_gpu_leaves_out_what_the_cpu_does_and_nothing_of_it_shows() {
    let Some(gpu) = gpu_or_skip("the_gpu_leaves_out_what_the_cpu_does_and_nothing_of_it_shows") else { return };
    let pipelines = pipelines(gpu);
    let mut left_out = 0;
    for name in ["icosphere:1", "torus:16,10", "blob:800", "cylinder", "gear"] {
        let [method, kept] = [Invisible::LeftOut, Invisible::Kept]
            .map(|invisible| method(name, SmoothingOptions { invisible, ..Default::default() }));
        let [mut scene, mut closed] = [&method, &kept].map(|method| Scene::new(gpu, &pipelines, method));
        let mut drawn = method.drawn();
        let mut out = ViewMesh::default();
        for camera in cameras(method.shading_mesh().mesh(), 6) {
            drawn.remesh(&SmoothingView::from_camera(&camera), &mut out);
            let frame = scene.frame(&camera);
            let (found, expected) = (frame.proper_triangles().len(), out.triangles.len());
            // Triangles nearly edge-on, and segments that have a piece more or less in 32 bits.
            assert!(found.abs_diff(expected) <= 2 + expected / 50, "{name}: {found} for {expected}");
            left_out += closed.frame(&camera).proper_triangles().len() - found;
            let pictures = [&mut scene, &mut closed].map(|scene| scene.picture(&camera));
            let covers =
                pictures.each_ref().map(|image| image.rgba.iter().skip(3).step_by(4).filter(|a| **a > 0).count());
            assert_eq!(covers[0], covers[1], "{name}");
            let pairs = pictures[0].rgba.chunks_exact(4).zip(pictures[1].rgba.chunks_exact(4));
            let others = pairs.filter(|(a, b)| a[0].abs_diff(b[0]) > 8).count();
            assert!(others <= 4, "{name}: {others} pixels have another shade");
        }
    }
    assert!(left_out > 200, "{left_out}");
}

/// Where an eye is close enough to be inside, or a plane cuts the surface, rays begin within it.
#[test]
fn nothing_is_left_out_of_open_meshes_and_from_nearby() {
    let Some(gpu) = gpu_or_skip("nothing_is_left_out_of_open_meshes_and_from_nearby") else { return };
    let pipelines = pipelines(gpu);
    let projection = Projection::Perspective { fov_y_rad: 1.5 };
    for (name, distance) in [("moebius", 5.0), ("torus:16,10", 0.9)] {
        let [method, kept] = [Invisible::LeftOut, Invisible::Kept]
            .map(|invisible| method(name, SmoothingOptions { invisible, ..Default::default() }));
        let eye = distance * Vec3::new(0.6, 0.64, 0.48);
        let camera = Camera::new(eye, Vec3::ZERO, Vec3::Z, projection, [256; 2]).unwrap();
        let [drawn, all] =
            [&method, &kept].map(|method| Scene::new(gpu, &pipelines, method).frame(&camera).proper_triangles());
        assert!(drawn == all && !all.is_empty(), "{name}");
        let mut out = [ViewMesh::default(), ViewMesh::default()];
        let view = SmoothingView::from_camera(&camera);
        method.drawn().remesh(&view, &mut out[0]);
        kept.drawn().remesh(&view, &mut out[1]);
        assert!(
            out[0].triangles == out[1].triangles && out[0].triangles.len() > method.shading_mesh().triangles().len()
        );
    }
}
