//! Section planes: a mesh is cut open, and the curves in which it is cut become lines of a kind of their own.
//!
//! 1. `plane.rs`: on which side of the plane a vertex lies, exactly.
//! 2. `in_plane.rs`: which faces that lie in the plane stay.
//! 3. Here: faces across the plane are divided, and what lies towards the normal is left out.
//!
//! Nothing closes the cut: what remains is the surface, opened, whose inner side is seen and hides lines as its outer side does.
//! A closed mesh is cut in closed polygons. Where an edge of the mesh lies in the plane, it is part of them if something at it
//! stays and something is taken away.

mod in_plane;
mod plane;

pub use plane::{ParseSectionPlaneError, SectionPlane};

use self::in_plane::InPlane;
use silhouette_core::glam::Vec3;
use silhouette_core::mesh::MeshError;
use silhouette_core::{FaceId, TriangleMesh, VertexId};
use std::cmp::Ordering;
use std::collections::{HashMap, HashSet};

/// A mesh, or what section planes leave of it.
#[derive(Debug, Clone, PartialEq)]
pub struct SectionedMesh {
    /// What remains. Vertices keep their numbers, also those that no face has any more; those in which edges were cut follow.
    pub mesh: TriangleMesh,
    /// Of each face the one of the whole mesh that it is, or is part of; ascending.
    pub face_of: Vec<FaceId>,
    /// The edges along which the mesh was cut, by their end points, lower one first; ascending.
    pub edges: Vec<[VertexId; 2]>,
}

impl SectionedMesh {
    /// A mesh that was not cut yet.
    pub fn whole(mesh: TriangleMesh) -> Self {
        let face_of = (0..mesh.face_count()).map(FaceId::from_usize).collect();
        Self { mesh, face_of, edges: Vec::new() }
    }

    /// What a plane leaves of it. Where the plane takes nothing away, all stays as it is. Expected O(F).
    ///
    /// Faces are divided in points rounded to 32 bits. On which side a vertex lies is decided exactly; one that lies so near to the
    /// plane that both edges of a face cross it in one place, but for rounding, counts as lying in it. Each plane decides anew: points in
    /// which one plane cut edges may lie a rounding off it.
    ///
    /// # Errors
    /// [`MeshError::TooLarge`] where the divided faces are more than a mesh can hold.
    pub fn cut(self, plane: &SectionPlane) -> Result<Self, MeshError> {
        let sides = Sides::new(&self.mesh, plane);
        if !self.mesh.triangles().iter().flatten().any(|&vertex| sides.of(vertex).is_gt()) {
            return Ok(self);
        }
        let in_plane = InPlane::new(&self.mesh, plane, &sides);
        let mut cutter = Cutter::new(&self, plane, sides);
        for face in (0..self.mesh.face_count()).map(FaceId::from_usize) {
            cutter.cut_face(face, &in_plane);
        }
        cutter.finish()
    }
}

/// On which side of a plane each vertex of a mesh lies.
struct Sides {
    sides: Vec<Ordering>,
    /// Of vertices in the plane, where others of the same place have other numbers, the first of that place.
    first_at_place: HashMap<u32, u32>,
}

impl Sides {
    fn new(mesh: &TriangleMesh, plane: &SectionPlane) -> Self {
        let mut sides: Vec<Ordering> = mesh.positions().iter().map(|&place| plane.side(place)).collect();
        let touching = touching(mesh, plane, &sides);
        let mut first: HashMap<Place, u32> = HashMap::new();
        let mut first_at_place = HashMap::new();
        for (vertex, side) in (0..).zip(&mut sides) {
            let place = place(mesh.positions()[vertex as usize]);
            if !touching.is_empty() && touching.contains(&place) {
                *side = Ordering::Equal;
            }
            if side.is_eq() {
                let first = *first.entry(place).or_insert(vertex);
                if first != vertex {
                    first_at_place.insert(vertex, first);
                }
            }
        }
        Self { sides, first_at_place }
    }

    fn of(&self, vertex: u32) -> Ordering {
        self.sides[vertex as usize]
    }

    /// The name of a vertex's place; of vertices that are not in the plane, or came later, their own number.
    fn place(&self, vertex: u32) -> u32 {
        self.first_at_place.get(&vertex).copied().unwrap_or(vertex)
    }

