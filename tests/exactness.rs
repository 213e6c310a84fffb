//! Every exact extractor against unbounded integers: ten thousand random and a thousand hard viewpoints, tiny
//! to huge meshes, far from the origin.

use crate::seen::look;
use glam::Vec3;
use silhouette_compare::registry::Registry;
use silhouette_core::method::{OptionValues, PrepareError};
use silhouette_core::{ExtractsEdges, NoProgress, SilhouetteEdges, TriangleMesh, Viewpoint};
use silhouette_testing::edits::mapped;
use silhouette_testing::integers::IntegerMesh;
use silhouette_testing::prepare::{artefact, prepared};
use silhouette_testing::views::{hard_eye, seen_from};
use silhouette_testing::{Random, builtin};

const RANDOM_VIEWS: usize = 10_000;
const HARD_VIEWS: usize = 1_000;

/// A mesh with what its silhouettes follow from, in integers.
struct Case {
    mesh: TriangleMesh,
    exact: IntegerMesh,
    methods: Vec<(&'static str, Box<dyn ExtractsEdges>)>,
}

impl Case {
    fn new(mesh: TriangleMesh) -> Self {
        let prepared = prepared(mesh.clone());
        let exact = IntegerMesh::new(&mesh, artefact(&prepared));
        let registry = Registry::builtin();
        let methods = registry.entries().iter().filter(|entry| entry.info().exact).filter_map(|entry| {
            let info = entry.info();
            match entry.prepare(&prepared, &OptionValues::defaults(info.options), &NoProgress) {
                Ok(prepared) => Some((info.name, prepared.into_edges().expect("exact methods yield edges"))),
                // Not defined for this mesh.
                Err(PrepareError::Mesh(_)) => None,
                Err(error) => panic!("{}: {error}", info.name),
            }
        });
        Self { exact, mesh, methods: methods.collect() }
    }

    /// Number of edges on which methods and integers differ, over both kinds of view towards `eye`.
    fn differing(&mut self, eye: Vec3) -> usize {
        let views = [seen_from(eye), Viewpoint::Orthographic { toward_viewer: eye }];
        views.iter().map(|viewpoint| self.differing_in(viewpoint)).sum()
    }

    fn differing_in(&mut self, viewpoint: &Viewpoint) -> usize {
        let expected = self.exact.silhouette_edges(viewpoint);
        let mut found = SilhouetteEdges::default();
        let mut differing = 0;
        for (_, method) in &mut self.methods {
            method.extract_edges(viewpoint, &mut found);
            differing += expected.iter().filter(|&edge| !found.contains(edge)).count();
            differing += found.iter().filter(|&edge| !expected.contains(edge)).count();
        }
        differing
    }
}

/// Closed, open, flat-sided and one-sided meshes, each tiny, of unit size, huge, and far from the origin.
fn cases() -> Vec<Case> {
    let mut cases = Vec::new();
    for name in ["icosphere:2", "gear:5", "cube", "moebius:24,2", "blob:300"] {
        let mesh = builtin(name);
        for (scale, offset) in [(1.0, 0.0), (1e-9, 0.0), (1e9, 0.0), (1.0, 1e3), (1.0, 1e6)] {
            cases.push(Case::new(mapped(&mesh, |p| p * scale + Vec3::new(offset, -offset, offset))));
        }
    }
    cases
}

#[test]
fn random_viewpoints() {
    let (mut cases, mut random) = (cases(), Random::new(1));
    for view in 0..RANDOM_VIEWS {
        let count = cases.len();
        let case = &mut cases[view % count];
        let bounds = case.mesh.bounds().unwrap();
        let reach = [0.7, 1.5, 6.0, 1e4][view / count % 4] * bounds.radius as f32;
        let eye = bounds.center.as_vec3() + random.vector().as_vec3() * reach;
        assert_eq!(case.differing(eye), 0, "view {view}: eye {eye}");
    }
}

#[test]
fn hard_viewpoints() {
    let (mut cases, mut random) = (cases(), Random::new(1));
    for view in 0..HARD_VIEWS {
        let count = cases.len();
        let case = &mut cases[view % count];
        let bounds = case.mesh.bounds().unwrap();
        let eye = match view / count % 5 {
            0..=3 => hard_eye(&case.mesh, &mut random),
            _ => (bounds.center + random.vector() * (0.01 * bounds.radius)).as_vec3(),
        };
        assert_eq!(case.differing(eye), 0, "view {view}: eye {eye}");
    }
}

/// The integers notice an eye moved by one bit across a face, so the tests above can fail.
#[test]
fn integers_distinguish_neighbouring_floats() {
    let mut case = Case::new(builtin("cube"));
    let top = case.mesh.bounds().unwrap().max.y as f32;
    let eye = |y: f32| Vec3::new(0.1, y, 0.2);
    let above = f32::from_bits(top.to_bits() + 1);
    assert_eq!(case.differing(eye(top)) + case.differing(eye(above)), 0);
    let edges = |y| case.exact.silhouette_edges(&seen_from(eye(y)));
    assert_ne!(edges(top), edges(above));
    assert_eq!(look(&case.mesh, &seen_from(eye(above))).edges, edges(above));
}
