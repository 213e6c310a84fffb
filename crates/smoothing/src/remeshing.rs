//! Section III-E, local re-meshing (Figs. 11 and 12): triangles are replaced around silhouette and feature segments.
//!
//! | face | becomes |
//! |---|---|
//! | neither | itself |
//! | silhouette triangle | a fan from its lone corner to the samples of the segment, and beyond them a strip to its other side |
//! | one feature segment | a fan from the opposite corner to the samples of the feature segment |
//! | two or three feature segments | a fan from the middle of the face |
//! | silhouette triangle with feature segments | its two parts, each a fan from its middle where feature samples bend its sides |
//!
//! All faces at a side share its points, so that a closed mesh stays closed for whatever signs its vertices have.
//!
//! Departure: the paper triangulates the visible part of a silhouette triangle. Here the invisible part is kept too: it closes
//! the mesh, and no crack can open where signs of vertices and the image disagree. When an image is drawn, those of its triangles
//! that are seen from behind may be left out ([`Curves::left_out_from`]). A ray from outside of a closed surface to the outside
//! passes as many triangles from the front as from behind; so where it passes any, it passes one that is kept.

use crate::eye::Eye;
use crate::feature_samples::FeatureSamples;
use crate::feature_segments::FeatureSegments;
use crate::rounding::rounded;
use crate::shading_mesh::ShadingMesh;
use crate::silhouette_segments::{SilhouetteSegment, SilhouetteSegments};
use crate::view_mesh::{Origin, ViewMesh};
use silhouette_core::FaceId;
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::id::HalfEdgeId;

/// What re-meshing reads of a view.
pub struct Curves<'a> {
    /// The mesh.
    pub mesh: &'a ShadingMesh,
    /// Its feature segments.
    pub features: &'a FeatureSegments,
    /// How they are sampled in the view.
    pub samples: &'a FeatureSamples,
    /// Silhouette points and segments of the view.
    pub silhouette: &'a SilhouetteSegments,
    /// Number of straight pieces of each silhouette segment.
    pub counts: &'a [u32],
    /// Vertices that are moved, and where they are put.
    pub moved: &'a [(u32, DVec3)],
    /// The eye from which triangles of invisible parts that are seen from behind are left out, if any are.
    pub left_out_from: Option<Eye>,
}

/// Re-meshes view after view; scratch memory.
#[derive(Debug, Clone, Default)]
pub struct LocalRemeshing {
    /// Vertex of each silhouette point that lies on no feature edge, or [`NONE`].
    vertex_of_point: Vec<u32>,
    sides: [Side; 3],
    /// Samples of the silhouette segment, both ends included.
    chain: Vec<u32>,
    polygon: Vec<u32>,
    /// Vertices that the last view has moved.
    moved: Vec<u32>,
}

const NONE: u32 = u32::MAX;

/// The bends of one side of a face, in the direction of its half-edge.
#[derive(Debug, Clone, Default)]
struct Side {
    /// Vertices strictly inside.
    vertices: Vec<u32>,
    /// Which of them is the face's silhouette point.
    silhouette_at: usize,
}

impl Side {
    /// The bends from the silhouette point on, beginning with it.
    fn after_silhouette(&self) -> &[u32] {
        &self.vertices[self.silhouette_at..]
    }

    /// The bends up to the silhouette point, which is the last.
    fn before_silhouette(&self) -> &[u32] {
        &self.vertices[..=self.silhouette_at]
    }
}

impl LocalRemeshing {
    /// Replaces `out`, which has to be empty or as the last call left it, by the triangles of a view. The first vertices are the
    /// shading vertices, in their order. O(F + samples).
    pub fn remesh(&mut self, curves: &Curves<'_>, out: &mut ViewMesh) {
        let mesh = curves.mesh;
        self.begin_with_shading_vertices(curves, out);
        self.vertex_of_point.clear();
        self.vertex_of_point.resize(curves.silhouette.points().len(), NONE);
        let mut segments = curves.silhouette.segments().iter().zip(curves.counts).peekable();
        let mut bent = mesh.feature_faces().iter().copied().peekable();
        let mut done = 0;
        loop {
            let crossed = segments.peek().map(|(segment, _)| segment.triangle.face);
            // A face that is both is re-meshed once.
            let Some(face) = crossed.into_iter().chain(bent.peek().copied()).min() else { break };
            out.triangles.extend_from_slice(&mesh.triangles()[done..face.index()]);
            done = face.index() + 1;
            bent.next_if_eq(&face);
            match segments.next_if(|_| crossed == Some(face)) {
                Some((segment, &count)) => self.silhouette_triangle(curves, segment, count, out),
                None => self.feature_triangle(curves, face, out),
            }
        }
        out.triangles.extend_from_slice(&mesh.triangles()[done..]);
    }

