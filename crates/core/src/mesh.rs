//! [`TriangleMesh`]: positions and triangles, validated once, immutable afterwards.

use crate::id::{FaceId, VertexId};
use crate::origin::{common_origin, in_file, origin_between};
use glam::{DVec3, Vec3};

/// Triangles over a list of positions.
///
/// Positions are finite, indices are in range: checked by [`TriangleMesh::new`], so nothing downstream checks again.
/// Everything else is ordinary data: open, non-manifold and inconsistently wound meshes, faces of zero area, faces that
/// name a vertex twice, unreferenced and coincident vertices. Triangles are meant to be counter-clockwise seen from
/// outside, in a right-handed space; units are the file's own. Render normals and texture seams are not part of a mesh,
/// so they never split its topology.
///
/// Object space is the file's, unless the mesh lies far from zero: then its axes are parallel, but positions count from
/// [`origin`](Self::origin).
#[derive(Debug, Clone, PartialEq)]
pub struct TriangleMesh {
    positions: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
    origin: DVec3,
}

/// Why a list of positions and triangles is no mesh.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum MeshError {
    /// A coordinate is NaN or infinite (or too large for 32-bit floats).
    #[error("vertex {vertex} has a coordinate that is not a finite 32-bit float")]
    NotFinite {
        /// The first such vertex.
        vertex: VertexId,
    },
    /// A triangle names a vertex that does not exist.
    #[error("face {face} names vertex {index}, but there are only {vertices} vertices (0 is the first)")]
    IndexOutOfRange {
        /// The first such face.
        face: FaceId,
        /// The index it names.
        index: u32,
        /// How many vertices there are.
        vertices: usize,
    },
    /// More vertices, or half-edges, than 32-bit ids can name.
    #[error("the mesh has {count} {what}; at most {limit} are supported")]
    TooLarge {
        /// `"vertices"` or `"faces"`.
        what: &'static str,
        /// How many there are.
        count: usize,
        /// How many there may be.
        limit: usize,
    },
}

/// Half-edge ids are `3 * face + slot` in 32 bits, and the two highest values mean "no twin".
pub const MAX_FACES: usize = (u32::MAX as usize - 2) / 3;

/// Vertex ids are 32 bits wide.
pub const MAX_VERTICES: usize = u32::MAX as usize;

/// Axis-aligned box and bounding sphere about its centre, in object space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    /// Smallest coordinates.
    pub min: DVec3,
    /// Largest coordinates.
    pub max: DVec3,
    /// Middle of the box.
    pub center: DVec3,
    /// Distance from the centre to the farthest vertex that a triangle uses.
    pub radius: f64,
}

impl Bounds {
    /// The bounds of some finite points; `None` of no point. O(n), twice through the points.
    pub fn of(points: impl Iterator<Item = Vec3> + Clone) -> Option<Self> {
        let first = points.clone().next()?;
        let (min, max) = points.clone().fold((first, first), |(min, max), p| (min.min(p), max.max(p)));
        let (min, max) = (min.as_dvec3(), max.as_dvec3());
        let center = (min + max) * 0.5;
        let radius = points.map(|p| p.as_dvec3().distance_squared(center)).fold(0.0, f64::max).sqrt();
        Some(Self { min, max, center, radius })
    }
}

impl TriangleMesh {
    /// Validates and owns the arrays. O(V + F).
    ///
    /// # Errors
    /// [`MeshError`] names the first vertex or face at fault.
    pub fn new(positions: Vec<Vec3>, triangles: Vec<[u32; 3]>) -> Result<Self, MeshError> {
        let too_large =
            |what, count, limit| if count > limit { Err(MeshError::TooLarge { what, count, limit }) } else { Ok(()) };
        too_large("vertices", positions.len(), MAX_VERTICES)?;
        too_large("faces", triangles.len(), MAX_FACES)?;
        check_finite(&positions)?;
        let vertices = positions.len();
        for (face, triangle) in triangles.iter().enumerate() {
            if let Some(&index) = triangle.iter().find(|&&index| index as usize >= vertices) {
                return Err(MeshError::IndexOutOfRange { face: FaceId::from_usize(face), index, vertices });
            }
        }
        Ok(Self { positions, triangles, origin: DVec3::ZERO })
    }

