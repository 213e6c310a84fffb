//! The last collapses of a hull's edges, each checked: none makes the hull touch the object or itself.
//!
//! `meshopt` collapses without regard to either. At a coarse hull's faces, a few folds and faces that reach into the object are
//! the rule, and one is enough to spoil it. So it is left with several times the vertices that are wanted, and edges are
//! collapsed here from then on, in the order of their quadric error, with the vertex left at the best of seven places. As the best
//! place is mostly outside of a convex surface, this also keeps the hull from shrinking.

use crate::hull::box_grid::{BoxGrid, box_of};
use crate::hull::quadric::Quadric;
use crate::hull::self_contact::meets;
use crate::hull::touching::faces_touch;
use glam::{DVec3, Vec3};
use silhouette_core::glam;
use silhouette_core::{Cancelled, Progress, TriangleMesh};
use silhouette_rays::MeshHierarchy;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Least cosine between the normals of a face before and after a collapse.
const TURN: f64 = 0.3;

/// Faces whose boxes and edges are listed, before the next question whether to stop: some milliseconds.
const FACES_BETWEEN_CHECKS: usize = 1024;

/// A closed manifold with at most `vertices` vertices where checks permit, or more. The same bits for any number of threads.
/// Expected O(V log V + V log F) for V vertices of `hull` and F faces of the object.
pub(super) fn collapsed(
    hull: &TriangleMesh,
    object: &MeshHierarchy,
    vertices: usize,
    progress: &dyn Progress,
) -> Result<TriangleMesh, Cancelled> {
    let mut collapses = Collapses::new(hull, object, vertices, progress)?;
    while collapses.left > vertices
        && let Some(candidate) = collapses.heap.pop()
    {
        progress.check()?;
        collapses.attempt(candidate.0)?;
    }
    Ok(collapses.finished())
}

/// An edge to collapse. Ordered by cost.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Candidate {
    /// The bits of a cost of 0 or more, which have its order.
    cost: u64,
    edge: [u32; 2],
    /// How often the ends had changed.
    versions: [u32; 2],
}

struct Collapses<'a> {
    object: &'a MeshHierarchy,
    progress: &'a dyn Progress,
    /// What quadrics are relative to.
    origin: DVec3,
    positions: Vec<Vec3>,
    quadrics: Vec<Quadric>,
    versions: Vec<u32>,
    /// Faces at each vertex; none once it is gone.
    faces_of: Vec<Vec<u32>>,
    triangles: Vec<[u32; 3]>,
    /// The boxes of faces that are left.
    boxes: BoxGrid,
    heap: BinaryHeap<Reverse<Candidate>>,
    /// Vertices left.
    left: usize,
}

impl<'a> Collapses<'a> {
    fn new(
        hull: &TriangleMesh,
        object: &'a MeshHierarchy,
        vertices: usize,
        progress: &'a dyn Progress,
    ) -> Result<Self, Cancelled> {
        let origin = hull.bounds().map_or(DVec3::ZERO, |bounds| bounds.center);
        let mut collapses = Self {
            object,
            progress,
            origin,
            positions: hull.positions().to_vec(),
            quadrics: vec![Quadric::ZERO; hull.vertex_count()],
            versions: vec![0; hull.vertex_count()],
            faces_of: vec![Vec::new(); hull.vertex_count()],
            triangles: hull.triangles().to_vec(),
            boxes: BoxGrid::new(origin, cell(hull, vertices)),
            heap: BinaryHeap::new(),
            left: hull.vertex_count(),
        };
        for (face, triangle) in hull.triangles().iter().enumerate() {
            if face % FACES_BETWEEN_CHECKS == 0 {
                progress.check()?;
            }
            let quadric = Quadric::of_face(triangle.map(|vertex| collapses.place(vertex)));
            collapses.boxes.set(face as u32, Some(box_of(collapses.corners(*triangle))));
            for &vertex in triangle {
                collapses.faces_of[vertex as usize].push(face as u32);
                collapses.quadrics[vertex as usize] = collapses.quadrics[vertex as usize].plus(&quadric);
            }
        }
        for (face, &[a, b, c]) in hull.triangles().iter().enumerate() {
            if face % FACES_BETWEEN_CHECKS == 0 {
                progress.check()?;
            }
            for edge in [[a, b], [b, c], [c, a]] {
                // Each edge is met from both sides.
                if edge[0] < edge[1] {
                    collapses.push(edge);
                }
            }
        }
        Ok(collapses)
    }

    fn place(&self, vertex: u32) -> DVec3 {
        self.positions[vertex as usize].as_dvec3() - self.origin
    }

