//! Lines that are no mesh edges: intersections and smooth curves; several objects; labels; the cache.

use crate::scenes::{finder, framing};
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::view::Projection;
use silhouette_core::{Camera, FaceId, NoProgress, TriangleMesh};
use silhouette_testing::builtin;
use silhouette_testing::edits::moved;
use silhouette_testing::prepare::prepared;
use silhouette_visibility::{CurvePiece, LineCache, LineFinder, LineKind, LineOptions, LineScene, Lines, SceneError};
use std::sync::Arc;

fn find(scene: LineScene, direction: DVec3, options: &LineOptions) -> Lines {
    let camera = framing(scene.mesh().mesh(), direction, true);
    LineFinder::new(scene, &NoProgress).unwrap().find(&camera, options, &NoProgress).unwrap()
}

fn length(lines: &Lines, kind: LineKind, visible: bool) -> f64 {
    let wanted = |chain: &silhouette_visibility::Chain<'_>| {
        chain.style.kind == kind && (chain.style.invisibility == 0) == visible
    };
    lines.chains.iter().filter(wanted).map(|chain| chain.length_px()).sum()
}

#[test]
fn the_line_in_which_two_cubes_meet_is_closed_and_half_hidden() {
    let cube = builtin("cube");
    let other = moved(&cube, Vec3::new(0.31, -0.42, 0.23));
    let options = LineOptions { intersection: true, max_invisibility: u32::MAX, ..LineOptions::default() };
    let scene = LineScene::of_meshes(&[&cube, &other]).unwrap();
    let lines = find(scene, DVec3::new(0.5, 0.6, 1.0), &options);
    let (visible, hidden) =
        (length(&lines, LineKind::Intersection, true), length(&lines, LineKind::Intersection, false));
    assert!(visible > 100.0 && hidden > 100.0, "{visible} {hidden}");
    let ends = lines.chains.iter().filter(|chain| chain.style.kind == LineKind::Intersection && !chain.closed).count();
    assert!(ends >= 2, "it changes between visible and hidden");
    let objects: std::collections::BTreeSet<u32> = lines.chains.iter().map(|chain| chain.style.object).collect();
    assert_eq!(objects.into_iter().collect::<Vec<_>>(), [0, 1]);
    let without = LineOptions { intersection: false, ..options };
    let scene = LineScene::of_meshes(&[&cube, &other]).unwrap();
    assert!(
        find(scene, DVec3::new(0.5, 0.6, 1.0), &without).chains.iter().all(|c| c.style.kind != LineKind::Intersection)
    );
}

/// Cubes that share part of a side, an edge or a corner only touch. Moved into each other by one unit in the last place, they
/// intersect.
#[test]
fn surfaces_that_touch_do_not_intersect() {
    let cube = builtin("cube");
    let side = (cube.positions()[0].x * 2.0).abs();
    let options = LineOptions { intersection: true, max_invisibility: u32::MAX, ..LineOptions::default() };
    let drawn = |by: Vec3| {
        let lines =
            find(LineScene::of_meshes(&[&cube, &moved(&cube, by)]).unwrap(), DVec3::new(0.5, 0.6, 1.0), &options);
        lines.chains.iter().filter(|chain| chain.style.kind == LineKind::Intersection).count()
    };
    for by in [
        Vec3::new(side, 0.0, 0.0),
        Vec3::new(side, side * 0.25, side * 0.5),
        Vec3::new(side, side, side * 0.5),
        Vec3::new(side, side, side),
    ] {
        assert_eq!(drawn(by), 0, "{by}");
    }
    assert!(drawn(Vec3::new(side.next_down(), side * 0.25, side * 0.5)) > 0);
}

/// A circle of radius 1.3 about an icosphere of radius 1, as four cubic pieces.
fn ring() -> Vec<CurvePiece> {
    let (radius, handle) = (1.3_f32, 1.3_f32 * 0.552_284_8);
    let corner = [Vec3::X, Vec3::Z, Vec3::NEG_X, Vec3::NEG_Z];
    (0..4)
        .map(|quarter| {
            let (from, to) = (corner[quarter], corner[(quarter + 1) % 4]);
            let control = [from * radius, from * radius + to * handle, to * radius + from * handle, to * radius];
            CurvePiece { control, on_faces: Vec::new(), kind: LineKind::Curve, object: 0 }
        })
        .collect()
}

