//! Which lines are drawn.

use crate::args::bend;
use clap::{Args, ValueEnum};
use silhouette_visibility::SectionPlane;
use std::str::FromStr;

/// Which lines are drawn besides silhouettes and boundaries.
#[derive(Debug, Args)]
#[command(next_help_heading = "Lines")]
pub struct WhichLines {
    /// Hidden lines, too, in layers of their own: dashed, solid or drop [default: drop; --hidden alone: dashed]
    #[arg(long, value_enum, value_name = "HOW", num_args = 0..=1, require_equals = true, default_missing_value = "dashed")]
    pub hidden: Option<HiddenArgument>,
    /// Ridges and valleys whose faces bend by at least this angle
    #[arg(long, value_name = "DEG", value_parser = bend, conflicts_with_all = ["ridge", "valley"])]
    pub creases: Option<f64>,
    /// Ridges whose faces bend by at least this angle
    #[arg(long, value_name = "DEG", value_parser = bend)]
    pub ridge: Option<f64>,
    /// Valleys whose faces bend by at least this angle
    #[arg(long, value_name = "DEG", value_parser = bend)]
    pub valley: Option<f64>,
    /// Edges between faces of different materials or groups (OBJ: usemtl and g; glTF: materials, with --weld)
    #[arg(long)]
    pub materials: bool,
    /// Every edge of the mesh
    #[arg(long)]
    pub all_edges: bool,
    /// No boundary edges
    #[arg(long)]
    pub no_boundaries: bool,
    /// Lines in which faces pass through each other
    #[arg(long)]
    pub intersections: bool,
    /// Cuts the meshes open by the plane through X,Y,Z, and takes away what lies on the side to which the normal NX,NY,NZ points;
    /// the curves in which it cuts are lines of the kind section; may be given several times
    #[arg(long, value_name = "X,Y,Z,NX,NY,NZ", allow_hyphen_values = true, value_parser = SectionPlane::from_str, conflicts_with = "smooth")]
    pub section: Vec<SectionPlane>,
    /// The outline, as closed polygons around all that the meshes cover: with the other lines, or only [--outline alone: with]
    #[arg(long, value_enum, value_name = "HOW", num_args = 0..=1, require_equals = true, default_missing_value = "with")]
    pub outline: Option<OutlineArgument>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum HiddenArgument {
    /// Left out
    Drop,
    /// In strokes and gaps
    Dashed,
    /// As visible ones are
    Solid,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum OutlineArgument {
    /// Beside all other lines
    With,
    /// Instead of all other lines
    Only,
}
