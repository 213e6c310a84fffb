//! What holds of every re-meshed mesh.

use super::smoothing;
use crate::feature_segments::Tangents;
use crate::perturbation::Perturbation;
use crate::sampling::Sampling;
use crate::shading_normals::NormalWeights;
use crate::silhouette_segments::SegmentLaw;
use crate::vertex_visibility::Cells;
use crate::{Eye, Remesher, Smoothing, SmoothingOptions, SmoothingView, ViewMesh};
use proptest::prelude::*;
use silhouette_core::glam::{DMat4, DVec3, Vec3};
use silhouette_core::view::{Camera, Framing, Viewpoint};
use silhouette_core::{ExtractsCurves, Method, PreparedMesh, SilhouetteCurves, Topology, TriangleMesh, shapes};
use silhouette_testing::directions::spread;
use silhouette_testing::{strategies, views, zoo};
use std::sync::Arc;

const PROJECTIONS: [Framing; 2] = [Framing::Orthographic, Framing::Perspective { fov_y_rad: 0.7 }];

fn cameras(mesh: &TriangleMesh, count: usize) -> impl Iterator<Item = Camera> {
    let framed = |(i, direction)| views::framed(mesh, direction, PROJECTIONS[i % 2], [512; 2]);
    // Exact views along axes are where ties are.
    let axes = [DVec3::X, DVec3::NEG_Y, DVec3::Z];
    axes.into_iter().chain(spread(count)).enumerate().map(framed).collect::<Vec<_>>().into_iter()
}

fn options_that_differ() -> [SmoothingOptions; 3] {
    let default = SmoothingOptions::default();
    let printed = SmoothingOptions {
        newton_steps: 0,
        crease_deg: 20.0,
        corner_deg: 180.0,
        perturbation: Perturbation::AsPrinted,
        cells: Cells::AsPrinted,
        sampling: Sampling::AsPrinted,
        tangents: Tangents::AsPrinted,
        normals: NormalWeights::Angle,
        segments: SegmentLaw::AsPrinted,
        tolerance_px: 0.3,
        invisible: default.invisible,
        path: default.path,
    };
    [default, SmoothingOptions { crease_deg: 180.0, ..default }, printed]
}

#[test]
fn closed_meshes_stay_closed() {
    for (name, mesh) in zoo::closed() {
        for options in options_that_differ() {
            let mut method = smoothing(mesh.clone(), options);
            let mut out = ViewMesh::default();
            for camera in cameras(&mesh, 12) {
                method.remesh(&SmoothingView::from_camera(&camera), &mut out);
                let topology = Topology::new(&out.to_mesh().unwrap());
                assert_eq!(topology.boundary_edge_count(), 0, "{name} {options:?}");
            }
        }
    }
}

/// A boundary stays one: it is bent where it is smoothed, and nothing else opens.
#[test]
fn open_meshes_have_as_many_boundary_loops_as_before() {
    for (name, mesh) in zoo::with_boundary() {
        let euler = |mesh: &TriangleMesh| {
            let topology = Topology::new(mesh);
            let mut used = vec![false; mesh.vertex_count()];
            mesh.triangles().iter().flatten().for_each(|&vertex| used[vertex as usize] = true);
            let vertices = used.iter().filter(|used| **used).count() as i64;
            vertices - topology.edge_count() as i64 + mesh.face_count() as i64
        };
        let mut method = smoothing(mesh.clone(), SmoothingOptions::default());
        let mut out = ViewMesh::default();
        for camera in cameras(&mesh, 6) {
            method.remesh(&SmoothingView::from_camera(&camera), &mut out);
            assert_eq!(euler(&out.to_mesh().unwrap()), euler(&mesh), "{name}");
        }
    }
}

#[test]
fn a_plane_is_left_as_it_is_and_a_cube_keeps_its_edges() {
    for name in ["grid:4,4", "cube"] {
        let mesh = shapes::by_name(name).unwrap();
        let mut method = smoothing(mesh.clone(), SmoothingOptions::default());
        let mut out = ViewMesh::default();
        for camera in cameras(&mesh, 8) {
            method.remesh(&SmoothingView::from_camera(&camera), &mut out);
            assert_eq!(method.silhouette().segments().len(), 0, "{name}: one normal for all corners of each face");
            assert_eq!(out.triangles.len(), mesh.face_count(), "{name}: straight features are not bent {camera:?}");
        }
    }
}

#[test]
fn origins_say_where_vertices_lie_and_interpolate_what_is_linear() {
    let mesh = shapes::by_name("cylinder").unwrap();
    // Straight segments on the original: with face normals nothing is bent, and origins are exact.
    let mut method = smoothing(mesh.clone(), SmoothingOptions { corner_deg: 0.0, ..Default::default() });
    let mut out = ViewMesh::default();
    for camera in cameras(&mesh, 5) {
        method.remesh(&SmoothingView::from_camera(&camera), &mut out);
        let at_corner = |face: silhouette_core::FaceId, slot: u32| mesh.corners(face)[slot as usize].to_array();
        let flat = out.interpolate(at_corner);
        let reach = crate::tests::longest_edge(&mesh);
        for ((origin, position), flat) in out.origins.iter().zip(&out.positions).zip(&flat) {
            assert!((origin.weights.iter().sum::<f32>() - 1.0).abs() < 1e-5);
            assert!(position.distance(Vec3::from_array(*flat)) < 0.3 * reach);
        }
    }
}

