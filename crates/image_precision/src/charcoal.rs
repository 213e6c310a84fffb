//! Section 4: charcoal. Front faces that are nearly edge-on, `0 < V.N < band` with V towards the viewer, are fattened like
//! back faces, and all of it is grey, `(1 + V.N) / 3`; front faces may have Gooch's shading instead (`interior=gooch`).
//!
//! The paper's band of 0.1 is 5.7 degrees: [`band_width`] of a sphere's radius, below a pixel for spheres of less than 200
//! pixels. It greys vertices by their normals; here each polygon has one grey, since normals of vertices need adjacency.

/// Width of the band on a sphere as a share of its radius in the image: `1 - sqrt(1 - band²)`.
pub fn band_width(band: f64) -> f64 {
    1.0 - (1.0 - band * band).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_papers_band_is_half_a_percent_of_a_sphere() {
        assert!((band_width(0.1) - 0.005).abs() < 2e-5);
        assert!((band_width(1.0) - 1.0).abs() < 1e-12);
    }
}
