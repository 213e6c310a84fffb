//! Areas, lengths and counts that a silhouette must have, by another route than the extraction's.

use crate::seen::look;
use glam::{DVec3, Vec3};
use proptest::prelude::*;
use silhouette_core::shapes::Sphere;
use silhouette_core::{FaceId, Topology, TriangleMesh, Viewpoint};
use silhouette_testing::builtin;
use silhouette_testing::directions::spread;
use silhouette_testing::edges::{edge_ends, half_edge_ends};
use silhouette_testing::edits::mapped;
use silhouette_testing::strategies::{closed_mesh, open_mesh, viewpoint};
use silhouette_testing::views::seen_from;
use std::f64::consts::PI;

fn vector_area(mesh: &TriangleMesh, face: FaceId) -> DVec3 {
    let [a, b, c] = mesh.corners(face).map(Vec3::as_dvec3);
    (b - a).cross(c - a) * 0.5
}

/// Angle between the normals at each interior edge, and the edge's length.
fn bends(mesh: &TriangleMesh) -> impl Iterator<Item = (f64, f64)> {
    let topology = Topology::new(mesh);
    topology.edges().ids().collect::<Vec<_>>().into_iter().map(move |edge| {
        let normals: Vec<_> = topology.faces(edge).map(|face| vector_area(mesh, face).normalize()).collect();
        let [a, b] = edge_ends(mesh, &topology, edge);
        (normals[0].angle_between(normals[1]), a.distance(b))
    })
}

proptest! {
    /// Stokes: the vector areas of the front faces add up to the loops' areas.
    #[test]
    fn loops_enclose_the_front_vector_area(mesh in prop_oneof![closed_mesh(), open_mesh()], viewpoint in viewpoint()) {
        let seen = look(&mesh, &viewpoint);
        let faces = (0..mesh.face_count()).map(FaceId::from_usize);
        let front: DVec3 = faces.filter(|&face| seen.facings.is_front(face)).map(|face| vector_area(&mesh, face)).sum();
        let enclosed: DVec3 = seen.loops.half_edges().iter().map(|&h| { let [a, b] = half_edge_ends(&mesh, h); a.cross(b) * 0.5 }).sum();
        prop_assert!(front.distance(enclosed) < 1e-10, "{} {}", front, enclosed);
    }

    /// Scaling by a power of two is exact, so that it must not change a single edge, down to subnormal products.
    #[test]
    fn scale_changes_nothing(mesh in closed_mesh(), viewpoint in viewpoint(), exponent in -110_i32..60) {
        let scale = 2.0_f32.powi(exponent);
        let scaled = mapped(&mesh, |p| p * scale);
        let scaled_view = match viewpoint {
            Viewpoint::Perspective { eye } => Viewpoint::Perspective { eye: eye * scale },
            Viewpoint::Orthographic { toward_viewer } => Viewpoint::Orthographic { toward_viewer: toward_viewer * scale },
        };
        // Coordinates that scaling itself rounds make another mesh.
        prop_assume!(scaled.positions().iter().zip(mesh.positions()).all(|(&s, &p)| s / scale == p));
        prop_assert_eq!(look(&mesh, &viewpoint).edges, look(&scaled, &scaled_view).edges);
    }
}

#[test]
fn an_eye_infinitely_far_sees_the_orthographic_silhouette() {
    let mesh = builtin("blob:20000");
    for direction in spread(20).map(DVec3::as_vec3) {
        let far = look(&mesh, &seen_from(direction * 1e9));
        let ortho = look(&mesh, &Viewpoint::Orthographic { toward_viewer: direction });
        let differing = far.edges.iter().filter(|&edge| !ortho.edges.contains(edge)).count();
        assert!(differing <= 2, "{differing} of {} edges from {direction}", ortho.edges.len());
    }
}

#[test]
fn orthographic_averages_follow_from_the_bends() {
    let mesh = builtin("blob:3000");
    let (mut count, mut length, mut area) = (0.0, 0.0, 0.0);
    let views = 2000;
    for direction in spread(views).map(DVec3::as_vec3) {
        let seen = look(&mesh, &Viewpoint::Orthographic { toward_viewer: direction });
        count += seen.edges.len() as f64;
        let lengths = seen.edges.iter().map(|edge| {
            let [a, b] = edge_ends(&mesh, &seen.topology, edge);
            a.distance(b)
        });
        length += lengths.sum::<f64>();
        let faces = (0..mesh.face_count()).map(FaceId::from_usize).filter(|&face| seen.facings.is_front(face));
        area += faces.map(|face| vector_area(&mesh, face).dot(direction.as_dvec3())).sum::<f64>();
    }
    let expected_count: f64 = bends(&mesh).map(|(angle, _)| angle / PI).sum();
    let expected_length: f64 = bends(&mesh).map(|(angle, length)| angle * length / PI).sum();
    let surface: f64 = (0..mesh.face_count()).map(|face| vector_area(&mesh, FaceId::from_usize(face)).length()).sum();
    for (name, sum, expected) in
        [("edges", count, expected_count), ("length", length, expected_length), ("front area", area, surface / 4.0)]
    {
        let mean = sum / views as f64;
        assert!((mean / expected - 1.0).abs() < 0.01, "{name}: mean {mean}, expected {expected}");
    }
}

/// A polyhedron's silhouette is longer than the smooth one by 4 / pi, however fine the mesh.
#[test]
fn edge_silhouettes_of_a_sphere_stay_too_long() {
    for level in 2..5 {
        let mesh = Sphere::default().icosphere(level).unwrap();
        let length: f64 = bends(&mesh).map(|(angle, length)| angle * length / PI).sum();
        let circle = 2.0 * PI * Sphere::default().radius;
        assert!((length / circle - 4.0 / PI).abs() < 0.03, "level {level}: {}", length / circle);
    }
}

/// Signed solid angles of the faces add up to 0 outside of a closed mesh and to 4 pi inside; front faces are those that
/// count negatively.
#[test]
fn front_faces_have_negative_solid_angles() {
    let mesh = builtin("gear");
    for (scale, total) in [(5.0, 0.0), (0.6, 4.0 * PI)] {
        let eye = Vec3::new(0.73, 0.011, 0.0) * scale;
        let seen = look(&mesh, &seen_from(eye));
        let mut sum = 0.0;
        for face in (0..mesh.face_count()).map(FaceId::from_usize) {
            let [a, b, c] = mesh.corners(face).map(|p| (p.as_dvec3() - eye.as_dvec3()).normalize());
            let triple = a.dot(b.cross(c));
            let angle = 2.0 * triple.atan2(1.0 + a.dot(b) + b.dot(c) + c.dot(a));
            assert!(angle.abs() < 1e-9 || (angle < 0.0) == seen.facings.is_front(face), "face {face}: {angle}");
            sum += angle;
        }
        assert!((sum - total).abs() < 1e-9, "eye {eye}: {sum}");
    }
}