#[test]
fn a_ring_around_a_ball_is_hidden_behind_it() {
    let ball = builtin("icosphere:4");
    let scene = LineScene::new(prepared(ball)).with_curves(ring()).unwrap();
    let options = LineOptions { max_invisibility: u32::MAX, ..LineOptions::default() };
    // From 20 degrees above the ring's plane.
    let (sin, cos) = 20_f64.to_radians().sin_cos();
    let eye = Vec3::new(0.0, sin as f32, cos as f32) * 5.0;
    let projection = Projection::Orthographic { height: 3.0 };
    let camera = Camera::new(eye, Vec3::ZERO, Vec3::Y, projection, [1024, 1024]).unwrap();
    let lines = LineFinder::new(scene, &NoProgress).unwrap().find(&camera, &options, &NoProgress).unwrap();
    // A point of the ring at azimuth u (0 towards the viewer) appears at (1.3 sin u, 1.3 sin 20 cos u) radii: inside of the
    // ball's disc, and farther than its middle, where cos u < 0 and sin^2 u + sin^2 20 cos^2 u < 1 / 1.69.
    let limit = ((1.0 - 1.0 / 1.69) / (1.0 - sin * sin)).sqrt();
    let expected_hidden = 2.0 * limit.acos() / std::f64::consts::TAU;
    let share = |visible: bool| -> f64 {
        let chains = lines.chains.iter().filter(|chain| chain.style.kind == LineKind::Curve);
        let chains = chains.filter(|chain| (chain.style.invisibility == 0) == visible);
        chains.flat_map(|chain| chain.points.windows(2).map(|ends| ends[0].distance(ends[1])).collect::<Vec<_>>()).sum()
    };
    let (visible, hidden) = (share(true), share(false));
    assert!((hidden / (visible + hidden) - expected_hidden).abs() < 0.01, "{hidden} {visible} {expected_hidden}");
    let curves: Vec<_> = lines.chains.iter().filter(|chain| chain.style.kind == LineKind::Curve).collect();
    assert_eq!(curves.len(), 2, "one visible and one hidden chain, joined across pieces");
    for chain in curves {
        assert_eq!(chain.handles.len(), chain.sources.len());
        for (segment, handles) in chain.handles.iter().enumerate() {
            let [from, to] = chain.segment_pixels(segment);
            // Handles lie a third along a flat enough piece.
            assert!(handles[0].distance(from.lerp(to, 1.0 / 3.0)) < 0.2 * from.distance(to) + 1e-9);
            assert!(handles[1].distance(from.lerp(to, 2.0 / 3.0)) < 0.2 * from.distance(to) + 1e-9);
        }
    }
}

#[test]
fn a_curve_is_of_the_kind_that_it_was_given() {
    let of_kind = |kind| ring().into_iter().map(|piece| CurvePiece { kind, ..piece }).collect();
    let scene = LineScene::new(prepared(builtin("icosphere:4")));
    let scenes = [LineKind::Silhouette, LineKind::Ridge].map(|kind| scene.clone().with_curves(of_kind(kind)).unwrap());
    assert_ne!(scenes[0].fingerprint(), scenes[1].fingerprint());
    let options = LineOptions { silhouette: false, ..LineOptions::default() };
    for (scene, kind) in scenes.into_iter().zip([LineKind::Silhouette, LineKind::Ridge]) {
        let lines = find(scene, DVec3::Z, &options);
        assert!(!lines.chains.is_empty() && lines.chains.iter().all(|chain| chain.style.kind == kind));
    }
}

#[test]
fn faces_that_a_curve_lies_on_do_not_hide_it() {
    let square =
        TriangleMesh::new(vec![Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::ONE.with_z(0.0)], vec![[0, 1, 2], [2, 1, 3]]);
    let mesh = prepared(square.unwrap());
    let at = |x: f32| Vec3::new(x, 0.5, -0.001);
    let hidden_length = |on_faces: Vec<FaceId>| {
        let control = [at(0.1), at(0.3), at(0.6), at(0.9)];
        let piece = CurvePiece { control, on_faces, kind: LineKind::Curve, object: 0 };
        let scene = LineScene::new(Arc::clone(&mesh)).with_curves(vec![piece]).unwrap();
        let options = LineOptions { max_invisibility: u32::MAX, ..LineOptions::default() };
        length(&find(scene, DVec3::Z, &options), LineKind::Curve, false)
    };
    let both = vec![FaceId::new(0), FaceId::new(1)];
    assert!(hidden_length(Vec::new()) > 100.0);
    assert!(hidden_length(both) == 0.0);
    let half = hidden_length(vec![FaceId::new(0)]);
    assert!(half > 50.0 && half < hidden_length(Vec::new()) * 0.7, "{half}");
}

