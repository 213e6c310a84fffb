//! [`Settings`]: what the options come to, each variant with what it alone needs.

use crate::depth_range::MovedPlane;
use crate::fatten::FattenLaw;
use crate::options::{
    ExtraEdgesChoice, EyeInside, FattenedPolygons, ImagePrecisionOptions, InteriorChoice, LawChoice, Texture,
    UnorientedLines, VariantChoice, WireframeLines,
};
use silhouette_core::line_style::LineWidth;

/// How step 3 draws back faces.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Variant {
    /// [`screen`](crate::screen).
    Screen,
    /// [`equal`](crate::equal).
    Equal,
    /// [`wireframe`](crate::wireframe).
    Wireframe {
        /// Whether the adapter's own lines are used, which are 1 px wide.
        polygon_mode: bool,
    },
    /// [`fixed_pull`](crate::fixed_pull).
    FixedPull {
        /// t, in radii of the mesh's bounding sphere.
        radii: f64,
    },
    /// [`scale`](crate::scale).
    Scale {
        /// k, above 0 and at most 1.
        k: f64,
    },
    /// [`depth_range`](crate::depth_range).
    DepthRange {
        /// The plane that is moved.
        plane: MovedPlane,
        /// Its new depth over its old one.
        factor: f64,
    },
    /// [`offset`](crate::offset).
    Offset {
        /// Depth slopes, 0 or more, towards the viewer.
        slope: f64,
        /// Depth steps, 0 or more, towards the viewer.
        constant: f64,
        /// Most in units of the depth buffer; 0 is no bound.
        clamp: f64,
    },
    /// [`fatten`](crate::fatten).
    Fatten {
        /// How far edges are pushed.
        law: FattenLaw,
    },
    /// [`charcoal`](crate::charcoal).
    Charcoal {
        /// How far edges are pushed.
        law: FattenLaw,
        /// Front faces with V.N below this are fattened too.
        band: f64,
    },
    /// [`unoriented`](crate::unoriented).
    Unoriented {
        /// k where faces behind the first layer are scaled about the eye; `None` where their edges are expanded.
        k: Option<f64>,
    },
}

/// Which edges are drawn along with the silhouette.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum ExtraEdges {
    /// None: the mesh's topology is not built.
    #[default]
    None,
    /// Edges with one face.
    Boundary,
    /// Those, and edges bent by at least this many radians.
    BoundaryAndCreases(f64),
}

/// How front faces are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Interior {
    /// White.
    Paper,
    /// Lit from the viewer.
    Lit,
    /// Charcoal grey, `(1 + V.N) / 3`.
    Grey,
    /// From cool to warm (Gooch, Gooch, Shirley and Cohen 1998).
    Gooch,
    /// Depth without colour: they hide lines over whatever the target holds.
    DepthOnly,
    /// Not drawn: the depth that the target holds hides lines.
    None,
}

/// The options, interpreted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// How back faces are drawn.
    pub variant: Variant,
    /// How wide lines are, where the variant draws lines.
    pub width: LineWidth,
    /// Most that fattening pushes an edge, in lengths of that edge; 0 is no bound.
    pub fatten_clamp: f64,
    /// Whether fans of triangles are fattened as the polygons that they are.
    pub fans: bool,
    /// Edges drawn along.
    pub extra_edges: ExtraEdges,
    /// Share by which lines that face the light are thinned.
    pub light_thinning: f64,
    /// Share of the ink that the farthest lines lose.
    pub depth_fade: f64,
    /// Red, green and blue of the ink, 0 to 1, in sRGB as displayed.
    pub ink: [f64; 3],
    /// Opacity of the ink, 0 to 1.
    pub ink_alpha: f64,
    /// Pattern of lines.
    pub texture: Texture,
    /// Front faces.
    pub interior: Interior,
    /// Whether back faces are left out while the eye is inside a closed mesh.
    pub skips_inside: bool,
}

