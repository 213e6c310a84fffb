//! Silhouette edges by unbounded integers alone: the oracle of every method that says it is exact.

use num_bigint::{BigInt, Sign};
use silhouette_core::glam::Vec3;
use silhouette_core::{SilhouetteEdges, Topology, TriangleMesh, Viewpoint};
use std::sync::Arc;

type Point = [BigInt; 3];

/// A 32-bit float in units of the smallest one, without rounding.
fn integer(x: f32) -> BigInt {
    let bits = x.to_bits();
    let exponent = (bits >> 23) & 0xff;
    let fraction = bits & 0x7f_ffff;
    let magnitude =
        if exponent == 0 { BigInt::from(fraction) } else { BigInt::from(fraction | 0x80_0000) << (exponent - 1) };
    if x.is_sign_negative() { -magnitude } else { magnitude }
}

fn point(p: Vec3) -> Point {
    p.to_array().map(integer)
}

fn sub(a: &Point, b: &Point) -> Point {
    std::array::from_fn(|i| &a[i] - &b[i])
}

fn cross(a: &Point, b: &Point) -> Point {
    std::array::from_fn(|i| &a[(i + 1) % 3] * &b[(i + 2) % 3] - &a[(i + 2) % 3] * &b[(i + 1) % 3])
}

/// A mesh as its silhouettes follow from it, in integers.
#[derive(Debug, Clone)]
pub struct IntegerMesh {
    topology: Arc<Topology>,
    /// Normal and first corner of each face.
    planes: Vec<(Point, Point)>,
}

impl IntegerMesh {
    /// The mesh whose topology is given.
    pub fn new(mesh: &TriangleMesh, topology: Arc<Topology>) -> Self {
        let planes = mesh.triangles().iter().map(|triangle| {
            let [a, b, c] = triangle.map(|vertex| point(mesh.positions()[vertex as usize]));
            (cross(&sub(&b, &a), &sub(&c, &a)), a)
        });
        Self { planes: planes.collect(), topology }
    }

    /// Its silhouette edges, by Hall's definition: a face whose plane holds the viewer is back.
    pub fn silhouette_edges(&self, viewpoint: &Viewpoint) -> SilhouetteEdges {
        let front = self.planes.iter().map(|(normal, corner)| {
            let toward_viewer = match *viewpoint {
                Viewpoint::Perspective { eye } => sub(&point(eye), corner),
                Viewpoint::Orthographic { toward_viewer } => point(toward_viewer),
            };
            let side: BigInt = normal.iter().zip(&toward_viewer).map(|(a, b)| a * b).sum();
            side.sign() == Sign::Plus
        });
        let front: Vec<bool> = front.collect();
        let mut edges = SilhouetteEdges::default();
        edges.refill(self.topology.edges().ids().filter(|&edge| {
            let sides: Vec<_> = self.topology.faces(edge).map(|face| front[face.index()]).collect();
            if let [side] = sides[..] { side } else { sides.contains(&true) && sides.contains(&false) }
        }));
        edges
    }
}
