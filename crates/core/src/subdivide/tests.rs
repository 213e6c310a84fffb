use super::*;
use crate::id::{EdgeId, VertexId};
use crate::shapes::{Sphere, by_name};
use glam::{DAffine3, DQuat};
use proptest::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

fn subdivided(mesh: &TriangleMesh, levels: u32) -> TriangleMesh {
    loop_subdivision(mesh, &Topology::new(mesh), levels).unwrap()
}

fn octahedron() -> TriangleMesh {
    let positions = [Vec3::X, Vec3::Y, Vec3::Z, Vec3::NEG_X, Vec3::NEG_Y, Vec3::NEG_Z].to_vec();
    let (top, bottom) = ([[0, 1, 2], [1, 3, 2], [3, 4, 2], [4, 0, 2]], [[1, 0, 5], [3, 1, 5], [4, 3, 5], [0, 4, 5]]);
    TriangleMesh::new(positions, [top, bottom].concat()).unwrap()
}

fn euler_characteristic(mesh: &TriangleMesh) -> i64 {
    mesh.vertex_count() as i64 - Topology::new(mesh).edge_count() as i64 + mesh.face_count() as i64
}

fn soup(points: &[[f32; 3]], triangles: Vec<[u32; 3]>) -> TriangleMesh {
    TriangleMesh::new(points.iter().copied().map(Vec3::from).collect(), triangles).unwrap()
}

/// Neighbours of every vertex.
fn neighbours(mesh: &TriangleMesh) -> BTreeMap<u32, BTreeSet<u32>> {
    let mut all = BTreeMap::<u32, BTreeSet<u32>>::new();
    for &[a, b] in Topology::new(mesh).edges().as_slice() {
        all.entry(a).or_default().insert(b);
        all.entry(b).or_default().insert(a);
    }
    all
}

fn mean(points: impl Iterator<Item = DVec3>) -> DVec3 {
    let (sum, count) = points.fold((DVec3::ZERO, 0.0), |(sum, count), point| (sum + point, count + 1.0));
    sum / count
}

/// One level by the table of the module, each vertex and edge looked up in sets: the oracle. Faces name no vertex twice.
fn naive(mesh: &TriangleMesh) -> Vec<Vec3> {
    let position = |v: u32| mesh.positions()[v as usize].as_dvec3();
    let mut across = BTreeMap::<[u32; 2], Vec<u32>>::new();
    for &[a, b, c] in mesh.triangles() {
        for (a, b, c) in [(a, b, c), (b, c, a), (c, a, b)] {
            across.entry([a.min(b), a.max(b)]).or_default().push(c);
        }
    }
    let neighbours = neighbours(mesh);
    let mut points = Vec::new();
    for v in 0..mesh.vertex_count() as u32 {
        let around: Vec<u32> = neighbours.get(&v).into_iter().flatten().copied().collect();
        let wings = |other: u32| &across[&[v.min(other), v.max(other)]];
        let sharp: Vec<u32> = around.iter().copied().filter(|&other| wings(other).len() != 2).collect();
        let sum = |of: &[u32]| of.iter().map(|&other| position(other)).sum::<DVec3>();
        points.push(match sharp[..] {
            [] if !around.is_empty() => {
                // Neighbours that a face at v joins are connected; one fan connects them all.
                let mut reached = BTreeSet::from([around[0]]);
                let mut front = vec![around[0]];
                while let Some(other) = front.pop() {
                    front.extend(wings(other).iter().copied().filter(|&next| reached.insert(next)));
                }
                let n = around.len() as f64;
                let weight = if n > 3.0 { 3.0 / (8.0 * n) } else { 3.0 / 16.0 };
                let smooth = position(v) * (1.0 - n * weight) + sum(&around) * weight;
                if reached.len() == around.len() { smooth } else { position(v) }
            }
            [_, _] => position(v) * 0.75 + sum(&sharp) * 0.125,
            _ => position(v),
        });
    }
    points.extend(across.iter().map(|(&[a, b], wings)| match wings[..] {
        [c, d] => (position(a) + position(b)) * 0.375 + (position(c) + position(d)) * 0.125,
        _ => (position(a) + position(b)) * 0.5,
    }));
    points.iter().map(|point| point.as_vec3()).collect()
}

