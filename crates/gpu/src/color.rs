//! [`Color`]: a colour as it is displayed, and as a target stores it.

use crate::formats::TargetFormats;

/// A colour in sRGB, as displayed and as style sheets have it, with straight (not premultiplied) alpha. All parts 0 to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Color {
    /// Red, green and blue, sRGB-encoded.
    pub srgb: [f64; 3],
    /// Opacity.
    pub alpha: f64,
}

impl Color {
    /// Opaque black.
    pub const BLACK: Self = Self { srgb: [0.0; 3], alpha: 1.0 };
    /// Opaque white.
    pub const WHITE: Self = Self { srgb: [1.0; 3], alpha: 1.0 };
    /// Nothing.
    pub const TRANSPARENT: Self = Self { srgb: [0.0; 3], alpha: 0.0 };

    /// What a fragment stage yields for this colour on a target: premultiplied by alpha; linear light where
    /// [the target takes linear light](TargetFormats::is_linear), the sRGB values themselves elsewhere.
    pub fn for_target(self, formats: &TargetFormats) -> [f32; 4] {
        let [red, green, blue] =
            self.srgb.map(|part| (if formats.is_linear() { linear(part) } else { part } * self.alpha) as f32);
        [red, green, blue, self.alpha as f32]
    }
}

/// The linear light of an sRGB-encoded value, both 0 to 1 (IEC 61966-2-1).
pub fn linear(encoded: f64) -> f64 {
    if encoded <= 0.040_45 { encoded / 12.92 } else { ((encoded + 0.055) / 1.055).powf(2.4) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::view::DepthDirection;

    fn formats(color: wgpu::TextureFormat) -> TargetFormats {
        let depth = wgpu::TextureFormat::Depth32Float;
        TargetFormats { color, depth, depth_direction: DepthDirection::Reversed, samples: 1 }
    }

    #[test]
    fn colours_are_stored_as_the_target_takes_them() {
        let half = Color { srgb: [0.5, 0.0, 1.0], alpha: 0.5 };
        let stored = half.for_target(&formats(wgpu::TextureFormat::Rgba8Unorm));
        assert_eq!(stored.map(f32::to_bits), [0.25_f32, 0.0, 0.5, 0.5].map(f32::to_bits));
        for format in [wgpu::TextureFormat::Bgra8UnormSrgb, wgpu::TextureFormat::Rgba16Float] {
            let [red, _, blue, alpha] = half.for_target(&formats(format));
            // Half of the way in sRGB is 21.4 % of the light.
            assert!((red - 0.5 * 0.214_041).abs() < 1e-6 && (blue, alpha) == (0.5, 0.5), "{red}");
        }
    }

    #[test]
    fn the_two_pieces_of_the_curve_meet() {
        assert!((linear(0.040_45) - linear(0.040_450_1)).abs() < 1e-6);
        assert!(linear(0.0).abs() < 1e-12 && (linear(1.0) - 1.0).abs() < 1e-12);
    }
}
