//! The options as the command line names them.

use silhouette_core::method::{OptionKind, OptionSpec};

const fn number(
    name: &'static str,
    unit: &'static str,
    [min, max, default]: [f64; 3],
    summary: &'static str,
) -> OptionSpec {
    OptionSpec { name, summary, unit, kind: OptionKind::Number { min, max, default } }
}

const fn choice(name: &'static str, choices: &'static [&'static str], summary: &'static str) -> OptionSpec {
    OptionSpec { name, summary, unit: "", kind: OptionKind::Choice(choices) }
}

pub(crate) const VARIANT: OptionSpec = choice(
    "variant",
    &[
        "screen",
        "equal",
        "wireframe",
        "fixed-pull",
        "scale",
        "depth-range",
        "offset",
        "fatten",
        "fatten-simple",
        "charcoal",
        "unoriented",
    ],
    "How back faces are drawn: screen expands their edges in the image plane and is the one to use; the others are the \
     paper's, in its order",
);
pub(crate) const WIDTH: OptionSpec = number(
    "width",
    "in width-unit",
    [0.0, 1000.0, 2.0],
    "Width of lines, for screen, wireframe, fatten, fatten-simple, charcoal and extra edges; pulls have none of their own",
);
pub(crate) const WIDTH_UNIT: OptionSpec = choice(
    "width-unit",
    &["px", "world", "mm", "height-percent"],
    "Unit of width: pixels, units of the mesh at the depth of the line, millimetres of paper, percent of the image's height",
);
pub(crate) const DPI: OptionSpec =
    number("dpi", "px/inch", [1.0, 10_000.0, 300.0], "Resolution of the paper that width-unit=mm means");
pub(crate) const SCALE: OptionSpec = number(
    "scale",
    "",
    [0.01, 1.0, 0.99],
    "Scale of back faces about the eye: 1 draws nothing, smaller is thicker and shows through sooner; the paper uses 0.95 \
     to 0.99",
);
pub(crate) const PULL: OptionSpec = number(
    "pull",
    "bounding radii",
    [0.0, 1.0, 0.03],
    "How far fixed-pull moves back faces along the viewing axis: 0 draws nothing, more is thicker and shows through sooner",
);
pub(crate) const DEPTH_PLANE: OptionSpec = choice(
    "depth-plane",
    &["near", "far"],
    "Which plane depth-range moves for back faces; both pull when they move out, which for far is against the paper's text",
);
pub(crate) const PLANE_FACTOR: OptionSpec = number(
    "plane-factor",
    "",
    [0.1, 10.0, 1.05],
    "Depth of that plane for back faces over its depth for front faces: above 1 pulls, below 1 pushes and draws nothing",
);
pub(crate) const OFFSET_SLOPE: OptionSpec = number(
    "offset-slope",
    "",
    [0.0, 64.0, 2.0],
    "Polygon offset towards the viewer in depth slopes: the width on face-on silhouettes in pixels, half on smooth rims",
);
pub(crate) const OFFSET_CONSTANT: OptionSpec = number(
    "offset-constant",
    "depth steps",
    [0.0, 1e6, 1.0],
    "Polygon offset towards the viewer in depth-buffer steps",
);
pub(crate) const OFFSET_CLAMP: OptionSpec = number(
    "offset-clamp",
    "",
    [0.0, 1.0, 0.0],
    "Most that polygon offset may amount to, in units of the depth buffer: bounds what edge-on faces do; 0 is no bound",
);
pub(crate) const LINES: OptionSpec = choice(
    "wireframe-lines",
    &["quads", "polygon-mode"],
    "What wireframe draws with: quads of any width, or the adapter's own lines, 1 pixel wide, which need POLYGON_MODE_LINE",
);
pub(crate) const FATTEN_LAW: OptionSpec = choice(
    "fatten-law",
    &["exact", "as-printed"],
    "How far fatten and charcoal push an edge: so that its middle is as wide as asked, or by the paper's formula",
);
pub(crate) const FATTEN_CLAMP: OptionSpec = number(
    "fatten-clamp",
    "edge lengths",
    [0.0, 1000.0, 4.0],
    "Most that fattening may push an edge: less is shorter spikes and thinner lines; 0 is the paper's, without a bound",
);
pub(crate) const POLYGONS: OptionSpec = choice(
    "polygons",
    &["triangles", "fans"],
    "What is fattened: triangles, or the convex polygons whose fans the triangles are, as a file of polygons is read",
);
pub(crate) const BAND: OptionSpec = number(
    "charcoal-band",
    "",
    [0.0, 1.0, 0.1],
    "Front faces with V.N below this are fattened by charcoal: 0.1 is 5.7 degrees, half a percent of a sphere's radius",
);
pub(crate) const FIRST_LAYER_LINES: OptionSpec = choice(
    "unoriented-lines",
    &["scale", "screen"],
    "How unoriented draws what is not in the first layer: scale moves no pixel, so that faces below a pixel cannot ink",
);
pub(crate) const EXTRA_EDGES: OptionSpec = choice(
    "extra-edges",
    &["none", "boundary", "boundary-and-creases"],
    "Edges drawn along with the silhouette; any but none builds the mesh's topology",
);
pub(crate) const CREASE_ANGLE: OptionSpec = number(
    "crease-angle",
    "degrees",
    [1.0, 180.0, 60.0],
    "Least angle between the faces of an edge that is drawn as a crease",
);
pub(crate) const CLUTTER: OptionSpec = number(
    "clutter-distance",
    "bounding radii",
    [0.0, 1e6, 0.0],
    "Distance of the mesh from the eye beyond which lines thin in proportion, against clutter; 0 keeps their width",
);
pub(crate) const LIGHT: OptionSpec = number(
    "light-thinning",
    "",
    [0.0, 1.0, 0.0],
    "Share by which screen and wireframe thin lines that face the light at the upper left: 0 keeps their width",
);
pub(crate) const FADE: OptionSpec = number(
    "depth-fade",
    "",
    [0.0, 1.0, 0.0],
    "Share of the ink that the farthest lines of a perspective view lose: 0 keeps them as dark, 1 whitens them",
);
pub(crate) const RED: OptionSpec = number("ink-red", "", [0.0, 1.0, 0.0], "Red of the ink");
pub(crate) const GREEN: OptionSpec = number("ink-green", "", [0.0, 1.0, 0.0], "Green of the ink");
pub(crate) const BLUE: OptionSpec = number("ink-blue", "", [0.0, 1.0, 0.0], "Blue of the ink");
pub(crate) const TEXTURE: OptionSpec = choice(
    "texture",
    &["solid", "dashes", "stipple"],
    "Pattern of lines that have a width: dashes run with the nearer axis of the image, stipple lies in the image",
);
pub(crate) const INTERIOR: OptionSpec = choice(
    "interior",
    &["auto", "paper", "lit", "grey", "gooch"],
    "Front faces: white, lit from the viewer, the paper's charcoal grey, or Gooch's cool to warm; auto is grey for \
     charcoal and paper otherwise",
);
pub(crate) const EYE_INSIDE: OptionSpec = choice(
    "eye-inside",
    &["skip", "draw"],
    "With the eye inside a closed mesh: skip the back faces, or draw them as the paper does, all black",
);

/// All of them, in the order in which they are listed.
pub(crate) const ALL: &[OptionSpec] = &[
    VARIANT,
    WIDTH,
    WIDTH_UNIT,
    DPI,
    SCALE,
    PULL,
    DEPTH_PLANE,
    PLANE_FACTOR,
    OFFSET_SLOPE,
    OFFSET_CONSTANT,
    OFFSET_CLAMP,
    LINES,
    FATTEN_LAW,
    FATTEN_CLAMP,
    POLYGONS,
    BAND,
    FIRST_LAYER_LINES,
    EXTRA_EDGES,
    CREASE_ANGLE,
    CLUTTER,
    LIGHT,
    FADE,
    RED,
    GREEN,
    BLUE,
    TEXTURE,
    INTERIOR,
    EYE_INSIDE,
];
