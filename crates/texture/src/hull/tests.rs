//! Tests of hulls as a whole, and of the proof against brute force.

use super::*;
use crate::hull::touching::faces_touch;
use crate::hull::winding_number::winding_number;
use glam::{DVec3, Vec3, Vec3Swizzles};
use proptest::prelude::*;
use silhouette_core::inspect::inspect;
use silhouette_core::shapes;
use silhouette_core::{FaceId, NoProgress, Topology, glam};
use silhouette_rays::MeshHierarchy;
use silhouette_testing::edits::{inside_out, joined, keeping, mapped, moved, transformed, with_positions};
use silhouette_testing::progress::Cancelling;
use silhouette_testing::real_meshes::real_mesh;
use silhouette_testing::strategies::soup;
use silhouette_testing::threads::with_threads;
use silhouette_testing::zoo;

fn builtin(name: &str) -> TriangleMesh {
    shapes::by_name(name).unwrap()
}

fn grown(mesh: &TriangleMesh, factor: f32) -> TriangleMesh {
    mapped(mesh, |position| position * factor)
}

fn offence(object: &TriangleMesh, hull: &TriangleMesh) -> Option<Offence> {
    Enclosed::new(object).by(hull).first
}

fn enclosing(object: &TriangleMesh, vertices: usize) -> Result<Hull, HullError> {
    let options = HullOptions { vertices, faces_per_vertex: 48, ..HullOptions::default() };
    Hull::enclosing(object, &options, &NoProgress)
}

#[test]
fn a_larger_copy_encloses_and_everything_else_is_named() {
    let object = builtin("icosphere:2");
    let hull = grown(&builtin("icosphere:1"), 1.5);
    assert_eq!(offence(&object, &hull), None);
    assert!(Hull::checked(&object, hull.clone()).unwrap().enclosure().unwrap().is_proved());

    let empty = zoo::empty();
    assert_eq!(offence(&object, &empty), Some(Offence::Empty));
    let open = keeping(&hull, |face| face != 5);
    assert!(matches!(offence(&object, &open), Some(Offence::Open(_))));
    assert!(matches!(offence(&object, &inside_out(&hull)), Some(Offence::Nested(_))));
    assert!(matches!(offence(&object, &moved(&hull, Vec3::X * 9.0)), Some(Offence::Outside(_))));
    assert!(matches!(offence(&object, &grown(&hull, 0.1)), Some(Offence::Outside(_))));
    let double = joined(&[&hull, &grown(&hull, 1.2)]);
    assert!(matches!(offence(&object, &double), Some(Offence::Nested(_))));
    let passing = joined(&[&hull, &moved(&hull, Vec3::X * 0.3)]);
    assert!(matches!(offence(&object, &passing), Some(Offence::SelfContact { .. })));
    let finned = zoo::finned_blob();
    assert!(matches!(offence(&grown(&object, 0.1), &finned), Some(Offence::Open(_))));
    let error = Hull::checked(&object, open).unwrap_err().to_string();
    assert!(error.contains("open at its edge") && !error.contains('\n'), "{error}");
}

/// A cavity is no second way in or out: the object in it is outside, and one around it is inside.
#[test]
fn a_hull_may_have_cavities_in_which_nothing_lies() {
    let [object, hull] = [builtin("icosphere:2"), grown(&builtin("icosphere:1"), 1.5)];
    let hollow = joined(&[&hull, &inside_out(&grown(&hull, 0.2))]);
    assert_eq!(offence(&object, &hollow), None);
    let inside = grown(&object, 0.1);
    assert!(matches!(offence(&inside, &hollow), Some(Offence::Outside(_))));
}

#[test]
fn a_vertex_or_only_an_edge_that_reaches_through_is_found() {
    let object = builtin("cube");
    let hull = grown(&builtin("icosphere:2"), 3.0);
    assert_eq!(offence(&object, &hull), None);
    // A vertex of the object through a face of the hull.
    let mut positions = object.positions().to_vec();
    positions[3] *= 9.0;
    assert!(matches!(offence(&with_positions(&object, positions), &hull), Some(Offence::ObjectEdge { .. })));
    // All vertices of the object are inside, but edges leave a hull that is dented between them.
    let dented =
        mapped(
            &hull,
            |position| if position.x > 1.5 && position.yz().length() < 1.8 { position * 0.1 } else { position },
        );
    let bar = mapped(&object, |position| position * Vec3::new(0.2, 2.0, 0.2) + Vec3::X);
    assert!(
        bar.positions()
            .iter()
            .all(|&position| { winding_number(&dented, &MeshHierarchy::new(&dented), position, |_| true) == Some(1) })
    );
    let found = Enclosed::new(&bar).by(&dented);
    assert!(found.hull_edges + found.object_edges > 0 && !found.is_proved(), "{found:?}");
}