fn assert_close(a: &[Vec3], b: &[Vec3], tolerance: f32) {
    assert_eq!(a.len(), b.len());
    for (index, (a, b)) in a.iter().zip(b).enumerate() {
        assert!(a.distance(*b) <= tolerance, "vertex {index}: {a} and {b}");
    }
}

/// A vertex of n > 3 neighbours goes to the middle between itself and their mean; of the distance a quarter is left after
/// each level.
#[test]
fn vertices_converge_to_the_limit() {
    for mesh in [octahedron(), Sphere::default().icosphere(2).unwrap(), by_name("knot:2,3,40,5").unwrap()] {
        let fine = [1, 2, 3].map(|levels| subdivided(&mesh, levels));
        let position = |v: u32| mesh.positions()[v as usize].as_dvec3();
        let mut moved: f64 = 0.0;
        for (v, around) in neighbours(&mesh) {
            let limit = (position(v) + mean(around.iter().map(|&other| position(other)))) * 0.5;
            let begin = position(v).distance(limit);
            moved = moved.max(begin);
            for (fine, expected) in fine.iter().zip([begin / 4.0, begin / 16.0, begin / 64.0]) {
                let left = fine.positions()[v as usize].as_dvec3().distance(limit);
                assert!((left - expected).abs() < 3e-7, "vertex {v}: {left}, not {expected}");
            }
        }
        assert!(moved > 0.01, "at {moved} the limit of this mesh is hardly another surface than the mesh");
    }
}

#[test]
fn counts_ids_and_euler_characteristic() {
    for name in ["icosphere:1", "torus:9,7", "gear:5", "grid:3,2", "moebius:12,2", "cylinder:8"] {
        let mesh = by_name(name).unwrap();
        let topology = Topology::new(&mesh);
        let once = subdivided(&mesh, 1);
        assert_eq!(once.vertex_count(), mesh.vertex_count() + topology.edge_count(), "{name}");
        for (edge, &[a, b]) in topology.edges().iter() {
            let point = VertexId::from_usize(mesh.vertex_count() + edge.index());
            let halves = [a, b].map(|end| Topology::new(&once).find_edge(VertexId::new(end), point));
            assert!(halves.iter().all(Option::is_some), "{name}: edge {edge} has no halves");
        }
        for (face, triangle) in mesh.triangles().iter().enumerate() {
            let children = &once.triangles()[4 * face..][..4];
            assert_eq!([children[0][0], children[1][1], children[2][2]], *triangle, "{name}");
        }
        for levels in 1..4 {
            let fine = subdivided(&mesh, levels);
            assert_eq!(fine.face_count(), mesh.face_count() << (2 * levels), "{name}");
            assert_eq!(euler_characteristic(&fine), euler_characteristic(&mesh), "{name}");
        }
    }
}

#[test]
fn without_levels_or_faces_nothing_changes() {
    let points = soup(&[[1.0, 2.0, 3.0]], vec![]);
    assert_eq!(subdivided(&points, u32::MAX), points);
    assert_eq!(subdivided(&octahedron(), 0), octahedron());
}

#[test]
fn affine_maps_go_before_or_after() {
    let map = DAffine3::from_scale_rotation_translation(
        DVec3::new(2.0, 0.5, 1.5),
        DQuat::from_rotation_z(0.7) * DQuat::from_rotation_x(0.4),
        DVec3::new(3.0, -1.0, 2.0),
    );
    for name in ["knot:2,3,40,5", "moebius:12,2"] {
        let mesh = by_name(name).unwrap();
        let mapped = |mesh: &TriangleMesh| {
            let positions = mesh.positions().iter().map(|p| map.transform_point3(p.as_dvec3()).as_vec3()).collect();
            TriangleMesh::new(positions, mesh.triangles().to_vec()).unwrap()
        };
        assert_close(subdivided(&mapped(&mesh), 2).positions(), mapped(&subdivided(&mesh, 2)).positions(), 2e-6);
    }
}

#[test]
fn flat_stays_flat_and_waves_do_not() {
    let height =
        |name| subdivided(&by_name(name).unwrap(), 3).positions().iter().fold(0.0, |top: f32, p| top.max(p.y.abs()));
    assert!(height("grid:6,5").to_bits() == 0);
    assert!(height("grid:6,5,0.5") > 0.2);
}

