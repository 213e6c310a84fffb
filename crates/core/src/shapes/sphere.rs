//! The sphere, tessellated evenly (geodesic) or by latitude and longitude.

use super::builtin::{ArgumentSpec, Builtin, ShapeError};
use super::{ellipsoid::Ellipsoid, finish};
use crate::mesh::TriangleMesh;
use glam::DVec3;
use rayon::prelude::*;

/// A sphere about the origin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sphere {
    /// Radius, 0.01 to 100. Default: 1.
    pub radius: f64,
}

pub(super) static ICOSPHERE: Builtin = Builtin {
    name: "icosphere",
    summary: "A sphere of 20*4^level nearly equilateral faces: the standard scene for smooth outlines.",
    arguments: &[
        ArgumentSpec::count("level", "subdivisions of the icosahedron", [0, 10], 4),
        ArgumentSpec::length("radius", "radius", 1.0),
    ],
    genus: Some(0),
    build: |values| Sphere { radius: values[1] }.icosphere(values[0] as u32),
    contour: Some(|values| Ok(Box::new(Sphere { radius: values[1] }))),
};

pub(super) static UV_SPHERE: Builtin = Builtin {
    name: "uv-sphere",
    summary: "A sphere by latitude and longitude: needle faces and vertices of high degree at the poles.",
    arguments: &[
        ArgumentSpec::count("segments", "faces around", [3, 8192], 96),
        ArgumentSpec::count("bands", "bands from pole to pole", [2, 8192], 48),
        ArgumentSpec::length("radius", "radius", 1.0),
    ],
    genus: Some(0),
    build: |values| Sphere { radius: values[2] }.uv_mesh(values[0] as u32, values[1] as u32),
    contour: Some(|values| Ok(Box::new(Sphere { radius: values[2] }))),
};

impl Default for Sphere {
    fn default() -> Self {
        Self { radius: 1.0 }
    }
}

impl Sphere {
    /// The icosahedron subdivided `level` times (0 to 10), each new vertex pushed out to the sphere: 20 * 4^level faces.
    /// The children of face f are the faces 4f to 4f + 3; earlier vertices keep their ids.
    ///
    /// # Errors
    /// [`ShapeError`] where an argument is out of range.
    pub fn icosphere(&self, level: u32) -> Result<TriangleMesh, ShapeError> {
        ICOSPHERE.check(&[f64::from(level), self.radius], 20 << (2 * level.min(10)))?;
        let geodesic = (0..level).fold(Geodesic::icosahedron(), |coarse, _| coarse.subdivide());
        let positions = geodesic.directions.par_iter().map(|&direction| (direction * self.radius).as_vec3()).collect();
        let triangles = geodesic.faces.par_iter().map(|face| face.vertices).collect();
        Ok(finish(positions, triangles))
    }

    /// `segments` (3 to 8192) faces around and `bands` (2 to 8192) from pole to pole: 2 * segments * (bands - 1) faces.
    ///
    /// # Errors
    /// [`ShapeError`] where an argument is out of range or there would be too many faces.
    pub fn uv_mesh(&self, segments: u32, bands: u32) -> Result<TriangleMesh, ShapeError> {
        let faces = super::revolution::face_count(segments, bands.saturating_sub(1));
        UV_SPHERE.check(&[f64::from(segments), f64::from(bands), self.radius], faces)?;
        Ellipsoid { semi_axes: [self.radius; 3] }.mesh(segments, bands)
    }
}

/// A triangulated unit sphere that knows the edges of its faces, so that subdividing needs no search: the new vertex,
/// edges and faces all have ids in closed form.
struct Geodesic {
    directions: Vec<DVec3>,
    edges: Vec<[u32; 2]>,
    faces: Vec<GeodesicFace>,
}

/// `edges[i]` runs between `vertices[i]` and `vertices[(i + 1) % 3]`, in either direction.
#[derive(Clone, Copy)]
struct GeodesicFace {
    vertices: [u32; 3],
    edges: [u32; 3],
}

