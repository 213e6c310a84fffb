//! [`check`]: whether a drawing can be inked in seconds.
//!
//! Ink that overlaps counts once, so what a pen covers is [united](crate::truth::pen) before it is measured. That takes time and
//! memory with every place where lines cross. A drawing has some hundreds of those; a wireframe of a dense mesh, or a file that means
//! no harm but holds noise, has millions. How many there are is estimated: straight lines in all directions whose length is L cross
//! each other L² / (π A) times in an area A, which is summed over tiles of the picture. Strokes that crowd a place much smaller than a tile
//! escape that; so the pairs of strokes that come to the same small cell are counted as well, whatever way they go on.

use super::error::ForeignFault;
use super::trace::{Frame, Polyline};
use crate::truth::pen::arc_chords;
use glam::DVec2;
use std::f64::consts::{PI, TAU};

/// Most crossings of a drawing by the estimate: some ten seconds of work and a hundred MiB in a picture of 1024 x 1024.
pub const MAX_CROSSINGS: f64 = 1e5;

/// Most corners of what a pen covers before it is united.
pub const MAX_CORNERS: f64 = 8e6;

/// Most pairs of strokes in the same cells of 8 pixels: about twice as many as the crossings of lines that are scattered evenly.
pub const MAX_PAIRS: f64 = 3e5;

/// Side of a cell in pixels: a few widths of a pen.
const CELL_PX: f64 = 8.0;

/// Side of a tile in pixels.
const TILE_PX: f64 = 64.0;

/// Lengths are added to tiles and strokes to cells in steps of at most this many pixels.
const STEP_PX: f64 = 4.0;

/// Refuses a drawing that is too crowded. O(points + length of lines).
///
/// # Errors
/// [`ForeignFault::TooCrowded`].
pub fn check(lines: &[Polyline], frame: Frame) -> Result<(), ForeignFault> {
    let columns = (f64::from(frame.size[0]) / TILE_PX).ceil();
    let rows = (f64::from(frame.size[1]) / TILE_PX).ceil();
    let mut tiles = vec![0.0_f64; (columns * rows) as usize];
    let mut cells = Cells::new(frame);
    let (mut crossings, mut corners) = (0.0, 0.0);
    for line in lines {
        cells.lift();
        let mut last: Option<DVec2> = None;
        let closing = if line.closed { line.points.first() } else { None };
        let ends = line.points.iter().zip(line.points.iter().skip(1).chain(closing));
        for (&from, &to) in ends {
            let Some(direction) = (to - from).try_normalize() else { continue };
            // A line without neighbours has half a disc at each end.
            let turn = last.map_or(TAU, |last| last.angle_to(direction).abs());
            last = Some(direction);
            if turn > PI * 0.5 {
                cells.lift();
            }
            corners += 6.0 + arc_chords(turn, frame.pen_width_px * 0.5);
            let length = from.distance(to);
            let steps = (length / STEP_PX).ceil();
            for step in 0..steps as u32 {
                let place = from.lerp(to, (f64::from(step) + 0.5) / steps);
                cells.visit(place);
                let place = place / TILE_PX;
                let [column, row] = [place.x.clamp(0.0, columns - 1.0), place.y.clamp(0.0, rows - 1.0)];
                let tile = &mut tiles[row as usize * columns as usize + column as usize];
                let before = *tile;
                *tile += length / steps;
                crossings += (tile.powi(2) - before.powi(2)) / (PI * TILE_PX * TILE_PX);
            }
            if crossings > MAX_CROSSINGS || corners > MAX_CORNERS || cells.pairs > MAX_PAIRS {
                return Err(ForeignFault::TooCrowded);
            }
        }
    }
    Ok(())
}

/// How many strokes come to each cell of the picture.
struct Cells {
    columns: f64,
    rows: f64,
    strokes: Vec<u32>,
    /// Pairs of strokes in the same cell.
    pairs: f64,
    /// The cell that the pen was in last, since it was lifted.
    last: Option<usize>,
}

impl Cells {
    fn new(frame: Frame) -> Self {
        let [columns, rows] = frame.size.map(|side| (f64::from(side) / CELL_PX).ceil());
        Self { columns, rows, strokes: vec![0; (columns * rows) as usize], pairs: 0.0, last: None }
    }

    /// What comes now is another stroke: another line, or one that turns back.
    fn lift(&mut self) {
        self.last = None;
    }

    fn visit(&mut self, place: DVec2) {
        let [column, row] = [(place.x, self.columns), (place.y, self.rows)]
            .map(|(place, count)| (place / CELL_PX).clamp(0.0, count - 1.0) as usize);
        let cell = row * self.columns as usize + column;
        if self.last != Some(cell) {
            self.pairs += f64::from(self.strokes[cell]);
            self.strokes[cell] += 1;
            self.last = Some(cell);
        }
    }
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

    /// Strokes that crowd one place are far fewer than a tile could hold if they lay apart.
    #[test]
    fn strokes_that_crowd_one_place_are_refused_and_a_long_drawing_is_not() {
        let ray = |at: u32, count: u32, length: f64| {
            let direction = DVec2::from_angle(f64::from(at) / f64::from(count) * TAU);
            vec![DVec2::splat(256.0), DVec2::splat(256.0) + direction * length]
        };
        let rays = |count: u32, length: f64| -> Vec<Polyline> {
            (0..count).map(|at| Polyline { points: ray(at, count, length), closed: false }).collect()
        };
        assert!(check(&rays(4000, 2.5), FRAME).is_err(), "separate strokes");
        let scribble = Polyline { points: (0..4000).flat_map(|at| ray(at, 4000, 2.5)).collect(), closed: false };
        assert!(check(&[scribble], FRAME).is_err(), "one line to and fro");
        assert!(check(&rays(200, 200.0), FRAME).is_ok(), "a star");
        // A spiral of chords of a tenth of a pixel comes to each cell a few times.
        let turn = |at: u32| DVec2::from_angle(f64::from(at) * 1e-3) * (f64::from(at) * 1e-3 * 2.0);
        let spiral = Polyline { points: (0..100_000).map(|at| turn(at) + 256.0).collect(), closed: false };
        assert!(check(&[spiral], FRAME).is_ok());
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
