//! [`FaceSplitter`]: faces as lattices of smaller triangles whose vertices on sides are shared with the neighbours.

use crate::hermite::Hermite;
use crate::shading_mesh::ShadingMesh;
use crate::side_curves::Side;
use crate::view_mesh::{Origin, ViewMesh};
use silhouette_core::glam::DVec3;
use silhouette_core::id::PerEdge;
use silhouette_core::{FaceId, HalfEdgeId};

/// How a face is bent, given the curves over its edges.
pub trait Patch: Clone + Send {
    /// The point of a side at a parameter from 0 to 1: what [`inner_point`](Self::inner_point) tends to there.
    fn side_point(&self, side: &Hermite, u: f64) -> DVec3;

    /// The point of a face at barycentric coordinates. `sides` run from corner 0 to 1, from 1 to 2 and from 2 to 0.
    fn inner_point(&self, sides: &[Hermite; 3], weights: [f64; 3]) -> DVec3;

    /// The normal there, of any length, from the corners' positions and unit normals. A corner without weight is not read.
    fn normal(&self, positions: [DVec3; 3], normals: [DVec3; 3], weights: [f64; 3]) -> DVec3;
}

/// No vertex yet.
const NONE: u32 = u32::MAX;

/// Appends faces to a [`ViewMesh`], each as it is or split; keeps its scratch memory from mesh to mesh.
///
/// A vertex on an edge that is no feature edge is shared by both faces. On a feature edge each face has one of its own, with
/// its own normal, at bitwise the same position: it is evaluated from the edge's lower vertex to the higher one.
#[derive(Debug, Clone, Default)]
pub struct FaceSplitter {
    /// Vertex of each shading vertex.
    of_corner: Vec<u32>,
    /// First of the vertices within each side, per half-edge; of two that share them the lower one holds it.
    of_side: Vec<u32>,
    /// Vertices of the face at work.
    lattice: Vec<u32>,
}

/// What faces are made of.
pub(crate) struct Splitting<'a, P> {
    pub(crate) mesh: &'a ShadingMesh,
    /// The curve over each edge that is split, from its lower to its higher vertex.
    pub(crate) curves: &'a PerEdge<Hermite>,
    pub(crate) patch: &'a P,
    /// Parts that a split side has, at least 1.
    pub(crate) segments: u32,
}

impl FaceSplitter {
    /// Forgets the vertices of the last mesh and empties `out`. O(V + F).
    pub(crate) fn begin(&mut self, mesh: &ShadingMesh, out: &mut ViewMesh) {
        out.clear();
        for (vertices, count) in
            [(&mut self.of_corner, mesh.positions().len()), (&mut self.of_side, 3 * mesh.triangles().len())]
        {
            vertices.clear();
            vertices.resize(count, NONE);
        }
    }

    /// Bytes held.
    pub(crate) fn bytes(&self) -> usize {
        [&self.of_corner, &self.of_side, &self.lattice].map(|list| size_of_val(list.as_slice())).iter().sum()
    }

    /// Appends a face as segments x segments triangles.
    pub(crate) fn push_split<P: Patch>(&mut self, from: &Splitting<'_, P>, face: FaceId, out: &mut ViewMesh) {
        let n = from.segments;
        // Of the point (i, j), which is i steps towards corner 1 and j towards corner 2.
        let place = |i: u32, j: u32| (j * (n + 1) - j * j.saturating_sub(1) / 2 + i) as usize;
        self.lattice.clear();
        self.lattice.resize(place(0, n) + 1, NONE);
        let corners = [0, 1, 2].map(|slot| self.corner(from.mesh, face, slot, out));
        for (vertex, (i, j)) in corners.into_iter().zip([(0, 0), (n, 0), (0, n)]) {
            self.lattice[place(i, j)] = vertex;
        }
        for slot in 0..3 {
            let half_edge = HalfEdgeId::of(face, slot);
            let vertices = self.side(from, half_edge, out);
            for k in 1..n {
                let (i, j) = [(k, 0), (n - k, k), (0, n - k)][slot as usize];
                self.lattice[place(i, j)] = vertices.at(k);
            }
        }
        if n > 2 {
            let (positions, normals) = corner_data(from.mesh, face);
            let sides = [0, 1, 2].map(|slot| {
                let half_edge = HalfEdgeId::of(face, slot);
                let curve = from.curves[from.mesh.topology().edge_of(half_edge)];
                if Side::of(from.mesh, half_edge).ascends { curve } else { curve.reversed() }
            });
            for (i, j) in (1..n - 1).flat_map(|j| (1..n - j).map(move |i| (i, j))) {
                let weights = [n - i - j, i, j].map(|part| f64::from(part) / f64::from(n));
                let position = from.patch.inner_point(&sides, weights);
                let normal = from.patch.normal(positions, normals, weights);
                self.lattice[place(i, j)] = out.push_vertex(position, normal, origin(face, weights));
            }
        }
        for j in 0..n {
            for i in 0..n - j {
                let [a, b, c] = [place(i, j), place(i + 1, j), place(i, j + 1)].map(|place| self.lattice[place]);
                out.push_triangle([a, b, c]);
                if i + j + 1 < n {
                    out.push_triangle([b, self.lattice[place(i + 1, j + 1)], c]);
                }
            }
        }
    }

