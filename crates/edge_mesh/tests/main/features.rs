//! Ridges, valleys and creases: which edges they are, and how they are drawn.

use crate::scene::{self, GROUND, PATHS, count, drawn, framed, method, picture};
use silhouette_core::glam::Vec3;
use silhouette_core::{FaceId, Method, MethodOptions, PreparedMesh, TriangleMesh, VertexId};
use silhouette_edge_mesh::edge_record::Bend;
use silhouette_edge_mesh::{EdgeMesh, EdgeMeshOptions, face_planes, oct_normal};
use silhouette_gpu::FrameRenderer;
use silhouette_render::{DEFAULT_FORMATS, view_of_mesh};
use silhouette_testing::edits::{moved, turned_over};
use silhouette_testing::{builtin, gpu_or_skip, zoo};
use std::sync::Arc;

/// Numbers of ridges and of valleys.
fn bends(method: &EdgeMesh) -> [usize; 2] {
    let of = |bend| method.records().iter().filter(|record| record.feature().is_some_and(|f| f.bend == bend)).count();
    let [ridges, valleys] = [Bend::Ridge, Bend::Valley].map(of);
    assert_eq!(method.feature_count(), ridges + valleys);
    let is_first = |(index, record): (usize, &silhouette_edge_mesh::EdgeRecord)| {
        record.feature().is_some() == (index < method.feature_count())
    };
    assert!(method.records().iter().enumerate().all(is_first), "features come first");
    [ridges, valleys]
}

#[test]
fn ridges_are_convex_and_valleys_concave_at_their_angles() {
    let cube = builtin("cube");
    for (words, expected) in [
        (&[][..], [0, 0]),
        (&["ridge-angle=90"], [12, 0]),
        (&["ridge-angle=91"], [0, 0]),
        (&["valley-angle=1"], [0, 0]),
        (&["ridge-angle=180"], [0, 0]),
    ] {
        assert_eq!(bends(&method(&cube, words)), expected, "{words:?}");
    }
    let hollow = turned_over(&cube, |_| true);
    assert_eq!(bends(&method(&hollow, &["ridge-angle=1", "valley-angle=90"])), [0, 12]);
    // One face of the twelve turned over is bent as before at each edge.
    let mended = turned_over(&cube, |face| face == 3);
    assert_eq!(bends(&method(&mended, &["ridge-angle=90", "valley-angle=90"])).iter().sum::<usize>(), 12);
    let gear = bends(&method(&builtin("gear"), &["ridge-angle=30", "valley-angle=30"]));
    assert!(gear[0] > 40 && gear[1] > 20, "{gear:?}");
}

#[test]
fn creases_of_the_file_are_drawn_where_they_are_asked_for() {
    let mesh = builtin("icosphere:2");
    let [a, b, _] = mesh.triangles()[0].map(VertexId::new);
    let prepared = Arc::new(PreparedMesh::new(mesh).with_feature_edges(vec![[b, a], [a, a]]));
    let count = |words: &[&str]| {
        let options = EdgeMeshOptions::parse(words.iter().copied()).unwrap();
        bends(&EdgeMesh::new(&prepared, options).unwrap())
    };
    assert_eq!((count(&[]), count(&["creases=given"])), ([0, 0], [1, 0]));
}

/// Two squares that meet at a right angle along the z axis, open towards the viewer or away from it.
fn folded(towards_viewer: bool) -> TriangleMesh {
    let depth = if towards_viewer { -1.0 } else { 1.0 };
    let at = |x: f32, y: f32| Vec3::new(x, y, depth * x.abs());
    let positions = vec![at(-1.0, -1.0), at(0.0, -1.0), at(0.0, 1.0), at(-1.0, 1.0), at(1.0, -1.0), at(1.0, 1.0)];
    TriangleMesh::new(positions, vec![[0, 1, 2], [0, 2, 3], [1, 4, 5], [1, 5, 2]]).unwrap()
}

#[test]
fn ridges_and_valleys_have_their_own_widths_and_colours() {
    let Some(gpu) = gpu_or_skip("ridges_and_valleys_have_their_own_widths_and_colours") else { return };
    let words =
        ["ridge-angle=60", "valley-angle=60", "ridge-width=4", "valley-width=8", "ridge-red=1", "valley-blue=1"];
    for path in PATHS {
        let words: Vec<&str> = words.into_iter().chain([path]).collect();
        for (towards_viewer, width, color) in [(true, 4, [255, 0, 0]), (false, 8, [0, 0, 255])] {
            let mesh = folded(towards_viewer);
            let camera = silhouette_testing::views::look(Vec3::Z * 5.0, Vec3::ZERO, 40.0, [200; 2]);
            let image = picture(gpu, &mesh, &camera, &words);
            // The line of the fold crosses the picture through its middle, along one of its axes.
            let on_line = image.rgba.chunks_exact(4).filter(|pixel| pixel[..3] == color).count();
            let length = image.rgba.chunks_exact(4).enumerate().filter(|(at, pixel)| {
                let (x, y) = (at % 200, at / 200);
                (x == 100 || y == 100) && pixel[..3] == color
            });
            let [short, long] = [width, on_line / width];
            assert!(length.count().abs_diff(short + long) <= short + 12, "{path}: {on_line} pixels, {width} wide");
            assert!(on_line > 70 * width, "{path}: {on_line}");
        }
    }
}

