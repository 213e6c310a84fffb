use proptest::prelude::*;
use silhouette_core::glam::Vec3;
use silhouette_core::method::ExtractsMovingEdges;
use silhouette_core::{ExtractsLoops, SilhouetteLoops, TriangleMesh, Viewpoint};
use silhouette_extraction::{BruteForce, BruteForceSimd, ClusterCones};
use silhouette_testing::edits::mapped;
use silhouette_testing::prepare::{method, prepared};
use silhouette_testing::strategies::{lattice_viewpoint, soup};
use silhouette_testing::views::hard_viewpoints;
use silhouette_testing::{builtin, zoo};

fn check(name: &str, mesh: TriangleMesh, views: &[Viewpoint]) {
    let mesh = prepared(mesh);
    let mut oracle: BruteForce = method(&mesh);
    let methods: [Box<dyn ExtractsLoops>; 2] =
        [Box::new(method::<BruteForceSimd>(&mesh)), Box::new(method::<ClusterCones>(&mesh))];
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
    for (name, mesh) in zoo::all() {
        let views = hard_viewpoints(&mesh, 10);
        check(name, mesh, &views);
    }
}

#[test]
fn loops_follow_a_mesh_that_moves() {
    let mesh = builtin("torus:40,24");
    let flattened = mapped(&mesh, |position| position * Vec3::new(1.0, 0.2, 1.0));
    let views = hard_viewpoints(&mesh, 3);
    let mut moving: BruteForceSimd = method(&prepared(mesh));
    moving.update_positions(flattened.positions()).unwrap();
    let mut oracle: BruteForce = method(&prepared(flattened));
    let (mut expected, mut found) = (SilhouetteLoops::default(), SilhouetteLoops::default());
    for view in &views {
        oracle.extract_loops(view, &mut expected);
        moving.extract_loops(view, &mut found);
        assert_eq!(found, expected);
    }
}

proptest! {
    #[test]
    fn any_soup(mesh in soup(150), views in prop::collection::vec(lattice_viewpoint(4), 1..8)) {
        check("soup", mesh, &views);
    }
}
