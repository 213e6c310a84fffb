//! Silhouette half-edges and loops as a cut between front and back faces.

use crate::seen::{Seen, look};
use glam::{DVec3, Vec3};
use proptest::prelude::*;
use silhouette_core::loops::start_vertex;
use silhouette_core::orientation::orientation;
use silhouette_core::{FaceFacings, FaceId, HalfEdgeId, SilhouetteEdges, Topology, TriangleMesh, Viewpoint};
use silhouette_testing::edges::half_edge_ends;
use silhouette_testing::edits::{joined, mapped, moved};
use silhouette_testing::strategies::{closed_mesh, convex_body, open_mesh, viewpoint};
use silhouette_testing::views::seen_from;
use std::collections::BTreeMap;
use std::f64::consts::PI;

/// How many more silhouette half-edges begin in each vertex than end there.
fn surplus(mesh: &TriangleMesh, half_edges: impl Iterator<Item = HalfEdgeId>) -> BTreeMap<u32, i64> {
    let mut surplus = BTreeMap::new();
    for half_edge in half_edges {
        *surplus.entry(start_vertex(mesh, half_edge).get()).or_default() += 1;
        *surplus.entry(start_vertex(mesh, half_edge.next_in_face()).get()).or_default() -= 1;
    }
    surplus
}

fn of_front_faces<'a>(
    topology: &'a Topology,
    facings: &'a FaceFacings,
    edges: &'a SilhouetteEdges,
) -> impl Iterator<Item = HalfEdgeId> + 'a {
    let half_edges = edges.iter().flat_map(|edge| topology.half_edges(edge).iter().copied());
    half_edges.filter(|half_edge| facings.is_front(half_edge.face()))
}

fn corners(mesh: &TriangleMesh, face: FaceId) -> [DVec3; 3] {
    mesh.corners(face).map(Vec3::as_dvec3)
}

/// The signed solid angle of a face, below 0 where it is front.
fn solid_angle_of([a, b, c]: [DVec3; 3], eye: Vec3) -> f64 {
    let [a, b, c] = [a, b, c].map(|p| (p - eye.as_dvec3()).normalize());
    2.0 * a.dot(b.cross(c)).atan2(1.0 + a.dot(b) + b.dot(c) + c.dot(a))
}

fn solid_angle(mesh: &TriangleMesh, eye: Vec3) -> f64 {
    faces(mesh).map(|face| solid_angle_of(corners(mesh, face), eye)).sum()
}

fn faces(mesh: &TriangleMesh) -> impl Iterator<Item = FaceId> {
    (0..mesh.face_count()).map(FaceId::from_usize)
}