    /// Leaves the shading vertices in `out`, those that moved where they are put. In what the last call left, only those that it
    /// moved differ from the mesh.
    fn begin_with_shading_vertices(&mut self, curves: &Curves<'_>, out: &mut ViewMesh) {
        let mesh = curves.mesh;
        let count = mesh.positions().len();
        out.triangles.clear();
        if out.positions.len() < count {
            out.clear();
            out.positions.extend_from_slice(mesh.positions());
            out.normals.extend_from_slice(mesh.normals());
            out.origins.extend_from_slice(mesh.origins());
        } else {
            out.positions.truncate(count);
            out.normals.truncate(count);
            out.origins.truncate(count);
            for &vertex in &self.moved {
                let range = mesh.shading_vertices(vertex);
                out.positions[range.clone()].copy_from_slice(&mesh.positions()[range]);
            }
        }
        self.moved.clear();
        for &(vertex, to) in curves.moved {
            out.positions[mesh.shading_vertices(vertex)].fill(rounded(to));
            self.moved.push(vertex);
        }
    }

    /// A face with feature segments that no silhouette runs through.
    fn feature_triangle(&mut self, curves: &Curves<'_>, face: FaceId, out: &mut ViewMesh) {
        for slot in 0..3 {
            self.bend_side(curves, HalfEdgeId::of(face, slot), None, out);
        }
        let corners = curves.mesh.triangles()[face.index()];
        self.polygon.clear();
        for (corner, side) in corners.iter().zip(&self.sides) {
            self.polygon.push(*corner);
            self.polygon.extend_from_slice(&side.vertices);
        }
        match [0, 1, 2].map(|slot| !self.sides[slot].vertices.is_empty()) {
            [false, false, false] => out.push_triangle(corners),
            // One side is bent: the corner opposite to it sees all of it.
            [true, false, false] => fan(corners[2], &self.polygon, out),
            [false, true, false] => fan(corners[0], &self.polygon, out),
            [false, false, true] => fan(corners[1], &self.polygon, out),
            _ => {
                let middle = push_middle(face, &[0, 1, 2].map(|slot| (corners[slot], Vec3::AXES[slot])), out);
                fan(middle, &self.polygon, out);
            }
        }
    }

    /// A face that the silhouette divides into the part of its lone corner and the part of the pair.
    fn silhouette_triangle(
        &mut self,
        curves: &Curves<'_>,
        segment: &SilhouetteSegment,
        count: u32,
        out: &mut ViewMesh,
    ) {
        let triangle = segment.triangle;
        let slots = [[0, 1, 2], [1, 2, 0], [2, 0, 1]][triangle.lone as usize];
        let corners = curves.mesh.triangles()[triangle.face.index()];
        let [lone, next, previous] = [corners[slots[0]], corners[slots[1]], corners[slots[2]]];
        let sides = [slots[0], slots[2]].map(|slot| HalfEdgeId::of(triangle.face, slot as u32));
        let weights = |end: usize| {
            side_weights(curves.mesh, sides[end], curves.silhouette.points()[segment.points[end] as usize].u)
        };
        let weights = [weights(0), weights(1)];
        // Which of both parts is invisible, if triangles of it may be left out.
        let left_out = |of_lone: bool| curves.left_out_from.filter(|_| triangle.lone_is_visible != of_lone);
        let is_turned = curves.mesh.is_turned()[triangle.face.index()];
        let begin = out.triangles.len();
        if !curves.mesh.has_feature(triangle.face) {
            let mut end = |i: usize| self.vertex_of_point(curves, sides[i], segment.points[i], out);
            let ends = [end(0), end(1)];
            self.sample_segment(curves, segment, count, ends, weights, out);
            fan_to_lone(lone, &self.chain, out);
            leave_out_behind(left_out(true), is_turned, begin, out);
            let begin = out.triangles.len();
            strip_to_pair([next, previous], &self.chain, out);
            leave_out_behind(left_out(false), is_turned, begin, out);
            return;
        }
        let points = [Some(segment.points[0]), None, Some(segment.points[1])];
        for (slot, point) in slots.into_iter().zip(points) {
            self.bend_side(curves, HalfEdgeId::of(triangle.face, slot as u32), point, out);
        }
        let ends = [slots[0], slots[2]].map(|slot| self.sides[slot].after_silhouette()[0]);
        self.sample_segment(curves, segment, count, ends, weights, out);
        let ends = [0, 1].map(|i| (ends[i], weights[i]));
        let corner = |i: usize| (corners[slots[i]], Vec3::AXES[slots[i]]);
        let [leaving, opposite, returning] = slots.map(|slot| &self.sides[slot]);
        let (chain, polygon) = (&self.chain, &mut self.polygon);

        if leaving.silhouette_at == 0 && returning.after_silhouette().len() == 1 {
            fan_to_lone(lone, chain, out);
        } else {
            polygon.clear();
            polygon.push(lone);
            polygon.extend_from_slice(leaving.before_silhouette());
            polygon.extend_from_slice(&chain[1..chain.len() - 1]);
            polygon.extend_from_slice(returning.after_silhouette());
            fan(push_middle(triangle.face, &[corner(0), ends[0], ends[1]], out), polygon, out);
        }
        leave_out_behind(left_out(true), is_turned, begin, out);

        let begin = out.triangles.len();
        let is_straight = leaving.after_silhouette().len() == 1 && opposite.vertices.is_empty();
        if is_straight && returning.silhouette_at == 0 {
            strip_to_pair([next, previous], chain, out);
        } else {
            polygon.clear();
            polygon.extend_from_slice(leaving.after_silhouette());
            polygon.push(next);
            polygon.extend_from_slice(&opposite.vertices);
            polygon.push(previous);
            polygon.extend_from_slice(returning.before_silhouette());
            polygon.extend(chain[1..chain.len() - 1].iter().rev());
            fan(push_middle(triangle.face, &[ends[0], corner(1), corner(2), ends[1]], out), polygon, out);
        }
        leave_out_behind(left_out(false), is_turned, begin, out);
    }