/// Where everything is regular the points of a sheet are spread evenly.
#[test]
fn even_spacing_is_kept_inside() {
    let grid = by_name("grid:8,8").unwrap();
    let fine = subdivided(&grid, 1);
    let inside = |p: &Vec3| p.x.abs() < 0.7 && p.z.abs() < 0.7;
    let offsets = fine.positions().iter().filter(|p| inside(p)).flat_map(|p| [p.x * 8.0, p.z * 8.0]);
    assert!(offsets.clone().count() > 200);
    assert!(offsets.into_iter().all(|steps| (steps - steps.round()).abs() < 1e-5));
}

/// Positions of the vertices of boundary edges.
fn boundary_points(mesh: &TriangleMesh) -> Vec<Vec3> {
    let topology = Topology::new(mesh);
    let ends: BTreeSet<u32> = topology
        .edges()
        .iter()
        .filter(|&(edge, _)| topology.half_edges(edge).len() == 1)
        .flat_map(|(_, &ends)| ends)
        .collect();
    ends.into_iter().map(|v| mesh.positions()[v as usize]).collect()
}

#[test]
fn a_boundary_converges_to_its_own_b_spline() {
    let mesh = by_name("grid:4,3,0.8").unwrap();
    // The loop of the grid's 5 x 4 vertices, once around.
    let ring: Vec<usize> = [0, 1, 2, 3, 4, 9, 14, 19, 18, 17, 16, 15, 10, 5].to_vec();
    let mut curve: Vec<DVec3> = ring.iter().map(|&v| mesh.positions()[v].as_dvec3()).collect();
    for _ in 0..3 {
        let at = |i: usize| curve[i % curve.len()];
        let pairs = (0..curve.len()).flat_map(|i| {
            let last = at(i + curve.len() - 1);
            [at(i) * 0.75 + (last + at(i + 1)) * 0.125, (at(i) + at(i + 1)) * 0.5]
        });
        curve = pairs.collect();
    }
    let boundary = boundary_points(&subdivided(&mesh, 3));
    assert_eq!(boundary.len(), curve.len());
    for point in boundary {
        let nearest = curve.iter().map(|p| p.distance(point.as_dvec3())).fold(f64::INFINITY, f64::min);
        assert!(nearest < 1e-6, "{point} lies {nearest} from the curve");
    }
    let inside = subdivided(&mesh, 3).positions()[6].as_dvec3();
    assert!(curve.iter().all(|p| p.distance(inside) > 0.1), "a point inside is told from one of the boundary");
}

