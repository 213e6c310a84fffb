//! [`EdgeMesh`]: what the method says of itself, its preparation, and the edges that it extracts.

use crate::builder;
use crate::edge_record::{EdgeRecord, MOST_ELEMENTS, OfBackFaces};
use crate::options::{ArithmeticChoice, BoundariesChoice, EdgeMeshOptions, PathChoice};
use silhouette_core::inside_out::part_volumes;
use silhouette_core::method::{ExtractionStats, PrepareError, Source};
use silhouette_core::prepared::Artefact;
use silhouette_core::silhouette::is_silhouette_edge;
use silhouette_core::{
    ExtractsEdges, FaceFacings, Method, MethodGuide, MethodInfo, MethodOptions, PreparedMesh, Progress,
    SilhouetteEdges, Topology, TriangleMesh, Viewpoint,
};
use std::sync::Arc;

/// Bytes per edge of the article: four vertices of 40 bytes and, here, two triangles of 32-bit indices.
const AS_PRINTED_BYTES: f64 = 4.0 * 40.0 + 6.0 * 4.0;

/// The mesh has more faces or vertices than records can number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("{faces} faces and {vertices} vertices; an edge mesh numbers at most {MOST_ELEMENTS} of each")]
pub struct TooManyElements {
    /// Faces of the mesh.
    pub faces: usize,
    /// Vertices of the mesh.
    pub vertices: usize,
}

/// Zink's edge mesh of a mesh. See the [crate](crate).
///
/// Extraction: O(F + E) per view, F bits of scratch; a call allocates nothing once its memory has grown.
#[derive(Debug)]
pub struct EdgeMesh {
    mesh: Arc<TriangleMesh>,
    topology: Arc<Topology>,
    options: EdgeMeshOptions,
    records: Arc<[EdgeRecord]>,
    features: usize,
    is_closed: bool,
    is_outward: bool,
    facings: FaceFacings,
    #[cfg(feature = "gpu")]
    pub(crate) on_devices: crate::edge_buffers::OnDevices,
}

impl Method for EdgeMesh {
    type Options = EdgeMeshOptions;

    const INFO: MethodInfo = MethodInfo {
        name: "edge-mesh",
        summary: "Draws silhouettes, ridges and valleys from one precomputed list of edges, of which a compute or vertex \
                  stage leaves out what is not drawn.",
        source: Source { authors: "Jason Zink", title: "Fast Silhouettes", venue: "GameDev.net", year: 2006 },
        exact: true,
        needs: &[Topology::NAME],
        options: EdgeMeshOptions::SPECS,
        guide: MethodGuide {
            origin: "Zink's edge mesh, right in pixels and exact at rest",
            yields: "ink; edges",
            accuracy: "all edges and no others while the mesh is at rest",
            cost: "O(F) bits on the processor or O(F) on the adapter, O(E) on the adapter, lines as S",
            memory: "16 bytes per edge, 4 to 11 more for lists and normals (the article: 160)",
            choose_when: "a game draws the same mesh in every frame: static, skinned or instanced, with ridges and \
                          valleys",
            limits: "wide lines have the depth of their edge and may float before a surface that curves away; a \
                     moving mesh is judged in 32 bits; translucent lines darken each other where they overlap",
        },
        published: &[],
    };

    /// O(E) beyond the topology, parallel.
    fn prepare(
        mesh: &Arc<PreparedMesh>,
        options: &EdgeMeshOptions,
        progress: &dyn Progress,
    ) -> Result<Self, PrepareError> {
        options.validate()?;
        let (faces, vertices) = (mesh.mesh().face_count(), mesh.mesh().vertex_count());
        if faces.max(vertices) > MOST_ELEMENTS {
            return Err(PrepareError::Mesh(Box::new(TooManyElements { faces, vertices })));
        }
        let topology = mesh.artefact::<Topology>(Self::INFO.name, progress)?;
        progress.check()?;
        let built = builder::build(mesh, &topology, options);
        progress.check()?;
        let is_outward = built.is_closed && part_volumes(mesh.mesh(), &topology).iter().all(|&volume| volume > 0.0);
        Ok(Self {
            mesh: Arc::clone(mesh.mesh()),
            topology,
            options: *options,
            records: built.records.into(),
            features: built.features,
            is_closed: built.is_closed,
            is_outward,
            facings: FaceFacings::default(),
            #[cfg(feature = "gpu")]
            on_devices: crate::edge_buffers::OnDevices::default(),
        })
    }

    fn bytes(&self) -> usize {
        size_of_val(&self.records[..]) + self.facings.bytes()
    }
}

impl EdgeMesh {
    /// The mesh it was prepared for.
    pub fn mesh(&self) -> &Arc<TriangleMesh> {
        &self.mesh
    }

    /// Its options.
    pub fn options(&self) -> &EdgeMeshOptions {
        &self.options
    }

    /// The records: [features](Self::feature_count) first, either part in the order of edge ids; with `path=vertex-stage` the others
    /// along a curve through space.
    pub fn records(&self) -> &Arc<[EdgeRecord]> {
        &self.records
    }

    /// How many records are ridges, valleys or creases at rest.
    pub fn feature_count(&self) -> usize {
        self.features
    }

    /// Bytes on the device per edge of a renderer with these options, the mesh's own positions and triangles left out: the record,
    /// its places in the lists of what is drawn, and its share of the facing and the normal of each face. The article's vertices take
    /// 160, and indices here 24 more.
    /// A mesh without edges has 0.
    pub fn bytes_per_edge(&self) -> f64 {
        if self.options.arithmetic == ArithmeticChoice::AsPrinted {
            return AS_PRINTED_BYTES;
        }
        let edges = self.records.len() as f64;
        if edges == 0.0 {
            return 0.0;
        }
        let by_angle = self.options.draws_by_angle();
        let listed = self.options.path == PathChoice::Compacted;
        let features = if by_angle { edges } else { self.features as f64 };
        let lists = if listed { 4.0 * (edges + features) } else { 0.0 };
        let faces = self.mesh.face_count() as f64 * (0.125 + if by_angle { 4.0 } else { 0.0 });
        size_of::<EdgeRecord>() as f64 + (lists + faces) / edges
    }

    /// Whether every edge has two faces that run along it in opposite directions.
    pub fn is_closed(&self) -> bool {
        self.is_closed
    }

    /// Whether, besides, each part of the mesh encloses a volume above 0 at rest, so that its faces point outwards.
    pub fn is_outward(&self) -> bool {
        self.is_outward
    }

    /// What is drawn of back faces in a view that hides them all, or does not.
    pub fn of_back_faces(&self, hides_them: bool) -> OfBackFaces {
        OfBackFaces { boundaries: self.options.boundaries == BoundariesChoice::All, features: !hides_them }
    }
}

impl ExtractsEdges for EdgeMesh {
    fn extract_edges(&mut self, viewpoint: &Viewpoint, out: &mut SilhouetteEdges) -> ExtractionStats {
        let exact_fallbacks = self.facings.classify(&self.mesh, viewpoint);
        let edges = self.topology.edges().ids();
        out.refill_ascending(edges.filter(|&edge| is_silhouette_edge(&self.topology, &self.facings, edge)));
        ExtractionStats {
            faces_tested: self.mesh.face_count() as u64,
            edges_tested: self.topology.edge_count() as u64,
            exact_fallbacks,
            ..ExtractionStats::default()
        }
    }
}
