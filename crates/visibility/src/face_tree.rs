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

use obvhs::aabb::Aabb;
use obvhs::bvh2::{Bvh2, builder::build_bvh2, node::Bvh2Node};
use obvhs::ray::Ray;
use obvhs::{Boundable, BvhBuildParams};
use rayon::prelude::*;
use silhouette_core::glam::{DVec3, Vec3, Vec3A};
use silhouette_core::prepared::Artefact;
use silhouette_core::{Cancelled, FaceId, PreparedMesh, Progress, TriangleMesh, Viewpoint};
use std::time::Duration;

/// By how much boxes are grown on every side, in units of half the scene's largest extent. See the [module](self).
const GROWTH: f32 = 1.0e-5;

/// Longest ray in local units: across a scene that spans -1 to 1 on each axis, twice over.
const FAR: f32 = 8.0;

/// Longest side of a segment's box, in local units, for which the faces near the box are asked for instead of those along the
/// segment. They are few then; it takes 7 % off the armadillo's preparation for many views.
const SHORT: f32 = 1.0 / 16.0;

/// A number from 0 to 1 that looks random. Boxes are grown by different amounts so that of very many faces in one place no two
/// have the same box: the builder pairs nearest neighbours, and would pair but one of equals in a round.
fn spread(face: usize) -> f32 {
    // Knuth's multiplicative hashing.
    f32::from((face as u32).wrapping_mul(2_654_435_769).to_be_bytes()[0]) / f32::from(u8::MAX)
}

/// A bounding volume hierarchy over the faces of a mesh. Memory: about 70 bytes a face.
pub struct FaceTree {
    bvh: Bvh2,
    /// The grown boxes in the order of the leaves, so that those of a leaf lie side by side.
    boxes: Vec<Aabb>,
    center: DVec3,
    /// Local units a world unit.
    scale: f64,
}

/// The places of a leaf's faces in the order of the leaves.
fn places(leaf: &Bvh2Node) -> impl Iterator<Item = usize> + use<> {
    (leaf.first_index..leaf.first_index + leaf.prim_count).map(|place| place as usize)
}

#[derive(Clone, Copy)]
struct FaceBox(Aabb);

impl Boundable for FaceBox {
    fn aabb(&self) -> Aabb {
        self.0
    }
}

impl FaceTree {
    /// Builds the tree. O(F log F), parallel.
    pub fn new(mesh: &TriangleMesh) -> Self {
        let (min, max) = mesh.bounds().map_or((DVec3::ZERO, DVec3::ZERO), |bounds| (bounds.min, bounds.max));
        let half = ((max - min) * 0.5).max_element();
        let (center, scale) = ((min + max) * 0.5, if half > 0.0 { 1.0 / half } else { 1.0 });
        let local = |vertex: u32| ((mesh.positions()[vertex as usize].as_dvec3() - center) * scale).as_vec3a();
        let boxes: Vec<FaceBox> = mesh
            .triangles()
            .par_iter()
            .enumerate()
            .map(|(face, triangle)| {
                let [a, b, c] = triangle.map(local);
                let growth = Vec3A::splat(GROWTH * (1.0 + spread(face)));
                FaceBox(Aabb::new(a.min(b).min(c) - growth, a.max(b).max(c) + growth))
            })
            .collect();
        let bvh = if boxes.is_empty() {
            Bvh2::default()
        } else {
            let mut time = Duration::ZERO;
            build_bvh2(&boxes, BvhBuildParams::fast_build(), &mut time)
        };
        let boxes = bvh.primitive_indices.iter().map(|&face| boxes[face as usize].0).collect();
        Self { bvh, boxes, center, scale }
    }

    /// Visits the faces that may lie between `from` and the viewer: a superset, in no particular order, each face once.
    pub fn faces_toward(&self, viewpoint: &Viewpoint, from: DVec3, mut visit: impl FnMut(FaceId)) {
        let (toward, reach) = match *viewpoint {
            Viewpoint::Perspective { eye } => (eye.as_dvec3() - from, true),
            Viewpoint::Orthographic { toward_viewer } => (toward_viewer.as_dvec3(), false),
        };
        self.along(from, toward, reach, |place| visit(self.face(place)));
    }