/// Touching counts, and a gap of one bit does not.
#[test]
fn a_hull_that_touches_is_refused_and_one_a_bit_larger_is_not() {
    let object = builtin("cube");
    assert!(matches!(offence(&object, &object), Some(Offence::ObjectEdge { .. })));
    let larger = mapped(&object, |position| position.signum() * f32::from_bits(position.x.abs().to_bits() + 1));
    assert_eq!(offence(&object, &larger), None);
    // A corner of the object in the middle of a face.
    let touching =
        mapped(&object, |position| if position == object.positions()[0] { position } else { position * 0.5 });
    assert!(matches!(offence(&touching, &object), Some(Offence::ObjectEdge { .. })));
}

#[test]
fn an_object_of_no_extent_or_a_hull_of_too_few_vertices_is_refused() {
    assert_eq!(enclosing(&zoo::empty(), 100).unwrap_err(), HullError::NoExtent);
    let point = TriangleMesh::new(vec![Vec3::ONE; 3], vec![[0, 1, 2]]).unwrap();
    assert_eq!(enclosing(&point, 100).unwrap_err(), HullError::NoExtent);
    assert_eq!(enclosing(&builtin("cube"), 3).unwrap_err(), HullError::TooFewVertices(3));
    let cancelled = Hull::enclosing(&builtin("cube"), &HullOptions::default(), &Cancelling::at_once());
    assert_eq!(cancelled.unwrap_err(), HullError::Cancelled(Cancelled));
}

/// Rounded to steps of 1/16, the surfaces of small offsets are knots that were still being simplified after eight minutes.
#[test]
fn an_object_among_positions_that_are_too_far_apart_is_refused_unless_they_count_from_close_by() {
    let far = moved(&builtin("torus:24,16"), Vec3::splat(1e6));
    let refused = enclosing(&far, 24).unwrap_err();
    assert!(matches!(refused, HullError::TooFar { step, .. } if (step * 16.0 - 1.0).abs() < 1e-6), "{refused}");
    let near = far.relative_to(DVec3::splat(1e6)).unwrap();
    assert!(enclosing(&near, 100).is_ok());
}

/// The smallest numbers that there are, and the largest: a hull, or what to do. Close to either end, hulls are those of a usual cube
/// but for the last bits.
#[test]
fn objects_at_the_ends_of_32_bit_floats_have_a_hull_or_are_refused_with_what_to_do() {
    let share = |side: f64| {
        let cube = transformed(&builtin("cube"), side / 2.0, DVec3::ZERO);
        enclosing(&cube, 24).map(|hull| hull.offset().unwrap() / cube.bounds().unwrap().radius)
    };
    let usual = share(1.0).unwrap();
    for side in [1e-41, 1e-36, 1e37] {
        let found = share(side).unwrap_or_else(|error| panic!("{side}: {error}"));
        assert!((found / usual - 1.0).abs() < 0.01, "{side}: {found} for {usual}");
    }
    let small = share(1e-42).unwrap_err();
    assert!(
        matches!(small, HullError::TooSmall { .. }) && small.to_string().contains("scale it by a million"),
        "{small}"
    );
    let far = moved(&builtin("cube"), Vec3::splat(1e5));
    assert!(matches!(enclosing(&far, 24), Err(HullError::TooFar { .. })), "that an origin mends");
    let large = share(3e38).unwrap_err();
    assert!(
        matches!(large, HullError::TooLarge { .. }) && large.to_string().contains("scale it by a thousandth"),
        "{large}"
    );
    let at_the_end = moved(&transformed(&builtin("cube"), 2.5e37, DVec3::ZERO), Vec3::splat(2.9e38));
    assert!(matches!(enclosing(&at_the_end, 24), Err(HullError::TooLarge { .. })));
}

fn assert_encloses(name: &str, object: &TriangleMesh, hull: &Hull, vertices: usize) {
    assert!(hull.mesh().vertex_count() <= vertices, "{name}: {}", hull.mesh().vertex_count());
    assert!(hull.enclosure().unwrap().is_proved() && hull.offset().unwrap() > 0.0, "{name}");
    assert_eq!(offence(object, hull.mesh()), None, "{name}");
}

#[test]
fn every_shape_has_a_hull() {
    for (name, mesh) in zoo::all() {
        let hull = enclosing(&mesh, 100).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_encloses(name, &mesh, &hull, 100);
    }
}

#[test]
fn a_hull_is_found_in_any_unit_and_far_from_the_origin() {
    let knot = builtin("knot");
    let share = |scale: f64, origin: f64| {
        let placed = transformed(&knot, scale, DVec3::splat(origin));
        let hull = enclosing(&placed, 150).unwrap();
        assert_encloses(&format!("{scale} {origin}"), &placed, &hull, 150);
        hull.offset().unwrap() / placed.bounds().unwrap().radius
    };
    let offset = share(1.0, 0.0);
    for scale in [1e-9, 1e9] {
        assert!((share(scale, 0.0) / offset - 1.0).abs() < 0.5, "{scale}");
    }
    share(100.0, 1e6);
}

