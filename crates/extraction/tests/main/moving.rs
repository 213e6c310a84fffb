use crate::scenes::{adversarial, prepare, zoo};
use silhouette_core::glam::Vec3;
use silhouette_core::method::{ExtractsMovingEdges, PositionsError};
use silhouette_core::{ExtractsEdges, PreparedMesh, SilhouetteEdges, TriangleMesh, VertexId};
use silhouette_extraction::{BruteForce, BruteForceSimd};
use std::sync::Arc;

/// A twist that turns each height by another angle, and grows with time.
fn twisted(mesh: &TriangleMesh, time: f32) -> Vec<Vec3> {
    let twist = |p: &Vec3| {
        let (sin, cos) = (p.y * time).sin_cos();
        Vec3::new(p.x * cos - p.z * sin, p.y * (1.0 + 3.0 * time), p.x * sin + p.z * cos) + Vec3::X * 10.0 * time
    };
    mesh.positions().iter().map(twist).collect()
}

#[test]
fn a_moving_mesh_equals_a_new_mesh_at_each_frame() {
    for (name, mesh) in zoo() {
        let prepared = Arc::new(PreparedMesh::new(mesh));
        let mut moving: BruteForceSimd = prepare(&prepared);
        for frame in 0..4 {
            let positions = twisted(prepared.mesh(), frame as f32 * 0.3);
            moving.update_positions(&positions).unwrap();
            let frozen = TriangleMesh::new(positions, prepared.mesh().triangles().to_vec()).unwrap();
            let views = adversarial(&frozen, 5);
            let mut oracle: BruteForce = prepare(&Arc::new(PreparedMesh::new(frozen)));
            let (mut expected, mut found) = (SilhouetteEdges::default(), SilhouetteEdges::default());
            for view in &views {
                oracle.extract_edges(view, &mut expected);
                moving.extract_edges(view, &mut found);
                assert_eq!(found, expected, "{name}, frame {frame}, {view:?}");
            }
        }
    }
}

#[test]
fn positions_that_do_not_fit_are_refused_and_change_nothing() {
    let mesh = silhouette_core::shapes::by_name("blob:500").unwrap();
    let views = adversarial(&mesh, 1);
    let mut positions = mesh.positions().to_vec();
    let vertices = positions.len();
    let mut moving: BruteForceSimd = prepare(&Arc::new(PreparedMesh::new(mesh)));
    let (mut before, mut after) = (SilhouetteEdges::default(), SilhouetteEdges::default());
    moving.extract_edges(&views[4], &mut before);
    let short = moving.update_positions(&positions[1..]);
    assert_eq!(short, Err(PositionsError::Count { given: vertices - 1, vertices }));
    positions[17].y = f32::NAN;
    positions[99].y = f32::INFINITY;
    let not_finite = moving.update_positions(&positions);
    assert_eq!(not_finite, Err(PositionsError::NotFinite { vertex: VertexId::new(17) }));
    moving.extract_edges(&views[4], &mut after);
    assert!(!before.is_empty());
    assert_eq!(before, after);
}