proptest! {
    /// Invariant 1, of views and of random labels.
    #[test]
    fn as_many_half_edges_end_in_a_vertex_as_begin_there(
        mesh in prop_oneof![closed_mesh(), open_mesh()],
        viewpoint in viewpoint(),
        labels in any::<u128>(),
    ) {
        let Seen { topology, facings, edges, .. } = look(&mesh, &viewpoint);
        prop_assert!(surplus(&mesh, of_front_faces(&topology, &facings, &edges)).values().all(|more| *more == 0));
        let facings = FaceFacings::from_fn(mesh.face_count(), |face| labels >> (face.get() % 128) & 1 == 1);
        let edges = SilhouetteEdges::of(&topology, &facings);
        let all: Vec<_> = of_front_faces(&topology, &facings, &edges).collect();
        prop_assert!(surplus(&mesh, all.iter().copied()).values().all(|more| *more == 0));
        // Without one of them, two vertices are out of balance.
        if let Some((_, rest)) = all.split_first() {
            prop_assert_eq!(surplus(&mesh, rest.iter().copied()).values().filter(|more| **more != 0).count(), 2);
        }
    }

    /// Invariant 4: seen from the other side of infinity, front and back are exchanged.
    #[test]
    fn the_opposite_direction_has_the_same_edges(mesh in closed_mesh(), direction in prop::array::uniform3(-3.0_f32..3.0)) {
        let of = |sign: f32| look(&mesh, &Viewpoint::Orthographic { toward_viewer: Vec3::from(direction) * sign });
        let (one, other) = (of(1.0), of(-1.0));
        prop_assume!(one.facings.front_count() + other.facings.front_count() == mesh.face_count());
        prop_assert!(faces(&mesh).all(|face| one.facings.is_front(face) != other.facings.is_front(face)));
        prop_assert_eq!(one.edges, other.edges);
    }

    /// Invariant 5: a loop for each of several convex bodies apart from each other, but for the one that the eye is in.
    #[test]
    fn disjoint_convex_bodies_have_a_loop_each(
        bodies in prop::collection::vec((convex_body(), prop::array::uniform3(-2_i8..=2)), 1..6),
        eye in prop::array::uniform3(-1.0_f32..1.0),
        inside: bool,
    ) {
        let mut places: Vec<[i8; 3]> = bodies.iter().map(|(_, place)| *place).collect();
        places.sort_unstable();
        places.dedup();
        prop_assume!(places.len() == bodies.len());
        // Each fits a cube of side 2, and cubes are 4 apart.
        let at = |place: [i8; 3]| Vec3::from(place.map(f32::from)) * 4.0;
        let placed: Vec<TriangleMesh> = bodies.iter().map(|(body, place)| moved(body, at(*place))).collect();
        let mesh = joined(&placed.iter().collect::<Vec<_>>());
        // Bodies hold a ball of a tenth about their middle.
        let eye = if inside { at(bodies[0].1) + Vec3::from(eye) * 0.05 } else { Vec3::splat(2.0) + Vec3::from(eye) * 0.5 };
        let seen = look(&mesh, &seen_from(eye));
        let is_tied = |face| { let [a, b, c] = mesh.corners(face); orientation(a, b, c, eye) == 0.0 };
        prop_assume!(!faces(&mesh).any(is_tied));
        prop_assert_eq!(seen.loops.len(), bodies.len() - usize::from(inside));
    }

    /// Invariant 6: where a face alone becomes front or back amid neighbours that all face the other way, one of its edges
    /// is concave, unless the eye passes through the face itself.
    #[test]
    fn a_face_that_turns_alone_has_a_concave_edge(
        mesh in closed_mesh(),
        place in prop::array::uniform2(-4.0_f64..4.0),
        choice in any::<prop::sample::Index>(),
    ) {
        let face = FaceId::from_usize(choice.index(mesh.face_count()));
        let [a, b, c] = corners(&mesh, face);
        let eye = (a + (b - a) * place[0] + (c - a) * place[1]).as_vec3();
        // The eye has to be clear of the face, and its neighbours not be in doubt.
        let [s, t] = place;
        prop_assume!(s < -0.01 || t < -0.01 || s + t > 1.01);
        let topology = Topology::new(&mesh);
        let slots = || (0..3).map(|slot| HalfEdgeId::of(face, slot));
        let neighbours: Vec<FaceId> = slots().map(|h| topology.faces(topology.edge_of(h)).find(|of| *of != face).unwrap()).collect();
        let side = |of: FaceId| { let [u, v, w] = mesh.corners(of); orientation(u, v, w, eye) };
        let [u, v, w] = mesh.corners(face);
        let height = |of: FaceId| {
            let apex = mesh.corners(of).into_iter().max_by(|p, q| orientation(u, v, w, *p).abs().total_cmp(&orientation(u, v, w, *q).abs()));
            orientation(u, v, w, apex.unwrap())
        };
        let is_alone = neighbours.iter().all(|of| side(*of) > 0.0) || neighbours.iter().all(|of| side(*of) < 0.0);
        // Concave: the neighbour rises above the face's plane. Coplanar neighbours are in doubt.
        prop_assume!(neighbours.iter().all(|of| height(*of).abs() > 1e-9));
        if is_alone {
            prop_assert!(neighbours.iter().any(|of| height(*of) > 0.0), "{:?}", mesh.corners(face));
        }
    }

    /// Invariant 9, seen from infinitely far: the areas that projected loops run around add up to that of the projected
    /// front faces, each as often as it lies there.
    #[test]
    fn projected_loops_enclose_the_projected_front_area(
        mesh in prop_oneof![closed_mesh(), open_mesh()],
        direction in prop::array::uniform3(-3.0_f32..3.0),
    ) {
        let toward_viewer = Vec3::from(direction);
        prop_assume!(toward_viewer.length() > 0.1);
        let seen = look(&mesh, &Viewpoint::Orthographic { toward_viewer });
        let (x, y) = toward_viewer.normalize().as_dvec3().any_orthonormal_pair();
        let project = |p: DVec3| [p.dot(x), p.dot(y)];
        let area = |[a, b, c]: [[f64; 2]; 3]| ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) * 0.5;
        let front: f64 = faces(&mesh).filter(|&face| seen.facings.is_front(face)).map(|face| area(corners(&mesh, face).map(project))).sum();
        let of_side = |half_edge: &HalfEdgeId| { let [a, b] = half_edge_ends(&mesh, *half_edge).map(project); area([[0.0; 2], a, b]) };
        let enclosed: f64 = seen.loops.iter().map(|half_edges| half_edges.iter().map(of_side).sum::<f64>()).sum();
        prop_assert!((front - enclosed).abs() < 1e-9, "{} {}", front, enclosed);
        prop_assert!(front >= -1e-9);
    }

    /// Invariant 10: solid angles add up to a whole number of spheres, and front faces are those that count negatively.
    #[test]
    fn solid_angles_of_a_closed_mesh_add_up_to_whole_spheres(mesh in closed_mesh(), eye in prop::array::uniform3(-3.0_f32..3.0)) {
        let eye = Vec3::from(eye);
        let seen = look(&mesh, &seen_from(eye));
        for face in faces(&mesh) {
            let at = corners(&mesh, face);
            prop_assume!(at.iter().all(|corner| corner.distance(eye.as_dvec3()) > 1e-3));
            let angle = solid_angle_of(at, eye);
            prop_assert!(angle.abs() < 1e-9 || (angle < 0.0) == seen.facings.is_front(face), "{}: {}", face, angle);
        }
        let spheres = solid_angle(&mesh, eye) / (4.0 * PI);
        prop_assert!((spheres - spheres.round()).abs() < 1e-6, "{} spheres", spheres);
    }
}

/// The properties above notice what breaks them: a mesh with a hole, and bodies that pass through each other.
#[test]
fn what_is_no_closed_surface_and_no_convex_body_breaks_them() {
    let sphere = silhouette_testing::builtin("icosphere:2");
    let open = silhouette_testing::edits::keeping(&sphere, |face| face != 7);
    let spheres = |mesh: &TriangleMesh| solid_angle(mesh, Vec3::new(0.1, 0.3, 0.2)) / (4.0 * PI);
    assert!((spheres(&sphere) - 1.0).abs() < 1e-9 && (spheres(&open) - 1.0).abs() > 1e-4, "{}", spheres(&open));
    let dented = mapped(&sphere, |p| if p.x > 0.7 { Vec3::new(1.0 - p.x, p.y, p.z) } else { p });
    let loops: Vec<usize> =
        (0..40).map(|step| look(&dented, &seen_from(Vec3::new(6.0, step as f32 * 0.3, 1.0))).loops.len()).collect();
    assert!(loops.iter().any(|count| *count > 1), "{loops:?}");
}
