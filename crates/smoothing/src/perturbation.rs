//! Section III-E, local perturbation: vertices near concave silhouette segments are lowered until they hide none of them.
//!
//! The vertices of a silhouette triangle and those that an edge joins to it are its neighbours. A vertex moves along the average
//! R of the normals of all planes that it neighbours.
//!
//! Departures:
//!
//! 1. The printed length is the largest of the distances to the planes along R, which leaves the vertex above all planes but
//!    one and raises vertices that are below all of them. It has to be the least, and not above zero
//!    ([`Perturbation::Lowered`]); the printed one stays available.
//! 2. A plane that faces away from R cannot be reached along R and is left out.
//! 3. No vertex moves farther than the shortest of its edges is long.
//! 4. Silhouette points are found before vertices are moved.
//! 5. A plane that lies too far below a vertex for both to be of one arc, [`SAME_ARC`], belongs to another part of the surface and is
//!    left out.

use crate::concavity::BlockingPlane;
use crate::shading_mesh::ShadingMesh;
use silhouette_core::FaceId;
use silhouette_core::glam::DVec3;
use silhouette_core::{Cancelled, Progress};

silhouette_core::option_choice! {
    /// Whether and how far vertices near concave segments are moved.
    pub enum Perturbation {
        /// Below every plane that can be reached.
        Lowered = "lowered",
        /// Not at all.
        Off = "off",
        /// By the printed maximum, which raises vertices too.
        AsPrinted = "as-printed",
    }
}

/// How high above a plane, as a multiple of the height of the segment's arc, a vertex of the same arc may stand: the neighbours of a
/// face reach one and a half chords from the middle of the segment, and heights grow as the square of the distance.
pub const SAME_ARC: f64 = 9.0;

/// Moves vertices near concave segments; what it knows of the mesh, and scratch memory.
#[derive(Debug, Clone)]
pub struct Perturber {
    law: Perturbation,
    /// Neighbours of face f, ascending: `neighbours[first[f]..first[f + 1]]`.
    first: Vec<u32>,
    neighbours: Vec<u32>,
    /// Length of the shortest edge of each vertex.
    reach: Vec<f32>,
    planes: Vec<BlockingPlane>,
    /// The planes near each vertex, as a list through [`near`](Self::near): its head, or [`NONE`].
    heads: Vec<u32>,
    near: Vec<Near>,
    /// The vertices that have such a list.
    touched: Vec<u32>,
    moved: Vec<(u32, DVec3)>,
}

/// A plane near a vertex, and the next one.
#[derive(Debug, Clone, Copy)]
struct Near {
    plane: u32,
    next: u32,
}

const NONE: u32 = u32::MAX;

/// Faces between two checks for cancellation: about 10 ms.
const FACES_PER_CHECK: usize = 1 << 16;

impl Perturber {
    /// Lists the neighbours of every face. O(F), 50 bytes per face; nothing where perturbation is off.
    ///
    /// # Errors
    /// [`Cancelled`] when `progress` says so.
    pub fn new(mesh: &ShadingMesh, law: Perturbation, progress: &dyn Progress) -> Result<Self, Cancelled> {
        let mut perturber = Self {
            law,
            first: Vec::new(),
            neighbours: Vec::new(),
            reach: Vec::new(),
            planes: Vec::new(),
            heads: Vec::new(),
            near: Vec::new(),
            touched: Vec::new(),
            moved: Vec::new(),
        };
        if law != Perturbation::Off {
            perturber.list_neighbours(mesh, progress)?;
        }
        Ok(perturber)
    }

