//! [`Polygons`]: convex polygons over the vertices of a mesh, which fattening takes in place of triangles.

use silhouette_core::TriangleMesh;
use silhouette_core::glam::DVec3;

/// Polygons as lists of corners, counter-clockwise seen from outside.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Polygons {
    /// Vertices, polygon after polygon.
    pub corners: Vec<u32>,
    /// First corner of each polygon, and the number of corners at the end.
    pub starts: Vec<u32>,
}

/// Faces whose normals differ by less than this many radians lie in a plane, as far as 32-bit positions tell.
const PLANE_RAD: f64 = 1e-3;

impl Polygons {
    /// The polygons whose fans the triangles are: readers of polygons fan each one about its first corner, so that
    /// triangles that follow each other, share that corner and an edge, lie in a plane and make a convex whole were one
    /// polygon. No adjacency is looked for. O(F).
    pub fn from_fans(mesh: &TriangleMesh) -> Self {
        let mut polygons = Self { corners: Vec::new(), starts: vec![0] };
        let mut polygon: Vec<u32> = Vec::new();
        for &triangle in mesh.triangles() {
            if !extends(mesh, &polygon, triangle) {
                polygons.push(&polygon);
                polygon.clear();
                polygon.extend(&triangle[..2]);
            }
            polygon.push(triangle[2]);
        }
        polygons.push(&polygon);
        polygons
    }

    /// Number of polygons.
    pub fn count(&self) -> usize {
        self.starts.len() - 1
    }

    /// Bytes on the heap.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.corners[..]) + size_of_val(&self.starts[..])
    }

    fn push(&mut self, polygon: &[u32]) {
        if !polygon.is_empty() {
            self.corners.extend(polygon);
            // A mesh has fewer than 2^32 corners, by validation, and no fan has more than its triangles.
            self.starts.push(self.corners.len() as u32);
        }
    }
}

/// Whether `triangle` is the next of the fan that makes `polygon`, and the whole stays flat and convex.
fn extends(mesh: &TriangleMesh, polygon: &[u32], triangle: [u32; 3]) -> bool {
    let (&[first, second, third, ..], &[.., before_last, last]) = (polygon, polygon) else { return false };
    if triangle[0] != first || triangle[1] != last || polygon.contains(&triangle[2]) {
        return false;
    }
    let at = |vertex: u32| mesh.positions()[vertex as usize].as_dvec3();
    let turn = |a: u32, b: u32, c: u32| (at(b) - at(a)).cross(at(c) - at(b));
    let Some(normal) = turn(first, second, third).try_normalize() else { return false };
    let is_convex = |cross: DVec3| cross.dot(normal) >= 0.0;
    let is_flat = turn(first, last, triangle[2]).try_normalize().is_some_and(|n| n.angle_between(normal) < PLANE_RAD);
    is_flat
        && is_convex(turn(before_last, last, triangle[2]))
        && is_convex(turn(last, triangle[2], first))
        && is_convex(turn(triangle[2], first, second))
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::glam::Vec3;
    use silhouette_core::shapes::{Cuboid, Sphere};

    #[test]
    fn fans_become_the_polygons_that_they_were() {
        let cube = Cuboid::default().mesh().unwrap();
        let polygons = Polygons::from_fans(&cube);
        assert_eq!(polygons.count(), 6);
        assert!(polygons.starts.windows(2).all(|pair| pair[1] - pair[0] == 4));
        let sphere = Sphere::default().icosphere(1).unwrap();
        let polygons = Polygons::from_fans(&sphere);
        assert_eq!((polygons.count(), polygons.corners.len()), (80, 240), "nothing flat to join");
    }

    #[test]
    fn a_fan_that_is_not_convex_stays_apart() {
        let points = [(0.0, 0.0), (2.0, 0.0), (0.5, 0.5), (0.0, 2.0)];
        let positions: Vec<Vec3> = points.iter().map(|&(x, y)| Vec3::new(x, y, 0.0)).collect();
        let dart = |order: [u32; 4]| {
            let triangles = vec![[order[0], order[1], order[2]], [order[0], order[2], order[3]]];
            Polygons::from_fans(&TriangleMesh::new(positions.clone(), triangles).unwrap()).count()
        };
        assert_eq!(dart([0, 1, 2, 3]), 2);
        assert_eq!(Polygons::from_fans(&TriangleMesh::new(vec![], vec![]).unwrap()).count(), 0);
    }
}