    /// The name of an edge.
    fn edge(&self, ends: [u32; 2]) -> [u32; 2] {
        ascending(ends.map(|vertex| self.place(vertex)))
    }

    /// The names of a face's sides in the plane.
    fn edges_in_plane(&self, triangle: [u32; 3]) -> impl Iterator<Item = [u32; 2]> {
        let of_slot = move |slot: usize| [triangle[slot], triangle[(slot + 1) % 3]];
        let is_in_plane = |ends: &[u32; 2]| ends.iter().all(|&vertex| self.of(vertex).is_eq());
        (0..3).map(of_slot).filter(is_in_plane).map(|ends| self.edge(ends))
    }
}

/// The bits of a place; both zeros are one.
type Place = [u32; 3];

fn place(position: Vec3) -> Place {
    (position + Vec3::ZERO).to_array().map(f32::to_bits)
}

/// Places of vertices beside the plane, but so near to it that both edges that leave one in a face cross the plane in one place,
/// but for rounding. They count as lying in the plane: to cut them off would be a face without area and a section edge without
/// length.
fn touching(mesh: &TriangleMesh, plane: &SectionPlane, sides: &[Ordering]) -> HashSet<Place> {
    let mut places = HashSet::new();
    for (face, triangle) in mesh.triangles().iter().enumerate() {
        let Some(slot) = lonely(triangle.map(|vertex| sides[vertex as usize])) else { continue };
        let corners = mesh.corners(FaceId::from_usize(face));
        let [a, b, c] = [0, 1, 2].map(|at| corners[(slot + at) % 3]);
        let crossing = plane.crossing(a, b);
        // A step of 32 bits on each axis: a face without width has its crossings in one place wherever it is cut.
        let step = a.abs().max(b.abs()) * f32::EPSILON;
        if place(crossing) == place(plane.crossing(a, c)) && (crossing - a).abs().cmple(step).all() {
            places.insert(place(a));
        }
    }
    places
}

/// The slot of the corner that is alone on its side, where the two others are on the other side.
fn lonely(sides: [Ordering; 3]) -> Option<usize> {
    (0..3).find(|&slot| {
        let [other, last] = [sides[(slot + 1) % 3], sides[(slot + 2) % 3]];
        sides[slot].is_ne() && other == last && other == sides[slot].reverse()
    })
}

fn ascending([a, b]: [u32; 2]) -> [u32; 2] {
    [a.min(b), a.max(b)]
}

/// What is at an edge in the plane.
#[derive(Default)]
struct AtEdge {
    /// End points of the edge where faces stay.
    kept: Vec<[u32; 2]>,
    /// Whether something at it is taken away.
    is_cut: bool,
}

/// Cuts one face after another.
struct Cutter<'a> {
    source: &'a SectionedMesh,
    plane: &'a SectionPlane,
    sides: Sides,
    positions: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
    face_of: Vec<FaceId>,
    /// The new vertex of each edge across the plane.
    crossings: HashMap<[u32; 2], u32>,
    /// Edges in the plane, by their names.
    in_plane: HashMap<[u32; 2], AtEdge>,
}

impl<'a> Cutter<'a> {
    fn new(source: &'a SectionedMesh, plane: &'a SectionPlane, sides: Sides) -> Self {
        let positions = source.mesh.positions().to_vec();
        let (triangles, face_of) = (Vec::new(), Vec::new());
        Self {
            source,
            plane,
            sides,
            positions,
            triangles,
            face_of,
            crossings: HashMap::new(),
            in_plane: HashMap::new(),
        }
    }

