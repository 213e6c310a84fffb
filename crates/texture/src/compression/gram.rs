//! Step 1: the Gram matrix of the samples, azimuths by azimuths.

use crate::volume_size::VolumeSize;
use rayon::prelude::*;

/// Texels whose products are summed together, before these sums are added up in their order. Rows of this many texels stay in
/// the cache.
const CHUNK: usize = 1024;
/// Sums that are held at once.
const BATCH: usize = 32;

/// The sum, over used texels, of the products of the texel's values at every two azimuths: `azimuths` rows of as many values. Not
/// centred, as in the paper. The same bits for any number of threads. O(texels x azimuths^2).
pub(super) fn gram(shares: &[f32], size: VolumeSize, used: Option<&[bool]>) -> Vec<f64> {
    let azimuths = size.azimuths as usize;
    let mut total = vec![0.0; azimuths * azimuths];
    for batch in texel_chunks(size, CHUNK).collect::<Vec<_>>().chunks(BATCH) {
        let sums: Vec<_> = batch.par_iter().map(|chunk| gram_of(shares, size, used, chunk)).collect();
        for sum in sums {
            for (total, sum) in total.iter_mut().zip(sum) {
                *total += sum;
            }
        }
    }
    for row in 0..azimuths {
        for column in 0..row {
            total[row * azimuths + column] = total[column * azimuths + row];
        }
    }
    total
}

/// Neighbouring texels of one page.
#[derive(Debug, Clone)]
pub(super) struct TexelChunk {
    /// The first among all texels.
    pub(super) first: usize,
    /// How many.
    pub(super) count: usize,
    /// The index of the first one's sample at azimuth 0; further azimuths follow at intervals of a slice.
    pub(super) sample: usize,
}

/// All texels in their order, in chunks of at most `most`.
pub(super) fn texel_chunks(size: VolumeSize, most: usize) -> impl Iterator<Item = TexelChunk> {
    let slice = slice_of(size);
    (0..size.pages).flat_map(move |page| {
        (0..slice).step_by(most).map(move |start| TexelChunk {
            first: size.texel(page, 0, 0) + start,
            count: most.min(slice - start),
            sample: size.sample(page, 0, 0, 0) + start,
        })
    })
}

/// Texels of a page, and samples of a slice.
pub(super) fn slice_of(size: VolumeSize) -> usize {
    size.width as usize * size.height as usize
}

/// The upper triangle for a chunk.
fn gram_of(shares: &[f32], size: VolumeSize, used: Option<&[bool]>, chunk: &TexelChunk) -> Vec<f64> {
    let (azimuths, slice) = (size.azimuths as usize, slice_of(size));
    let mut rows = vec![0.0_f64; chunk.count * azimuths];
    for azimuth in 0..azimuths {
        let values = &shares[chunk.sample + azimuth * slice..][..chunk.count];
        for (texel, &value) in values.iter().enumerate() {
            rows[texel * azimuths + azimuth] = f64::from(value);
        }
    }
    let mut sum = vec![0.0; azimuths * azimuths];
    for (texel, row) in rows.chunks_exact(azimuths).enumerate() {
        if used.is_some_and(|used| !used[chunk.first + texel]) {
            continue;
        }
        for (azimuth, &value) in row.iter().enumerate() {
            let sums = &mut sum[azimuth * azimuths..][azimuth..azimuths];
            for (sum, &other) in sums.iter_mut().zip(&row[azimuth..]) {
                *sum += value * other;
            }
        }
    }
    sum
}
