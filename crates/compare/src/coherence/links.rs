//! [`Links`]: which place of another frame a place becomes.

use super::places::{TrueFrame, TruePlace};
use super::reference_scale;
use crate::metrics::point_grid::PointGrid;
use rayon::prelude::*;
use silhouette_core::Topology;
use silhouette_core::glam::Vec3;

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

#[cfg(test)]
mod tests {
    use super::super::sample_sequence::SampleSequence;
    use super::*;

    #[test]
    fn a_place_becomes_itself_where_nothing_moves() {
        let sample = SampleSequence::of("torus", 512);
        let frame = &sample.sequence.frames[0];
        let links = Links::new([frame, frame], &sample.topology, &sample.rest);
        let identity: Vec<Option<u32>> = (0..frame.places.len() as u32).map(Some).collect();
        assert_eq!((&links.forward, &links.backward), (&identity, &identity));
    }

    /// What the true line moves by, a place moves by, and there and back again is where it was, give or take a place.
    #[test]
    fn places_are_followed_there_and_back_while_the_view_turns() {
        let sample = SampleSequence::of("torus", 512);
        let (frames, links) = (&sample.sequence.frames, &sample.sequence.links[0]);
        let (mut kept, mut returned) = (0, 0);
        for (at, next) in links.forward.iter().enumerate() {
            let Some(next) = next else { continue };
            kept += 1;
            let back = links.backward[*next as usize];
            let near = |back: u32| frames[0].places[back as usize].at.distance(frames[0].places[at].at) < 2.0 * SLIP;
            returned += u32::from(back.is_some_and(near));
        }
        assert!(kept as usize > 9 * links.forward.len() / 10, "{kept} of {}", links.forward.len());
        assert!(returned > 99 * kept / 100, "{returned} of {kept}");
    }

    /// The control: where the mesh has moved far, no line has stayed.
    #[test]
    fn lines_that_jump_have_not_stayed() {
        let sample = SampleSequence::of("torus", 512);
        let frame = &sample.sequence.frames[0];
        let mut jumped = frame.clone();
        jumped.places.iter_mut().for_each(|place| place.at += 4.0 * SLIP * place.normal);
        let links = Links::new([frame, &jumped], &sample.topology, &sample.rest);
        let kept = links.forward.iter().flatten().count();
        assert!(kept < links.forward.len() / 10, "{kept} of {}", links.forward.len());
    }
}
