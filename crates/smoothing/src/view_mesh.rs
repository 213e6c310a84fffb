//! [`ViewMesh`]: the triangles that are drawn for one view.

use crate::rounding::rounded;
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::{FaceId, MeshError, Method, TriangleMesh, weld};

/// Where a vertex of a [`ViewMesh`] lies on the mesh that it was made from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Origin {
    /// A face that holds it.
    pub face: FaceId,
    /// Its barycentric coordinates there, corner by corner; their sum is 1, or 0 for a vertex of no face.
    pub weights: [f32; 3],
}

/// A triangle mesh with normals, made anew for each view. Object space.
///
/// Vertices on a feature curve appear once for each group of faces there, at bitwise the same position, so that each has its
/// own normal; welded by position ([`to_mesh`](Self::to_mesh)), the mesh is closed where the original is.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ViewMesh {
    /// Position of each vertex.
    pub positions: Vec<Vec3>,
    /// Unit normal of each vertex; 0 where there is none.
    pub normals: Vec<Vec3>,
    /// Where each vertex comes from.
    pub origins: Vec<Origin>,
    /// Vertices of each triangle, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
}

/// How far outside of a mesh a surface through its vertices may reach: the length of its longest edge, in its own units. No
/// control point of a side or a patch of this crate is farther from the mesh. O(F).
pub fn reach(mesh: &TriangleMesh) -> f64 {
    let sides = |&[a, b, c]: &[u32; 3]| [[a, b], [b, c], [c, a]];
    let length = |ends: [u32; 2]| {
        let [from, to] = ends.map(|vertex| mesh.positions()[vertex as usize].as_dvec3());
        from.distance(to)
    };
    mesh.triangles().iter().flat_map(sides).map(length).fold(0.0, f64::max)
}

/// Makes the triangles of one view after another.
pub trait Remesher: Send {
    /// Replaces `out`, which has to be empty or as the last call of this remesher left it, by the triangles of a view, and says
    /// whether they may differ from those of the last call. Once `out` and the scratch memory have grown, a call allocates nothing.
    fn remesh(&mut self, view: &crate::SmoothingView, out: &mut ViewMesh) -> bool;
}

/// A method that makes triangles of its own for each view, or once for all views.
pub trait MakesTriangles: Method {
    /// What makes them.
    type Remesher: Remesher + 'static;

    /// A maker of triangles; each has scratch memory of its own.
    fn remesher(&self) -> Self::Remesher;
}

impl ViewMesh {
    /// Removes everything; keeps the memory.
    pub fn clear(&mut self) {
        self.positions.clear();
        self.normals.clear();
        self.origins.clear();
        self.triangles.clear();
    }

    /// Appends a vertex; yields its index. The normal may be of any length.
    #[inline]
    pub(crate) fn push_vertex(&mut self, position: DVec3, normal: DVec3, origin: Origin) -> u32 {
        self.push_vertex_with_unit_normal(position, normal.normalize_or_zero(), origin)
    }

    /// As [`push_vertex`](Self::push_vertex), with a normal of unit length or none.
    #[inline]
    pub(crate) fn push_vertex_with_unit_normal(&mut self, position: DVec3, normal: DVec3, origin: Origin) -> u32 {
        let index = self.positions.len() as u32;
        self.positions.push(rounded(position));
        self.normals.push(normal.as_vec3());
        self.origins.push(origin);
        index
    }

    /// Appends a triangle, unless two of its corners are the same vertex.
    #[inline]
    pub(crate) fn push_triangle(&mut self, corners: [u32; 3]) {
        let [a, b, c] = corners;
        if a != b && b != c && c != a {
            self.triangles.push(corners);
        }
    }

    /// The same triangles as a mesh, vertices at the same position merged.
    ///
    /// # Errors
    /// [`MeshError`] where a position is not finite, as of a curve beyond the range of 32 bits.
    pub fn to_mesh(&self) -> Result<TriangleMesh, MeshError> {
        let mesh = TriangleMesh::new(self.positions.clone(), self.triangles.clone())?;
        Ok(weld::weld_exact(&mesh).mesh)
    }

    /// What the caller knows at the corners of the original's faces, texture coordinates or colours, at each vertex: linear
    /// over each face. A vertex that several faces share takes its value from one of them, so a seam in the values must run
    /// along feature edges. O(vertices).
    pub fn interpolate<const N: usize>(&self, corner: impl Fn(FaceId, u32) -> [f32; N]) -> Vec<[f32; N]> {
        let value = |origin: &Origin| {
            let mut sum = [0.0; N];
            for (slot, &weight) in (0..).zip(&origin.weights) {
                if weight != 0.0 {
                    let at_corner = corner(origin.face, slot);
                    sum.iter_mut().zip(at_corner).for_each(|(sum, part)| *sum += weight * part);
                }
            }
            sum
        };
        self.origins.iter().map(value).collect()
    }
}
