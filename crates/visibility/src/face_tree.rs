//! [`FaceTree`]: which faces may lie along a line.
//!
//! A bounding volume hierarchy over all faces, built by `obvhs` (parallel locally ordered clustering). It works in `f32`, in
//! a frame of its own in which the scene spans -1 to 1, and what it answers is only a list of candidates; every decision is
//! taken by exact predicates on the mesh itself. No candidate may be missing, so boxes are grown.
//!
//! # Why boxes grown by [`GROWTH`] lose nothing
//!
//! Local coordinates stay below 2, parameters along a ray of unit direction below 8. Rounding the origin to `f32` moves the
//! ray by at most `2^-24 x 2`, rounding the direction by `8 x 2^-24`, the stand-in for components below `2^-23` by
//! `8 x 2^-23`; a slab's parameter comes from a difference and a product, each within `2^-24`, so that its plane appears
//! moved by at most `3 x 2^-24 x 8`. In all below `54 x 2^-24`, a third of the growth.

use crate::candidate::Candidate;
use crate::fan::Fan;
use obvhs::aabb::Aabb;
use obvhs::bvh2::{Bvh2, node::Bvh2Node};
use obvhs::ray::Ray;
use rayon::prelude::*;
use silhouette_core::glam::{DVec3, Vec3, Vec3A};
use silhouette_core::prepared::Artefact;
use silhouette_core::{Cancelled, FaceId, PreparedMesh, Progress, TriangleMesh, Viewpoint};
use silhouette_rays::hierarchy::{Boxed, build};
use std::ops::Range;

/// By how much boxes are grown on every side, in units of half the scene's largest extent. See the [module](self).
const GROWTH: f32 = 1.0e-5;

/// Longest ray in local units: across a scene that spans -1 to 1 on each axis, twice over.
const FAR: f32 = 8.0;

/// Longest side of a segment's box, in local units, for which the faces near the box are asked for instead of those along the
/// segment. They are few then; it takes 7 % off the armadillo's preparation for many views.
const SHORT: f32 = 1.0 / 16.0;

/// Segments that are asked about together, at most, and how much larger than the largest of them they are all together.
const TOGETHER: usize = 16;
const SPREAD: f32 = 4.0;

/// A number from 0 to 1 that looks random. Boxes are grown by different amounts so that of very many faces in one place no two
/// have the same box: the builder pairs nearest neighbours, and would pair but one of equals in a round.
fn spread(face: usize) -> f32 {
    // Knuth's multiplicative hashing.
    f32::from((face as u32).wrapping_mul(2_654_435_769).to_be_bytes()[0]) / f32::from(u8::MAX)
}

/// Faces around a vertex from which on they are a [`Fan`].
const MOST_AROUND_A_VERTEX: u32 = 128;

/// A face with its grown box. What is looked at first of all faces near a line, side by side for those of a leaf.
#[derive(Debug, Clone, Copy)]
struct Leaf {
    min: Vec3,
    face: FaceId,
    max: Vec3,
    vertices: [u32; 3],
}

impl Leaf {
    /// The face as a candidate for a segment, if its box meets that of the segment.
    #[inline]
    fn candidate(&self, segment: &LocalSegment) -> Option<Candidate> {
        let (min, max) = (Vec3A::from(self.min), Vec3A::from(self.max));
        let holds = |point: Vec3A| (min.cmple(point) & max.cmpge(point)).all();
        (min.cmple(segment.high) & max.cmpge(segment.low)).all().then(|| Candidate {
            face: self.face,
            vertices: self.vertices,
            may_hold: segment.ends.map(holds),
        })
    }
}

/// A hierarchy over some faces.
struct Tree {
    bvh: Bvh2,
    /// The faces in the order of the leaves.
    leaves: Vec<Leaf>,
}

/// The places of a leaf's faces in the order of the leaves.
fn places(leaf: &Bvh2Node) -> Range<usize> {
    leaf.first_index as usize..(leaf.first_index + leaf.prim_count) as usize
}

impl Tree {
    fn new(mesh: &TriangleMesh, boxes: &[Boxed], faces: impl Fn(usize) -> FaceId) -> Self {
        let bvh = build(boxes);
        let leaf = |&index: &u32| {
            let (Boxed(Aabb { min, max }), face) = (boxes[index as usize], faces(index as usize));
            Leaf { min: min.into(), face, max: max.into(), vertices: mesh.triangles()[face.index()] }
        };
        let leaves = bvh.primitive_indices.iter().map(leaf).collect();
        Self { bvh, leaves }
    }

