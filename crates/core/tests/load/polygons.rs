//! Polygons of four and more corners, in every format that has them: their triangles cover them once.

use crate::expectations::{accepted, feature_edges, labelled};
use proptest::prelude::*;
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::inspect::inspect;
use silhouette_core::load::{Format, Note};
use silhouette_core::{Topology, TriangleMesh};
use std::collections::HashMap;

/// A point of an integer grid, on which areas are exact.
type Point = [i64; 2];

/// Where the plane of a polygon lies in space. All are exact for grid points.
#[derive(Debug, Clone, Copy)]
enum Plane {
    Above,
    Below,
    Side,
    Tilted,
}

const PLANES: [Plane; 4] = [Plane::Above, Plane::Below, Plane::Side, Plane::Tilted];

impl Plane {
    fn place(self, [x, y]: Point) -> Vec3 {
        let [x, y] = [x as f32, y as f32];
        match self {
            Self::Above => Vec3::new(x, y, 7.0),
            Self::Below => Vec3::new(x, -y, -7.0),
            Self::Side => Vec3::new(-3.0, x, y),
            Self::Tilted => Vec3::new(x, y, 2.0 * x - 3.0 * y),
        }
    }
}

/// An OBJ file of one face over these positions, in which each corner is a vertex of its own.
fn obj(positions: &[Vec3]) -> String {
    let corners: Vec<usize> = (0..positions.len()).collect();
    obj_with(positions, &corners)
}

/// An OBJ file of one face with these corners.
fn obj_with(positions: &[Vec3], corners: &[usize]) -> String {
    let vertices: String = positions.iter().map(|p| format!("v {} {} {}\n", p.x, p.y, p.z)).collect();
    let corners: String = corners.iter().map(|corner| format!(" {}", corner + 1)).collect();
    format!("{vertices}f{corners}\n")
}

/// Twice the signed area.
fn double_area(polygon: &[Point]) -> i64 {
    polygon.iter().zip(polygon.iter().cycle().skip(1)).map(|(a, b)| a[0] * b[1] - a[1] * b[0]).sum()
}

/// Twice the signed area of the triangle of three points.
fn turn(a: Point, b: Point, c: Point) -> i64 {
    double_area(&[a, b, c])
}

/// Asserts that triangles cover a simple polygon of these corners once: each triangle is turned as the polygon is, their
/// areas add up, and their sides are those of the polygon, once and in its direction, and others, as often in one
/// direction as in the other. Without crossings, no more is needed: triangles that join without a fold and whose border is
/// a simple polygon cover its inside once.
fn check_covers(corners: &[u32], points: &[Point], triangles: &[[u32; 3]]) -> Result<(), TestCaseError> {
    let at = |vertex: u32| points[vertex as usize];
    let polygon: Vec<Point> = corners.iter().map(|&corner| at(corner)).collect();
    let direction = double_area(&polygon).signum();
    let areas: Vec<i64> = triangles.iter().map(|t| turn(at(t[0]), at(t[1]), at(t[2])) * direction).collect();
    prop_assert!(areas.iter().all(|&area| area >= 0), "turned over: {areas:?} {triangles:?}");
    prop_assert_eq!(areas.iter().sum::<i64>(), double_area(&polygon) * direction);
    prop_assert_eq!(triangles.len(), corners.len() - 2);
    let mut balance: HashMap<[u32; 2], i64> = HashMap::new();
    let mut count = |a: u32, b: u32, by: i64| {
        // A side from a corner to itself has no direction.
        let by = if a == b { 0 } else { by };
        *balance.entry([a.min(b), a.max(b)]).or_default() += if a < b { by } else { -by };
    };
    for &[a, b, c] in triangles {
        [[a, b], [b, c], [c, a]].into_iter().for_each(|[from, to]| count(from, to, 1));
    }
    for (&from, &to) in corners.iter().zip(corners.iter().cycle().skip(1)) {
        count(from, to, -1);
    }
    prop_assert!(balance.values().all(|&sum| sum == 0), "sides differ: {balance:?}");
    Ok(())
}

