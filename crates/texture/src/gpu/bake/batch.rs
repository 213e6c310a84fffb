//! [`Batch`]: texels of some tiles, in the order in which a device searches them.

use crate::gpu::bake::device_texel::{DeviceTexel, NO_SLOT};
use crate::tile::{Baked, Source, Texel, Tile};
use rayon::prelude::*;
use std::ops::Range;

/// Samples per batch, at least one tile: 36 bytes per sample on the device at most, and 8 for reading back.
const MOST_SAMPLES: u64 = 1 << 21;

/// A tile that is about to be baked.
pub(super) struct Start {
    pub tile: Tile,
    pub texels: Vec<Texel>,
    /// The centres' rays, if texels have their own.
    pub baked: Baked,
    /// Per texel, its place in [`Batch::texels`].
    pub slots: Vec<u32>,
}

/// Texels of all tiles, level by level.
pub(super) struct Batch {
    pub starts: Vec<Start>,
    pub texels: Vec<DeviceTexel>,
    /// The slots of each level, from coarse to fine.
    pub levels: Vec<Range<u32>>,
}

impl Batch {
    /// How many of these tiles make a batch: at least 1, if there are any.
    pub fn tiles_of(tiles: &[Tile], azimuths: u32) -> usize {
        let mut samples = 0;
        let fit = tiles.iter().take_while(|tile| {
            samples += tile.texels() as u64 * u64::from(azimuths);
            samples <= MOST_SAMPLES
        });
        fit.count().max(1).min(tiles.len())
    }

    /// Places and frames of all texels. In parallel.
    pub fn new(tiles: &[Tile], source: &Source<'_>) -> Self {
        let start = |&tile: &Tile| {
            let mut baked = Baked::default();
            let texels = tile.texels_of(source, &mut baked);
            Start { tile, slots: vec![NO_SLOT; texels.len()], texels, baked }
        };
        let mut starts: Vec<Start> = tiles.par_iter().map(start).collect();
        let of_tiles: Vec<_> = tiles.iter().map(Tile::levels).collect();
        let (mut texels, mut levels) = (Vec::new(), Vec::new());
        for level in 0..of_tiles.first().map_or(0, Vec::len) {
            let first = texels.len() as u32;
            for (start, of_tile) in starts.iter_mut().zip(&of_tiles) {
                for &(index, seeds) in &of_tile[level] {
                    start.slots[index] = texels.len() as u32;
                    let seeds = seeds.map(|seed| seed.map_or(NO_SLOT, |seed| start.slots[seed]));
                    texels.push(DeviceTexel::new(&start.texels[index], seeds, source.visibility));
                }
            }
            levels.push(first..texels.len() as u32);
        }
        Self { starts, texels, levels }
    }

    /// Texels whose borders others follow: those of all levels but the finest.
    pub fn known_texels(&self) -> u32 {
        self.levels.last().map_or(0, |finest| finest.start)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What a device relies on: a level reads only what earlier levels have written.
    #[test]
    fn texels_follow_texels_of_coarser_levels_only() {
        for (width, height) in [(32, 32), (1, 1), (9, 5), (17, 32)] {
            let tile = Tile { block: 0, x: 0, y: 0, width, height };
            let mut level_of = vec![None; tile.texels()];
            for (level, texels) in tile.levels().into_iter().enumerate() {
                for (index, seeds) in texels {
                    assert_eq!(seeds[0].is_none(), level == 0);
                    assert!(seeds.into_iter().flatten().all(|seed| level_of[seed].is_some_and(|of| of < level)));
                    assert_eq!(level_of[index].replace(level), None);
                }
            }
            assert!(level_of.iter().all(Option::is_some), "{width} x {height}");
        }
    }

    #[test]
    fn batches_are_neither_empty_nor_too_large() {
        let tile = Tile { block: 0, x: 0, y: 0, width: 32, height: 32 };
        assert_eq!(Batch::tiles_of(&[tile; 100], 64), 32);
        assert_eq!(Batch::tiles_of(&[tile; 3], 64), 3);
        assert_eq!(Batch::tiles_of(&[tile; 3], 4096), 1);
        assert_eq!(Batch::tiles_of(&[], 64), 0);
    }
}
