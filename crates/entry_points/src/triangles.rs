//! [`triangles`].

use crate::bytes::Bytes;
use crate::check_message;
use silhouette_compare::registry::{Entry, Registry};
use silhouette_core::glam::Vec3;
use silhouette_core::loops::LoopWalker;
use silhouette_core::method::{OptionValues, PrepareError};
use silhouette_core::prepared::PreparedMesh;
use silhouette_core::{
    ExtractsEdges, ExtractsLoops, FaceFacings, NoProgress, SilhouetteCurves, SilhouetteEdges, SilhouetteLoops,
    Topology, TriangleMesh, Viewpoint,
};
use std::sync::Arc;

/// Most vertices, faces and viewpoints of an input.
const MOST: (usize, usize, usize) = (40, 80, 5);

/// Has every extractor and tracker of the registry find edges, loops and curves of arbitrary triangles from a few viewpoints in turn,
/// then of the same triangles over other positions.
///
/// Indices of vertices that do not exist and positions that are not finite are refused. An exact method yields the edges that follow
/// from the facings of the faces, any other method none besides; loops are made of the same edges; nothing depends on what was looked
/// at before.
pub fn triangles(bytes: &[u8]) -> bool {
    let mut bytes = Bytes::new(bytes);
    let (positions, triangles) = bytes.triangles(MOST.0, MOST.1);
    let is_valid = triangles.iter().flatten().all(|&vertex| (vertex as usize) < positions.len())
        && positions.iter().all(|position| position.is_finite());
    let mesh = match TriangleMesh::new(positions, triangles) {
        Ok(mesh) => mesh,
        Err(error) => {
            assert!(!is_valid, "{error}");
            check_message(&error.to_string());
            return false;
        }
    };
    assert!(is_valid, "a mesh is made of what is none");
    let views = bytes.below(MOST.2) + 1;
    let made = bytes.coordinates();
    let views: Vec<Viewpoint> = (0..views).map(|_| viewpoint(bytes.is_set(), bytes.vector(made))).collect();
    let moved: Vec<Vec3> = {
        let made = bytes.coordinates();
        (0..mesh.vertex_count()).map(|_| bytes.vector(made)).collect()
    };
    let prepared = Arc::new(PreparedMesh::new(mesh));
    let topology = Topology::new(prepared.mesh());
    for entry in Registry::builtin().entries() {
        check_method(entry, &prepared, &topology, &views, &moved);
    }
    true
}

/// A viewpoint there or in that direction; a usual one where the vector is none.
fn viewpoint(is_eye: bool, vector: Vec3) -> Viewpoint {
    let vector = if vector.is_finite() && vector != Vec3::ZERO { vector } else { Vec3::new(3.0, 2.0, 1.0) };
    if is_eye { Viewpoint::Perspective { eye: vector } } else { Viewpoint::Orthographic { toward_viewer: vector } }
}

fn check_method(entry: &Entry, mesh: &Arc<PreparedMesh>, topology: &Topology, views: &[Viewpoint], moved: &[Vec3]) {
    let (info, can) = (entry.info(), entry.capabilities());
    if !(can.edges || can.curves) {
        return;
    }
    let prepare = || match entry.prepare(mesh, &OptionValues::defaults(info.options), &NoProgress) {
        Ok(method) => Some(method),
        Err(PrepareError::Mesh(reason)) => {
            // Not defined for this mesh.
            check_message(&reason.to_string());
            None
        }
        Err(error) => panic!("{}: {error}", info.name),
    };
    let Some(mut method) = prepare() else { return };
    let mut check = Check { name: info.name, is_exact: info.exact, mesh: mesh.mesh(), topology };
    for view in views {
        if let Some(method) = method.edges() {
            check.edges(method, view);
        }
        match method.loops() {
            Some(method) => check.loops(method, view),
            None => {
                if let Some(method) = method.edges() {
                    check.loops_of_edges(method, view);
                }
            }
        }
        if let Some(method) = method.curves() {
            let mut curves = SilhouetteCurves::default();
            method.extract_curves(view, &mut curves);
            let is_finite = curves.pieces().iter().flat_map(|piece| piece.control).all(Vec3::is_finite);
            assert!(is_finite, "{} from {view:?}: a curve goes nowhere", info.name);
        }
    }
    if can.moving_edges
        && let Ok(mut method) = method.into_moving_edges()
        && let Ok(mesh) = TriangleMesh::new(moved.to_vec(), mesh.mesh().triangles().to_vec())
    {
        method.update_positions(moved).unwrap_or_else(|error| panic!("{}: {error}", info.name));
        check.mesh = &mesh;
        views.iter().for_each(|view| check.edges(&mut *method, view));
    }
}

struct Check<'a> {
    name: &'a str,
    is_exact: bool,
    mesh: &'a TriangleMesh,
    topology: &'a Topology,
}

impl Check<'_> {
    fn expected(&self, view: &Viewpoint) -> SilhouetteEdges {
        SilhouetteEdges::of(self.topology, &FaceFacings::new(self.mesh, view))
    }

    fn edges(&self, method: &mut dyn ExtractsEdges, view: &Viewpoint) {
        let mut found = SilhouetteEdges::default();
        method.extract_edges(view, &mut found);
        let expected = self.expected(view);
        if self.is_exact {
            assert_eq!(found, expected, "{} from {view:?}", self.name);
        } else {
            assert!(found.iter().all(|edge| expected.contains(edge)), "{} from {view:?}: {found:?}", self.name);
        }
    }

    /// The loops through the edges of a method that finds no loops, and perhaps not all edges.
    fn loops_of_edges(&self, method: &mut dyn ExtractsEdges, view: &Viewpoint) {
        let (mut found, mut loops) = (SilhouetteEdges::default(), SilhouetteLoops::default());
        method.extract_edges(view, &mut found);
        LoopWalker::default().walk(self.topology, &FaceFacings::new(self.mesh, view), &found, &mut loops);
        let expected = self.expected(view);
        let are_silhouette = loops.half_edges().iter().all(|&side| expected.contains(self.topology.edge_of(side)));
        assert!(are_silhouette, "{} from {view:?}: {loops:?}", self.name);
    }

    fn loops(&self, method: &mut dyn ExtractsLoops, view: &Viewpoint) {
        let mut loops = SilhouetteLoops::default();
        method.extract_loops(view, &mut loops);
        let mut edges: Vec<_> = loops.half_edges().iter().map(|&side| self.topology.edge_of(side)).collect();
        edges.sort_unstable();
        edges.dedup();
        let expected = self.expected(view);
        assert!(edges.iter().all(|&edge| expected.contains(edge)), "{} from {view:?}: {loops:?}", self.name);
        assert!(!self.is_exact || edges == expected.as_slice(), "{} from {view:?}: {loops:?}", self.name);
    }
}