/// Loads a simple polygon in each plane and checks its triangles.
fn check_polygon(points: &[Point], corners: &[usize]) -> Result<(), TestCaseError> {
    let ids: Vec<u32> = corners.iter().map(|&corner| corner as u32).collect();
    for plane in PLANES {
        let positions: Vec<Vec3> = points.iter().map(|&point| plane.place(point)).collect();
        let loaded = labelled(Format::Obj, obj_with(&positions, corners));
        prop_assert!(loaded.notes.is_empty(), "{plane:?}: {:?}", loaded.notes);
        check_covers(&ids, points, loaded.mesh.triangles())?;
    }
    Ok(())
}

fn segments_meet(a: Point, b: Point, c: Point, d: Point) -> bool {
    let within = |p: Point| (0..2).all(|i| p[i] >= a[i].min(b[i]) && p[i] <= a[i].max(b[i]));
    let within_other = |p: Point| (0..2).all(|i| p[i] >= c[i].min(d[i]) && p[i] <= c[i].max(d[i]));
    let [of_c, of_d, of_a, of_b] = [turn(a, b, c), turn(a, b, d), turn(c, d, a), turn(c, d, b)].map(i64::signum);
    (of_c * of_d < 0 && of_a * of_b < 0)
        || (of_c == 0 && within(c))
        || (of_d == 0 && within(d))
        || (of_a == 0 && within_other(a))
        || (of_b == 0 && within_other(b))
}

/// Makes a closed path through distinct points simple by reversing the stretch between two crossing sides, as long as
/// there are any; collinear corners are welcome. `None` where this does not end, or the path runs back on itself.
fn untangled(mut points: Vec<Point>) -> Option<Vec<Point>> {
    let n = points.len();
    let side = |points: &[Point], i: usize| [points[i], points[(i + 1) % n]];
    for _ in 0..500 {
        let pairs = (0..n).flat_map(|i| (i + 2..n).map(move |j| (i, j))).filter(|&(i, j)| (j + 1) % n != i);
        let mut crossing = pairs.filter(|&(i, j)| {
            let ([a, b], [c, d]) = (side(&points, i), side(&points, j));
            segments_meet(a, b, c, d)
        });
        let Some((i, j)) = crossing.next() else {
            let runs_back = (0..n).any(|i| {
                let [a, b, c] = [0, 1, 2].map(|step| points[(i + step) % n]);
                turn(a, b, c) == 0 && (a[0] - b[0]) * (c[0] - b[0]) + (a[1] - b[1]) * (c[1] - b[1]) > 0
            });
            return (!runs_back).then_some(points);
        };
        points[i + 1..=j].reverse();
    }
    None
}

