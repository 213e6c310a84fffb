//! The bumpy blob: a closed mesh of any size.

use super::builtin::{ArgumentSpec, Builtin, MAX_FACES, ShapeError};
use super::{around_y, finish, turn};
use crate::mesh::TriangleMesh;
use glam::DVec3;
use rayon::prelude::*;

/// A sphere of radius 1 with smooth bumps, star-shaped about the origin: rays from there meet it once, so it never cuts
/// through itself. Concave enough to hide parts of itself and to have several contour generators in most views.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Blob {
    /// Largest deviation of the radius from 1, 0 (a sphere) to 0.6. Default: 0.3.
    pub relief: f64,
}

pub(super) static BLOB: Builtin = Builtin {
    name: "blob",
    summary: "A closed bumpy body of any number of faces: the scene for measuring how cost grows.",
    arguments: &[
        ArgumentSpec::count("faces", "number of faces; an odd number is rounded up", [6, MAX_FACES as u32], 20_000),
        ArgumentSpec::number("relief", "height of the bumps over the radius", [0.0, 0.6], 0.3),
    ],
    genus: Some(0),
    build: |values| Blob { relief: values[1] }.mesh(values[0] as u32),
    contour: None,
};

impl Default for Blob {
    fn default() -> Self {
        Self { relief: 0.3 }
    }
}

/// The bumps: waves `weight * sin(direction . wave + phase)`. The weights add up to 1; no two waves are parallel, so the
/// blob has no symmetry.
const WAVES: [(f64, DVec3, f64); 6] = [
    (0.30, DVec3::new(2.9, 1.1, -1.7), 0.3),
    (0.22, DVec3::new(-1.3, 3.7, 2.2), 1.9),
    (0.18, DVec3::new(3.1, -4.1, 3.3), 4.1),
    (0.14, DVec3::new(-6.3, -2.1, 4.7), 0.9),
    (0.10, DVec3::new(5.2, 7.9, 3.6), 2.6),
    (0.06, DVec3::new(-8.8, 6.4, -9.7), 5.3),
];

impl Blob {
    /// The blob with exactly `faces` faces, 6 to [`MAX_FACES`]. A closed triangle mesh has an even number of them, so an
    /// odd number is rounded up: every achievable number is achieved.
    ///
    /// Vertices lie on circles of latitude, evenly spread over the sphere, from the lower pole (vertex 0) to the upper
    /// (the last one); between two circles of m and n vertices lie m + n faces, nearly equilateral before the bumps.
    ///
    /// # Errors
    /// [`ShapeError`] where an argument is out of range.
    pub fn mesh(&self, faces: u32) -> Result<TriangleMesh, ShapeError> {
        BLOB.check(&[f64::from(faces), self.relief], u64::from(faces))?;
        let rings = Rings::new(faces.div_ceil(2));
        let place = |direction: DVec3| (direction * self.radius(direction)).as_vec3();
        let (place, rings) = (&place, &rings);
        let between: Vec<_> = (0..rings.count())
            .into_par_iter()
            .flat_map_iter(|ring| (0..rings.size(ring)).map(move |i| place(rings.direction(ring, i))))
            .collect();
        let positions = std::iter::once(place(DVec3::NEG_Y)).chain(between).chain([place(DVec3::Y)]).collect();
        let triangles = (0..=rings.count()).into_par_iter().flat_map_iter(|band| rings.band(band)).collect();
        Ok(finish(positions, triangles))
    }

    /// Distance of the surface from the origin in a unit direction.
    fn radius(&self, direction: DVec3) -> f64 {
        let bumps: f64 = WAVES.iter().map(|&(weight, wave, phase)| weight * (direction.dot(wave) + phase).sin()).sum();
        1.0 + self.relief * bumps
    }
}

/// Circles of latitude with their own number of vertices each.
struct Rings {
    /// `first[k]` is the first vertex of ring k; the last entry is the upper pole.
    first: Vec<u32>,
}

