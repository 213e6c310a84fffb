//! Blocks of 4 x 4 samples in 8 bytes each, which graphics hardware filters: the format BC4 (in OpenGL, RGTC1).
//!
//! A block has two end values, in bytes, and per sample 3 bits that choose between them and 6 values in between, or 4 values in between
//! and the two extremes 0 and 1. Volumes are stored as slices of such blocks; wgpu samples them with the feature
//! `TEXTURE_COMPRESSION_BC_SLICED_3D`.
//!
//! The encoder starts from the smallest and largest sample of a block and searches nearby ends for a smaller error. The pure Rust
//! encoder that crates.io offers, `texpresso` 2.0.2, stops at those ends, and measures errors against the wrong ones where a block
//! contains a 0.

use super::expand::shares;
use super::gram::slice_of;
use super::{CompressionError, check_used};
use crate::silhouette_texture::SilhouetteTexture;
use crate::volume_size::VolumeSize;
use rayon::prelude::*;

/// Bytes of a block.
pub const BLOCK_BYTES: usize = 8;
/// Samples along the side of a block.
const SIDE: usize = 4;
/// By how much the ends of a block are moved at first, in search of a smaller error, in steps of a byte.
const FIRST_MOVE: i16 = 8;

/// The angles of a texture in blocks: slice by slice in the order of the samples, blocks in rows. Sides that are no multiple of 4 are
/// rounded up.
///
/// `used` marks, per texel, those inside charts; the error at others is ignored. `None` marks all. O(samples).
///
/// # Errors
/// [`CompressionError`]: `used` does not fit the texture.
pub fn encode(texture: &SilhouetteTexture, used: Option<&[bool]>) -> Result<Vec<u8>, CompressionError> {
    let size = texture.parts().size;
    check_used(size, used)?;
    let shares = shares(&texture.parts().angles, size);
    let (slice, azimuths) = (slice_of(size), size.azimuths as usize);
    let mut bytes = vec![0; encoded_bytes(size) as usize];
    let slices = bytes.par_chunks_exact_mut(slice_bytes(size)).zip(shares.par_chunks_exact(slice)).enumerate();
    slices.for_each(|(index, (bytes, shares))| {
        let used = used.map(|used| &used[index / azimuths * slice..][..slice]);
        let mut values = Vec::with_capacity(SIDE * SIDE);
        for (block, bytes) in bytes.chunks_exact_mut(BLOCK_BYTES).enumerate() {
            values.clear();
            for (place, texel) in texels_of(size, block) {
                if used.is_none_or(|used| used[texel]) {
                    values.push((place, 255.0 * shares[texel].clamp(0.0, 1.0)));
                }
            }
            bytes.copy_from_slice(&encode_block(&values));
        }
    });
    Ok(bytes)
}

/// The angles that blocks stand for, as shares of pi, one per sample. O(samples).
///
/// # Panics
/// If there are not [`encoded_bytes`] bytes.
pub fn decode(bytes: &[u8], size: VolumeSize) -> Vec<f32> {
    assert_eq!(bytes.len() as u64, encoded_bytes(size), "bytes of blocks");
    let mut shares = vec![0.0; size.samples() as usize];
    let slices = shares.par_chunks_exact_mut(slice_of(size)).zip(bytes.par_chunks_exact(slice_bytes(size)));
    slices.for_each(|(shares, bytes)| {
        for (block, bytes) in bytes.chunks_exact(BLOCK_BYTES).enumerate() {
            let codes = codes(bytes[0], bytes[1]);
            let choices = bytes[2..].iter().rev().fold(0_u64, |choices, &byte| choices << 8 | u64::from(byte));
            for (place, texel) in texels_of(size, block) {
                shares[texel] = codes[(choices >> (3 * place) & 7) as usize] / 255.0;
            }
        }
    });
    shares
}

/// Bytes of a texture in blocks.
pub fn encoded_bytes(size: VolumeSize) -> u64 {
    slice_bytes(size) as u64 * u64::from(size.azimuths) * u64::from(size.pages)
}

fn slice_bytes(size: VolumeSize) -> usize {
    (size.width as usize).div_ceil(SIDE) * (size.height as usize).div_ceil(SIDE) * BLOCK_BYTES
}

