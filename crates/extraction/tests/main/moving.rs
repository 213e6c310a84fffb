use silhouette_core::glam::Vec3;
use silhouette_core::method::{ExtractsMovingEdges, PositionsError};
use silhouette_core::{ExtractsEdges, SilhouetteEdges, VertexId};
use silhouette_extraction::{BruteForce, BruteForceSimd};
use silhouette_testing::edits::{twisted, with_positions};
use silhouette_testing::prepare::{method, prepared};
use silhouette_testing::views::hard_viewpoints;
use silhouette_testing::{builtin, zoo};

#[test]
fn a_moving_mesh_equals_a_new_mesh_at_each_frame() {
    for (name, mesh) in zoo::all() {
        let mut moving: BruteForceSimd = method(&prepared(mesh.clone()));
        for time in [0.0, 0.3, 0.6, 0.9_f32] {
            let aside = Vec3::X * 10.0 * time;
            let positions: Vec<Vec3> = twisted(&mesh, time, 3.0).into_iter().map(|position| position + aside).collect();
            moving.update_positions(&positions).unwrap();
            let frozen = with_positions(&mesh, positions);
            let views = hard_viewpoints(&frozen, 5);
            let mut oracle: BruteForce = method(&prepared(frozen));
            let (mut expected, mut found) = (SilhouetteEdges::default(), SilhouetteEdges::default());
            for view in &views {
                oracle.extract_edges(view, &mut expected);
                moving.extract_edges(view, &mut found);
                assert_eq!(found, expected, "{name}, time {time}, {view:?}");
            }
        }
    }
}

#[test]
fn positions_that_do_not_fit_are_refused_and_change_nothing() {
    let mesh = builtin("blob:500");
    let views = hard_viewpoints(&mesh, 1);
    let mut positions = mesh.positions().to_vec();
    let vertices = positions.len();
    let mut moving: BruteForceSimd = method(&prepared(mesh));
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