#[test]
fn silhouettes_cover_features_where_they_cross_and_replace_them_where_they_are_both() {
    let Some(gpu) = gpu_or_skip("silhouettes_cover_features_where_they_cross_and_replace_them_where_they_are_both")
    else {
        return;
    };
    let mesh = builtin("cube");
    let method = method(&mesh, &["ridge-angle=60"]);
    let buffers = scene::buffers(gpu, &mesh);
    let mut renderer = scene::renderer_of(gpu, &method, &buffers, DEFAULT_FORMATS);
    let lists = drawn(gpu, &mut renderer, &view_of_mesh(&framed(&mesh, 64), &buffers).unwrap());
    // Three faces are in front: six edges around them, three between them, and three at the back.
    assert_eq!((lists.silhouettes.len(), lists.features.len()), (6, 3));
    for path in PATHS {
        let words = [path, "width=9", "ridge-angle=60", "ridge-width=9", "ridge-red=1", "interior=none"];
        let [both, alone] = [&words[..], &[path, "width=9", "interior=none"]]
            .map(|words| picture(gpu, &mesh, &framed(&mesh, 256), words));
        let covered = both.rgba.chunks_exact(4).zip(alone.rgba.chunks_exact(4)).filter(|(_, alone)| alone[0] == 0);
        assert!(covered.clone().count() > 2000 && covered.into_iter().all(|(both, _)| both[0] == 0), "{path}");
        assert!(count(&both, |value| value == 255) > 500, "{path}: ridges are drawn");
    }
    assert!((GROUND[0] - 0.5).abs() < 1e-9);
}

/// A moving mesh finds its ridges and valleys anew: a flat sheet that is folded.
#[test]
fn bends_of_a_moving_mesh_are_those_of_this_frame() {
    let Some(gpu) = gpu_or_skip("bends_of_a_moving_mesh_are_those_of_this_frame") else { return };
    let flat = TriangleMesh::new(
        folded(true).positions().iter().map(|p| Vec3::new(p.x, p.y, 0.0)).collect(),
        folded(true).triangles().to_vec(),
    )
    .unwrap();
    for offset in [Vec3::ZERO, Vec3::new(30.0, -20.0, 10.0)] {
        let flat = moved(&flat, offset);
        let method = method(&flat, &["ridge-angle=90", "valley-angle=80"]);
        let buffers = scene::buffers(gpu, &flat);
        let mut renderer = scene::renderer_of(gpu, &method, &buffers, DEFAULT_FORMATS);
        let camera = silhouette_testing::views::look(offset + Vec3::new(0.3, 0.2, 5.0), offset, 40.0, [64; 2]);
        let view = scene::any_view(&flat, &camera);
        assert_eq!(drawn(gpu, &mut renderer, &view).features, []);
        for (towards_viewer, bend) in [(true, Bend::Ridge), (false, Bend::Valley)] {
            let positions: Vec<Vec3> = folded(towards_viewer).positions().iter().map(|&p| p + offset).collect();
            buffers.set_positions(gpu.queue(), &positions).unwrap();
            let features = drawn(gpu, &mut renderer, &view).features;
            assert_eq!(features.iter().map(|(_, bend)| *bend).collect::<Vec<_>>(), [bend]);
            let ends = method.records()[features[0].0 as usize].ends().map(VertexId::get);
            assert!(ends == [1, 2] || ends == [2, 1], "{ends:?}");
        }
        renderer.prepare(gpu.device(), gpu.queue(), &view).unwrap();
    }
}

/// What the device stores of this frame's normals is what its twin stores, and no farther from the true ones than the bound.
#[test]
fn normals_of_the_device_are_those_of_its_twin() {
    let Some(gpu) = gpu_or_skip("normals_of_the_device_are_those_of_its_twin") else { return };
    for mesh in [builtin("blob:3000,0.6"), builtin("cube"), zoo::book(5)] {
        let method = method(&mesh, &["ridge-angle=30"]);
        let buffers = scene::buffers(gpu, &mesh);
        let mut renderer = scene::renderer_of(gpu, &method, &buffers, DEFAULT_FORMATS);
        let view = scene::any_view(&mesh, &framed(&mesh, 16));
        drawn(gpu, &mut renderer, &view);
        assert!(renderer.normals().is_none(), "at rest, bends are known");
        buffers.set_positions(gpu.queue(), mesh.positions()).unwrap();
        drawn(gpu, &mut renderer, &view);
        let stored = scene::words_of(gpu, renderer.normals().unwrap());
        for face in (0..mesh.face_count()).map(FaceId::from_usize) {
            let local = mesh.corners(face).map(|corner| buffers.frame().to_local(corner.as_dvec3()));
            let [a, b, c] = local.map(Vec3::as_dvec3);
            let truth = (b - a).cross(c - a).normalize();
            for word in [stored[face.index()], face_planes::normal(local)] {
                let normal = oct_normal::decode(word).as_dvec3();
                let error_rad = normal.cross(truth).length().atan2(normal.dot(truth));
                // The cross product is rounded as well before it is stored.
                assert!(error_rad < oct_normal::ERROR_RAD + 1e-5, "face {face}: {error_rad}");
            }
        }
    }
}