    fn corners(&self, triangle: [u32; 3]) -> [Vec3; 3] {
        triangle.map(|vertex| self.positions[vertex as usize])
    }

    /// Places for the vertex that an edge becomes, with their costs, best first.
    fn places(&self, [a, b]: [u32; 2]) -> Vec<(f64, Vec3)> {
        let quadric = self.quadrics[a as usize].plus(&self.quadrics[b as usize]);
        let ends = [self.place(a), self.place(b)];
        let length = ends[0].distance(ends[1]);
        let middle = ends[0].midpoint(ends[1]);
        let lowest = quadric.lowest().filter(|lowest| lowest.distance(middle) < 2.0 * length);
        let outward = self.outward(a) + self.outward(b);
        let farther = [0.125, 0.25, 0.5].map(|share| middle + outward.normalize_or_zero() * (share * length));
        let all = lowest.into_iter().chain([middle, ends[0], ends[1]]).chain(farther);
        let mut places: Vec<(f64, Vec3)> =
            all.map(|place| (quadric.at(place).max(0.0), (place + self.origin).as_vec3())).collect();
        places.sort_by(|one, other| one.0.total_cmp(&other.0));
        places
    }

    /// The sum of the normals of the faces at a vertex, weighted by their areas.
    fn outward(&self, vertex: u32) -> DVec3 {
        let across = |&face: &u32| {
            let [a, b, c] = self.triangles[face as usize].map(|vertex| self.place(vertex));
            (b - a).cross(c - a)
        };
        self.faces_of[vertex as usize].iter().map(across).sum()
    }

    fn push(&mut self, edge: [u32; 2]) {
        let cost = self.places(edge)[0].0.to_bits();
        self.heap.push(Reverse(Candidate { cost, edge, versions: edge.map(|end| self.versions[end as usize]) }));
    }

    /// Collapses an edge, if it is still as it was and a place passes all checks.
    fn attempt(&mut self, Candidate { edge, versions, .. }: Candidate) -> Result<(), Cancelled> {
        if edge.map(|end| self.versions[end as usize]) != versions {
            return Ok(());
        }
        let Some(ring) = self.ring(edge) else { return Ok(()) };
        for (_, place) in self.places(edge) {
            if self.is_free(&ring, place)? {
                self.collapse(edge, &ring, place);
                break;
            }
        }
        Ok(())
    }

    /// What a collapse changes; `None` if it would change the topology.
    fn ring(&self, [a, b]: [u32; 2]) -> Option<Ring> {
        let faces = |vertex: u32| &self.faces_of[vertex as usize];
        let gone: Vec<u32> = faces(a).iter().copied().filter(|face| faces(b).contains(face)).collect();
        let changed: Vec<u32> = faces(a).iter().chain(faces(b)).copied().filter(|face| !gone.contains(face)).collect();
        let around = |vertex: u32| {
            let mut around: Vec<u32> = faces(vertex).iter().flat_map(|&face| self.triangles[face as usize]).collect();
            around.sort_unstable();
            around.dedup();
            around.retain(|&other| other != vertex);
            around
        };
        let of_b = around(b);
        let common: Vec<u32> = around(a).into_iter().filter(|vertex| of_b.contains(vertex)).collect();
        // Both stay in more than two faces.
        let is_kept = common.len() == 2 && gone.len() == 2 && common.iter().all(|&vertex| faces(vertex).len() > 3);
        let new = |&face: &u32| self.triangles[face as usize].map(|vertex| if vertex == b { a } else { vertex });
        is_kept.then(|| Ring { into: a, triangles: changed.iter().map(new).collect(), gone, changed })
    }

