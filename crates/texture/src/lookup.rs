//! [`Lookup`]: whether a hull point shows the object in a direction, as the texture says (section 3.4 and appendix A).
//!
//! The renderer's arithmetic without a GPU, for measuring what sampling costs.

use crate::atlas::Place;
use crate::frame::Frame;
use crate::silhouette_texture::{Angles, SilhouetteTexture};
use crate::tile_bytes::of_unorm8;
use glam::{Vec2, Vec3};
use half::f16;
use silhouette_core::glam;
use std::f32::consts::PI;

silhouette_core::option_choice! {
    /// Where along the third texture coordinate an azimuth is looked up.
    pub enum AzimuthRule {
        /// At the middle of the texel in which its sample is stored.
        Aligned = "aligned",
        /// At the azimuth itself, half a texel away from its sample, as in the paper's shader: lobes are turned by half a step.
        /// For comparison only.
        AsPrinted = "as-printed",
    }
}

/// A texture to be looked up in.
#[derive(Debug, Clone, Copy)]
pub struct Lookup<'a> {
    texture: &'a SilhouetteTexture,
    azimuths: AzimuthRule,
}

/// The two texels between which a value lies along one axis, and the weight of the second.
#[derive(Debug, Clone, Copy)]
struct Between {
    texels: [u32; 2],
    share: f32,
}

impl<'a> Lookup<'a> {
    /// Looks up in `texture`.
    pub fn new(texture: &'a SilhouetteTexture, azimuths: AzimuthRule) -> Self {
        Self { texture, azimuths }
    }

    /// Whether the point shows the object in a direction of any length (equation 4).
    pub fn shows(&self, place: &Place, direction: Vec3) -> bool {
        let frame = self.frame(place);
        frame.angle(direction) <= self.angle(place, &frame, direction)
    }

    /// The frame at a point: interpolated between vertices, its middle filtered from the texture if that has one.
    pub fn frame(&self, place: &Place) -> Frame {
        let parts = self.texture.parts();
        let vertices = parts.hull.mesh().triangles()[place.face.index()];
        let mix = |values: &[Vec3]| (0..3).map(|at| place.weights[at] * values[vertices[at] as usize]).sum::<Vec3>();
        let center = parts.texel_centers.as_ref().map_or_else(
            || mix(&parts.centers),
            |centers| {
                self.filter(place, |page, x, y| {
                    let [x, y, z, _] = centers[parts.size.texel(page, x, y)].map(f16::to_f32);
                    Vec3::new(x, y, z)
                })
            },
        );
        Frame::new(center, mix(&parts.tangents))
    }

    /// The angle between the middle of the lobe and its border at the azimuth of a direction, in radians, by trilinear filtering.
    pub fn angle(&self, place: &Place, frame: &Frame, direction: Vec3) -> f32 {
        let size = self.texture.parts().size;
        let shift = match self.azimuths {
            AzimuthRule::Aligned => 0.0,
            AzimuthRule::AsPrinted => 0.5,
        };
        let at = frame.azimuth(direction) * size.azimuths as f32 - shift;
        let wrap = |index: f32| index.rem_euclid(size.azimuths as f32) as u32 % size.azimuths;
        let azimuths = [wrap(at.floor()), wrap(at.floor() + 1.0)];
        let along = |page, x, y| azimuths.map(|azimuth| self.sample(page, azimuth, x, y));
        let [low, high] = self.filter(place, |page, x, y| Vec2::from(along(page, x, y))).to_array();
        (low + (high - low) * (at - at.floor())) * PI
    }

    /// Bilinear filtering of a value per texel at a point.
    fn filter<T: std::ops::Mul<f32, Output = T> + std::ops::Add<Output = T>>(
        &self,
        place: &Place,
        value: impl Fn(u32, u32, u32) -> T,
    ) -> T {
        let parts = self.texture.parts();
        let corners = parts.places[place.face.index()].corners;
        let at = (0..3).map(|corner| place.weights[corner] * corners[corner]).sum::<Vec2>();
        let page = parts.places[place.face.index()].page;
        let (x, y) = (Between::new(at.x, parts.size.width), Between::new(at.y, parts.size.height));
        let row = |y: u32| {
            let [left, right] = x.texels.map(|x| value(page, x, y));
            left * (1.0 - x.share) + right * x.share
        };
        row(y.texels[0]) * (1.0 - y.share) + row(y.texels[1]) * y.share
    }

    /// A sample as a share of pi.
    fn sample(&self, page: u32, azimuth: u32, x: u32, y: u32) -> f32 {
        let parts = self.texture.parts();
        let index = || parts.size.sample(page, azimuth, x, y);
        match &parts.angles {
            Angles::Unorm8(values) => of_unorm8(values[index()]),
            Angles::Float16(values) => values[index()].to_f32(),
            Angles::Terms(terms) => {
                let (texel, texels) = (parts.size.texel(page, x, y), parts.size.texels() as usize);
                let term = |at: usize| {
                    let weight = f32::from(terms.weights[at * texels + texel]) / 255.0;
                    (terms.offsets[at] + terms.scales[at] * weight) * terms.functions[at][azimuth as usize]
                };
                (0..terms.functions.len()).map(term).sum()
            }
        }
    }
}

impl Between {
    /// A coordinate from 0 to 1 across `count` texels, clamped at the border.
    fn new(coordinate: f32, count: u32) -> Self {
        let at = coordinate * count as f32 - 0.5;
        let clamp = |index: f32| index.clamp(0.0, (count - 1) as f32) as u32;
        Self { texels: [clamp(at.floor()), clamp(at.floor() + 1.0)], share: at - at.floor() }
    }
}
