//! [`Bytes`]: small values taken one by one from arbitrary bytes.

use silhouette_core::glam::Vec3;

/// What is left of some bytes. Beyond their end are zeros, so that every input means something.
pub(crate) struct Bytes<'a>(&'a [u8]);

/// How coordinates are made.
#[derive(Clone, Copy)]
pub(crate) enum Coordinates {
    /// Whole numbers from -8 to 7, of which many coincide.
    Lattice,
    /// Any bits, of which not all are numbers.
    AnyBits,
    /// Numbers from -1 to 1, then scaled by a power of two.
    Scaled(f32),
}

impl<'a> Bytes<'a> {
    pub(crate) fn new(bytes: &'a [u8]) -> Self {
        Self(bytes)
    }

    pub(crate) fn byte(&mut self) -> u8 {
        let (first, rest) = self.0.split_first().unwrap_or((&0, &[]));
        self.0 = rest;
        *first
    }

    pub(crate) fn array<const N: usize>(&mut self) -> [u8; N] {
        std::array::from_fn(|_| self.byte())
    }

    /// A number below `end`, which is at most 256.
    pub(crate) fn below(&mut self, end: usize) -> usize {
        usize::from(self.byte()) % end
    }

    pub(crate) fn is_set(&mut self) -> bool {
        self.byte() & 1 == 1
    }

    pub(crate) fn coordinates(&mut self) -> Coordinates {
        match self.below(4) {
            0 | 1 => Coordinates::Lattice,
            2 => Coordinates::AnyBits,
            _ => Coordinates::Scaled((f32::from(self.byte() as i8)).exp2()),
        }
    }

    pub(crate) fn vector(&mut self, made: Coordinates) -> Vec3 {
        match made {
            Coordinates::Lattice => Vec3::from(self.array::<3>().map(|byte| f32::from(byte % 16) - 8.0)),
            Coordinates::AnyBits => Vec3::from([0; 3].map(|_| f32::from_le_bytes(self.array()))),
            Coordinates::Scaled(scale) => {
                Vec3::from([0; 3].map(|_| f32::from(i16::from_le_bytes(self.array())) / 32_768.0 * scale))
            }
        }
    }

    /// Up to `most_vertices` positions and up to `most_faces` triangles over them.
    pub(crate) fn triangles(&mut self, most_vertices: usize, most_faces: usize) -> (Vec<Vec3>, Vec<[u32; 3]>) {
        let vertices = self.below(most_vertices + 1);
        let faces = self.below(most_faces + 1);
        let made = self.coordinates();
        let positions = (0..vertices).map(|_| self.vector(made)).collect();
        // Indices are used as they are: those of vertices that do not exist are to be refused.
        let triangles = (0..faces).map(|_| self.array::<3>().map(u32::from)).collect();
        (positions, triangles)
    }
}
