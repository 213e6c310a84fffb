//! [`Tile`]: part of a block, the unit of work of a bake.
//!
//! Texels are baked from coarse to fine: those on a grid of [`COARSEST`] texels by scanning every meridian, then those halfway
//! between, and so on. A texel of a finer level follows the borders of the two coarser texels on both sides of it. No tile looks at
//! another, so tiles can be baked in any order, and within a tile all texels of a level.

use crate::atlas::{Atlas, Block, Place};
use crate::border_search::BorderSearch;
use crate::correspondence::Correspondence;
use crate::frame::Frame;
use crate::lobe::{LobeRule, Meridian, Span};
use crate::visibility_function::{HullPoint, VisibilityFunction};
use glam::{DVec3, Vec3};
use half::f16;
use silhouette_core::glam;
use std::f32::consts::TAU;

/// Most texels along a tile's side: what a tile holds while it is baked stays below 3 MB at 64 azimuths, however large blocks are.
pub const TILE_SIDE: u32 = 32;

/// Distance between texels of the coarsest level. A power of two.
pub const COARSEST: u32 = 8;

/// Most meridians by which a texel's own centre is found.
const CENTER_AZIMUTHS: u32 = 16;

/// Least length of the mean direction of a lobe, as a share of the sphere, below which it has no direction.
const LEAST_MOMENT: f64 = 1e-6;

/// A rectangle of texels of one block.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Tile {
    /// Which block.
    pub block: usize,
    /// First column within the block.
    pub x: u32,
    /// First row within the block.
    pub y: u32,
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
}

/// Which centres phi is baked about.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Middle {
    /// That interpolated between vertices.
    Interpolated,
    /// The texel's own.
    Own,
}

/// All that tiles are baked from.
pub struct Source<'a> {
    /// Where faces lie.
    pub atlas: &'a Atlas,
    /// The function that is sampled.
    pub visibility: &'a VisibilityFunction,
    /// Vertices of the hull's faces.
    pub triangles: &'a [[u32; 3]],
    /// C per vertex of the hull.
    pub centers: &'a [Vec3],
    /// T per vertex of the hull.
    pub tangents: &'a [Vec3],
    /// Colours and normals.
    pub correspondence: &'a Correspondence<'a>,
    /// What to bake about.
    pub middle: Middle,
    /// Which angle stands for a meridian.
    pub lobe: LobeRule,
    /// Width to which borders are bracketed, in radians.
    pub tolerance: f32,
    /// Detail texels along a texel's side.
    pub detail: u32,
}

/// What is baked for a tile.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Baked {
    /// Angles as shares of pi: azimuth by azimuth, in rows.
    pub angles: Vec<f32>,
    /// Distances to the outline, in rows, in the object's unit.
    pub gaps: Vec<f32>,
    /// The centres that angles were baked about, in rows.
    pub centers: Vec<[f16; 4]>,
    /// Colours of detail texels, in rows.
    pub colors: Vec<[u8; 4]>,
    /// Normals of detail texels, in rows.
    pub normals: Vec<[f16; 4]>,
    /// Rays cast at the object to find borders.
    pub rays: u64,
    /// Meridians that were scanned.
    pub scans: u64,
    /// Texels whose centre does not show the object.
    pub hidden_centers: u64,
}

/// A texel: where it lies and how directions are expressed there.
#[derive(Clone, Copy)]
pub(crate) struct Texel {
    pub point: HullPoint,
    pub frame: Frame,
}

/// A texel of a tile with the coarser texels on both sides, whose borders it follows; none on the coarsest level.
pub(crate) type Seeded = (usize, [Option<usize>; 2]);

/// The distances at which the meridians of a texel graze the object.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Grazed {
    sum: f32,
    count: u32,
}

impl Grazed {
    pub fn add(&mut self, distance: Option<f32>) {
        self.sum += distance.unwrap_or(0.0);
        self.count += u32::from(distance.is_some());
    }

    /// 0 if no meridian does.
    fn mean(&self) -> f32 {
        if self.count > 0 { self.sum / self.count as f32 } else { 0.0 }
    }
}

/// Azimuths with their cosines and sines.
fn azimuths(count: u32) -> Vec<[f32; 2]> {
    (0..count)
        .map(|index| {
            let (sin, cos) = (index as f32 / count as f32 * TAU).sin_cos();
            [cos, sin]
        })
        .collect()
}

