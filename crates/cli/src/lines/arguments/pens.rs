//! The pens that lines are drawn with.

use super::which::HiddenArgument;
use crate::failure::Failure;
use clap::{Args, ValueEnum};
use silhouette_visibility::LineKind;
use silhouette_visibility::plot::{Cap, Colour, Dash, Join, Length, Pen, Pens, Unit};

/// What the outline's pen is called.
const OUTLINE: &str = "outline";
/// What the pens and the pattern of hidden lines are called.
const HIDDEN: &str = "hidden";
/// What is said of a word that is no colour.
const COLOUR: &str = "expected an opaque colour such as #1a2b3c or red";

/// The pens.
#[derive(Debug, Args)]
#[command(next_help_heading = "Pens (SVG, PDF, DXF)")]
pub struct PenArguments {
    /// Width of all pens, of one kind's, of hidden lines', or of one hidden kind's: 0.3mm, ridge=0.2mm, hidden=0.18mm,
    /// hidden-ridge=0.13mm; may be given several times
    #[arg(long, value_name = "[KIND=]LENGTH")]
    width: Vec<String>,
    /// Colour of all pens, or of the same ones as --width: #1a2b3c, silhouette=red, hidden=grey; may be given several times
    #[arg(long, value_name = "[KIND=]COLOUR", visible_alias = "color")]
    colour: Vec<String>,
    /// Strokes and gaps of one kind of visible line: curve=3mm,1mm; of hidden ones, with --hidden: hidden=2mm,1mm or
    /// hidden-ridge=1mm,1mm
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
    pub fn pens(&self, unit: Unit, hidden: Option<HiddenArgument>) -> Result<(Pens, Dash), Failure> {
        let mut pens = Pens::default();
        for Word { word, whose, text } in words("--width", &self.width)? {
            let width = Length::parse(text, unit);
            let width = width.map_err(|error| Failure::Input(format!("--width {word}: {error}")))?;
            whose.change(&mut pens, |pen| pen.width = width);
        }
        for Word { word, whose, text } in words("--colour", &self.colour)? {
            let colour = colour(text).ok_or_else(|| Failure::Input(format!("--colour {word}: {COLOUR}")))?;
            whose.change(&mut pens, |pen| pen.colour = colour);
        }
        let mut hidden_dash = Dash::HIDDEN;
        for Word { word, whose, text } in words("--dash", &self.dash)? {
            let parts = || {
                let (on, off) = text.split_once(',')?;
                Some(Dash { on: Length::parse(on, unit).ok()?, off: Length::parse(off, unit).ok()? })
            };
            let expected = || Failure::Input(format!("--dash {word}: expected two lengths such as hidden=2mm,1mm"));
            let dash = parts().ok_or_else(expected)?;
            match whose {
                Whose::All => {
                    return Err(Failure::Input(format!("--dash {word}: say of which kind, as in hidden=2mm,1mm")));
                }
                Whose::Hidden | Whose::HiddenKind(_) if hidden != Some(HiddenArgument::Dashed) => {
                    return Err(Failure::Input(format!("--dash {word}: hidden lines are not dashed; add --hidden")));
                }
                Whose::Hidden => hidden_dash = dash,
                // Drawn solid, hidden lines are drawn as visible ones are.
                Whose::Kind(kind) if hidden != Some(HiddenArgument::Solid) => pens.of_mut(kind).dash = Some(dash),
                whose => whose.change(&mut pens, |pen| pen.dash = Some(dash)),
            }
        }
        Ok((pens, hidden_dash))
    }
}

/// Whose pens an option changes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Whose {
    All,
    /// A kind's, visible and hidden.
    Kind(LineKind),
    /// Those of all hidden lines.
    Hidden,
    HiddenKind(LineKind),
    Outline,
}

impl Whose {
    /// Reads what stands before the sign of equality.
    fn of(option: &str, name: &str) -> Result<Self, Failure> {
        let kind = |name: &str| LineKind::ALL.into_iter().find(|kind| kind.name() == name);
        let whose = match name {
            OUTLINE => Some(Self::Outline),
            HIDDEN => Some(Self::Hidden),
            name => match name.strip_prefix(HIDDEN).and_then(|rest| rest.strip_prefix('-')) {
                Some(name) => kind(name).map(Self::HiddenKind),
                None => kind(name).map(Self::Kind),
            },
        };
        let known = || LineKind::ALL.map(LineKind::name).join(", ");
        whose.ok_or_else(|| {
            Failure::Input(format!(
                "{option} {name}: no such kind; choose {}, {OUTLINE}, {HIDDEN}, or {HIDDEN}-ridge and so on",
                known()
            ))
        })
    }

