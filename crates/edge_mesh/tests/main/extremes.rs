//! Eyes on vertices, edges through the near plane, empty meshes, meshes far from the origin: no panic, no stray ink.

use crate::scene::{self, PATHS, any_view, count, differing, drawn, framed, ink, method, picture_of};
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::view::{Camera, Projection};
use silhouette_core::{TriangleMesh, Viewpoint};
use silhouette_gpu::FrameRenderer;
use silhouette_render::{DEFAULT_FORMATS, Image};
use silhouette_testing::edits::{inside_out, mapped, transformed};
use silhouette_testing::{builtin, gpu_or_skip, views, zoo};

/// Pixels of ink farther than `reach` pixels from every silhouette edge as a camera sees it: sampled along each, before the eye.
fn stray(image: &Image, mesh: &TriangleMesh, camera: &Camera, reach: f64) -> usize {
    let size = image.width as usize;
    let mut near = vec![false; size * size];
    for record in &**method(mesh, &[]).records() {
        let [a, b] = record.ends().map(|end| mesh.positions()[end.index()].as_dvec3());
        let steps = 4 * size;
        for step in 0..=steps {
            let Some(seen) = camera.project(a.lerp(b, step as f64 / steps as f64)) else { continue };
            let [x, y] = [seen.pixel.x, seen.pixel.y];
            if !(-reach..size as f64 + reach).contains(&x) || !(-reach..size as f64 + reach).contains(&y) {
                continue;
            }
            let span =
                |at: f64| ((at - reach).floor().max(0.0) as usize)..((at + reach).ceil().max(0.0) as usize).min(size);
            for row in span(y) {
                for column in span(x) {
                    near[row * size + column] = true;
                }
            }
        }
    }
    image.rgba.chunks_exact(4).zip(&near).filter(|(pixel, near)| pixel[0] == 0 && !**near).count()
}

#[test]
fn an_eye_on_a_vertex_or_amid_the_mesh_draws_nothing_away_from_edges() {
    let Some(gpu) = gpu_or_skip("an_eye_on_a_vertex_or_amid_the_mesh_draws_nothing_away_from_edges") else { return };
    for mesh in [builtin("cube"), builtin("cone"), builtin("grid:3,2")] {
        let corner = mesh.positions()[0];
        let [a, b, _] = mesh.triangles()[0].map(|vertex| mesh.positions()[vertex as usize]);
        let eyes = [corner, 0.5 * (a + b), 0.9 * corner + Vec3::splat(0.01), corner * 1.01];
        for eye in eyes {
            let camera = views::look(eye, Vec3::new(0.05, 0.1, 0.15), 70.0, [128; 2]);
            for path in PATHS {
                for words in [&[path, "width=3"][..], &[path, "width=3", "facing=device"]] {
                    let image = picture_of(gpu, &mesh, words, &any_view(&mesh, &camera));
                    assert_eq!(stray(&image, &mesh, &camera, 8.0), 0, "{words:?} from {eye}");
                }
            }
        }
    }
}

#[test]
fn edges_through_the_near_plane_are_drawn_as_far_as_they_are_in_front_of_it() {
    let Some(gpu) = gpu_or_skip("edges_through_the_near_plane_are_drawn_as_far_as_they_are_in_front_of_it") else {
        return;
    };
    // A long beam that begins behind the eye.
    let mesh = mapped(&builtin("cube"), |p| Vec3::new(0.3 * p.x, 0.3 * p.y, 10.0 * p.z));
    let camera = views::look(Vec3::new(0.9, 0.7, 5.0), Vec3::new(0.0, 0.0, -5.0), 60.0, [256; 2]);
    for path in PATHS {
        let image = picture_of(gpu, &mesh, &[path, "width=3"], &any_view(&mesh, &camera));
        assert_eq!(stray(&image, &mesh, &camera, 8.0), 0, "{path}");
        // Both edges of the beam run to the border of the picture.
        let border = (0..256)
            .filter(|&at| [[at, 0], [at, 255], [0, at], [255, at]].iter().any(|&[x, y]| image.pixel(x, y)[0] == 0));
        assert!(border.count() >= 6, "{path}");
    }
}

