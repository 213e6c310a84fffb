//! The ellipsoid, tessellated by latitude and longitude.

use super::builtin::{ArgumentSpec, Builtin, ShapeError};
use super::revolution::{face_count, revolve};
use crate::mesh::TriangleMesh;
use glam::{DVec2, DVec3, Vec3};
use rayon::prelude::*;

/// An axis-aligned ellipsoid about the origin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ellipsoid {
    /// Half the length along x, y and z, each 0.01 to 100. Default: 1, 0.6, 0.4.
    pub semi_axes: [f64; 3],
}

pub(super) static ELLIPSOID: Builtin = Builtin {
    name: "ellipsoid",
    summary: "An ellipsoid by latitude and longitude: a smooth outline of varying curvature.",
    arguments: &[
        ArgumentSpec::count("segments", "faces around", [3, 8192], 96),
        ArgumentSpec::count("bands", "bands from pole to pole", [2, 8192], 48),
        ArgumentSpec::length("semi-axis-x", "half the length along x", 1.0),
        ArgumentSpec::length("semi-axis-y", "half the length along y", 0.6),
        ArgumentSpec::length("semi-axis-z", "half the length along z", 0.4),
    ],
    genus: Some(0),
    build: |values| from(values).mesh(values[0] as u32, values[1] as u32),
    contour: Some(|values| Ok(Box::new(from(values)))),
};

fn from(values: &[f64]) -> Ellipsoid {
    Ellipsoid { semi_axes: [values[2], values[3], values[4]] }
}

impl Default for Ellipsoid {
    fn default() -> Self {
        Self { semi_axes: [1.0, 0.6, 0.4] }
    }
}

impl Ellipsoid {
    /// `segments` (3 to 8192) faces around y and `bands` (2 to 8192) from pole to pole: 2 * segments * (bands - 1) faces.
    ///
    /// # Errors
    /// [`ShapeError`] where an argument is out of range or there would be too many faces.
    pub fn mesh(&self, segments: u32, bands: u32) -> Result<TriangleMesh, ShapeError> {
        let [x, y, z] = self.semi_axes;
        let faces = face_count(segments, bands.saturating_sub(1));
        ELLIPSOID.check(&[f64::from(segments), f64::from(bands), x, y, z], faces)?;
        let rings: Vec<DVec2> = (1..bands)
            .map(|band| {
                let (sin, cos) = super::turn(band, 2 * bands).sin_cos();
                DVec2::new(sin, -cos)
            })
            .collect();
        let unit = revolve([-1.0, 1.0], &rings, segments);
        let scale = |p: &Vec3| (p.as_dvec3() * DVec3::new(x, y, z)).as_vec3();
        Ok(super::finish(unit.positions().par_iter().map(scale).collect(), unit.triangles().to_vec()))
    }
}
