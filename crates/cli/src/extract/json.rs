//! An extraction as JSON.

use super::Extraction;
use crate::failure::Failure;
use glam::{DVec3, Vec3};
use serde::Serialize;
use silhouette_compare::registry::FoundEdges;
use silhouette_core::curves::{CurveChain, CurveKind, CurveSource, SmoothPiece};
use silhouette_core::method::ExtractionStats;
use silhouette_core::{FaceId, TriangleMesh, VertexId, Viewpoint};

#[derive(Serialize)]
struct Document<'a> {
    method: &'static str,
    mesh: Counts,
    viewpoint: PlacedViewpoint,
    #[serde(flatten)]
    edges: Option<&'a FoundEdges>,
    #[serde(skip_serializing_if = "Option::is_none")]
    curves: Option<Vec<Curve>>,
    stats: ExtractionStats,
}

/// What facing depends on, in the coordinates of the mesh's file.
#[derive(Serialize)]
#[serde(rename_all = "snake_case")]
enum PlacedViewpoint {
    Perspective { eye: DVec3 },
    Orthographic { toward_viewer: Vec3 },
}

impl PlacedViewpoint {
    fn new(viewpoint: Viewpoint, mesh: &TriangleMesh) -> Self {
        match viewpoint {
            Viewpoint::Perspective { eye } => Self::Perspective { eye: mesh.in_file(eye) },
            Viewpoint::Orthographic { toward_viewer } => Self::Orthographic { toward_viewer },
        }
    }
}

#[derive(Serialize)]
struct Counts {
    vertices: usize,
    triangles: usize,
}

#[derive(Serialize)]
struct Curve {
    closed: bool,
    pieces: Vec<Piece>,
}

#[derive(Serialize)]
struct Piece {
    kind: CurveKind,
    source: PieceSource,
    control: [DVec3; 4],
}

/// What a piece stands for, in the ids of the mesh.
#[derive(Serialize)]
#[serde(rename_all = "kebab-case")]
enum PieceSource {
    Face(FaceId),
    Edge([VertexId; 2]),
}

/// The document, with a line feed at its end.
pub fn write(found: &Extraction) -> Result<Vec<u8>, Failure> {
    let curves_of = |chain: CurveChain<'_>| curve(&chain, found);
    let document = Document {
        method: found.method,
        mesh: Counts { vertices: found.mesh.vertex_count(), triangles: found.mesh.face_count() },
        viewpoint: PlacedViewpoint::new(found.viewpoint, &found.mesh),
        edges: found.edges.as_ref(),
        curves: found.curves.as_ref().map(|curves| curves.iter().map(curves_of).collect()),
        stats: found.stats,
    };
    let mut bytes = serde_json::to_vec(&document).map_err(Failure::run)?;
    bytes.push(b'\n');
    Ok(bytes)
}

fn curve(chain: &CurveChain<'_>, found: &Extraction) -> Curve {
    let piece = |&SmoothPiece { control, kind, source }: &SmoothPiece| {
        let source = match source {
            CurveSource::Face(face) => PieceSource::Face(face),
            CurveSource::Edge(edge) => PieceSource::Edge(found.topology.end_points(edge)),
        };
        Piece { kind, source, control: control.map(|point| found.mesh.in_file(point)) }
    };
    Curve { closed: chain.closed, pieces: chain.pieces.iter().map(piece).collect() }
}
