//! [`Shading`]: how the surfaces of this crate's methods are coloured.

silhouette_core::option_choice! {
    /// How faces look.
    pub enum Shading {
        /// Lit from the viewer's upper left by Lambert's law, with interpolated normals.
        Lit = "lit",
        /// In one grey.
        Flat = "flat",
    }
}

#[cfg(feature = "gpu")]
impl Shading {
    /// The same for a renderer, in a grey from 0 (black) to 1 (white), sRGB as displayed.
    pub fn shade(self, grey: f64) -> silhouette_gpu::Shade {
        let color = silhouette_gpu::Color { srgb: [grey; 3], alpha: 1.0 };
        match self {
            Self::Lit => silhouette_gpu::Shade::Lit(color),
            Self::Flat => silhouette_gpu::Shade::Flat(color),
        }
    }
}
