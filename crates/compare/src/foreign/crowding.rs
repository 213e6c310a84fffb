//! [`check`]: whether a drawing can be inked in seconds.
//!
//! Ink that overlaps counts once, so what a pen covers is [united](crate::truth::pen) before it is measured. That takes time and
//! memory with every place where lines cross. A drawing has some hundreds of those; a wireframe of a dense mesh, or a file that means
//! no harm but holds noise, has millions. How many there are is estimated: straight lines in all directions whose length is L cross
//! each other L² / (π A) times in an area A, which is summed over tiles of the picture.

use super::error::ForeignFault;
use super::trace::{Frame, Polyline};
use crate::truth::pen::arc_chords;
use glam::DVec2;
use std::f64::consts::{PI, TAU};

/// Most crossings of a drawing by the estimate: some ten seconds of work and a hundred MiB in a picture of 1024 x 1024.
pub const MAX_CROSSINGS: f64 = 1e5;

/// Most corners of what a pen covers before it is united.
pub const MAX_CORNERS: f64 = 8e6;

/// Side of a tile in pixels.
const TILE_PX: f64 = 64.0;

/// Lengths are added to tiles in steps of at most this many pixels.
const STEP_PX: f64 = 16.0;

/// Refuses a drawing that is too crowded. O(points + length of lines).
///
/// # Errors
/// [`ForeignFault::TooCrowded`].
pub fn check(lines: &[Polyline], frame: Frame) -> Result<(), ForeignFault> {
    let columns = (f64::from(frame.size[0]) / TILE_PX).ceil();
    let rows = (f64::from(frame.size[1]) / TILE_PX).ceil();
    let mut tiles = vec![0.0_f64; (columns * rows) as usize];
    let (mut crossings, mut corners) = (0.0, 0.0);
    for line in lines {
        let mut last: Option<DVec2> = None;
        let closing = if line.closed { line.points.first() } else { None };
        let ends = line.points.iter().zip(line.points.iter().skip(1).chain(closing));
        for (&from, &to) in ends {
            let Some(direction) = (to - from).try_normalize() else { continue };
            // A line without neighbours has half a disc at each end.
            let turn = last.map_or(TAU, |last| last.angle_to(direction).abs());
            last = Some(direction);
            corners += 6.0 + arc_chords(turn, frame.pen_width_px * 0.5);
            let length = from.distance(to);
            let steps = (length / STEP_PX).ceil();
            for step in 0..steps as u32 {
                let place = from.lerp(to, (f64::from(step) + 0.5) / steps) / TILE_PX;
                let [column, row] = [place.x.clamp(0.0, columns - 1.0), place.y.clamp(0.0, rows - 1.0)];
                let tile = &mut tiles[row as usize * columns as usize + column as usize];
                let before = *tile;
                *tile += length / steps;
                crossings += (tile.powi(2) - before.powi(2)) / (PI * TILE_PX * TILE_PX);
            }
            if crossings > MAX_CROSSINGS || corners > MAX_CORNERS {
                return Err(ForeignFault::TooCrowded);
            }
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_testing::random::Random;

    const FRAME: Frame = Frame { size: [512, 512], pen_width_px: 2.0 };

    fn scattered(count: usize, random: &mut Random) -> Vec<Polyline> {
        let mut point = || DVec2::new(random.unit(), random.unit()) * 512.0;
        (0..count).map(|_| Polyline { points: vec![point(), point()], closed: false }).collect()
    }

    fn crosses(one: &Polyline, other: &Polyline) -> bool {
        let side =
            |line: &Polyline, point: DVec2| (line.points[1] - line.points[0]).perp_dot(point - line.points[0]) > 0.0;
        let parts = |line: &Polyline, other: &Polyline| side(line, other.points[0]) != side(line, other.points[1]);
        parts(one, other) && parts(other, one)
    }

    /// The estimate against a count of all crossings: as many lines as should just do, and twice as many.
    #[test]
    fn as_many_crossings_as_the_limit_says_are_let_through() {
        let mut random = Random::new(3);
        let few = scattered(60, &mut random);
        let counted = (0..60).flat_map(|at| (0..at).map(move |other| (at, other)));
        let counted = counted.filter(|&(at, other)| crosses(&few[at], &few[other])).count() as f64;
        // Pairs grow with the square of the number of lines.
        let limit = 60.0 * (MAX_CROSSINGS / counted).sqrt();
        let outcome = |count: f64, random: &mut Random| check(&scattered(count as usize, random), FRAME).is_ok();
        assert!(outcome(limit * 0.6, &mut random) && !outcome(limit * 1.6, &mut random), "{counted} {limit}");
    }

    #[test]
    fn the_same_line_again_and_again_is_crowded() {
        let line = Polyline { points: vec![DVec2::splat(10.0), DVec2::splat(500.0)], closed: false };
        assert!(check(&vec![line.clone(); 10], FRAME).is_ok() && check(&vec![line; 2000], FRAME).is_err());
        let dots = |at: u32| DVec2::new(f64::from(at % 2) * 1e-3, f64::from(at / 2 % 2) * 1e-3) + 100.0;
        let scribble = Polyline { points: (0..1_000_000).map(dots).collect(), closed: false };
        assert!(check(&[scribble], FRAME).is_err(), "round corners");
    }
}
