//! [`HullPoint::margin`]: whether a hull point shows the object in a direction (equation 4), and by how much. Stages:
//! `shaders/texture/carving.wgsl`, and `carving.terms.wgsl` for [`Terms`].
//!
//! Departures from the paper's pixel shader (appendix A):
//!
//! 1. Sample k holds the angle at azimuth k / K of a turn, but the middle of its texel lies at (k + 1/2) / K: [`AzimuthShift`].
//! 2. The direction of view is a unit vector. The printed shader takes it as interpolated, which is shorter: lobes shrink.
//! 3. Texture coordinates beyond a page's border are clamped; only azimuths wrap around.
//! 4. A stored angle of 0 shows nothing, not even the centre of the lobe.

use crate::frame::Frame;
use crate::silhouette_texture::{Angles, SilhouetteTexture, Terms};
use glam::{Vec2, Vec3};
use silhouette_core::{FaceId, glam};
use std::f32::consts::PI;

silhouette_core::option_choice! {
    /// Where in the texture an azimuth is looked up.
    pub enum AzimuthShift {
        /// Azimuth 0 in the middle of the first texel, for which its angle is stored.
        Aligned = "aligned",
        /// As the paper prints it: azimuth 0 at the outer corner of the first texel. Lobes are turned by half a sample.
        AsPrinted = "as-printed",
    }
}

impl AzimuthShift {
    /// What is added to an azimuth, in turns, where there are `azimuths` samples per turn.
    pub fn turns(self, azimuths: u32) -> f32 {
        match self {
            Self::Aligned => 0.5 / azimuths as f32,
            Self::AsPrinted => 0.0,
        }
    }
}

/// A point of the hull as a fragment sees it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HullPoint {
    /// Page.
    pub page: u32,
    /// Texture coordinates, 0 to 1 across the page.
    pub place: Vec2,
    /// Of the lobe.
    pub frame: Frame,
}

impl HullPoint {
    /// The point of a face with these barycentric coordinates, with the frame that is interpolated there.
    ///
    /// # Panics
    /// If the hull has no such face.
    pub fn on_face(texture: &SilhouetteTexture, face: FaceId, weights: [f32; 3]) -> Self {
        let parts = texture.parts();
        let corners = parts.hull.mesh().triangles()[face.index()].map(|vertex| vertex as usize);
        let place = &parts.places[face.index()];
        let at = (0..3).map(|i| weights[i] * place.corners[i]).sum();
        let blend = |values: &[Vec3]| (0..3).map(|i| weights[i] * values[corners[i]]).sum::<Vec3>();
        let center = match &parts.texel_centers {
            None => blend(&parts.centers),
            Some(centers) => Taps::new(texture, at).blend(|x, y| {
                let [x, y, z, _] = centers[parts.size.texel(place.page, x, y)];
                Vec3::new(x.to_f32(), y.to_f32(), z.to_f32())
            }),
        };
        Self { page: place.page, place: at, frame: Frame::new(center, blend(&parts.tangents)) }
    }

    /// How far inside the border of the lobe a direction lies, in radians: the point shows the object from 0 on. The direction
    /// runs from the eye into the object, in the object's own space, and may have any length.
    pub fn margin(&self, texture: &SilhouetteTexture, direction: Vec3, shift: AzimuthShift) -> f32 {
        let azimuths = texture.parts().size.azimuths;
        let share = stored_share(texture, self, self.frame.azimuth(direction) + shift.turns(azimuths));
        if share > 0.0 { PI * share - self.frame.angle(direction) } else { -PI }
    }
}

/// The stored angle over pi, filtered in all three coordinates; `turn` counts from the outer corner of the first texel.
fn stored_share(texture: &SilhouetteTexture, point: &HullPoint, turn: f32) -> f32 {
    let size = texture.parts().size;
    let at = turn.rem_euclid(1.0) * size.azimuths as f32 - 0.5;
    let part = at - at.floor();
    let low = (at.floor() as i64).rem_euclid(i64::from(size.azimuths)) as u32;
    let ends = [low, (low + 1) % size.azimuths];
    let taps = Taps::new(texture, point.place);
    let sample = |azimuth, x, y| size.sample(point.page, azimuth, x, y);
    let [before, after] = match &texture.parts().angles {
        Angles::Unorm8(values) => {
            ends.map(|azimuth| taps.blend(|x, y| f32::from(values[sample(azimuth, x, y)]) / 255.0))
        }
        Angles::Float16(values) => ends.map(|azimuth| taps.blend(|x, y| values[sample(azimuth, x, y)].to_f32())),
        Angles::Terms(terms) => {
            let texels = size.texels() as usize;
            let weight = |term, x, y| f32::from(terms.weights[term * texels + size.texel(point.page, x, y)]) / 255.0;
            ends.map(|azimuth| sum_of_terms(terms, azimuth as usize, |term| taps.blend(|x, y| weight(term, x, y))))
        }
    };
    before + part * (after - before)
}

/// The sum of all terms at an azimuth; `weight` yields that of a term, 0 to 1.
fn sum_of_terms(terms: &Terms, azimuth: usize, weight: impl Fn(usize) -> f32) -> f32 {
    (0..terms.functions.len())
        .map(|term| (terms.offsets[term] + terms.scales[term] * weight(term)) * terms.functions[term][azimuth])
        .sum()
}

/// The four texels around a place, and its distance from the first of them.
struct Taps {
    x: [u32; 2],
    y: [u32; 2],
    part: Vec2,
}

impl Taps {
    fn new(texture: &SilhouetteTexture, place: Vec2) -> Self {
        let size = texture.parts().size;
        let at = place * Vec2::new(size.width as f32, size.height as f32) - 0.5;
        let low = at.floor();
        // Conversions saturate.
        let pair = |low: f32, count: u32| [low, low + 1.0].map(|texel| (texel.max(0.0) as u32).min(count - 1));
        Self { x: pair(low.x, size.width), y: pair(low.y, size.height), part: at - low }
    }

    fn blend<T>(&self, value: impl Fn(u32, u32) -> T) -> T
    where
        T: std::ops::Mul<f32, Output = T> + std::ops::Add<Output = T>,
    {
        let row = |y| value(self.x[0], y) * (1.0 - self.part.x) + value(self.x[1], y) * self.part.x;
        row(self.y[0]) * (1.0 - self.part.y) + row(self.y[1]) * self.part.y
    }
}