#[test]
fn few_vertices_are_enough_for_a_single_triangle_and_for_parts_far_apart() {
    let face = TriangleMesh::new(vec![Vec3::ZERO, Vec3::X, Vec3::Y], vec![[0, 1, 2]]).unwrap();
    assert_encloses("a face", &face, &enclosing(&face, 8).unwrap(), 8);
    let ball = builtin("icosphere:3");
    let pair = joined(&[&ball, &moved(&ball, Vec3::X * 6.0)]);
    let hull = enclosing(&pair, 60).unwrap();
    assert_encloses("two balls", &pair, &hull, 60);
    assert_eq!(inspect(hull.mesh(), &Topology::new(hull.mesh())).components.len(), 2);
    assert_encloses("a tetrahedron", &ball, &enclosing(&ball, 4).unwrap(), 4);
}

#[test]
fn more_vertices_bring_the_hull_closer() {
    let blob = builtin("blob:3000");
    let volume = |vertices| {
        let hull = Hull::enclosing(&blob, &HullOptions { vertices, ..HullOptions::default() }, &NoProgress).unwrap();
        inspect(hull.mesh(), &Topology::new(hull.mesh())).components[0].volume.unwrap()
    };
    let [few, many] = [12, 400].map(volume);
    let of_blob = inspect(&blob, &Topology::new(&blob)).components[0].volume.unwrap();
    assert!(few > many && many > of_blob, "{few} {many} {of_blob}");
}

/// The hull of a ball with a hole: with the hole closed, its inside is not covered.
#[test]
fn a_hull_does_not_lead_through_closed_holes() {
    let open = keeping(&builtin("icosphere:4"), {
        let ball = builtin("icosphere:4");
        move |face| ball.corners(FaceId::from_usize(face)).iter().all(|corner| corner.z < 0.9)
    });
    let area = |closed_holes| {
        let hull =
            Hull::enclosing(&open, &HullOptions { vertices: 300, closed_holes, faces_per_vertex: 100 }, &NoProgress)
                .unwrap();
        assert_encloses("ball with a hole", &open, &hull, 300);
        inspect(hull.mesh(), &Topology::new(hull.mesh())).components[0].area
    };
    assert!(area(0.0) > 1.5 * area(2.0));
}

#[test]
fn threads_do_not_change_a_hull() {
    let blob = builtin("blob:3000");
    let [one, four] = [1, 4].map(|count| with_threads(count, || enclosing(&blob, 100).unwrap()));
    assert_eq!(one.mesh(), four.mesh());
    assert_eq!(one.offset().map(f64::to_bits), four.offset().map(f64::to_bits));
}

#[test]
fn real_meshes_have_hulls_of_the_papers_sizes() {
    for (file, vertices) in [("stanford-bunny.obj", 500), ("bear.off", 500), ("head.off", 500)] {
        if let Some(mesh) = real_mesh("hulls", file) {
            let hull = enclosing(&mesh, vertices).unwrap();
            assert_encloses(file, &mesh, &hull, vertices);
        }
    }
}

/// Every pair of faces, and a winding number for every vertex.
fn encloses_by_brute_force(object: &TriangleMesh, hull: &TriangleMesh) -> bool {
    let faces = |mesh: &TriangleMesh| {
        (0..mesh.face_count()).map(|face| mesh.corners(FaceId::from_usize(face))).collect::<Vec<_>>()
    };
    let of_hull = faces(hull);
    let touches = |corners: &[Vec3; 3]| of_hull.iter().any(|&face| faces_touch(*corners, face));
    let hierarchy = MeshHierarchy::new(hull);
    let is_inside =
        |&vertex: &u32| winding_number(hull, &hierarchy, object.positions()[vertex as usize], |_| true) == Some(1);
    !faces(object).iter().any(touches) && object.triangles().as_flattened().iter().all(is_inside)
}

proptest! {
    /// On a lattice, where touching is common. A cube's surface is no hull that fails for itself.
    #[test]
    fn the_proof_is_that_of_brute_force(
        mesh in soup(6), center in prop::array::uniform3(-1_i8..=1), half in 1_i8..6, is_round in any::<bool>(),
    ) {
        prop_assume!(mesh.face_count() > 0);
        let base = builtin(if is_round { "icosphere:1" } else { "cube" });
        let size = f32::from(half) / base.positions()[0].abs().max_element();
        let hull = mapped(&base, |position| (position * size + Vec3::from(center.map(f32::from))).round());
        let found = Enclosed::new(&mesh).by(&hull);
        prop_assume!(!matches!(found.first, Some(Offence::SelfContact { .. } | Offence::Flat(_))));
        prop_assert_eq!(found.is_proved(), encloses_by_brute_force(&mesh, &hull), "{:?}", found);
    }

}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(16))]

    #[test]
    fn any_triangles_have_a_hull(mesh in soup(8), vertices in 40_usize..120) {
        prop_assume!(mesh.bounds().is_some_and(|bounds| bounds.radius > 0.0));
        let hull = enclosing(&mesh, vertices).unwrap();
        assert_encloses("soup", &mesh, &hull, vertices);
    }
}
