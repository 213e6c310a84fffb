//! The arguments of `lines`, and the options they stand for.

use crate::args::bend;
use crate::camera::CameraArguments;
use crate::failure::Failure;
use crate::winding::OrientArgument;
use clap::{Args, ValueEnum};
use silhouette_visibility::plot::{
    Cap, Colour, Dash, Fit, Hidden, Join, Length, Page, Pen, Pens, PlotOptions, Sheet, Unit,
};
use silhouette_visibility::{LineKind, LineOptions};
use std::path::PathBuf;
use std::str::FromStr;

/// Arguments of `lines`.
#[derive(Debug, Args)]
pub struct LinesArguments {
    /// Mesh files or builtin:NAME; several are drawn together and hide each other
    #[arg(required = true, value_name = "MESH")]
    pub meshes: Vec<String>,
    /// Output file: .svg, .json, .gltf or .glb [default: SVG on standard output]
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Threads to work with [default: as many as the machine runs]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=256))]
    pub threads: Option<u16>,
    /// Looks up what is visible in a picture of face ids, twice as fine as the view, instead of deciding it exactly: misses up
    /// to 1 % of the visible length, and on fine meshes draws nearly as much again that is hidden, most of it within a pixel
    /// of a visible line; needs an adapter
    #[arg(long, conflicts_with_all = ["hidden", "outline", "intersections"])]
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
    page: PageArguments,
    #[command(flatten)]
    pens: PenArguments,
    #[command(flatten)]
    pub camera: CameraArguments,
}

