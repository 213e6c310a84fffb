//! Compression of the angles: sums of a few functions of azimuth (the paper's section 3.5), fewer azimuths, or blocks.
//!
//! [`compress`] takes these steps:
//!
//! 1. `gram`: the matrix of texels times azimuths, multiplied by its transpose.
//! 2. `eigen`: the functions of azimuth, as its eigenvectors.
//! 3. `weights`: each texel's share of each function, in 8 bits.
//!
//! The paper stores weights in 8 bits but does not say how signed, unbounded values become bytes: here each term has its own
//! offset and scale. The paper's size of 512 x 512 x 16 + 16 x 64 = 4,195,328 bytes also counts 8 bits per value of a function. With
//! functions, offsets and scales in 32 bits, 16 terms take 4,198,528 bytes, against 16,777,216 uncompressed.
//!
//! The hardware cannot filter terms: the shader sums and filters them itself. [`fewer_azimuths`] and [`blocks`] keep hardware
//! filtering. [`compare`] measures the bytes and error of all forms side by side.
//!
//! Sums are formed in an order that does not depend on the number of threads, so that the same texture always gives the same
//! bytes.

mod azimuths;
pub mod blocks;
mod eigen;
mod expand;
mod forms;
mod gram;
mod psnr;
#[cfg(test)]
mod tests;
mod weights;

pub use azimuths::{fewer_azimuths, interpolate_azimuths};
pub use expand::{expand, shares};
pub use forms::{Form, FormRow, compare, stored_bytes};
pub use psnr::psnr_db;

use crate::silhouette_texture::{Angles, PartsError, SilhouetteTexture, Terms};
use crate::volume_size::VolumeSize;

/// Why a texture is not compressed.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum CompressionError {
    /// More terms than there can be, or none.
    #[error("{asked} terms were asked for; a texture of {azimuths} azimuths has 1 to {azimuths}")]
    Terms {
        /// How many were asked for.
        asked: u32,
        /// How many azimuths there are.
        azimuths: u32,
    },
    /// More azimuths than there are, or too few.
    #[error("{asked} azimuths were asked for; a texture of {azimuths} azimuths can be reduced to 3 to {azimuths}")]
    Azimuths {
        /// How many were asked for.
        asked: u32,
        /// How many there are.
        azimuths: u32,
    },
    /// A list of used texels whose length is not the number of texels.
    #[error(transparent)]
    Used(#[from] PartsError),
}

/// The same texture with its angles as sums of `terms` functions, those that leave the smallest mean square error.
///
/// `used` marks, per texel, those inside charts. Only they determine the functions and the ranges of the weights; `None` marks all.
/// Where fewer than `terms` functions suffice, the remaining terms are zero to rounding.
///
/// O(samples x (azimuths + terms) + azimuths^3), with memory of 4 bytes per sample and 5 per weight.
///
/// # Errors
/// [`CompressionError`]: `terms` or `used` do not fit the texture.
pub fn compress(
    texture: &SilhouetteTexture,
    terms: u32,
    used: Option<&[bool]>,
) -> Result<SilhouetteTexture, CompressionError> {
    let size = texture.parts().size;
    let shares = shares(&texture.parts().angles, size);
    let terms = terms_of(&shares, size, terms, used)?;
    Ok(with_angles(texture, size, Angles::Terms(terms)))
}

/// The best `terms` functions and their weights.
fn terms_of(shares: &[f32], size: VolumeSize, terms: u32, used: Option<&[bool]>) -> Result<Terms, CompressionError> {
    let azimuths = size.azimuths;
    if !(1..=azimuths).contains(&terms) {
        return Err(CompressionError::Terms { asked: terms, azimuths });
    }
    check_used(size, used)?;
    let gram = gram::gram(shares, size, used);
    let functions = eigen::eigenvectors(gram, azimuths as usize).vectors;
    let functions = functions.iter().take(terms as usize).map(|function| function.iter().map(|&x| x as f32).collect());
    Ok(weights::with_weights(functions.collect(), shares, size, used))
}

/// The same texture with other angles.
fn with_angles(texture: &SilhouetteTexture, size: VolumeSize, angles: Angles) -> SilhouetteTexture {
    let parts = crate::silhouette_texture::Parts { size, angles, ..texture.parts().clone() };
    SilhouetteTexture::new(parts).expect("angles of this size are as many as the size asks for")
}

fn check_used(size: VolumeSize, used: Option<&[bool]>) -> Result<(), PartsError> {
    let (found, expected) = (used.map_or(size.texels(), |used| used.len() as u64), size.texels());
    if found == expected { Ok(()) } else { Err(PartsError { what: "used texels", found, expected }) }
}
