//! Directions to look from.

use silhouette_core::glam::DVec3;

/// `count` unit vectors spread evenly over the sphere, on a golden spiral.
pub fn spread(count: u32) -> impl Iterator<Item = DVec3> {
    let golden = std::f64::consts::PI * (3.0 - 5.0_f64.sqrt());
    (0..count).map(move |index| {
        let height = 1.0 - (2.0 * f64::from(index) + 1.0) / f64::from(count);
        let (sine, cosine) = (golden * f64::from(index)).sin_cos();
        let across = (1.0 - height * height).sqrt();
        DVec3::new(across * cosine, height, across * sine)
    })
}