#[test]
fn lines_are_drawn_between_labels_which_must_fit() {
    let cube = builtin("icosphere:2");
    let labels = (0..cube.face_count() as u32).map(|face| u32::from(face < 100)).collect();
    let mesh = prepared(cube);
    let scene = LineScene::new(Arc::clone(&mesh)).with_labels(labels).unwrap();
    let options = LineOptions { max_invisibility: u32::MAX, ..LineOptions::default() };
    assert!(length(&find(scene, DVec3::ONE, &options), LineKind::Material, true) > 10.0);
    let error = LineScene::new(mesh).with_labels(vec![0; 3]).unwrap_err();
    assert_eq!(error, SceneError::PerFace { what: "labels", given: 3, faces: 320 });
}

/// A mask hides what it hid before, and is not drawn; what the faces belong to changes nothing but that.
#[test]
fn masks_hide_without_being_drawn() {
    let (cube, torus) = (builtin("cube"), builtin("torus"));
    let near = moved(&torus, Vec3::new(0.6, 0.5, 0.7));
    let scene = LineScene::of_meshes(&[&cube, &near]).unwrap();
    let cube_faces = cube.face_count() as u32;
    let objects: Vec<u32> =
        (0..(cube_faces + near.face_count() as u32)).map(|face| u32::from(face >= cube_faces)).collect();
    let is_mask: Vec<bool> = objects.iter().map(|object| *object == 1).collect();
    let options = LineOptions { intersection: true, max_invisibility: u32::MAX, mesh: true, ..LineOptions::default() };
    let of_cube = |lines: &Lines| -> Vec<_> {
        let chains = lines.chains.iter().filter(|chain| chain.style.object == 0);
        chains.map(|chain| (chain.style, chain.pixels.to_vec())).collect()
    };
    let plain = find(scene.clone(), DVec3::ONE, &options);
    let masked = find(scene.clone().with_masks(is_mask).unwrap(), DVec3::ONE, &options);
    assert!(plain.chains.iter().any(|chain| chain.style.object == 1));
    assert!(masked.chains.iter().all(|chain| chain.style.object == 0));
    assert_eq!(of_cube(&masked), of_cube(&plain));
    assert!(length(&masked, LineKind::Silhouette, false) > 1.0, "the mask hides something");

    let same = find(scene.clone().with_objects(objects.clone()).unwrap(), DVec3::ONE, &options);
    assert_eq!(same.chains, plain.chains);
    let apart = objects.iter().map(|object| object + 3).collect();
    assert_eq!(scene.clone().with_objects(apart).unwrap().object_count(), 5);
    let error = scene.clone().with_masks(vec![true]).unwrap_err();
    assert!(matches!(error, SceneError::PerFace { what: "masks", given: 1, .. }), "{error}");
    assert!(matches!(scene.with_objects(vec![]).unwrap_err(), SceneError::PerFace { what: "objects", .. }));
}

#[test]
fn the_cache_finds_a_view_once() {
    let mesh = builtin("knot");
    let camera = framing(&mesh, DVec3::ONE, true);
    let mut knot = finder(mesh.clone());
    let (mut cache, options) = (LineCache::new(2), LineOptions::default());
    let mut find = |camera, options: &LineOptions| cache.find(&mut knot, camera, options, &NoProgress).unwrap();
    let first = find(&camera, &options);
    assert!(Arc::ptr_eq(&first, &find(&camera, &options)));
    let hidden = LineOptions { max_invisibility: 1, ..options.clone() };
    assert!(!Arc::ptr_eq(&first, &find(&camera, &hidden)));
    assert!(Arc::ptr_eq(&first, &find(&camera, &options)), "still among the last two");
    let other = camera.with_size([512, 512]).unwrap();
    find(&other, &hidden);
    find(&other, &options);
    assert!(!Arc::ptr_eq(&first, &find(&camera, &options)), "forgotten, found again");
    let (again, elsewhere) = (finder(mesh.clone()), finder(moved(&mesh, Vec3::X)));
    assert_eq!(knot.scene().fingerprint(), again.scene().fingerprint());
    assert_ne!(knot.scene().fingerprint(), elsewhere.scene().fingerprint());
}
