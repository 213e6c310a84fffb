//! [`EdgeMeshOptions`]: the options in the words of the command line, and the [pens](EdgeMeshOptions::pens) that they come to.

use silhouette_core::line_style::{InteriorChoice, LineWidth, WidthUnitChoice};
use silhouette_core::{method_options, option_choice};

option_choice! {
    /// Which stage leaves out the edges that are not drawn.
    pub enum PathChoice {
        /// A compute pass lists the drawn edges, and an indirect draw follows the list: raster cost grows with S.
        Compacted = "compacted",
        /// One draw of all edges, whose vertex stage sends the others outside the clip volume, as in the article.
        VertexStage = "vertex-stage",
    }
}

option_choice! {
    /// Where the facing of faces is decided.
    pub enum FacingChoice {
        /// On the CPU by exact arithmetic, while the positions are those of the mesh; on the device once they are replaced.
        Exact = "exact",
        /// On the device, in 32 bits, from this frame's positions.
        Device = "device",
    }
}

option_choice! {
    /// Which boundary edges are drawn.
    pub enum BoundariesChoice {
        /// Those of front faces, as extraction has it: a sheet seen from behind has no outline.
        Front = "front",
        /// All of them.
        All = "all",
    }
}

option_choice! {
    /// Which faces of the interior are drawn.
    pub enum CullChoice {
        /// Front faces only where that cannot be seen: each part of the mesh is closed with its faces outwards and at rest, the eye is
        /// outside of the mesh's bounds, and the near plane before them; all of them otherwise.
        Auto = "auto",
        /// All of them: what hides lines on any mesh.
        None = "none",
        /// Front faces only.
        Back = "back",
    }
}

option_choice! {
    /// Whose arithmetic decides and displaces.
    pub enum ArithmeticChoice {
        /// Facing once per face, lines expanded in the image plane.
        Corrected = "corrected",
        /// The article's vertex stage.
        AsPrinted = "as-printed",
    }
}

option_choice! {
    /// What happens to edges that the mesh's file marks as sharp.
    pub enum CreasesChoice {
        /// Nothing: they are treated like all other edges.
        None = "none",
        /// They are drawn, whatever their angle.
        Given = "given",
    }
}