impl Rings {
    /// Spreads `vertices` (at least 3) over rings of at least three.
    fn new(vertices: u32) -> Self {
        // For equilateral faces, K rings pi / (K + 1) apart need sqrt(3) (K + 1) sin(polar angle) vertices each, in all
        // 2 sqrt(3) / pi (K + 1)^2; solve for K.
        let per_gap = 3.0_f64.sqrt();
        let gaps = (f64::from(vertices) * std::f64::consts::PI / (2.0 * per_gap)).sqrt().round().max(2.0);
        let rings = gaps as u32 - 1;
        let weight = |ring: u32| (per_gap * gaps * turn(ring + 1, 2 * (rings + 1)).sin() - 3.0).max(0.0);
        let total: f64 = (0..rings).map(weight).sum();
        // Three vertices for each ring, the rest by weight. Rounding the running sum instead of each share makes the
        // sizes add up exactly.
        let rest = f64::from(vertices - 3 * rings);
        let mut sum = 0.0;
        let mut first = vec![1];
        first.extend((0..rings).map(|ring| {
            sum += weight(ring);
            let given = if ring + 1 == rings { rest } else { (rest * sum / total).round() };
            1 + 3 * (ring + 1) + given as u32
        }));
        Self { first }
    }

    fn count(&self) -> u32 {
        self.first.len() as u32 - 1
    }

    fn size(&self, ring: u32) -> u32 {
        self.first[ring as usize + 1] - self.first[ring as usize]
    }

    fn direction(&self, ring: u32, i: u32) -> DVec3 {
        let (sin, cos) = turn(ring + 1, 2 * (self.count() + 1)).sin_cos();
        around_y(turn(i, self.size(ring))) * sin + DVec3::NEG_Y * cos
    }

    /// Faces between ring `band - 1` and ring `band`, where the poles count as rings of one vertex.
    fn band(&self, band: u32) -> impl Iterator<Item = [u32; 3]> + use<> {
        let lower = band.checked_sub(1).map(|ring| (self.first[ring as usize], self.size(ring)));
        let upper = (band < self.count()).then(|| (self.first[band as usize], self.size(band)));
        let pole = if band == 0 { 0 } else { self.first[self.first.len() - 1] };
        let (lower_steps, upper_steps) = (lower.map_or(0, |ring| ring.1), upper.map_or(0, |ring| ring.1));
        let vertex = move |ring: Option<(u32, u32)>, i: u32| ring.map_or(pole, |(first, size)| first + i % size);
        let (mut i, mut j) = (0, 0);
        std::iter::from_fn(move || {
            if i == lower_steps && j == upper_steps {
                return None;
            }
            // Advance on the ring whose next edge has its middle first: compares (2i + 1) / m with (2j + 1) / n.
            let lower_middle = u64::from(2 * i + 1) * u64::from(upper_steps);
            let upper_middle = u64::from(2 * j + 1) * u64::from(lower_steps);
            let along_lower = j == upper_steps || (i < lower_steps && lower_middle <= upper_middle);
            let [a, b] = [vertex(lower, i), vertex(upper, j)];
            Some(if along_lower {
                i += 1;
                [a, vertex(lower, i), b]
            } else {
                j += 1;
                [a, vertex(upper, j), b]
            })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_even_number_of_faces_is_met_exactly() {
        for faces in (6..400).chain([1000, 4999, 123_456, 1_000_001]) {
            let mesh = Blob::default().mesh(faces).unwrap();
            assert_eq!(mesh.face_count() as u32, faces.next_multiple_of(2));
            assert_eq!(mesh.vertex_count(), mesh.face_count() / 2 + 2);
        }
    }

    #[test]
    fn faces_tile_the_sphere_of_directions_once() {
        for faces in (6..200).step_by(2).chain([2000, 54_321]) {
            let mesh = Blob { relief: 0.6 }.mesh(faces).unwrap();
            let mut covered = 0.0;
            for triangle in mesh.triangles() {
                let [a, b, c] = triangle.map(|v| mesh.positions()[v as usize].as_dvec3().normalize());
                let volume = a.dot(b.cross(c));
                assert!(volume > 0.0, "{faces}: {triangle:?}");
                // Van Oosterom and Strackee's solid angle.
                covered += 2.0 * volume.atan2(1.0 + a.dot(b) + b.dot(c) + c.dot(a));
            }
            assert!((covered - 4.0 * std::f64::consts::PI).abs() < 1e-6, "{faces}: {covered}");
        }
    }

    #[test]
    fn relief_bounds_the_radius_and_is_used() {
        let mesh = Blob { relief: 0.5 }.mesh(20_000).unwrap();
        let radii = mesh.positions().iter().map(|p| p.length());
        let (low, high) = radii.fold((f32::MAX, 0.0_f32), |(low, high), r| (low.min(r), high.max(r)));
        assert!((0.5..0.75).contains(&low) && (1.25..=1.5).contains(&high), "{low} {high}");
    }
}