    fn list_neighbours(&mut self, mesh: &ShadingMesh, progress: &dyn Progress) -> Result<(), Cancelled> {
        let vertices = mesh.mesh().vertex_count();
        self.reach = vec![f32::INFINITY; vertices];
        self.heads = vec![NONE; vertices];
        for [a, b] in proper_edges(mesh) {
            let [from, to] = [a, b].map(|vertex| mesh.mesh().positions()[vertex as usize]);
            let length = from.as_dvec3().distance(to.as_dvec3()) as f32;
            for vertex in [a, b].map(|vertex| vertex as usize) {
                self.reach[vertex] = self.reach[vertex].min(length);
            }
        }
        progress.check()?;
        let (first, around) = vertex_neighbours(mesh);
        self.first.push(0);
        let mut near = Vec::new();
        for run in mesh.mesh().triangles().chunks(FACES_PER_CHECK) {
            progress.check()?;
            for corners in run {
                near.clear();
                near.extend_from_slice(corners);
                for corner in corners.map(|corner| corner as usize) {
                    near.extend_from_slice(&around[first[corner] as usize..first[corner + 1] as usize]);
                }
                near.sort_unstable();
                near.dedup();
                self.neighbours.extend_from_slice(&near);
                self.first.push(self.neighbours.len() as u32);
            }
        }
        Ok(())
    }

    /// Forgets all planes.
    pub fn clear(&mut self) {
        self.planes.clear();
        self.near.clear();
        self.touched.drain(..).for_each(|vertex| self.heads[vertex as usize] = NONE);
        self.moved.clear();
    }

    /// Notes that the neighbours of a face must stay below a plane. Nothing where perturbation is off.
    pub fn push(&mut self, face: FaceId, plane: BlockingPlane) {
        if self.law == Perturbation::Off {
            return;
        }
        let index = self.planes.len() as u32;
        self.planes.push(plane);
        let [begin, end] = [0, 1].map(|i| self.first[face.index() + i] as usize);
        for &vertex in &self.neighbours[begin..end] {
            let head = &mut self.heads[vertex as usize];
            if *head == NONE {
                self.touched.push(vertex);
            }
            self.near.push(Near { plane: index, next: *head });
            *head = (self.near.len() - 1) as u32;
        }
    }

    /// Finds where vertices are moved to. O(P) for P pairs of a vertex and a plane.
    pub fn find(&mut self, mesh: &ShadingMesh) {
        self.moved.clear();
        for &vertex in &self.touched {
            let position = mesh.mesh().positions()[vertex as usize].as_dvec3();
            let (list, all) = (&self.near, &self.planes);
            let first = list.get(self.heads[vertex as usize] as usize);
            let planes = || {
                let following = |near: &&Near| list.get(near.next as usize);
                std::iter::successors(first, following).map(|near| &all[near.plane as usize])
            };
            let Some(direction) = planes().map(|plane| plane.normal).sum::<DVec3>().try_normalize() else { continue };
            let to_plane = |plane: &BlockingPlane| {
                let slope = direction.dot(plane.normal);
                let above = (position - plane.middle).dot(plane.normal);
                (slope > 0.0 && above <= SAME_ARC * plane.height).then(|| -above / slope)
            };
            let lengths = planes().filter_map(to_plane);
            let length = match self.law {
                Perturbation::Off => 0.0,
                Perturbation::Lowered => lengths.fold(0.0, f64::min),
                Perturbation::AsPrinted => lengths.reduce(f64::max).unwrap_or(0.0),
            };
            let reach = f64::from(self.reach[vertex as usize]);
            let length = length.clamp(-reach, reach);
            if length != 0.0 && length.is_finite() {
                self.moved.push((vertex, position + length * direction));
            }
        }
    }

    /// Where vertices are moved to, as last found; those that stay are left out.
    pub fn moved(&self) -> &[(u32, DVec3)] {
        &self.moved
    }

    /// Bytes held.
    pub fn bytes(&self) -> usize {
        size_of_val(self.first.as_slice())
            + size_of_val(self.neighbours.as_slice())
            + size_of_val(self.reach.as_slice())
            + size_of_val(self.heads.as_slice())
            + size_of_val(self.near.as_slice())
            + size_of_val(self.planes.as_slice())
    }
}

/// Edges between two vertices.
fn proper_edges(mesh: &ShadingMesh) -> impl Iterator<Item = [u32; 2]> {
    mesh.topology().edges().iter().map(|(_, &ends)| ends).filter(|[a, b]| a != b)
}

