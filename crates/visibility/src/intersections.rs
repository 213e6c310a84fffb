//! [`FaceIntersections`]: the segments in which surfaces pass through each other.
//!
//! 1. Two faces have a segment in common because edges of one pass through the other, or a vertex of one lies on the other,
//!    or they share a vertex: two of these make a segment.
//! 2. It counts where the surfaces go through each other there, and not where one only ends on the other or both only touch,
//!    as the patches of a model along their seams: `sheets.rs`.
//!
//! All of this is decided exactly; the ends of a segment are rounded to `f32`. Faces that overlap in one plane have no line
//! of intersection.

use crate::candidate::Candidate;
use crate::face_tree::FaceTree;
use crate::piercing::{holds, passage};
use crate::sheets::pass_through;
use rayon::prelude::*;
use silhouette_core::glam::Vec3;
use silhouette_core::orientation::orientation;
use silhouette_core::prepared::Artefact;
use silhouette_core::{Cancelled, EdgeId, FaceId, PreparedMesh, Progress, Topology, TriangleMesh};
use std::sync::atomic::{AtomicU64, Ordering};

/// An end of a segment of intersection.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct IntersectionEnd {
    /// Its place, rounded.
    pub place: Vec3,
    /// What distinguishes it from other ends: a mesh vertex, or V plus the index of the place where an edge passes through a
    /// face. Segments that continue each other have one in common.
    pub id: u32,
}

/// A segment in which two faces intersect.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Intersection {
    /// Its ends.
    pub ends: [IntersectionEnd; 2],
    /// The two faces, ascending.
    pub faces: [FaceId; 2],
}

/// All segments in which the surfaces of a mesh pass through each other, ordered by faces.
#[derive(Debug, Clone, Default)]
pub struct FaceIntersections {
    segments: Vec<Intersection>,
    too_crowded: bool,
}

/// Edges that a task takes.
const EDGES_PER_TASK: usize = 256;

/// Faces that all edges may look at beyond [`FACES_PER_EDGE`] each: some ten seconds of work on one core.
const MOST_FACES: u64 = 100_000_000;

/// Faces near an edge of an ordinary surface.
const FACES_PER_EDGE: u64 = 64;

/// Most meetings of an edge and a face, beyond one per edge: they take 32 bytes each, and as much again for each face at
/// the edge.
const MOST_MEETINGS: u64 = 2_000_000;

impl FaceIntersections {
    /// The segments; none where there are [too many](Self::is_too_crowded).
    pub fn as_slice(&self) -> &[Intersection] {
        &self.segments
    }

    /// Whether so many faces lie in one place, or pass through each other, that they were not all looked at.
    pub fn is_too_crowded(&self) -> bool {
        self.too_crowded
    }

    /// Finds all segments. O(E log F + segments log segments), parallel.
    fn find(
        mesh: &PreparedMesh,
        topology: &Topology,
        tree: &FaceTree,
        progress: &dyn Progress,
    ) -> Result<Self, Cancelled> {
        let edges: Vec<EdgeId> = topology.edges().ids().collect();
        progress.stage("intersections", edges.len() as u64);
        let (looked_at, met) = (AtomicU64::new(0), AtomicU64::new(0));
        let most_faces = MOST_FACES + FACES_PER_EDGE * edges.len() as u64;
        let most_meetings = MOST_MEETINGS + edges.len() as u64;
        let is_crowded =
            || looked_at.load(Ordering::Relaxed) > most_faces || met.load(Ordering::Relaxed) > most_meetings;
        let meetings = |edges: &[EdgeId]| -> Result<Vec<Meeting>, Cancelled> {
            progress.check()?;
            let mut found = Vec::new();
            for &edge in edges {
                if is_crowded() {
                    break;
                }
                let before = found.len();
                looked_at.fetch_add(meetings_of(mesh.mesh(), topology, tree, edge, &mut found), Ordering::Relaxed);
                met.fetch_add((found.len() - before) as u64, Ordering::Relaxed);
            }
            progress.advance(edges.len() as u64);
            Ok(found)
        };
        let found: Result<Vec<_>, Cancelled> = edges.par_chunks(EDGES_PER_TASK).map(meetings).collect();
        let found = found?;
        if is_crowded() {
            return Ok(Self { segments: Vec::new(), too_crowded: true });
        }
        let mut found = found.concat();
        found.sort_unstable_by_key(|meeting| (meeting.edge, meeting.face, meeting.vertex));
        progress.check()?;
        Ok(Self { segments: segments(mesh.mesh(), topology, &found), too_crowded: false })
    }
}

