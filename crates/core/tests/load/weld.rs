use glam::Vec3;
use proptest::prelude::*;
use silhouette_core::weld::{WeldError, weld_exact, weld_within};
use silhouette_core::{TriangleMesh, glam};

/// Vertices on the x axis, and triangles over them.
fn on_axis(x: &[f32], triangles: &[[u32; 3]]) -> TriangleMesh {
    TriangleMesh::new(x.iter().map(|&x| Vec3::new(x, 0.0, 0.0)).collect(), triangles.to_vec()).unwrap()
}

fn axis(mesh: &TriangleMesh) -> Vec<f32> {
    mesh.positions().iter().map(|p| p.x).collect()
}

#[test]
fn equal_positions_join_their_lowest_id() {
    let mesh = on_axis(&[5.0, 0.0, -0.0, 5.0, 1.0, 0.0], &[[0, 1, 4], [3, 4, 2], [1, 2, 5]]);
    let welded = weld_exact(&mesh);
    assert_eq!(axis(&welded.mesh), [5.0, 0.0, 1.0]);
    assert_eq!(welded.vertex_of, [0, 1, 1, 0, 2, 1]);
    // Order and number of the triangles stay, the degenerate one included.
    assert_eq!(welded.mesh.triangles(), [[0, 1, 2], [0, 2, 1], [1, 1, 1]]);
    assert_eq!(welded.merged(), 3);
}

#[test]
fn a_chain_is_cut_where_the_representative_is_too_far() {
    let mesh = on_axis(&[0.0, 0.75, 1.5, 2.25, 3.0], &[]);
    let welded = weld_within(&mesh, 1.0).unwrap();
    assert_eq!(axis(&welded.mesh), [0.0, 1.5, 3.0]);
    assert_eq!(welded.vertex_of, [0, 0, 1, 1, 2]);
}

#[test]
fn the_lowest_representative_wins_and_the_tolerance_is_inclusive() {
    let mesh = on_axis(&[0.0, 1.5, 1.0], &[]);
    assert_eq!(weld_within(&mesh, 1.0).unwrap().vertex_of, [0, 1, 0]);
    assert_eq!(weld_within(&mesh, 0.999_999_9).unwrap().vertex_of, [0, 1, 1]);
}

#[test]
fn a_tolerance_of_zero_is_exact_and_no_distance_is_refused() {
    let mesh = on_axis(&[0.0, -0.0, f32::MIN_POSITIVE], &[[0, 1, 2]]);
    assert_eq!(weld_within(&mesh, 0.0).unwrap(), weld_exact(&mesh));
    assert_eq!(weld_within(&mesh, -1.0), Err(WeldError::Tolerance { tolerance: -1.0 }));
    for tolerance in [f32::NAN, f32::INFINITY] {
        assert!(weld_within(&mesh, tolerance).unwrap_err().to_string().contains("no distance"));
    }
}

#[test]
fn extreme_ratios_of_coordinate_to_tolerance_do_not_overflow() {
    let far = [f32::MAX, f32::MIN, 1e30, 1e30, 1.0, f32::from_bits(1), 0.0, 1.0 + f32::EPSILON];
    let tiny = weld_within(&on_axis(&far, &[]), f32::from_bits(1)).unwrap();
    assert_eq!(tiny.vertex_of, [0, 1, 2, 2, 3, 4, 4, 5]);
    let huge = weld_within(&on_axis(&far, &[]), f32::MAX).unwrap();
    assert_eq!(huge.vertex_of, [0, 1, 0, 0, 0, 0, 0, 0]);
}

#[test]
fn far_coordinates_do_not_share_a_cell() {
    // All cells of so fine a grid lie beyond 2^63; were they clamped, this would take minutes.
    let x: Vec<f32> = (0..100_000_u32).map(|i| f32::from_bits(0x3f80_0000 + i)).collect();
    assert_eq!(weld_within(&on_axis(&x, &[]), 1e-30).unwrap().merged(), 0);
}

/// The relation as documented, with nothing but a list to search.
fn weld_naively(mesh: &TriangleMesh, tolerance: f32) -> Vec<u32> {
    let mut representatives: Vec<Vec3> = Vec::new();
    let id_of = |&position: &Vec3| {
        let near = |r: &Vec3| r.as_dvec3().distance_squared(position.as_dvec3()) <= f64::from(tolerance).powi(2);
        let found = representatives.iter().position(near);
        found.unwrap_or_else(|| {
            representatives.push(position);
            representatives.len() - 1
        }) as u32
    };
    mesh.positions().iter().map(id_of).collect()
}

proptest! {
    #[test]
    fn the_grid_agrees_with_a_plain_search(
        points in prop::collection::vec(prop::array::uniform3(-8_i8..8), 1..80),
        step in 0.01_f32..10.0,
        offset in prop::sample::select(vec![0.0_f32, 1.0, -1e3, 1e6]),
        steps in 0.0_f32..4.0,
    ) {
        // On a lattice, distances that equal the tolerance and positions on cell walls are common.
        for tolerance in [step * steps, step * steps.round(), step * steps.round() * 0.5] {
            let positions = points.iter().map(|p| Vec3::from_array(p.map(|x| f32::from(x) * step + offset))).collect();
            let mesh = TriangleMesh::new(positions, vec![]).unwrap();
            prop_assert_eq!(weld_within(&mesh, tolerance).unwrap().vertex_of, weld_naively(&mesh, tolerance));
        }
    }
}
