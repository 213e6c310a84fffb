//! The outline against the picture of all faces: what it encloses, and that it is a planar map.

use crate::scenes::{finder, framing};
use silhouette_core::glam::{DVec2, DVec3, Vec3};
use silhouette_core::view::Projection;
use silhouette_core::{Camera, NoProgress, TriangleMesh};
use silhouette_testing::directions::spread;
use silhouette_testing::edits::{inside_out, joined, keeping, moved};
use silhouette_testing::lattice_scenes::{FAMILIES, camera, scene, seeds};
use silhouette_testing::views::look;
use silhouette_testing::{Random, builtin, real_mesh};
use silhouette_visibility::Outline;
use std::collections::BTreeSet;

fn outline(mesh: &TriangleMesh, camera: &Camera) -> Outline {
    finder(mesh.clone()).outline(camera, &NoProgress).unwrap()
}

/// Edges of all polygons.
fn edges(polygons: &[Vec<DVec2>]) -> impl Iterator<Item = [DVec2; 2]> + '_ {
    polygons.iter().flat_map(|polygon| (0..polygon.len()).map(|at| [polygon[at], polygon[(at + 1) % polygon.len()]]))
}

/// Whether a point is inside by the even-odd rule; `None` within 0.01 px of an edge.
fn is_inside(polygons: &[Vec<DVec2>], point: DVec2) -> Option<bool> {
    let mut inside = false;
    for [a, b] in edges(polygons) {
        let along = b - a;
        let share = ((point - a).dot(along) / along.length_squared().max(1e-300)).clamp(0.0, 1.0);
        if a.lerp(b, share).distance(point) < 0.01 {
            return None;
        }
        if (a.y > point.y) != (b.y > point.y) && point.x < a.x + (point.y - a.y) / along.y * along.x {
            inside = !inside;
        }
    }
    Some(inside)
}

fn is_covered(triangles: &[[DVec2; 3]], point: DVec2) -> bool {
    triangles.iter().any(|&[a, b, c]| {
        let sides = [(b - a).perp_dot(point - a), (c - b).perp_dot(point - b), (a - c).perp_dot(point - c)];
        sides.iter().all(|&side| side > 0.0) || sides.iter().all(|&side| side < 0.0)
    })
}

/// Twice the signed area, above 0 for a ring that runs counter-clockwise as seen.
fn twice_area(ring: &[DVec2]) -> f64 {
    // The picture's y points down.
    (0..ring.len()).map(|at| ring[(at + 1) % ring.len()].perp_dot(ring[at])).sum()
}

/// Whether two segments have more in common than an end that both have.
fn cross([a, b]: [DVec2; 2], [p, q]: [DVec2; 2]) -> bool {
    let coord = |point: DVec2| robust::Coord { x: point.x, y: point.y };
    let side = |from, to, point| robust::orient2d(coord(from), coord(to), coord(point));
    if a == p || a == q || b == p || b == q {
        // A common end: no more than that, unless they run back over each other.
        let (end, one) = if a == p || a == q { (a, b) } else { (b, a) };
        let other = if p == end { q } else { p };
        return one == other || side(end, one, other) == 0.0 && (one - end).dot(other - end) > 0.0;
    }
    let (of_p, of_q) = (side(a, b, p), side(a, b, q));
    let (of_a, of_b) = (side(p, q, a), side(p, q, b));
    let apart = a.max(b).cmplt(p.min(q)).any() || p.max(q).cmplt(a.min(b)).any();
    // An end of one on the other is a point that they may have in common.
    !apart
        && (of_p * of_q < 0.0 && of_a * of_b < 0.0
            || [of_p, of_q, of_a, of_b].iter().filter(|&&s| s == 0.0).count() > 1)
}

/// Whether an end of one segment lies on the other, no end of which it is.
fn touch([a, b]: [DVec2; 2], [p, q]: [DVec2; 2]) -> bool {
    let coord = |point: DVec2| robust::Coord { x: point.x, y: point.y };
    let lies_on = |point: DVec2, from: DVec2, to: DVec2| {
        let inside = point.cmpge(from.min(to)).all() && point.cmple(from.max(to)).all();
        inside && point != from && point != to && robust::orient2d(coord(from), coord(to), coord(point)) == 0.0
    };
    lies_on(a, p, q) || lies_on(b, p, q) || lies_on(p, a, b) || lies_on(q, a, b)
}

