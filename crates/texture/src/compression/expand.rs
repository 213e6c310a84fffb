//! Expansion: angles of any form become one number per sample.

use super::gram::slice_of;
use crate::silhouette_texture::{Angles, Terms};
use crate::volume_size::VolumeSize;
use rayon::prelude::*;

/// The angles as shares of pi, one per sample. Sums of terms are not clamped to 0 to 1. O(samples), times the terms.
///
/// # Panics
/// If the angles are not of this size.
pub fn shares(angles: &Angles, size: VolumeSize) -> Vec<f32> {
    match angles {
        Angles::Unorm8(values) => values.iter().map(|&value| f32::from(value) / 255.0).collect(),
        Angles::Float16(values) => values.iter().map(|value| value.to_f32()).collect(),
        Angles::Terms(terms) => expand(terms, size),
    }
}

/// The sums of terms, as shares of pi, one per sample. They are not clamped and can lie slightly outside 0 to 1.
/// O(samples x terms).
///
/// # Panics
/// If the terms are not of this size.
pub fn expand(terms: &Terms, size: VolumeSize) -> Vec<f32> {
    let (slice, azimuths, texels) = (slice_of(size), size.azimuths as usize, size.texels() as usize);
    let mut shares = vec![0.0; size.samples() as usize];
    shares.par_chunks_exact_mut(slice).enumerate().for_each(|(index, shares)| {
        let (page, azimuth) = (index / azimuths, index % azimuths);
        for (term, function) in terms.functions.iter().enumerate() {
            let weights = &terms.weights[term * texels + page * slice..][..slice];
            let (offset, scale) = (terms.offsets[term], terms.scales[term] / 255.0);
            for (share, &weight) in shares.iter_mut().zip(weights) {
                *share += (offset + scale * f32::from(weight)) * function[azimuth];
            }
        }
    });
    shares
}