/// The texels of a block that lie within the slice, each with its place in the block.
fn texels_of(size: VolumeSize, block: usize) -> impl Iterator<Item = (usize, usize)> {
    let (width, height) = (size.width as usize, size.height as usize);
    let across = width.div_ceil(SIDE);
    let (left, top) = (block % across * SIDE, block / across * SIDE);
    let places = (0..SIDE * SIDE).map(move |place| (place, left + place % SIDE, top + place / SIDE));
    places.filter(move |&(_, x, y)| x < width && y < height).map(move |(place, x, y)| (place, y * width + x))
}

/// The eight values of a block, in 255ths.
fn codes(first: u8, second: u8) -> [f32; 8] {
    let (a, b) = (f32::from(first), f32::from(second));
    let between = |index: usize, parts: usize| {
        let (index, parts) = (index as f32, parts as f32);
        ((parts - index) * a + index * b) / parts
    };
    std::array::from_fn(|code| match (code, first > second) {
        (0, _) => a,
        (1, _) => b,
        (_, true) => between(code - 1, 7),
        (6, false) => 0.0,
        (7, false) => 255.0,
        (_, false) => between(code - 1, 5),
    })
}

/// The block that fits values in 255ths at some of its places best, of those that the search meets.
fn encode_block(values: &[(usize, f32)]) -> [u8; BLOCK_BYTES] {
    // With the first end above the second, six values lie in between; otherwise four, and the extremes are left out of the range.
    let whole = searched(values, range(values, |_| true).map(|(least, most)| (most, least)));
    let inner = searched(values, range(values, |value| value > 0.5 && value < 254.5));
    let best = if whole.error < inner.error { whole } else { inner };
    let codes = codes(best.ends.0, best.ends.1);
    let mut choices = 0_u64;
    for &(place, value) in values {
        choices |= (nearest(&codes, value).0 as u64) << (3 * place);
    }
    let mut bytes = [0; BLOCK_BYTES];
    (bytes[0], bytes[1]) = best.ends;
    bytes[2..].copy_from_slice(&choices.to_le_bytes()[..6]);
    bytes
}

/// The smallest and the largest of the values that count, rounded.
fn range(values: &[(usize, f32)], counts: impl Fn(f32) -> bool) -> Option<(u8, u8)> {
    let counted = values.iter().map(|&(_, value)| value).filter(|&value| counts(value));
    let ends = counted.map(|value| (value, value)).reduce(|(a, b), (value, _)| (a.min(value), b.max(value)));
    ends.map(|(least, most)| (least.round() as u8, most.round() as u8))
}

/// Ends and the sum of squares of errors that they leave.
#[derive(Debug, Clone, Copy)]
struct Candidate {
    ends: (u8, u8),
    error: f32,
}

/// Moves each end, by less and less, as long as the error falls. Ends keep their order, which chooses the values in between.
fn searched(values: &[(usize, f32)], ends: Option<(u8, u8)>) -> Candidate {
    let candidate = |ends: (u8, u8)| {
        let codes = codes(ends.0, ends.1);
        Candidate { ends, error: values.iter().map(|&(_, value)| nearest(&codes, value).1).sum() }
    };
    let mut best = candidate(ends.unwrap_or((0, 0)));
    let is_falling = best.ends.0 > best.ends.1;
    let mut step = FIRST_MOVE;
    while step > 0 && best.error > 0.0 {
        let moves = [(step, 0), (-step, 0), (0, step), (0, -step)];
        let moved = |(a, b): (i16, i16)| {
            let end = |end: u8, by: i16| u8::try_from(i16::from(end) + by).ok();
            let ends = (end(best.ends.0, a)?, end(best.ends.1, b)?);
            ((ends.0 > ends.1) == is_falling).then(|| candidate(ends))
        };
        match moves.into_iter().filter_map(moved).min_by(|a, b| a.error.total_cmp(&b.error)) {
            Some(better) if better.error < best.error => best = better,
            _ => step /= 2,
        }
    }
    best
}

/// The index of the code nearest to a value, and the square of their difference.
fn nearest(codes: &[f32; 8], value: f32) -> (usize, f32) {
    let mut nearest = (0, f32::INFINITY);
    for (index, code) in codes.iter().enumerate() {
        let error = (code - value) * (code - value);
        if error < nearest.1 {
            nearest = (index, error);
        }
    }
    nearest
}