#[test]
fn empty_meshes_and_single_triangles() {
    let Some(gpu) = gpu_or_skip("empty_meshes_and_single_triangles") else { return };
    let empty = zoo::empty();
    let single = TriangleMesh::new(vec![Vec3::ZERO, Vec3::X, Vec3::Y], vec![[0, 1, 2]]).unwrap();
    let camera = views::look(Vec3::new(0.4, 0.3, 3.0), Vec3::new(0.4, 0.3, 0.0), 40.0, [64; 2]);
    for path in PATHS {
        for words in
            [&[path][..], &[path, "facing=device", "ridge-angle=10", "valley-angle=10"], &["arithmetic=as-printed"]]
        {
            let image = picture_of(gpu, &empty, words, &any_view(&empty, &camera));
            assert_eq!(count(&image, |value| value != 128), 0, "{words:?}");
        }
        let image = picture_of(gpu, &single, &[path], &any_view(&single, &camera));
        assert!(ink(&image) > 100 && count(&image, |value| value == 255) > 100, "{path}");
        // From behind it has an outline only where that is asked for.
        let behind = views::look(Vec3::new(0.4, 0.3, -3.0), Vec3::new(0.4, 0.3, 0.0), 40.0, [64; 2]);
        let of = |words: &[&str]| ink(&picture_of(gpu, &single, words, &any_view(&single, &behind)));
        assert!(of(&[path, "boundaries=all"]) > 100 && of(&[path]) == 0, "{path}");
    }
    assert_eq!((method(&empty, &[]).records().len(), method(&single, &[]).records().len()), (0, 3));
}

#[test]
fn a_mesh_far_from_the_origin_is_drawn_as_at_the_origin() {
    let Some(gpu) = gpu_or_skip("a_mesh_far_from_the_origin_is_drawn_as_at_the_origin") else { return };
    // On a lattice on which 32-bit floats are exact a million units away.
    let lattice = mapped(&builtin("blob:600,0.4"), |p| (p * 16.0).round() / 16.0 * 16.0);
    let offset = DVec3::new(1e6, -1e6, 5e5);
    let far = transformed(&lattice, 1.0, offset);
    let eye = Vec3::new(40.0, 24.0, 64.0);
    let projection = Projection::Perspective { fov_y_rad: 0.6 };
    let at = |offset: Vec3| Camera::new(eye + offset, offset, Vec3::Y, projection, [200; 2]).unwrap();
    for path in PATHS {
        for facing in ["facing=exact", "facing=device"] {
            let near = picture_of(gpu, &lattice, &[path, facing], &any_view(&lattice, &at(Vec3::ZERO)));
            let away = picture_of(gpu, &far, &[path, facing], &any_view(&far, &at(offset.as_vec3())));
            assert!(ink(&near) > 500 && differing(&near, &away) < 10, "{path} {facing}: {}", differing(&near, &away));
        }
    }
}

#[test]
fn any_unit_of_length_is_drawn_the_same() {
    let Some(gpu) = gpu_or_skip("any_unit_of_length_is_drawn_the_same") else { return };
    let mesh = builtin("knot");
    let of = |mesh: &TriangleMesh, path: &str, facing: &str| {
        picture_of(gpu, mesh, &[path, facing, "width=3", "ridge-angle=50"], &any_view(mesh, &framed(mesh, 128)))
    };
    for path in PATHS {
        for facing in ["facing=exact", "facing=device"] {
            let unit = of(&mesh, path, facing);
            for scale in [1e-12, 1e-9, 1e9] {
                let scaled = of(&transformed(&mesh, scale, DVec3::ZERO), path, facing);
                assert!(ink(&unit) > 500 && differing(&unit, &scaled) < 20, "{scale} {path} {facing}");
            }
        }
    }
}

#[test]
fn inverted_symmetric_and_axis_views_draw_lines_along_edges_alone() {
    let Some(gpu) = gpu_or_skip("inverted_symmetric_and_axis_views_draw_lines_along_edges_alone") else { return };
    let cube = builtin("cube");
    for mesh in [&cube, &inside_out(&cube), &builtin("uv-sphere:12,8")] {
        for direction in silhouette_testing::directions::AXES {
            for framing in [views::PERSPECTIVE, silhouette_core::view::Framing::Orthographic] {
                let camera = views::framed(mesh, direction, framing, [128; 2]);
                for path in PATHS {
                    let image = picture_of(gpu, mesh, &[path, "width=3"], &any_view(mesh, &camera));
                    assert!(ink(&image) > 300, "{path} from {direction}: {}", ink(&image));
                    assert_eq!(stray(&image, mesh, &camera, 6.0), 0, "{path} from {direction}");
                }
            }
        }
    }
}

#[test]
fn a_cube_from_an_axis_has_four_silhouette_edges_in_either_projection() {
    let Some(gpu) = gpu_or_skip("a_cube_from_an_axis_has_four_silhouette_edges_in_either_projection") else { return };
    let mesh = builtin("cube");
    let mut renderer = scene::renderer_of(gpu, &method(&mesh, &[]), &scene::buffers(gpu, &mesh), DEFAULT_FORMATS);
    for direction in silhouette_testing::directions::AXES {
        for framing in [views::PERSPECTIVE, silhouette_core::view::Framing::Orthographic] {
            let view = any_view(&mesh, &views::framed(&mesh, direction, framing, [16; 2]));
            let lists = drawn(gpu, &mut renderer, &view);
            assert_eq!(lists.silhouettes.len(), 4, "{direction}");
            let Viewpoint::Perspective { .. } = view.viewpoint() else { continue };
            renderer.prepare(gpu.device(), gpu.queue(), &view).unwrap();
        }
    }
}