impl Tile {
    /// The tiles of an atlas, block by block.
    pub fn all(atlas: &Atlas) -> Vec<Self> {
        let side = atlas.side();
        let starts = || (0..side).step_by(TILE_SIDE as usize);
        let of_block = |block| {
            starts().flat_map(move |y| {
                starts().map(move |x| {
                    let [width, height] = [x, y].map(|start| TILE_SIDE.min(side - start));
                    Self { block, x, y, width, height }
                })
            })
        };
        (0..atlas.blocks().len()).flat_map(of_block).collect()
    }

    pub(crate) fn texels(&self) -> usize {
        (self.width * self.height) as usize
    }

    fn index(&self, x: u32, y: u32) -> usize {
        (y * self.width + x) as usize
    }

    /// All texels of a tile, level by level from coarse to fine.
    pub(crate) fn levels(&self) -> Vec<Vec<Seeded>> {
        let mut levels = Vec::new();
        let mut stride = COARSEST;
        while stride > 0 {
            let mut level = Vec::new();
            for y in (0..self.height).step_by(stride as usize) {
                for x in (0..self.width).step_by(stride as usize) {
                    let offset = |at: u32| if at.is_multiple_of(2 * stride) { 0 } else { stride };
                    let (dx, dy) = (offset(x), offset(y));
                    if stride == COARSEST {
                        level.push((self.index(x, y), [None; 2]));
                    } else if dx + dy > 0 {
                        let before = self.index(x - dx, y - dy);
                        let is_inside = x + dx < self.width && y + dy < self.height;
                        let after = is_inside.then(|| self.index(x + dx, y + dy));
                        level.push((self.index(x, y), [Some(before), after]));
                    }
                }
            }
            levels.push(level);
            stride /= 2;
        }
        levels
    }

    /// Bakes the tile.
    pub fn bake(&self, source: &Source<'_>) -> Baked {
        let mut baked = Baked::default();
        let texels = self.texels_of(source, &mut baked);
        let azimuths = azimuths(source.atlas.size().azimuths);
        let mut angles = vec![0.0; texels.len() * azimuths.len()];
        let mut grazed = vec![Grazed::default(); texels.len()];
        let count = texels.len();
        self.search(source, &texels, &azimuths, &mut baked, |texel, azimuth, meridian, span, graze| {
            angles[azimuth * count + texel] = meridian.angle(span, source.lobe) * std::f32::consts::FRAC_1_PI;
            grazed[texel].add(graze);
        });
        baked.angles = angles;
        self.complete(source, &texels, &grazed, &mut baked);
        baked
    }

    /// Where the texels lie, and about what directions are expressed there.
    pub(crate) fn texels_of(&self, source: &Source<'_>, baked: &mut Baked) -> Vec<Texel> {
        let block = &source.atlas.blocks()[self.block];
        let mut texels: Vec<Texel> = (0..self.texels() as u32)
            .map(|index| {
                let place = source.atlas.point(
                    block,
                    f64::from(self.x + index % self.width),
                    f64::from(self.y + index / self.width),
                );
                Texel { point: source.visibility.point(place.face, place.weights), frame: source.frame(&place) }
            })
            .collect();
        if source.middle == Middle::Own {
            self.find_own_centers(source, &mut texels, baked);
        }
        texels
    }

    /// All that is baked beside the angles.
    pub(crate) fn complete(&self, source: &Source<'_>, texels: &[Texel], grazed: &[Grazed], baked: &mut Baked) {
        baked.gaps = grazed.iter().map(Grazed::mean).collect();
        baked.centers = texels.iter().map(|texel| halves(texel.frame.center)).collect();
        self.bake_details(source, &source.atlas.blocks()[self.block], baked);
    }

