//! Meshes placed by a model matrix, in part of a target, or moved by new positions are drawn as meshes that are there.

use crate::scene::{self, Lines, count, differing, ink, sphere, three_quarter, torus, view};
use silhouette_core::glam::{DMat4, DQuat, DVec3, Vec3};
use silhouette_core::mesh::TriangleMesh;
use silhouette_core::shapes::Cuboid;
use silhouette_gpu::Viewport;
use silhouette_render::{DEFAULT_FORMATS, Image};
use silhouette_testing::edits::{mapped, with_positions};
use silhouette_testing::gpu_or_skip;

/// Options under which pictures are compared.
const WORDS: [(Lines, &[&str]); 7] = [
    (Lines::Hull, &[]),
    (Lines::Hull, &["normals=split", "width=5"]),
    (Lines::Hull, &["push=world", "width-unit=world", "width=0.05"]),
    (Lines::Filter, &["edges=all"]),
    (Lines::Filter, &["operator=sobel", "width=5"]),
    (Lines::Flood, &[]),
    (Lines::Flood, &["width=0.2", "width-unit=world", "interior=depth-only"]),
];

#[test]
fn a_model_matrix_draws_what_the_moved_mesh_draws() {
    let Some(gpu) = gpu_or_skip("a_model_matrix_draws_what_the_moved_mesh_draws") else { return };
    let mesh = torus();
    for scale in [DVec3::new(1.2, 0.5, 0.9), DVec3::new(0.8, 0.7, -1.1)] {
        let turn = DQuat::from_rotation_x(0.6);
        let model = DMat4::from_scale_rotation_translation(scale, turn, DVec3::new(0.1, -0.2, 0.05));
        let moved = mapped(&mesh, |p| model.transform_point3(p.as_dvec3()).as_vec3());
        let flip = |[a, b, c]: [u32; 3]| if model.determinant() < 0.0 { [a, c, b] } else { [a, b, c] };
        let triangles = moved.triangles().iter().copied().map(flip).collect();
        let moved = TriangleMesh::new(moved.positions().to_vec(), triangles).unwrap();
        let view = view(&moved, &three_quarter(5.0, 200), DEFAULT_FORMATS);
        for (lines, words) in WORDS {
            let expected = lines.picture(gpu, &moved, words, &view);
            let found = lines.picture(gpu, &mesh, words, &view.with_model(model).unwrap());
            assert!(ink(&expected) > 300, "{lines:?} {words:?}: {} px of ink", ink(&expected));
            // Outline normals are means in the mesh's own space, which stretching does not keep.
            let differs = differing(&expected, &found);
            assert!(differs < 60, "{lines:?} {words:?}, determinant {}: {differs} px", model.determinant());
            // The control: without the matrix the mesh is elsewhere.
            assert!(differing(&expected, &lines.picture(gpu, &mesh, words, &view)) > 1000, "{lines:?} {words:?}");
        }
    }
}

#[test]
fn a_viewport_draws_within_its_rectangle_what_a_whole_target_shows() {
    let Some(gpu) = gpu_or_skip("a_viewport_draws_within_its_rectangle_what_a_whole_target_shows") else { return };
    let mesh = torus();
    let view = view(&mesh, &three_quarter(4.0, 100), DEFAULT_FORMATS);
    for (lines, words) in WORDS {
        let whole = lines.picture(gpu, &mesh, words, &view);
        let within = view.with_viewport(Viewport { origin_px: [60, 30], size_px: [100; 2] }).unwrap();
        let mut renderer = lines.renderer(gpu, &mesh, words, DEFAULT_FORMATS, &scene::buffers(gpu, &mesh));
        renderer.prepare(gpu.device(), gpu.queue(), &within).unwrap();
        let large = scene::draw_with(gpu, &*renderer, [200; 2], DEFAULT_FORMATS);
        let rows = (30..130).flat_map(|y| (60..160).map(move |x| (x, y)));
        let inside = Image { width: 100, height: 100, rgba: rows.flat_map(|(x, y)| large.pixel(x, y)).collect() };
        assert!(differing(&whole, &inside) < 20, "{lines:?} {words:?}: {} px", differing(&whole, &inside));
        let drawn = |image: &Image| count(image, |value| value != scene::GROUND_VALUE);
        assert_eq!(drawn(&large), drawn(&inside), "{lines:?} {words:?}: nothing outside of the rectangle");
    }
}

#[test]
fn new_positions_draw_what_a_new_mesh_draws() {
    let Some(gpu) = gpu_or_skip("new_positions_draw_what_a_new_mesh_draws") else { return };
    let mesh = torus();
    let bent: Vec<Vec3> = mesh.positions().iter().map(|p| Vec3::new(p.x, p.y + 0.3 * p.x * p.x, p.z)).collect();
    let moved = with_positions(&mesh, bent.clone());
    let view = view(&moved, &three_quarter(4.5, 200), DEFAULT_FORMATS);
    for (lines, words) in WORDS {
        let expected = lines.picture(gpu, &moved, words, &view);
        let buffers = scene::buffers(gpu, &mesh);
        let mut renderer = lines.renderer(gpu, &mesh, words, DEFAULT_FORMATS, &buffers);
        buffers.set_positions(gpu.queue(), &bent).unwrap();
        renderer.prepare(gpu.device(), gpu.queue(), &view).unwrap();
        let found = scene::draw_with(gpu, &*renderer, [200; 2], DEFAULT_FORMATS);
        assert!(differing(&expected, &found) < 30, "{lines:?} {words:?}: {} px", differing(&expected, &found));
    }
}

#[test]
fn normals_found_on_the_device_are_those_of_the_preparation() {
    let Some(gpu) = gpu_or_skip("normals_found_on_the_device_are_those_of_the_preparation") else { return };
    for mesh in [torus(), sphere(), Cuboid::default().mesh().unwrap()] {
        let view = view(&mesh, &three_quarter(5.0, 200), DEFAULT_FORMATS);
        let rest = Lines::Hull.picture(gpu, &mesh, &["width=9"], &view);
        let buffers = scene::buffers(gpu, &mesh);
        let mut renderer = Lines::Hull.renderer(gpu, &mesh, &["width=9"], DEFAULT_FORMATS, &buffers);
        buffers.set_positions(gpu.queue(), mesh.positions()).unwrap();
        assert!(!buffers.is_at_rest(), "the device has to find them");
        renderer.prepare(gpu.device(), gpu.queue(), &view).unwrap();
        let moving = scene::draw_with(gpu, &*renderer, [200; 2], DEFAULT_FORMATS);
        assert!(ink(&rest) > 2000 && differing(&rest, &moving) < 5, "{} px", differing(&rest, &moving));
    }
}

#[test]
fn winding_matters_to_hulls_alone() {
    let Some(gpu) = gpu_or_skip("winding_matters_to_hulls_alone") else { return };
    let mesh = torus();
    let flipped = silhouette_testing::edits::inside_out(&mesh);
    let camera = three_quarter(4.0, 128);
    for lines in Lines::ALL {
        let [outward, inward] = [&mesh, &flipped].map(|mesh| lines.seen(gpu, mesh, &[], &camera));
        if lines == Lines::Hull {
            assert!(ink(&inward) > 3 * ink(&outward), "what a hull shows of an inverted mesh is its ink");
        } else {
            assert!(differing(&outward, &inward) < 5, "{lines:?}");
        }
    }
}
