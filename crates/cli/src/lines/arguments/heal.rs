//! [`HealDistance`]: how far a vertex may lie from the edge that it divides.

use std::str::FromStr;

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