    /// The vertex of a silhouette point on a side that is no feature edge: one for all faces there.
    fn vertex_of_point(&mut self, curves: &Curves<'_>, half_edge: HalfEdgeId, index: u32, out: &mut ViewMesh) -> u32 {
        let known = &mut self.vertex_of_point[index as usize];
        if *known == NONE {
            let mesh = curves.mesh;
            let point = &curves.silhouette.points()[index as usize];
            let corners = mesh.triangles()[half_edge.face().index()];
            let share = if runs_forward(mesh, half_edge) { point.u } else { 1.0 - point.u };
            *known = match share {
                0.0 => corners[half_edge.slot() as usize],
                1.0 => corners[half_edge.next_in_face().slot() as usize],
                _ => {
                    let weights = side_weights(mesh, half_edge, point.u).to_array();
                    let origin = Origin { face: half_edge.face(), weights };
                    out.push_vertex_with_unit_normal(point.position, point.normal, origin)
                }
            };
        }
        *known
    }

    /// Finds the vertices inside a side, given the index of the silhouette point on it, if there is one.
    fn bend_side(&mut self, curves: &Curves<'_>, half_edge: HalfEdgeId, point: Option<u32>, out: &mut ViewMesh) {
        let mesh = curves.mesh;
        let slots = [half_edge.slot(), half_edge.next_in_face().slot()].map(|slot| slot as usize);
        let corners = slots.map(|slot| mesh.triangles()[half_edge.face().index()][slot]);
        let side = &mut self.sides[slots[0]];
        side.vertices.clear();
        side.silhouette_at = 0;
        let is_forward = runs_forward(mesh, half_edge);
        let share = |u: f64| if is_forward { u } else { 1.0 - u };
        let normals = corners.map(|corner| mesh.normals()[corner as usize].as_dvec3());
        let on_side = |u: f64| Origin { face: half_edge.face(), weights: side_weights(mesh, half_edge, u).to_array() };
        let Some(feature) = curves.features.index_of(mesh.topology().edge_of(half_edge)) else {
            if let Some(index) = point {
                let vertex = self.vertex_of_point(curves, half_edge, index, out);
                self.sides[slots[0]].vertices.push(vertex);
            }
            return;
        };
        let point = point.map(|index| &curves.silhouette.points()[index as usize]);
        let push = |side: &mut Side, u: f64, position: DVec3, out: &mut ViewMesh| {
            let is_point = point.is_some_and(|point| point.u.total_cmp(&u).is_eq());
            let normal = match point {
                Some(point) if is_point => point.normal,
                _ => normals[0].lerp(normals[1], share(u)),
            };
            if is_point {
                side.silhouette_at = side.vertices.len();
            }
            side.vertices.push(out.push_vertex(position, normal, on_side(u)));
        };
        // A silhouette point at an end of the side is that corner.
        let [is_first, is_last] = [point.is_some_and(|p| share(p.u) <= 0.0), point.is_some_and(|p| share(p.u) >= 1.0)];
        if is_first {
            side.vertices.push(corners[0]);
        }
        let samples = curves.samples.of(feature);
        if is_forward {
            samples.iter().for_each(|sample| push(side, sample.u, sample.position, out));
        } else {
            samples.iter().rev().for_each(|sample| push(side, sample.u, sample.position, out));
        }
        if is_last {
            side.silhouette_at = side.vertices.len();
            side.vertices.push(corners[1]);
        }
    }

