//! [`Tables`]: what the stages know of a mesh's connectivity. Twin: `shaders/smoothing/frame.wgsl`.

use crate::perturbation::vertex_neighbours;
use crate::shading_mesh::ShadingMesh;
use crate::smoothing::Smoothing;
use silhouette_core::id::{HalfEdgeId, VertexId};
use silhouette_core::topology::Twin;

/// No vertex, no feature edge.
const NONE: u32 = u32::MAX;

/// How many of each there are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Counts {
    /// Shading vertices.
    pub groups: u32,
    pub vertices: u32,
    pub faces: u32,
    /// Places at which a silhouette point may lie: edges, and half-edges on feature edges.
    pub points: u32,
    /// Feature edges.
    pub features: u32,
    /// Half-edges on feature edges.
    pub feature_points: u32,
}

/// Where each part begins, in words.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct TableOffsets {
    pub sides: u32,
    pub owners: u32,
    pub point_features: u32,
    pub group_vertices: u32,
    pub turned_groups: u32,
    pub first_corners: u32,
    pub group_corners: u32,
    pub first_groups: u32,
    pub first_neighbours: u32,
    pub neighbours: u32,
    pub first_feature_points: u32,
    pub feature_points: u32,
    pub feature_ends: u32,
}

/// Tables of a mesh, one after another.
#[derive(Debug, Clone)]
pub(crate) struct Tables {
    pub words: Vec<u32>,
    pub at: TableOffsets,
    pub counts: Counts,
}

impl Tables {
    /// Lists what the stages read. O(V + E).
    pub fn new(method: &Smoothing) -> Self {
        let mesh = method.shading_mesh();
        let points = Points::new(method);
        let corners = Corners::new(mesh);
        let (first_neighbours, neighbours) = vertex_neighbours(mesh);
        let (first_feature_points, feature_points) = points.of_features(method);
        let counts = Counts {
            groups: mesh.vertices().len() as u32,
            vertices: mesh.mesh().vertex_count() as u32,
            faces: mesh.triangles().len() as u32,
            points: points.owners.len() as u32,
            features: method.features().edges().len() as u32,
            feature_points: feature_points.len() as u32,
        };
        let mut words = mesh.triangles().as_flattened().to_vec();
        let mut push = |part: &[u32]| {
            let at = words.len() as u32;
            words.extend_from_slice(part);
            at
        };
        let at = TableOffsets {
            sides: push(&points.sides),
            owners: push(&points.owners),
            point_features: push(&points.features),
            group_vertices: push(mesh.vertices()),
            turned_groups: push(&turned_groups(mesh)),
            first_corners: push(&corners.first),
            group_corners: push(&corners.corners),
            first_groups: push(&first_groups(mesh)),
            first_neighbours: push(&first_neighbours),
            neighbours: push(&neighbours),
            first_feature_points: push(&first_feature_points),
            feature_points: push(&feature_points),
            feature_ends: push(feature_ends(method).as_flattened()),
        };
        Self { words, at, counts }
    }
}

/// Where silhouette points may lie.
struct Points {
    /// For each half-edge four times its point, plus 2 on a feature edge, plus 1 if it runs from the lower vertex to the higher.
    sides: Vec<u32>,
    /// For each point, the first of its half-edges.
    owners: Vec<u32>,
    /// For each point, its feature edge or [`NONE`].
    features: Vec<u32>,
}