    fn bytes(&self) -> usize {
        size_of_val(self.bvh.nodes.as_slice())
            + size_of_val(self.bvh.primitive_indices.as_slice())
            + size_of_val(self.leaves.as_slice())
    }

    /// Visits the faces that a segment may meet: a superset, each face once.
    #[inline]
    fn faces_at(&self, segment: &LocalSegment, visit: &mut impl FnMut(Candidate)) {
        let mut visit_near = |place: usize| self.leaves[place].candidate(segment).into_iter().for_each(&mut *visit);
        match segment.ray {
            Some(ray) if !self.bvh.nodes.is_empty() => self.bvh.ray_traverse_anyhit(ray, |_, place| visit_near(place)),
            _ => self.bvh.aabb_traverse(Aabb::new(segment.low, segment.high), |bvh, node| {
                places(&bvh.nodes[node as usize]).for_each(&mut visit_near);
                true
            }),
        }
    }

    /// The same for several short segments close to each other, with the index of each.
    fn faces_at_all(&self, segments: &[LocalSegment], found: &mut Vec<u32>, visit: &mut impl FnMut(usize, Candidate)) {
        let low = segments.iter().fold(Vec3A::INFINITY, |low, segment| low.min(segment.low));
        let high = segments.iter().fold(Vec3A::NEG_INFINITY, |high, segment| high.max(segment.high));
        found.clear();
        self.bvh.aabb_traverse(Aabb::new(low, high), |bvh, node| {
            found.extend(places(&bvh.nodes[node as usize]).map(|place| place as u32));
            true
        });
        for (index, segment) in segments.iter().enumerate() {
            let candidates = found.iter().filter_map(|&place| self.leaves[place as usize].candidate(segment));
            candidates.for_each(|candidate| visit(index, candidate));
        }
    }
}

/// A segment in local coordinates: its box, and where that is large, the ray along it.
struct LocalSegment {
    ends: [Vec3A; 2],
    low: Vec3A,
    high: Vec3A,
    ray: Option<Ray>,
}

impl LocalSegment {
    fn extent(&self) -> f32 {
        (self.high - self.low).max_element()
    }
}

/// A bounding volume hierarchy over the faces of a mesh. Memory: about 70 bytes per face.
pub struct FaceTree {
    /// All faces but those of fans.
    main: Tree,
    /// Faces around vertices of very many, and a hierarchy over what each fan spans.
    fans: Vec<Fan>,
    over_fans: Bvh2,
    center: DVec3,
    /// Local units per world unit.
    scale: f64,
}

impl FaceTree {
    /// Builds the tree. O(F log F), parallel.
    pub fn new(mesh: &TriangleMesh) -> Self {
        let (min, max) = mesh.bounds().map_or((DVec3::ZERO, DVec3::ZERO), |bounds| (bounds.min, bounds.max));
        let half = ((max - min) * 0.5).max_element();
        let (center, scale) = ((min + max) * 0.5, if half > 0.0 { 1.0 / half } else { 1.0 });
        let local = |vertex: u32| ((mesh.positions()[vertex as usize].as_dvec3() - center) * scale).as_vec3a();
        let grown = |(face, triangle): (usize, &[u32; 3])| {
            let [a, b, c] = triangle.map(local);
            let growth = Vec3A::splat(GROWTH * (1.0 + spread(face)));
            Boxed(Aabb::new(a.min(b).min(c) - growth, a.max(b).max(c) + growth))
        };
        let boxes: Vec<Boxed> = mesh.triangles().par_iter().enumerate().map(grown).collect();
        let [rest, of_fans] = split_fans(mesh);
        let tree_of = |faces: &[u32]| {
            let boxes: Vec<Boxed> = faces.iter().map(|&face| boxes[face as usize]).collect();
            Tree::new(mesh, &boxes, |index| FaceId::new(faces[index]))
        };
        let main = match &rest {
            None => Tree::new(mesh, &boxes, FaceId::from_usize),
            Some(rest) => tree_of(&rest.iter().map(|&(_, face)| face).collect::<Vec<_>>()),
        };
        let of_fans = of_fans.unwrap_or_default();
        let by_vertex: Vec<&[(u32, u32)]> = of_fans.chunk_by(|one, other| one.0 == other.0).collect();
        let fan_of = |fan: &&[(u32, u32)]| {
            let bounds =
                fan.iter().map(|&(_, face)| boxes[face as usize].0).fold(Aabb::INVALID, |all, one| all.union(&one));
            let faces: Vec<FaceId> = fan.iter().map(|&(_, face)| FaceId::new(face)).collect();
            (Fan::new(mesh, fan[0].0, &faces), Boxed(bounds))
        };
        let (fans, spans): (Vec<Fan>, Vec<Boxed>) = by_vertex.par_iter().map(fan_of).unzip();
        let over_fans = build(&spans);
        Self { main, fans, over_fans, center, scale }
    }

