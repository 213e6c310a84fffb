//! The arguments of `lines`, and the options they stand for.

mod heal;
mod page;
mod parts;
mod pens;
mod views;
mod which;

pub use heal::HealDistance;
pub use parts::PartArguments;
pub use views::ViewsArguments;
pub use which::SectionArgument;

use crate::camera::CameraArguments;
use crate::failure::Failure;
use crate::mesh_argument::MeshArgument;
use crate::winding::OrientArgument;
use clap::Args;
use page::PageArguments;
use pens::PenArguments;
use silhouette_visibility::LineOptions;
use silhouette_visibility::plot::{Hidden, Length, PlotOptions, Unit};
use std::path::PathBuf;
use which::{HiddenArgument, OutlineArgument, WhichLines};

/// Arguments of `lines`.
#[derive(Debug, Args)]
pub struct LinesArguments {
    /// Mesh files or builtin:NAME; several are drawn together and hide each other
    #[arg(required = true, value_name = "MESH")]
    pub meshes: Vec<MeshArgument>,
    /// Output file: .svg, .pdf, .dxf, .hpgl or .plt, .json, .gltf or .glb [default: SVG on standard output]
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Threads to work with [default: as many as the machine runs]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=256))]
    pub threads: Option<u16>,
    /// Looks up what is visible in a picture of face ids, twice as fine as the view, instead of deciding it exactly: misses up
    /// to 1 % of the visible length, and on fine meshes draws nearly as much again that is hidden, most of it within a pixel
    /// of a visible line; needs an adapter
    #[arg(long, conflicts_with_all = ["hidden", "outline", "fill", "intersections"])]
    pub quick: bool,
    /// Smooth curves in place of silhouette, boundary and crease edges, as of a finer mesh: each mesh is re-meshed for this view
    /// by the method smoothing, and hides lines as that surface. SVG: cubic Bezier curves; JSON: no edges but curves, with
    /// handles; glTF: chords within 0.05 pixels. What is --creases is sharp, and so is what bends by 75 degrees
    #[arg(long, conflicts_with_all = ["quick", "materials", "all_edges"])]
    pub smooth: bool,
    /// Joins vertices no farther apart than this, in units of the mesh, so that seams are no boundaries [--weld alone: 0]
    #[arg(long, value_name = "DISTANCE", num_args = 0..=1, require_equals = true, default_missing_value = "0")]
    pub weld: Option<f32>,
    /// Divides edges at vertices that lie on them, no farther than this, in units of the mesh, so that T-junctions are no
    /// boundaries; joins vertices as --weld does [--heal alone: a millionth of the mesh's largest extent]
    #[arg(long, value_name = "DISTANCE", num_args = 0..=1, require_equals = true, default_missing_value = "auto")]
    pub heal: Option<HealDistance>,
    #[command(flatten)]
    pub orient: OrientArgument,
    /// Report on standard error what was found, how long each stage took and how far the lifted pen travels
    #[arg(long)]
    pub stats: bool,
    #[command(flatten)]
    which: WhichLines,
    #[command(flatten)]
    pub parts: PartArguments,
    #[command(flatten)]
    page: PageArguments,
    #[command(flatten)]
    pens: PenArguments,
    #[command(flatten)]
    pub camera: CameraArguments,
    #[command(flatten)]
    pub views: ViewsArguments,
}

impl LinesArguments {
    /// Whether borders of materials are wanted, so that it has to be known which faces are of one.
    pub fn wants_materials(&self) -> bool {
        self.which.materials && self.line_options().material
    }

    /// By which planes the meshes are cut.
    pub fn sections(&self) -> &[SectionArgument] {
        &self.which.section
    }

    /// Whether contours go on across gaps, for which hidden lines have to be found. Edges that are all drawn have no gaps.
    pub fn bridges_gaps(&self) -> bool {
        let is_off =
            self.page.bridge.as_deref().is_some_and(|text| text.trim().trim_end_matches(char::is_alphabetic) == "0");
        !(is_off || self.quick || self.smooth || self.which.all_edges)
    }

