//! The pens that lines are drawn with.

use super::length;
use crate::failure::Failure;
use clap::{Args, ValueEnum};
use silhouette_visibility::LineKind;
use silhouette_visibility::plot::{Cap, Colour, Dash, Join, Length, Pen, Pens, Unit};

/// What the outline's pen is called.
const OUTLINE: &str = "outline";
/// What the pattern of hidden lines is called.
const HIDDEN: &str = "hidden";
/// What is said of a word that is no colour.
const COLOUR: &str = "expected an opaque colour such as #1a2b3c or red";

/// The pens.
#[derive(Debug, Args)]
#[command(next_help_heading = "Pens (SVG, PDF, DXF)")]
pub struct PenArguments {
    /// Width of all pens, or of one kind's: 0.3mm, ridge=0.2mm; may be given several times
    #[arg(long, value_name = "[KIND=]LENGTH")]
    width: Vec<String>,
    /// Colour of all pens, or of one kind's: #1a2b3c, red, silhouette=black; may be given several times
    #[arg(long, value_name = "[KIND=]COLOUR", visible_alias = "color")]
    colour: Vec<String>,
    /// Strokes and gaps of one kind of visible line: curve=3mm,1mm; of hidden ones, with --hidden: hidden=2mm,1mm
    #[arg(long, value_name = "KIND=ON,OFF")]
    dash: Vec<String>,
    /// Fills all that the meshes cover, beneath the lines, in SVG, PDF and DXF [--fill alone: white, so that the drawing covers what
    /// it is laid upon]
    #[arg(long, value_name = "COLOUR", num_args = 0..=1, require_equals = true, default_missing_value = "white")]
    fill: Option<String>,
    /// How strokes end
    #[arg(long, value_enum, default_value_t = CapArgument::Round)]
    cap: CapArgument,
    /// How the segments of a stroke meet
    #[arg(long, value_enum, default_value_t = JoinArgument::Round)]
    join: JoinArgument,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum CapArgument {
    /// At the last point
    Butt,
    /// With half a disc
    Round,
    /// With half a square
    Square,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum JoinArgument {
    /// With a sector of a disc
    Round,
    /// With the sides prolonged
    Miter,
    /// With the corner cut off
    Bevel,
}

impl PenArguments {
    pub const fn cap(&self) -> Cap {
        match self.cap {
            CapArgument::Butt => Cap::Butt,
            CapArgument::Round => Cap::Round,
            CapArgument::Square => Cap::Square,
        }
    }

    pub const fn join(&self) -> Join {
        match self.join {
            JoinArgument::Round => Join::Round,
            JoinArgument::Miter => Join::Miter,
            JoinArgument::Bevel => Join::Bevel,
        }
    }

    /// Whether something is to be filled.
    pub const fn wants_fill(&self) -> bool {
        self.fill.is_some()
    }

    /// With what.
    pub fn fill(&self) -> Result<Option<Colour>, Failure> {
        let read = |text: &String| colour(text).ok_or_else(|| Failure::Input(format!("--fill {text}: {COLOUR}")));
        self.fill.as_ref().map(read).transpose()
    }

    /// The pens, and the pattern of hidden lines, which may be given where they are drawn dashed.
    pub fn pens(&self, unit: Unit, draws_dashes: bool) -> Result<(Pens, Dash), Failure> {
        let mut pens = Pens::default();
        for word in &self.width {
            let (kind, text) = split(word);
            let width = length("--width", Some(text), unit, Length::mm(0.0))?;
            change("--width", kind, &mut pens, |pen| pen.width = width)?;
        }
        for word in &self.colour {
            let (kind, text) = split(word);
            let colour = colour(text).ok_or_else(|| Failure::Input(format!("--colour {word}: {COLOUR}")))?;
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

#[cfg(test)]
mod tests {
    use super::super::tests::parse;
    use super::*;

    #[test]
    fn pens_are_set_one_by_one_or_all_at_once() {
        let words = ["--width", "0.3", "--width", "ridge=2px", "--colour", "outline=red", "--dash", "curve=3,1mm"];
        let options = parse(&words).plot_options().unwrap();
        assert_eq!(options.pens.of(LineKind::Mesh).width, Length::mm(0.3));
        assert_eq!(options.pens.of(LineKind::Ridge).width, Length::px(2.0));
        assert_eq!((options.pens.outline.colour, options.pens.outline.width), (Colour([255, 0, 0]), Length::mm(0.3)));
        assert_eq!(options.pens.of(LineKind::Curve).dash, Some(Dash { on: Length::mm(3.0), off: Length::mm(1.0) }));
    }
}
