//! What is baked for a tile as bytes, for a checkpoint. Little-endian; lengths follow from the tile. Angles are stored as in the
//! texture.

use crate::bake::AngleFormat;
use crate::tile::{Baked, Tile};
use half::f16;

/// The share of pi that 8 bits stand for.
pub fn of_unorm8(byte: u8) -> f32 {
    f32::from(byte) / 255.0
}

/// The 8 bits nearest to a share of pi.
pub fn to_unorm8(share: f32) -> u8 {
    (share.clamp(0.0, 1.0) * 255.0).round() as u8
}

/// The bytes of a tile.
pub fn write(baked: &Baked, format: AngleFormat) -> Vec<u8> {
    let mut bytes = Vec::new();
    for count in [baked.rays, baked.scans, baked.hidden_centers] {
        bytes.extend(count.to_le_bytes());
    }
    match format {
        AngleFormat::Unorm8 => bytes.extend(baked.angles.iter().map(|&share| to_unorm8(share))),
        AngleFormat::Float16 => bytes.extend(baked.angles.iter().flat_map(|&share| f16::from_f32(share).to_le_bytes())),
    }
    baked.gaps.iter().for_each(|gap| bytes.extend(gap.to_le_bytes()));
    baked.centers.iter().chain(&baked.normals).flatten().for_each(|value| bytes.extend(value.to_le_bytes()));
    baked.colors.iter().for_each(|color| bytes.extend(color));
    bytes
}

/// The tile of some bytes; `None` if there are more or fewer than the tile has.
pub fn read(tile: &Tile, format: AngleFormat, azimuths: u32, detail: u32, bytes: &[u8]) -> Option<Baked> {
    let texels = tile.texels();
    let (angles, details) = (texels * azimuths as usize, texels * (detail * detail) as usize);
    let mut rest = bytes;
    let mut take = |length: usize| {
        let (head, tail) = rest.split_at_checked(length)?;
        rest = tail;
        Some(head)
    };
    let counts = take(24)?;
    let count = |at: usize| counts[at * 8..].first_chunk().map(|&bytes| u64::from_le_bytes(bytes));
    let floats = |bytes: &[u8]| bytes.as_chunks().0.iter().map(|&chunk| f32::from_le_bytes(chunk)).collect();
    let quads = |bytes: &[u8]| {
        let value = |at: [u8; 2]| f16::from_le_bytes(at);
        let quad = |chunk: &[u8; 8]| [0, 2, 4, 6].map(|at| value([chunk[at], chunk[at + 1]]));
        bytes.as_chunks().0.iter().map(quad).collect()
    };
    let baked = Baked {
        rays: count(0)?,
        scans: count(1)?,
        hidden_centers: count(2)?,
        angles: match format {
            AngleFormat::Unorm8 => take(angles)?.iter().map(|&byte| of_unorm8(byte)).collect(),
            AngleFormat::Float16 => {
                take(angles * 2)?.as_chunks().0.iter().map(|&chunk| f16::from_le_bytes(chunk).to_f32()).collect()
            }
        },
        gaps: floats(take(texels * 4)?),
        centers: quads(take(texels * 8)?),
        normals: quads(take(details * 8)?),
        colors: take(details * 4)?.as_chunks().0.to_vec(),
    };
    rest.is_empty().then_some(baked)
}
