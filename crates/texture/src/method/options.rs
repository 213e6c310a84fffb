//! The options of the methods, in the words of the command line.

use crate::bake::BakeOptions;

/// What is baked: a hull, a texture on it, and how it is compressed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BakeChoice {
    /// Most vertices of the hull.
    pub hull_vertices: u32,
    /// The texture.
    pub options: BakeOptions,
    /// Terms that are kept; 0 keeps all samples.
    pub terms: u32,
}

silhouette_core::option_choice! {
    /// How the width of lines is kept.
    pub enum WidthLaw {
        /// By the slope of the margin in the image.
        Gradient = "gradient",
        /// By the baked distance from hull to outline.
        Gap = "gap",
        /// Not at all: the paper's equation 5.
        AsPrinted = "as-printed",
    }
}

silhouette_core::option_choice! {
    /// What is drawn inside of outlines.
    pub enum Inside {
        /// White paper.
        Paper = "paper",
        /// Depth alone.
        DepthOnly = "depth-only",
        /// Nothing.
        None = "none",
    }
}

/// A struct of options that begins with what is baked and how it is looked up, with a method that says what is to be baked.
macro_rules! texture_options {
    ($(#[$meta:meta])* pub struct $name:ident { $($own:tt)* }) => {
        silhouette_core::method_options! {
            $(#[$meta])*
            pub struct $name {
                /// Most vertices of the hull.
                pub hull_vertices: u32 = whole("hull-vertices", 4..=1000000, default 500, sweep log 100..=2000),
                /// Texels along either side of a page.
                pub size: u32 = whole("size", 8..=16384 "texels", default 256, sweep log 64..=512),
                /// Azimuths at which each texel's lobe is sampled.
                pub azimuths: u32 = whole("azimuths", 3..=1024, default 32, sweep log 8..=64),
                /// 3-D textures that the hull is spread over, for sizes that no single one can have.
                pub pages: u32 = whole("pages", 1..=1024, default 1),
                /// Which outlines are kept: inner and outer ones, or outer ones alone.
                pub visibility: $crate::VisibilityRule = choice("visibility"),
                /// Which middles of lobes angles are baked about, and drawn with.
                pub centers: $crate::CenterRule = choice("centers"),
                /// The angle where a meridian meets a lobe more than once.
                pub lobe: $crate::LobeRule = choice("lobe"),
                /// How angles are stored.
                pub format: $crate::AngleFormat = choice("format", sweep ["unorm8", "float16"]),
                /// Terms of the compressed texture; 0 keeps all samples.
                pub terms: u32 = whole("terms", 0..=1024, default 0),
                /// Texels of colours and normals along a texel's side.
                pub detail: u32 = whole("detail", 1..=16, default 2, sweep linear 1..=4),
                /// Edges of the mesh whose faces differ by more are shaded as sharp.
                pub crease_deg: f64 = number("crease", 0.0..=180.0 "degrees", default 60.0),
                /// Who filters angles.
                pub filter: $crate::gpu::Filtering = choice("filter", sweep ["native", "float16", "manual"]),
                /// Where azimuths are looked up.
                pub lookup: $crate::lookup::AzimuthRule = choice("lookup"),
                $($own)*
            }
        }

        impl $name {
            /// What is baked.
            pub fn bake(&self) -> $crate::method::BakeChoice {
                let side = self.size;
                let size = $crate::VolumeSize { width: side, height: side, azimuths: self.azimuths, pages: self.pages };
                let options = $crate::BakeOptions {
                    size,
                    rule: self.visibility,
                    centers: self.centers,
                    lobe: self.lobe,
                    format: self.format,
                    detail: self.detail,
                    crease_deg: self.crease_deg,
                    ..$crate::BakeOptions::default()
                };
                $crate::method::BakeChoice { hull_vertices: self.hull_vertices, options, terms: self.terms }
            }
        }
    };
}

pub(super) use texture_options;
