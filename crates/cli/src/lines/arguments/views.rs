//! Several views on one page.

use clap::{Args, ValueEnum};
use silhouette_core::view::ViewPreset;
use silhouette_visibility::plot::ProjectionAngle;
use std::str::FromStr;

/// Several views on one page.
#[derive(Debug, Args)]
#[command(next_help_heading = "Camera")]
pub struct ViewsArguments {
    /// Several views on one page, at one scale, without perspective: front,top,right,iso
    #[arg(long, value_name = "NAME,NAME", value_parser = Views::from_str,
        conflicts_with_all = ["view", "eye", "target", "up", "fov"])]
    pub views: Option<Views>,
    /// Where the views stand: third (what is seen from the right on the right, as in America) or first (on the left, as ISO has it)
    /// [default: third]
    #[arg(long, value_enum, value_name = "ANGLE", requires = "views")]
    pub projection: Option<ProjectionArgument>,
}

/// Different views.
#[derive(Debug, Clone, PartialEq)]
pub struct Views(pub Vec<ViewPreset>);

impl FromStr for Views {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let mut views = Vec::new();
        for word in text.split(',') {
            let known = || ViewPreset::NAMED.map(|(name, _)| name).join(", ");
            let found = ViewPreset::NAMED.iter().find(|(name, _)| *name == word.trim());
            let &(_, preset) = found.ok_or_else(|| format!("expected some of {}", known()))?;
            if views.contains(&preset) {
                return Err(format!("{} is named twice", word.trim()));
            }
            views.push(preset);
        }
        Ok(Self(views))
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum ProjectionArgument {
    /// The view from the right stands on the left, that from above below
    First,
    /// The view from the right stands on the right, that from above above
    Third,
}

impl ViewsArguments {
    /// How the views are folded into the page.
    pub fn angle(&self) -> ProjectionAngle {
        match self.projection {
            Some(ProjectionArgument::First) => ProjectionAngle::First,
            Some(ProjectionArgument::Third) | None => ProjectionAngle::Third,
        }
    }
}
