//! Volumes of closed and open meshes against edge counts and ray casts, and proof that both can fail.

use super::*;
use silhouette_core::facing::{Facing, judge};
use silhouette_core::glam::{Vec3, Vec4};
use silhouette_testing::{builtin, edits, real_mesh};

fn scene(mesh: TriangleMesh) -> Scene {
    Scene::new(mesh).unwrap()
}

/// The faces of a mesh that lie below a height.
fn below(mesh: &TriangleMesh, height: f32) -> TriangleMesh {
    let is_below = |vertex: u32| mesh.positions()[vertex as usize].y < height;
    edits::keeping(mesh, |face| mesh.triangles()[face].into_iter().all(is_below))
}

/// Three pages at one spine, wound as they come: cut where they meet.
fn pages() -> TriangleMesh {
    let page = |x: f32, z: f32| [Vec3::new(x, 0.9, z), Vec3::new(x * 0.8, -0.7, z)];
    let positions = [[Vec3::Y, Vec3::NEG_Y], page(1.0, 0.1), page(-0.4, 0.8), page(-0.5, -0.9)].concat();
    let triangles = vec![[0, 1, 2], [1, 3, 2], [1, 0, 4], [1, 4, 5], [0, 1, 6], [1, 7, 6]];
    TriangleMesh::new(positions, triangles).unwrap()
}

/// Extrudes the loops of a light that goes around; every volume must be closed, every checked point right. Yields what
/// the points said.
fn assert_right(name: &str, scene: &Scene, caps: Caps, [frames, step_deg, points]: [u32; 3]) -> ShadowCount {
    let mut total = ShadowCount::default();
    for kind in [LightKind::Point, LightKind::Directional] {
        for reach in scene.reaches() {
            let (mut tracker, mut volume) = (scene.tracker().unwrap(), scene.volume(caps, reach).unwrap());
            for frame in 0..frames {
                let light = scene.light(kind, f64::from(frame * step_deg));
                volume.extrude(&light, tracker.update(&light));
                let context = format!("{name}, {caps:?}, {reach:?}, {light:?}");
                let surface = Surface { positions: volume.positions(), triangles: volume.triangles() };
                let edges = count_edges(surface.triangles);
                assert!(edges.unmatched == 0 && (edges.edges > 0 || caps == Caps::FrontTwice), "{context}: {edges:?}");
                let shadows = count_shadows(surface, LitScene { mesh: &scene.mesh, light: &light, caps }, points);
                assert_eq!(shadows.wrong, 0, "{context}: {shadows:?}");
                total.add(shadows);
            }
        }
    }
    // Few say nothing, and both answers occur often.
    assert!(total.skipped <= total.samples / 100, "{name}, {caps:?}: {total:?}");
    assert!(total.shadowed > total.samples / 50 && total.shadowed < total.samples / 2, "{name}, {caps:?}: {total:?}");
    total
}

#[test]
fn closed_meshes_by_every_rule() {
    for name in ["torus:30,18", "gear", "blob:1200", "knot:2,3,80,10", "cube"] {
        let scene = scene(builtin(name));
        assert_eq!(Caps::fitting(&scene.table, &scene.mesh), Caps::FrontAndBack);
        let by_rule: Vec<_> =
            scene.rules().iter().map(|&caps| assert_right(name, &scene, caps, [12, 31, 60]).shadowed).collect();
        // The light is outside, so all rules give the same shadow.
        assert_eq!(by_rule, [by_rule[0]; 3], "{name}");
    }
}

#[test]
fn open_and_cut_meshes_by_both_rules() {
    let bowl = below(&builtin("icosphere:3"), 0.25);
    let meshes = [("bowl", bowl), ("pages", pages())];
    let builtin = ["grid:14,10,0.6", "moebius"].map(|name| (name, builtin(name)));
    for (name, mesh) in meshes.into_iter().chain(builtin) {
        let scene = scene(mesh);
        assert_eq!(Caps::fitting(&scene.table, &scene.mesh), Caps::Doubled, "{name}");
        let [culled, all] =
            [Caps::FrontTwice, Caps::Doubled].map(|caps| assert_right(name, &scene, caps, [12, 31, 80]));
        assert!(culled.shadowed <= all.shadowed, "{name}: {culled:?} {all:?}");
        let refused = scene.volume(Caps::FrontAndBack, Reach::Infinite).unwrap_err();
        assert!(refused.to_string().contains("half-edges have nothing across"), "{name}: {refused}");
    }
}

