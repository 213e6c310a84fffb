//! The displaced viewer and moved strokes of the crates, with rational numbers in place of infinitesimals.

use crate::exact::rational::{Row, direction, height, plane, point, sum, turned};
use glam::Vec3;
use num_bigint::{BigInt, Sign};
use num_rational::BigRational;
use silhouette_core::{TriangleMesh, Viewpoint};

/// How small what is moved is moved: numbers so far below 1 that no determinant of the coordinates changes its sign.
#[derive(Debug, Clone, Copy)]
pub struct Steps {
    /// Coordinates are multiples of two to minus this.
    pub exponent: u32,
    /// Coordinates times that have at most so many bits.
    pub bits: u32,
}

impl Steps {
    /// For whole and half coordinates below 64.
    pub const WHOLE: Self = Self { exponent: 1, bits: 7 };

    /// Bits of the viewer's step. A determinant of three differences is a whole number below `6 * 2^(3 bits + 3)`, so that
    /// the first of the coefficients that does not vanish outweighs the rest; the 40 bits beyond keep parameters within
    /// `2^-40` of those that the camera's own viewer has.
    fn of_viewer(self) -> u32 {
        3 * self.bits + 8 + 40
    }

    /// Bits of a stroke's step, below the fourth power of the viewer's.
    fn of_stroke(self) -> u32 {
        6 * self.of_viewer()
    }
}

/// A face as the moved viewer sees it.
#[derive(Debug)]
pub struct Seen {
    /// Its corners.
    pub corners: [u32; 3],
    /// Whether it is a front face.
    pub is_front: bool,
    /// The planes through its sides and the viewer, and its own: above all of them lies what it hides.
    bounds: [Row; 4],
}

/// A scene without faces of no area, and its viewer.
pub struct Scene {
    pub points: Vec<Row>,
    pub faces: Vec<Seen>,
    /// Where the camera has the viewer.
    pub camera: Row,
    viewer: Row,
    steps: Steps,
}

/// 1, 0 or -1.
pub fn sign(value: &BigInt) -> i32 {
    match value.sign() {
        Sign::Plus => 1,
        Sign::NoSign => 0,
        Sign::Minus => -1,
    }
}

/// The viewer where the camera has it, and displaced towards `toward` by `2^-step`, in coordinates times `2^exponent`.
pub fn viewers(viewpoint: &Viewpoint, toward: Vec3, exponent: u32, step: u32) -> [Row; 2] {
    let camera = match *viewpoint {
        Viewpoint::Perspective { eye } => point(eye, exponent),
        Viewpoint::Orthographic { toward_viewer } => direction(toward_viewer, exponent),
    };
    let [x, y, z] = Vec3::AXES.map(|axis| direction(axis, 0));
    let power = |power: u32| BigInt::from(1) << (step * power);
    let toward = point(toward, exponent);
    let moved = sum(&[(&camera, power(4)), (&toward, power(3)), (&x, power(2)), (&y, power(1)), (&z, power(0))]);
    [camera, moved]
}

impl Scene {
    /// A mesh from a viewpoint. Panics where a face has no area.
    pub fn new(mesh: &TriangleMesh, viewpoint: &Viewpoint, steps: Steps) -> Self {
        let middle = mesh.bounds().map_or(Vec3::ZERO, |bounds| bounds.center.as_vec3());
        let [camera, viewer] = viewers(viewpoint, middle, steps.exponent, steps.of_viewer());
        let points: Vec<Row> = mesh.positions().iter().map(|&p| point(p, steps.exponent)).collect();
        let face = |&corners: &[u32; 3]| {
            let at = corners.map(|vertex| &points[vertex as usize]);
            let own = plane(at);
            let facing = sign(&height(&own, &viewer));
            assert_ne!(facing, 0, "a face without area");
            let side = |slot: usize| {
                // Above it lies what is to the left of the side, and of a back face what is to its right.
                let plane = plane([at[(slot + 1) % 3], at[slot], &viewer]);
                if facing > 0 { plane } else { turned(&plane) }
            };
            let below = if facing > 0 { turned(&own) } else { own };
            Seen { corners, is_front: facing > 0, bounds: [side(0), side(1), side(2), below] }
        };
        let faces = mesh.triangles().iter().map(face).collect();
        Self { points, faces, camera, viewer, steps }
    }

