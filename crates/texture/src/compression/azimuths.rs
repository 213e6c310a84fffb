//! Fewer azimuths, between which the hardware interpolates.
//!
//! Sample `k` of `n` stands for the azimuth of `k / n` turns, and values in between are interpolated linearly, round the circle.

use super::eigen::{Eigen, eigenvectors};
use super::expand::shares;
use super::gram::slice_of;
use super::{CompressionError, with_angles};
use crate::silhouette_texture::{Angles, SilhouetteTexture};
use crate::volume_size::VolumeSize;
use rayon::prelude::*;

/// Eigenvalues below this share of the largest are rounding.
const LEAST_EIGENVALUE: f64 = 1e-10;

/// The same texture with fewer azimuths, in 8 bits. Values are chosen such that linear interpolation between them reproduces the
/// original samples with the least mean squared error. O(samples x azimuths).
///
/// # Errors
/// [`CompressionError`]: `azimuths` must be 3 to those that there are.
pub fn fewer_azimuths(texture: &SilhouetteTexture, azimuths: u32) -> Result<SilhouetteTexture, CompressionError> {
    let from = texture.parts().size;
    if !(3..=from.azimuths).contains(&azimuths) {
        return Err(CompressionError::Azimuths { asked: azimuths, azimuths: from.azimuths });
    }
    let to = VolumeSize { azimuths, ..from };
    let values = mixed(&shares(&texture.parts().angles, from), from, to, &fitting(from.azimuths, azimuths));
    let angles = values.iter().map(|&share| (share * 255.0).round() as u8).collect();
    Ok(with_angles(texture, to, Angles::Unorm8(angles)))
}

/// Shares of pi of this size, interpolated linearly at `azimuths` azimuths. O(samples of the result).
///
/// # Panics
/// If the shares are not of this size.
pub fn interpolate_azimuths(shares: &[f32], size: VolumeSize, azimuths: u32) -> Vec<f32> {
    mixed(shares, size, VolumeSize { azimuths, ..size }, &interpolation(size.azimuths, azimuths))
}

/// Per value of the result: the values of the source that contribute, with their factors.
type Factors = Vec<Vec<(usize, f64)>>;

/// Every slice of the result as a mix of slices of its page.
fn mixed(shares: &[f32], from: VolumeSize, to: VolumeSize, factors: &Factors) -> Vec<f32> {
    let (slice, page_samples) = (slice_of(from), slice_of(from) * from.azimuths as usize);
    let mut result = vec![0.0; to.samples() as usize];
    result.par_chunks_exact_mut(slice).enumerate().for_each(|(index, result)| {
        let page = index / to.azimuths as usize;
        for &(azimuth, factor) in &factors[index % to.azimuths as usize] {
            let values = &shares[page * page_samples + azimuth * slice..][..slice];
            for (result, &value) in result.iter_mut().zip(values) {
                *result += factor as f32 * value;
            }
        }
    });
    result
}

/// How `to` values are interpolated between `from` values round a circle.
fn interpolation(from: u32, to: u32) -> Factors {
    let between = |index: u32| {
        // Whole and remaining parts of index * from / to.
        let product = u64::from(index) * u64::from(from);
        let (whole, rest) = ((product / u64::from(to)) as u32, (product % u64::from(to)) as f64 / f64::from(to));
        [(whole as usize, 1.0 - rest), (((whole + 1) % from) as usize, rest)]
    };
    (0..to).map(|index| between(index).into_iter().filter(|&(_, factor)| factor > 0.0).collect()).collect()
}

/// The `to` values that, interpolated back, fit `from` values best in the least squares sense: the pseudoinverse of that
/// interpolation.
fn fitting(from: u32, to: u32) -> Factors {
    let back = interpolation(to, from);
    let (rows, columns) = (from as usize, to as usize);
    let mut normal = vec![0.0; columns * columns];
    for factors in &back {
        for &(i, a) in factors {
            for &(j, b) in factors {
                normal[i * columns + j] += a * b;
            }
        }
    }
    let Eigen { values, vectors } = eigenvectors(normal, columns);
    let mut fitting = vec![vec![0.0; rows]; columns];
    for (value, vector) in values.iter().zip(&vectors) {
        if *value <= LEAST_EIGENVALUE * values[0] {
            continue;
        }
        for (row, factors) in back.iter().enumerate() {
            let part = factors.iter().map(|&(column, factor)| factor * vector[column]).sum::<f64>() / value;
            for (column, &component) in vector.iter().enumerate() {
                fitting[column][row] += component * part;
            }
        }
    }
    fitting.into_iter().map(|factors| factors.into_iter().enumerate().collect()).collect()
}
