//! Triangles without shared vertices whose winding says nothing.

use silhouette_core::TriangleMesh;

/// A fixed permutation of 64-bit numbers that looks random (splitmix64's finaliser: Steele, Lea and Flood, OOPSLA 2014).
fn mixed(number: u64) -> u64 {
    let a = (number ^ (number >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let b = (a ^ (a >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    b ^ (b >> 31)
}

/// The triangles without shared vertices in a random order, each turned inside out with a chance of a half. O(F log F).
pub fn soup(mesh: &TriangleMesh) -> TriangleMesh {
    let mut keyed: Vec<(u64, [u32; 3])> = (1..).map(mixed).zip(mesh.triangles().iter().copied()).collect();
    keyed.sort_unstable();
    let turned = keyed.into_iter().map(|(key, [a, b, c])| if key % 2 == 1 { [a, c, b] } else { [a, b, c] });
    let positions: Vec<_> = turned.flatten().map(|vertex| mesh.positions()[vertex as usize]).collect();
    // Validation bounds the corners of a mesh by 2^32, so that a soup of its triangles is valid.
    let corners = (0..positions.len() as u32 / 3).map(|face| [3 * face, 3 * face + 1, 3 * face + 2]).collect();
    TriangleMesh::new(positions, corners).expect("a soup of a valid mesh is valid")
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::shapes::Sphere;
    use std::collections::BTreeMap;

    /// How often each triangle occurs, in either winding.
    fn triangles(mesh: &TriangleMesh) -> BTreeMap<[[u32; 3]; 3], usize> {
        let mut counts = BTreeMap::new();
        for triangle in mesh.triangles() {
            let mut corners = triangle.map(|vertex| mesh.positions()[vertex as usize].to_array().map(f32::to_bits));
            corners.sort_unstable();
            *counts.entry(corners).or_insert(0) += 1;
        }
        counts
    }

    #[test]
    fn a_soup_holds_the_same_triangles_half_of_them_turned() {
        let mesh = Sphere::default().icosphere(3).unwrap();
        let soup = soup(&mesh);
        assert_eq!(triangles(&soup), triangles(&mesh));
        assert_eq!(soup.positions().len(), 3 * mesh.face_count());
        let outward = soup.triangles().iter().filter(|triangle| {
            let [a, b, c] = triangle.map(|vertex| soup.positions()[vertex as usize]);
            (b - a).cross(c - a).dot(a) > 0.0
        });
        let share = outward.count() as f64 / mesh.face_count() as f64;
        assert!((share - 0.5).abs() < 0.05, "{share}");
        let first = mesh.triangles()[0].map(|vertex| mesh.positions()[vertex as usize]);
        assert!(soup.positions()[..3].iter().any(|position| !first.contains(position)), "in another order");
    }
}
