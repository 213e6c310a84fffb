//! [`Settings`]: the options, read into types.

use crate::depth_range::MovedPlane;
use crate::fatten::FattenLaw;
use crate::line_width::{LineWidth, WidthUnit};
use crate::options as named;
use silhouette_core::method::{OptionError, OptionValues};

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

/// How front faces look.
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
}

/// The pattern of lines that have a width.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Texture {
    /// None.
    Solid,
    /// 7 px of ink and 5 px of paper along the axis of the image that an edge is nearer to.
    Dashes,
    /// A chequerboard of 2 px in the image.
    Stipple,
}

/// Everything that the options say.
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
    /// Red, green and blue of the ink, 0 to 1, as the target stores them.
    pub ink: [f64; 3],
    /// Pattern of lines.
    pub texture: Texture,
    /// Front faces.
    pub interior: Interior,
    /// Whether back faces are left out while the eye is inside a closed mesh.
    pub skips_inside: bool,
}

impl Settings {
    /// Reads checked values.
    ///
    /// # Errors
    /// [`OptionError::Foreign`] where the values were made for another method.
    pub fn read(values: &OptionValues) -> Result<Self, OptionError> {
        let number = |spec: &silhouette_core::method::OptionSpec| values.number(spec.name);
        let choice = |spec: &silhouette_core::method::OptionSpec| values.choice(spec.name);
        let variant = Self::variant(values)?;
        let unit = match choice(&named::WIDTH_UNIT)? {
            "world" => WidthUnit::World,
            "mm" => WidthUnit::Millimetres { dpi: number(&named::DPI)? },
            "height-percent" => WidthUnit::HeightPercent,
            _ => WidthUnit::Pixels,
        };
        let clutter = number(&named::CLUTTER)?;
        Ok(Self {
            variant,
            width: LineWidth {
                value: number(&named::WIDTH)?,
                unit,
                thins_beyond_radii: (clutter > 0.0).then_some(clutter),
            },
            fatten_clamp: number(&named::FATTEN_CLAMP)?,
            fans: choice(&named::POLYGONS)? == "fans",
            extra_edges: match choice(&named::EXTRA_EDGES)? {
                "boundary" => ExtraEdges::Boundary,
                "boundary-and-creases" => ExtraEdges::BoundaryAndCreases(number(&named::CREASE_ANGLE)?.to_radians()),
                _ => ExtraEdges::None,
            },
            light_thinning: number(&named::LIGHT)?,
            depth_fade: number(&named::FADE)?,
            ink: [number(&named::RED)?, number(&named::GREEN)?, number(&named::BLUE)?],
            texture: match choice(&named::TEXTURE)? {
                "dashes" => Texture::Dashes,
                "stipple" => Texture::Stipple,
                _ => Texture::Solid,
            },
            interior: match choice(&named::INTERIOR)? {
                "lit" => Interior::Lit,
                "grey" => Interior::Grey,
                "gooch" => Interior::Gooch,
                "auto" if matches!(variant, Variant::Charcoal { .. }) => Interior::Grey,
                _ => Interior::Paper,
            },
            skips_inside: choice(&named::EYE_INSIDE)? == "skip",
        })
    }

    fn variant(values: &OptionValues) -> Result<Variant, OptionError> {
        let number = |spec: &silhouette_core::method::OptionSpec| values.number(spec.name);
        let choice = |spec: &silhouette_core::method::OptionSpec| values.choice(spec.name);
        let law = match choice(&named::FATTEN_LAW)? {
            "as-printed" => FattenLaw::AsPrinted,
            _ => FattenLaw::Exact,
        };
        Ok(match choice(&named::VARIANT)? {
            "equal" => Variant::Equal,
            "wireframe" => Variant::Wireframe { polygon_mode: choice(&named::LINES)? == "polygon-mode" },
            "fixed-pull" => Variant::FixedPull { radii: number(&named::PULL)? },
            "scale" => Variant::Scale { k: number(&named::SCALE)? },
            "depth-range" => Variant::DepthRange {
                plane: if choice(&named::DEPTH_PLANE)? == "far" { MovedPlane::Far } else { MovedPlane::Near },
                factor: number(&named::PLANE_FACTOR)?,
            },
            "offset" => Variant::Offset {
                slope: number(&named::OFFSET_SLOPE)?,
                constant: number(&named::OFFSET_CONSTANT)?,
                clamp: number(&named::OFFSET_CLAMP)?,
            },
            "fatten" => Variant::Fatten { law },
            "fatten-simple" => Variant::Fatten { law: FattenLaw::WithoutSine },
            "charcoal" => Variant::Charcoal { law, band: number(&named::BAND)? },
            "unoriented" => {
                let scales = choice(&named::FIRST_LAYER_LINES)? == "scale";
                Variant::Unoriented { k: if scales { Some(number(&named::SCALE)?) } else { None } }
            }
            _ => Variant::Screen,
        })
    }
}