    /// Visits the faces that may lie between `from` and the viewer: a superset, in no particular order, each face once.
    pub fn faces_toward(&self, viewpoint: &Viewpoint, from: DVec3, mut visit: impl FnMut(FaceId)) {
        let (toward, reach) = match *viewpoint {
            Viewpoint::Perspective { eye } => (eye.as_dvec3() - from, true),
            Viewpoint::Orthographic { toward_viewer } => (toward_viewer.as_dvec3(), false),
        };
        let Some(ray) = self.ray(from, toward, reach) else { return };
        if !self.main.bvh.nodes.is_empty() {
            self.main.bvh.ray_traverse_anyhit(ray, |_, place| visit(self.main.leaves[place].face));
        }
        if !self.fans.is_empty() {
            let (end, mut found) =
                (if reach { toward } else { toward.normalize() * (f64::from(FAR) / self.scale) }, Vec::new());
            self.over_fans.ray_traverse_anyhit(ray, |_, place| {
                let fan = &self.fans[self.over_fans.primitive_indices[place] as usize];
                fan.faces_along([from, from + end], &mut found, &mut |candidate| visit(candidate.face));
            });
        }
    }

    /// Visits the faces that a segment may meet: a superset, each face once. Of very many faces around a vertex at one of its
    /// ends, only those are visited that it may meet at the other end.
    pub fn faces_at(&self, ends: [Vec3; 2], vertices: [u32; 2], mut visit: impl FnMut(Candidate)) {
        let segment = self.segment(ends);
        self.main.faces_at(&segment, &mut visit);
        self.fan_faces_at(ends, vertices, &segment, &mut visit);
    }

    /// The same for many segments, each given as its ends and its vertices: calls with the index of the segment. Faster where
    /// segments that follow each other are close to each other.
    pub fn faces_at_each(&self, segments: &[([Vec3; 2], [u32; 2])], mut visit: impl FnMut(usize, Candidate)) {
        let local: Vec<LocalSegment> = segments.iter().map(|&(ends, _)| self.segment(ends)).collect();
        let (mut begin, mut found) = (0, Vec::new());
        while begin < local.len() {
            // As many as together are not much larger than the largest.
            let (mut low, mut high, mut largest) = (local[begin].low, local[begin].high, local[begin].extent());
            let mut end = begin + 1;
            while end < local.len().min(begin + TOGETHER) && largest.max(local[end].extent()) <= SHORT {
                let (next_low, next_high) = (low.min(local[end].low), high.max(local[end].high));
                largest = largest.max(local[end].extent());
                if (next_high - next_low).max_element() > SPREAD * largest {
                    break;
                }
                (low, high, end) = (next_low, next_high, end + 1);
            }
            if end - begin == 1 {
                self.main.faces_at(&local[begin], &mut |candidate| visit(begin, candidate));
            } else {
                let visit = &mut |index, candidate| visit(begin + index, candidate);
                self.main.faces_at_all(&local[begin..end], &mut found, visit);
            }
            begin = end;
        }
        for (index, &(ends, vertices)) in segments.iter().enumerate() {
            self.fan_faces_at(ends, vertices, &local[index], &mut |candidate| visit(index, candidate));
        }
    }

    /// Visits the faces of fans that a segment may meet.
    fn fan_faces_at(
        &self,
        [a, b]: [Vec3; 2],
        vertices: [u32; 2],
        segment: &LocalSegment,
        visit: &mut impl FnMut(Candidate),
    ) {
        if self.fans.is_empty() {
            return;
        }
        let mut found = Vec::new();
        self.over_fans.aabb_traverse(Aabb::new(segment.low, segment.high), |over, node| {
            for place in places(&over.nodes[node as usize]) {
                let fan = &self.fans[over.primitive_indices[place] as usize];
                // Its faces meet an edge that ends in its vertex there, and may hold the other end.
                let ends = match vertices.iter().position(|&end| end == fan.vertex()) {
                    None => [a, b],
                    Some(end) => [[a, b][1 - end]; 2],
                };
                fan.faces_along(ends.map(Vec3::as_dvec3), &mut found, visit);
            }
            true
        });
    }