/// Simple polygons on a grid so small that many corners are collinear, or so large that few are.
fn simple_polygon() -> impl Strategy<Value = Vec<Point>> {
    let points = prop::sample::select(vec![4_i64, 9, 60, 4000]).prop_flat_map(|size| {
        let most = if size == 4 { 9 } else { 16 };
        prop::collection::hash_set([0..size, 0..size], 4..most)
    });
    points.prop_map(|points| points.into_iter().collect()).prop_filter_map("tangled", untangled)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, max_global_rejects: 200_000, ..ProptestConfig::default() })]

    #[test]
    fn simple_polygons_are_covered_once(points in simple_polygon()) {
        let corners: Vec<usize> = (0..points.len()).collect();
        check_polygon(&points, &corners)?;
    }

    #[test]
    fn corners_may_be_named_twice_in_a_row(points in simple_polygon(), repeated in prop::collection::vec(0..16_usize, 1..5)) {
        let mut corners: Vec<usize> = (0..points.len()).chain(repeated.iter().map(|r| r % points.len())).collect();
        corners.sort_unstable();
        check_polygon(&points, &corners)?;
    }

    /// A square with the polygon as a hole, which a bridge between the left side of the square and the leftmost corner of the
    /// hole reaches. The ends of the bridge are named twice, or are different vertices in the same places.
    #[test]
    fn bridges_to_holes_are_followed(polygon in simple_polygon(), by_id in any::<bool>()) {
        let mut hole = polygon;
        if double_area(&hole) > 0 {
            hole.reverse();
        }
        let leftmost = (0..hole.len()).min_by_key(|&i| hole[i]).unwrap();
        hole.rotate_left(leftmost);
        let [left, y] = [hole[0][0] - 1, hole[0][1]];
        let mut points = vec![[left, y], [left, -5000], [5000, -5000], [5000, 5000], [left, 5000]];
        let bridge = [0, points.len()];
        points.extend(&hole);
        let back = if by_id {
            bridge
        } else {
            points.extend(bridge.map(|end| points[end]));
            [points.len() - 2, points.len() - 1]
        };
        // Around the square, across the bridge, around the hole and back across the bridge.
        let square = 1..bridge[1];
        let hole = bridge[1]..bridge[1] + hole.len();
        let corners: Vec<usize> = square.chain([0]).chain(hole).chain([back[1], back[0]]).collect();
        check_polygon(&points, &corners)?;
    }

    /// Corners that have been lifted off the plane: no triangle is turned over, seen along the polygon's normal.
    #[test]
    fn polygons_need_not_be_flat(points in simple_polygon(), lift in prop::collection::vec(-1.0..1.0_f32, 16)) {
        let size = points.iter().flatten().max().copied().unwrap() as f32;
        let lifted = |(&point, lift): (&Point, &f32)| Plane::Tilted.place(point) + Vec3::Z * lift * size * 0.02;
        let positions: Vec<Vec3> = points.iter().zip(&lift).map(lifted).collect();
        let loaded = labelled(Format::Obj, obj(&positions));
        let area = |[a, b, c]: [u32; 3]| {
            let [a, b, c] = [a, b, c].map(|vertex| positions[vertex as usize].as_dvec3());
            (b - a).cross(c - a)
        };
        let normal: DVec3 = (1..points.len() as u32 - 1).map(|corner| area([0, corner, corner + 1])).sum();
        let least = loaded.mesh.triangles().iter().map(|&t| area(t).dot(normal)).fold(f64::INFINITY, f64::min);
        // The lift may make a narrow polygon cross itself.
        if loaded.notes.is_empty() {
            prop_assert!(least >= -1e-12 * normal.length_squared(), "{least}");
        }
    }
}

/// The triangles of a polygon in each format; all must agree.
fn in_all_formats(positions: &[Vec3]) -> TriangleMesh {
    let rows: String = positions.iter().map(|p| format!("{} {} {}\n", p.x, p.y, p.z)).collect();
    let n = positions.len();
    let corners: String = (0..n).map(|corner| format!(" {corner}")).collect();
    let off = format!("OFF\n{n} 1 0\n{rows}{n}{corners}\n");
    let ply = |faces_first: bool| {
        let vertices = format!("element vertex {n}\nproperty float x\nproperty float y\nproperty float z\n");
        let faces = "element face 1\nproperty list int int vertex_indices\n";
        let (header, body) = if faces_first {
            (faces.to_owned() + &vertices, format!("{n}{corners}\n{rows}"))
        } else {
            (vertices + faces, format!("{rows}{n}{corners}\n"))
        };
        format!("ply\nformat ascii 1.0\n{header}end_header\n{body}")
    };
    let mesh = accepted(Format::Obj, obj(positions));
    for (format, text) in [(Format::Off, off), (Format::Ply, ply(false)), (Format::Ply, ply(true))] {
        assert_eq!(accepted(format, text), mesh, "{format}");
    }
    mesh
}

/// An L of seven squares, from whichever corner it begins.
#[test]
fn an_l_is_covered_in_every_format() {
    let l: [Point; 6] = [[0, 0], [4, 0], [4, 1], [1, 1], [1, 4], [0, 4]];
    for plane in PLANES {
        for first in 0..6 {
            let mut corners = l;
            corners.rotate_left(first);
            let mesh = in_all_formats(&corners.map(|corner| plane.place(corner)));
            let ids: Vec<u32> = (0..6).collect();
            check_covers(&ids, &corners, mesh.triangles()).unwrap();
        }
    }
}

/// The negative control: a fan that folds over, a missing triangle and one that is there twice do not pass.
#[test]
fn wrong_triangles_are_seen() {
    let arrow: [Point; 4] = [[4, 4], [0, 2], [-4, 4], [0, 0]];
    let check = |triangles: &[[u32; 3]]| check_covers(&[0, 1, 2, 3], &arrow, triangles);
    assert!(check(&[[0, 1, 3], [1, 2, 3]]).is_ok());
    assert!(check(&[[0, 1, 2], [0, 2, 3]]).is_err());
    assert!(check(&[[0, 1, 3]]).is_err());
    assert!(check(&[[0, 1, 3], [0, 1, 3]]).is_err());
    assert!(check(&[[0, 1, 3], [1, 2, 2]]).is_err());
}