method_options! {
    /// Options of [`EdgeMesh`](crate::EdgeMesh), one field per word of the command line.
    pub struct EdgeMeshOptions {
        /// Width of silhouettes and boundaries.
        pub width: f64 = number("width", 0.0..=1000.0 "in width-unit", default 2.0),
        /// Width of ridges, and of creases that are convex.
        pub ridge_width: f64 = number("ridge-width", 0.0..=1000.0 "in width-unit", default 2.0),
        /// Width of valleys, and of creases that are concave.
        pub valley_width: f64 = number("valley-width", 0.0..=1000.0 "in width-unit", default 2.0),
        /// Unit of all widths: pixels, units of the world at the depth of the line, millimetres of paper, percent of the image's
        /// height.
        pub width_unit: WidthUnitChoice = choice("width-unit"),
        /// Resolution of the paper that width-unit=mm means.
        pub dpi: f64 = number("dpi", 1.0..=10000.0 "px/inch", default 300.0),
        /// Distance of the mesh from the eye beyond which lines thin in proportion, against clutter; 0 keeps their width.
        pub clutter_distance_radii: f64 = number("clutter-distance", 0.0..=1e6 "bounding radii", default 0.0),
        /// Least angle between the normals of the faces at a convex edge that is drawn as a ridge; 180 draws none.
        pub ridge_angle_deg: f64 = number("ridge-angle", 1.0..=180.0 "degrees", default 180.0),
        /// Least angle between the normals of the faces at a concave edge that is drawn as a valley; 180 draws none.
        pub valley_angle_deg: f64 = number("valley-angle", 1.0..=180.0 "degrees", default 180.0),
        /// Whether edges that the mesh's file marks as sharp are drawn, whatever their angle.
        pub creases: CreasesChoice = choice("creases"),
        /// Red of silhouettes and boundaries, in sRGB as displayed.
        pub ink_red: f64 = number("ink-red", 0.0..=1.0, default 0.0),
        /// Green of silhouettes and boundaries, in sRGB as displayed.
        pub ink_green: f64 = number("ink-green", 0.0..=1.0, default 0.0),
        /// Blue of silhouettes and boundaries, in sRGB as displayed.
        pub ink_blue: f64 = number("ink-blue", 0.0..=1.0, default 0.0),
        /// Red of ridges, in sRGB as displayed.
        pub ridge_red: f64 = number("ridge-red", 0.0..=1.0, default 0.0),
        /// Green of ridges, in sRGB as displayed.
        pub ridge_green: f64 = number("ridge-green", 0.0..=1.0, default 0.0),
        /// Blue of ridges, in sRGB as displayed.
        pub ridge_blue: f64 = number("ridge-blue", 0.0..=1.0, default 0.0),
        /// Red of valleys, in sRGB as displayed.
        pub valley_red: f64 = number("valley-red", 0.0..=1.0, default 0.0),
        /// Green of valleys, in sRGB as displayed.
        pub valley_green: f64 = number("valley-green", 0.0..=1.0, default 0.0),
        /// Blue of valleys, in sRGB as displayed.
        pub valley_blue: f64 = number("valley-blue", 0.0..=1.0, default 0.0),
        /// Opacity of all lines: 0 draws nothing, 1 covers what lies below. Below 1, overlapping lines darken each other.
        pub ink_alpha: f64 = number("ink-alpha", 0.0..=1.0, default 1.0),
        /// What is drawn where the mesh is: white, depth alone, or nothing, where the caller's own depth hides lines.
        pub interior: InteriorChoice = choice("interior"),
        /// Boundary edges that are drawn: those of front faces, or all, for sheets that are seen from both sides.
        pub boundaries: BoundariesChoice = choice("boundaries"),
        /// Faces that the interior leaves out: back faces where that cannot be seen, none, or back faces in any case. Without them it
        /// takes about half.
        pub cull: CullChoice = choice("cull"),
        /// Which stage leaves out the edges that are not drawn: a compute pass that lists the others, or the vertex stage.
        pub path: PathChoice = choice("path", sweep ["compacted", "vertex-stage"]),
        /// Where facing is decided: exactly on the CPU while the mesh is at rest, or on the device.
        pub facing: FacingChoice = choice("facing", sweep ["exact", "device"]),
        /// Corrected, or the article's: widths, path and facing are then the article's too.
        pub arithmetic: ArithmeticChoice = choice("arithmetic"),
    }
}

/// How lines of one kind are drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinePen {
    /// How wide.
    pub width: LineWidth,
    /// Red, green and blue, 0 to 1, in sRGB as displayed.
    pub ink: [f64; 3],
}

impl EdgeMeshOptions {
    /// The pens of silhouettes, ridges and valleys.
    pub fn pens(&self) -> [LinePen; 3] {
        let pen = |value, ink| {
            let thins_beyond_radii = (self.clutter_distance_radii > 0.0).then_some(self.clutter_distance_radii);
            LinePen { width: LineWidth { value, unit: self.width_unit.with_dpi(self.dpi), thins_beyond_radii }, ink }
        };
        [
            pen(self.width, [self.ink_red, self.ink_green, self.ink_blue]),
            pen(self.ridge_width, [self.ridge_red, self.ridge_green, self.ridge_blue]),
            pen(self.valley_width, [self.valley_red, self.valley_green, self.valley_blue]),
        ]
    }

    /// Whether ridges or valleys are drawn by their angle.
    pub fn draws_by_angle(&self) -> bool {
        self.ridge_angle_deg < 180.0 || self.valley_angle_deg < 180.0
    }
}
