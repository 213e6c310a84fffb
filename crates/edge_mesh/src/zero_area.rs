//! [`FacingSource`]: which face lends its facing to a face without area.
//!
//! A face without area is never front, so that inside of the front region each of its edges would be drawn. It takes the facing of
//! the face across its longest edge instead, as if it were collapsed into that edge: a sliver that closes a T-junction then
//! draws nothing, and silhouettes stay closed. A face with no neighbour that has an area keeps its own facing.

use rayon::prelude::*;
use silhouette_core::glam::Vec3;
use silhouette_core::inspect::has_zero_area;
use silhouette_core::{FaceId, HalfEdgeId, Topology, TriangleMesh};
use std::collections::HashMap;

/// For each face without area, the half-edge of the face that lends it its facing.
#[derive(Debug, Default)]
pub(crate) struct FacingSource {
    lenders: HashMap<FaceId, HalfEdgeId>,
}

/// What is known of a face without area while the chains of such faces are followed.
#[derive(Clone, Copy, PartialEq)]
enum Lender {
    Unknown,
    Followed,
    Found(Option<HalfEdgeId>),
}

impl FacingSource {
    /// O(F) for a mesh; the chains of faces without area are followed in time linear in their length.
    pub fn new(mesh: &TriangleMesh, topology: &Topology) -> Self {
        let faces = (0..mesh.face_count()).into_par_iter().map(FaceId::from_usize);
        let flat: Vec<FaceId> = faces.filter(|&face| has_zero_area(mesh.corners(face))).collect();
        let mut known: HashMap<FaceId, Lender> = flat.iter().map(|&face| (face, Lender::Unknown)).collect();
        let mut chain = Vec::new();
        for &start in &flat {
            let mut face = start;
            let lender = loop {
                match known.get(&face) {
                    Some(Lender::Found(lender)) => break *lender,
                    // A circle of faces without area.
                    Some(Lender::Followed) => break None,
                    _ => {}
                }
                known.insert(face, Lender::Followed);
                chain.push(face);
                let [longest, ..] = sides_by_length(mesh, face);
                let across = topology.half_edges(topology.edge_of(longest)).iter().copied();
                let others = || across.clone().filter(|other| other.face() != face);
                if let Some(real) = others().find(|other| !known.contains_key(&other.face())) {
                    break Some(real);
                }
                let Some(next) = others().next() else { break None };
                face = next.face();
            };
            for face in chain.drain(..) {
                let own = || {
                    sides_by_length(mesh, face)
                        .into_iter()
                        .flat_map(|side| topology.half_edges(topology.edge_of(side)).iter().copied())
                        .find(|other| !known.contains_key(&other.face()))
                };
                let lender = lender.or_else(own);
                known.insert(face, Lender::Found(lender));
            }
        }
        let found = known.into_iter().filter_map(|(face, lender)| match lender {
            Lender::Found(Some(half_edge)) => Some((face, half_edge)),
            _ => None,
        });
        Self { lenders: found.collect() }
    }

    /// The half-edge of the face that lends `face` its facing; `None` for a face that keeps its own.
    pub fn lender(&self, face: FaceId) -> Option<HalfEdgeId> {
        if self.lenders.is_empty() { None } else { self.lenders.get(&face).copied() }
    }

    /// The face whose facing counts for `face`.
    pub fn of(&self, face: FaceId) -> FaceId {
        self.lender(face).map_or(face, HalfEdgeId::face)
    }
}

/// The half-edges of a face, longest first.
fn sides_by_length(mesh: &TriangleMesh, face: FaceId) -> [HalfEdgeId; 3] {
    let corners = mesh.corners(face).map(Vec3::as_dvec3);
    let length = |slot: usize| corners[slot].distance_squared(corners[(slot + 1) % 3]);
    let mut slots = [0, 1, 2];
    slots.sort_by(|&a, &b| length(b).total_cmp(&length(a)));
    slots.map(|slot| HalfEdgeId::of(face, slot as u32))
}