/// Holds that an outline is a planar map: rings that meet neither each other nor themselves but in single points, outer ones
/// counter-clockwise, each hole clockwise and inside of the outer ring of its region, and no region inside of another.
fn check_map(outline: &Outline) {
    let all: Vec<[DVec2; 2]> = edges(&outline.rings).collect();
    for (index, one) in all.iter().enumerate() {
        assert!(one[0].is_finite() && one[0] != one[1], "{one:?}");
        for other in &all[index + 1..] {
            assert!(!cross(*one, *other), "{one:?} and {other:?} cross");
        }
    }
    for ring in &outline.rings {
        let corners: BTreeSet<[u64; 2]> = ring.iter().map(|corner| corner.to_array().map(f64::to_bits)).collect();
        assert_eq!(corners.len(), ring.len(), "a ring meets itself: {ring:?}");
        let own: Vec<[DVec2; 2]> = edges(std::slice::from_ref(ring)).collect();
        for (index, one) in own.iter().enumerate() {
            assert!(!own[index + 1..].iter().any(|other| touch(*one, *other)), "a ring meets itself at {one:?}");
        }
    }
    assert_eq!(outline.regions().map(<[_]>::len).sum::<usize>(), outline.rings.len());
    for region in outline.regions() {
        let [outer, holes @ ..] = region else { panic!("a region without a ring") };
        assert!(twice_area(outer) > 0.0, "an outer ring runs counter-clockwise");
        let inside = |ring: &[DVec2], of: &[DVec2]| {
            // Rings may meet in a point, so that all of them are asked.
            ring.iter().all(|&corner| is_inside(&[of.to_vec()], corner).unwrap_or(true))
        };
        for (index, hole) in holes.iter().enumerate() {
            assert!(twice_area(hole) < 0.0, "a hole runs clockwise");
            assert!(inside(hole, outer), "a hole lies in its region");
            // A hole may be a sliver so close to another that none of its corners decides.
            let reaches_into =
                |of: &[DVec2]| hole.iter().any(|&corner| is_inside(&[of.to_vec()], corner) == Some(true));
            let mut others = holes.iter().enumerate().filter(|(other, _)| *other != index);
            assert!(!others.any(|(_, of)| reaches_into(of)), "holes lie apart");
        }
    }
    let twice: f64 = outline.rings.iter().map(|ring| twice_area(ring)).sum();
    assert!((twice * 0.5 - outline.area_px()).abs() <= 1e-9 * twice.abs());
}

/// Compares on a grid of points; yields how many lie inside.
fn check(name: &str, mesh: &TriangleMesh, camera: &Camera) -> usize {
    let outline = outline(mesh, camera);
    check_map(&outline);
    let polygons = &outline.rings;
    let pixel = |vertex: u32| camera.project(mesh.positions()[vertex as usize].as_dvec3()).unwrap().pixel;
    let triangles: Vec<[DVec2; 3]> = mesh.triangles().iter().map(|corners| corners.map(pixel)).collect();
    let (mut compared, mut inside_count) = (0, 0);
    for row in 0..24 {
        for column in 0..24 {
            let point = DVec2::new(f64::from(column) * 42.7 + 13.1, f64::from(row) * 42.7 + 11.7);
            if let Some(inside) = is_inside(polygons, point) {
                assert_eq!(inside, is_covered(&triangles, point), "{name} at {point}");
                compared += 1;
                inside_count += usize::from(inside);
            }
        }
    }
    assert!(compared > 500, "{name}: {compared}");
    inside_count
}

#[test]
fn the_outline_bounds_what_is_covered() {
    for name in ["cube", "icosphere:3", "torus:48,24", "knot", "gear", "blob:3000", "moebius", "grid", "cone"] {
        let mesh = builtin(name);
        for (index, direction) in spread(5).enumerate() {
            let inside = check(name, &mesh, &framing(&mesh, direction, index % 2 == 0));
            assert!(inside > 10, "{name} from {direction}: {inside}");
        }
    }
    for name in ["cow.obj", "spot.obj", "teapot.obj", "stanford-bunny.obj"] {
        if let Some(mesh) = real_mesh("the_outline_bounds_what_is_covered", name) {
            check(name, &mesh, &framing(&mesh, DVec3::new(0.55, 0.35, 1.0), true));
        }
    }
}

#[test]
fn a_torus_seen_along_its_axis_has_a_hole() {
    let mesh = builtin("torus:64,32");
    let [along_axis, across] =
        [DVec3::Y, DVec3::X].map(|direction| outline(&mesh, &framing(&mesh, direction, true)).rings.len());
    let other = outline(&mesh, &framing(&mesh, DVec3::Z, true)).rings.len();
    let mut polygons = [along_axis, across, other];
    polygons.sort_unstable();
    assert_eq!(polygons, [1, 1, 2], "one of three axes looks through the hole");
}

