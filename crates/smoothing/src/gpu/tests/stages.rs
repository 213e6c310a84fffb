//! Each stage against its CPU twin.

use super::scene::{Frame, SHAPES, Scene, cameras, method, pipelines};
use crate::bridges::bridge;
use crate::feature_segments::Tangents;
use crate::gpu::tables::Tables;
use crate::options::Invisible;
use crate::perturbation::Perturbation;
use crate::sampling::Sampling;
use crate::silhouette_points::SilhouettePoint;
use crate::silhouette_segments::SegmentLaw;
use crate::vertex_visibility::visible;
use crate::{Remesher as _, ShadingMesh, Smoothing, SmoothingOptions, SmoothingView, ViewMesh};
use silhouette_core::FaceId;
use silhouette_core::id::HalfEdgeId;
use silhouette_core::view::{Camera, Projection};
use silhouette_testing::directions::spread;
use silhouette_testing::gpu_or_skip;

/// A sign is certain where |N . D| is above this share of |D|: 64 roundings to 32 bits.
const CERTAIN: f64 = 64.0 * f32::EPSILON as f64;

/// How far apart both paths may be, over the mesh's radius.
const NEAR: f64 = 1e-5;

/// What differs between both paths in one view.
#[derive(Debug, Default)]
struct Differences {
    points: usize,
    worst_point: f64,
    /// Points beside their bridges, as the CPU has them.
    beside: usize,
    segments: usize,
    other_pieces: usize,
    moved: usize,
    far_vertices: usize,
}

/// Compares what a frame left with what the CPU makes of the same view; all that follows from signs only where these agree.
fn compare(method: &mut Smoothing, frame: &Frame, camera: &Camera, sums: &mut Differences) {
    let view = SmoothingView::from_camera(camera);
    let mut out = ViewMesh::default();
    method.remesh(&view, &mut out);
    let mesh = method.shading_mesh().clone();
    let radius = mesh.mesh().bounds().unwrap().radius;
    let mut all_agree = true;
    for (group, (&position, &normal)) in mesh.positions().iter().zip(mesh.normals()).enumerate() {
        assert!(frame.normals[group].distance(normal.as_dvec3()) < 1e-6);
        let toward = view.eye().toward(position.as_dvec3());
        let expected = visible(position, normal, view.eye());
        if expected != frame.is_visible(group) {
            all_agree = false;
            assert!(normal.as_dvec3().dot(toward).abs() <= CERTAIN * toward.length(), "vertex {group}");
        }
    }
    if !all_agree {
        return;
    }
    let silhouette = method.silhouette();
    let tables = Tables::new(method);
    for segment in silhouette.segments() {
        let (face, lone) = (segment.triangle.face.index(), segment.triangle.lone as usize);
        for (end, slot) in [lone, (lone + 2) % 3].into_iter().enumerate() {
            let expected = silhouette.points()[segment.points[end] as usize];
            let point = tables.words[tables.at.sides as usize + 3 * face + slot] / 4;
            let found = frame.positions[(frame.settings.groups + point) as usize];
            sums.points += 1;
            sums.worst_point = sums.worst_point.max(found.distance(expected.position) / radius);
            sums.beside += usize::from(off_bridge(&mesh, face, slot, &expected) > 1e-3 * radius);
        }
    }
    let counts: Vec<u32> =
        (0..mesh.triangles().len()).map(|face| frame.pieces(face)).filter(|&pieces| pieces > 0).collect();
    assert_eq!(counts.len(), silhouette.segments().len());
    sums.segments += counts.len();
    let mut same = true;
    for (&found, &expected) in counts.iter().zip(method.counts()) {
        assert!(found.abs_diff(expected) <= 1, "{found} for {expected}");
        same &= found == expected;
        sums.other_pieces += usize::from(found != expected);
    }
    if same {
        assert!(frame.proper_triangles().len().abs_diff(out.triangles.len()) <= 2 * method.features().edges().len());
        if method.features().edges().is_empty() {
            assert_eq!(frame.proper_triangles().len(), out.triangles.len());
        }
    }
    for (group, position) in out.positions.iter().take(mesh.positions().len()).enumerate() {
        sums.moved += usize::from(*position != mesh.positions()[group]);
        sums.far_vertices += usize::from(frame.positions[group].distance(position.as_dvec3()) > 10.0 * NEAR * radius);
    }
}

