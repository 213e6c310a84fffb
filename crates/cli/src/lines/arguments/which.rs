//! Which lines are drawn.

use crate::args::bend;
use clap::{Args, ValueEnum};
use silhouette_core::glam::DVec3;
use silhouette_visibility::{ParseSectionPlaneError, SectionPlane};
use std::fmt;
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
    #[arg(long, value_name = "X,Y,Z,NX,NY,NZ", allow_hyphen_values = true, value_parser = SectionArgument::from_str, conflicts_with = "smooth")]
    pub section: Vec<SectionArgument>,
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

/// A plane in the coordinates of the meshes' files.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SectionArgument {
    point: DVec3,
    /// The plane where positions count from zero.
    plane: SectionPlane,
}

impl SectionArgument {
    /// The plane for meshes whose positions count from `origin`; `None` where it lies beyond 32 bits as seen from there.
    pub fn seen_from(&self, origin: DVec3) -> Option<SectionPlane> {
        if origin == DVec3::ZERO {
            return Some(self.plane);
        }
        SectionPlane::new((self.point - origin).as_vec3(), self.plane.normal())
    }
}

impl FromStr for SectionArgument {
    type Err = ParseSectionPlaneError;

    fn from_str(text: &str) -> Result<Self, ParseSectionPlaneError> {
        let plane = text.parse()?;
        let numbers: Option<Vec<f64>> = text.split(',').map(|number| number.trim().parse().ok()).collect();
        let Some(&[x, y, z, ..]) = numbers.as_deref() else { return Err(ParseSectionPlaneError) };
        Ok(Self { point: DVec3::new(x, y, z), plane })
    }
}

impl fmt::Display for SectionArgument {
    /// As it is read.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (DVec3 { x, y, z }, normal) = (self.point, self.plane.normal());
        write!(f, "{x},{y},{z},{},{},{}", normal.x, normal.y, normal.z)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn planes_are_in_the_coordinates_of_the_file() {
        let far: SectionArgument = "500000.25,0,5400000.5,0,0,1".parse().unwrap();
        assert_eq!(far.to_string(), "500000.25,0,5400000.5,0,0,1");
        let plane = far.seen_from(DVec3::new(500_000.0, 0.0, 5_400_000.0)).unwrap();
        assert_eq!(plane.to_string(), "0.25,0,0.5,0,0,1");
        let near: SectionArgument = "0.1,0,0,1,0,0".parse().unwrap();
        assert_eq!(near.seen_from(DVec3::ZERO).unwrap().point().x.to_bits(), 0.1_f32.to_bits());
    }
}
