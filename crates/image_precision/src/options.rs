//! [`ImagePrecisionOptions`]: the options in the words of the command line.

use crate::depth_range::MovedPlane;
use silhouette_core::line_style::WidthUnitChoice;
use silhouette_core::{method_options, option_choice};

option_choice! {
    /// How back faces are drawn.
    pub enum VariantChoice {
        /// [`screen`](crate::screen).
        Screen = "screen",
        /// [`equal`](crate::equal).
        Equal = "equal",
        /// [`wireframe`](crate::wireframe).
        Wireframe = "wireframe",
        /// [`fixed_pull`](crate::fixed_pull).
        FixedPull = "fixed-pull",
        /// [`scale`](crate::scale).
        Scale = "scale",
        /// [`depth_range`](crate::depth_range).
        DepthRange = "depth-range",
        /// [`offset`](crate::offset).
        Offset = "offset",
        /// [`fatten`](crate::fatten).
        Fatten = "fatten",
        /// [`fatten`](crate::fatten) by the paper's first approximation, without the sine.
        FattenSimple = "fatten-simple",
        /// [`charcoal`](crate::charcoal).
        Charcoal = "charcoal",
        /// [`unoriented`](crate::unoriented).
        Unoriented = "unoriented",
    }
}

option_choice! {
    /// What the variant `wireframe` draws with.
    pub enum WireframeLines {
        /// Polygons, of any width.
        Quads = "quads",
        /// The adapter's own lines, 1 pixel wide.
        PolygonMode = "polygon-mode",
    }
}

option_choice! {
    /// How far the variants `fatten` and `charcoal` push an edge.
    pub enum LawChoice {
        /// So that the strip is as wide as asked at the middle of the edge.
        Exact = "exact",
        /// By the paper's formula.
        AsPrinted = "as-printed",
    }
}

option_choice! {
    /// What is fattened.
    pub enum FattenedPolygons {
        /// Triangles.
        Triangles = "triangles",
        /// The convex polygons whose fans the triangles are.
        Fans = "fans",
    }
}

option_choice! {
    /// How the variant `unoriented` draws what is not in the first layer.
    pub enum UnorientedLines {
        /// Scaled about the eye.
        Scale = "scale",
        /// With its edges expanded in the image plane.
        Screen = "screen",
    }
}

option_choice! {
    /// Which edges are drawn along with the silhouette.
    pub enum ExtraEdgesChoice {
        /// None.
        None = "none",
        /// Edges with one face.
        Boundary = "boundary",
        /// Those, and edges bent by at least the crease angle.
        BoundaryAndCreases = "boundary-and-creases",
    }
}

option_choice! {
    /// The pattern of lines that have a width.
    pub enum Texture {
        /// None.
        Solid = "solid",
        /// 7 px of ink and 5 px of paper along the axis of the image that an edge is nearer to.
        Dashes = "dashes",
        /// A chequerboard of 2 px in the image.
        Stipple = "stipple",
    }
}

option_choice! {
    /// How front faces are drawn.
    pub enum InteriorChoice {
        /// Grey for the variant `charcoal`, and paper for the others.
        Auto = "auto",
        /// White.
        Paper = "paper",
        /// Lit from the viewer.
        Lit = "lit",
        /// The paper's charcoal grey.
        Grey = "grey",
        /// Gooch's cool to warm.
        Gooch = "gooch",
        /// Front faces write depth and no colour, so that they hide lines over the caller's shading.
        DepthOnly = "depth-only",
        /// Nothing is drawn: the caller's own depth hides lines.
        None = "none",
    }
}

option_choice! {
    /// What happens with the eye inside a closed mesh, where only back faces are in sight.
    pub enum EyeInside {
        /// Back faces are left out.
        Skip = "skip",
        /// They are drawn as the paper does, all black.
        Draw = "draw",
    }
}

