//! Step 1, preparation: [`EdgeRecord`]s of all edges of a mesh.

use crate::edge_record::{Bend, EdgeRecord, Feature};
use crate::options::{CreasesChoice, EdgeMeshOptions, PathChoice};
use crate::zero_area::FacingSource;
use rayon::prelude::*;
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::loops::start_vertex;
use silhouette_core::{EdgeId, FaceId, HalfEdgeId, PreparedMesh, Topology, TriangleMesh, VertexId, morton};

/// Edges that a task takes at least: about 0.1 ms of work.
const EDGES_PER_TASK: usize = 4096;

/// The records of a mesh.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Records {
    /// Features first, in the order of edge ids; the others in that order, or along a curve through space where chunks of them are
    /// drawn or left out as a whole.
    pub records: Vec<EdgeRecord>,
    /// Number of features.
    pub features: usize,
    /// Whether every edge has two faces that run along it in opposite directions, so that between two back faces nothing shows.
    pub is_closed: bool,
}

/// Builds the records. O(E), parallel; the same for any number of threads.
pub(crate) fn build(mesh: &PreparedMesh, topology: &Topology, options: &EdgeMeshOptions) -> Records {
    let given = given_edges(mesh, topology, options);
    let builder =
        Builder { mesh: mesh.mesh(), topology, sources: FacingSource::new(mesh.mesh(), topology), given, options };
    let edges = (0..topology.edge_count()).into_par_iter().with_min_len(EDGES_PER_TASK).map(EdgeId::from_usize);
    let records: Vec<EdgeRecord> = edges.clone().flat_map_iter(|edge| builder.records_at(edge)).collect();
    let is_closed = edges.all(|edge| match topology.half_edges(edge) {
        &[a, b] => start_vertex(mesh.mesh(), a) != start_vertex(mesh.mesh(), b),
        _ => false,
    });
    let (mut records, mut others): (Vec<_>, Vec<_>) =
        records.into_iter().partition(|record| record.feature().is_some());
    let features = records.len();
    if options.path == PathChoice::VertexStage {
        others = along_curve(mesh.mesh(), &others);
    }
    records.extend(others);
    Records { records, features, is_closed }
}

/// Records in the order of a Morton curve through the middles of their edges, so that chunks of them lie close together. O(E log E).
fn along_curve(mesh: &TriangleMesh, records: &[EdgeRecord]) -> Vec<EdgeRecord> {
    let Some(bounds) = mesh.bounds() else { return Vec::new() };
    let position = |vertex: VertexId| mesh.positions()[vertex.index()].as_dvec3();
    let mut keyed: Vec<(u64, u32)> = records
        .par_iter()
        .enumerate()
        .map(|(index, record)| {
            let [a, b] = record.ends().map(position);
            (morton::place((0.5 * (a + b) - bounds.center) / bounds.radius), index as u32)
        })
        .collect();
    keyed.par_sort_unstable();
    keyed.into_iter().map(|(_, index)| records[index as usize]).collect()
}

/// The edges that the mesh's file marks as sharp, ascending; none unless they are to be drawn.
fn given_edges(mesh: &PreparedMesh, topology: &Topology, options: &EdgeMeshOptions) -> Vec<EdgeId> {
    if options.creases == CreasesChoice::None {
        return Vec::new();
    }
    let mut given: Vec<EdgeId> = mesh.feature_edges().iter().filter_map(|&[a, b]| topology.find_edge(a, b)).collect();
    given.sort_unstable();
    given
}

struct Builder<'a> {
    mesh: &'a TriangleMesh,
    topology: &'a Topology,
    sources: FacingSource,
    given: Vec<EdgeId>,
    options: &'a EdgeMeshOptions,
}

impl Builder<'_> {
    /// The records of an edge: one for each two neighbours among the faces that decide its facing, if they are not the same.
    fn records_at(&self, edge: EdgeId) -> impl Iterator<Item = EdgeRecord> {
        let half_edges = self.topology.half_edges(edge);
        let boundary = if let &[only] = half_edges { Some(self.boundary(only)) } else { None };
        // A face without area whose lender is at this edge as well adds nothing.
        let deciding = half_edges.iter().copied().filter(move |&half_edge| {
            let lender = self.sources.lender(half_edge.face());
            lender.is_none_or(|lender| self.topology.edge_of(lender) != edge)
        });
        let pairs = deciding.clone().zip(deciding.skip(1));
        let records = pairs.filter_map(move |(a, b)| self.between(edge, a, b));
        boundary.into_iter().chain(records)
    }

    fn ends(&self, half_edge: HalfEdgeId) -> [u32; 2] {
        [half_edge, half_edge.next_in_face()].map(|side| start_vertex(self.mesh, side).get())
    }

    fn boundary(&self, half_edge: HalfEdgeId) -> EdgeRecord {
        EdgeRecord::boundary(self.ends(half_edge), self.sources.of(half_edge.face()))
    }

    fn between(&self, edge: EdgeId, a: HalfEdgeId, b: HalfEdgeId) -> Option<EdgeRecord> {
        let faces = [a, b].map(|half_edge| self.sources.of(half_edge.face()));
        if faces[0] == faces[1] {
            return None;
        }
        let (ends, others) = (self.ends(a), self.ends(b));
        let same_way = ends == others;
        let record = EdgeRecord::between(ends, faces[0], faces[1], same_way);
        Some(record.with_feature(self.feature(edge, ends, faces, same_way)))
    }

    /// What an edge between two faces is drawn as.
    fn feature(&self, edge: EdgeId, ends: [u32; 2], faces: [FaceId; 2], same_way: bool) -> Option<Feature> {
        let is_given = self.given.binary_search(&edge).is_ok();
        if !is_given && !self.options.draws_by_angle() {
            return None;
        }
        let bend_deg = bend_deg(self.mesh, ends, faces, same_way)?;
        let (bend, least) = if bend_deg < 0.0 {
            (Bend::Valley, self.options.valley_angle_deg)
        } else {
            (Bend::Ridge, self.options.ridge_angle_deg)
        };
        (is_given || (least < 180.0 && bend_deg.abs() >= least)).then_some(Feature { bend, is_given })
    }
}

/// The angle between the normals of two faces at an edge in degrees, above 0 where it is convex, below where it is concave. `None`
/// where a face has no normal.
fn bend_deg(mesh: &TriangleMesh, ends: [u32; 2], faces: [FaceId; 2], same_way: bool) -> Option<f64> {
    let position = |vertex: u32| mesh.positions()[vertex as usize].as_dvec3();
    let normal = |face: FaceId| {
        let [a, b, c] = mesh.corners(face).map(Vec3::as_dvec3);
        (b - a).cross(c - a).try_normalize()
    };
    let first = normal(faces[0])?;
    // Of two faces that run the same way one has its normal inside; turned over, they bend as they do in space.
    let second = normal(faces[1])? * if same_way { -1.0 } else { 1.0 };
    let way = position(ends[1]) - position(ends[0]);
    let cross: DVec3 = first.cross(second);
    let angle_deg = cross.length().atan2(first.dot(second)).to_degrees();
    Some(if cross.dot(way) < 0.0 { -angle_deg } else { angle_deg })
}