/// Where an edge passes through a face, or ends on it.
#[derive(Clone, Copy)]
struct Meeting {
    edge: EdgeId,
    face: FaceId,
    /// The vertex that lies on the face, where it is not the edge's inside that meets it.
    vertex: Option<u32>,
    place: Vec3,
}

/// Appends the meetings of an edge; yields how many faces were looked at.
fn meetings_of(
    mesh: &TriangleMesh,
    topology: &Topology,
    tree: &FaceTree,
    edge: EdgeId,
    found: &mut Vec<Meeting>,
) -> u64 {
    let vertices = topology.edges()[edge];
    let ends = vertices.map(|vertex| mesh.positions()[vertex as usize]);
    let mut looked_at = 0;
    tree.faces_at(ends, vertices, |Candidate { face, vertices: around, may_hold }| {
        looked_at += 1;
        if vertices.iter().any(|vertex| around.contains(vertex)) {
            return;
        }
        let corners = mesh.corners(face);
        if let Some(passage) = passage(ends, corners) {
            let place = ends[0].as_dvec3().lerp(ends[1].as_dvec3(), passage.t).as_vec3();
            found.push(Meeting { edge, face, vertex: None, place });
        }
        for (end, (vertex, place)) in vertices.into_iter().zip(ends).enumerate() {
            if may_hold[end] && holds(corners, place) {
                found.push(Meeting { edge, face, vertex: Some(vertex), place });
            }
        }
    });
    looked_at
}

/// Whether two faces lie in one plane, in which they have no line of intersection.
fn are_coplanar(mesh: &TriangleMesh, [one, other]: [FaceId; 2]) -> bool {
    let [a, b, c] = mesh.corners(one);
    mesh.corners(other).iter().all(|&corner| orientation(a, b, c, corner) == 0.0)
}

fn segments(mesh: &TriangleMesh, topology: &Topology, meetings: &[Meeting]) -> Vec<Intersection> {
    let mut ends: Vec<([FaceId; 2], IntersectionEnd)> = Vec::with_capacity(2 * meetings.len());
    for (index, &Meeting { edge, face, vertex, place }) in meetings.iter().enumerate() {
        let id = vertex.unwrap_or((mesh.vertex_count() + index) as u32);
        let end = IntersectionEnd { place, id };
        ends.extend(topology.faces(edge).map(|other| ([other.min(face), other.max(face)], end)));
    }
    ends.par_sort_by_key(|(faces, end)| (*faces, end.id));
    ends.dedup_by_key(|(faces, end)| (*faces, end.id));
    let of_pairs: Vec<&[([FaceId; 2], IntersectionEnd)]> = ends.chunk_by(|one, other| one.0 == other.0).collect();
    of_pairs.par_iter().with_min_len(64).filter_map(|of_pair| segment(mesh, topology, of_pair)).collect()
}

/// The segment of two faces that have these ends in common.
fn segment(
    mesh: &TriangleMesh,
    topology: &Topology,
    of_pair: &[([FaceId; 2], IntersectionEnd)],
) -> Option<Intersection> {
    let faces = of_pair[0].0;
    let [one, other] = faces.map(|face| mesh.triangles()[face.index()]);
    let shared = one.into_iter().find(|vertex| other.contains(vertex));
    let shared = shared.map(|id| IntersectionEnd { place: mesh.positions()[id as usize], id });
    // More than two where an edge passes exactly through a rim: the farthest two.
    let ends: Vec<IntersectionEnd> = of_pair.iter().map(|(_, end)| *end).chain(shared).collect();
    let mut best: Option<(f64, [IntersectionEnd; 2])> = None;
    for (index, &one) in ends.iter().enumerate() {
        for &other in &ends[index + 1..] {
            let distance = one.place.as_dvec3().distance_squared(other.place.as_dvec3());
            if distance > best.map_or(0.0, |(longest, _)| longest) {
                best = Some((distance, [one, other]));
            }
        }
    }
    let (_, ends) = best?;
    (!are_coplanar(mesh, faces) && pass_through(mesh, topology, faces)).then_some(Intersection { ends, faces })
}