    /// A number that is often close for points that are close to each other: their place on a curve through all of the scene
    /// (Morton 1966).
    pub fn key_of_place(&self, point: DVec3) -> u32 {
        let steps =
            ((self.local(point).clamp(Vec3A::NEG_ONE, Vec3A::ONE) + 1.0) * 511.5).to_array().map(|step| step as u32);
        let spread = |step: u32| (0..10).fold(0, |key, bit| key | (step >> bit & 1) << (3 * bit));
        spread(steps[0]) | spread(steps[1]) << 1 | spread(steps[2]) << 2
    }

    /// The largest extent of the scene along an axis, in world units, or somewhat more; 2 for a scene that has none.
    pub fn extent(&self) -> f64 {
        2.0 / self.scale
    }

    fn local(&self, point: DVec3) -> Vec3A {
        ((point - self.center) * self.scale).as_vec3a()
    }

    fn segment(&self, [a, b]: [Vec3; 2]) -> LocalSegment {
        let ends = [a, b].map(|end| self.local(end.as_dvec3()));
        let (low, high) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
        let is_long = (high - low).max_element() > SHORT;
        let ray = if is_long { self.ray(a.as_dvec3(), b.as_dvec3() - a.as_dvec3(), true) } else { None };
        LocalSegment { ends, low, high, ray }
    }

    fn ray(&self, from: DVec3, direction: DVec3, to_its_end: bool) -> Option<Ray> {
        let (origin, length) = (self.local(from), direction.length());
        let end = if to_its_end { (length * self.scale) as f32 * (1.0 + 1e-5) + 2.0 * GROWTH } else { FAR };
        (length > 0.0 && length.is_finite() && origin.is_finite())
            .then(|| Ray::new(origin, (direction / length).as_vec3a(), 0.0, end.min(FAR)))
    }
}

/// Vertices with faces.
type Fans = Vec<(u32, u32)>;

/// The faces that belong to no vertex of very many, and those that do, each with the vertex, ascending; nothing where there is
/// no such vertex. O(F).
fn split_fans(mesh: &TriangleMesh) -> [Option<Fans>; 2] {
    let mut around = vec![0_u32; mesh.vertex_count()];
    mesh.triangles().iter().flatten().for_each(|&vertex| around[vertex as usize] += 1);
    if around.iter().all(|&faces| faces < MOST_AROUND_A_VERTEX) {
        return [None, None];
    }
    let (mut rest, mut of_fans): (Fans, Fans) = Default::default();
    for (face, corners) in (0..).zip(mesh.triangles()) {
        let fullest = corners.iter().copied().max_by_key(|&vertex| (around[vertex as usize], vertex)).unwrap_or(0);
        let is_fan = around[fullest as usize] >= MOST_AROUND_A_VERTEX;
        if is_fan { of_fans.push((fullest, face)) } else { rest.push((0, face)) }
    }
    of_fans.sort_unstable();
    [Some(rest), Some(of_fans)]
}

impl Artefact for FaceTree {
    const NAME: &'static str = "face-tree";

    fn build(mesh: &PreparedMesh, progress: &dyn Progress) -> Result<Self, Cancelled> {
        progress.check()?;
        progress.stage("face tree", 1);
        let tree = Self::new(mesh.mesh());
        progress.advance(1);
        Ok(tree)
    }