method_options! {
    /// Options of [`ImagePrecision`](crate::ImagePrecision), one field per word of the command line.
    /// [`Settings`](crate::Settings) is what they come to.
    pub struct ImagePrecisionOptions {
        /// How back faces are drawn: screen expands their edges in the image plane and is the one to use; the others are the
        /// paper's, in its order.
        pub variant: VariantChoice = choice("variant"),
        /// Width of lines, for screen, wireframe, fatten, fatten-simple, charcoal and extra edges; pulls have none of their
        /// own.
        pub width: f64 = number("width", 0.0..=1000.0 "in width-unit", default 2.0),
        /// Unit of width: pixels, units of the mesh at the depth of the line, millimetres of paper, percent of the image's
        /// height.
        pub width_unit: WidthUnitChoice = choice("width-unit"),
        /// Resolution of the paper that width-unit=mm means.
        pub dpi: f64 = number("dpi", 1.0..=10000.0 "px/inch", default 300.0),
        /// Scale of back faces about the eye: 1 draws nothing, smaller is thicker and shows through sooner; the paper uses
        /// 0.95 to 0.99.
        pub scale: f64 = number("scale", 0.01..=1.0, default 0.99),
        /// How far fixed-pull moves back faces along the viewing axis: 0 draws nothing, more is thicker and shows through
        /// sooner.
        pub pull_radii: f64 = number("pull", 0.0..=1.0 "bounding radii", default 0.03, sweep log 0.003..=0.1),
        /// Which plane depth-range moves for back faces; both pull when they move out, which for far is against the paper's
        /// text.
        pub depth_plane: MovedPlane = choice("depth-plane"),
        /// Depth of that plane for back faces over its depth for front faces: above 1 pulls, below 1 pushes and draws nothing.
        pub plane_factor: f64 = number("plane-factor", 0.1..=10.0, default 1.05),
        /// Polygon offset towards the viewer in depth slopes: the width on face-on silhouettes in pixels, half on smooth rims.
        pub offset_slope: f64 = number("offset-slope", 0.0..=64.0, default 2.0, sweep linear 1.0..=4.0),
        /// Polygon offset towards the viewer in depth-buffer steps.
        pub offset_constant: f64 = number("offset-constant", 0.0..=1e6 "depth steps", default 1.0),
        /// Most that polygon offset may amount to, in units of the depth buffer: bounds what edge-on faces do; 0 is no bound.
        pub offset_clamp: f64 = number("offset-clamp", 0.0..=1.0, default 0.0),
        /// What wireframe draws with: quads of any width, or the adapter's own lines, 1 pixel wide, which need
        /// POLYGON_MODE_LINE.
        pub wireframe_lines: WireframeLines = choice("wireframe-lines"),
        /// How far fatten and charcoal push an edge: so that its middle is as wide as asked, or by the paper's formula.
        pub fatten_law: LawChoice = choice("fatten-law"),
        /// Most that fattening may push an edge: less is shorter spikes and thinner lines; 0 is the paper's, without a bound.
        pub fatten_clamp: f64 = number("fatten-clamp", 0.0..=1000.0 "edge lengths", default 4.0),
        /// What is fattened: triangles, or the convex polygons whose fans the triangles are, as a file of polygons is read.
        pub polygons: FattenedPolygons = choice("polygons"),
        /// Front faces with V.N below this are fattened by charcoal: 0.1 is 5.7 degrees, half a percent of a sphere's radius.
        pub charcoal_band: f64 = number("charcoal-band", 0.0..=1.0, default 0.1),
        /// How unoriented draws what is not in the first layer: scale moves no pixel, so that faces below a pixel cannot ink.
        pub unoriented_lines: UnorientedLines = choice("unoriented-lines"),
        /// Edges drawn along with the silhouette; any but none builds the mesh's topology.
        pub extra_edges: ExtraEdgesChoice = choice("extra-edges"),
        /// Least angle between the faces of an edge that is drawn as a crease.
        pub crease_angle_deg: f64 = number("crease-angle", 1.0..=180.0 "degrees", default 60.0),
        /// Distance of the mesh from the eye beyond which lines thin in proportion, against clutter; 0 keeps their width.
        pub clutter_distance_radii: f64 = number("clutter-distance", 0.0..=1e6 "bounding radii", default 0.0),
        /// Share by which screen and wireframe thin lines that face the light at the upper left: 0 keeps their width.
        pub light_thinning: f64 = number("light-thinning", 0.0..=1.0, default 0.0),
        /// Share of the ink that the farthest lines of a perspective view lose: 0 keeps them as dark, 1 whitens them.
        pub depth_fade: f64 = number("depth-fade", 0.0..=1.0, default 0.0),
        /// Red of the ink, in sRGB as displayed.
        pub ink_red: f64 = number("ink-red", 0.0..=1.0, default 0.0),
        /// Green of the ink, in sRGB as displayed.
        pub ink_green: f64 = number("ink-green", 0.0..=1.0, default 0.0),
        /// Blue of the ink, in sRGB as displayed.
        pub ink_blue: f64 = number("ink-blue", 0.0..=1.0, default 0.0),
        /// Opacity of the ink: 0 draws nothing, 1 covers what lies below. Below 1, overlapping strips darken each other.
        pub ink_alpha: f64 = number("ink-alpha", 0.0..=1.0, default 1.0),
        /// Pattern of lines that have a width: dashes run with the nearer axis of the image, stipple lies in the image.
        pub texture: Texture = choice("texture"),
        /// Front faces: white, lit from the viewer, the paper's charcoal grey, Gooch's cool to warm, depth without colour, or
        /// nothing, where the caller's own depth hides lines; auto is grey for charcoal and paper otherwise.
        pub interior: InteriorChoice = choice("interior"),
        /// With the eye inside a closed mesh: skip the back faces, or draw them as the paper does, all black.
        pub eye_inside: EyeInside = choice("eye-inside"),
    }
}
