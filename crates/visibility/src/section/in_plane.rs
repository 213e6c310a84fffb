//! Which faces that lie in a section plane stay.
//!
//! A patch of such faces is what edges connect. It stays where it is joined to nothing else, or only to what stays, and is taken
//! away where it is joined only to what is taken away, whatever its winding. Joined to both, as the step of a staircase is, it
//! bounds solid below the plane or above it: its faces stay whose outer side is towards the normal.

use super::Sides;
use super::plane::SectionPlane;
use silhouette_core::orientation::turn;
use silhouette_core::{DisjointSets, FaceId, TriangleMesh, Viewpoint};
use std::cmp::Ordering;
use std::collections::HashMap;

/// The faces of a mesh that lie in the plane.
#[derive(Default)]
pub struct InPlane {
    /// Ascending; whether each stays.
    faces: Vec<(FaceId, bool)>,
}

impl InPlane {
    /// Finds them, and decides. O(F) where there are some, expected.
    pub fn new(mesh: &TriangleMesh, plane: &SectionPlane, sides: &Sides) -> Self {
        let of = |face: usize| mesh.triangles()[face].map(|vertex| sides.of(vertex));
        let faces: Vec<usize> = (0..mesh.face_count()).filter(|&face| of(face) == [Ordering::Equal; 3]).collect();
        if faces.is_empty() {
            return Self::default();
        }
        // Edges in the plane, by their places; the first face in the plane at each.
        let mut patches = DisjointSets::new(faces.len());
        let mut first_at: HashMap<[u32; 2], u32> = HashMap::new();
        for (index, &face) in (0..).zip(&faces) {
            for edge in sides.edges_in_plane(mesh.triangles()[face]) {
                let first = *first_at.entry(edge).or_insert(index);
                patches.unite(first, index);
            }
        }
        // Whether what is joined to each patch stays, and whether some of it is taken away.
        let mut joined = vec![[false; 2]; faces.len()];
        for face in (0..mesh.face_count()).filter(|&face| of(face) != [Ordering::Equal; 3]) {
            for edge in sides.edges_in_plane(mesh.triangles()[face]) {
                if let Some(&first) = first_at.get(&edge) {
                    let is_taken = of(face).contains(&Ordering::Greater);
                    joined[patches.find(first) as usize][usize::from(is_taken)] = true;
                }
            }
        }
        let towards_normal = Viewpoint::Orthographic { toward_viewer: plane.normal() };
        let decide = |(index, face): (u32, usize)| {
            let face = FaceId::from_usize(face);
            let [a, b, c] = mesh.corners(face);
            let stays = match joined[patches.find(index) as usize] {
                [true, true] => turn(&towards_normal, a, b, c) >= 0.0,
                [_, some_is_taken] => !some_is_taken,
            };
            (face, stays)
        };
        Self { faces: (0..).zip(faces).map(decide).collect() }
    }

    /// Whether a face in the plane stays.
    ///
    /// # Panics
    /// If the face does not lie in the plane.
    pub fn stays(&self, face: FaceId) -> bool {
        let index = self.faces.binary_search_by_key(&face, |(face, _)| *face).expect("the face lies in the plane");
        self.faces[index].1
    }
}