/// The comparison can fail: the outline of another view does not bound what is covered.
#[test]
fn the_outline_of_another_view_is_seen_to_be_wrong() {
    let mesh = builtin("gear");
    let (camera, other) = (framing(&mesh, DVec3::ONE, true), framing(&mesh, DVec3::new(1.0, 0.1, -0.2), true));
    let polygons = outline(&mesh, &other).rings;
    let pixel = |vertex: u32| camera.project(mesh.positions()[vertex as usize].as_dvec3()).unwrap().pixel;
    let triangles: Vec<[DVec2; 3]> = mesh.triangles().iter().map(|corners| corners.map(pixel)).collect();
    let points = (0..400).map(|index| DVec2::new(f64::from(index % 20), f64::from(index / 20)) * 51.2 + 3.3);
    let wrong = points
        .filter(|&point| is_inside(&polygons, point).is_some_and(|inside| inside != is_covered(&triangles, point)));
    assert!(wrong.count() > 20);
}

/// Two faces that share an edge with an end at the eye, one of them without area.
#[test]
fn a_contour_through_the_eye_leaves_the_outline_finite() {
    let eye = Vec3::NEG_Z;
    let corners = vec![Vec3::new(0.0, -2.0, -2.0), Vec3::new(0.0, 2.0, 0.0), eye, Vec3::new(-1.0, -2.0, 0.0)];
    let mesh = TriangleMesh::new(corners, vec![[2, 0, 1], [2, 1, 3]]).unwrap();
    let rings = outline(&mesh, &look(eye, Vec3::ZERO, 60.0, [640, 480])).rings;
    assert!(rings.iter().flatten().all(|corner| corner.is_finite()), "{rings:?}");
}

/// Seen from inside, a solid covers the whole picture, wound either way; one that lacks a side covers all but that side.
#[test]
fn an_eye_inside_of_a_solid_sees_it_everywhere() {
    let cube = builtin("cube");
    let camera = look(Vec3::ZERO, Vec3::new(0.1, 0.05, -1.0), 60.0, [640, 480]);
    for mesh in [&cube, &inside_out(&cube)] {
        let outline = outline(mesh, &camera);
        check_map(&outline);
        assert_eq!((outline.rings.len(), outline.rings[0].len()), (1, 4), "{outline:?}");
        assert!(is_inside(&outline.rings, DVec2::splat(100.0)) == Some(true));
    }
    let is_ahead = |corner: u32| cube.positions()[corner as usize].z < 0.0;
    let rest = keeping(&cube, |face| !cube.triangles()[face].into_iter().all(is_ahead));
    let open = outline(&rest, &camera);
    check_map(&open);
    let hole = camera.project(DVec3::new(0.0, 0.0, -1.0)).unwrap().pixel;
    assert_eq!(open.regions().map(<[_]>::len).collect::<Vec<_>>(), [2], "a hole in what is covered");
    assert_eq!(is_inside(&open.rings, hole), Some(false));
}

/// Random scenes in which edges lie on edges, seen along axes and from eyes in the planes of faces, wholly in front of the eye
/// or not.
#[test]
fn outlines_of_random_scenes_are_planar_maps_around_what_is_covered() {
    let (mut compared, mut covered) = (0, 0);
    for seed in 0..seeds(3000) {
        let mut random = Random::new(seed);
        let mesh = scene(FAMILIES[random.below(FAMILIES.len())], &mut random);
        let Some(camera) = camera(&mesh, &mut random) else { continue };
        let outline = outline(&mesh, &camera);
        let points: usize = outline.rings.iter().map(Vec::len).sum();
        assert!(points < 500, "seed {seed}: {points} points of {} faces", mesh.face_count());
        check_map(&outline);
        let view = camera.view_matrix();
        let corners = |triangle: &[u32; 3]| {
            triangle.map(|vertex| view.transform_point3(mesh.positions()[vertex as usize].as_dvec3()))
        };
        let triangles: Vec<[DVec3; 3]> = mesh.triangles().iter().map(corners).collect();
        for _ in 0..60 {
            let pixel = DVec2::new(random.below(2560) as f64, random.below(2560) as f64) * 0.1 + 128.037;
            let Some(inside) = is_inside(&outline.rings, pixel) else { continue };
            let Some(expected) = is_seen(&triangles, &camera, pixel) else { continue };
            assert_eq!(inside, expected, "seed {seed}, {pixel}");
            compared += 1;
            covered += usize::from(inside);
        }
    }
    eprintln!("{compared} places, {covered} of them covered");
    assert!(compared > 40_000 && covered > 5000, "{covered} of {compared}");
}