/// Which lines are drawn besides silhouettes and boundaries.
#[derive(Debug, Args)]
#[command(next_help_heading = "Lines")]
struct WhichLines {
    /// Hidden lines, too, in layers of their own: dashed, solid or drop [default: drop; --hidden alone: dashed]
    #[arg(long, value_enum, value_name = "HOW", num_args = 0..=1, require_equals = true, default_missing_value = "dashed")]
    hidden: Option<HiddenArgument>,
    /// Ridges and valleys whose faces bend by at least this angle
    #[arg(long, value_name = "DEG", value_parser = bend, conflicts_with_all = ["ridge", "valley"])]
    creases: Option<f64>,
    /// Ridges whose faces bend by at least this angle
    #[arg(long, value_name = "DEG", value_parser = bend)]
    ridge: Option<f64>,
    /// Valleys whose faces bend by at least this angle
    #[arg(long, value_name = "DEG", value_parser = bend)]
    valley: Option<f64>,
    /// Edges between faces of different materials or groups (OBJ: usemtl and g; glTF: materials, with --weld)
    #[arg(long)]
    materials: bool,
    /// Every edge of the mesh
    #[arg(long)]
    all_edges: bool,
    /// No boundary edges
    #[arg(long)]
    no_boundaries: bool,
    /// Lines in which faces pass through each other
    #[arg(long)]
    intersections: bool,
    /// The outline, as closed polygons around all that the meshes cover: with the other lines, or only [--outline alone: with]
    #[arg(long, value_enum, value_name = "HOW", num_args = 0..=1, require_equals = true, default_missing_value = "with")]
    outline: Option<OutlineArgument>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum HiddenArgument {
    /// Left out
    Drop,
    /// In strokes and gaps
    Dashed,
    /// As visible ones are
    Solid,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum OutlineArgument {
    /// Beside all other lines
    With,
    /// Instead of all other lines
    Only,
}

/// The paper.
#[derive(Debug, Args)]
#[command(next_help_heading = "Page (SVG)")]
struct PageArguments {
    /// Unit of the file, and of lengths given without one
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
    min_length: Option<String>,
    /// How far points may lie off the line for which they are dropped [default: 0.01mm]
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    tolerance: Option<String>,
    /// Leaves paths in the order of the lines instead of one in which the lifted pen travels little
    #[arg(long)]
    no_sort: bool,
    /// Draws lines that lie on others again
    #[arg(long)]
    no_dedupe: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum UnitArgument {
    /// Millimetres
    Mm,
    /// Pixels, 96 to an inch
    Px,
}

/// A true scale.
#[derive(Debug, Clone, Copy, PartialEq)]
enum ScaleArgument {
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
enum MeshUnitArgument {
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
enum FitArgument {
    /// The lines that are drawn
    Lines,
    /// The camera's viewport
    View,
}

/// The pens.
#[derive(Debug, Args)]
#[command(next_help_heading = "Pens (SVG)")]
struct PenArguments {
    /// Width of all pens, or of one kind's: 0.3mm, ridge=0.2mm; may be given several times
    #[arg(long, value_name = "[KIND=]LENGTH")]
    width: Vec<String>,
    /// Colour of all pens, or of one kind's: #1a2b3c, red, silhouette=black; may be given several times
    #[arg(long, value_name = "[KIND=]COLOUR", visible_alias = "color")]
    colour: Vec<String>,
    /// Strokes and gaps of one kind of visible line: curve=3mm,1mm; of hidden ones, with --hidden: hidden=2mm,1mm
    #[arg(long, value_name = "KIND=ON,OFF")]
    dash: Vec<String>,
    /// How strokes end
    #[arg(long, value_enum, default_value_t = CapArgument::Round)]
    cap: CapArgument,
    /// How the segments of a stroke meet
    #[arg(long, value_enum, default_value_t = JoinArgument::Round)]
    join: JoinArgument,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum CapArgument {
    /// At the last point
    Butt,
    /// With half a disc
    Round,
    /// With half a square
    Square,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum JoinArgument {
    /// With a sector of a disc
    Round,
    /// With the sides prolonged
    Miter,
    /// With the corner cut off
    Bevel,
}

/// How far a vertex may lie from the edge that it divides.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum HealDistance {
    /// A millionth of the mesh's largest extent.
    Auto,
    /// In units of the mesh.
    Units(f32),
}

impl FromStr for HealDistance {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text {
            "auto" => Ok(Self::Auto),
            number => number.parse().map(Self::Units).map_err(|_| "expected a distance such as 0.001".to_owned()),
        }
    }
}

/// What the outline's pen is called.
const OUTLINE: &str = "outline";
/// What the pattern of hidden lines is called.
const HIDDEN: &str = "hidden";

impl LinesArguments {
    /// Whether borders of materials are wanted, so that it has to be known which faces are of one.
    pub fn wants_materials(&self) -> bool {
        self.which.materials && self.line_options().material
    }

    /// Which lines are wanted.
    pub fn line_options(&self) -> LineOptions {
        let which = &self.which;
        let others = which.outline != Some(OutlineArgument::Only);
        let all_depths = matches!(which.hidden, Some(HiddenArgument::Dashed | HiddenArgument::Solid));
        LineOptions {
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
            outline: which.outline.is_some(),
        }
    }

    /// How they are drawn.
    pub fn plot_options(&self) -> Result<PlotOptions, Failure> {
        let page = &self.page;
        let unit = match page.units {
            UnitArgument::Mm => Unit::Mm,
            UnitArgument::Px => Unit::Px,
        };
        let (pens, hidden_dash) = self.pens.pens(unit, self.which.hidden == Some(HiddenArgument::Dashed))?;
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
            cap: match self.pens.cap {
                CapArgument::Butt => Cap::Butt,
                CapArgument::Round => Cap::Round,
                CapArgument::Square => Cap::Square,
            },
            join: match self.pens.join {
                JoinArgument::Round => Join::Round,
                JoinArgument::Miter => Join::Miter,
                JoinArgument::Bevel => Join::Bevel,
            },
            merge_tolerance: length("--tolerance", page.tolerance.as_deref(), unit, defaults.merge_tolerance)?,
            min_length: length("--min-length", page.min_length.as_deref(), unit, defaults.min_length)?,
            dedupe: !page.no_dedupe,
            order: !page.no_sort,
        })
    }
}

impl PageArguments {
    fn sheet(&self, unit: Unit) -> Result<Option<Sheet>, Failure> {
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

impl PenArguments {
    /// The pens, and the pattern of hidden lines, which may be given where they are drawn dashed.
    fn pens(&self, unit: Unit, draws_dashes: bool) -> Result<(Pens, Dash), Failure> {
        let mut pens = Pens::default();
        for word in &self.width {
            let (kind, text) = split(word);
            let width = length("--width", Some(text), unit, Length::mm(0.0))?;
            change("--width", kind, &mut pens, |pen| pen.width = width)?;
        }
        for word in &self.colour {
            let (kind, text) = split(word);
            let expected = "expected an opaque colour such as #1a2b3c or red";
            let colour = colour(text).ok_or_else(|| Failure::Input(format!("--colour {word}: {expected}")))?;
            change("--colour", kind, &mut pens, |pen| pen.colour = colour)?;
        }
        let mut hidden = Dash::HIDDEN;
        for word in &self.dash {
            let parts = |text: &str| {
                let (on, off) = text.split_once(',')?;
                Some(Dash { on: Length::parse(on, unit).ok()?, off: Length::parse(off, unit).ok()? })
            };
            let (Some(kind), text) = split(word) else {
                return Err(Failure::Input(format!("--dash {word}: say of which kind, as in hidden=2mm,1mm")));
            };
            let expected = || Failure::Input(format!("--dash {word}: expected two lengths such as {kind}=2mm,1mm"));
            let dash = parts(text).ok_or_else(expected)?;
            if kind == HIDDEN {
                if !draws_dashes {
                    return Err(Failure::Input(format!("--dash {word}: hidden lines are not dashed; add --hidden")));
                }
                hidden = dash;
            } else {
                change("--dash", Some(kind), &mut pens, |pen| pen.dash = Some(dash))?;
            }
        }
        Ok((pens, hidden))
    }
}

/// A colour as CSS writes it, names included; `None` for a translucent one, which no plotter has.
fn colour(text: &str) -> Option<Colour> {
    let [red, green, blue, alpha] = csscolorparser::parse(text).ok()?.to_rgba8();
    (alpha == u8::MAX).then_some(Colour([red, green, blue]))
}

/// The kind and the value of `KIND=VALUE`, or the value alone.
fn split(word: &str) -> (Option<&str>, &str) {
    word.split_once('=').map_or((None, word), |(kind, value)| (Some(kind), value))
}

/// Changes the pen of a kind, or all.
fn change(option: &str, kind: Option<&str>, pens: &mut Pens, change: impl Fn(&mut Pen)) -> Result<(), Failure> {
    match kind {
        None => pens.iter_mut().for_each(change),
        Some(OUTLINE) => change(&mut pens.outline),
        Some(name) => {
            let known = || LineKind::ALL.map(LineKind::name).join(", ");
            let kind = LineKind::ALL.into_iter().find(|kind| kind.name() == name);
            let unknown = || Failure::Input(format!("{option} {name}: no such kind; choose {}, {OUTLINE}", known()));
            change(pens.of_mut(kind.ok_or_else(unknown)?));
        }
    }
    Ok(())
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

    fn parse(options: &[&str]) -> LinesArguments {
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
        assert_eq!(arguments.meshes, ["builtin:cube"]);
        assert_eq!(arguments.plot_options().unwrap().hidden, Hidden::Dashed(Dash::HIDDEN));
        assert!(arguments.line_options().outline && arguments.line_options().silhouette);
        let only = parse(&["--outline=only", "--creases", "30", "--all-edges"]).line_options();
        assert!(only.outline && !only.silhouette && !only.mesh && only.ridge_deg.is_none());
    }

    #[test]
    fn pens_are_set_one_by_one_or_all_at_once() {
        let words = ["--width", "0.3", "--width", "ridge=2px", "--colour", "outline=red", "--dash", "curve=3,1mm"];
        let options = parse(&words).plot_options().unwrap();
        assert_eq!(options.pens.of(LineKind::Mesh).width, Length::mm(0.3));
        assert_eq!(options.pens.of(LineKind::Ridge).width, Length::px(2.0));
        assert_eq!((options.pens.outline.colour, options.pens.outline.width), (Colour([255, 0, 0]), Length::mm(0.3)));
        assert_eq!(options.pens.of(LineKind::Curve).dash, Some(Dash { on: Length::mm(3.0), off: Length::mm(1.0) }));
    }

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
