use crate::scenes::{adversarial, prepare, soup, viewpoint, zoo};
use proptest::prelude::*;
use silhouette_core::method::ExtractsMovingEdges;
use silhouette_core::{ExtractsLoops, PreparedMesh, SilhouetteLoops, TriangleMesh, Viewpoint};
use silhouette_extraction::{BruteForce, BruteForceSimd, ClusterCones};
use std::sync::Arc;

fn check(name: &str, mesh: TriangleMesh, views: &[Viewpoint]) {
    let mesh = Arc::new(PreparedMesh::new(mesh));
    let mut oracle: BruteForce = prepare(&mesh);
    let methods: [Box<dyn ExtractsLoops>; 2] =
        [Box::new(prepare::<BruteForceSimd>(&mesh)), Box::new(prepare::<ClusterCones>(&mesh))];
    let (mut expected, mut found) = (SilhouetteLoops::default(), SilhouetteLoops::default());
    for mut method in methods {
        for view in views {
            oracle.extract_loops(view, &mut expected);
            method.extract_loops(view, &mut found);
            assert_eq!(found, expected, "{name} from {view:?}");
        }
    }
}

#[test]
fn loops_equal_those_of_brute_force() {
    for (name, mesh) in zoo() {
        let views = adversarial(&mesh, 10);
        check(name, mesh, &views);
    }
}

#[test]
fn loops_follow_a_mesh_that_moves() {
    let mesh = silhouette_core::shapes::by_name("torus:40,24").unwrap();
    let flattened: Vec<_> =
        mesh.positions().iter().map(|p| *p * silhouette_core::glam::Vec3::new(1.0, 0.2, 1.0)).collect();
    let views = adversarial(&mesh, 3);
    let frozen = TriangleMesh::new(flattened.clone(), mesh.triangles().to_vec()).unwrap();
    let mut oracle: BruteForce = prepare(&Arc::new(PreparedMesh::new(frozen)));
    let mut moving: BruteForceSimd = prepare(&Arc::new(PreparedMesh::new(mesh)));
    moving.update_positions(&flattened).unwrap();
    let (mut expected, mut found) = (SilhouetteLoops::default(), SilhouetteLoops::default());
    for view in &views {
        oracle.extract_loops(view, &mut expected);
        moving.extract_loops(view, &mut found);
        assert_eq!(found, expected);
    }
}

proptest! {
    #[test]
    fn any_soup(mesh in soup(), views in prop::collection::vec(viewpoint(), 1..8)) {
        check("soup", mesh, &views);
    }
}
