//! Simplified meshes: small enough, of the same topology, close to the original, wherever it lies and however large it is.

use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::inspect::{Inspection, inspect};
use silhouette_core::shapes::{Sphere, Torus};
use silhouette_core::simplify::{SimplifyError, simplify};
use silhouette_core::weld::weld_exact;
use silhouette_core::{FaceId, Topology, TriangleMesh};
use silhouette_testing::with_threads;
use silhouette_testing::{real_mesh, real_meshes, zoo};

const FACES: usize = 500;

fn inspected(mesh: &TriangleMesh) -> Inspection {
    inspect(mesh, &Topology::new(mesh))
}

/// What simplification keeps.
fn kept(mesh: &TriangleMesh) -> impl PartialEq + std::fmt::Debug {
    let found = inspected(mesh);
    let defects = found.defects;
    let counts = [found.components.len(), found.boundary_loops.len(), defects.non_manifold_edges.len()];
    (found.is_closed, found.is_manifold, found.is_consistently_wound, found.euler_characteristic, found.genus, counts)
}

/// Simplifies, and checks everything that holds of any mesh.
#[track_caller]
fn simplified(name: &str, mesh: &TriangleMesh, faces: usize) -> TriangleMesh {
    let small = simplify(mesh, faces).unwrap_or_else(|error| panic!("{name}: {error}"));
    assert_sound(name, mesh, &small);
    // A collapse takes two faces, sometimes a few more.
    assert!((faces * 9 / 10..=faces).contains(&small.face_count()), "{name}: {} faces", small.face_count());
    small
}

#[track_caller]
fn assert_sound(name: &str, mesh: &TriangleMesh, small: &TriangleMesh) {
    let whole = without_repeated_vertices(&weld_exact(mesh).mesh);
    assert_eq!(kept(small), kept(&whole), "{name}");
    let found = inspected(small).defects;
    assert!(found.unreferenced_vertices.is_empty() && found.duplicate_vertices.is_empty(), "{name}");
    let mut originals = whole.positions().iter();
    assert!(
        small.positions().iter().all(|p| originals.any(|q| p == q)),
        "{name}: not vertices of the mesh in its order"
    );
}

fn without_repeated_vertices(mesh: &TriangleMesh) -> TriangleMesh {
    let whole = mesh.triangles().iter().copied().filter(|[a, b, c]| a != b && b != c && c != a);
    let mut positions = mesh.positions().to_vec();
    let triangles: Vec<[u32; 3]> = whole.collect();
    positions.truncate(triangles.iter().flatten().max().map_or(0, |&last| last as usize + 1));
    TriangleMesh::new(positions, triangles).unwrap()
}

fn corners(mesh: &TriangleMesh, face: usize) -> [DVec3; 3] {
    mesh.corners(FaceId::from_usize(face)).map(Vec3::as_dvec3)
}

/// Corners, middles of sides and centre of every face.
fn samples(mesh: &TriangleMesh) -> impl Iterator<Item = DVec3> + '_ {
    (0..mesh.face_count()).flat_map(|face| {
        let [a, b, c] = corners(mesh, face);
        [a, b, c, (a + b) / 2.0, (b + c) / 2.0, (c + a) / 2.0, (a + b + c) / 3.0]
    })
}

fn distance_to_triangle(p: DVec3, [a, b, c]: [DVec3; 3]) -> f64 {
    let normal = (b - a).cross(c - a);
    let sides = [(a, b), (b, c), (c, a)];
    if sides.iter().all(|&(from, to)| (to - from).cross(p - from).dot(normal) >= 0.0) {
        return (p - a).dot(normal).abs() / normal.length();
    }
    let to_side = |&(from, to): &(DVec3, DVec3)| {
        let along = ((p - from).dot(to - from) / from.distance_squared(to)).clamp(0.0, 1.0);
        p.distance(from.lerp(to, along))
    };
    sides.iter().map(to_side).fold(f64::INFINITY, f64::min)
}

/// Largest distance of some two thousand vertices of a mesh from another mesh.
fn distance(from: &TriangleMesh, to: &TriangleMesh) -> f64 {
    let step = from.vertex_count().div_ceil(2000);
    let to_mesh = |p: &Vec3| {
        let faces = 0..to.face_count();
        faces.map(|face| distance_to_triangle(p.as_dvec3(), corners(to, face))).fold(f64::INFINITY, f64::min)
    };
    from.positions().iter().step_by(step).map(to_mesh).fold(0.0, f64::max)
}

/// With 500 faces of equal size, the middle of a face lies 0.01 radii below the sphere.
#[test]
fn a_sphere_stays_within_three_percent_of_its_radius() {
    let sphere = Sphere { radius: 2.0 };
    let mesh = sphere.icosphere(5).unwrap();
    let small = simplified("sphere", &mesh, FACES);
    let lowest = samples(&small).map(DVec3::length).fold(f64::INFINITY, f64::min);
    assert!(lowest > 0.97 * sphere.radius, "{lowest}");
    assert!(distance(&mesh, &small) < 0.03 * sphere.radius);
}

#[test]
fn a_torus_stays_within_a_tenth_of_its_tube() {
    let torus = Torus::default();
    let mesh = torus.mesh(200, 100).unwrap();
    let small = simplified("torus", &mesh, FACES);
    assert_eq!(inspected(&small).genus, Some(1));
    assert!(distance(&mesh, &small) < 0.1 * torus.minor_radius, "{}", distance(&mesh, &small));
    let coarser = simplified("torus", &mesh, 100);
    assert!(distance(&mesh, &coarser) > distance(&mesh, &small));
}