impl Points {
    /// Two faces of one group share the point of their side; on a feature edge each face has its own.
    fn new(method: &Smoothing) -> Self {
        let (mesh, topology) = (method.shading_mesh(), method.shading_mesh().topology());
        let mut points = Self { sides: Vec::new(), owners: Vec::new(), features: Vec::new() };
        for index in 0..topology.half_edge_count() as u32 {
            let half_edge = HalfEdgeId::new(index);
            let feature = method.features().index_of(topology.edge_of(half_edge));
            let point = match (feature, topology.twin(half_edge)) {
                (None, Twin::HalfEdge(twin)) if twin < half_edge => points.sides[twin.index()] / 4,
                _ => {
                    points.owners.push(index);
                    points.features.push(feature.map_or(NONE, |feature| feature as u32));
                    points.owners.len() as u32 - 1
                }
            };
            let corners = mesh.mesh().triangles()[half_edge.face().index()];
            let ends = [half_edge.slot(), half_edge.next_in_face().slot()].map(|slot| corners[slot as usize]);
            points.sides.push(4 * point + 2 * u32::from(feature.is_some()) + u32::from(ends[0] <= ends[1]));
        }
        points
    }

    /// The points of each feature edge, and where those of each begin.
    fn of_features(&self, method: &Smoothing) -> (Vec<u32>, Vec<u32>) {
        let (mut first, mut points) = (vec![0], Vec::new());
        for &edge in method.features().edges() {
            let half_edges = method.shading_mesh().topology().half_edges(edge);
            points.extend(half_edges.iter().map(|half_edge| self.sides[half_edge.index()] / 4));
            first.push(points.len() as u32);
        }
        (first, points)
    }
}

/// The corners of each shading vertex, ascending, and where those of each begin.
struct Corners {
    first: Vec<u32>,
    corners: Vec<u32>,
}

impl Corners {
    fn new(mesh: &ShadingMesh) -> Self {
        let of_corner = mesh.triangles().as_flattened();
        let mut first = vec![0; mesh.vertices().len() + 1];
        of_corner.iter().for_each(|&group| first[group as usize + 1] += 1);
        (1..first.len()).for_each(|group| first[group] += first[group - 1]);
        let mut next = first.clone();
        let mut corners = vec![0; of_corner.len()];
        for (corner, &group) in of_corner.iter().enumerate() {
            corners[next[group as usize] as usize] = corner as u32;
            next[group as usize] += 1;
        }
        Self { first, corners }
    }
}

/// Whether each shading vertex belongs to faces that are wound inside out, which all of its faces are or none.
fn turned_groups(mesh: &ShadingMesh) -> Vec<u32> {
    let mut turned = vec![0; mesh.vertices().len()];
    for (corners, is_turned) in mesh.triangles().iter().zip(mesh.is_turned()) {
        corners.iter().for_each(|&group| turned[group as usize] = u32::from(*is_turned));
    }
    turned
}

/// The first shading vertex of each vertex, and one beyond the last.
fn first_groups(mesh: &ShadingMesh) -> Vec<u32> {
    let firsts = (0..mesh.mesh().vertex_count() as u32).map(|vertex| mesh.shading_vertices(vertex).start as u32);
    firsts.chain([mesh.vertices().len() as u32]).collect()
}

/// Of each feature edge its lower and its higher vertex, and the vertices before and after it on its polyline or [`NONE`].
fn feature_ends(method: &Smoothing) -> Vec<[u32; 4]> {
    let topology = method.shading_mesh().topology();
    let ends = |&edge| {
        let [lower, higher] = topology.end_points(edge).map(VertexId::get);
        [lower, higher, NONE, NONE]
    };
    let mut all: Vec<_> = method.features().edges().iter().map(ends).collect();
    for polyline in method.polylines() {
        let count = polyline.vertices.len();
        let vertex = |index: usize| polyline.vertices[index % count].get();
        for (i, &edge) in polyline.edges.iter().enumerate() {
            let Some(index) = method.features().index_of(edge) else { continue };
            let before = if polyline.closed || i > 0 { vertex(i + count - 1) } else { NONE };
            let after = if polyline.closed || i + 2 < count { vertex(i + 2) } else { NONE };
            let is_forward = all[index][0] == vertex(i);
            all[index][2..].copy_from_slice(&if is_forward { [before, after] } else { [after, before] });
        }
    }
    all
}
