//! Triangles without shared vertices whose winding says nothing, and the ink that they get by mistake.

use super::lost::added;
use super::measure::framed;
use super::variants::{UNORIENTED, Unoriented, Variant};
use crate::error::Cause;
use silhouette_core::shapes::by_name;
use silhouette_core::{PreparedMesh, Progress, TriangleMesh};
use silhouette_render::Gpu;
use std::sync::Arc;

/// The built-in mesh that is taken apart.
pub const MILLION: &str = "blob:1000000";

/// What a variant drew of a soup.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SoupResult {
    /// The variant, one of [`UNORIENTED`].
    pub variant: Variant,
    /// Number of triangles of the soup.
    pub triangles: usize,
    /// Pixels with ink.
    pub ink_px: usize,
    /// Pixels with ink in the picture of the oriented mesh by the variant's oriented counterpart.
    pub expected_px: usize,
    /// Pixels with ink in the first picture only.
    pub false_px: usize,
    /// Pixels with ink in the second only.
    pub lacking_px: usize,
}

/// Draws [`MILLION`] by the oriented variants, and its soup by those that need no orientation.
///
/// # Errors
/// [`Cause`]: cancelled, or a device that failed.
pub fn measure(gpu: &Gpu, size: [u32; 2], progress: &dyn Progress) -> Result<Vec<SoupResult>, Cause> {
    progress.stage("soup of a million triangles", UNORIENTED.len() as u64);
    let mesh = by_name(MILLION)?;
    let camera = framed(&mesh, size)?;
    let soup = Arc::new(PreparedMesh::new(shuffled_soup(&mesh)));
    let mesh = Arc::new(PreparedMesh::new(mesh));
    let result = |Unoriented { variant, oriented }: Unoriented| {
        let found = variant.ink(gpu, &soup, &camera, progress)?;
        let expected = oriented.ink(gpu, &mesh, &camera, progress)?;
        progress.advance(1);
        Ok(SoupResult {
            variant,
            triangles: soup.mesh().face_count(),
            ink_px: found.ink_pixels().count(),
            expected_px: expected.ink_pixels().count(),
            false_px: added(&found, &expected),
            lacking_px: added(&expected, &found),
        })
    };
    UNORIENTED.into_iter().map(result).collect()
}

/// A fixed permutation of 64-bit numbers that looks random (splitmix64's finaliser: Steele, Lea and Flood, OOPSLA 2014).
fn mixed(number: u64) -> u64 {
    let a = (number ^ (number >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let b = (a ^ (a >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    b ^ (b >> 31)
}

/// The triangles without shared vertices in a random order, each turned inside out with a chance of a half.
fn shuffled_soup(mesh: &TriangleMesh) -> TriangleMesh {
    let mut keyed: Vec<(u64, [u32; 3])> = (1..).map(mixed).zip(mesh.triangles().iter().copied()).collect();
    keyed.sort_unstable();
    soup_of(mesh, keyed.into_iter().map(|(key, triangle)| (triangle, key % 2 == 1)))
}

/// The triangles without shared vertices, every other one turned inside out.
pub fn turned_soup(mesh: &TriangleMesh) -> TriangleMesh {
    soup_of(
        mesh,
        mesh.triangles().iter().zip([false, true].into_iter().cycle()).map(|(&triangle, turned)| (triangle, turned)),
    )
}

fn soup_of(mesh: &TriangleMesh, triangles: impl Iterator<Item = ([u32; 3], bool)>) -> TriangleMesh {
    let turned = triangles.map(|([a, b, c], is_turned)| if is_turned { [a, c, b] } else { [a, b, c] });
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
    fn soups_hold_the_same_triangles_half_of_them_turned() {
        let mesh = Sphere::default().icosphere(3).unwrap();
        for soup in [turned_soup(&mesh), shuffled_soup(&mesh)] {
            assert_eq!(triangles(&soup), triangles(&mesh));
            assert_eq!(soup.positions().len(), 3 * mesh.face_count());
            let outward = soup.triangles().iter().filter(|triangle| {
                let [a, b, c] = triangle.map(|vertex| soup.positions()[vertex as usize]);
                (b - a).cross(c - a).dot(a) > 0.0
            });
            let share = outward.count() as f64 / mesh.face_count() as f64;
            assert!((share - 0.5).abs() < 0.05, "{share}");
        }
        assert_ne!(shuffled_soup(&mesh).positions()[..3], turned_soup(&mesh).positions()[..3]);
    }
}
