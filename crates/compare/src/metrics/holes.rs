//! Pixels left bare inside of a filled picture.

use super::ink::{INK_THRESHOLD, Ink};

/// Number of hole pixels, from 0 to the true area: bare pixels (covered by less than half) in spots that drawn pixels
/// enclose and that the truth covers altogether. O(pixels).
///
/// A spot is a set of bare pixels that touch along their sides. One that reaches the frame is outside, one that holds a
/// pixel where the truth is bare too is a hole of the object itself; neither counts.
///
/// # Panics
/// If the pictures differ in size.
pub fn hole_pixels(drawn: &Ink, truth: &Ink) -> usize {
    assert_eq!((drawn.width(), drawn.height()), (truth.width(), truth.height()), "pictures of one view");
    let [width, height] = [drawn.width(), drawn.height()].map(|side| side as usize);
    let mut waiting: Vec<bool> = drawn.mask().iter().map(|is_drawn| !is_drawn).collect();
    let mut spot: Vec<usize> = Vec::new();
    let mut holes = 0;
    for first in 0..waiting.len() {
        if !waiting[first] {
            continue;
        }
        waiting[first] = false;
        spot.clear();
        spot.push(first);
        let (mut is_hole, mut at) = (true, 0);
        while let Some(&pixel) = spot.get(at) {
            at += 1;
            let (x, y) = (pixel % width, pixel / width);
            is_hole &= truth.coverages()[pixel] >= INK_THRESHOLD;
            is_hole &= x > 0 && y > 0 && x + 1 < width && y + 1 < height;
            let beside = [
                (x > 0).then(|| pixel - 1),
                (x + 1 < width).then_some(pixel + 1),
                (y > 0).then(|| pixel - width),
                (y + 1 < height).then_some(pixel + width),
            ];
            for next in beside.into_iter().flatten().filter(|&next| waiting[next]).collect::<Vec<_>>() {
                waiting[next] = false;
                spot.push(next);
            }
        }
        holes += if is_hole { spot.len() } else { 0 };
    }
    holes
}

#[cfg(test)]
mod tests {
    use super::super::sample_fill::{SIZE, disc, square};
    use super::*;
    use glam::DVec2;

    #[test]
    fn pixels_punched_out_of_a_disc_are_counted() {
        let whole = disc(DVec2::splat(32.0), 20.0);
        assert_eq!(hole_pixels(&whole, &whole), 0);
        let punched = |x: u32, y: u32| x % 5 == 2 && y % 5 == 2 && (25..40).contains(&x) && (25..40).contains(&y);
        let holed =
            Ink::from_fn(SIZE, SIZE, |x, y| if punched(x, y) { 0.0 } else { whole.coverage(x.into(), y.into()) });
        assert_eq!(hole_pixels(&holed, &whole), 9);
    }

    #[test]
    fn a_crack_of_touching_pixels_is_a_hole_and_a_bay_is_none() {
        let whole = square(DVec2::splat(10.0), 40.0);
        let without = |bare: &dyn Fn(u32, u32) -> bool| {
            Ink::from_fn(SIZE, SIZE, |x, y| if bare(x, y) { 0.0 } else { whole.coverage(x.into(), y.into()) })
        };
        assert_eq!(hole_pixels(&without(&|x, y| x == y && (20..30).contains(&x)), &whole), 10, "a diagonal crack");
        assert_eq!(hole_pixels(&without(&|x, y| y == 20 && x < 30), &whole), 0, "open to the outside");
    }

    #[test]
    fn a_true_hole_is_none_even_where_it_is_drawn_too_large() {
        let ring = |inner: f64| {
            let (disc, hole) = (disc(DVec2::splat(32.0), 25.0), disc(DVec2::splat(32.0), inner));
            Ink::from_fn(SIZE, SIZE, |x, y| disc.coverage(x.into(), y.into()) - hole.coverage(x.into(), y.into()))
        };
        assert_eq!(hole_pixels(&ring(10.0), &ring(8.0)), 0);
        let blank = Ink::blank(SIZE, SIZE);
        assert_eq!((hole_pixels(&blank, &ring(8.0)), hole_pixels(&ring(8.0), &blank)), (0, 0));
    }
}