    /// Visits the faces that the segment from `a` to `b` may meet: a superset, each face once.
    pub fn faces_at(&self, a: Vec3, b: Vec3, mut visit: impl FnMut(FaceId)) {
        let [from, to] = [a, b].map(|end| self.local(end.as_dvec3()));
        let (low, high) = (from.min(to), from.max(to));
        let mut visit_near = |place: usize| {
            let Aabb { min, max } = self.boxes[place];
            if (min.cmple(high) & max.cmpge(low)).all() {
                visit(self.face(place));
            }
        };
        if (high - low).max_element() > SHORT {
            self.along(a.as_dvec3(), b.as_dvec3() - a.as_dvec3(), true, visit_near);
        } else {
            self.bvh.aabb_traverse(Aabb::new(low, high), |bvh, node| {
                places(&bvh.nodes[node as usize]).for_each(&mut visit_near);
                true
            });
        }
    }

    /// Visits the faces on which a point may lie: a superset, each face once.
    pub fn faces_near(&self, point: Vec3, mut visit: impl FnMut(FaceId)) {
        let local = self.local(point.as_dvec3());
        self.bvh.point_traverse(local, |bvh, node| {
            places(&bvh.nodes[node as usize]).for_each(|place| visit(self.face(place)));
            true
        });
    }

    /// Visits the faces that may meet the line through `from` along `direction`, in both directions without end.
    pub fn faces_on_line(&self, from: DVec3, direction: DVec3, mut visit: impl FnMut(FaceId)) {
        // A ray that begins well outside of the scene.
        let Some(direction) = direction.try_normalize() else { return };
        let begin = from - direction * (f64::from(FAR) * 0.5 / self.scale);
        self.along(begin, direction, false, |place| visit(self.face(place)));
    }

    /// The largest extent of the scene along an axis, in world units, or somewhat more; 2 for a scene that has none.
    pub fn extent(&self) -> f64 {
        2.0 / self.scale
    }

    fn face(&self, place: usize) -> FaceId {
        FaceId::new(self.bvh.primitive_indices[place])
    }

    fn local(&self, point: DVec3) -> Vec3A {
        ((point - self.center) * self.scale).as_vec3a()
    }

    /// Visits the places in the leaves that a ray may meet.
    fn along(&self, from: DVec3, direction: DVec3, to_its_end: bool, mut visit: impl FnMut(usize)) {
        let origin = self.local(from);
        let length = direction.length();
        if self.bvh.nodes.is_empty() || !(length > 0.0 && length.is_finite() && origin.is_finite()) {
            return;
        }
        let end = if to_its_end { (length * self.scale) as f32 * (1.0 + 1e-5) + 2.0 * GROWTH } else { FAR };
        let ray = Ray::new(origin, (direction / length).as_vec3a(), 0.0, end.min(FAR));
        self.bvh.ray_traverse_anyhit(ray, |_, place| visit(place));
    }
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
        size_of_val(self.bvh.nodes.as_slice())
            + size_of_val(self.bvh.primitive_indices.as_slice())
            + size_of_val(self.boxes.as_slice())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
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
                let (mut seen, mut crossed) = (Vec::new(), Vec::new());
                tree.faces_toward(&Viewpoint::Perspective { eye: from }, beyond, |f| seen.push(f.index()));
                tree.faces_on_line(beyond, inside - from.as_dvec3(), |f| crossed.push(f.index()));
                if inside != from.as_dvec3() {
                    prop_assert!(seen.contains(&face), "face {face} is not between {beyond} and {from}");
                    prop_assert!(crossed.contains(&face));
                }
            }
        }
    }

    #[test]
    fn an_empty_mesh_has_no_candidates() {
        let tree = FaceTree::new(&TriangleMesh::new(Vec::new(), Vec::new()).unwrap());
        tree.faces_at(Vec3::ZERO, Vec3::ONE, |_| panic!("no face"));
    }
}
