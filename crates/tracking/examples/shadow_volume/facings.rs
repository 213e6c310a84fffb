//! [`FollowedFacings`]: which faces face the light, from what did before and the silhouette loops of both lights.
//!
//! Only faces between the old loops and the new ones turn. A set of faces that turn, connected through edges, ends at
//! edges that are silhouette for one of the lights, or holds one; otherwise it would be a closed surface that is all
//! front for one light and all back for the other. That cannot be: the sum of `((v1 - v0) x (v2 - v0)) . (light - v0)`
//! over a closed surface does not depend on the light (nor, of `. toward_light`, on a directional one: it is 0). So
//! spreading from both sides of all old and new loops, through faces that turned, reaches every one of them, however far
//! the light went in between.
//!
//! 1. Both sides of a new loop are known without looking: front on its left, back across.
//! 2. Both sides of an old loop that are not known by then are judged.
//! 3. The neighbours of each face that turned are judged, until none turns.

use silhouette_core::facing::{Facing, judge};
use silhouette_core::{FaceId, HalfEdgeId, SilhouetteLoops, TriangleMesh, Viewpoint};
use silhouette_tracking::ConnectivityTable;

/// Facings that are kept from light to light. Loops that are missing leave faces as they were, until a later loop
/// passes.
#[derive(Debug, Clone, Default)]
pub struct FollowedFacings {
    facings: Vec<Facing>,
    /// The frame in which the facing of each face was last found, counted from 1.
    found: Vec<u32>,
    frame: u32,
    old_loops: Vec<HalfEdgeId>,
    /// Faces that turned and whose neighbours have not been looked at.
    turned: Vec<FaceId>,
}

impl FollowedFacings {
    /// One per face, of the last light.
    pub fn as_slice(&self) -> &[Facing] {
        &self.facings
    }

    /// Goes on to another light, of which `loops` are all the silhouette loops. O(old and new silhouette + faces that
    /// turned); O(F) for the first light. Allocates nothing once memory has grown.
    pub fn follow(
        &mut self,
        mesh: &TriangleMesh,
        table: &ConnectivityTable,
        light: &Viewpoint,
        loops: &SilhouetteLoops,
    ) {
        if self.facings.len() != mesh.face_count() || self.frame == u32::MAX {
            self.begin(mesh, light);
        } else {
            self.frame += 1;
            for &half_edge in loops.half_edges() {
                self.set(half_edge.face(), Facing::Front);
                if let Some(twin) = table.twin(half_edge) {
                    self.set(twin.face(), Facing::Back);
                }
            }
            for index in 0..self.old_loops.len() {
                let half_edge = self.old_loops[index];
                self.look(mesh, light, half_edge.face());
                if let Some(twin) = table.twin(half_edge) {
                    self.look(mesh, light, twin.face());
                }
            }
            while let Some(face) = self.turned.pop() {
                for twin in (0..3).filter_map(|slot| table.twin(HalfEdgeId::of(face, slot))) {
                    self.look(mesh, light, twin.face());
                }
            }
        }
        self.old_loops.clear();
        self.old_loops.extend_from_slice(loops.half_edges());
    }

    /// Judges every face.
    fn begin(&mut self, mesh: &TriangleMesh, light: &Viewpoint) {
        let faces = (0..mesh.face_count()).map(FaceId::from_usize);
        self.facings.clear();
        self.facings.extend(faces.map(|face| judge(mesh.corners(face), light).facing));
        self.found.clear();
        self.found.resize(mesh.face_count(), 0);
        self.frame = 0;
    }

    /// Judges a face unless it is known in this frame.
    fn look(&mut self, mesh: &TriangleMesh, light: &Viewpoint, face: FaceId) {
        if self.found[face.index()] != self.frame {
            self.set(face, judge(mesh.corners(face), light).facing);
        }
    }

    fn set(&mut self, face: FaceId, facing: Facing) {
        self.found[face.index()] = self.frame;
        if std::mem::replace(&mut self.facings[face.index()], facing) != facing {
            self.turned.push(face);
        }
    }
}
