//! Silhouette and feature segments joined to chains, as output.

use crate::feature_polylines::FeaturePolyline;
use crate::feature_segments::FeatureSegments;
use crate::hermite::Hermite;
use crate::shading_mesh::ShadingMesh;
use crate::silhouette_segments::{SilhouetteSegment, SilhouetteSegments};
use silhouette_core::curves::{CurveKind, CurveSource, SmoothPiece};
use silhouette_core::id::HalfEdgeId;
use silhouette_core::topology::Twin;
use silhouette_core::{EdgeId, SilhouetteCurves, Topology};

/// Joins pieces to chains; scratch memory.
#[derive(Debug, Clone, Default)]
pub struct CurveWalker {
    /// Segment of each face that is a silhouette triangle in this view.
    segment_of_face: Vec<u32>,
    is_done: Vec<bool>,
    /// Parameters at which faces of one feature edge change their visibility.
    cuts: Vec<f64>,
    pieces: Vec<SmoothPiece>,
}

impl CurveWalker {
    /// Appends the silhouette segments of a view, joined across the sides that faces share; visible vertices lie on the left,
    /// seen from outside. A chain is open where it meets a feature edge or a boundary. Open chains come first, each group in
    /// the order of its first face. O(silhouette triangles).
    pub fn silhouette(&mut self, mesh: &ShadingMesh, silhouette: &SilhouetteSegments, out: &mut SilhouetteCurves) {
        let segments = silhouette.segments();
        self.segment_of_face.resize(mesh.triangles().len(), 0);
        for (index, segment) in segments.iter().enumerate() {
            self.segment_of_face[segment.triangle.face.index()] = index as u32;
        }
        self.is_done.clear();
        self.is_done.resize(segments.len(), false);
        let across = |half_edge: HalfEdgeId| match mesh.topology().twin(half_edge) {
            Twin::HalfEdge(twin) if !mesh.features()[mesh.topology().edge_of(half_edge)] => Some(twin.face()),
            _ => None,
        };
        for only_open in [true, false] {
            for (first, segment) in segments.iter().enumerate() {
                let [entry, _] = way_through(segment);
                if self.is_done[first] || (only_open && across(entry).is_some()) {
                    continue;
                }
                let mut at = first;
                let closed = loop {
                    self.is_done[at] = true;
                    out.push(oriented(&segments[at]));
                    let [_, exit] = way_through(&segments[at]);
                    let Some(face) = across(exit) else { break false };
                    let next = self.segment_of_face[face.index()] as usize;
                    if next == first {
                        break true;
                    }
                    at = next;
                };
                out.end_chain(closed);
            }
        }
    }

    /// Appends the feature segments that a view shows something of: boundary edges with a visible face, and of the others the
    /// parts where a visible face meets an invisible one, which are silhouettes, or all faces are visible, which are creases.
    /// Pieces of one kind that follow each other on a polyline form a chain. O(feature edges).
    pub fn features(
        &mut self,
        mesh: &ShadingMesh,
        features: &FeatureSegments,
        polylines: &[FeaturePolyline],
        silhouette: &SilhouetteSegments,
        is_visible: &[bool],
        out: &mut SilhouetteCurves,
    ) {
        for polyline in polylines {
            self.pieces.clear();
            let mut is_whole = true;
            for (i, &edge) in polyline.edges.iter().enumerate() {
                let is_forward = mesh.topology().end_points(edge)[0] == polyline.vertices[i];
                let sides = Sides { mesh, silhouette, is_visible, edge };
                is_whole &= self.edge_pieces(&sides, features, is_forward);
            }
            self.join(polyline.closed && is_whole, out);
        }
    }

    /// Appends the pieces of one edge in the direction of its polyline. Yields whether they cover it.
    fn edge_pieces(&mut self, sides: &Sides<'_>, features: &FeatureSegments, is_forward: bool) -> bool {
        let Some(index) = features.index_of(sides.edge) else { return false };
        let segment = &features.segments()[index];
        self.cuts.clear();
        let curves = segment.curves().len();
        self.cuts.extend((0..=curves).map(|i| i as f64 / curves as f64));
        self.cuts.extend(sides.silhouette_parameters());
        self.cuts.sort_unstable_by(f64::total_cmp);
        self.cuts.dedup();
        let begin = self.pieces.len();
        let mut is_whole = true;
        for cut in self.cuts.windows(2) {
            let Some(kind) = sides.kind_at(0.5 * (cut[0] + cut[1])) else {
                is_whole = false;
                continue;
            };
            let part = ((cut[0] * curves as f64).floor() as usize).min(curves - 1);
            let Some(curve) = segment.curves().nth(part) else { continue };
            let local = [cut[0], cut[1]].map(|u| u * curves as f64 - part as f64);
            let curve = restricted(curve, local);
            let curve = if is_forward { curve } else { curve.reversed() };
            self.pieces.push(curve.piece(kind, CurveSource::Edge(sides.edge)));
        }
        if !is_forward {
            self.pieces[begin..].reverse();
        }
        is_whole
    }

