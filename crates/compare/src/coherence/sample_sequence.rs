//! A sequence with its truth, drawn by the true pen, and the ways in which the tests make it worse.

use super::metrics::{CoherenceMetrics, Sequence, measure, observe};
use super::{DrawnFrame, Motion, TrueFrame};
use crate::camera_path::Orbit;
use crate::metrics::{Ink, PictureKind};
use crate::runner::coherence_truth::true_sequence;
use crate::truth::pen;
use crate::truth::visible::VisibleLine;
use glam::DVec2;
use rayon::prelude::*;
use silhouette_core::glam::Vec3;
use silhouette_core::view::Framing;
use silhouette_core::{NoProgress, PreparedMesh, Topology, shapes};
use silhouette_gpu::{Pen, PenPlacement};
use std::collections::HashMap;
use std::sync::Arc;

/// Frames of every sequence.
const FRAMES: u32 = 12;

/// Truth of a sequence.
pub struct SampleSequence {
    pub sequence: Sequence,
    pub topology: Topology,
    /// Where the vertices rest.
    pub rest: Vec<Vec3>,
}

/// Draws a frame of a sequence.
type Draw = fn(&TrueFrame, usize) -> Ink;

impl SampleSequence {
    /// A shape with many loops, seen from an orbit in pictures of this height.
    pub fn blob(height: u32) -> Self {
        Self::of("blob:5000", height)
    }

    /// A built-in shape, likewise.
    pub fn of(shape: &str, height: u32) -> Self {
        let mesh = Arc::new(PreparedMesh::new(shapes::by_name(shape).unwrap()));
        let orbit = Orbit { step_rad: 0.01, ..Orbit::turn(Framing::Perspective { fov_y_rad: 0.8 }, [height; 2], 1) };
        let bounds = mesh.mesh().bounds().unwrap();
        let cameras = Motion::Orbit.cameras(&orbit, &bounds, FRAMES).unwrap();
        Self {
            sequence: true_sequence(&mesh, &bounds, Motion::Orbit, &cameras, &NoProgress).unwrap(),
            topology: Topology::new(mesh.mesh()),
            rest: mesh.mesh().positions().to_vec(),
        }
    }

    pub fn measure(&self, draw: Draw) -> CoherenceMetrics {
        let observe = |(at, frame): (usize, &TrueFrame)| observe(frame, &DrawnFrame::Picture(draw(frame, at)));
        let observations: Vec<_> = self.sequence.frames.par_iter().enumerate().map(observe).collect();
        measure(&self.sequence, &observations, PictureKind::Lines)
    }
}

/// A pen of 4 reference pixels, moved and restricted to some loops.
fn drawn(frame: &TrueFrame, shift: impl Fn(DVec2) -> DVec2, is_drawn: impl Fn(u32) -> bool) -> Ink {
    let loops: HashMap<_, _> = frame.places.iter().map(|place| (place.edge, place.loop_id)).collect();
    // A line may begin with edges so short that no place is on them.
    let loop_of = |line: &VisibleLine| line.edges.iter().find_map(|edge| loops.get(edge)).copied().unwrap_or(0);
    let height = frame.camera.size()[1];
    let scale = super::reference_scale(height);
    let moved = |line: &VisibleLine| VisibleLine {
        points: line.points.iter().map(|&point| point + shift(point * scale) / scale).collect(),
        ..line.clone()
    };
    let lines: Vec<VisibleLine> = frame.visible.iter().filter(|line| is_drawn(loop_of(line))).map(moved).collect();
    pen::draw(&lines, Pen { width_px: 4.0 / scale, placement: PenPlacement::Centred }, frame.camera.size())
}

/// A number from 0 to 7 that looks random. Loops keep no number from frame to frame, so that the frame is part of it.
fn hash(loop_id: u32, frame: usize) -> u32 {
    let mixed =
        (loop_id.wrapping_mul(0x9E37_79B1) ^ (frame as u32).wrapping_mul(0x85EB_CA77)).wrapping_mul(0xC2B2_AE3D);
    (mixed ^ (mixed >> 15)) >> 8 & 7
}

pub fn exact(frame: &TrueFrame, _at: usize) -> Ink {
    drawn(frame, |_| DVec2::ZERO, |_| true)
}

/// A quarter of the loops left out, others in each frame.
pub fn dropping(frame: &TrueFrame, at: usize) -> Ink {
    drawn(frame, |_| DVec2::ZERO, |loop_id| hash(loop_id, at) >= 2)
}

/// All loops in one frame of six, none in the others.
pub fn flashing(frame: &TrueFrame, at: usize) -> Ink {
    drawn(frame, |_| DVec2::ZERO, |_| at % 6 == 3)
}

pub fn never_drawn(frame: &TrueFrame, _at: usize) -> Ink {
    drawn(frame, |_| DVec2::ZERO, |_| false)
}

/// Every other frame a pixel of a 512 px high picture to the right.
pub fn jittering(frame: &TrueFrame, at: usize) -> Ink {
    drawn(frame, |_| DVec2::new(if at.is_multiple_of(2) { 0.0 } else { 1000.0 / 512.0 }, 0.0), |_| true)
}

/// A short stretch of the right-hand outline, in one frame, four reference pixels to the right.
pub fn jumping(frame: &TrueFrame, at: usize) -> Ink {
    let is_there = |point: DVec2| at == 6 && point.x > 500.0 && (480.0..540.0).contains(&point.y);
    drawn(frame, |point| DVec2::new(if is_there(point) { 4.0 } else { 0.0 }, 0.0), |_| true)
}

/// Always the same way off.
pub fn lagging(frame: &TrueFrame, _at: usize) -> Ink {
    drawn(frame, |_| DVec2::new(2.5, -1.0), |_| true)
}

/// As if drawn on a cloth that a wave runs through.
pub fn swimming(frame: &TrueFrame, at: usize) -> Ink {
    drawn(frame, |point| DVec2::splat(2.0 * (point.x / 60.0 - 2.0 * at as f64).sin()), |_| true)
}
