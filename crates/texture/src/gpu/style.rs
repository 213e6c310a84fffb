//! [`TextureStyle`]: what is drawn of a silhouette texture, and how.

use crate::lookup::AzimuthRule;
use silhouette_gpu::{Color, Cull, FillStyle, Interior, Shade};
use std::borrow::Cow;

silhouette_core::option_choice! {
    /// How the object's silhouette is cut.
    pub enum Edge {
        /// At whole pixels, as in the paper.
        Hard = "hard",
        /// At each of a pixel's four samples, from the slope of the margin in the image. Needs a target with 4 samples per pixel; on
        /// others edges are hard, and the renderer warns.
        Coverage = "coverage",
    }
}

/// How the surface is coloured.
#[derive(Debug, Clone, PartialEq)]
pub enum Shading {
    /// Baked colour, opaque, lit from the viewer's upper left by Lambert's law with the baked normal.
    Lit,
    /// One colour, opaque.
    Flat(Color),
    /// The baked normal in the object's own space: -1 to 1 as 0 to 1.
    Normals,
    /// The caller's own fragment stage: WGSL that is appended to `shaders/texture/lookup.wgsl` (or `lookup.terms.wgsl`) with all
    /// that it imports, and that declares the entry point `custom`:
    ///
    /// ```wgsl
    /// @fragment
    /// fn custom(in: HullVertex) -> Drawn {
    ///     let samples = carve(in); // 0 where the object is not seen; for the whole hull, leave out
    ///     if samples == 0u { discard; }
    ///     let light = 0.5 + 0.5 * normalize(baked_normal(in)).y;
    ///     return Drawn(for_target(baked_color(in) * light, 1.0, surface.is_linear), samples);
    /// }
    /// ```
    ///
    /// Colours are premultiplied, as `for_target` makes them. `in.point` is the hull point and `view_direction(in)` the direction of
    /// view, both in the local frame: the object's axes. Mistakes in the text go to the device's error handler.
    Custom(Cow<'static, str>),
}

/// How wide outlines are. Half of a line lies outside of the object, as far as the hull reaches.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum OutlineWidth {
    /// In pixels, everywhere: the margin over its slope in the image, the best choice. Where pixels straddle sides of the hull's
    /// faces, slopes are less exact and lines up to a third wider.
    Gradient {
        /// 0 or more.
        px: f64,
    },
    /// In pixels: the margin times the baked distance from the hull to the outline. As exact as that distance, of which there is
    /// one per texel for all azimuths: within a few percent on a ball, within a factor of 2 on a hull that is far from the object.
    Gap {
        /// 0 or more.
        px: f64,
    },
    /// As the paper prints it: ink where the margin is at most `sigma` times the depth.
    AsPrinted {
        /// In radians per radius of the hull's bounding sphere. Orthographic views count as one radius deep everywhere.
        sigma: f64,
    },
}

/// How outlines are drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OutlineStyle {
    /// Width.
    pub width: OutlineWidth,
    /// Colour of the lines.
    pub ink: Color,
    /// What is drawn where the object is. With [`Interior::None`] hidden lines are removed only as far as the depth buffer holds the
    /// object already, for example as drawn by another [`TextureRenderer`](super::TextureRenderer) of the same volume.
    pub interior: Interior,
}

/// What is drawn.
#[derive(Debug, Clone, PartialEq)]
pub enum Drawing {
    /// The object's surface, cut out of the hull: the paper's method.
    Surface(Shading),
    /// The whole hull with the object's colours and normals: what the paper compares with (figure 6).
    Hull(Shading),
    /// The object's outlines (equation 5).
    Outlines(OutlineStyle),
}

/// What is drawn of a silhouette texture, and how.
#[derive(Debug, Clone, PartialEq)]
pub struct TextureStyle {
    /// What.
    pub drawing: Drawing,
    /// How edges are cut.
    pub edge: Edge,
    /// Where azimuths are looked up.
    pub azimuths: AzimuthRule,
    /// How the fine mesh is drawn where the near plane meets the hull.
    pub near: FillStyle,
}

impl TextureStyle {
    /// Hard edges, azimuths as stored. Near objects are white and lit; of outlines, their interior.
    pub fn new(drawing: Drawing) -> Self {
        let shade = match &drawing {
            Drawing::Surface(Shading::Flat(color)) | Drawing::Hull(Shading::Flat(color)) => Shade::Flat(*color),
            Drawing::Surface(_) | Drawing::Hull(_) => Shade::Lit(Color::WHITE),
            Drawing::Outlines(OutlineStyle { interior: Interior::Paper(color), .. }) => Shade::Flat(*color),
            Drawing::Outlines(_) => Shade::DepthOnly,
        };
        let near = FillStyle { shade, cull: Cull::None };
        Self { drawing, edge: Edge::default(), azimuths: AzimuthRule::default(), near }
    }
}
