//! The glTF extension `EXT_mesh_primitive_edge_visibility`: what its writer and its reader share. The repository's
//! `docs/formats/glb-edges.md` describes it.

/// The name of the extension.
pub(crate) const NAME: &str = "EXT_mesh_primitive_edge_visibility";

/// When a viewer draws a side of a triangle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum EdgeCode {
    /// Never, or another triangle's side is drawn for it.
    Hidden,
    /// Where one of its two triangles is front and the other back.
    Silhouette,
    /// Always.
    Hard,
    /// Always, and another triangle's side is [`Hard`](Self::Hard) along the same edge.
    RepeatedHard,
}

/// Codes per byte, the first one in the lowest bits.
const PER_BYTE: usize = 4;

/// Bytes that the codes of a primitive with so many triangles take, three per triangle. The spare bits of the last are 0.
#[cfg(feature = "gltf")]
pub(crate) fn packed_len(triangles: u64) -> u64 {
    triangles.saturating_mul(3).div_ceil(PER_BYTE as u64)
}

/// The codes as bytes.
#[cfg(feature = "save")]
pub(crate) fn pack(codes: &[EdgeCode]) -> Vec<u8> {
    let byte = |codes: &[EdgeCode]| codes.iter().rev().fold(0, |byte, &code| byte << 2 | code as u8);
    codes.chunks(PER_BYTE).map(byte).collect()
}

/// The codes in these bytes, spare ones included.
#[cfg(feature = "gltf")]
pub(crate) fn unpack(bytes: &[u8]) -> impl Iterator<Item = EdgeCode> + '_ {
    const CODES: [EdgeCode; 4] = [EdgeCode::Hidden, EdgeCode::Silhouette, EdgeCode::Hard, EdgeCode::RepeatedHard];
    bytes.iter().flat_map(|byte| [0, 2, 4, 6].map(|shift| CODES[usize::from(byte >> shift & 3)]))
}

#[cfg(all(test, feature = "save", feature = "gltf"))]
mod tests {
    use super::*;

    /// The two worked examples of the extension's text: two triangles with a silhouette, and with a hard edge, between them.
    #[test]
    fn codes_are_packed_as_the_extension_packs_its_examples() {
        use EdgeCode::{Hard, Hidden, RepeatedHard, Silhouette};
        for (codes, bytes) in [
            ([Hard, Hidden, Silhouette, Hidden, Hard, Hidden], [18, 2]),
            ([Hard, Hidden, Hard, RepeatedHard, Hard, Hidden], [226, 2]),
        ] {
            assert_eq!(pack(&codes), bytes);
            assert!(unpack(&bytes).eq(codes.into_iter().chain([Hidden, Hidden])));
        }
    }

    #[test]
    fn three_codes_a_triangle_fill_whole_bytes() {
        assert_eq!([0, 1, 2, 3, 4, 5].map(packed_len), [0, 1, 2, 3, 3, 4]);
        for triangles in 0..9 {
            let codes = vec![EdgeCode::RepeatedHard; 3 * triangles];
            assert_eq!(pack(&codes).len() as u64, packed_len(triangles as u64));
        }
        assert!(packed_len(u64::MAX) > 1 << 60);
    }
}
