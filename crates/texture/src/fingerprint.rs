//! [`Fingerprint`]: a 64-bit hash that is the same on every machine (FNV-1a). It finds damage and mistakes, not attacks.

/// A hash of what it was given so far.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Fingerprint(u64);

impl Default for Fingerprint {
    fn default() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }
}

impl Fingerprint {
    /// With some more bytes.
    #[must_use]
    pub fn bytes(self, bytes: &[u8]) -> Self {
        Self(bytes.iter().fold(self.0, |hash, &byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)))
    }

    /// With one more number.
    #[must_use]
    pub fn number(self, number: u64) -> Self {
        self.bytes(&number.to_le_bytes())
    }

    /// With the positions and triangles of a mesh.
    #[must_use]
    pub fn mesh(self, mesh: &silhouette_core::TriangleMesh) -> Self {
        let sized = self.number(mesh.vertex_count() as u64).number(mesh.face_count() as u64);
        let placed = mesh.positions().iter().fold(sized, |hash, position| {
            position.to_array().iter().fold(hash, |hash, coordinate| hash.bytes(&coordinate.to_le_bytes()))
        });
        mesh.triangles().iter().flatten().fold(placed, |hash, vertex| hash.bytes(&vertex.to_le_bytes()))
    }

    /// The hash.
    pub fn finish(self) -> u64 {
        self.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The published test vectors of FNV-1a.
    #[test]
    fn hashes_are_those_of_fnv_1a() {
        for (text, hash) in
            [("", 0xcbf2_9ce4_8422_2325), ("a", 0xaf63_dc4c_8601_ec8c), ("foobar", 0x8594_4171_f739_67e8)]
        {
            assert_eq!(Fingerprint::default().bytes(text.as_bytes()).finish(), hash, "{text}");
        }
    }
}
