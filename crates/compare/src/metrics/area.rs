//! How much area is covered by one of two pictures, but not by both.

use super::ink::Ink;

/// XOR area over true area, from 0 to the picture's area over the true area: the sum over all pixels of the difference
/// between drawn and true coverage, over the sum of the true coverage. 0 where both are empty, 1 where only the truth is.
///
/// Within one pixel the two are compared by how much they cover, not by where: coverage knows no more. O(pixels).
///
/// # Panics
/// If the pictures differ in size.
pub fn xor_share(drawn: &Ink, truth: &Ink) -> f64 {
    assert_eq!((drawn.width(), drawn.height()), (truth.width(), truth.height()), "pictures of one view");
    let pairs = drawn.coverages().iter().zip(truth.coverages());
    let xor: f64 = pairs.map(|(drawn, truth)| f64::from((drawn - truth).abs())).sum();
    let area: f64 = truth.coverages().iter().map(|&coverage| f64::from(coverage)).sum();
    match (xor > 0.0, area > 0.0) {
        (false, _) => 0.0,
        (true, true) => xor / area,
        (true, false) => 1.0,
    }
}

#[cfg(test)]
mod tests {
    use super::super::sample_fill::{SIZE, disc, square};
    use super::*;
    use glam::DVec2;
    use std::f64::consts::PI;

    #[test]
    fn a_square_moved_by_d_leaves_a_strip_of_d_on_both_sides() {
        let at = |x: f64| square(DVec2::new(x, 30.0), 20.0);
        for shift in [0.5, 1.0, 3.25] {
            let share = xor_share(&at(30.0 + shift), &at(30.0));
            assert!((share - 2.0 * shift / 20.0).abs() < 1e-6, "{shift}: {share}");
        }
    }

    #[test]
    fn a_disc_moved_by_d_leaves_two_lunes() {
        let radius = 20.0;
        let at = |x: f64| disc(DVec2::new(x, 32.0), radius);
        for shift in [2.0, 5.0] {
            let half = shift / (2.0 * radius);
            let common =
                2.0 * radius * radius * half.acos() - 0.5 * shift * (4.0 * radius * radius - shift * shift).sqrt();
            let expected = 2.0 * (PI * radius * radius - common) / (PI * radius * radius);
            let share = xor_share(&at(30.0 + shift), &at(30.0));
            assert!((share - expected).abs() < 2e-3, "{shift}: {share} instead of {expected}");
        }
    }

    #[test]
    fn shrinking_and_growing_raise_the_share() {
        let at = |radius: f64| disc(DVec2::splat(32.0), radius);
        for radius in [19.0, 21.0] {
            let expected = (radius * radius - 400.0_f64).abs() / 400.0;
            assert!((xor_share(&at(radius), &at(20.0)) - expected).abs() < 1e-3, "{radius}");
        }
    }

    #[test]
    fn empty_pictures_have_shares_at_the_ends() {
        let (disc, blank) = (disc(DVec2::splat(32.0), 20.0), Ink::blank(SIZE, SIZE));
        let shares = [(&blank, &disc), (&disc, &blank), (&blank, &blank)].map(|(one, other)| xor_share(one, other));
        assert!((shares[0] - 1.0).abs() < 1e-9 && shares[1].to_bits() == 1.0_f64.to_bits() && shares[2] == 0.0);
    }
}