    /// Turns the pieces of a polyline into chains. `closed`: the last ends where the first begins.
    fn join(&mut self, closed: bool, out: &mut SilhouetteCurves) {
        let follows = |a: &SmoothPiece, b: &SmoothPiece| a.kind == b.kind && a.control[3] == b.control[0];
        let is_closed = closed
            && self.pieces.windows(2).all(|pair| follows(&pair[0], &pair[1]))
            && self.pieces.first().zip(self.pieces.last()).is_some_and(|(first, last)| follows(last, first));
        for chain in self.pieces.chunk_by(follows) {
            chain.iter().for_each(|&piece| out.push(piece));
            out.end_chain(is_closed);
        }
    }
}

/// The half-edges through which a silhouette enters and leaves a face with visible vertices on its left.
fn way_through(segment: &SilhouetteSegment) -> [HalfEdgeId; 2] {
    let triangle = segment.triangle;
    let ends = [triangle.lone, (triangle.lone + 2) % 3].map(|slot| HalfEdgeId::of(triangle.face, slot));
    if triangle.lone_is_visible { ends } else { [ends[1], ends[0]] }
}

/// The piece of a segment, visible vertices on its left.
fn oriented(segment: &SilhouetteSegment) -> SmoothPiece {
    let curve = if segment.triangle.lone_is_visible { segment.curve } else { segment.curve.reversed() };
    curve.piece(CurveKind::Silhouette, CurveSource::Face(segment.triangle.face))
}

/// The part of a curve between two of its parameters.
fn restricted(curve: &Hermite, [from, to]: [f64; 2]) -> Hermite {
    if from <= 0.0 && to >= 1.0 {
        return *curve;
    }
    Hermite {
        ends: [curve.point(from), curve.point(to)],
        tangents: [from, to].map(|u| (to - from) * curve.derivative(u)),
    }
}

/// The faces at a feature edge in a view.
struct Sides<'a> {
    mesh: &'a ShadingMesh,
    silhouette: &'a SilhouetteSegments,
    is_visible: &'a [bool],
    edge: EdgeId,
}

impl Sides<'_> {
    fn half_edges(&self) -> &[HalfEdgeId] {
        let topology: &Topology = self.mesh.topology();
        topology.half_edges(self.edge)
    }

    /// Whether the lower and the higher vertex are visible for the face of a half-edge.
    fn ends(&self, half_edge: HalfEdgeId) -> [bool; 2] {
        let corners = self.mesh.triangles()[half_edge.face().index()];
        let mut ends = [half_edge.slot(), half_edge.next_in_face().slot()].map(|slot| corners[slot as usize]);
        if self.mesh.vertices()[ends[0] as usize] > self.mesh.vertices()[ends[1] as usize] {
            ends.swap(0, 1);
        }
        ends.map(|vertex| self.is_visible[vertex as usize])
    }

    fn parameter(&self, half_edge: HalfEdgeId) -> f64 {
        self.silhouette.points()[self.silhouette.point_index(half_edge) as usize].u
    }

    /// Where faces change their visibility along the edge.
    fn silhouette_parameters(&self) -> impl Iterator<Item = f64> {
        let mixed = self.half_edges().iter().filter(|half_edge| {
            let [from, to] = self.ends(**half_edge);
            from != to
        });
        mixed.map(|&half_edge| self.parameter(half_edge))
    }

    /// What the edge shows at a parameter.
    fn kind_at(&self, u: f64) -> Option<CurveKind> {
        let is_visible = |half_edge: HalfEdgeId| match self.ends(half_edge) {
            [from, to] if from == to => from,
            [from, _] => from == (u < self.parameter(half_edge)),
        };
        let all = self.half_edges();
        let visible = all.iter().filter(|half_edge| is_visible(**half_edge)).count();
        match visible {
            0 => None,
            _ if all.len() == 1 => Some(CurveKind::Boundary),
            _ if visible < all.len() => Some(CurveKind::Silhouette),
            _ => Some(CurveKind::Crease),
        }
    }
}