impl From<ImagePrecisionOptions> for Settings {
    fn from(options: ImagePrecisionOptions) -> Self {
        let clutter = options.clutter_distance_radii;
        Self {
            variant: options.into(),
            width: LineWidth {
                value: options.width,
                unit: options.width_unit.with_dpi(options.dpi),
                thins_beyond_radii: (clutter > 0.0).then_some(clutter),
            },
            fatten_clamp: options.fatten_clamp,
            fans: options.polygons == FattenedPolygons::Fans,
            extra_edges: match options.extra_edges {
                ExtraEdgesChoice::None => ExtraEdges::None,
                ExtraEdgesChoice::Boundary => ExtraEdges::Boundary,
                ExtraEdgesChoice::BoundaryAndCreases => {
                    ExtraEdges::BoundaryAndCreases(options.crease_angle_deg.to_radians())
                }
            },
            light_thinning: options.light_thinning,
            depth_fade: options.depth_fade,
            ink: [options.ink_red, options.ink_green, options.ink_blue],
            ink_alpha: options.ink_alpha,
            texture: options.texture,
            interior: match options.interior {
                InteriorChoice::Auto if options.variant == VariantChoice::Charcoal => Interior::Grey,
                InteriorChoice::Auto | InteriorChoice::Paper => Interior::Paper,
                InteriorChoice::Lit => Interior::Lit,
                InteriorChoice::Grey => Interior::Grey,
                InteriorChoice::Gooch => Interior::Gooch,
                InteriorChoice::DepthOnly => Interior::DepthOnly,
                InteriorChoice::None => Interior::None,
            },
            skips_inside: options.eye_inside == EyeInside::Skip,
        }
    }
}

impl From<ImagePrecisionOptions> for Variant {
    fn from(options: ImagePrecisionOptions) -> Self {
        let law = match options.fatten_law {
            LawChoice::Exact => FattenLaw::Exact,
            LawChoice::AsPrinted => FattenLaw::AsPrinted,
        };
        match options.variant {
            VariantChoice::Screen => Self::Screen,
            VariantChoice::Equal => Self::Equal,
            VariantChoice::Wireframe => {
                Self::Wireframe { polygon_mode: options.wireframe_lines == WireframeLines::PolygonMode }
            }
            VariantChoice::FixedPull => Self::FixedPull { radii: options.pull_radii },
            VariantChoice::Scale => Self::Scale { k: options.scale },
            VariantChoice::DepthRange => Self::DepthRange { plane: options.depth_plane, factor: options.plane_factor },
            VariantChoice::Offset => Self::Offset {
                slope: options.offset_slope,
                constant: options.offset_constant,
                clamp: options.offset_clamp,
            },
            VariantChoice::Fatten => Self::Fatten { law },
            VariantChoice::FattenSimple => Self::Fatten { law: FattenLaw::WithoutSine },
            VariantChoice::Charcoal => Self::Charcoal { law, band: options.charcoal_band },
            VariantChoice::Unoriented => {
                Self::Unoriented { k: (options.unoriented_lines == UnorientedLines::Scale).then_some(options.scale) }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::MethodOptions;
    use silhouette_core::line_style::WidthUnit;

    fn settings(words: &[&str]) -> Settings {
        ImagePrecisionOptions::parse(words.iter().copied()).unwrap().into()
    }

    #[test]
    fn each_variant_takes_its_own_options() {
        assert_eq!(settings(&[]).variant, Variant::Screen);
        assert_eq!(settings(&["variant=scale", "scale=0.95"]).variant, Variant::Scale { k: 0.95 });
        assert_eq!(settings(&["variant=unoriented"]).variant, Variant::Unoriented { k: Some(0.99) });
        let screen = settings(&["variant=unoriented", "unoriented-lines=screen"]);
        assert_eq!(screen.variant, Variant::Unoriented { k: None });
        let far = Variant::DepthRange { plane: MovedPlane::Far, factor: 2.0 };
        assert_eq!(settings(&["variant=depth-range", "depth-plane=far", "plane-factor=2"]).variant, far);
        let simple = settings(&["variant=fatten-simple", "fatten-law=as-printed"]);
        assert_eq!(simple.variant, Variant::Fatten { law: FattenLaw::WithoutSine });
    }

    #[test]
    fn the_interior_follows_the_variant_unless_it_is_named() {
        assert_eq!(settings(&[]).interior, Interior::Paper);
        assert_eq!(settings(&["variant=charcoal"]).interior, Interior::Grey);
        assert_eq!(settings(&["variant=charcoal", "interior=paper"]).interior, Interior::Paper);
        assert_eq!(settings(&["interior=depth-only"]).interior, Interior::DepthOnly);
        assert_eq!(settings(&["variant=charcoal", "interior=none"]).interior, Interior::None);
    }

    #[test]
    fn ink_and_width_are_read_in_their_units() {
        let ink = settings(&["ink-red=0.1", "ink-green=0.2", "ink-blue=0.3", "ink-alpha=0.4"]);
        assert_eq!((ink.ink, ink.ink_alpha, settings(&[]).ink_alpha), ([0.1, 0.2, 0.3], 0.4, 1.0));
        let width = settings(&["width=0.3", "width-unit=mm", "dpi=600", "clutter-distance=5"]).width;
        assert_eq!((width.value, width.unit), (0.3, WidthUnit::Millimetres { dpi: 600.0 }));
        assert_eq!((width.thins_beyond_radii, settings(&[]).width.thins_beyond_radii), (Some(5.0), None));
    }
}