/// A concave quadrilateral is cut along the diagonal that lies inside, whatever its first corner.
#[test]
fn concave_quadrilaterals_are_cut_inside() {
    let arrow: [Point; 4] = [[0, 0], [4, 4], [0, 2], [-4, 4]];
    for first in 0..4 {
        let mut corners = arrow;
        corners.rotate_left(first);
        let mesh = in_all_formats(&corners.map(|corner| Plane::Tilted.place(corner)));
        check_covers(&[0, 1, 2, 3], &corners, mesh.triangles()).unwrap();
    }
}

/// Convex polygons keep their fan, also where corners are collinear or repeated, in planes that are not exact.
#[test]
fn convex_polygons_are_fanned_from_their_first_corner() {
    for corners in 4..40_usize {
        for turns in 0..7 {
            let angle = |i: usize| (i as f64 + 0.1 * f64::from(turns)) * std::f64::consts::TAU / corners as f64;
            let [right, up] = [DVec3::new(0.6, 0.3, -0.2), DVec3::new(-0.1, 0.7, 0.9)];
            let corner = |i: usize| (DVec3::splat(2.0) + right * angle(i).cos() + up * angle(i).sin()).as_vec3();
            let positions: Vec<Vec3> = (0..corners).map(corner).collect();
            let fan: Vec<[u32; 3]> = (1..corners as u32 - 1).map(|i| [0, i, i + 1]).collect();
            assert_eq!(accepted(Format::Obj, obj(&positions)).triangles(), fan);
        }
    }
    let square: [Point; 9] = [[0, 0], [1, 0], [2, 0], [2, 0], [2, 1], [2, 2], [1, 2], [0, 2], [0, 1]];
    for plane in PLANES {
        for first in 0..9 {
            let mut corners = square;
            corners.rotate_left(first);
            let mesh = accepted(Format::Obj, obj(&corners.map(|corner| plane.place(corner))));
            assert_eq!(mesh.triangles(), [1, 2, 3, 4, 5, 6, 7].map(|i| [0, i, i + 1]), "{plane:?} from {first}");
        }
    }
}

/// What crosses itself has no triangles; it stays a fan and is counted, by the first triangle of the first one.
#[test]
fn polygons_that_cross_themselves_stay_fans_and_are_counted() {
    let star: [Point; 5] = [[0, 10], [6, -8], [-10, 3], [10, 3], [-6, -8]];
    let bow_tie: [Point; 4] = [[0, 0], [2, 2], [2, 0], [0, 2]];
    for plane in PLANES {
        for polygon in [star.as_slice(), &bow_tie] {
            let positions: Vec<Vec3> = polygon.iter().map(|&corner| plane.place(corner)).collect();
            let loaded = labelled(Format::Obj, format!("{}f 1 2 3\nf 1 2 3 4 1 2 3 4\nf 1 2 3", obj(&positions)));
            let fan: Vec<[u32; 3]> = (1..polygon.len() as u32 - 1).map(|i| [0, i, i + 1]).collect();
            assert_eq!(&loaded.mesh.triangles()[..fan.len()], fan);
            let [Note::CrossingPolygons { count: 1 | 2, first }] = loaded.notes[..] else {
                panic!("{:?}", loaded.notes)
            };
            assert_eq!(first.index(), 0);
        }
    }
}

/// Polygons without an area are fanned, and no note complains of them.
#[test]
fn polygons_without_area_are_fanned() {
    for polygon in [[[0, 0], [1, 1], [3, 3], [2, 2]], [[5, 5]; 4]] {
        for plane in PLANES {
            let loaded = labelled(Format::Obj, obj(&polygon.map(|corner| plane.place(corner))));
            assert_eq!((loaded.mesh.triangles(), loaded.notes), ([[0, 1, 2], [0, 2, 3]].as_slice(), vec![]));
        }
    }
}