    fn cut_face(&mut self, face: FaceId, in_plane: &InPlane) {
        let triangle = self.source.mesh.triangles()[face.index()];
        let sides = triangle.map(|vertex| self.sides.of(vertex));
        let count = |wanted: Ordering| sides.iter().filter(|&&side| side == wanted).count();
        let (below, above) = (count(Ordering::Less), count(Ordering::Greater));
        if below == 0 || above == 0 {
            let stays = if below == 0 && above == 0 { in_plane.stays(face) } else { above == 0 };
            for slot in 0..3 {
                let ends = [triangle[slot], triangle[(slot + 1) % 3]];
                if ends.iter().all(|&vertex| self.sides.of(vertex).is_eq()) {
                    self.note(ends, stays, !stays);
                }
            }
            if stays {
                self.push(face, triangle);
            }
            return;
        }
        // The corner that is alone on its side, or the one in the plane, comes first.
        let first = lonely(sides).or_else(|| sides.iter().position(|side| side.is_eq())).unwrap_or(0);
        let [a, b, c] = [0, 1, 2].map(|slot| triangle[(first + slot) % 3]);
        if below + above == 2 {
            let middle = self.crossing(b, c);
            self.note([a, middle], true, true);
            let kept = if self.sides.of(b).is_lt() { [a, b, middle] } else { [a, middle, c] };
            self.push(face, kept);
            return;
        }
        let (on_ab, on_ca) = (self.crossing(a, b), self.crossing(c, a));
        self.note([on_ab, on_ca], true, true);
        if below == 1 {
            self.push(face, [a, on_ab, on_ca]);
        } else {
            self.push_quad(face, [on_ab, b, c, on_ca]);
        }
    }

    /// Of both ways to divide a quad the one that does not depend on where it begins: from its first place.
    fn push_quad(&mut self, face: FaceId, corners: [u32; 4]) {
        let place = |vertex: u32| self.positions[vertex as usize].to_array();
        let is_before = |a: u32, b: u32| place(a) < place(b);
        let first = (1..4).fold(0, |first, next| if is_before(corners[next], corners[first]) { next } else { first });
        let [p, q, r, s] = [0, 1, 2, 3].map(|at| corners[(first + at) % 4]);
        self.push(face, [p, q, r]);
        self.push(face, [p, r, s]);
    }

    fn push(&mut self, face: FaceId, triangle: [u32; 3]) {
        self.triangles.push(triangle);
        self.face_of.push(self.source.face_of[face.index()]);
    }

    /// The vertex in which the edge between two vertices on different sides crosses the plane.
    fn crossing(&mut self, a: u32, b: u32) -> u32 {
        let [a, b] = ascending([a, b]);
        *self.crossings.entry([a, b]).or_insert_with(|| {
            let [from, to] = [a, b].map(|vertex| self.positions[vertex as usize]);
            let crossing = self.plane.crossing(from, to);
            self.positions.push(crossing);
            // Beyond 32 bits the mesh is refused for its size.
            (self.positions.len() - 1) as u32
        })
    }

    /// Says of an edge in the plane whether something at it stays, and whether something is taken away.
    fn note(&mut self, ends: [u32; 2], stays: bool, is_taken: bool) {
        let at_edge = self.in_plane.entry(self.sides.edge(ends)).or_default();
        at_edge.is_cut |= is_taken;
        if stays {
            at_edge.kept.push(ascending(ends));
        }
    }

    fn finish(self) -> Result<SectionedMesh, MeshError> {
        let cut = self.in_plane.values().filter(|at_edge| at_edge.is_cut).flat_map(|at_edge| &at_edge.kept);
        let mut edges: Vec<[u32; 2]> = cut.copied().collect();
        let of_this_plane = |name: &[u32; 2]| self.in_plane.get(name).into_iter().flat_map(|at_edge| &at_edge.kept);
        // Those of earlier planes, as far as they stay.
        for ends in &self.source.edges {
            let ends = ends.map(VertexId::get);
            let sides = ends.map(|vertex| self.sides.of(vertex));
            match sides.iter().position(|side| side.is_gt()) {
                None if sides == [Ordering::Equal; 2] => {
                    edges.extend(of_this_plane(&self.sides.edge(ends)).filter(|kept| **kept == ends));
                }
                None => edges.push(ends),
                Some(taken) if sides[1 - taken].is_lt() => {
                    let middle = self.crossings.get(&ends);
                    edges.extend(middle.map(|&middle| ascending([ends[1 - taken], middle])));
                }
                Some(_) => {}
            }
        }
        edges.sort_unstable();
        edges.dedup();
        Ok(SectionedMesh {
            mesh: TriangleMesh::new(self.positions, self.triangles)?.with_origin(self.source.mesh.origin()),
            face_of: self.face_of,
            edges: edges.into_iter().map(|ends| ends.map(VertexId::new)).collect(),
        })
    }
}
