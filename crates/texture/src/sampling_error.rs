//! [`SamplingError`]: how much of the sphere the texture gets wrong (equation 3, averaged over the hull).
//!
//! Points are spread evenly over the area of the hull, directions over the sphere: each point has a Fibonacci lattice of its own,
//! turned by a random angle and axis. The same numbers every time.

use crate::atlas::Place;
use crate::directions::spread;
use crate::lookup::{AzimuthRule, Lookup};
use crate::silhouette_texture::SilhouetteTexture;
use crate::visibility_function::VisibilityFunction;
use glam::{Quat, Vec3};
use rayon::prelude::*;
use silhouette_core::{Cancelled, FaceId, Progress, TriangleMesh, glam};
use std::f64::consts::TAU;

/// The points and directions of a measurement.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ErrorOptions {
    /// Points of the hull. 2000 by default.
    pub points: u32,
    /// Directions per point. 3000 by default.
    pub directions: u32,
    /// How azimuths are looked up.
    pub azimuths: AzimuthRule,
}

impl Default for ErrorOptions {
    fn default() -> Self {
        Self { points: 2000, directions: 3000, azimuths: AzimuthRule::Aligned }
    }
}

/// Shares of the sphere, each a mean over points of the hull.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SamplingError {
    /// Directions in which the texture differs from the visibility function: the paper's "average VF sampling error".
    pub mean: f64,
    /// Standard error of `mean`, from how points differ.
    pub standard_error: f64,
    /// Of these, directions in which the texture shows the object and the function does not.
    pub excess: f64,
    /// Of these, directions in which the function shows the object and the texture does not.
    pub missing: f64,
    /// Directions in which the function shows the object.
    pub shown: f64,
}

/// Measures a texture against the function that it samples. O(points x directions) rays, in parallel.
///
/// # Errors
/// [`Cancelled`] by the progress.
pub fn sampling_error(
    texture: &SilhouetteTexture,
    visibility: &VisibilityFunction,
    options: &ErrorOptions,
    progress: &dyn Progress,
) -> Result<SamplingError, Cancelled> {
    progress.stage("sampling error", u64::from(options.points));
    let lookup = Lookup::new(texture, options.azimuths);
    let places = places(texture.parts().hull.mesh(), options.points);
    let of_place = |(index, place): (usize, &Place)| {
        progress.check()?;
        let point = visibility.point(place.face, place.weights);
        let turn = Quat::from_rotation_arc(Vec3::Z, spread(options.points, 0.7).nth(index).unwrap_or(Vec3::Z));
        let [mut excess, mut missing, mut shown] = [0_u32; 3];
        for direction in spread(options.directions, TAU * share(index, 3)) {
            let direction = (turn * direction).normalize();
            let (truth, found) = (visibility.shows(&point, direction), lookup.shows(place, direction));
            // The renderer draws front faces only.
            let found = found && point.normal.dot(direction) < 0.0;
            excess += u32::from(found && !truth);
            missing += u32::from(truth && !found);
            shown += u32::from(truth);
        }
        progress.advance(1);
        Ok([excess, missing, shown].map(|count| f64::from(count) / f64::from(options.directions.max(1))))
    };
    let shares: Vec<[f64; 3]> = places.par_iter().enumerate().map(of_place).collect::<Result<_, Cancelled>>()?;
    let count = shares.len().max(1) as f64;
    let [excess, missing, shown] = [0, 1, 2].map(|at| shares.iter().map(|share| share[at]).sum::<f64>() / count);
    let mean = excess + missing;
    let squares: f64 = shares.iter().map(|share| (share[0] + share[1] - mean).powi(2)).sum();
    Ok(SamplingError { mean, standard_error: squares.sqrt() / count, excess, missing, shown })
}

/// Number `index` of the sequence of powers of the generalised golden ratio that fills the unit cube of three dimensions evenly,
/// and a fourth beside it.
fn share(index: usize, dimension: i32) -> f64 {
    const RATIO: f64 = 1.220_744_084_605_759_5;
    (0.5 + RATIO.powi(-dimension - 1) * (index as f64 + 1.0)).fract()
}

/// Points spread over the area of a mesh.
pub fn places(mesh: &TriangleMesh, count: u32) -> Vec<Place> {
    let area = |face: usize| {
        let [a, b, c] = mesh.corners(FaceId::from_usize(face)).map(Vec3::as_dvec3);
        (b - a).cross(c - a).length()
    };
    let mut total = 0.0;
    let sums: Vec<f64> = (0..mesh.face_count())
        .map(|face| {
            total += area(face);
            total
        })
        .collect();
    (0..count as usize)
        .filter_map(|index| {
            let face = sums.partition_point(|&sum| sum <= share(index, 0) * total);
            let (root, along) = (share(index, 1).sqrt(), share(index, 2));
            let weights = [1.0 - root, root * (1.0 - along), root * along].map(|weight| weight as f32);
            (face < sums.len()).then(|| Place { face: FaceId::from_usize(face), weights: Vec3::from(weights) })
        })
        .collect()
}
