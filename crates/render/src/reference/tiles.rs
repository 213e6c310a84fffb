//! A viewport cut into tiles of bounded size, each with an apron.

use silhouette_gpu::{FrameView, FrameViewError};

/// A rectangle of a viewport, drawn at several samples per pixel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Tile {
    /// Top left corner in pixels of the viewport; it may lie outside.
    pub origin_px: [i32; 2],
    /// Width and height in pixels of the viewport.
    pub size_px: [u32; 2],
    /// Samples along each side of a pixel.
    pub scale: u32,
}

/// Most samples along each side of a tile, apron included.
const MAX_SAMPLES: u32 = 2048;

/// Tiles of one size that cover a viewport.
///
/// A stroke that enters a tile may have its centre line, where visibility is decided, outside. So each tile is drawn
/// with an apron as wide as strokes reach, which is left out of the picture.
#[derive(Debug, Clone, Copy)]
pub(super) struct Tiling {
    size_px: [u32; 2],
    n: u32,
    apron_px: u32,
    inner_px: [u32; 2],
}

/// One tile with the part of the picture that comes from it.
#[derive(Debug, Clone, Copy)]
pub(super) struct PlacedTile {
    /// What is drawn, apron included.
    pub tile: Tile,
    apron_px: u32,
    /// Top left corner and size of the part in the picture.
    at_px: [u32; 2],
    part_px: [u32; 2],
}

impl Tiling {
    /// Tiles for a viewport of `size_px` with `n` x `n` samples a pixel and strokes that reach `reach_px`. A reach of
    /// more than a quarter of a tile is cut to that.
    pub fn new(size_px: [u32; 2], n: u32, reach_px: f64) -> Self {
        let side_px = MAX_SAMPLES / n;
        let fits = size_px.iter().all(|&side| side <= side_px);
        let apron_px = if fits { 0 } else { (reach_px.ceil() as u32).saturating_add(2).min(side_px / 4) };
        let inner_px = size_px.map(|side| side.min(side_px - 2 * apron_px));
        Self { size_px, n, apron_px, inner_px }
    }

    /// Width and height of a tile in pixels, apron included.
    pub fn tile_px(&self) -> [u32; 2] {
        self.inner_px.map(|side| side + 2 * self.apron_px)
    }

    /// Width and height of a tile in samples, apron included.
    pub fn target_px(&self) -> [u32; 2] {
        self.tile_px().map(|side| side * self.n)
    }

    /// The tiles, row by row.
    pub fn tiles(self) -> impl Iterator<Item = PlacedTile> {
        let [width, height] = self.size_px;
        let rows = (0..height).step_by(self.inner_px[1] as usize);
        rows.flat_map(move |y| {
            (0..width).step_by(self.inner_px[0] as usize).map(move |x| PlacedTile {
                tile: Tile {
                    origin_px: [x, y].map(|corner| corner as i32 - self.apron_px as i32),
                    size_px: self.tile_px(),
                    scale: self.n,
                },
                apron_px: self.apron_px,
                at_px: [x, y],
                part_px: [self.inner_px[0].min(width - x), self.inner_px[1].min(height - y)],
            })
        })
    }
}

impl PlacedTile {
    /// The view of this tile, of the view of the whole.
    pub fn view(&self, whole: &FrameView) -> Result<FrameView, FrameViewError> {
        let Tile { origin_px, size_px, scale } = self.tile;
        whole.tile(origin_px, size_px, scale)
    }

    /// Copies this tile's part from `tile` (rows of `tile_width`) into `whole` (rows of `whole_width`), where a pixel
    /// of the viewport has `scale` x `scale` elements of `channels` values each.
    pub fn copy_rows<T: Copy>(
        &self,
        whole: &mut [T],
        whole_width: u32,
        scale: u32,
        channels: usize,
        tile: &[T],
        tile_width: u32,
    ) {
        let length = (self.part_px[0] * scale) as usize * channels;
        for row in 0..self.part_px[1] * scale {
            let offset = |x: u32, y: u32, width: u32| (y as usize * width as usize + x as usize) * channels;
            let from = offset(self.apron_px * scale, self.apron_px * scale + row, tile_width);
            let to = offset(self.at_px[0] * scale, self.at_px[1] * scale + row, whole_width);
            whole[to..to + length].copy_from_slice(&tile[from..from + length]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tiles_cover_every_pixel_once_with_what_belongs_there() {
        for (size, n, reach) in [([7, 5], 4, 3.0), ([1300, 700], 4, 2.5), ([600, 3000], 3, 1e9), ([2100, 1], 1, 0.0)] {
            let tiling = Tiling::new(size, n, reach);
            assert!(tiling.target_px().iter().all(|&side| side <= MAX_SAMPLES), "{size:?}");
            let mut whole = vec![u32::MAX; (size[0] * size[1]) as usize];
            for placed in tiling.tiles() {
                let [width, height] = placed.tile.size_px;
                let [x0, y0] = placed.tile.origin_px;
                let name = |x: i32, y: i32| (y * size[0] as i32 + x) as u32;
                let tile: Vec<_> =
                    (0..height * width).map(|i| name(x0 + (i % width) as i32, y0 + (i / width) as i32)).collect();
                placed.copy_rows(&mut whole, size[0], 1, 1, &tile, width);
            }
            assert!(whole.iter().enumerate().all(|(i, &name)| name == i as u32), "{size:?}");
        }
    }
}
