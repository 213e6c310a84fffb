//! [`Room`]: how many triangles and vertices a frame may take.

use crate::gpu::tables::Tables;
use crate::sampling::MAX_SEGMENTS;
use crate::smoothing::Smoothing;
use silhouette_core::FaceId;
use silhouette_core::id::HalfEdgeId;

/// How many triangles, and vertices beside those of the mesh and one per edge, a frame may take.
///
/// By default there is room for all that a small mesh may ever become. A larger mesh, whose silhouette crosses a small share of its
/// faces, has room for four times as many triangles as it has faces, and as many as are needed if each curve is drawn in one piece.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Room {
    /// Triangles.
    pub triangles: u64,
    /// Vertices.
    pub vertices: u64,
}

/// Room that every mesh has if it can use it: 65 536 triangles of 12 bytes, 32 768 vertices of 24 bytes.
const LEAST: Room = Room { triangles: 1 << 16, vertices: 1 << 15 };

impl Room {
    /// What [`SmoothingRenderer`](crate::SmoothingRenderer) takes for a mesh.
    pub fn for_mesh(method: &Smoothing) -> Self {
        let mesh = method.shading_mesh();
        let (faces, features) = (mesh.triangles().len() as u64, method.features().edges().len() as u64);
        let (least, most) = (Self::worst(method, 1), Self::worst(method, u64::from(MAX_SEGMENTS)));
        let triangles = LEAST.triangles + 4 * faces + 16 * features;
        let vertices = LEAST.vertices + 2 * faces + 24 * features;
        Self {
            triangles: triangles.max(least.triangles).min(most.triangles),
            vertices: vertices.max(least.vertices).min(most.vertices),
        }
    }

    /// What a mesh may become at most if no cubic is drawn in more than this many pieces: with one piece, in any view and within
    /// any room that is not smaller.
    pub(crate) fn worst(method: &Smoothing, pieces: u64) -> Self {
        let topology = method.shading_mesh().topology();
        // Of two cubics; one piece stands for a feature edge that is not sampled at all.
        let samples = if pieces > 1 { 2 * pieces - 1 } else { 0 };
        let bends = |edge| topology.half_edges(edge).len() as u64 + samples;
        let shared: u64 = method.features().edges().iter().map(|&edge| bends(edge)).sum();
        let mut room = Self { triangles: 0, vertices: shared };
        for face in 0..method.shading_mesh().triangles().len() {
            let sides = (0..3).map(|slot| topology.edge_of(HalfEdgeId::of(FaceId::from_usize(face), slot)));
            let features = sides.filter(|&edge| method.features().index_of(edge).is_some());
            let own: u64 = features.map(bends).sum();
            // A fan and a strip; or two fans around all that bends the sides.
            room.triangles += if own == 0 { 2 * pieces + 1 } else { 2 * pieces + own + 6 };
            room.vertices += if own == 0 { pieces - 1 } else { pieces + own + 1 };
        }
        room
    }
}

/// Vertices of a frame: shading vertices, silhouette points, and those that there is room for.
pub(crate) fn vertex_count(tables: &Tables, room: Room) -> u64 {
    u64::from(tables.counts.groups) + u64::from(tables.counts.points) + room.vertices
}