/// How far a point on a side that is no feature edge is from its bridge; 0 on feature edges.
fn off_bridge(mesh: &ShadingMesh, face: usize, slot: usize, point: &SilhouettePoint) -> f64 {
    let half_edge = HalfEdgeId::of(FaceId::from_usize(face), slot as u32);
    if mesh.features()[mesh.topology().edge_of(half_edge)] {
        return 0.0;
    }
    let mut ends = [slot, (slot + 1) % 3].map(|slot| mesh.triangles()[face][slot] as usize);
    ends.sort_unstable_by_key(|&end| mesh.vertices()[end]);
    let bridge =
        bridge(ends.map(|end| mesh.positions()[end].as_dvec3()), ends.map(|end| mesh.normals()[end].as_dvec3()));
    bridge.point(point.u).distance(point.position)
}

/// From so near that bridges cross the contour twice.
#[test]
fn both_paths_have_the_same_points_beside_bridges() {
    let Some(gpu) = gpu_or_skip("both_paths_have_the_same_points_beside_bridges") else { return };
    let pipelines = pipelines(gpu);
    let mut sums = Differences::default();
    for name in ["icosphere:1", "torus:16,10", "blob:800"] {
        let mut method = method(name, SmoothingOptions { invisible: Invisible::Kept, ..Default::default() });
        let mut scene = Scene::new(gpu, &pipelines, &method);
        let bounds = method.shading_mesh().mesh().bounds().unwrap();
        for direction in spread(12) {
            let eye = bounds.center + 1.4 * bounds.radius * direction;
            let projection = Projection::Perspective { fov_y_rad: 1.6 };
            let up = direction.any_orthonormal_vector().as_vec3();
            let camera = Camera::new(eye.as_vec3(), bounds.center.as_vec3(), up, projection, [256; 2]).unwrap();
            let frame = scene.frame(&camera);
            compare(&mut method, &frame, &camera, &mut sums);
        }
    }
    assert!(sums.beside > 20 && sums.worst_point < NEAR, "{sums:?}");
}

#[test]
fn both_paths_agree_stage_by_stage() {
    let Some(gpu) = gpu_or_skip("both_paths_agree_stage_by_stage") else { return };
    let pipelines = pipelines(gpu);
    let kept = SmoothingOptions { invisible: Invisible::Kept, ..Default::default() };
    let variants = [
        kept,
        SmoothingOptions { newton_steps: 0, segments: SegmentLaw::AsPrinted, ..kept },
        SmoothingOptions {
            sampling: Sampling::AsPrinted,
            tolerance_px: 0.1,
            tangents: Tangents::AsPrinted,
            perturbation: Perturbation::AsPrinted,
            corner_deg: 180.0,
            ..kept
        },
    ];
    let mut sums = Differences::default();
    for options in variants {
        for name in SHAPES {
            let mut method = method(name, options);
            let mut scene = Scene::new(gpu, &pipelines, &method);
            for camera in cameras(method.shading_mesh().mesh(), 6) {
                let frame = scene.frame(&camera);
                compare(&mut method, &frame, &camera, &mut sums);
            }
        }
    }
    assert!(sums.points > 2000 && sums.worst_point < NEAR, "{sums:?}");
    assert!(sums.other_pieces * 200 <= sums.segments, "{sums:?}");
    assert!(sums.moved > 20 && sums.far_vertices * 50 <= sums.moved, "{sums:?}");
}
