//! [`Target`]: the arrays of a texture while it is baked.

use crate::atlas::Atlas;
use crate::bake::{AngleFormat, Bake, BakeError, BakeOptions, BakeReport, CenterRule};
use crate::silhouette_texture::{Angles, Parts, SilhouetteTexture};
use crate::tile::{Baked, Tile};
use crate::tile_bytes;
use half::f16;
use silhouette_core::glam::Vec3;

/// Arrays of the texture, filled tile by tile.
pub(crate) struct Target {
    parts: Parts,
    pub report: BakeReport,
    /// Of each tile, whether it was restored from a checkpoint.
    pub is_done: Vec<bool>,
}

impl Target {
    /// Arrays of zeros for a bake.
    pub fn new(bake: &Bake<'_>, atlas: &Atlas, tiles: usize, centers: &[Vec3], tangents: &[Vec3]) -> Self {
        let BakeOptions { size, detail, rule, .. } = *bake.options();
        let (texels, samples) = (size.texels() as usize, size.samples() as usize);
        let details = texels * (detail * detail) as usize;
        let block_texels = u64::from(atlas.side()).pow(2) * atlas.blocks().len() as u64;
        Self {
            parts: Parts {
                hull: bake.hull().clone(),
                centers: centers.to_vec(),
                tangents: tangents.to_vec(),
                places: atlas.places(),
                size,
                rule,
                angles: match bake.options().format {
                    AngleFormat::Unorm8 => Angles::Unorm8(vec![0; samples]),
                    AngleFormat::Float16 => Angles::Float16(vec![f16::ZERO; samples]),
                },
                texel_centers: (bake.options().centers == CenterRule::Texel).then(|| vec![[f16::ZERO; 4]; texels]),
                gaps: vec![f16::ZERO; texels],
                detail,
                colors: vec![[0; 4]; details],
                normals: vec![[f16::ZERO; 4]; details],
            },
            report: BakeReport {
                blocks: atlas.blocks().len(),
                block_side: atlas.side(),
                utilisation: atlas.utilisation(),
                samples: block_texels * u64::from(size.azimuths),
                rays: 0,
                scans: 0,
                texels: block_texels,
                hidden_centers: 0,
                restored_tiles: 0,
                tiles: tiles as u64,
            },
            is_done: vec![false; tiles],
        }
    }

    /// Puts a tile from a checkpoint in its place, if it is one.
    pub fn restore(&mut self, atlas: &Atlas, tiles: &[Tile], index: u32, bytes: &[u8]) -> bool {
        let Some(tile) = tiles.get(index as usize) else { return false };
        let format = match &self.parts.angles {
            Angles::Float16(_) => AngleFormat::Float16,
            _ => AngleFormat::Unorm8,
        };
        let Some(baked) = tile_bytes::read(tile, format, self.parts.size.azimuths, self.parts.detail, bytes) else {
            return false;
        };
        if !std::mem::replace(&mut self.is_done[index as usize], true) {
            self.put(atlas, tile, &baked);
            self.report.restored_tiles += 1;
        }
        true
    }

    /// The texture, once all tiles are in place.
    pub fn finish(self) -> Result<(SilhouetteTexture, BakeReport), BakeError> {
        Ok((SilhouetteTexture::new(self.parts)?, self.report))
    }

    /// Puts a tile in its place.
    pub fn put(&mut self, atlas: &Atlas, tile: &Tile, baked: &Baked) {
        let (block, size, parts) = (&atlas.blocks()[tile.block], self.parts.size, &mut self.parts);
        let unit = parts.hull.mesh().bounds().map_or(1.0, |bounds| bounds.radius) as f32;
        let (left, top) = (block.x + tile.x, block.y + tile.y);
        let texels = tile.texels();
        for index in 0..texels as u32 {
            let (x, y) = (left + index % tile.width, top + index / tile.width);
            for azimuth in 0..size.azimuths {
                let share = baked.angles[azimuth as usize * texels + index as usize];
                let sample = size.sample(block.page, azimuth, x, y);
                match &mut parts.angles {
                    Angles::Unorm8(values) => values[sample] = tile_bytes::to_unorm8(share),
                    Angles::Float16(values) => values[sample] = f16::from_f32(share),
                    Angles::Terms(_) => {}
                }
            }
            let texel = size.texel(block.page, x, y);
            parts.gaps[texel] = f16::from_f32(baked.gaps[index as usize] / unit);
            if let Some(centers) = &mut parts.texel_centers {
                centers[texel] = baked.centers[index as usize];
            }
        }
        let (detail, columns) = (parts.detail, (size.width * parts.detail) as usize);
        let row_of =
            |y: u32| (block.page as usize * size.height as usize) * detail as usize + (top * detail + y) as usize;
        let width = (tile.width * detail) as usize;
        for y in 0..tile.height * detail {
            let to = row_of(y) * columns + (left * detail) as usize;
            let from = y as usize * width;
            parts.colors[to..to + width].copy_from_slice(&baked.colors[from..from + width]);
            parts.normals[to..to + width].copy_from_slice(&baked.normals[from..from + width]);
        }
        self.report.rays += baked.rays;
        self.report.scans += baked.scans;
        self.report.hidden_centers += baked.hidden_centers;
    }
}
