//! The gear: a toothed plate with a bore.

use super::builtin::{ArgumentSpec, Builtin, ShapeError};
use super::lattice::Lattice;
use super::{around_y, turn};
use crate::mesh::TriangleMesh;
use glam::DVec3;

/// A gear about the y axis with trapezoidal teeth and a round bore; its tips reach radius 1. Every edge between two of
/// its sides is sharp.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gear {
    /// Number of teeth, 3 to 4096. Default: 16.
    pub teeth: u32,
    /// Radius between the teeth, as a share of the tips' radius, 0.5 to 0.95. Default: 0.8.
    pub root: f64,
    /// Radius of the bore as a share of the root radius, 0.1 to 0.9. Default: 0.4.
    pub bore: f64,
    /// Length along y, 0.01 to 10. Default: 0.4.
    pub thickness: f64,
}

pub(super) static GEAR: Builtin = Builtin {
    name: "gear",
    summary: "A toothed plate with a bore: genus 1, sharp creases, large flat sides, as from a CAD system.",
    arguments: &[
        ArgumentSpec::count("teeth", "number of teeth", [3, 4096], 16),
        ArgumentSpec::number("root", "radius between the teeth over the radius at the tips", [0.5, 0.95], 0.8),
        ArgumentSpec::number("bore", "radius of the bore over the radius between the teeth", [0.1, 0.9], 0.4),
        ArgumentSpec::number("thickness", "length along y", [0.01, 10.0], 0.4),
    ],
    genus: Some(1),
    build: |values| Gear { teeth: values[0] as u32, root: values[1], bore: values[2], thickness: values[3] }.mesh(),
    contour: None,
};

impl Default for Gear {
    fn default() -> Self {
        Self { teeth: 16, root: 0.8, bore: 0.4, thickness: 0.4 }
    }
}

/// Where a tooth's profile has its corners, in sixteenths of a tooth's pitch, and whether each is at the tip. The flanks
/// take 2/16 each, so that they lean but stay steep.
const PROFILE: [(u32, bool); 4] = [(4, false), (6, true), (10, true), (12, false)];

impl Gear {
    /// 32 faces a tooth.
    ///
    /// # Errors
    /// [`ShapeError`] where an argument is out of range.
    pub fn mesh(&self) -> Result<TriangleMesh, ShapeError> {
        let values = [f64::from(self.teeth), self.root, self.bore, self.thickness];
        GEAR.check(&values, 32 * u64::from(self.teeth))?;
        // Four loops around the axis, each with the profile's angles, closed to a ring: bore and outside below, outside
        // and bore above. Corners of the two profiles lie on common rays, so the flat sides are cut without overlap.
        let rows = [(false, -0.5), (true, -0.5), (true, 0.5), (false, 0.5)];
        Ok(Lattice::closed(4 * self.teeth, 4).mesh(|column, row| {
            let (sixteenths, at_tip) = PROFILE[column as usize % 4];
            let (is_outside, height) = rows[row as usize];
            let radius = match (is_outside, at_tip) {
                (false, _) => self.root * self.bore,
                (true, false) => self.root,
                (true, true) => 1.0,
            };
            let ray = around_y(turn(column / 4 * 16 + sixteenths, 16 * self.teeth));
            ray * radius + DVec3::Y * (height * self.thickness)
        }))
    }
}
