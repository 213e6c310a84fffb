//! [`Links`]: which place of another frame a place becomes.

use super::places::{TrueFrame, TruePlace};
use crate::metrics::point_grid::PointGrid;
use rayon::prelude::*;
use silhouette_core::Topology;
use silhouette_core::glam::Vec3;

use super::reference_scale;

/// How far from where its point of the mesh has moved a place may lie in the next frame, in reference pixels: silhouettes slip
/// over the surface. A true line that jumps farther, from edge to edge of a coarse mesh, has not stayed.
pub const SLIP: f64 = 5.0;

/// Least cosine of the angle between the directions of a line before and after.
const LEAST_COSINE: f64 = 0.7;

/// Links between the places of two frames, one after the other.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Links {
    /// Of each place of the first frame, its place in the second; `None` where the true line has not stayed.
    pub forward: Vec<Option<u32>>,
    /// The other way round.
    pub backward: Vec<Option<u32>>,
}

impl Links {
    /// Links two frames of a mesh with this topology, whose vertices rest at `rest`. O(places).
    pub fn new(frames: [&TrueFrame; 2], topology: &Topology, rest: &[Vec3]) -> Self {
        let [first, second] = frames;
        Self { forward: link(first, second, topology, rest), backward: link(second, first, topology, rest) }
    }
}

fn link(from: &TrueFrame, to: &TrueFrame, topology: &Topology, rest: &[Vec3]) -> Vec<Option<u32>> {
    let grid = PointGrid::new(to.places.iter().map(|place| place.at).collect(), SLIP);
    let positions = to.positions.as_deref().unwrap_or(rest);
    let scale = reference_scale(to.camera.size()[1]);
    let successor = |place: &TruePlace| {
        let [a, b] = topology.end_points(place.edge).map(|vertex| positions[vertex.index()].as_dvec3());
        let pixel = to.camera.project(a.lerp(b, place.share))?.pixel;
        let runs_alike = |at: usize| to.places[at].normal.dot(place.normal) >= LEAST_COSINE;
        grid.nearest(pixel * scale, runs_alike).map(|at| at as u32)
    };
    from.places.par_iter().map(successor).collect()
}
