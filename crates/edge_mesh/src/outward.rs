//! Whether the faces of a closed mesh point outwards, so that its back faces cannot be seen from outside.

use silhouette_core::TriangleMesh;
use silhouette_core::disjoint_sets::DisjointSets;
use silhouette_core::glam::DVec3;

/// Whether each connected part of a closed mesh encloses a volume above 0: no part is turned inside out, and none is a cavity. O(F).
pub fn is_outward(mesh: &TriangleMesh) -> bool {
    let mut parts = DisjointSets::new(mesh.vertex_count());
    for &[a, b, c] in mesh.triangles() {
        parts.unite(a, b);
        parts.unite(b, c);
    }
    // Six times the volume between a part's faces and a point near them: far away, sums would cancel.
    let origin = mesh.bounds().map_or(DVec3::ZERO, |bounds| bounds.center);
    let mut volumes = vec![0.0; mesh.vertex_count()];
    for triangle in mesh.triangles() {
        let [a, b, c] = triangle.map(|vertex| mesh.positions()[vertex as usize].as_dvec3() - origin);
        volumes[parts.find(triangle[0]) as usize] += a.dot(b.cross(c));
    }
    mesh.triangles().iter().all(|triangle| volumes[parts.find(triangle[0]) as usize] > 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::glam::Vec3;
    use silhouette_testing::edits::{joined, moved};
    use silhouette_testing::zoo;

    fn inverted(mesh: &TriangleMesh) -> TriangleMesh {
        let triangles = mesh.triangles().iter().map(|&[a, b, c]| [a, c, b]).collect();
        TriangleMesh::new(mesh.positions().to_vec(), triangles).unwrap()
    }

    #[test]
    fn one_part_inside_out_is_enough() {
        for (name, mesh) in zoo::closed() {
            assert!(is_outward(&mesh) && !is_outward(&inverted(&mesh)), "{name}");
        }
        let cube = silhouette_testing::builtin("cube");
        let aside = moved(&cube, Vec3::X * 5.0);
        assert!(is_outward(&joined(&[&cube, &aside])) && !is_outward(&joined(&[&cube, &inverted(&aside)])));
    }
}