/// A corridor that winds many times about a point, in steps of the grid.
fn spiral(half: i64) -> Vec<Point> {
    let along = |i: i64, radius: f64| {
        let (angle, radius) = (i as f64 * 0.05, 1000.0 * radius + i as f64 * 20.0);
        [(radius * angle.cos()) as i64, (radius * angle.sin()) as i64]
    };
    (0..half).map(|i| along(i, 1.0)).chain((0..half).rev().map(|i| along(i, 2.0))).collect()
}

#[test]
fn polygons_may_have_many_corners() {
    let spiral = spiral(5000);
    let comb: Vec<Point> =
        (0..1000).flat_map(|i| [[2 * i, 0], [2 * i + 1, 1000]]).chain([[4000, -2], [0, -2]]).collect();
    for polygon in [spiral, comb] {
        let corners: Vec<usize> = (0..polygon.len()).collect();
        check_polygon(&polygon, &corners).unwrap();
    }
}

/// 100,000 corners that zigzag across each other: no corner that is cut off helps the next, and yet this ends.
#[test]
fn hopeless_polygons_are_given_up() {
    let zigzag: Vec<Vec3> = (0..100_000_i64).map(|i| Plane::Above.place([i % 2, i * 7919 % 100_000])).collect();
    let loaded = labelled(Format::Obj, obj(&zigzag));
    assert!(matches!(loaded.notes[..], [Note::CrossingPolygons { count: 1, .. }]), "{:?}", loaded.notes);
}

/// The sides of a concave polygon that is shaded flat are sharp, the diagonals that cut it into triangles are not.
#[test]
fn diagonals_of_concave_polygons_are_no_feature_edges() {
    let l: [Point; 6] = [[0, 0], [4, 0], [4, 1], [1, 1], [1, 4], [0, 4]];
    let positions = l.map(|corner| Plane::Above.place(corner));
    let text = obj(&positions).replace("f ", "v 9 9 9\ns 1\nf 1 2 7\ns off\nf ");
    for first in 0..6 {
        let mut corners = [1, 2, 3, 4, 5, 6];
        corners.rotate_left(first);
        let text = text.replace("f 1 2 3 4 5 6", &format!("f {}", corners.map(|c: i32| c.to_string()).join(" ")));
        assert_eq!(feature_edges(Format::Obj, text), [[0, 1], [0, 5], [1, 2], [2, 3], [3, 4], [4, 5]]);
    }
}

/// The prism over a polygon, its two ends as polygons of the file.
fn prism(polygon: &[Point]) -> String {
    let n = polygon.len();
    let level = |z: i32| polygon.iter().map(move |[x, y]| format!("v {x} {y} {z}\n")).collect::<String>();
    let corners = |ranks: &mut dyn Iterator<Item = usize>| ranks.map(|rank| format!(" {rank}")).collect::<String>();
    let sides: String = (0..n)
        .map(|i| {
            let [a, b] = [i + 1, (i + 1) % n + 1];
            format!("f {a} {b} {} {}\n", b + n, a + n)
        })
        .collect();
    let (bottom, top) = (corners(&mut (1..=n).rev()), corners(&mut (n + 1..=2 * n)));
    format!("{}{}f{bottom}\nf{top}\n{sides}", level(0), level(1))
}

/// The ends of an L-shaped prism and of a comb cover what their polygons enclose, and no more.
#[test]
fn prisms_of_concave_polygons_are_whole() {
    let l: &[Point] = &[[0, 0], [4, 0], [4, 1], [1, 1], [1, 4], [0, 4]];
    let comb: Vec<Point> = [[0, 0], [9, 0], [9, 4], [8, 4], [8, 1], [6, 1], [6, 4], [5, 4], [5, 1]]
        .into_iter()
        .chain([[3, 1], [3, 4], [2, 4], [2, 1], [1, 1], [1, 4], [0, 4]])
        .collect();
    for (polygon, area, volume) in [(l, 30.0, 7.0), (&comb, 86.0, 21.0)] {
        let mesh = accepted(Format::Obj, prism(polygon));
        let found = inspect(&mesh, &Topology::new(&mesh));
        assert!(found.is_closed && found.defects.is_empty(), "{:?}", found.defects);
        assert_eq!((found.components[0].area, found.components[0].volume), (area, Some(volume)));
    }
}
