//! How far drawn and true ink lie apart, as sets of pixels.

use super::distance_transform::distance_transform;
use super::ink::Ink;

/// Share of the distances that [`Separation::hausdorff_95_px`] is not exceeded by: the farthest 5 % are excluded, so that a
/// single stray pixel does not decide.
pub const HAUSDORFF_SHARE: f64 = 0.95;

/// Distances between drawn ink pixels and the pixels of the true pen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Separation {
    /// Symmetric Chamfer distance in pixels: mean of the two directed means.
    pub chamfer_px: f64,
    /// 95 % Hausdorff distance in pixels: the larger of the two directed 95th percentiles (nearest rank).
    pub hausdorff_95_px: f64,
}

/// Measures both distances. The picture's diagonal where exactly one of the two has no ink, 0 where neither has.
/// O(pixels + ink log ink).
///
/// # Panics
/// If the pictures differ in size.
pub fn separation(ink: &Ink, true_pen: &Ink) -> Separation {
    assert_eq!((ink.width(), ink.height()), (true_pen.width(), true_pen.height()), "pictures of one view");
    let (drawn, truth) = (ink.mask(), true_pen.mask());
    let width = ink.width() as usize;
    let diagonal = ink.diagonal_px();
    match (drawn.contains(&true), truth.contains(&true)) {
        (false, false) => Separation { chamfer_px: 0.0, hausdorff_95_px: 0.0 },
        (true, true) => {
            let to_truth = directed(&drawn, &distance_transform(&truth, width));
            let to_ink = directed(&truth, &distance_transform(&drawn, width));
            Separation {
                chamfer_px: 0.5 * (to_truth.mean + to_ink.mean),
                hausdorff_95_px: to_truth.percentile.max(to_ink.percentile),
            }
        }
        _ => Separation { chamfer_px: diagonal, hausdorff_95_px: diagonal },
    }
}

struct Directed {
    mean: f64,
    percentile: f64,
}

/// Mean and percentile of `distances` over the pixels of a mask that is not empty.
fn directed(from: &[bool], distances: &[f64]) -> Directed {
    let mut found: Vec<f64> =
        from.iter().zip(distances).filter(|(set, _)| **set).map(|(_, &distance)| distance).collect();
    let mean = found.iter().sum::<f64>() / found.len() as f64;
    let rank = ((found.len() as f64 * HAUSDORFF_SHARE).ceil() as usize).clamp(1, found.len()) - 1;
    let (_, percentile, _) = found.select_nth_unstable_by(rank, f64::total_cmp);
    Directed { mean, percentile: *percentile }
}

#[cfg(test)]
mod tests {
    use super::super::sample_lines;
    use super::*;

    #[test]
    fn shifting_raises_the_chamfer_distance() {
        let pen = sample_lines::crossing_lines().pen;
        let [same, two, four] = [0, 2, 4].map(|by| separation(&sample_lines::shift_right(&pen, by), &pen).chamfer_px);
        assert!(same.abs() < 1e-12 && two > 0.1 && four > two, "{same} {two} {four}");
    }

    #[test]
    fn shifting_raises_the_hausdorff_distance() {
        let pen = sample_lines::crossing_lines().pen;
        let [same, two, four] =
            [0, 2, 4].map(|by| separation(&sample_lines::shift_right(&pen, by), &pen).hausdorff_95_px);
        assert!(same.abs() < 1e-12 && two >= 1.0 && four > two, "{same} {two} {four}");
    }

    #[test]
    fn erasing_and_specks_raise_both_directions() {
        let pen = sample_lines::crossing_lines().pen;
        for worse in [sample_lines::erase_stretch(&pen), sample_lines::add_specks(&pen)] {
            assert!(separation(&worse, &pen).chamfer_px > 0.05);
        }
    }

    #[test]
    fn one_stray_pixel_does_not_decide_the_hausdorff_distance() {
        let pen = sample_lines::crossing_lines().pen;
        let mut stray = pen.clone();
        stray.set(0, 0, 1.0);
        assert!(separation(&stray, &pen).hausdorff_95_px.abs() < 1e-12);
    }

    #[test]
    fn empty_pictures_are_a_diagonal_apart() {
        let pen = sample_lines::crossing_lines().pen;
        let blank = Ink::blank(pen.width(), pen.height());
        for (ink, truth) in [(&blank, &pen), (&pen, &blank)] {
            let apart = separation(ink, truth);
            assert!((apart.chamfer_px - pen.diagonal_px()).abs() < 1e-12, "{apart:?}");
            assert!((apart.hausdorff_95_px - pen.diagonal_px()).abs() < 1e-12, "{apart:?}");
        }
        assert!(separation(&blank, &blank).chamfer_px.abs() < 1e-12);
    }
}