    /// The vertices of a silhouette segment, from that of its first point to that of its second, whose barycentric coordinates are
    /// `weights`.
    fn sample_segment(
        &mut self,
        curves: &Curves<'_>,
        segment: &SilhouetteSegment,
        count: u32,
        ends: [u32; 2],
        weights: [Vec3; 2],
        out: &mut ViewMesh,
    ) {
        let face = segment.triangle.face;
        let normal = |end: usize| curves.silhouette.points()[segment.points[end] as usize].normal;
        let (from, to) = (normal(0), normal(1));
        self.chain.clear();
        self.chain.push(ends[0]);
        for i in 1..count {
            let t = f64::from(i) / f64::from(count);
            let origin = Origin { face, weights: weights[0].lerp(weights[1], t as f32).to_array() };
            self.chain.push(out.push_vertex(segment.curve.point(t), from.lerp(to, t), origin));
        }
        self.chain.push(ends[1]);
    }

    /// Bytes held.
    pub fn bytes(&self) -> usize {
        let sides: usize = self.sides.iter().map(|side| size_of_val(side.vertices.as_slice())).sum();
        sides
            + size_of_val(self.vertex_of_point.as_slice())
            + size_of_val(self.chain.as_slice())
            + size_of_val(self.polygon.as_slice())
            + size_of_val(self.moved.as_slice())
    }
}

/// Removes those of the triangles from `begin` on that an eye sees from behind; `is_turned`: they are wound inside out.
fn leave_out_behind(eye: Option<Eye>, is_turned: bool, begin: usize, out: &mut ViewMesh) {
    let Some(eye) = eye else { return };
    let mut kept = begin;
    for at in begin..out.triangles.len() {
        let triangle = out.triangles[at];
        let position = |corner: usize| out.positions[triangle[corner] as usize].as_dvec3();
        let (a, b, c) = (position(0), position(1), position(2));
        let facing = (b - a).cross(c - a).dot(eye.toward(a));
        let stays = if is_turned { facing <= 0.0 } else { facing >= 0.0 };
        // About half of them stay, in no pattern: a branch would be mispredicted.
        out.triangles[kept] = triangle;
        kept += usize::from(stays);
    }
    out.triangles.truncate(kept);
}

/// Triangles from the lone corner to the vertices of the segment.
fn fan_to_lone(lone: u32, chain: &[u32], out: &mut ViewMesh) {
    chain.windows(2).for_each(|pair| out.push_triangle([lone, pair[0], pair[1]]));
}

/// Triangles between the side opposite to the lone corner and the vertices of the segment.
fn strip_to_pair([next, previous]: [u32; 2], chain: &[u32], out: &mut ViewMesh) {
    let half = chain.len() / 2;
    chain[..=half].windows(2).for_each(|pair| out.push_triangle([next, pair[1], pair[0]]));
    out.push_triangle([next, previous, chain[half]]);
    chain[half..].windows(2).for_each(|pair| out.push_triangle([previous, pair[1], pair[0]]));
}

/// Triangles from one vertex of a polygon to the sides that do not touch it.
fn fan(from: u32, polygon: &[u32], out: &mut ViewMesh) {
    for (i, &vertex) in polygon.iter().enumerate() {
        let next = polygon[(i + 1) % polygon.len()];
        out.push_triangle([from, vertex, next]);
    }
}

/// Appends the middle of some vertices of a face, given their barycentric coordinates there.
fn push_middle(face: FaceId, vertices: &[(u32, Vec3)], out: &mut ViewMesh) -> u32 {
    let count = vertices.len() as f64;
    let position = vertices.iter().map(|&(vertex, _)| out.positions[vertex as usize].as_dvec3()).sum::<DVec3>() / count;
    let normal = vertices.iter().map(|&(vertex, _)| out.normals[vertex as usize].as_dvec3()).sum::<DVec3>();
    let weights = vertices.iter().map(|&(_, weights)| weights).sum::<Vec3>() / count as f32;
    out.push_vertex(position, normal, Origin { face, weights: weights.to_array() })
}

/// Whether a half-edge runs from the lower vertex of its edge to the higher, as parameters of points on it do.
#[inline]
fn runs_forward(mesh: &ShadingMesh, half_edge: HalfEdgeId) -> bool {
    let corners = mesh.mesh().triangles()[half_edge.face().index()];
    corners[half_edge.slot() as usize] <= corners[half_edge.next_in_face().slot() as usize]
}

/// Barycentric coordinates, in the face of a half-edge, of the point on it with a parameter from the lower vertex to the higher.
#[inline]
fn side_weights(mesh: &ShadingMesh, half_edge: HalfEdgeId, u: f64) -> Vec3 {
    let share = if runs_forward(mesh, half_edge) { u } else { 1.0 - u } as f32;
    let axis = |half_edge: HalfEdgeId| Vec3::AXES[half_edge.slot() as usize];
    axis(half_edge) * (1.0 - share) + axis(half_edge.next_in_face()) * share
}