/// The vertices that an edge joins to vertex v, as `neighbours[first[v]..first[v + 1]]`: `(first, neighbours)`. O(E).
pub(crate) fn vertex_neighbours(mesh: &ShadingMesh) -> (Vec<u32>, Vec<u32>) {
    let vertices = mesh.mesh().vertex_count();
    let mut first = vec![0; vertices + 1];
    proper_edges(mesh).flatten().for_each(|vertex| first[vertex as usize + 1] += 1);
    (0..vertices).for_each(|vertex| first[vertex + 1] += first[vertex]);
    let mut neighbours = vec![0; first[vertices] as usize];
    let mut next = first.clone();
    for [a, b] in proper_edges(mesh) {
        for (at, other) in [(a, b), (b, a)] {
            neighbours[next[at as usize] as usize] = other;
            next[at as usize] += 1;
        }
    }
    (first, neighbours)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shading_normals::NormalWeights;
    use silhouette_core::glam::Vec3;
    use silhouette_core::{NoProgress, PreparedMesh, shapes};
    use silhouette_testing::directions::spread;

    fn mesh() -> ShadingMesh {
        ShadingMesh::new(
            &PreparedMesh::new(shapes::by_name("icosphere:1").unwrap()),
            75.0,
            NormalWeights::Sphere,
            "test",
            &NoProgress,
        )
        .unwrap()
    }

    /// Planes that touch the sphere of radius `at` in some directions near a vertex, and the vertex's place after perturbation.
    fn perturbed(law: Perturbation, at: f64, count: usize) -> (DVec3, Vec<BlockingPlane>, DVec3) {
        let mesh = mesh();
        let mut perturber = Perturber::new(&mesh, law, &NoProgress).unwrap();
        let vertex = mesh.mesh().triangles()[0][0];
        let position = mesh.mesh().positions()[vertex as usize].as_dvec3();
        let planes: Vec<_> = spread(count)
            .map(|off| {
                let normal = (position + 0.3 * off).normalize();
                BlockingPlane { middle: at * normal, normal, height: 1.0 }
            })
            .collect();
        planes.iter().for_each(|&plane| perturber.push(FaceId::new(0), plane));
        perturber.find(&mesh);
        let moved = perturber.moved().iter().find(|(at, _)| *at == vertex).map_or(position, |(_, to)| *to);
        (position, planes, moved)
    }

    #[test]
    fn vertices_end_below_every_plane_and_by_the_printed_maximum_they_do_not() {
        let is_below = |planes: &[BlockingPlane], point: DVec3| {
            planes.iter().all(|plane| (point - plane.middle).dot(plane.normal) <= 1e-12)
        };
        let (from, planes, to) = perturbed(Perturbation::Lowered, 0.9, 7);
        assert!(!is_below(&planes, from) && is_below(&planes, to));
        let (_, planes, to) = perturbed(Perturbation::AsPrinted, 0.9, 7);
        assert!(!is_below(&planes, to));
    }

    #[test]
    fn a_vertex_below_all_planes_stays_and_by_the_printed_maximum_it_is_raised() {
        let (from, _, to) = perturbed(Perturbation::Lowered, 1.1, 5);
        assert_eq!(from, to);
        let (from, _, to) = perturbed(Perturbation::AsPrinted, 1.1, 5);
        assert!(to.length() > from.length() + 0.05);
        let (from, _, to) = perturbed(Perturbation::Off, 0.5, 5);
        assert_eq!(from, to);
    }

    #[test]
    fn no_vertex_moves_farther_than_its_shortest_edge() {
        let mesh = mesh();
        let mut perturber = Perturber::new(&mesh, Perturbation::Lowered, &NoProgress).unwrap();
        let far = BlockingPlane { middle: DVec3::splat(-50.0), normal: DVec3::X, height: 100.0 };
        perturber.push(FaceId::new(3), far);
        perturber.find(&mesh);
        let moved = perturber.moved();
        assert!(moved.len() > 6, "a face and what its edges lead to");
        for &(vertex, to) in moved {
            let from: Vec3 = mesh.mesh().positions()[vertex as usize];
            assert!(from.as_dvec3().distance(to) < 0.65, "edges of this mesh are up to 0.62 long");
        }
    }
}