/// A light that sees only backs: nothing casts unless faces are doubled. Then the boundary alone makes the sides.
#[test]
fn a_sheet_seen_from_behind_casts_by_doubled_faces_only() {
    let scene = scene(builtin("grid:6,4"));
    let light = Viewpoint::Perspective { eye: Vec3::new(0.3, -2.0, 0.2) };
    let mut tracker = scene.tracker().unwrap();
    let loops = tracker.update(&light);
    assert!(loops.is_empty());
    let look = |caps| {
        let mut volume = scene.volume(caps, Reach::Infinite).unwrap();
        volume.extrude(&light, loops);
        let surface = Surface { positions: volume.positions(), triangles: volume.triangles() };
        let shadows = count_shadows(surface, LitScene { mesh: &scene.mesh, light: &light, caps }, 100);
        assert_eq!((count_edges(surface.triangles).unmatched, shadows.wrong), (0, 0), "{caps:?}");
        ([volume.front_cap().len(), volume.sides().len(), volume.back_cap().len()], shadows.shadowed > 0)
    };
    assert_eq!(look(Caps::FrontTwice), ([0, 0, 0], false));
    assert_eq!(look(Caps::Doubled), ([48, 2 * 20, 48], true));
}

/// Only doubled faces know of a shadow that no front face casts: that of a body around the light.
#[test]
fn a_light_inside_needs_doubled_faces() {
    let scene = scene(builtin("icosphere:2"));
    let light = Viewpoint::Perspective { eye: Vec3::new(0.1, 0.2, -0.15) };
    let mut tracker = scene.tracker().unwrap();
    let loops = tracker.update(&light);
    let wrong = [Caps::FrontAndBack, Caps::Doubled].map(|caps| {
        let mut volume = scene.volume(caps, Reach::Infinite).unwrap();
        volume.extrude(&light, loops);
        let surface = Surface { positions: volume.positions(), triangles: volume.triangles() };
        assert_eq!(count_edges(surface.triangles).unmatched, 0);
        count_shadows(surface, LitScene { mesh: &scene.mesh, light: &light, caps }, 200).wrong
    });
    assert!(wrong[0] > 100 && wrong[1] == 0, "{wrong:?}");
}

#[test]
fn a_directional_light_at_infinity_has_one_far_vertex_and_no_back_cap() {
    let scene = scene(builtin("cube"));
    let light = Viewpoint::Orthographic { toward_viewer: Vec3::new(1.0, 2.0, 3.0) };
    let mut volume = scene.volume(Caps::FrontAndBack, Reach::Infinite).unwrap();
    volume.extrude(&light, scene.tracker().unwrap().update(&light));
    assert_eq!(volume.positions()[8..], [Vec4::new(-1.0, -2.0, -3.0, 0.0)]);
    // Three sides of the cube, and a hexagon around them.
    assert_eq!([volume.front_cap().len(), volume.sides().len(), volume.back_cap().len()], [6, 6, 0]);
}

/// A side dropped, a cap turned over, a cap left out, a loop missed: each check notices each of them.
#[test]
fn both_checks_notice_a_broken_volume() {
    for name in ["cube", "grid:2,1,0.5"] {
        let scene = scene(builtin(name));
        let caps = Caps::fitting(&scene.table, &scene.mesh);
        let light = scene.light(LightKind::Point, 50.0);
        let mut tracker = scene.tracker().unwrap();
        let mut volume = scene.volume(caps, Reach::Infinite).unwrap();
        volume.extrude(&light, tracker.update(&light));
        let (front, sides) = (volume.front_cap().len(), volume.sides().len());
        let whole = volume.triangles().to_vec();
        let judge = |triangles: &[[u32; 3]]| {
            let surface = Surface { positions: volume.positions(), triangles };
            let lit = LitScene { mesh: &scene.mesh, light: &light, caps };
            (count_edges(triangles).unmatched, count_shadows(surface, lit, 1500).wrong)
        };
        assert_eq!(judge(&whole), (0, 0), "{name}");
        let without = |range: std::ops::Range<usize>| {
            let mut triangles = whole.clone();
            triangles.drain(range);
            triangles
        };
        let reversed = |range: std::ops::Range<usize>| {
            let mut triangles = whole.clone();
            triangles[range].iter_mut().for_each(|triangle| triangle.reverse());
            triangles
        };
        let (side, back) = (front..front + 2, front + sides..whole.len());
        for (what, broken) in [
            ("a side dropped", without(side.clone())),
            ("a side turned over", reversed(side)),
            ("the front cap turned over", reversed(0..front)),
            ("the back cap turned over", reversed(back.clone())),
            ("the back cap dropped", without(back)),
        ] {
            let (unmatched, wrong) = judge(&broken);
            assert!(unmatched > 0 && wrong > 0, "{name}, {what}: {unmatched} unmatched, {wrong} wrong");
        }
    }
    // No loops at all: caps without sides.
    let scene = scene(builtin("cube"));
    let mut volume = scene.volume(Caps::FrontTwice, Reach::Infinite).unwrap();
    volume.extrude(&scene.light(LightKind::Point, 0.0), &Default::default());
    assert!(count_edges(volume.triangles()).unmatched > 0);
}