    /// Whether the faces of a ring touch nothing, with their vertex at a place.
    fn is_free(&self, ring: &Ring, place: Vec3) -> Result<bool, Cancelled> {
        let corner = |vertex: u32| if vertex == ring.into { place } else { self.positions[vertex as usize] };
        let new: Vec<[Vec3; 3]> = ring.triangles.iter().map(|triangle| triangle.map(corner)).collect();
        let normal = |corners: [Vec3; 3]| {
            let [a, b, c] = corners.map(Vec3::as_dvec3);
            (b - a).cross(c - a).normalize_or_zero()
        };
        let turns = |(&face, &corners): (&u32, &[Vec3; 3])| {
            normal(self.corners(self.triangles[face as usize])).dot(normal(corners)) < TURN
        };
        if ring.changed.iter().zip(&new).any(turns) {
            return Ok(false);
        }
        let near = self.near(ring, &new);
        let touches_hull = (0..new.len()).any(|index| {
            let (triangle, corners) = (ring.triangles[index], new[index]);
            let others = near.iter().map(|&face| {
                let other = self.triangles[face as usize];
                (other, self.corners(other))
            });
            let among = (0..index).map(|earlier| (ring.triangles[earlier], new[earlier]));
            others.chain(among).any(|(other, of_other)| hull_faces_touch(triangle, corners, other, of_other))
        });
        if touches_hull {
            return Ok(false);
        }
        for corners in new {
            // A face of a coarse hull may be near many thousands of the object's.
            self.progress.check()?;
            if self.touches_object(corners) {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Other faces of the hull in the box around those of a ring.
    fn near(&self, ring: &Ring, new: &[[Vec3; 3]]) -> Vec<u32> {
        let boxes = new.iter().map(|&corners| box_of(corners));
        let around = boxes.reduce(|all, one| [all[0].min(one[0]), all[1].max(one[1])]);
        let mut near = around.map(|around| self.boxes.meeting(around)).unwrap_or_default();
        near.retain(|face| !ring.changed.contains(face) && !ring.gone.contains(face));
        near
    }

    fn touches_object(&self, corners: [Vec3; 3]) -> bool {
        let mut touches = false;
        self.object.near_triangle(corners, |_, of_object| {
            touches = faces_touch(corners, of_object);
            touches
        });
        touches
    }

    fn collapse(&mut self, [a, b]: [u32; 2], ring: &Ring, place: Vec3) {
        for &face in &ring.gone {
            self.boxes.set(face, None);
            for vertex in self.triangles[face as usize] {
                self.faces_of[vertex as usize].retain(|&other| other != face);
            }
        }
        self.positions[a as usize] = place;
        self.quadrics[a as usize] = self.quadrics[a as usize].plus(&self.quadrics[b as usize]);
        self.faces_of[b as usize].clear();
        self.faces_of[a as usize].clone_from(&ring.changed);
        for (&face, &triangle) in ring.changed.iter().zip(&ring.triangles) {
            self.triangles[face as usize] = triangle;
            self.boxes.set(face, Some(box_of(self.corners(triangle))));
        }
        self.left -= 1;
        self.versions[b as usize] += 1;
        let mut around: Vec<u32> = ring.triangles.as_flattened().to_vec();
        around.sort_unstable();
        around.dedup();
        // Also what failed before may succeed now: edges around are asked again.
        self.versions[a as usize] += 1;
        for vertex in around.into_iter().filter(|&vertex| vertex != a) {
            self.push([a.min(vertex), a.max(vertex)]);
        }
    }

    fn finished(self) -> TriangleMesh {
        let mut numbers = vec![0; self.positions.len()];
        let mut positions = Vec::with_capacity(self.left);
        for (vertex, _) in self.faces_of.iter().enumerate().filter(|(_, faces)| !faces.is_empty()) {
            numbers[vertex] = positions.len() as u32;
            positions.push(self.positions[vertex]);
        }
        let left = (0..).zip(&self.triangles).filter(|&(face, _)| self.boxes.has(face));
        let triangles = left.map(|(_, triangle)| triangle.map(|vertex| numbers[vertex as usize])).collect();
        TriangleMesh::new(positions, triangles).expect("places are finite, and faces left have vertices left")
    }
}

/// About the length of the edges of a hull with so many vertices.
fn cell(hull: &TriangleMesh, vertices: usize) -> f64 {
    let area = |triangle: &[u32; 3]| {
        let [a, b, c] = triangle.map(|vertex| hull.positions()[vertex as usize].as_dvec3());
        (b - a).cross(c - a).length() * 0.5
    };
    let cell = (hull.triangles().iter().map(area).sum::<f64>() / vertices as f64).sqrt();
    // Flat as it may be, it has an extent.
    cell.max(hull.bounds().map_or(1.0, |bounds| bounds.radius / 1e4))
}

/// Faces around an edge.
struct Ring {
    /// The vertex that is left.
    into: u32,
    /// The two faces at the edge.
    gone: Vec<u32>,
    /// The other faces at its ends.
    changed: Vec<u32>,
    /// What these become.
    triangles: Vec<[u32; 3]>,
}

/// Whether two faces of a hull touch elsewhere than in what they share.
fn hull_faces_touch(one: [u32; 3], of_one: [Vec3; 3], other: [u32; 3], of_other: [Vec3; 3]) -> bool {
    let edges_touch = |from: [u32; 3], of_from: [Vec3; 3], to: [u32; 3], of_to: [Vec3; 3]| {
        (0..3).any(|slot| {
            let next = (slot + 1) % 3;
            meets([from[slot], from[next]], [of_from[slot], of_from[next]], to, of_to)
        })
    };
    edges_touch(one, of_one, other, of_other) || edges_touch(other, of_other, one, of_one)
}