/// Three sheets along a bent spine: vertices 0, 1, 2 the spine, 3 to 5 the wings.
#[test]
fn sheets_keep_meeting_in_a_curve() {
    let spine = [[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [2.0, 0.0, 0.0]];
    let wings = [[1.0, 0.0, 2.0], [1.0, 3.0, -1.0], [1.0, -3.0, -1.0]];
    let faces = (3..6).flat_map(|wing| [[0, 1, wing], [1, 2, wing]]).collect();
    let fine = subdivided(&soup(&[spine, wings].concat(), faces), 1);
    let at = |v: usize| fine.positions()[v];
    assert_eq!([at(0), at(2)], [Vec3::ZERO, Vec3::X * 2.0], "four sharp edges meet at the ends");
    assert_eq!(at(1), Vec3::new(1.0, 0.75, 0.0));
    assert_eq!([at(6), at(6 + 4)], [Vec3::new(0.5, 0.5, 0.0), Vec3::new(1.5, 0.5, 0.0)], "middles of the spine");
    assert_eq!(Topology::new(&fine).non_manifold_edge_count(), 4);
}

#[test]
fn touching_fans_and_degenerate_faces_hold_their_vertex() {
    // Two tetrahedra that share vertex 0.
    let shell = |[a, b, c, d]: [u32; 4]| [[a, b, c], [a, c, d], [a, d, b], [b, d, c]];
    let points = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let opposite = points[1..].iter().map(|p| p.map(|x| -x));
    let points: Vec<[f32; 3]> = points.into_iter().chain(opposite).collect();
    let fine = subdivided(&soup(&points, [shell([0, 1, 2, 3]), shell([0, 4, 5, 6])].concat()), 2);
    assert_eq!(fine.positions()[0], Vec3::ZERO);
    assert_ne!(fine.positions()[1], Vec3::X, "a vertex of one fan moves");

    let degenerate = soup(&points, vec![[1, 1, 2], [1, 3, 2], [2, 3, 3], [4, 4, 4]]);
    let fine = subdivided(&degenerate, 1);
    for v in [1, 3, 4] {
        assert_eq!(fine.positions()[v], degenerate.positions()[v], "vertex {v} is named twice by a face");
    }
}

#[test]
fn faces_over_the_same_vertices_share_their_inner_edges() {
    let mesh = soup(&[[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], vec![[0, 1, 2], [0, 2, 1]]);
    assert_eq!(Topology::new(&mesh).non_manifold_edge_count(), 0);
    let fine = subdivided(&mesh, 1);
    assert_eq!((fine.vertex_count(), Topology::new(&fine).non_manifold_edge_count()), (6, 3));
}

#[test]
fn too_many_elements_are_refused_before_any_work() {
    let refused = loop_subdivision(&octahedron(), &Topology::new(&octahedron()), 14).unwrap_err();
    assert_eq!(refused, SubdivisionError::TooLarge { what: "faces", limit: MAX_FACES, levels: 14, most: 13 });
    assert_eq!(
        refused.to_string(),
        format!("14 levels of subdivision make more than {MAX_FACES} faces; at most 13 are possible")
    );
    assert!(loop_subdivision(&octahedron(), &Topology::new(&octahedron()), u32::MAX).is_err());
    assert_eq!(check_counts([6, 12, 8], 13), Ok(()));
    let unused = check_counts([MAX_VERTICES - 11, 12, 8], 1).unwrap_err();
    assert_eq!(unused, SubdivisionError::TooLarge { what: "vertices", limit: MAX_VERTICES, levels: 1, most: 0 });
    assert_eq!(check_counts([MAX_VERTICES - 12, 12, 8], 1), Ok(()));
}

#[test]
#[should_panic(expected = "the topology belongs to another mesh")]
fn a_foreign_topology_is_noticed() {
    let _ = loop_subdivision(&octahedron(), &Topology::new(&soup(&[], vec![])), 1);
}

/// Any faces but those that name a vertex twice.
fn any_faces() -> impl Strategy<Value = Vec<[u32; 3]>> {
    let distinct = |t: &[u32; 3]| t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
    prop::collection::vec(prop::array::uniform3(0_u32..9).prop_filter("three vertices", distinct), 0..24)
}

fn scattered(triangles: Vec<[u32; 3]>) -> TriangleMesh {
    let points: Vec<[f32; 3]> =
        (0..9_u8).map(f32::from).map(|i| [i, (i * 1.7).sin() * 4.0, (i * 2.3).cos() * 3.0]).collect();
    soup(&points, triangles)
}

proptest! {
    #[test]
    fn any_soup_follows_the_rules(triangles in any_faces()) {
        let mesh = scattered(triangles);
        prop_assume!(mesh.face_count() > 0);
        assert_close(subdivided(&mesh, 1).positions(), &naive(&mesh), 1e-6);
    }

    #[test]
    fn any_soup_stays_in_its_box(triangles in prop::collection::vec(prop::array::uniform3(0_u32..9), 1..24)) {
        let mesh = scattered(triangles);
        let (coarse, fine) = (mesh.bounds().unwrap(), subdivided(&mesh, 3).bounds().unwrap());
        prop_assert!(fine.min.cmpge(coarse.min).all() && fine.max.cmple(coarse.max).all());
    }
}

#[test]
fn the_oracle_tells_a_wrong_weight() {
    let mut wrong = naive(&octahedron());
    assert_close(subdivided(&octahedron(), 1).positions(), &wrong, 1e-6);
    // Half the way from the middle of an edge to its point: 7/16 and 1/16.
    let [a, b] = Topology::new(&octahedron()).end_points(EdgeId::new(0)).map(|v| octahedron().positions()[v.index()]);
    wrong[6] = (wrong[6] + (a + b) * 0.5) * 0.5;
    let same = std::panic::catch_unwind(|| assert_close(subdivided(&octahedron(), 1).positions(), &wrong, 1e-6));
    assert!(same.is_err());
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    let mesh = by_name("knot:2,3,60,7").unwrap();
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| subdivided(&mesh, 3))
    };
    assert_eq!(with(1), with(5));
}