/// Facings that are followed equal those that are judged, over jumps of the light to anywhere, through the surface too.
#[test]
fn the_front_cap_holds_the_faces_that_face_the_light() {
    for name in ["blob:1500", "gear", "grid:20,14,0.8", "moebius", "cube"] {
        let scene = scene(builtin(name));
        let mut tracker = scene.tracker().unwrap();
        let mut volume = scene.volume(Caps::FrontTwice, Reach::Infinite).unwrap();
        for index in 0..400_u16 {
            let t = f32::from(index);
            let toward = Vec3::new((1.3 * t).sin(), (2.9 * t).cos(), (0.7 * t).sin());
            let light = match index % 5 {
                0 | 1 => Viewpoint::Perspective { eye: toward * 0.4 },
                2 | 3 => Viewpoint::Perspective { eye: toward * 3.0 },
                _ => Viewpoint::Orthographic { toward_viewer: toward },
            };
            volume.extrude(&light, tracker.update(&light));
            let is_front = |triangle: &&[u32; 3]| {
                judge(triangle.map(|vertex| scene.mesh.positions()[vertex as usize]), &light).facing == Facing::Front
            };
            let expected = scene.mesh.triangles().iter().filter(is_front);
            assert!(volume.front_cap().iter().eq(expected), "{name}, light {index}: {light:?}");
        }
    }
}

/// Once a light has gone around, going around again allocates nothing.
#[test]
fn a_steady_frame_allocates_nothing() {
    let scene = scene(builtin("blob:3000"));
    for kind in [LightKind::Point, LightKind::Directional] {
        for &caps in scene.rules() {
            let (mut tracker, mut volume) = (scene.tracker().unwrap(), scene.volume(caps, Reach::Infinite).unwrap());
            let mut fly = || {
                for frame in 0..60 {
                    let light = scene.light(kind, f64::from(6 * frame));
                    volume.extrude(&light, tracker.update(&light));
                }
            };
            let first = allocation_counter::measure(&mut fly).count_total;
            fly();
            assert_eq!((first > 0, allocation_counter::measure(&mut fly).count_total), (true, 0), "{kind:?} {caps:?}");
        }
    }
}

/// Lights in a vertex, in the plane of a face, far away: closed in any case, and nothing that is not a number.
#[test]
fn degenerate_lights_leave_the_volume_closed_and_finite() {
    let scene = scene(builtin("cube"));
    let corner = scene.mesh.positions()[3];
    for eye in [corner, corner * Vec3::new(1.0, 1.0, 5.0), Vec3::ZERO, Vec3::splat(1e30), corner * (1.0 + 1e-7)] {
        let light = Viewpoint::Perspective { eye };
        for &caps in scene.rules() {
            for reach in scene.reaches() {
                let mut volume = scene.volume(caps, reach).unwrap();
                volume.extrude(&light, scene.tracker().unwrap().update(&light));
                assert_eq!(count_edges(volume.triangles()).unmatched, 0, "{caps:?} {reach:?} {eye}");
                assert!(volume.positions().iter().all(|position| position.is_finite()), "{caps:?} {reach:?} {eye}");
            }
        }
    }
}

/// The folder that `SILHOUETTES_MODELS` names, for those of these meshes that it holds.
#[test]
fn real_meshes() {
    for name in ["armadillo.obj", "suzanne.obj", "teapot.obj", "head.off", "dragon.ply"] {
        let Some(mesh) = real_mesh("real_meshes", name) else { continue };
        let scene = scene(mesh);
        let effort = if scene.mesh.face_count() < 10_000 { [4, 80, 40] } else { [2, 100, 12] };
        let is_closed = Caps::fitting(&scene.table, &scene.mesh) == Caps::FrontAndBack;
        assert_eq!(is_closed, name == "armadillo.obj", "{name}");
        for &caps in scene.rules() {
            assert_right(name, &scene, caps, effort);
        }
    }
}

#[test]
fn bad_input_is_refused_in_a_line() {
    let missing = "no-such-file.obj";
    for (words, expected) in [
        (vec!["builtin:teapoy"], "no built-in shape"),
        (vec![missing], missing),
        (vec!["builtin:cube", "0"], "FRAMES"),
        (vec!["builtin:cube", "-3"], "FRAMES"),
        (vec!["builtin:cube", "3", "4"], "one argument too many"),
    ] {
        let words: Vec<String> = words.into_iter().map(str::to_owned).collect();
        let mut out = Vec::new();
        let failure = run(&words, &mut out).unwrap_err();
        let line = failure.to_string();
        assert!(matches!(failure, Failure::BadInput(_)) && line.contains(expected), "{words:?}: {line}");
        assert_eq!((line.lines().count(), out.len()), (1, 0), "{words:?}: {line}");
    }
    let no_faces = Scene::new(TriangleMesh::new(vec![Vec3::ZERO], vec![]).unwrap());
    assert!(no_faces.err().unwrap().to_string().contains("no faces"));
}

#[test]
fn the_report_has_a_line_for_each_rule_light_and_reach() {
    let words = ["builtin:torus:12,8", "5"].map(str::to_owned);
    let mut out = Vec::new();
    run(&words, &mut out).unwrap();
    let text = String::from_utf8(out).unwrap();
    assert_eq!(text.lines().count(), 2 + 2 * 3 * 2, "{text}");
    assert!(text.lines().skip(2).all(|line| line.ends_with("      0")), "{text}");
}