    /// Appends a face as it is.
    pub(crate) fn push_whole(&mut self, mesh: &ShadingMesh, face: FaceId, out: &mut ViewMesh) {
        let corners = [0, 1, 2].map(|slot| self.corner(mesh, face, slot, out));
        out.push_triangle(corners);
    }

    /// The vertex of a shading vertex that a face was appended with.
    pub(crate) fn vertex_of(&self, corner: u32) -> u32 {
        self.of_corner[corner as usize]
    }

    /// Appends a flat face, some of whose sides its neighbours split: a fan from the corner opposite of one such side, or around
    /// the centre.
    pub(crate) fn push_flat<P: Patch>(
        &mut self,
        from: &Splitting<'_, P>,
        face: FaceId,
        is_split: [bool; 3],
        out: &mut ViewMesh,
    ) {
        let corners = [0, 1, 2].map(|slot| self.corner(from.mesh, face, slot, out));
        let centre = match is_split {
            [false, false, false] => return out.push_triangle(corners),
            [true, false, false] => corners[2],
            [false, true, false] => corners[0],
            [false, false, true] => corners[1],
            _ => {
                let (positions, normals) = corner_data(from.mesh, face);
                let position = positions.iter().sum::<DVec3>() / 3.0;
                out.push_vertex(position, normals.iter().sum(), origin(face, [1.0 / 3.0; 3]))
            }
        };
        for slot in 0..3 {
            let [start, end] = [corners[slot], corners[(slot + 1) % 3]];
            if !is_split[slot] {
                out.push_triangle([centre, start, end]);
                continue;
            }
            let vertices = self.side(from, HalfEdgeId::of(face, slot as u32), out);
            let mut last = start;
            for k in 1..from.segments {
                out.push_triangle([centre, last, vertices.at(k)]);
                last = vertices.at(k);
            }
            out.push_triangle([centre, last, end]);
        }
    }

    /// The vertex of a corner.
    fn corner(&mut self, mesh: &ShadingMesh, face: FaceId, slot: usize, out: &mut ViewMesh) -> u32 {
        let corner = mesh.triangles()[face.index()][slot] as usize;
        if self.of_corner[corner] == NONE {
            let mut weights = [0.0; 3];
            weights[slot] = 1.0;
            let (position, normal) = (mesh.positions()[corner].as_dvec3(), mesh.normals()[corner].as_dvec3());
            self.of_corner[corner] = out.push_vertex(position, normal, origin(face, weights));
        }
        self.of_corner[corner]
    }

    /// The vertices within a side.
    fn side<P: Patch>(&mut self, from: &Splitting<'_, P>, half_edge: HalfEdgeId, out: &mut ViewMesh) -> SideVertices {
        let Splitting { mesh, curves, patch, segments } = *from;
        let edge = mesh.topology().edge_of(half_edge);
        let owner = if mesh.features()[edge] { half_edge } else { mesh.topology().half_edges(edge)[0] };
        let side = Side::of(mesh, half_edge);
        if self.of_side[owner.index()] == NONE {
            self.of_side[owner.index()] = out.positions.len() as u32;
            let [low, high] = side.corners_ascending().map(|corner| corner as usize);
            let ([p, q], [m, n]) = (
                [low, high].map(|at| mesh.positions()[at].as_dvec3()),
                [mesh.normals()[low].as_dvec3(), mesh.normals()[high].as_dvec3()],
            );
            let [low_slot, high_slot] = side.ascending(side.slots);
            for k in 1..segments {
                let u = f64::from(k) / f64::from(segments);
                let mut weights = [0.0; 3];
                (weights[low_slot], weights[high_slot]) = (1.0 - u, u);
                let normal = patch.normal([p, q, p], [m, n, m], [1.0 - u, u, 0.0]);
                out.push_vertex(patch.side_point(&curves[edge], u), normal, origin(half_edge.face(), weights));
            }
        }
        SideVertices { first: self.of_side[owner.index()], segments, ascends: side.ascends }
    }
}

/// The vertices within a side of a face.
#[derive(Debug, Clone, Copy)]
struct SideVertices {
    first: u32,
    segments: u32,
    ascends: bool,
}

impl SideVertices {
    /// The vertex after some parts, 1 to one less than all, along the face.
    fn at(&self, part: u32) -> u32 {
        self.first + if self.ascends { part - 1 } else { self.segments - 1 - part }
    }
}

fn corner_data(mesh: &ShadingMesh, face: FaceId) -> ([DVec3; 3], [DVec3; 3]) {
    let corners = mesh.triangles()[face.index()].map(|corner| corner as usize);
    (corners.map(|at| mesh.positions()[at].as_dvec3()), corners.map(|at| mesh.normals()[at].as_dvec3()))
}

fn origin(face: FaceId, weights: [f64; 3]) -> Origin {
    Origin { face, weights: weights.map(|weight| weight as f32) }
}
