//! The machine room: pipes, flanges, valves, tanks and ladders, hundreds of closed objects that hide each other.

use super::builtin::{ArgumentSpec, Builtin, ShapeError};
use super::lattice::Lattice;
use super::revolution::revolve;
use super::{around_y, finish, turn};
use crate::mesh::TriangleMesh;
use glam::{DVec2, DVec3, Vec3};

/// A plant of separate closed objects: racks of bent pipes with flanges and valves over tanks with ladders. It stands in
/// for the auxiliary machine room of Raskar and Cohen 1999, of 252 thousand triangles, which cannot be had. No two objects
/// meet.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MachineRoom {
    /// Faces around a pipe, 6 to 128. Default: 24.
    pub around: u32,
}

pub(super) static MACHINE_ROOM: Builtin = Builtin {
    name: "machine-room",
    summary: "Pipes, flanges, valves, tanks and ladders in many closed objects, about 252 thousand faces: hides itself a \
              hundredfold.",
    arguments: &[ArgumentSpec::count("around", "faces around a pipe", [6, 128], 24)],
    genus: Some(0),
    build: |values| MachineRoom { around: values[0] as u32 }.mesh(),
    contour: None,
};

impl Default for MachineRoom {
    fn default() -> Self {
        Self { around: 24 }
    }
}

/// Racks over each other, every other one across, and pipes side by side in each.
const RACKS: u32 = 6;
const PIPES_PER_RACK: u32 = 8;
/// Faces along a pipe.
const ALONG: u32 = 46;
const PIPE_RADIUS: f64 = 0.028;
/// Half of a pipe's length, and height of the lowest rack.
const HALF_LENGTH: f64 = 0.95;
const LOWEST_RACK: f64 = 0.06;
const RACK_HEIGHT: f64 = 0.15;
const FLANGES_PER_PIPE: u32 = 6;
const VALVES_PER_PIPE: u32 = 2;
const TANKS: [u32; 2] = [4, 3];
const RUNGS: u32 = 14;

impl MachineRoom {
    /// The room, y up, floor at y = -0.9.
    ///
    /// # Errors
    /// [`ShapeError`] where an argument is out of range.
    pub fn mesh(&self) -> Result<TriangleMesh, ShapeError> {
        // An object takes a number of faces that grows as `around`; a room of 6 around has more than a quarter of one of 24.
        MACHINE_ROOM.check(&[f64::from(self.around)], 12_000 * u64::from(self.around))?;
        let mut room = Assembly { positions: Vec::new(), triangles: Vec::new(), around: self.around };
        for rack in 0..RACKS {
            for pipe in 0..PIPES_PER_RACK {
                room.pipe_with_fittings(&Pipe::new(rack, pipe));
            }
        }
        for column in 0..TANKS[0] {
            for row in 0..TANKS[1] {
                let at = |index: u32, count: u32| (f64::from(index) + 0.5) / f64::from(count) * 2.0 - 1.0;
                room.tank_with_ladder(DVec3::new(0.95 * at(column, TANKS[0]), -0.9, 0.95 * at(row, TANKS[1])));
            }
        }
        Ok(finish(room.positions, room.triangles))
    }
}

/// A number from 0 to 1 that only depends on its arguments.
fn chance(seed: u32, salt: u32) -> f64 {
    let mut word = seed.wrapping_mul(0x9e37_79b1) ^ salt.wrapping_mul(0x85eb_ca6b);
    for _ in 0..2 {
        word = (word ^ (word >> 15)).wrapping_mul(0x2c1b_3c6d);
    }
    f64::from(word >> 8) / f64::from(1_u32 << 24)
}

/// A pipe that runs level, and swerves within its own corridor.
#[derive(Debug, Clone, Copy)]
struct Pipe {
    seed: u32,
    middle: DVec3,
    ahead: DVec3,
    /// Where it swerves, as shares of its length, and how far to the side and up.
    swerves: [(f64, DVec3); 2],
}

