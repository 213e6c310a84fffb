//! [`Shading`]: how the methods of this crate colour faces.

silhouette_core::option_choice! {
    /// How faces look.
    pub enum Shading {
        /// Lit from the viewer's upper left by Lambert's law.
        Lit = "lit",
        /// In one grey.
        Flat = "flat",
    }
}

#[cfg(feature = "gpu")]
impl Shading {
    /// Both sides of faces, coloured so in a grey of this brightness, sRGB as displayed.
    pub(crate) fn style(self, grey: f64) -> silhouette_gpu::FillStyle {
        use silhouette_gpu::{Color, Cull, FillStyle, Shade};
        let color = Color { srgb: [grey; 3], alpha: 1.0 };
        let shade = match self {
            Self::Lit => Shade::Lit(color),
            Self::Flat => Shade::Flat(color),
        };
        FillStyle { shade, cull: Cull::None }
    }
}
