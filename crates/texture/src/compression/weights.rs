//! Step 3: each texel's weights for given functions, as bytes.

use super::gram::{slice_of, texel_chunks};
use crate::silhouette_texture::Terms;
use crate::volume_size::VolumeSize;
use rayon::prelude::*;

/// Texels that are projected together: their sums stay in the cache.
const CHUNK: usize = 4096;

/// Projects all texels onto orthonormal functions. Offset and scale of a term span its weights over the used texels; weights of other
/// texels are clamped to that range. O(samples x terms).
pub(super) fn with_weights(functions: Vec<Vec<f32>>, shares: &[f32], size: VolumeSize, used: Option<&[bool]>) -> Terms {
    let texels = size.texels() as usize;
    let is_used = |texel: usize| used.is_none_or(|used| used[texel]);
    let mut terms =
        Terms { offsets: vec![], scales: vec![], weights: Vec::with_capacity(texels * functions.len()), functions };
    for function in &terms.functions {
        let weights = projected(function, shares, size);
        let (mut least, mut most) = (f32::INFINITY, f32::NEG_INFINITY);
        for (texel, &weight) in weights.iter().enumerate() {
            if is_used(texel) {
                (least, most) = (least.min(weight), most.max(weight));
            }
        }
        // No texel is used.
        if least > most {
            (least, most) = (0.0, 0.0);
        }
        let scale = most - least;
        let steps = if scale > 0.0 { 255.0 / scale } else { 0.0 };
        terms.offsets.push(least);
        terms.scales.push(scale);
        // `as` clamps to the range, and takes NaN to 0.
        terms.weights.extend(weights.iter().map(|&weight| ((weight - least) * steps).round() as u8));
    }
    terms
}

/// Each texel's product with a function, in 64-bit sums.
fn projected(function: &[f32], shares: &[f32], size: VolumeSize) -> Vec<f32> {
    let slice = slice_of(size);
    let chunks: Vec<_> = texel_chunks(size, CHUNK).collect();
    let weights = chunks.par_iter().flat_map_iter(|chunk| {
        let mut sums = vec![0.0_f64; chunk.count];
        for (azimuth, &factor) in function.iter().enumerate() {
            let values = &shares[chunk.sample + azimuth * slice..][..chunk.count];
            for (sum, &value) in sums.iter_mut().zip(values) {
                *sum += f64::from(factor) * f64::from(value);
            }
        }
        sums.into_iter().map(|sum| sum as f32)
    });
    weights.collect()
}