    /// A mesh of 64-bit coordinates, each rounded once. Where they lie far from zero, positions count from an
    /// [origin](mod@crate::origin) close to them, as those of files do. O(V + F).
    ///
    /// # Errors
    /// [`MeshError`] names the first vertex or face at fault.
    pub fn from_wide(coordinates: &[DVec3], triangles: Vec<[u32; 3]>) -> Result<Self, MeshError> {
        let used = || triangles.iter().flatten().filter_map(|&vertex| coordinates.get(vertex as usize));
        let origin = match used().next() {
            Some(&first) => {
                let (min, max) = used().fold((first, first), |(min, max), &p| (min.min(p), max.max(p)));
                if min.is_finite() && max.is_finite() { origin_between(min, max) } else { DVec3::ZERO }
            }
            None => DVec3::ZERO,
        };
        let positions = coordinates.iter().map(|&coordinate| (coordinate - origin).as_vec3()).collect();
        Ok(Self::new(positions, triangles)?.with_origin(origin))
    }

    /// The same positions, counted from another point of the file's coordinates: the mesh is elsewhere.
    ///
    /// # Panics
    /// If `origin` is not finite.
    pub fn with_origin(self, origin: DVec3) -> Self {
        assert!(origin.is_finite(), "an origin is a point");
        Self { origin, ..self }
    }

    /// The same mesh at the same place, with positions that count from `origin`, rounded to 32 bits. O(V).
    ///
    /// # Errors
    /// [`MeshError::NotFinite`] where a position is beyond 32 bits as seen from there.
    ///
    /// # Panics
    /// If `origin` is not finite.
    pub fn relative_to(&self, origin: DVec3) -> Result<Self, MeshError> {
        let mut moved = self.clone().with_origin(origin);
        let offset = self.origin - origin;
        if offset != DVec3::ZERO {
            moved.positions.iter_mut().for_each(|position| *position = (offset + position.as_dvec3()).as_vec3());
            check_finite(&moved.positions)?;
        }
        Ok(moved)
    }

    /// The point of the file's coordinates from which positions count. Zero for most meshes, and for all that
    /// [`TriangleMesh::new`] makes; see [`origin`](mod@crate::origin).
    pub fn origin(&self) -> DVec3 {
        self.origin
    }

    /// A position of this mesh in the coordinates of its file, as they are written: see [`in_file`].
    pub fn in_file(&self, position: Vec3) -> DVec3 {
        in_file(self.origin, position)
    }

    /// Several meshes in one space as one: the vertices and faces of each follow those of the mesh before it. Nothing is joined.
    /// O(V + F).
    ///
    /// # Errors
    /// [`MeshError`]: together they are too large, or too far from each other for 32 bits.
    pub fn of_parts(parts: &[&Self]) -> Result<Self, MeshError> {
        let (mut positions, mut triangles) = (Vec::new(), Vec::new());
        // One that all have stays, however far from it some of them lie.
        let shared = parts.first().map_or(DVec3::ZERO, |first| first.origin);
        let is_shared = parts.iter().all(|part| part.origin == shared);
        let origin = if is_shared { shared } else { common_origin(parts.iter().copied()) };
        for &part in parts {
            // Most have the same origin, and need no copy.
            let placed = if part.origin == origin { None } else { Some(part.relative_to(origin)?) };
            let part = placed.as_ref().unwrap_or(part);
            // Beyond 32 bits the sum wraps, and the size check of the whole refuses the mesh.
            let first = positions.len() as u32;
            positions.extend_from_slice(&part.positions);
            triangles.extend(part.triangles.iter().map(|corners| corners.map(|corner| corner.wrapping_add(first))));
        }
        Ok(Self::new(positions, triangles)?.with_origin(origin))
    }

    /// Positions in object space, indexed by [`VertexId::index`].
    #[inline]
    pub fn positions(&self) -> &[Vec3] {
        &self.positions
    }

    /// Vertex indices of each face, indexed by [`FaceId::index`].
    #[inline]
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// Number of vertices V, unreferenced ones included.
    pub fn vertex_count(&self) -> usize {
        self.positions.len()
    }

    /// Number of faces F.
    pub fn face_count(&self) -> usize {
        self.triangles.len()
    }

    /// The three corners of a face.
    ///
    /// # Panics
    /// If the mesh has no such face.
    #[inline]
    pub fn corners(&self, face: FaceId) -> [Vec3; 3] {
        self.triangles[face.index()].map(|vertex| self.positions[vertex as usize])
    }

