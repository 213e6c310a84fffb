//! What is baked and drawn: a fine mesh, the vertices of its hull, and the row of Table 1 about the same model.

use super::printed::{PaperRow, ROWS};
use crate::label::mesh_label;
use silhouette_compare::{NamedMesh, Subject as Simplified};
use silhouette_core::PreparedMesh;
use std::sync::Arc;

/// Vertices of a hull for meshes without a row: those of most rows.
const HULL_VERTICES: u32 = 500;

/// From this many vertices on a mesh without a row stands for the paper's largest.
const LARGE: usize = 500_000;

/// Texels along a side of a block, gutter included: what the paper's largest model had.
const LEAST_BLOCK: u32 = 5;

/// The paper's largest model.
const LARGEST: &str = "Lucy";

/// A smooth closed mesh of about as many vertices as the paper's bunny, and a body with holes.
pub const DEFAULT_MESHES: [&str; 2] = ["builtin:blob:70000", "builtin:knot:2,3,720,48"];

/// One mesh to bake.
#[derive(Debug, Clone)]
pub struct Subject {
    /// What tables call it.
    pub label: String,
    /// Where it comes from.
    pub origin: String,
    /// The fine mesh.
    pub mesh: Arc<PreparedMesh>,
    /// Vertices of its hull.
    pub hull_vertices: u32,
    /// The row of Table 1 about the same model.
    pub row: Option<&'static PaperRow>,
}

impl Subject {
    /// Vertices that faces use, or all: the number that Table 1 is about.
    pub fn vertices(&self) -> usize {
        self.mesh.mesh().positions().len()
    }

    /// Texels along a side at which blocks of two faces of the hull have [`LEAST_BLOCK`], a power of two: the least that is baked.
    pub fn least_side(&self) -> u32 {
        let blocks_per_row = f64::from(self.hull_vertices).sqrt().ceil() as u32;
        (blocks_per_row * LEAST_BLOCK).next_power_of_two()
    }

    /// Why the paper's values of this model are not comparable with ours; `None` where the mesh has as many vertices.
    pub fn difference(&self) -> Option<String> {
        let row = self.row?;
        let vertices = self.vertices();
        (vertices != row.vertices as usize).then(|| {
            format!("the paper's {} has {} vertices, this one {vertices}", row.model.to_lowercase(), row.vertices)
        })
    }
}

/// The subjects of some meshes. A file named after a model of the paper gets the vertices of the paper's hull, and is simplified
/// to the paper's number of vertices where it has more and is closed.
pub fn subjects(meshes: &[NamedMesh]) -> Vec<Subject> {
    meshes.iter().map(subject).collect()
}

fn subject(named: &NamedMesh) -> Subject {
    let label = mesh_label(&named.name);
    let row = ROWS.iter().find(|row| label.to_lowercase().contains(&row.model.to_lowercase()));
    let vertices = named.mesh.mesh().positions().len();
    let row = row.or_else(|| ROWS.iter().find(|row| vertices >= LARGE && row.model == LARGEST));
    let mut subject = Subject {
        label,
        origin: named.name.clone(),
        mesh: Arc::clone(&named.mesh),
        hull_vertices: row.map_or(HULL_VERTICES, |row| row.hull_vertices),
        row,
    };
    // Of a closed surface of genus 0, which scans are, faces are twice the vertices less four.
    if let Some(row) = row.filter(|row| vertices > row.vertices as usize)
        && let Ok(simplified) = Simplified::simplified(named, 2 * row.vertices as usize - 4)
    {
        subject.origin = simplified.mesh.name;
        subject.mesh = simplified.mesh.mesh;
    }
    subject
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::shapes;

    fn named(name: &str, shape: &str) -> NamedMesh {
        NamedMesh { name: name.to_owned(), mesh: Arc::new(PreparedMesh::new(shapes::by_name(shape).unwrap())) }
    }

    #[test]
    fn models_of_the_paper_are_known_by_name_and_matched_in_vertices() {
        let meshes = [
            named("x/stanford-bunny.obj", "blob:2000"),
            named("Armadillo.ply", "blob:84000"),
            named("cow.obj", "cube"),
        ];
        let [bunny, armadillo, cow] = &subjects(&meshes)[..] else { panic!("three subjects") };
        assert_eq!((bunny.row.unwrap().model, bunny.hull_vertices), ("Bunny", 500));
        assert!(bunny.difference().unwrap().contains("34834"), "a mesh with fewer vertices stays as it is");
        assert_eq!((cow.row, cow.hull_vertices, cow.difference()), (None, HULL_VERTICES, None));
        if cfg!(feature = "simplify") {
            assert_eq!((armadillo.vertices(), armadillo.difference()), (40_002, None));
        }
    }
}