impl Pipe {
    fn new(rack: u32, pipe: u32) -> Self {
        let seed = rack * PIPES_PER_RACK + pipe;
        let ahead = if rack.is_multiple_of(2) { DVec3::X } else { DVec3::Z };
        let side = ahead.cross(DVec3::Y);
        let place = (f64::from(pipe) + 0.5) / f64::from(PIPES_PER_RACK) * 2.0 - 1.0;
        let height = LOWEST_RACK + RACK_HEIGHT * f64::from(rack);
        let swerve = |salt| {
            let [to_side, up] = [salt, salt + 1].map(|salt| chance(seed, salt) - 0.5);
            (0.2 + 0.5 * chance(seed, salt + 2), side * (0.06 * to_side) + DVec3::Y * (0.03 * up))
        };
        Self { seed, middle: side * (place * HALF_LENGTH) + DVec3::Y * height, ahead, swerves: [swerve(1), swerve(4)] }
    }

    /// The centre line at a share of its length.
    fn center(&self, share: f64) -> DVec3 {
        let bent = self.swerves.iter().map(|(at, by)| {
            let step = ((share - at) / 0.06 + 0.5).clamp(0.0, 1.0);
            *by * (step * step * (3.0 - 2.0 * step))
        });
        self.middle + self.ahead * ((2.0 * share - 1.0) * HALF_LENGTH) + bent.sum::<DVec3>()
    }

    /// Maps a point beside the y axis, whose y is a share of the length, to one beside the centre line.
    fn along(&self, p: DVec3) -> DVec3 {
        let step = 1e-4;
        let tangent = (self.center(p.y + step) - self.center(p.y - step)).normalize();
        let first = DVec3::Y.cross(tangent).normalize();
        self.center(p.y) + first * p.x + first.cross(tangent) * p.z
    }

    /// Maps a point about the origin to one about the place at a share of the length, y along the pipe.
    fn at(&self, share: f64, p: DVec3) -> DVec3 {
        let beside = self.along(DVec3::new(p.x, share, p.z));
        let tangent = (self.center(share + 1e-4) - self.center(share - 1e-4)).normalize();
        beside + tangent * p.y
    }
}

/// What is there so far.
struct Assembly {
    positions: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
    around: u32,
}

impl Assembly {
    /// Adds an object, each vertex placed. Placing must keep the orientation of space.
    fn add(&mut self, object: &TriangleMesh, place: impl Fn(DVec3) -> DVec3) {
        let first = self.positions.len() as u32;
        self.positions.extend(object.positions().iter().map(|p| place(p.as_dvec3()).as_vec3()));
        self.triangles.extend(object.triangles().iter().map(|triangle| triangle.map(|vertex| first + vertex)));
    }

    /// A ring about the y axis with a square profile.
    fn ring(&self, [inner, outer]: [f64; 2], height: f64) -> TriangleMesh {
        let corners = [(inner, -0.5), (outer, -0.5), (outer, 0.5), (inner, 0.5)];
        Lattice::closed(self.around, 4).mesh(|column, row| {
            let (radius, y) = corners[row as usize];
            around_y(turn(column, self.around)) * radius + DVec3::Y * (y * height)
        })
    }

    /// A bar along y from the origin up.
    fn bar(&self, radius: f64, length: f64) -> TriangleMesh {
        let ends = [0.0, length];
        revolve(ends, &ends.map(|y| DVec2::new(radius, y)), (self.around / 2).max(4))
    }