    /// Replaces the middle of each frame by the mean direction of the texel's lobe.
    fn find_own_centers(&self, source: &Source<'_>, texels: &mut [Texel], baked: &mut Baked) {
        let azimuths = azimuths(source.atlas.size().azimuths.min(CENTER_AZIMUTHS));
        let mut moments = vec![DVec3::ZERO; texels.len()];
        let frames: Vec<Frame> = texels.iter().map(|texel| texel.frame).collect();
        self.search(source, texels, &azimuths, baked, |texel, azimuth, meridian, span, _| {
            let [cos, sin] = azimuths[azimuth];
            let frame = &frames[texel];
            let across = cos * frame.tangent + sin * frame.binormal;
            moments[texel] += meridian.moment(span, frame.center, across) / azimuths.len() as f64;
        });
        for (texel, moment) in texels.iter_mut().zip(moments) {
            if moment.length() > LEAST_MOMENT {
                // As it is stored.
                let center = halves(moment.normalize().as_vec3()).map(f16::to_f32);
                texel.frame = Frame::new(Vec3::new(center[0], center[1], center[2]), texel.frame.tangent);
            }
        }
        baked.hidden_centers = 0;
    }

    /// Finds the borders along all meridians of all texels, from coarse to fine.
    fn search(
        &self,
        source: &Source<'_>,
        texels: &[Texel],
        azimuths: &[[f32; 2]],
        baked: &mut Baked,
        mut found: impl FnMut(usize, usize, &Meridian, Span, Option<f32>),
    ) {
        let mut known = vec![Meridian::default(); texels.len() * azimuths.len()];
        for (index, seeds) in self.levels().into_iter().flatten() {
            let Texel { point, frame } = texels[index];
            let center = source.visibility.distance(&point, frame.center).map(|distance| distance as f32);
            baked.rays += 1;
            baked.hidden_centers += u64::from(center.is_none());
            for (azimuth, &[cos, sin]) in azimuths.iter().enumerate() {
                let across = cos * frame.tangent + sin * frame.binormal;
                let span = Span::new(&frame, across, point.normal);
                let shows = |angle: f32| {
                    let (sin, cos) = angle.sin_cos();
                    let direction = cos * frame.center + sin * across;
                    source.visibility.distance(&point, direction).map(|distance| distance as f32)
                };
                let mut search = BorderSearch::new(shows, source.tolerance);
                let seed = expected(seeds.map(|seed| seed.map(|seed| &known[seed * azimuths.len() + azimuth])));
                let followed = seed
                    .and_then(|(seed, spread)| search.follow(span, center, &seed, source.tolerance + spread * 0.25));
                let meridian = followed.unwrap_or_else(|| {
                    baked.scans += 1;
                    search.scan(span, center)
                });
                baked.rays += search.calls;
                found(index, azimuth, &meridian, span, search.grazed);
                known[index * azimuths.len() + azimuth] = meridian;
            }
        }
    }

    fn bake_details(&self, source: &Source<'_>, block: &Block, baked: &mut Baked) {
        let detail = source.detail;
        let (width, height) = (self.width * detail, self.height * detail);
        let offset = |start: u32, at: u32| f64::from(start) - 0.5 + (f64::from(at) + 0.5) / f64::from(detail);
        for y in 0..height {
            for x in 0..width {
                let place = source.atlas.point(block, offset(self.x, x), offset(self.y, y));
                let position = source.visibility.point(place.face, place.weights).position;
                let vertices = source.triangles[place.face.index()];
                let (color, normal) = source.correspondence.at(position, vertices, place.weights);
                baked.colors.push(color);
                baked.normals.push(halves(normal));
            }
        }
    }
}

impl Source<'_> {
    fn frame(&self, place: &Place) -> Frame {
        let vertices = self.triangles[place.face.index()];
        let mix = |values: &[Vec3]| (0..3).map(|at| place.weights[at] * values[vertices[at] as usize]).sum::<Vec3>();
        Frame::new(mix(self.centers), mix(self.tangents))
    }
}

fn halves(vector: Vec3) -> [f16; 4] {
    [vector.x, vector.y, vector.z, 0.0].map(f16::from_f32)
}

/// The meridian halfway between those of two neighbours, and how far apart they are. Where only one is there, or they are unlike
/// each other, the first.
fn expected(seeds: [Option<&Meridian>; 2]) -> Option<(Meridian, f32)> {
    let first = *seeds[0]?;
    let alike = seeds[1].filter(|second| {
        second.is_shown_first == first.is_shown_first && second.borders().len() == first.borders().len()
    });
    let Some(second) = alike else { return Some((first, 0.0)) };
    let pairs = || first.borders().iter().zip(second.borders());
    let spread = pairs().map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
    Some((Meridian::new(first.is_shown_first, pairs().map(|(a, b)| (a + b) * 0.5).collect()), spread))
}