impl Artefact for FaceIntersections {
    const NAME: &'static str = "face-intersections";

    fn build(mesh: &PreparedMesh, progress: &dyn Progress) -> Result<Self, Cancelled> {
        let topology = mesh.artefact::<Topology>(Self::NAME, progress)?;
        let tree = mesh.artefact::<FaceTree>(Self::NAME, progress)?;
        Self::find(mesh, &topology, &tree, progress)
    }

    fn bytes(&self) -> usize {
        size_of_val(self.segments.as_slice())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::{NoProgress, shapes};
    use std::collections::BTreeMap;

    fn intersections(mesh: TriangleMesh) -> FaceIntersections {
        let mesh = PreparedMesh::new(mesh);
        FaceIntersections::clone(&mesh.artefact::<FaceIntersections>("test", &NoProgress).unwrap())
    }

    /// A mesh and its copy moved by `offset`.
    fn twice(mesh: &TriangleMesh, offset: Vec3) -> TriangleMesh {
        let count = mesh.vertex_count() as u32;
        let copies = [Vec3::ZERO, offset].into_iter();
        let positions = copies.flat_map(|by| mesh.positions().iter().map(move |&position| position + by)).collect();
        let again = mesh.triangles().iter().map(|corners| corners.map(|corner| corner + count));
        TriangleMesh::new(positions, mesh.triangles().iter().copied().chain(again).collect()).unwrap()
    }

    #[test]
    fn two_cubes_intersect_in_one_closed_line() {
        let cube = shapes::by_name("cube").unwrap();
        let size = cube.bounds().unwrap().max.x - cube.bounds().unwrap().min.x;
        let both = twice(&cube, Vec3::new(0.31, 0.42, 0.53) * size as f32);
        let found = intersections(both.clone());
        let mut degree = BTreeMap::<u32, usize>::new();
        found
            .as_slice()
            .iter()
            .flat_map(|segment| segment.ends)
            .for_each(|end| *degree.entry(end.id).or_default() += 1);
        assert!(degree.values().all(|&count| count == 2), "{degree:?}");
        let length: f32 =
            found.as_slice().iter().map(|segment| segment.ends[0].place.distance(segment.ends[1].place)).sum();
        let expected = 2.0 * (3.0 - 0.31 - 0.42 - 0.53) * size as f32;
        assert!((length / expected - 1.0).abs() < 1e-5, "{length} {expected}");
        assert_eq!(intersections(cube).as_slice().len(), 0);
    }

    #[test]
    fn a_vertex_on_a_face_ends_segments_of_its_faces() {
        let face = [[0, 0, 0], [8, 0, 0], [0, 8, 0]];
        // A pyramid through the face, of which one base vertex lies on it.
        let pyramid = [[1, 1, 0], [4, 1, -1], [1, 4, -1], [2, 2, 3]];
        let positions = face.into_iter().chain(pyramid).map(|p: [i32; 3]| Vec3::from(p.map(|c| c as f32))).collect();
        let triangles = vec![[0, 1, 2], [3, 4, 6], [4, 5, 6], [5, 3, 6], [3, 5, 4]];
        let found = intersections(TriangleMesh::new(positions, triangles).unwrap());
        let mut degree = BTreeMap::<u32, usize>::new();
        found
            .as_slice()
            .iter()
            .flat_map(|segment| segment.ends)
            .for_each(|end| *degree.entry(end.id).or_default() += 1);
        assert_eq!((found.as_slice().len(), degree.get(&3)), (3, Some(&2)), "{found:?}");
        assert!(degree.values().all(|&count| count == 2), "{degree:?}");
    }

    #[test]
    fn faces_that_share_a_vertex_intersect_from_there() {
        let positions = [[0, 0, 0], [4, 0, 0], [0, 4, 0], [2, 2, -3], [2, 2, 5]];
        let positions = positions.map(|p: [i32; 3]| Vec3::from(p.map(|c| c as f32))).to_vec();
        let found = intersections(TriangleMesh::new(positions, vec![[0, 1, 2], [0, 3, 4]]).unwrap());
        assert_eq!(found.as_slice().len(), 1);
        let ends = found.as_slice()[0].ends.map(|end| end.place);
        assert!(ends.contains(&Vec3::ZERO) && ends.contains(&Vec3::new(2.0, 2.0, 0.0)), "{ends:?}");
    }
}
