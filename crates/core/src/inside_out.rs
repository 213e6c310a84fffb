//! Which faces have to be turned for their normals to point outwards: many methods take that for granted, and scans and exports do
//! not always keep to it.

use crate::disjoint_sets::DisjointSets;
use crate::id::{EdgeId, FaceId};
use crate::mesh::TriangleMesh;
use crate::topology::Topology;
use glam::{DVec3, Vec3};

/// For each face whether it belongs to a part that is wound inside out: whose [volume](part_volumes) is negative. O(F α(F)).
pub fn inside_out_faces(mesh: &TriangleMesh, topology: &Topology) -> Vec<bool> {
    part_volumes(mesh, topology).into_iter().map(|volume| volume < 0.0).collect()
}

/// For each face six times the volume between its part and the part's centre, above 0 where faces point outwards: right for closed parts,
/// a guess for open ones, and 0 for flat ones. A part is what consistently wound pairs of faces join. O(F α(F)).
pub fn part_volumes(mesh: &TriangleMesh, topology: &Topology) -> Vec<f64> {
    let mut sets = DisjointSets::new(mesh.face_count());
    for edge in (0..topology.edge_count()).map(EdgeId::from_usize) {
        if let Some([a, b]) = topology.consistent_pair(mesh, edge) {
            sets.unite(a.get(), b.get());
        }
    }
    let corners = |face: usize| mesh.corners(FaceId::from_usize(face)).map(Vec3::as_dvec3);
    let mut parts = vec![Part::default(); mesh.face_count()];
    for face in 0..mesh.face_count() {
        let part = sets.find(face as u32) as usize;
        let [a, b, c] = corners(face);
        let area = (b - a).cross(c - a).length();
        parts[part].area += area;
        parts[part].moment += area / 3.0 * (a + b + c);
    }
    for face in 0..mesh.face_count() {
        let part = sets.find(face as u32) as usize;
        let centre = parts[part].moment / parts[part].area;
        let [a, b, c] = corners(face).map(|corner| corner - centre);
        let volume = a.cross(b).dot(c);
        if volume.is_finite() {
            parts[part].volume += volume;
        }
    }
    (0..mesh.face_count() as u32).map(|face| parts[sets.find(face) as usize].certain_volume()).collect()
}

/// The mesh with the faces turned for which `is_turned` says so; ids stay as they are. O(V + F).
///
/// # Panics
/// If there are not as many answers as faces.
pub fn turned(mesh: &TriangleMesh, is_turned: &[bool]) -> TriangleMesh {
    assert_eq!(is_turned.len(), mesh.face_count(), "one answer per face");
    let triangles = mesh.triangles().iter().zip(is_turned);
    let triangles = triangles.map(|(&[a, b, c], &is_turned)| if is_turned { [a, c, b] } else { [a, b, c] }).collect();
    let turned = TriangleMesh::new(mesh.positions().to_vec(), triangles).expect("the corners are those of a mesh");
    turned.with_origin(mesh.origin())
}

/// Of a part with twice the area A, a volume below this times A^(3/2) is rounding: six times that of a ball is 0.2 times as much, of a plate
/// a thousand times as wide as thick 0.0003.
const ROUNDING: f64 = 1e-9;

#[derive(Debug, Clone, Copy, Default)]
struct Part {
    /// Twice its area.
    area: f64,
    moment: DVec3,
    /// Six times its volume.
    volume: f64,
}

impl Part {
    fn certain_volume(self) -> f64 {
        if self.volume.abs() > ROUNDING * self.area.powf(1.5) { self.volume } else { 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes;

    #[test]
    fn each_part_is_judged_by_itself_far_from_the_origin_too() {
        let sphere = shapes::by_name("icosphere:1").unwrap();
        let count = sphere.vertex_count() as u32;
        let mut positions: Vec<Vec3> = sphere.positions().iter().map(|p| *p + Vec3::X * 1000.0).collect();
        positions.extend(sphere.positions());
        let mut triangles = sphere.triangles().to_vec();
        triangles.extend(sphere.triangles().iter().map(|&[a, b, c]| [b + count, a + count, c + count]));
        let both = TriangleMesh::new(positions, triangles).unwrap();
        let turned = inside_out_faces(&both, &Topology::new(&both));
        let faces = sphere.face_count();
        assert!(turned[..faces].iter().all(|turned| !turned) && turned[faces..].iter().all(|turned| *turned));
        let flat = shapes::by_name("grid:3,2").unwrap();
        assert_eq!(part_volumes(&flat, &Topology::new(&flat)), [0.0; 12]);
        let mended = super::turned(&both, &turned);
        assert!(!inside_out_faces(&mended, &Topology::new(&mended)).contains(&true));
        assert_eq!(mended.triangles()[..faces], both.triangles()[..faces], "what was right stays");
    }
}