/// A view and its mirror image along an edge's direction see the same silhouette points.
#[test]
fn faces_at_a_side_share_its_silhouette_point_to_the_last_bit() {
    let mesh = shapes::by_name("torus:24,12").unwrap();
    let mut method = smoothing(mesh.clone(), SmoothingOptions::default());
    let mut curves = SilhouetteCurves::default();
    for camera in cameras(&mesh, 20) {
        method.extract_curves(&camera.viewpoint(), &mut curves);
        let segments = method.silhouette().segments().len();
        assert_eq!(curves.pieces().len(), segments);
        assert_eq!(method.silhouette().points().len(), segments, "as many mixed edges as silhouette triangles");
        assert!(curves.iter().all(|chain| chain.closed));
    }
}

#[test]
fn meshes_wound_inside_out_have_the_same_outline() {
    let mesh = shapes::by_name("torus:24,12").unwrap();
    let turned = mesh.triangles().iter().map(|&[a, b, c]| [a, c, b]).collect();
    let turned = TriangleMesh::new(mesh.positions().to_vec(), turned).unwrap();
    let [mut method, mut inverted] = [mesh.clone(), turned].map(|mesh| smoothing(mesh, SmoothingOptions::default()));
    let (mut out, mut inverted_out) = (ViewMesh::default(), ViewMesh::default());
    // Along axes, vertices are ties, which rounding decides differently.
    for camera in cameras(&mesh, 6).skip(3) {
        let view = SmoothingView::from_camera(&camera);
        method.remesh(&view, &mut out);
        inverted.remesh(&view, &mut inverted_out);
        let sorted = |mesh: &ViewMesh| {
            let mut positions: Vec<_> =
                mesh.positions.iter().map(|p| (*p * 1e4).round().to_array().map(|x| x as i32)).collect();
            positions.sort_unstable();
            positions
        };
        assert!(sorted(&out) == sorted(&inverted_out), "{camera:?}");
    }
}

#[test]
fn a_steady_frame_allocates_nothing() {
    let mesh = shapes::by_name("gear").unwrap();
    let mut method = smoothing(mesh.clone(), SmoothingOptions::default());
    let (mut out, mut curves) = (ViewMesh::default(), SilhouetteCurves::default());
    let cameras: Vec<_> = cameras(&mesh, 12).collect();
    let mut all = |method: &mut Smoothing| {
        for camera in &cameras {
            method.remesh(&SmoothingView::from_camera(camera), &mut out);
            method.extract_curves(&camera.viewpoint(), &mut curves);
        }
    };
    all(&mut method);
    assert_eq!(allocation_counter::measure(|| all(&mut method)).count_total, 0);
}

fn check_finite(mesh: &TriangleMesh, viewpoint: Viewpoint, options: SmoothingOptions) {
    let mut method = Smoothing::new(&Arc::new(PreparedMesh::new(mesh.clone())), options).unwrap();
    let (mut out, mut curves) = (ViewMesh::default(), SilhouetteCurves::default());
    // A pinhole at the eye that looks at the origin, wherever that is.
    let eye = Eye::from(viewpoint);
    let to_clip = match viewpoint {
        Viewpoint::Perspective { eye } => {
            // Clip space whose w is the way towards the origin and a little beside it.
            let eye = eye.as_dvec3();
            let ahead = (DVec3::new(1e-3, 2e-3, 0.0) - eye).normalize();
            let (right, up) = ahead.any_orthonormal_pair();
            let row = |axis: DVec3| axis.extend(-axis.dot(eye));
            DMat4::from_cols(row(right), row(up), DVec3::ZERO.extend(1.0), row(ahead)).transpose()
        }
        Viewpoint::Orthographic { .. } => DMat4::from_scale(DVec3::splat(0.2)),
    };
    method.remesh(&SmoothingView::new(eye, to_clip, [512; 2]), &mut out);
    method.extract_curves(&viewpoint, &mut curves);
    assert!(out.positions.iter().all(|p| p.is_finite()), "a vertex is not finite");
    assert!(out.normals.iter().all(|n| n.is_finite()), "a normal is not finite");
    let vertices = out.positions.len() as u32;
    assert!(out.triangles.iter().flatten().all(|&vertex| vertex < vertices));
    assert!(curves.pieces().iter().all(|piece| piece.control.iter().all(|p| p.is_finite())), "a piece is not finite");
}

proptest! {
    #[test]
    fn soups_have_finite_vertices_from_everywhere(
        mesh in strategies::soup(24),
        viewpoint in prop_oneof![strategies::viewpoint(), strategies::lattice_viewpoint(4)],
        choice in 0..3_usize,
    ) {
        check_finite(&mesh, viewpoint, options_that_differ()[choice]);
    }

    #[test]
    fn shaken_meshes_of_every_size_have_finite_vertices(
        mesh in prop_oneof![strategies::closed_mesh(), strategies::open_mesh()],
        viewpoint in strategies::viewpoint(),
        exponent in -9..=9_i32,
        choice in 0..3_usize,
    ) {
        let scale = 10_f32.powi(exponent);
        let positions = mesh.positions().iter().map(|p| *p * scale).collect();
        let mesh = TriangleMesh::new(positions, mesh.triangles().to_vec()).unwrap();
        check_finite(&mesh, viewpoint, options_that_differ()[choice]);
    }
}

#[test]
fn every_specimen_has_finite_vertices_from_hard_viewpoints() {
    for (_, mesh) in zoo::all() {
        for viewpoint in views::hard_viewpoints(&mesh, 4) {
            check_finite(&mesh, viewpoint, SmoothingOptions::default());
        }
    }
    check_finite(&zoo::empty(), Viewpoint::Orthographic { toward_viewer: Vec3::Z }, SmoothingOptions::default());
}
