//! Which parts are drawn.

use clap::{Args, ValueEnum};
use silhouette_visibility::plot::LayersBy;

/// Which parts are drawn. A name is that of a mesh file, of an object or group of an OBJ file, or of a node of a glTF file, which
/// stands for all below it.
#[derive(Debug, Args)]
#[command(next_help_heading = "Parts")]
pub struct PartArguments {
    /// Draws only parts of this name: mesh files, OBJ's objects and groups, glTF's nodes; may be given several times. The others
    /// hide nothing
    #[arg(long, value_name = "NAME")]
    pub only: Vec<String>,
    /// Leaves out parts of this name, which hide nothing then; may be given several times
    #[arg(long, value_name = "NAME")]
    pub without: Vec<String>,
    /// Lets parts of this name, or a further mesh file, hide what is behind them without being drawn; may be given several times.
    /// The view is fitted to what is drawn
    #[arg(long, value_name = "NAME|FILE")]
    pub mask: Vec<String>,
    /// What the layers of the file are: kinds of line, parts, or the kinds of each part. In SVG and PDF each kind and each part has the
    /// same number in every file
    #[arg(long, value_enum, value_name = "BY", default_value_t = LayersArgument::Kind)]
    pub layers: LayersArgument,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum LayersArgument {
    /// One layer per kind of line, visible and hidden apart
    Kind,
    /// One layer per part, all its kinds in it; PDF, DXF and HP-GL, whose layers have one pen each: one per kind of each part
    Object,
    /// One layer per kind of each part
    Both,
}

impl From<LayersArgument> for LayersBy {
    fn from(argument: LayersArgument) -> Self {
        match argument {
            LayersArgument::Kind => Self::Kind,
            LayersArgument::Object => Self::Object,
            LayersArgument::Both => Self::Both,
        }
    }
}