#[test]
fn every_kind_of_mesh_keeps_its_topology() {
    for (name, mesh) in zoo::all() {
        let faces = mesh.face_count() / 3;
        match simplify(&mesh, faces) {
            Ok(small) => assert_sound(name, &mesh, &small),
            Err(SimplifyError::OutOfReach { wanted, reached }) => {
                assert!(wanted == faces && reached > faces && reached <= mesh.face_count(), "{name}: {reached}");
            }
            Err(error) => panic!("{name}: {error}"),
        }
    }
}

#[test]
fn a_hole_of_three_edges_stays_open() {
    let mesh = zoo::builtin("blob:2000");
    let open = TriangleMesh::new(mesh.positions().to_vec(), mesh.triangles()[1..].to_vec()).unwrap();
    for faces in [500, 50, 20] {
        assert_eq!(inspected(&simplified("blob", &open, faces)).boundary_edges, 3);
    }
}

#[test]
fn real_meshes_keep_their_topology() {
    for (name, mesh) in real_meshes("real_meshes_keep_their_topology") {
        match simplify(&mesh, FACES) {
            Ok(small) => assert_sound(&name, &mesh, &small),
            // A mesh of many parts, or one that turns back on itself nearly everywhere.
            Err(SimplifyError::OutOfReach { reached, .. }) => {
                assert!((FACES + 1..=mesh.face_count()).contains(&reached), "{name}: {reached}");
            }
            Err(error) => panic!("{name}: {error}"),
        }
    }
}

#[test]
fn the_bunny_stays_within_a_twentieth_of_its_radius() {
    let Some(mesh) = real_mesh("the_bunny_stays_within_a_twentieth_of_its_radius", "stanford-bunny.obj") else {
        return;
    };
    let small = simplified("bunny", &mesh, FACES);
    let distance = distance(&mesh, &small) / mesh.bounds().unwrap().radius;
    assert!(distance < 0.05, "{distance}");
}

fn moved(mesh: &TriangleMesh, place: impl Fn(Vec3) -> Vec3) -> TriangleMesh {
    TriangleMesh::new(mesh.positions().iter().map(|&p| place(p)).collect(), mesh.triangles().to_vec()).unwrap()
}

#[test]
fn neither_place_nor_unit_matters() {
    // On a grid on which the moves below are exact.
    let knot = moved(&zoo::builtin("knot"), |p| (p * 1024.0).round() / 1024.0);
    let small = simplified("knot", &knot, FACES);
    let (scale, offset) = ((-20_f32).exp2(), Vec3::new(4096.0, -2048.0, 1024.0));
    assert_eq!(simplify(&moved(&knot, |p| p * scale), FACES).unwrap(), moved(&small, |p| p * scale));
    assert_eq!(simplify(&moved(&knot, |p| p + offset), FACES).unwrap(), moved(&small, |p| p + offset));

    // And where they round.
    for factor in [1e-6, 1e-30, 1e30] {
        let tiny = moved(&knot, |p| p * factor);
        let small = simplified("scaled knot", &tiny, FACES);
        assert!(distance(&tiny, &small) < 0.05 * tiny.bounds().unwrap().radius, "{factor}");
    }
}

#[test]
fn triangles_apart_are_welded_first() {
    let torus = zoo::builtin("torus:64,32");
    let soup = TriangleMesh::new(
        torus.triangles().iter().flatten().map(|&vertex| torus.positions()[vertex as usize]).collect(),
        (0..torus.face_count() as u32).map(|face| [3 * face, 3 * face + 1, 3 * face + 2]).collect(),
    );
    let small = simplified("soup", &soup.unwrap(), FACES);
    assert!(inspected(&small).is_closed);
}

#[test]
fn a_mesh_that_is_small_enough_is_only_tidied() {
    let positions = [[9.0; 3], [0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]].map(Vec3::from);
    let mesh = TriangleMesh::new(positions.to_vec(), vec![[1, 2, 3], [1, 2, 4]]).unwrap();
    let tidied = TriangleMesh::new(positions[1..4].to_vec(), vec![[0, 1, 2]]).unwrap();
    assert_eq!(simplify(&mesh, 2), Ok(tidied.clone()));
    assert_eq!(simplify(&mesh, usize::MAX), Ok(tidied));
}

#[test]
fn threads_do_not_matter() {
    let mesh = zoo::builtin("blob:5672");
    let of = |threads| with_threads(threads, || simplify(&mesh, 100));
    assert_eq!(of(1), of(3));
}

#[test]
fn what_cannot_be_is_refused() {
    assert_eq!(simplify(&zoo::builtin("cube"), 0), Err(SimplifyError::NoneWanted));
    assert_eq!(simplify(&zoo::empty(), 10), Err(SimplifyError::NoFaces));
    let point = TriangleMesh::new(vec![Vec3::ONE; 3], vec![[0, 1, 2]]).unwrap();
    assert_eq!(simplify(&point, 10), Err(SimplifyError::NoFaces));

    // No torus has fewer than 14 faces, nothing closed fewer than 4.
    for (name, least) in [("torus", 14), ("icosphere:2", 4)] {
        match simplify(&zoo::builtin(name), least - 1) {
            Err(SimplifyError::OutOfReach { wanted, reached }) => assert!(wanted == least - 1 && reached >= least),
            other => panic!("{name}: {other:?}"),
        }
    }
    let error = simplify(&zoo::builtin("torus"), 13).unwrap_err().to_string();
    assert!(error.starts_with("13 faces cannot be reached, only "), "{error}");
}