    /// A vertex.
    pub fn at(&self, vertex: u32) -> &Row {
        &self.points[vertex as usize]
    }

    /// The faces at an edge, each by its third corner.
    pub fn wings(&self, [a, b]: [u32; 2]) -> Vec<u32> {
        let of_face = |face: &Seen| {
            let third = face.corners.into_iter().find(|corner| *corner != a && *corner != b);
            third.filter(|_| face.corners.contains(&a) && face.corners.contains(&b))
        };
        self.faces.iter().filter_map(of_face).collect()
    }

    /// On which side of an edge a point lies, as the moved viewer sees it: 1 to the left.
    pub fn side(&self, [a, b]: [u32; 2], point: u32) -> i32 {
        sign(&height(&plane([self.at(a), self.at(b), self.at(point)]), &self.viewer))
    }

    /// Whether the camera sees three points in line.
    pub fn is_in_line(&self, [a, b, c]: [u32; 3]) -> bool {
        sign(&height(&plane([self.at(a), self.at(b), self.at(c)]), &self.camera)) == 0
    }

    /// Whether the camera sees an edge as a point.
    pub fn is_end_on(&self, [a, b]: [u32; 2]) -> bool {
        Vec3::AXES.iter().all(|&axis| {
            let along = direction(axis, 0);
            sign(&height(&plane([self.at(a), self.at(b), &along]), &self.camera)) == 0
        })
    }

    /// The corner towards which a stroke along an edge is moved: that of the nearest wing on the side of more wings; of
    /// sides with equally many, of that to the left when looking from the end that comes first by its coordinates.
    fn surface(&self, [a, b]: [u32; 2]) -> u32 {
        let [a, b] = if self.at(b) < self.at(a) { [b, a] } else { [a, b] };
        let (left, right): (Vec<u32>, Vec<u32>) =
            self.wings([a, b]).into_iter().partition(|&apex| self.side([a, b], apex) > 0);
        let wings = if left.len() >= right.len() { left } else { right };
        let is_nearer = |one: u32, than: u32| {
            let plane = plane([self.at(a), self.at(b), self.at(than)]);
            sign(&height(&plane, self.at(one))) == sign(&height(&plane, &self.viewer))
        };
        wings.into_iter().reduce(|nearest, apex| if is_nearer(apex, nearest) { apex } else { nearest }).unwrap()
    }

    /// Both ends of an edge, moved towards its surface.
    pub fn stroke(&self, edge: [u32; 2]) -> [Row; 2] {
        let (apex, steps) = (self.at(self.surface(edge)), BigInt::from(1) << self.steps.of_stroke());
        edge.map(|end| sum(&[(self.at(end), &steps - 1), (apex, BigInt::from(1))]))
    }
}

impl Seen {
    /// The parameters between which it hides a stroke.
    pub fn hides(&self, [a, b]: &[Row; 2]) -> Option<[BigRational; 2]> {
        let mut range = [BigRational::from(BigInt::ZERO), BigRational::from(BigInt::from(1))];
        for bound in &self.bounds {
            let (at_a, at_b) = (height(bound, a), height(bound, b));
            let root = || BigRational::new(at_a.clone(), &at_a - &at_b);
            match (sign(&at_a) > 0, sign(&at_b) > 0) {
                (true, true) => {}
                (false, false) => return None,
                (false, true) => range[0] = root().max(range[0].clone()),
                (true, false) => range[1] = root().min(range[1].clone()),
            }
        }
        (range[0] < range[1]).then_some(range)
    }
}