    fn pipe_with_fittings(&mut self, pipe: &Pipe) {
        let rings: Vec<DVec2> =
            (0..=ALONG).map(|ring| DVec2::new(PIPE_RADIUS, f64::from(ring) / f64::from(ALONG))).collect();
        self.add(&revolve([0.0, 1.0], &rings, self.around), |p| pipe.along(p));

        let flange = self.ring([1.02 * PIPE_RADIUS, 1.45 * PIPE_RADIUS], 0.012);
        for flange_index in 0..FLANGES_PER_PIPE {
            let share = (f64::from(flange_index) + 0.2 + 0.3 * chance(pipe.seed, 10 + flange_index)) / 6.0;
            self.add(&flange, |p| pipe.at(share, p));
        }
        for valve in 0..VALVES_PER_PIPE {
            let share = (f64::from(valve) + 0.85 + 0.05 * chance(pipe.seed, 20 + valve)) / 2.0;
            self.valve(&|p| pipe.at(share - 0.02, p));
        }
    }

    /// A collar around a pipe, a stem above it, and a wheel around the stem's top.
    fn valve(&mut self, place: &dyn Fn(DVec3) -> DVec3) {
        let collar = self.ring([1.02 * PIPE_RADIUS, 1.35 * PIPE_RADIUS], 0.03);
        self.add(&collar, place);
        // In the pipe's frame up is -z: the stem and the wheel are turned there, y to -z and z to y.
        let upright = |p: DVec3| place(DVec3::new(p.x, p.z, -p.y));
        let (base, height) = (1.4 * PIPE_RADIUS, 0.025);
        self.add(&self.bar(0.006, height), |p| upright(p + DVec3::Y * base));
        let around = self.around;
        let across = (around / 3).max(4);
        let wheel = Lattice::closed(around, across).mesh(|column, row| {
            let (sin, cos) = (-turn(row, across)).sin_cos();
            around_y(turn(column, around)) * (0.022 + 0.004 * cos) + DVec3::Y * (0.004 * -sin)
        });
        self.add(&wheel, |p| upright(p + DVec3::Y * (base + height)));
    }

    /// A standing tank with round ends on a floor point, and a ladder beside it.
    fn tank_with_ladder(&mut self, foot: DVec3) {
        let (radius, end, height) = (0.16, 0.07, 0.72);
        let steps = (self.around / 3).max(3);
        let round = |step: u32| (f64::from(step) / f64::from(steps) * std::f64::consts::FRAC_PI_2).sin_cos();
        let lower = (1..=steps).map(|step| {
            let (sin, cos) = round(step);
            DVec2::new(radius * sin, end * (1.0 - cos))
        });
        let upper = (0..steps).map(|step| {
            let (sin, cos) = round(step);
            DVec2::new(radius * cos, height - end + end * sin)
        });
        let rings: Vec<DVec2> = lower.chain(upper).collect();
        let tank = revolve([0.0, height], &rings, 2 * self.around);
        self.add(&tank, |p| foot + p);

        let (half, rail) = (0.045, 0.005);
        let side = foot + DVec3::Z * (radius + 0.03);
        let rail_bar = self.bar(rail, height);
        for x in [-half, half] {
            self.add(&rail_bar, |p| side + DVec3::X * x + p);
        }
        let reach = half - 1.2 * rail;
        let rung = self.bar(0.7 * rail, 2.0 * reach);
        for index in 0..RUNGS {
            let at = side + DVec3::Y * (height * (f64::from(index) + 0.7) / f64::from(RUNGS + 1));
            self.add(&rung, |p| at + DVec3::new(p.y - reach, -p.x, p.z));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_default_is_as_large_as_the_papers_model() {
        let faces = MachineRoom::default().mesh().unwrap().face_count();
        assert!((faces as f64 / 252_000.0 - 1.0).abs() < 0.02, "{faces}");
    }

    #[test]
    fn objects_fill_a_room_of_about_one_unit() {
        let bounds = MachineRoom { around: 6 }.mesh().unwrap().bounds().unwrap();
        assert!(bounds.min.cmpge(DVec3::splat(-1.01)).all() && bounds.max.cmple(DVec3::splat(1.01)).all());
        assert!(MachineRoom { around: 5 }.mesh().is_err());
    }
}
