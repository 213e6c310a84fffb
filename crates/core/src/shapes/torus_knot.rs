//! Tubes around torus knots.

use super::builtin::{ArgumentSpec, Builtin, ShapeError};
use super::lattice::Lattice;
use crate::mesh::TriangleMesh;
use glam::DVec3;
use std::f64::consts::TAU;

/// A tube around the (p, q) torus knot: its centre line winds p times around the y axis and q times around the tube of
/// a torus of radii 1 and 0.4.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TorusKnot {
    /// Turns around the axis, 1 to 16, without a common factor with `q`. Default: 2.
    pub p: u32,
    /// Turns around the torus' tube, 1 to 16. Default: 3.
    pub q: u32,
    /// Radius of the knot's tube as a share of [`max_tube_radius`](Self::max_tube_radius), 0.05 to 0.9. Default: 0.7.
    pub thickness: f64,
}

/// Radii of the torus that the centre line lies on.
const MAJOR: f64 = 1.0;
const MINOR: f64 = 0.4;

pub(super) static TORUS_KNOT: Builtin = Builtin {
    name: "knot",
    summary: "A tube around a (p, q) torus knot: genus 1, hides itself in every view.",
    arguments: &[
        ArgumentSpec::count("p", "turns around the axis, coprime to q", [1, 16], 2),
        ArgumentSpec::count("q", "turns around the tube", [1, 16], 3),
        ArgumentSpec::count("along", "faces along the knot", [3, 65_536], 360),
        ArgumentSpec::count("across", "faces around the tube", [3, 4096], 16),
        ArgumentSpec::number(
            "thickness",
            "tube radius as a share of the thickest that stays clear of itself",
            [0.05, 0.9],
            0.7,
        ),
    ],
    genus: Some(1),
    build: |values| {
        let [p, q, along, across] = [0, 1, 2, 3].map(|i| values[i] as u32);
        TorusKnot { p, q, thickness: values[4] }.mesh(along, across)
    },
    contour: None,
};

impl Default for TorusKnot {
    fn default() -> Self {
        Self { p: 2, q: 3, thickness: 0.7 }
    }
}

impl TorusKnot {
    /// A radius below which neighbouring strands do not touch: half the chord between two strands where they are
    /// closest, on the inside of the torus, and half the torus' minor radius at most, so that the tube's bends stay
    /// smooth.
    pub fn max_tube_radius(&self) -> f64 {
        // Unroll the inside of the torus to a rectangle. The knot fills it with equidistant parallel strands, so their
        // distance is its area over their length.
        let (around, across) = (TAU * (MAJOR - MINOR), TAU * MINOR);
        let length = (f64::from(self.p) * around).hypot(f64::from(self.q) * across);
        let apart = around * across / length;
        let chord = 2.0 * MINOR * (apart / (2.0 * MINOR)).min(std::f64::consts::FRAC_PI_2).sin();
        (0.5 * chord).min(0.5 * MINOR)
    }

    /// `along` (3 to 65536) faces along the knot times `across` (3 to 4096) around it: 2 * along * across faces. Below
    /// about 16 (p + q) faces along the knot the polygonal tube may cut through itself.
    ///
    /// # Errors
    /// [`ShapeError`] where an argument is out of range, p and q have a common factor or there would be too many faces.
    pub fn mesh(&self, along: u32, across: u32) -> Result<TriangleMesh, ShapeError> {
        let counts = [self.p, self.q, along, across].map(f64::from);
        let values = [counts[0], counts[1], counts[2], counts[3], self.thickness];
        TORUS_KNOT.check(&values, 2 * u64::from(along) * u64::from(across))?;
        if common_factor(self.p, self.q) != 1 {
            let rule = "p and q must have no common factor, otherwise the curve is several rings";
            return Err(ShapeError::Combination { shape: TORUS_KNOT.name, rule });
        }
        let radius = self.thickness * self.max_tube_radius();
        Ok(Lattice::closed(along, across).mesh(|column, row| {
            let Frame { point, tangent, normal } = self.frame(super::turn(column, along));
            let (sin, cos) = super::turn(row, across).sin_cos();
            point + (normal * cos + normal.cross(tangent) * sin) * radius
        }))
    }

    /// The centre line at parameter `t` in radians, with the torus' normal. Unlike a frame carried along by parallel
    /// transport, this one closes by itself.
    fn frame(&self, t: f64) -> Frame {
        let (p, q) = (f64::from(self.p), f64::from(self.q));
        let outward = super::around_y(p * t);
        let (sin, cos) = (q * t).sin_cos();
        let normal = outward * cos + DVec3::Y * sin;
        let along_axis = DVec3::Y.cross(outward) * (p * (MAJOR + MINOR * cos));
        let along_tube = (DVec3::Y * cos - outward * sin) * (q * MINOR);
        Frame { point: outward * MAJOR + normal * MINOR, tangent: (along_axis + along_tube).normalize(), normal }
    }
}

struct Frame {
    point: DVec3,
    tangent: DVec3,
    normal: DVec3,
}

fn common_factor(a: u32, b: u32) -> u32 {
    if b == 0 { a } else { common_factor(b, a % b) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_thickest_tube_stays_clear_of_itself() {
        for (p, q) in [(1, 1), (2, 3), (3, 2), (2, 5), (5, 2), (3, 7), (7, 3), (1, 8), (8, 1)] {
            let knot = TorusKnot { p, q, thickness: 0.9 };
            let radius = knot.thickness * knot.max_tube_radius();
            let samples = 1500;
            let points: Vec<DVec3> = (0..samples).map(|i| knot.frame(super::super::turn(i, samples)).point).collect();
            let lengths: Vec<f64> =
                (0..points.len()).map(|i| points[i].distance(points[(i + 1) % points.len()])).collect();
            let total: f64 = lengths.iter().sum();
            for i in 0..points.len() {
                // Points nearer along the curve than half a turn of the tube belong to the same bend.
                let mut along = 0.0;
                for j in i + 1..points.len() {
                    along += lengths[j - 1];
                    if along.min(total - along) > std::f64::consts::PI * radius {
                        let distance = points[i].distance(points[j]);
                        assert!(distance > 2.0 * radius, "({p}, {q}): {distance} < 2 * {radius}");
                    }
                }
            }
        }
    }

    #[test]
    fn a_frame_is_orthonormal_and_its_tangent_is_the_derivative() {
        let knot = TorusKnot::default();
        for t in [0.0, 0.3, 1.7, 4.0] {
            let Frame { point, tangent, normal } = knot.frame(t);
            assert!(tangent.dot(normal).abs() < 1e-12 && (normal.length() - 1.0).abs() < 1e-12);
            let difference = (knot.frame(t + 1e-6).point - point).normalize();
            assert!(difference.distance(tangent) < 1e-5, "{difference} {tangent}");
        }
    }
}
