//! A cubic over each edge of a mesh, from which curved patches are made: the sides of PN triangles, watertight at feature edges.
//!
//! Vlachos, Peters, Boyd and Mitchell, "Curved PN triangles", I3D 2001: the tangent at an end is the edge less its
//! part along the normal there. Departures:
//!
//! 1. Where the faces at an edge have normals of their own, the paper's sides differ and the surface cracks. Here both faces have
//!    one side, whose tangents lie in the planes of both normals, as in McDonald and Kilgard, "Crack-free point-normal triangles
//!    using adjacent edge normals" (2010).
//! 2. An edge of three and more faces stays straight.

use crate::hermite::Hermite;
use crate::shading_mesh::ShadingMesh;
use rayon::prelude::*;
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::id::PerEdge;
use silhouette_core::{EdgeId, HalfEdgeId};

/// Normals whose planes make an angle with a sine below this have no line of intersection to speak of.
const LEAST_SINE: f64 = 0.01;

/// Fewest edges per task: about 0.3 ms of work.
const EDGES_PER_TASK: usize = 4096;

/// The side over each edge, from its lower to its higher vertex. No control point is farther from the edge than a third of its
/// length. O(E), parallel.
pub fn side_curves(mesh: &ShadingMesh) -> PerEdge<Hermite> {
    let edges = (0..mesh.topology().edge_count()).into_par_iter().with_min_len(EDGES_PER_TASK).map(EdgeId::from_usize);
    PerEdge::from(edges.map(|edge| side_curve(mesh, edge)).collect::<Vec<_>>())
}

fn side_curve(mesh: &ShadingMesh, edge: EdgeId) -> Hermite {
    let ends = mesh.topology().end_points(edge).map(|vertex| mesh.mesh().positions()[vertex.index()].as_dvec3());
    let chord = ends[1] - ends[0];
    let normals = |half_edge: &HalfEdgeId| {
        Side::of(mesh, *half_edge).corners_ascending().map(|corner| mesh.normals()[corner as usize])
    };
    let tangents = match mesh.topology().half_edges(edge) {
        [only] => normals(only).map(|normal| in_plane(chord, normal)),
        [first, second] => {
            let (a, b) = (normals(first), normals(second));
            [0, 1].map(|end| in_both_planes(chord, a[end], b[end]))
        }
        _ => [chord; 2],
    };
    Hermite { ends, tangents }
}

/// A side of a face.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Side {
    /// Slots in the face where it begins and ends.
    pub(crate) slots: [usize; 2],
    /// Shading vertices there.
    pub(crate) corners: [u32; 2],
    /// Whether it runs from the edge's lower vertex to its higher one.
    pub(crate) ascends: bool,
}

impl Side {
    pub(crate) fn of(mesh: &ShadingMesh, half_edge: HalfEdgeId) -> Self {
        let slot = half_edge.slot() as usize;
        let slots = [slot, (slot + 1) % 3];
        let face = half_edge.face().index();
        let [start, end] = slots.map(|slot| mesh.mesh().triangles()[face][slot]);
        Self { slots, corners: slots.map(|slot| mesh.triangles()[face][slot]), ascends: start <= end }
    }

    /// Shading vertices at the edge's lower and higher vertex.
    pub(crate) fn corners_ascending(&self) -> [u32; 2] {
        self.ascending(self.corners)
    }

    /// What belongs to the begin and the end of the side, for the lower and the higher vertex.
    pub(crate) fn ascending<T>(&self, [start, end]: [T; 2]) -> [T; 2] {
        if self.ascends { [start, end] } else { [end, start] }
    }
}

fn in_plane(chord: DVec3, normal: Vec3) -> DVec3 {
    let normal = normal.as_dvec3();
    chord - chord.dot(normal) * normal
}

/// The part of a chord along the line in which the planes of two unit normals meet.
fn in_both_planes(chord: DVec3, a: Vec3, b: Vec3) -> DVec3 {
    let line = a.as_dvec3().cross(b.as_dvec3());
    if line.length() < LEAST_SINE {
        return in_plane(chord, a);
    }
    chord.project_onto(line)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shading_normals::NormalWeights;
    use silhouette_core::{NoProgress, PreparedMesh};
    use silhouette_testing::builtin;

    fn curves(name: &str) -> (ShadingMesh, PerEdge<Hermite>) {
        let mesh = ShadingMesh::new(&PreparedMesh::new(builtin(name)), 75.0, NormalWeights::Area, "test", &NoProgress)
            .unwrap();
        let curves = side_curves(&mesh);
        (mesh, curves)
    }

    #[test]
    fn sides_of_a_sphere_bulge_towards_it() {
        let (_, curves) = curves("icosphere:1");
        for (edge, curve) in curves.iter() {
            let [chord, side] = [0.5 * (curve.ends[0] + curve.ends[1]), curve.point(0.5)].map(DVec3::length);
            assert!((side - 1.0).abs() < 0.1 * (1.0 - chord), "{edge}: {chord} {side}");
        }
    }

    #[test]
    fn tangents_at_feature_edges_lie_in_the_planes_of_both_sides() {
        let (mesh, curves) = curves("cylinder");
        let mut curved = 0;
        for (edge, curve) in curves.iter().filter(|(edge, _)| mesh.features()[*edge]) {
            let chord = curve.ends[1] - curve.ends[0];
            for half_edge in mesh.topology().half_edges(edge) {
                let corners = Side::of(&mesh, *half_edge).corners_ascending();
                for (corner, tangent) in corners.into_iter().zip(curve.tangents) {
                    let normal = mesh.normals()[corner as usize].as_dvec3();
                    assert!(tangent.dot(normal).abs() < 1e-6 && tangent.dot(chord) > 0.0);
                }
            }
            curved += usize::from(curve.point(0.5).distance(0.5 * (curve.ends[0] + curve.ends[1])) > 1e-4);
        }
        assert!(curved > 8, "{curved}");
        let (_, straight) = self::curves("cube");
        for (_, curve) in straight.iter() {
            assert!(curve.point(0.3).distance(curve.ends[0].lerp(curve.ends[1], 0.3)) < 1e-6);
        }
    }
}