    /// Bounds of the vertices that triangles use; `None` where there is no triangle. O(F).
    pub fn bounds(&self) -> Option<Bounds> {
        Bounds::of(self.triangles.iter().flatten().map(|&vertex| self.positions[vertex as usize]))
    }

    /// Bytes held by the arrays.
    pub fn bytes(&self) -> usize {
        size_of_val(self.positions.as_slice()) + size_of_val(self.triangles.as_slice())
    }
}

fn check_finite(positions: &[Vec3]) -> Result<(), MeshError> {
    let vertex = positions.iter().position(|position| !position.is_finite());
    vertex.map_or(Ok(()), |vertex| Err(MeshError::NotFinite { vertex: VertexId::from_usize(vertex) }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bad_arrays_are_named() {
        let p = vec![Vec3::ZERO, Vec3::X, Vec3::new(0.0, f32::NAN, 0.0)];
        assert_eq!(TriangleMesh::new(p, vec![]), Err(MeshError::NotFinite { vertex: VertexId::new(2) }));
        let p = vec![Vec3::ZERO, Vec3::X, Vec3::Y];
        let error = TriangleMesh::new(p.clone(), vec![[0, 1, 2], [0, 1, 3]]);
        assert_eq!(error, Err(MeshError::IndexOutOfRange { face: FaceId::new(1), index: 3, vertices: 3 }));
        assert!(TriangleMesh::new(p, vec![[0, 1, 2]]).is_ok());
    }

    #[test]
    fn coordinates_of_64_bits_are_rounded_once_and_counted_from_close_by() {
        let near = [DVec3::ZERO, DVec3::X * 0.1, DVec3::Y];
        let mesh = TriangleMesh::from_wide(&near, vec![[0, 1, 2]]).unwrap();
        assert_eq!((mesh.origin(), mesh.positions()[1]), (DVec3::ZERO, Vec3::X * 0.1));
        let offset = DVec3::new(4.5e6, 5.3e6, 0.0);
        let far = TriangleMesh::from_wide(&near.map(|point| point + offset), vec![[0, 1, 2]]).unwrap();
        for (&position, point) in far.positions().iter().zip(near) {
            assert!((far.origin() + position.as_dvec3() - offset).distance(point) < 1e-6, "{far:?}");
        }
        let plain = TriangleMesh::new(near.map(|point| (point + offset).as_vec3()).to_vec(), vec![[0, 1, 2]]).unwrap();
        assert!((plain.positions()[1].as_dvec3() - offset).distance(near[1]) > 1e-2, "32 bits alone lose the edge");
        let error = TriangleMesh::from_wide(&[DVec3::NAN, DVec3::X, DVec3::Y], vec![[0, 1, 2]]);
        assert_eq!(error, Err(MeshError::NotFinite { vertex: VertexId::new(0) }));
        assert!(TriangleMesh::from_wide(&near, vec![[0, 1, 3]]).is_err());
    }

    #[test]
    fn parts_follow_each_other() {
        let mesh = |x: f32, triangles: Vec<[u32; 3]>| {
            TriangleMesh::new(vec![Vec3::X * x, Vec3::Y, Vec3::Z], triangles).unwrap()
        };
        let (one, other) = (mesh(1.0, vec![[0, 1, 2]]), mesh(2.0, vec![[2, 1, 0]]));
        let both = TriangleMesh::of_parts(&[&one, &other]).unwrap();
        assert_eq!(both.positions(), [one.positions(), other.positions()].concat());
        assert_eq!(both.triangles(), [[0, 1, 2], [5, 4, 3]]);
        assert_eq!(TriangleMesh::of_parts(&[]).unwrap().face_count(), 0);
    }

    #[test]
    fn bounds_leave_out_unreferenced_vertices() {
        let p = vec![Vec3::ZERO, Vec3::X * 2.0, Vec3::Y, Vec3::splat(1e6)];
        let bounds = TriangleMesh::new(p, vec![[0, 1, 2]]).unwrap().bounds().unwrap();
        assert_eq!((bounds.min, bounds.max), (DVec3::ZERO, DVec3::new(2.0, 1.0, 0.0)));
        assert_eq!(TriangleMesh::new(vec![], vec![]).unwrap().bounds(), None);
    }
}
