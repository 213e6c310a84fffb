//! The peak signal-to-noise ratio, in texture space.

use super::check_used;
use super::gram::slice_of;
use crate::silhouette_texture::PartsError;
use crate::volume_size::VolumeSize;
use rayon::prelude::*;

/// The peak signal-to-noise ratio of angles against a reference, in decibels: `-10 log10` of the mean squared difference over all
/// samples of used texels. Both are shares of pi, so that the peak, the largest possible angle, is 1.
///
/// Infinite where no sample differs or none is used; 20 dB where the root mean square difference is a tenth of pi; greater is
/// better. The paper states ratios without a definition. The same bits for any number of threads. O(samples).
///
/// # Errors
/// [`PartsError`] where the arrays are not of this size.
pub fn psnr_db(reference: &[f32], other: &[f32], size: VolumeSize, used: Option<&[bool]>) -> Result<f64, PartsError> {
    let expected = size.samples();
    for (what, values) in [("angles of the reference", reference), ("angles", other)] {
        let found = values.len() as u64;
        if found != expected {
            return Err(PartsError { what, found, expected });
        }
    }
    check_used(size, used)?;
    let (slice, azimuths) = (slice_of(size), size.azimuths as usize);
    let slices = reference.par_chunks_exact(slice).zip(other.par_chunks_exact(slice)).enumerate();
    let sums: Vec<_> = slices
        .map(|(index, (reference, other))| {
            let used = used.map(|used| &used[index / azimuths * slice..][..slice]);
            let (mut sum, mut count) = (0.0, 0_u64);
            for (texel, (&a, &b)) in reference.iter().zip(other).enumerate() {
                if used.is_none_or(|used| used[texel]) {
                    sum += (f64::from(a) - f64::from(b)).powi(2);
                    count += 1;
                }
            }
            (sum, count)
        })
        .collect();
    let (sum, count) = sums.into_iter().fold((0.0, 0), |(sum, count), (s, c)| (sum + s, count + c));
    Ok(if sum > 0.0 { -10.0 * (sum / count as f64).log10() } else { f64::INFINITY })
}