/// Whether a ray through a pixel meets a triangle in front of the eye; `None` where it passes close to an edge, or the eye is
/// in a triangle.
fn is_seen(triangles: &[[DVec3; 3]], camera: &Camera, pixel: DVec2) -> Option<bool> {
    let size = DVec2::from(camera.size().map(f64::from));
    let at = (pixel - size * 0.5) * DVec2::new(1.0, -1.0) / camera.pixels_per_unit(1.0);
    let (origin, direction) = match camera.projection() {
        Projection::Perspective { .. } => (DVec3::ZERO, at.extend(-1.0)),
        Projection::Orthographic { .. } => (at.extend(1000.0), DVec3::NEG_Z),
    };
    let mut seen = false;
    for corners in triangles {
        let [u, v, w] = corners.map(|corner| corner - origin);
        let sides = [u.cross(v).dot(direction), v.cross(w).dot(direction), w.cross(u).dot(direction)];
        let margin = 1e-7 * (u.length() + v.length() + w.length()).powi(2) * direction.length();
        if sides.iter().all(|&side| side > margin) || sides.iter().all(|&side| side < -margin) {
            // In front where the plane is met at a positive distance.
            let normal = (v - u).cross(w - u);
            if normal.dot(u).abs() <= margin {
                // The eye is in the face: a tie.
                return None;
            }
            seen |= normal.dot(u) / normal.dot(direction) > 0.0;
        } else if !(sides.iter().any(|&side| side > margin) && sides.iter().any(|&side| side < -margin)) {
            return None;
        }
    }
    Some(seen)
}

/// Cubes in line, one of which hides the other exactly; a mesh that reaches far beyond the picture.
#[test]
fn what_coincides_in_the_picture_is_one_ring() {
    let cube = builtin("cube");
    let line = joined(&[&cube, &moved(&cube, Vec3::Z * -3.0)]);
    let [torus, gear] = ["torus", "gear"].map(builtin);
    // Of three axes, one looks through the hole.
    for (mesh, expected) in [(&cube, [1, 1, 1]), (&line, [1, 2, 2]), (&torus, [1, 1, 2]), (&gear, [1, 1, 2])] {
        for sign in [1.0, -1.0] {
            let mut rings = [DVec3::X, DVec3::Y, DVec3::Z].map(|axis| {
                let outline = outline(mesh, &framing(mesh, axis * sign, false));
                check_map(&outline);
                outline.rings.len()
            });
            rings.sort_unstable();
            assert_eq!(rings, expected);
        }
    }
    let square = outline(&line, &framing(&line, DVec3::Z, false));
    assert_eq!((square.rings.len(), square.rings[0].len()), (1, 4), "{square:?}");
}

#[test]
fn what_lies_beyond_the_picture_changes_nothing_in_it() {
    let mesh = builtin("knot");
    for direction in spread(6) {
        let camera = framing(&mesh, direction, true).with_size([1000, 1000]).unwrap();
        let [width, height] = camera.size();
        let whole = outline(&mesh, &camera);
        // The same picture through a window of a fifth: the field of view shrinks with it.
        let Projection::Perspective { fov_y_rad } = camera.projection() else { panic!() };
        let fov_y_rad = 2.0 * ((fov_y_rad * 0.5).tan() * 0.2).atan();
        let projection = Projection::Perspective { fov_y_rad };
        let small = [width / 5, height / 5];
        let window = Camera::new(camera.eye(), camera.target(), camera.up(), projection, small).unwrap();
        let cut = outline(&mesh, &window);
        check_map(&cut);
        let offset = (DVec2::from([width, height].map(f64::from)) - DVec2::from(small.map(f64::from))) * 0.5;
        for row in 0..20 {
            for column in 0..20 {
                let pixel = DVec2::new(f64::from(column), f64::from(row)) * 10.2 + 0.3;
                let pair = (is_inside(&cut.rings, pixel), is_inside(&whole.rings, pixel + offset));
                if let (Some(inside), Some(expected)) = pair {
                    assert_eq!(inside, expected, "{pixel} from {direction}");
                }
            }
        }
    }
}
