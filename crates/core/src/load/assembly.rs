//! What every reader fills: positions and triangles in file order.

use super::error::{Located, Problem};
use super::polygon::fan;
use crate::mesh::TriangleMesh;
use glam::Vec3;

/// A mesh under construction.
#[derive(Default)]
pub(super) struct Assembly {
    pub(super) positions: Vec<Vec3>,
    pub(super) triangles: Vec<[u32; 3]>,
}

impl Assembly {
    /// Appends a polygon, fanned from its first corner.
    pub(super) fn polygon(&mut self, face: u64, corners: &[u32]) -> Result<(), Problem> {
        if corners.len() < 3 {
            return Err(Problem::TooFewCorners { face, corners: corners.len() as u64 });
        }
        fan(corners, &mut self.triangles);
        Ok(())
    }

    /// The finished mesh.
    pub(super) fn finish(self) -> Result<TriangleMesh, Located> {
        if self.triangles.is_empty() {
            return Err(Problem::NoFaces.into());
        }
        Ok(TriangleMesh::new(self.positions, self.triangles)?)
    }
}

/// `index` as a vertex id of a format that counts from 0.
pub(super) fn vertex_id(index: i64, face: u64, vertices: u64) -> Result<u32, Problem> {
    match u32::try_from(index) {
        Ok(id) if u64::from(id) < vertices => Ok(id),
        _ => {
            let allowed = match vertices.checked_sub(1) {
                Some(last) => format!("only 0 to {last} exist"),
                None => "there are no vertices".to_owned(),
            };
            Err(Problem::VertexOutOfRange { face, index, allowed })
        }
    }
}

/// Refuses a promise that `remaining` bytes cannot keep, each element taking `least` bytes or more. Only after this
/// may memory be reserved for the promise.
pub(super) fn check_promise(what: &str, promised: u64, least: u64, remaining: usize) -> Result<usize, Problem> {
    // The last row of a text may lack its line end.
    let possible = (remaining as u64 + 1) / least.max(1);
    if promised > possible {
        return Err(Problem::Promise { what: what.to_owned(), promised, possible });
    }
    Ok(usize::try_from(promised).unwrap_or(usize::MAX))
}
