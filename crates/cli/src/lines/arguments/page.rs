//! The page that lines are drawn on.

use super::length;
use crate::failure::Failure;
use clap::{Args, ValueEnum};
use silhouette_visibility::plot::{Fit, Page, Sheet, Unit};
use std::str::FromStr;

/// The paper.
#[derive(Debug, Args)]
#[command(next_help_heading = "Page (SVG, PDF, DXF, HP-GL)")]
pub struct PageArguments {
    /// Unit of an SVG file, and of lengths given without one
    #[arg(long, value_enum, default_value_t = UnitArgument::Mm)]
    units: UnitArgument,
    /// a0 to a5, letter, legal, tabloid, or width and height such as 200x150mm or 11x17in [default: a4; with --units px: the view, as it is]
    #[arg(long, value_name = "SIZE", value_parser = Page::from_str)]
    page: Option<Page>,
    /// Lays the page on its longer side
    #[arg(long)]
    landscape: bool,
    /// Left free on all sides [default: 10mm]
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    margin: Option<String>,
    /// What fills the page: the lines, or the view, so that pictures of one camera lie upon each other [default: lines]
    #[arg(long, value_enum, conflicts_with = "scale")]
    fit: Option<FitArgument>,
    /// True scale: millimetres on paper that a unit of the mesh takes, or a ratio such as 1:100, with --mesh-unit; needs --ortho
    #[arg(long, value_name = "MM|A:B", allow_hyphen_values = true, value_parser = ScaleArgument::from_str)]
    scale: Option<ScaleArgument>,
    /// What a unit of the mesh is, for a --scale that is a ratio [default: mm]
    #[arg(long, value_enum, value_name = "UNIT", requires = "scale")]
    mesh_unit: Option<MeshUnitArgument>,
    /// Paths shorter than this are left out [default: 0.1mm]
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub min_length: Option<String>,
    /// How far points may lie off the line for which they are dropped [default: 0.01mm]
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub tolerance: Option<String>,
    /// Visible contours that a fold hides for no longer than this go on without lifting the pen, if the same contour continues
    /// underneath; 0 leaves all gaps [default: the pen's width, which its ends close anyway; with --cap butt: 0]
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub bridge: Option<String>,
    /// Draws curves in place of straight segments that turn little, within --tolerance; corners stay
    #[arg(long)]
    pub curves: bool,
    /// Leaves paths in the order of the lines instead of one in which the lifted pen travels little
    #[arg(long)]
    pub no_sort: bool,
    /// Draws lines that lie on others again, or in the ink of longer ones
    #[arg(long)]
    pub no_dedupe: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum UnitArgument {
    /// Millimetres
    Mm,
    /// Pixels, 96 to an inch
    Px,
}

/// A true scale.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ScaleArgument {
    /// Millimetres on paper per unit of the mesh.
    MmPerUnit(f64),
    /// Length on paper over length of the thing.
    Ratio(f64),
}

impl ScaleArgument {
    fn mm_per_unit(self, unit: Option<MeshUnitArgument>) -> Result<f64, Failure> {
        let mm = match unit {
            None | Some(MeshUnitArgument::Mm) => 1.0,
            Some(MeshUnitArgument::Cm) => 10.0,
            Some(MeshUnitArgument::M) => 1000.0,
            Some(MeshUnitArgument::In) => 25.4,
            Some(MeshUnitArgument::Ft) => 304.8,
        };
        match self {
            Self::MmPerUnit(_) if unit.is_some() => {
                Err(Failure::Input("--mesh-unit needs a --scale that is a ratio, such as 1:100".to_owned()))
            }
            Self::MmPerUnit(per_unit) => Ok(per_unit),
            Self::Ratio(ratio) => Ok(ratio * mm),
        }
    }
}

impl FromStr for ScaleArgument {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let number = |text: &str| text.trim().parse().ok().filter(|&value: &f64| value.is_finite() && value > 0.0);
        let scale = match text.split_once(':') {
            None => number(text).map(Self::MmPerUnit),
            Some((paper, thing)) => number(paper).zip(number(thing)).map(|(paper, thing)| Self::Ratio(paper / thing)),
        };
        scale.ok_or_else(|| "expected millimetres per unit above 0 such as 2.5, or a ratio such as 1:100".to_owned())
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum MeshUnitArgument {
    /// Millimetres
    Mm,
    /// Centimetres
    Cm,
    /// Metres
    M,
    /// Inches
    In,
    /// Feet
    Ft,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum FitArgument {
    /// The lines that are drawn
    Lines,
    /// The camera's viewport
    View,
}

impl PageArguments {
    pub const fn unit(&self) -> Unit {
        match self.units {
            UnitArgument::Mm => Unit::Mm,
            UnitArgument::Px => Unit::Px,
        }
    }

    pub fn sheet(&self, unit: Unit) -> Result<Option<Sheet>, Failure> {
        let defaults = Sheet::default();
        if unit == Unit::Px && self.page.is_none() {
            let given = [
                ("--landscape", self.landscape),
                ("--margin", self.margin.is_some()),
                ("--fit", self.fit.is_some()),
                ("--scale", self.scale.is_some()),
            ];
            return match given.iter().find(|(_, given)| *given) {
                Some((name, _)) => Err(Failure::Input(format!("{name} needs a page; add --page a4, say"))),
                None => Ok(None),
            };
        }
        let page = self.page.unwrap_or(defaults.page);
        let fit = match (self.scale, self.fit) {
            (Some(scale), _) => Fit::Scale { mm_per_unit: scale.mm_per_unit(self.mesh_unit)? },
            (None, Some(FitArgument::View)) => Fit::View,
            (None, Some(FitArgument::Lines) | None) => Fit::Lines,
        };
        Ok(Some(Sheet {
            page: if self.landscape { page.landscape() } else { page },
            margin: length("--margin", self.margin.as_deref(), unit, defaults.margin)?,
            fit,
        }))
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::parse;
    use super::*;
    use silhouette_visibility::plot::Length;

    #[test]
    fn pages() {
        let sheet = |words: &[&str]| parse(words).plot_options().unwrap().sheet;
        assert_eq!(sheet(&["--units", "px"]), None);
        let a3 = Sheet { page: "a3".parse::<Page>().unwrap().landscape(), margin: Length::px(5.0), fit: Fit::View };
        assert_eq!(
            sheet(&["--units", "px", "--page", "a3", "--landscape", "--margin", "5", "--fit", "view"]),
            Some(a3)
        );
        assert_eq!(sheet(&["--scale", "2"]).unwrap().fit, Fit::Scale { mm_per_unit: 2.0 });
        assert_eq!(sheet(&["--scale", "1:100"]).unwrap().fit, Fit::Scale { mm_per_unit: 0.01 });
        assert_eq!(sheet(&["--scale", "1:50", "--mesh-unit", "m"]).unwrap().fit, Fit::Scale { mm_per_unit: 20.0 });
        for bad in ["0", "-1", "1:0", "1:", "a", "1:2:3"] {
            assert!(ScaleArgument::from_str(bad).is_err(), "{bad}");
        }
        let tabloid = sheet(&["--page", "tabloid"]).unwrap().page;
        let inches = sheet(&["--page", "11x17in"]).unwrap().page;
        let pairs = inches.size(Unit::Mm).into_iter().zip(tabloid.size(Unit::Mm));
        assert!(pairs.into_iter().all(|(one, other)| (one - other).abs() < 1e-9), "{inches:?}");
        assert!(parse(&["--units", "px", "--scale", "2"]).plot_options().is_err());
    }
}