    fn change(self, pens: &mut Pens, change: impl Fn(&mut Pen)) {
        match self {
            Self::All => pens.iter_mut().for_each(change),
            Self::Kind(kind) => {
                change(pens.of_mut(kind));
                change(pens.of_hidden_mut(kind));
            }
            Self::Hidden => LineKind::ALL.into_iter().for_each(|kind| change(pens.of_hidden_mut(kind))),
            Self::HiddenKind(kind) => change(pens.of_hidden_mut(kind)),
            Self::Outline => change(&mut pens.outline),
        }
    }
}

/// A word of an option that changes pens.
struct Word<'a> {
    word: &'a str,
    whose: Whose,
    /// What follows the sign of equality.
    text: &'a str,
}

/// The words of an option, those that change many pens before those that change few, whatever their order.
fn words<'a>(option: &str, words: &'a [String]) -> Result<Vec<Word<'a>>, Failure> {
    let read = |word: &'a String| {
        let (whose, text) = match word.split_once('=') {
            Some((name, text)) => (Whose::of(option, name)?, text),
            None => (Whose::All, word.as_str()),
        };
        Ok(Word { word, whose, text })
    };
    let mut words = words.iter().map(read).collect::<Result<Vec<_>, Failure>>()?;
    words.sort_by_key(|word| word.whose);
    Ok(words)
}

/// A colour as CSS writes it, names included; `None` for a translucent one, which no plotter has.
fn colour(text: &str) -> Option<Colour> {
    let [red, green, blue, alpha] = csscolorparser::parse(text).ok()?.to_rgba8();
    (alpha == u8::MAX).then_some(Colour([red, green, blue]))
}

#[cfg(test)]
mod tests {
    use super::super::tests::parse;
    use super::*;
    use silhouette_visibility::plot::Hidden;

    #[test]
    fn pens_are_set_one_by_one_or_all_at_once() {
        let words = ["--width", "0.3", "--width", "ridge=2px", "--colour", "outline=red", "--dash", "curve=3,1mm"];
        let options = parse(&words).plot_options().unwrap();
        assert_eq!(options.pens.of(LineKind::Mesh).width, Length::mm(0.3));
        assert_eq!(options.pens.of(LineKind::Ridge).width, Length::px(2.0));
        assert_eq!((options.pens.outline.colour, options.pens.outline.width), (Colour([255, 0, 0]), Length::mm(0.3)));
        assert_eq!(
            options.pens.of_hidden(LineKind::Ridge).width,
            Length::px(2.0),
            "a kind's pen draws its hidden lines"
        );
        assert_eq!(options.pens.of(LineKind::Curve).dash, Some(Dash { on: Length::mm(3.0), off: Length::mm(1.0) }));
    }
    #[test]
    fn hidden_lines_have_pens_of_their_own() {
        // The most particular word counts, whatever the order.
        let words =
            ["--width", "hidden-ridge=0.13mm", "--width", "hidden=0.18mm", "--width", "ridge=0.35", "--width", "0.5"];
        let colours = ["--colour", "hidden=grey", "--hidden", "--dash", "hidden=3,1", "--dash", "hidden-valley=1,1"];
        let options = parse(&[&words[..], &colours].concat()).plot_options().unwrap();
        let (ridge, mesh) = (LineKind::Ridge, LineKind::Mesh);
        let widths = [
            options.pens.of(mesh),
            options.pens.of(ridge),
            options.pens.of_hidden(mesh),
            options.pens.of_hidden(ridge),
        ];
        assert_eq!(widths.map(|pen| pen.width), [0.5, 0.35, 0.18, 0.13].map(Length::mm));
        let grey = Colour([128; 3]);
        assert_eq!([options.pens.of(ridge).colour, options.pens.of_hidden(ridge).colour], [Colour::BLACK, grey]);
        let dash = |on| Dash { on: Length::mm(on), off: Length::mm(1.0) };
        assert_eq!(options.hidden, Hidden::Dashed(dash(3.0)));
        assert_eq!(options.pens.of_hidden(LineKind::Valley).dash, Some(dash(1.0)));
        assert_eq!(options.pens.of_hidden(ridge).dash, None);
        for bad in [["--width", "hidden-wall=1"], ["--width", "hiddenridge=1"], ["--dash", "hidden-ridge=1,1"]] {
            assert!(parse(&bad).plot_options().is_err(), "{bad:?}");
        }
        let solid = parse(&["--hidden=solid", "--dash", "ridge=2,2"]).plot_options().unwrap();
        assert!(solid.pens.of_hidden(ridge).dash.is_some(), "solid hidden lines are drawn as visible ones are");
    }
}
