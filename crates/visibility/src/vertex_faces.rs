//! [`VertexFaces`]: the faces around each vertex.

use silhouette_core::prepared::Artefact;
use silhouette_core::{Cancelled, FaceId, PreparedMesh, Progress, TriangleMesh};

/// A face as seen from one of its corners.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct VertexFace {
    /// The face.
    pub face: FaceId,
    /// The vertices at its other corners, in its order.
    pub others: [u32; 2],
}

/// The faces that name each vertex, ascending, with their other vertices: what is looked at around a vertex lies side by
/// side. Memory: 4 bytes a vertex and 36 a face.
#[derive(Debug, Clone, Default)]
pub struct VertexFaces {
    /// Faces of vertex `v` are `faces[first[v]..first[v + 1]]`.
    first: Vec<u32>,
    faces: Vec<VertexFace>,
}

impl VertexFaces {
    /// Lists the faces of every vertex by a counting sort. O(V + F).
    pub fn new(mesh: &TriangleMesh) -> Self {
        let mut first = vec![0_u32; mesh.vertex_count() + 1];
        for &vertex in mesh.triangles().iter().flatten() {
            first[vertex as usize + 1] += 1;
        }
        for vertex in 1..first.len() {
            first[vertex] += first[vertex - 1];
        }
        let mut next = first.clone();
        let mut faces = vec![VertexFace { face: FaceId::new(0), others: [0; 2] }; 3 * mesh.face_count()];
        for (face, &[a, b, c]) in mesh.triangles().iter().enumerate() {
            let face = FaceId::from_usize(face);
            for (vertex, others) in [(a, [b, c]), (b, [c, a]), (c, [a, b])] {
                faces[next[vertex as usize] as usize] = VertexFace { face, others };
                next[vertex as usize] += 1;
            }
        }
        Self { first, faces }
    }

    /// The faces that name a vertex; one that names it twice comes twice.
    ///
    /// # Panics
    /// If there is no such vertex.
    pub fn of(&self, vertex: u32) -> &[VertexFace] {
        &self.faces[self.first[vertex as usize] as usize..self.first[vertex as usize + 1] as usize]
    }
}

impl Artefact for VertexFaces {
    const NAME: &'static str = "vertex-faces";

    fn build(mesh: &PreparedMesh, progress: &dyn Progress) -> Result<Self, Cancelled> {
        progress.check()?;
        Ok(Self::new(mesh.mesh()))
    }

    fn bytes(&self) -> usize {
        size_of_val(self.first.as_slice()) + size_of_val(self.faces.as_slice())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::glam::Vec3;

    #[test]
    fn every_corner_is_listed_once() {
        let mesh = TriangleMesh::new(vec![Vec3::ZERO; 5], vec![[0, 1, 2], [2, 1, 3], [3, 3, 0]]).unwrap();
        let faces = VertexFaces::new(&mesh);
        let of = |vertex| faces.of(vertex).iter().map(|at| at.face.get()).collect::<Vec<_>>();
        assert_eq!([of(0), of(1), of(2), of(3), of(4)], [vec![0, 2], vec![0, 1], vec![0, 1], vec![1, 2, 2], vec![]]);
        assert_eq!(faces.of(1).iter().map(|at| at.others).collect::<Vec<_>>(), [[2, 0], [3, 2]]);
    }
}