impl Geodesic {
    fn icosahedron() -> Self {
        // Vertices: two poles and two rings of five, the upper ring turned by half a step; rings lie at
        // the heights +-1/sqrt(5).
        let height = 1.0 / 5.0_f64.sqrt();
        let ring = |i: u32, half_steps: u32, y: f64| {
            super::around_y(super::turn(2 * i + half_steps, 10)) * (2.0 * height) + DVec3::Y * y
        };
        let mut directions = vec![DVec3::NEG_Y];
        directions.extend((0..5).map(|i| ring(i, 0, -height)));
        directions.extend((0..5).map(|i| ring(i, 1, height)));
        directions.push(DVec3::Y);

        let (lower, upper) = (|i: u32| 1 + i % 5, |i: u32| 6 + i % 5);
        let triangles = (0..5).flat_map(|i| {
            [
                [0, lower(i + 1), lower(i)],
                [lower(i), lower(i + 1), upper(i)],
                [upper(i), lower(i + 1), upper(i + 1)],
                [upper(i), upper(i + 1), 11],
            ]
        });
        let mut edges: Vec<[u32; 2]> = Vec::with_capacity(30);
        let mut edge_of = |a: u32, b: u32| {
            let known = edges.iter().position(|&edge| edge == [a, b] || edge == [b, a]);
            known.unwrap_or_else(|| {
                edges.push([a, b]);
                edges.len() - 1
            }) as u32
        };
        let faces = triangles
            .map(|vertices| {
                let [a, b, c] = vertices;
                GeodesicFace { vertices, edges: [edge_of(a, b), edge_of(b, c), edge_of(c, a)] }
            })
            .collect();
        Self { directions, edges, faces }
    }

    /// Splits every face in four. The middle of edge e becomes vertex V + e, its halves the edges 2e and 2e + 1; the
    /// three edges inside face f are 2E + 3f to 2E + 3f + 2.
    fn subdivide(self) -> Self {
        let (vertices, edges) = (self.directions.len() as u32, self.edges.len() as u32);
        let middle = |edge: u32| vertices + edge;
        let half = |edge: u32, end: u32| 2 * edge + u32::from(self.edges[edge as usize][0] != end);

        let mut directions = self.directions.clone();
        directions.par_extend(
            self.edges
                .par_iter()
                .map(|&[a, b]| (self.directions[a as usize] + self.directions[b as usize]).normalize()),
        );
        let mut fine_edges: Vec<[u32; 2]> =
            (0..edges).into_par_iter().flat_map_iter(|e| self.edges[e as usize].map(|end| [end, middle(e)])).collect();
        fine_edges.par_extend(self.faces.par_iter().flat_map_iter(|face| {
            let [ab, bc, ca] = face.edges.map(middle);
            [[ca, ab], [ab, bc], [bc, ca]]
        }));
        let faces = (0..self.faces.len() as u32)
            .into_par_iter()
            .flat_map_iter(|f| {
                let GeodesicFace { vertices: [a, b, c], edges: [e0, e1, e2] } = self.faces[f as usize];
                let [ab, bc, ca] = [e0, e1, e2].map(middle);
                let [at_a, at_b, at_c] = [0, 1, 2].map(|corner| 2 * edges + 3 * f + corner);
                [
                    GeodesicFace { vertices: [a, ab, ca], edges: [half(e0, a), at_a, half(e2, a)] },
                    GeodesicFace { vertices: [ab, b, bc], edges: [half(e0, b), half(e1, b), at_b] },
                    GeodesicFace { vertices: [ca, bc, c], edges: [at_c, half(e1, c), half(e2, c)] },
                    GeodesicFace { vertices: [ab, bc, ca], edges: [at_b, at_c, at_a] },
                ]
            })
            .collect();
        Self { directions, edges: fine_edges, faces }
    }
}
