//! What the paper prints in section 5: frames per second, of Venus and Face on an SGI Indigo2 with MaxImpact graphics, of the machine
//! room on an InfiniteReality.

/// One row of the paper: a model drawn by one variant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PaperRow {
    /// The model, as named there.
    pub model: &'static str,
    /// Its triangles, as printed.
    pub triangles: u32,
    /// The built-in mesh of that size that stands in for it.
    pub stand_in: &'static str,
    /// The variant's label in [`variants`](super::variants).
    pub variant: &'static str,
    /// Frames per second with silhouettes.
    pub fps: f64,
    /// Frames per second without.
    pub plain_fps: f64,
}

impl PaperRow {
    /// Frame rate with silhouettes over the rate without, 0 to 1.
    pub fn rate_kept(&self) -> f64 {
        self.fps / self.plain_fps
    }
}

/// Venus, Face and AMR (the auxiliary machine room).
pub const ROWS: [PaperRow; 5] = [
    venus("wireframe", 40.0),
    venus("scale 0.99", 50.0),
    venus("fatten", 11.5),
    PaperRow {
        model: "Face",
        triangles: 13_408,
        stand_in: "builtin:blob:13408",
        variant: "charcoal",
        fps: 5.0,
        plain_fps: 30.0,
    },
    PaperRow {
        model: "AMR",
        triangles: 252_000,
        stand_in: "builtin:machine-room",
        variant: "wireframe",
        fps: 4.2,
        plain_fps: 6.0,
    },
];

const fn venus(variant: &'static str, fps: f64) -> PaperRow {
    PaperRow { model: "Venus", triangles: 5672, stand_in: "builtin:blob:5672", variant, fps, plain_fps: 66.0 }
}

#[cfg(test)]
mod tests {
    use super::super::variants::VARIANTS;
    use super::*;
    use silhouette_core::method::Method;
    use silhouette_image_precision::ImagePrecision;

    #[test]
    fn rates_kept_are_shares_and_variants_exist() {
        let kept = ROWS.map(|row| (row.rate_kept() * 1000.0).round() as u32);
        assert_eq!(kept, [606, 758, 174, 167, 700]);
        assert!(ROWS.iter().all(|row| VARIANTS.iter().any(|variant| variant.label == row.variant)));
    }

    #[test]
    fn reports_show_the_same_rates() {
        let printed = ROWS.map(|row| (row.fps, row.plain_fps));
        let shown =
            ImagePrecision::INFO.published.iter().flat_map(|rates| rates.rows).map(|row| (row.fps, row.against_fps));
        assert_eq!(shown.collect::<Vec<_>>(), printed);
    }
}
