//! What line renderers share of their options: [`LineWidth`] in the unit that the user thinks in, and [`InteriorChoice`].
//!
//! What a width comes to in a view is `WidthOverDepth` of `silhouette-gpu`.

crate::option_choice! {
    /// Unit of the width of lines, in the words of the command line.
    pub enum WidthUnitChoice {
        /// Pixels of the viewport.
        Pixels = "px",
        /// Units of the world at the depth of the line.
        World = "world",
        /// Millimetres of paper, of the resolution that `dpi` says.
        Millimetres = "mm",
        /// Percent of the height of the viewport.
        HeightPercent = "height-percent",
    }
}

impl WidthUnitChoice {
    /// The unit, on paper of `dpi` pixels per inch.
    pub fn with_dpi(self, dpi: f64) -> WidthUnit {
        match self {
            Self::Pixels => WidthUnit::Pixels,
            Self::World => WidthUnit::World,
            Self::Millimetres => WidthUnit::Millimetres { dpi },
            Self::HeightPercent => WidthUnit::HeightPercent,
        }
    }
}

crate::option_choice! {
    /// What is drawn where the mesh is, in the words of the command line.
    pub enum InteriorChoice {
        /// The mesh in white, hiding what lies behind it.
        Paper = "paper",
        /// Depth without colour: the mesh hides lines over the caller's shading.
        DepthOnly = "depth-only",
        /// Nothing: the caller's own depth hides lines.
        None = "none",
    }
}

/// Unit of a line's width.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum WidthUnit {
    /// Pixels of the viewport.
    Pixels,
    /// Units of world space, across the view at the depth of the line: farther lines are thinner.
    World,
    /// Millimetres of paper.
    Millimetres {
        /// Pixels per inch.
        dpi: f64,
    },
    /// Hundredths of the viewport's height.
    HeightPercent,
}

/// How wide lines are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LineWidth {
    /// The width, 0 or more.
    pub value: f64,
    /// Its unit.
    pub unit: WidthUnit,
    /// Distance of the mesh's middle from the eye, in radii of its bounding sphere, beyond which lines thin in
    /// proportion to it, against clutter; `None` keeps the width.
    pub thins_beyond_radii: Option<f64>,
}
