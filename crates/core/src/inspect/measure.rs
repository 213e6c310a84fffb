//! Sizes: extent, edge lengths, angles.

use super::Sides;
use super::faces::has_zero_area;
use crate::id::{EdgeId, FaceId};
use crate::mesh::TriangleMesh;
use glam::{DVec3, Vec3};
use rayon::prelude::*;

/// Axis-aligned box around the vertices that faces use, in the coordinates of the mesh's file.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct Extent {
    /// Smallest coordinates.
    pub min: [f64; 3],
    /// Largest coordinates.
    pub max: [f64; 3],
    /// Length of the diagonal.
    pub diagonal: f64,
}

/// Lengths of the edges, in object units.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct EdgeLengths {
    /// Sum.
    pub total: f64,
    /// Shortest.
    pub min: f64,
    /// Mean.
    pub mean: f64,
    /// Longest.
    pub max: f64,
}

/// The sharpest corner.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct SmallestAngle {
    /// The face that has it, the lowest of several.
    pub face: FaceId,
    /// The angle between two of its sides, above 0 to 60 degrees.
    pub angle_deg: f64,
}

/// Elements summed up at a time. Fixed, so that sums do not depend on how rayon splits the work.
const CHUNK: usize = 1 << 14;

impl Extent {
    pub(super) fn of(mesh: &TriangleMesh) -> Option<Self> {
        let bounds = mesh.bounds()?;
        let diagonal = bounds.min.distance(bounds.max);
        let [min, max] = [bounds.min, bounds.max].map(|corner| mesh.in_file(corner.as_vec3()).to_array());
        Some(Self { min, max, diagonal })
    }
}

impl EdgeLengths {
    pub(super) fn of(sides: Sides) -> Option<Self> {
        let edges = sides.topology.edge_count();
        let chunks: Vec<_> = (0..edges.div_ceil(CHUNK))
            .into_par_iter()
            .map(|chunk| {
                let range = chunk * CHUNK..((chunk + 1) * CHUNK).min(edges);
                let counted = range.map(EdgeId::from_usize).filter(|&edge| !sides.is_collapsed(edge));
                counted.map(|edge| Sum::of(sides.length(edge))).fold(Sum::EMPTY, Sum::add)
            })
            .collect();
        let Sum { count, total, min, max } = chunks.into_iter().fold(Sum::EMPTY, Sum::add);
        (count > 0).then(|| Self { total, min, mean: total / count as f64, max })
    }
}

#[derive(Clone, Copy)]
struct Sum {
    count: usize,
    total: f64,
    min: f64,
    max: f64,
}

impl Sum {
    const EMPTY: Self = Self { count: 0, total: 0.0, min: f64::INFINITY, max: 0.0 };

    fn of(value: f64) -> Self {
        Self { count: 1, total: value, min: value, max: value }
    }

    fn add(self, other: Self) -> Self {
        Self {
            count: self.count + other.count,
            total: self.total + other.total,
            min: self.min.min(other.min),
            max: self.max.max(other.max),
        }
    }
}

impl SmallestAngle {
    pub(super) fn of(mesh: &TriangleMesh) -> Option<Self> {
        let faces = (0..mesh.face_count() as u32).into_par_iter().map(FaceId::new);
        let angles = faces.filter(|&face| !has_zero_area(mesh.corners(face)));
        let angles = angles.map(|face| Self { face, angle_deg: smallest_angle_deg(mesh, face) });
        angles.reduce_with(|a, b| {
            let order = a.angle_deg.total_cmp(&b.angle_deg).then(a.face.cmp(&b.face));
            if order.is_le() { a } else { b }
        })
    }
}

fn smallest_angle_deg(mesh: &TriangleMesh, face: FaceId) -> f64 {
    let [a, b, c] = mesh.corners(face).map(Vec3::as_dvec3);
    let angle = |at: DVec3, p: DVec3, q: DVec3| {
        let (p, q) = (p - at, q - at);
        p.cross(q).length().atan2(p.dot(q))
    };
    angle(a, b, c).min(angle(b, c, a)).min(angle(c, a, b)).to_degrees()
}
