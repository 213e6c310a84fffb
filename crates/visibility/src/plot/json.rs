//! Lines as JSON: everything that was found, in pixels and in space.

use super::place::Placement;
use crate::chains::{Chain, SegmentSource};
use crate::lines::Lines;
use serde::Serialize;
use serde::ser::{SerializeSeq, Serializer};
use silhouette_core::glam::{DVec2, DVec3, Vec3};
use silhouette_core::origin::in_file;
use silhouette_core::view::{Camera, Projection};
use silhouette_core::{EdgeId, VertexId};
use std::io::{self, Write};

/// Says between which vertices an edge runs, lower one first, by the numbers that the document is to have.
pub type EndPoints<'a> = dyn Fn(EdgeId) -> [VertexId; 2] + 'a;

#[derive(Serialize)]
struct Document<'a> {
    camera: PlacedCamera,
    size: [u32; 2],
    page: &'a Placement,
    chains: AllChains<'a>,
    outline: &'a [Vec<DVec2>],
}

/// A camera in the coordinates of the file.
#[derive(Serialize)]
struct PlacedCamera {
    eye: DVec3,
    target: DVec3,
    up: Vec3,
    projection: Projection,
    size: [u32; 2],
}

impl PlacedCamera {
    fn new(camera: &Camera, origin: DVec3) -> Self {
        Self {
            eye: in_file(origin, camera.eye()),
            target: in_file(origin, camera.target()),
            up: camera.up(),
            projection: camera.projection(),
            size: camera.size(),
        }
    }
}

/// The chains, made one by one while they are written.
struct AllChains<'a> {
    lines: &'a Lines,
    end_points: &'a EndPoints<'a>,
}

#[derive(Serialize)]
struct ChainDocument<'a> {
    kind: &'static str,
    visible: bool,
    invisibility: u32,
    object: u32,
    closed: bool,
    edges: Vec<[VertexId; 2]>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    curves: Vec<u32>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    intersections: Vec<u32>,
    points: Vec<DVec3>,
    pixels: &'a [DVec2],
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    handles: &'a [[DVec2; 2]],
}

impl Serialize for AllChains<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut chains = serializer.serialize_seq(Some(self.lines.chains.len()))?;
        for chain in self.lines.chains.iter() {
            chains.serialize_element(&document(&chain, self.lines.origin, self.end_points))?;
        }
        chains.end()
    }
}

fn document<'a>(chain: &Chain<'a>, origin: DVec3, end_points: &EndPoints<'_>) -> ChainDocument<'a> {
    let (mut edges, mut curves, mut intersections) = (Vec::new(), Vec::new(), Vec::new());
    for source in chain.sources {
        match *source {
            SegmentSource::Edge(edge) => edges.push(end_points(edge)),
            SegmentSource::Curve(curve) => curves.push(curve),
            SegmentSource::Intersection(intersection) => intersections.push(intersection),
        }
    }
    ChainDocument {
        kind: chain.style.kind.name(),
        visible: chain.style.invisibility == 0,
        invisibility: chain.style.invisibility,
        object: chain.style.object,
        closed: chain.closed,
        edges,
        curves,
        intersections,
        points: chain.points.iter().map(|&point| origin + point).collect(),
        pixels: chain.pixels,
        handles: chain.handles,
    }
}

/// Writes one line of JSON:
///
/// `{"camera", "size": [w,h], "page": {"unit", "width", "height", "scale", "offset": [x,y]}, "chains": [{"kind",
/// "visible": bool, "invisibility": n, "object": i, "closed": bool, "edges": [[a,b]...], "points": [[x,y,z]...],
/// "pixels": [[x,y]...]}...], "outline": [[[x,y]...]...]}`
///
/// Camera and points are in the coordinates of the meshes' files. Pixels have their origin at the top left and their centres at .5; `pixel * scale + offset` is the place on the page,
/// in its unit. A chain has one edge a segment, one segment fewer than points, or as many where it is closed. Chains
/// along smooth curves and intersections have no edges but `curves` or `intersections` instead, indices of what each
/// segment lies on; curves have `handles`, too, both Bezier handles of each segment in pixels. All chains that were
/// found are written, whatever is drawn of them.
///
/// # Errors
/// Those of `out`.
pub fn write_json(
    lines: &Lines,
    placement: &Placement,
    end_points: &EndPoints<'_>,
    out: &mut dyn Write,
) -> io::Result<()> {
    let document = Document {
        camera: PlacedCamera::new(&lines.camera, lines.origin),
        size: lines.camera.size(),
        page: placement,
        chains: AllChains { lines, end_points },
        outline: &lines.outline.rings,
    };
    serde_json::to_writer(&mut *out, &document)?;
    out.write_all(b"\n")
}
