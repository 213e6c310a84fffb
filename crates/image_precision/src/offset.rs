//! Section 3.2: polygon offset, the paper's `glPolygonOffset`, for back faces.
//!
//! A depth of `slope * max(|dz/dx|, |dz/dy|) + constant * r` is taken away, in units of the depth buffer, where r is the
//! least step that the format can resolve. The maximum instead of the gradient's length makes widths depend on the
//! direction by up to the square root of 2; faces nearly edge-on have slopes without bound and show through everything
//! before them, unless `clamp` bounds the whole.

/// Width of the ink at a crease in pixels, for inward depth slopes a of the front face and b > a of the back face and a
/// back face that leans along an axis of the image: `slope |b| / (b - a)`. Half of `slope` where b = -a, which every
/// smooth rim comes to; `slope` where the front face is face-on; without bound at knife edges.
pub fn wedge_width_px(slope: f64, front_slope: f64, back_slope: f64) -> f64 {
    slope * back_slope.abs() / (back_slope - front_slope)
}

#[cfg(feature = "gpu")]
pub(crate) fn bias(
    formats: silhouette_gpu::TargetFormats,
    slope: f64,
    constant: f64,
    clamp: f64,
) -> wgpu::DepthBiasState {
    let towards_viewer = match formats.depth_direction {
        silhouette_core::view::DepthDirection::Standard => -1.0,
        silhouette_core::view::DepthDirection::Reversed => 1.0,
    };
    wgpu::DepthBiasState {
        constant: (towards_viewer * constant) as i32,
        slope_scale: (towards_viewer * slope) as f32,
        clamp: (towards_viewer * clamp) as f32,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_smooth_rim_has_half_the_width_of_a_face_on_crease() {
        assert!((wedge_width_px(4.0, -3.0, 3.0) - 2.0).abs() < 1e-12);
        assert!((wedge_width_px(4.0, 0.0, 3.0) - 4.0).abs() < 1e-12);
        assert!(wedge_width_px(4.0, 2.99, 3.0) > 1000.0);
    }
}
