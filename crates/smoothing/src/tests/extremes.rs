//! Far away, tiny, huge, degenerate: what each does to the result.

use super::{shape, smoothing};
use crate::sampling::MAX_SEGMENTS;
use crate::{Remesher, Smoothing, SmoothingOptions, SmoothingView, ViewMesh};
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::view::{Camera, Projection, Viewpoint};
use silhouette_core::{ExtractsCurves, Method, PreparedMesh, SilhouetteCurves, TriangleMesh, shapes};
use std::sync::Arc;

fn curves_of(mesh: &TriangleMesh, viewpoint: Viewpoint) -> SilhouetteCurves {
    let mut curves = SilhouetteCurves::default();
    smoothing(mesh.clone(), SmoothingOptions::default()).extract_curves(&viewpoint, &mut curves);
    curves
}

fn mapped(mesh: &TriangleMesh, map: impl Fn(Vec3) -> Vec3) -> TriangleMesh {
    TriangleMesh::new(mesh.positions().iter().map(|p| map(*p)).collect(), mesh.triangles().to_vec()).unwrap()
}

const EYE: Vec3 = Vec3::new(1.5, 2.0, 3.0);

/// Powers of two scale every number without rounding, and no threshold knows of units.
#[test]
fn results_scale_with_the_mesh_to_the_last_bit() {
    let mesh = shapes::by_name("torus:24,12").unwrap();
    let plain = curves_of(&mesh, Viewpoint::Perspective { eye: EYE });
    for exponent in [-30, 30] {
        let scale = 2.0_f32.powi(exponent);
        let scaled = curves_of(&mapped(&mesh, |p| p * scale), Viewpoint::Perspective { eye: EYE * scale });
        assert_eq!(plain.pieces().len(), scaled.pieces().len());
        for (a, b) in plain.pieces().iter().zip(scaled.pieces()) {
            assert_eq!(a.control.map(|point| point * scale), b.control);
        }
    }
}

/// At a million units positions are stored to 1/16 of a unit; with a mesh that fits that grid nothing is lost.
#[test]
fn results_move_with_the_mesh_far_from_the_origin() {
    let mesh = mapped(&shapes::by_name("icosphere:2").unwrap(), |p| (p * 1024.0).round());
    let offset = Vec3::new(1_000_000.0, -2_000_000.0, 500_000.0);
    let eye = Vec3::new(1500.0, 2000.0, 3000.0);
    let near = curves_of(&mesh, Viewpoint::Perspective { eye });
    let far = curves_of(&mapped(&mesh, |p| p + offset), Viewpoint::Perspective { eye: eye + offset });
    assert_eq!(near.pieces().len(), far.pieces().len());
    for (a, b) in near.pieces().iter().zip(far.pieces()) {
        assert_eq!(a.source, b.source);
        assert!(a.control.iter().zip(b.control).all(|(p, q)| (*p + offset).distance(q) <= 0.3), "a rounding of 1/8");
    }
}

#[test]
fn an_eye_at_ten_million_radii_sees_what_parallel_projection_shows() {
    let mesh = shapes::by_name("torus:24,12").unwrap();
    let direction = EYE.normalize();
    let far = curves_of(&mesh, Viewpoint::Perspective { eye: direction * 1e7 });
    let parallel = curves_of(&mesh, Viewpoint::Orthographic { toward_viewer: direction });
    assert_eq!(far.pieces().len(), parallel.pieces().len());
    for (a, b) in far.pieces().iter().zip(parallel.pieces()) {
        assert!(a.control.iter().zip(b.control).all(|(p, q)| p.distance(q) < 1e-5));
    }
}

#[test]
fn from_inside_a_closed_mesh_nothing_is_visible() {
    let mesh = shapes::by_name("icosphere:2").unwrap();
    assert!(curves_of(&mesh, Viewpoint::Perspective { eye: Vec3::new(0.1, 0.2, 0.1) }).is_empty());
}

/// A vertex that is seen edge-on is visible; its silhouette points lie on it, or in the limit away from it.
#[test]
fn an_eye_in_the_plane_of_a_vertex_s_normal_is_a_tie_and_the_chain_stays_closed() {
    let mesh = shapes::by_name("icosphere:1").unwrap();
    for &vertex in &mesh.positions()[..12] {
        let across = vertex.any_orthonormal_vector();
        for viewpoint in
            [Viewpoint::Orthographic { toward_viewer: across }, Viewpoint::Perspective { eye: vertex + across * 2.0 }]
        {
            let curves = curves_of(&mesh, viewpoint);
            assert!(curves.len() == 1 && curves.get(0).closed, "{viewpoint:?}");
        }
    }
}

#[test]
fn a_single_triangle_has_no_silhouette_triangle_and_three_boundary_curves() {
    let mesh = TriangleMesh::new(vec![Vec3::ZERO, Vec3::X, Vec3::Y], vec![[0, 1, 2]]).unwrap();
    let [front, behind] = [Vec3::Z, Vec3::NEG_Z]
        .map(|toward_viewer| curves_of(&mesh, Viewpoint::Orthographic { toward_viewer }).pieces().len());
    assert_eq!([front, behind], [3, 0]);
}

#[test]
fn fields_of_view_of_a_hundredth_and_of_179_degrees_sample_within_the_cap() {
    let mut method = shape("torus:24,12", SmoothingOptions { tolerance_px: 0.01, ..Default::default() });
    let faces = shapes::by_name("torus:24,12").unwrap().face_count();
    for (fov_deg, distance) in [(0.01_f64, 2e4_f32), (179.0, 1.45)] {
        let eye = DVec3::new(0.3, 0.2, 1.0).normalize().as_vec3() * distance;
        let projection = Projection::Perspective { fov_y_rad: fov_deg.to_radians() };
        let camera = Camera::new(eye, Vec3::ZERO, Vec3::Y, projection, [16384; 2]).unwrap();
        let mut out = ViewMesh::default();
        method.remesh(&SmoothingView::from_camera(&camera), &mut out);
        assert!(out.positions.iter().all(|p| p.is_finite()));
        assert!(out.triangles.len() <= faces * (2 * MAX_SEGMENTS as usize + 1));
    }
}

#[test]
fn a_viewport_of_one_pixel_needs_no_samples() {
    let mut method = shape("icosphere:1", SmoothingOptions::default());
    let camera = Camera::new(EYE, Vec3::ZERO, Vec3::Y, Projection::Orthographic { height: 3.0 }, [1, 1]).unwrap();
    let mut out = ViewMesh::default();
    method.remesh(&SmoothingView::from_camera(&camera), &mut out);
    assert_eq!(out.triangles.len(), 80 + 2 * method.silhouette().segments().len(), "three in place of one");
}

#[test]
fn a_tolerance_of_nothing_is_refused_by_name() {
    let mesh = Arc::new(PreparedMesh::new(shapes::by_name("cube").unwrap()));
    for tolerance_px in [0.0, -1.0, f64::NAN] {
        let error = Smoothing::new(&mesh, SmoothingOptions { tolerance_px, ..Default::default() }).unwrap_err();
        assert!(error.to_string().contains("tolerance"), "{error}");
    }
}
