//! Smooth curves: cut into straight strokes to be decided, drawn as what they are.

use crate::chains::SegmentSource;
use crate::curve_part::CurvePart;
use crate::frame::PictureFrame;
use crate::scene::{CurvePiece, LineScene};
use crate::stroke::{Stroke, Strokes};
use silhouette_core::glam::{DVec2, DVec3, Vec3};
use std::collections::HashMap;
use std::sync::OnceLock;

/// Largest distance in the picture between a curve and the chords that stand for it when it is decided what hides it.
const CHORD_ERROR_PX: f64 = 0.05;

/// Most chords for one piece of a curve.
const MAX_CHORDS: f64 = 256.0;

/// A point of a cubic Bezier curve.
pub fn point(control: [Vec3; 4], at: f64) -> DVec3 {
    let [a, b, c, d] = control.map(Vec3::as_dvec3);
    let (ab, bc, cd) = (a.lerp(b, at), b.lerp(c, at), c.lerp(d, at));
    ab.lerp(bc, at).lerp(bc.lerp(cd, at), at)
}

/// The derivative of a cubic Bezier curve by its parameter.
fn derivative(control: [Vec3; 4], at: f64) -> DVec3 {
    let [a, b, c, d] = control.map(Vec3::as_dvec3);
    let (ab, bc, cd) = (b - a, c - b, d - c);
    ab.lerp(bc, at).lerp(bc.lerp(cd, at), at) * 3.0
}

/// Bezier handles in the picture of the part of a curve between two parameters: those of the cubic with the same ends and
/// the same derivatives there. Exact for an orthographic view; for a perspective off by the fourth power of the part's length.
pub fn handles(curve: &CurvePiece, range: [f64; 2], frame: &PictureFrame) -> [DVec2; 2] {
    let step = range[1] - range[0];
    let velocity = |at: f64| frame.pixel_velocity(point(curve.control, at), derivative(curve.control, at));
    let ends = range.map(|at| frame.map(point(curve.control, at)).pixel());
    [ends[0] + velocity(range[0]) * (step / 3.0), ends[1] - velocity(range[1]) * (step / 3.0)]
}

/// Appends strokes along all curves of a scene. Ends are numbered from `first_id` on, so that strokes that continue each
/// other can be joined: by place where two pieces of curve meet.
pub fn push_strokes(scene: &LineScene, frame: &PictureFrame, first_id: u32, strokes: &mut Strokes) {
    let mut ids = Ids { next: first_id, at: HashMap::new() };
    for (index, curve) in scene.curves().iter().enumerate() {
        let chords = chord_count(curve, frame);
        let mut from = (curve.control[0], ids.of(curve.control[0]));
        for chord in 0..chords {
            let range = [chord, chord + 1].map(|step| f64::from(step) / f64::from(chords));
            let to = if chord + 1 == chords {
                (curve.control[3], ids.of(curve.control[3]))
            } else {
                (point(curve.control, range[1]).as_vec3(), ids.unique())
            };
            if from.0 != to.0 {
                let piece = index as u32;
                let stroke = Stroke {
                    ends: [from.0, to.0],
                    vertices: [from.1, to.1],
                    source: SegmentSource::Curve(piece),
                    kind: curve.kind,
                    object: curve.object,
                    own: 0..0,
                    surface: OnceLock::new(),
                };
                strokes.push_curve(stroke, curve.on_faces.iter().copied(), CurvePart { piece, range });
            }
            from = to;
        }
    }
}

/// Chords that keep within [`CHORD_ERROR_PX`]: a chord of a cubic whose second differences are at most d strays by d / 8 times
/// 6 over the square of their number.
fn chord_count(curve: &CurvePiece, frame: &PictureFrame) -> u32 {
    let [a, b, c, d] = curve.control.map(|p| frame.map(p.as_dvec3()).pixel());
    let bend = (a - 2.0 * b + c).length().max((b - 2.0 * c + d).length());
    let count = (bend * 6.0 / (8.0 * CHORD_ERROR_PX)).sqrt().ceil();
    // What passes behind the eye has no bend in pixels.
    if count.is_finite() { count.clamp(1.0, MAX_CHORDS) as u32 } else { MAX_CHORDS as u32 }
}

struct Ids {
    next: u32,
    at: HashMap<[u32; 3], u32>,
}

impl Ids {
    fn unique(&mut self) -> u32 {
        self.next += 1;
        self.next - 1
    }

    fn of(&mut self, place: Vec3) -> u32 {
        let next = self.next;
        // Adding 0 makes both zeros one.
        let id = *self.at.entry((place + Vec3::ZERO).to_array().map(f32::to_bits)).or_insert(next);
        self.next = self.next.max(id + 1);
        id
    }
}
