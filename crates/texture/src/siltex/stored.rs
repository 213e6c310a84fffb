//! [`Stored`]: values as they lie in a file, little-endian and without padding.

use crate::silhouette_texture::FacePlace;
use glam::{Vec2, Vec3};
use half::f16;
use silhouette_core::glam;

/// A value of a fixed number of bytes.
pub(super) trait Stored: Sized {
    /// How many bytes.
    const BYTES: usize;
    /// Appends them.
    fn put(&self, bytes: &mut Vec<u8>);
    /// The value of exactly so many bytes.
    fn take(bytes: &[u8]) -> Self;
}

/// Numbers, which know their own bytes.
macro_rules! stored_numbers {
    ($($number:ty),*) => {$(
        impl Stored for $number {
            const BYTES: usize = size_of::<Self>();

            fn put(&self, bytes: &mut Vec<u8>) {
                bytes.extend_from_slice(&self.to_le_bytes());
            }

            fn take(bytes: &[u8]) -> Self {
                let mut own = [0; size_of::<Self>()];
                own.copy_from_slice(bytes);
                Self::from_le_bytes(own)
            }
        }
    )*};
}

stored_numbers!(u8, u32, f32, f16);

impl<T: Stored, const N: usize> Stored for [T; N] {
    const BYTES: usize = N * T::BYTES;

    fn put(&self, bytes: &mut Vec<u8>) {
        for value in self {
            value.put(bytes);
        }
    }

    fn take(bytes: &[u8]) -> Self {
        std::array::from_fn(|index| T::take(&bytes[index * T::BYTES..][..T::BYTES]))
    }
}

impl Stored for Vec3 {
    const BYTES: usize = <[f32; 3]>::BYTES;

    fn put(&self, bytes: &mut Vec<u8>) {
        self.to_array().put(bytes);
    }

    fn take(bytes: &[u8]) -> Self {
        <[f32; 3]>::take(bytes).into()
    }
}

impl Stored for FacePlace {
    const BYTES: usize = u32::BYTES + <[f32; 6]>::BYTES;

    fn put(&self, bytes: &mut Vec<u8>) {
        self.page.put(bytes);
        self.corners.map(|corner| corner.to_array()).put(bytes);
    }

    fn take(bytes: &[u8]) -> Self {
        let (page, corners) = bytes.split_at(u32::BYTES);
        Self { page: u32::take(page), corners: <[[f32; 2]; 3]>::take(corners).map(Vec2::from_array) }
    }
}