    fn bytes(&self) -> usize {
        self.main.bytes() + self.fans.iter().map(Fan::bytes).sum::<usize>()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::piercing::passage;
    use proptest::prelude::*;

    proptest! {
        /// Any face that a segment truly passes near the middle of is among the candidates, at any scale and offset.
        #[test]
        fn no_face_on_a_line_is_missing(
            corners in prop::collection::vec(prop::array::uniform3(-100_i32..100), 3..60),
            weights in prop::array::uniform3(1_u32..10),
            from in prop::array::uniform3(-300_i32..300),
            exponent in -60..60, offset in -1000_i32..1000,
        ) {
            let scale = 2.0_f32.powi(exponent);
            let point = |p: [i32; 3]| Vec3::from(p.map(|c| (c + offset) as f32)) * scale;
            let positions: Vec<Vec3> = corners.iter().map(|&p| point(p)).collect();
            let faces = positions.len() as u32 / 3;
            let triangles: Vec<[u32; 3]> = (0..faces).map(|face| [0, 1, 2].map(|slot| 3 * face + slot)).collect();
            let mesh = TriangleMesh::new(positions, triangles).unwrap();
            let tree = FaceTree::new(&mesh);
            let from = point(from);
            let sum = f64::from(weights.iter().sum::<u32>());
            for face in 0..faces as usize {
                let [a, b, c] = mesh.triangles()[face].map(|v| mesh.positions()[v as usize].as_dvec3());
                let inside = (a * f64::from(weights[0]) + b * f64::from(weights[1]) + c * f64::from(weights[2])) / sum;
                let beyond = inside + (inside - from.as_dvec3()) * 0.01;
                let mut seen = Vec::new();
                tree.faces_toward(&Viewpoint::Perspective { eye: from }, beyond, |f| seen.push(f.index()));
                if inside != from.as_dvec3() {
                    prop_assert!(seen.contains(&face), "face {face} is not between {beyond} and {from}");
                }
            }
        }
    }

    /// A fan of slivers around one vertex, and an edge from there to the middle of one.
    #[test]
    fn an_edge_at_a_vertex_of_many_faces_looks_at_few_of_them() {
        let count = 500_u32;
        let rim = |index: u32| {
            let angle = index as f32 / count as f32 * std::f32::consts::TAU;
            Vec3::new(angle.cos(), angle.sin(), 0.0)
        };
        let end = (Vec3::Z + rim(7) + rim(8)) / 3.0;
        let positions = std::iter::once(Vec3::Z).chain((0..count).map(rim)).chain([end]).collect();
        let fan = (0..count).map(|index| [0, 1 + index, 1 + (index + 1) % count]);
        let triangles = fan.chain([[0, count + 1, count + 1]]).collect();
        let tree = FaceTree::new(&TriangleMesh::new(positions, triangles).unwrap());
        let visited = |ends: [Vec3; 2], vertices| {
            let mut faces = Vec::new();
            tree.faces_at(ends, vertices, |candidate| faces.push(candidate.face.get()));
            faces
        };
        assert!(visited([Vec3::Z, rim(3)], [0, 4]).len() < 20, "only those at the rim");
        assert!(visited([Vec3::Z, end], [0, count + 1]).contains(&7), "that on which it ends");
        assert!(
            visited([Vec3::Z, rim(3)], [count + 5, 4]).len() > 400,
            "all, for one that only begins in the same place"
        );
        let across = visited([Vec3::new(0.5, 0.0, 0.0), Vec3::new(0.5, 0.0, 2.0)], [u32::MAX; 2]);
        assert!((1..20).contains(&across.len()), "{across:?}");
    }

    proptest! {
        /// Any face that a segment between vertices passes through is among the candidates.
        #[test]
        fn no_face_that_a_segment_passes_through_is_missing(
            corners in prop::collection::vec(prop::array::uniform3(-20_i32..20), 3..60),
            exponent in -60..60, offset in -1000_i32..1000,
        ) {
            let scale = 2.0_f32.powi(exponent);
            let positions: Vec<Vec3> =
                corners.iter().map(|&p| Vec3::from(p.map(|c| (c + offset) as f32)) * scale).collect();
            let faces = positions.len() as u32 / 3;
            let triangles: Vec<[u32; 3]> = (0..faces).map(|face| [0, 1, 2].map(|slot| 3 * face + slot)).collect();
            let mesh = TriangleMesh::new(positions.clone(), triangles).unwrap();
            let tree = FaceTree::new(&mesh);
            let segments: Vec<_> = positions.windows(2).map(|pair| ([pair[0], pair[1]], [u32::MAX; 2])).collect();
            let mut together = vec![Vec::new(); segments.len()];
            tree.faces_at_each(&segments, |index, candidate| together[index].push(candidate.face));
            for (&(ends, vertices), together) in segments.iter().zip(&together) {
                let mut alone = Vec::new();
                tree.faces_at(ends, vertices, |candidate| alone.push(candidate.face));
                for face in (0..faces).map(FaceId::new).filter(|&face| passage(ends, mesh.corners(face)).is_some()) {
                    prop_assert!(alone.contains(&face) && together.contains(&face));
                }
            }
        }
    }

    #[test]
    fn an_empty_mesh_has_no_candidates() {
        let tree = FaceTree::new(&TriangleMesh::new(Vec::new(), Vec::new()).unwrap());
        tree.faces_at([Vec3::ZERO, Vec3::ONE], [0, 1], |_| panic!("no face"));
    }
}
