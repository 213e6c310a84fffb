//! What the paper prints in Table I: triangles, and frames per second on a GeForce 7800 GT in a PC with one processor of 3 GHz.

/// One row of Table I.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PaperRow {
    /// The model, as named there.
    pub model: &'static str,
    /// Its triangles.
    pub triangles: u32,
    /// Level of PN triangles: points inserted per side.
    pub pn_level: u32,
    /// PN triangles drawn.
    pub pn_triangles: u32,
    /// Triangles drawn by the paper's method, "typical counts".
    pub ours: u32,
    /// Frames per second.
    pub fps: PaperFps,
}

/// Frames per second.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PaperFps {
    /// Without smoothing.
    pub direct: f64,
    /// By boundary curves (B. Wang et al. 2003).
    pub boundary_curve: f64,
    /// By PN triangles.
    pub pn: f64,
    /// By the paper's method, in parallel projection.
    pub orthographic: f64,
    /// By the paper's method, in perspective.
    pub perspective: f64,
}

impl PaperRow {
    /// Triangles drawn over those of the mesh.
    pub fn growth(&self) -> f64 {
        f64::from(self.ours) / f64::from(self.triangles)
    }
}

/// How many copies of a model are drawn, but for the last row.
pub const COPIES: usize = 60;

/// The paper's window in pixels; the model covers 40 to 60 % of it.
pub const WINDOW_PX: [u32; 2] = [1280, 800];

/// What the paper says of the time that silhouette triangles and that perturbation take: less than this share each.
pub const LARGEST_SHARE_PERCENT: f64 = 4.0;

/// All rows, in the order of the table.
pub const ROWS: [PaperRow; 11] = [
    row("Sphere", [200, 3200, 3, 332], [573.0, 60.0, 115.0, 352.0, 347.0]),
    row("Knot", [480, 7680, 3, 884], [605.0, 56.0, 53.0, 152.0, 147.0]),
    row("Bunny", [500, 8000, 3, 800], [442.0, 53.0, 50.0, 75.0, 68.0]),
    row("Fish", [500, 4500, 2, 886], [620.0, 54.0, 77.0, 114.0, 114.0]),
    row("Bear", [500, 8000, 3, 893], [633.0, 54.0, 52.0, 117.0, 112.0]),
    row("Head", [500, 8000, 3, 904], [448.0, 52.0, 54.0, 78.0, 75.0]),
    row("Venus", [500, 4500, 2, 862], [655.0, 56.0, 76.0, 155.0, 153.0]),
    row("Cat", [500, 8000, 3, 842], [372.0, 53.0, 52.0, 74.0, 74.0]),
    row("Cow", [500, 8000, 3, 983], [560.0, 52.0, 51.0, 82.0, 80.0]),
    row("Torus", [576, 5184, 2, 960], [592.0, 57.0, 67.0, 172.0, 167.0]),
    row("Hippo", [43_288, 389_592, 2, 51_842], [462.0, 43.0, 60.0, 99.0, 96.0]),
];

const fn row(model: &'static str, counts: [u32; 4], fps: [f64; 5]) -> PaperRow {
    let [triangles, pn_triangles, pn_level, ours] = counts;
    let [direct, boundary_curve, pn, orthographic, perspective] = fps;
    PaperRow {
        model,
        triangles,
        pn_level,
        pn_triangles,
        ours,
        fps: PaperFps { direct, boundary_curve, pn, orthographic, perspective },
    }
}

/// The row of a model by the name that it has there.
pub fn row_of(model: &str) -> Option<&'static PaperRow> {
    ROWS.iter().find(|row| row.model == model)
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::method::Method;
    use silhouette_smoothing::Smoothing;

    #[test]
    fn levels_count_inserted_points_and_growth_is_as_the_text_says() {
        for row in ROWS {
            assert_eq!(row.pn_triangles, row.triangles * (row.pn_level + 1).pow(2), "{}", row.model);
            assert!((1.19..1.98).contains(&row.growth()), "{}: {}", row.model, row.growth());
            assert!((1.4..3.1).contains(&(row.fps.orthographic / row.fps.pn)), "30 % to over 200 % faster");
        }
    }

    #[test]
    fn reports_show_the_same_rates() {
        let printed = ROWS.map(|row| (row.fps.perspective, row.fps.pn));
        let shown = Smoothing::INFO.published.iter().flat_map(|rates| rates.rows).map(|row| (row.fps, row.against_fps));
        assert_eq!(shown.collect::<Vec<_>>(), printed);
    }
}
