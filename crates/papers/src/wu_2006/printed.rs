//! What the paper prints: Table 1, and section 3.5 with Fig. 10.

/// A row of Table 1. Frames per second are those of a GeForce 7800 GT.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PaperRow {
    /// The model, as named there.
    pub model: &'static str,
    /// Vertices of the mesh.
    pub vertices: u32,
    /// Vertices of the hull.
    pub hull_vertices: u32,
    /// Width and height of the window.
    pub window_px: u32,
    /// Frames per second of the mesh itself.
    pub mesh_fps: f64,
    /// Frames per second of the silhouette texture.
    pub texture_fps: f64,
    /// Average sampling error of the visibility function (Eq. 3), percent.
    pub sampling_error_percent: f64,
}

impl PaperRow {
    /// Frames of the silhouette texture per frame of the mesh.
    pub fn speed_up(&self) -> f64 {
        self.texture_fps / self.mesh_fps
    }
}

/// Table 1, in its order.
pub const ROWS: [PaperRow; 5] = [
    row("Armadillo", [40_002, 1000, 512], [308.0, 725.0], 0.426),
    row("Bunny", [34_834, 500, 512], [411.0, 638.0], 0.402),
    row("Gargoyle", [30_002, 500, 512], [460.0, 762.0], 0.309),
    row("Dragon", [40_525, 970, 512], [523.0, 674.0], 0.409),
    row("Lucy", [1_000_000, 10_000, 1024], [1.5, 273.0], 0.805),
];

const fn row(
    model: &'static str,
    [vertices, hull_vertices, window_px]: [u32; 3],
    [mesh_fps, texture_fps]: [f64; 2],
    sampling_error_percent: f64,
) -> PaperRow {
    PaperRow { model, vertices, hull_vertices, window_px, mesh_fps, texture_fps, sampling_error_percent }
}

/// Texels along a side, and azimuths, of the paper's textures.
pub const SIDE: u32 = 512;
/// Azimuths of the paper's textures.
pub const AZIMUTHS: u32 = 64;

/// Fig. 10: terms kept, and the PSNR in dB, of a model that is not named and by a definition that is not stated.
pub const TERMS: [(u32, f64); 3] = [(16, 45.99), (8, 39.52), (4, 30.91)];

/// How many times slower compressed textures are drawn.
pub const COMPRESSED_SLOWDOWN: [f64; 2] = [5.0, 8.0];

/// Fig. 14: texels along a side.
pub const SIDES: [u32; 3] = [512, 128, 32];
/// Fig. 14: azimuths.
pub const FEWER_AZIMUTHS: [u32; 3] = [64, 16, 4];

/// Fig. 13: vertices of the coarsest hull.
pub const COARSEST_HULL: u32 = 22;

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::method::Method;
    use silhouette_texture::Texture;

    #[test]
    fn speed_ups_are_those_of_the_text() {
        let speed_ups = ROWS.map(|row| row.speed_up());
        assert!((1.2..1.3).contains(&speed_ups[3]) && (181.0..183.0).contains(&speed_ups[4]), "{speed_ups:?}");
        let bytes = SIDE * SIDE * TERMS[0].0 + TERMS[0].0 * AZIMUTHS;
        assert_eq!((SIDE * SIDE * AZIMUTHS, bytes), (16 << 20, 4_195_328));
    }

    #[test]
    fn reports_show_the_same_rates() {
        let printed = ROWS.map(|row| (row.texture_fps, row.mesh_fps));
        let shown = Texture::INFO.published.iter().flat_map(|rates| rates.rows).map(|row| (row.fps, row.against_fps));
        assert_eq!(shown.collect::<Vec<_>>(), printed);
    }
}