    /// Which lines are wanted.
    pub fn line_options(&self) -> LineOptions {
        let which = &self.which;
        let others = which.outline != Some(OutlineArgument::Only);
        let all_depths = matches!(which.hidden, Some(HiddenArgument::Dashed | HiddenArgument::Solid));
        LineOptions {
            section: others,
            silhouette: others,
            boundary: others && !which.no_boundaries,
            back_boundary: others,
            ridge_deg: which.creases.or(which.ridge).filter(|_| others),
            valley_deg: which.creases.or(which.valley).filter(|_| others),
            material: others,
            intersection: which.intersections && others,
            mesh: which.all_edges && others,
            curves: others,
            max_invisibility: if all_depths { u32::MAX } else { 0 },
            outline: which.outline.is_some() || self.pens.wants_fill(),
        }
    }

    /// How they are drawn.
    pub fn plot_options(&self) -> Result<PlotOptions, Failure> {
        let page = &self.page;
        let unit = page.unit();
        let (pens, hidden_dash) = self.pens.pens(unit, self.which.hidden)?;
        let defaults = PlotOptions::default();
        Ok(PlotOptions {
            unit,
            sheet: page.sheet(unit)?,
            hidden: match self.which.hidden {
                None | Some(HiddenArgument::Drop) => Hidden::Drop,
                Some(HiddenArgument::Dashed) => Hidden::Dashed(hidden_dash),
                Some(HiddenArgument::Solid) => Hidden::Solid,
            },
            pens,
            layers: self.parts.layers.into(),
            object_names: Vec::new(),
            cap: self.pens.cap(),
            join: self.pens.join(),
            merge_tolerance: length("--tolerance", page.tolerance.as_deref(), unit, defaults.merge_tolerance)?,
            min_length: length("--min-length", page.min_length.as_deref(), unit, defaults.min_length)?,
            bridge: page
                .bridge
                .as_deref()
                .map(|text| length("--bridge", Some(text), unit, Length::mm(0.0)))
                .transpose()?,
            curves: page.curves,
            dedupe: !page.no_dedupe,
            outline: self.which.outline.is_some() || !self.pens.wants_fill(),
            fill: self.pens.fill()?,
            order: !page.no_sort,
        })
    }
}

/// A length in the file's unit where it has none of its own.
fn length(option: &str, text: Option<&str>, unit: Unit, default: Length) -> Result<Length, Failure> {
    let Some(text) = text else { return Ok(default) };
    Length::parse(text, unit).map_err(|error| Failure::Input(format!("{option} {text}: {error}")))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::args::{Arguments, Command};
    use clap::Parser;
    use silhouette_visibility::plot::Dash;

    pub(super) fn parse(options: &[&str]) -> LinesArguments {
        let words = ["silhouettes", "lines"].iter().chain(options).chain(&["builtin:cube"]);
        match Arguments::try_parse_from(words).unwrap().command {
            Command::Lines(arguments) => *arguments,
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn defaults_are_the_crates() {
        let arguments = parse(&[]);
        assert_eq!(arguments.plot_options().unwrap(), PlotOptions::default());
        assert_eq!(arguments.line_options(), LineOptions::default());
    }

    #[test]
    fn options_may_stand_before_the_mesh() {
        let arguments = parse(&["--hidden", "--outline"]);
        assert_eq!(arguments.meshes, [MeshArgument::from("builtin:cube")]);
        assert_eq!(arguments.plot_options().unwrap().hidden, Hidden::Dashed(Dash::HIDDEN));
        assert!(arguments.line_options().outline && arguments.line_options().silhouette);
        let only = parse(&["--outline=only", "--creases", "30", "--all-edges"]).line_options();
        assert!(only.outline && !only.silhouette && !only.mesh && only.ridge_deg.is_none());
    }
}
