//! How much the colours of two pictures differ.

use super::filled_picture::FilledPicture;

/// Peak signal-to-noise ratio in dB over white paper, from 0 (black against white) up; all pixels and the three colours
/// count the same. Pictures that do not differ at all have the ratio of pictures in which one byte differs by one, so that
/// no value is infinite: about 107 dB at 512 x 512 pixels. O(pixels).
///
/// # Panics
/// If the pictures differ in size.
pub fn psnr_db(drawn: &FilledPicture, truth: &FilledPicture) -> f64 {
    let (drawn, truth) = (drawn.over_paper(), truth.over_paper());
    assert_eq!(drawn.len(), truth.len(), "pictures of one view");
    let squares = drawn.iter().zip(&truth).map(|(&one, &other)| u64::from(one.abs_diff(other)).pow(2));
    let sum = squares.sum::<u64>().max(1);
    10.0 * (255.0 * 255.0 * truth.len().max(1) as f64 / sum as f64).log10()
}

/// Mean FLIP error over white paper, 0 to 1, as for a monitor of 67 pixels per degree (FLIP's own default).
///
/// Paper: P. Andersson, J. Nilsson, T. Akenine-Möller, M. Oskarsson, K. Åström and M. Fairchild, "FLIP: A Difference
/// Evaluator for Alternating Images", Proceedings of the ACM on Computer Graphics and Interactive Techniques 3(2), 2020;
/// NVIDIA's code. `None` where this package is built without the feature `flip`. O(pixels).
///
/// # Panics
/// If the pictures differ in size.
pub fn flip(drawn: &FilledPicture, truth: &FilledPicture) -> Option<f64> {
    #[cfg(feature = "flip")]
    {
        let [width, height] = truth.size();
        assert_eq!(drawn.size(), truth.size(), "pictures of one view");
        let image = |picture: &FilledPicture| nv_flip::FlipImageRgb8::with_data(width, height, &picture.over_paper());
        let errors = nv_flip::flip(image(truth), image(drawn), nv_flip::DEFAULT_PIXELS_PER_DEGREE);
        Some(f64::from(nv_flip::FlipPool::from_image(&errors).mean()))
    }
    #[cfg(not(feature = "flip"))]
    {
        let _ = (drawn, truth);
        None
    }
}

#[cfg(test)]
mod tests {
    use super::super::sample_fill::{SIZE, disc, picture};
    use super::*;
    use glam::DVec2;
    use silhouette_render::Image;

    fn flat(rgba: [u8; 4]) -> FilledPicture {
        FilledPicture::new(Image { width: SIZE, height: SIZE, rgba: rgba.repeat((SIZE * SIZE) as usize) })
    }

    #[test]
    fn a_known_difference_has_its_ratio() {
        let ratio = |by: u8| psnr_db(&flat([100 + by, 100 + by, 100 + by, 255]), &flat([100, 100, 100, 255]));
        for by in [1, 10, 100] {
            assert!((ratio(by) - 20.0 * (255.0 / f64::from(by)).log10()).abs() < 1e-9, "{by}");
        }
        assert!(psnr_db(&flat([0, 0, 0, 255]), &flat([0; 4])).abs() < 1e-12, "black against paper");
        let same = psnr_db(&flat([9; 4]), &flat([9; 4]));
        assert!((same - 10.0 * (255.0_f64.powi(2) * 3.0 * f64::from(SIZE * SIZE)).log10()).abs() < 1e-9, "{same}");
    }

    #[test]
    fn moving_a_disc_lowers_the_ratio() {
        let at = |x: f64| picture(&disc(DVec2::new(x, 32.0), 20.0));
        let ratios = [0.0, 0.5, 2.0, 8.0].map(|shift| psnr_db(&at(32.0 + shift), &at(32.0)));
        assert!(ratios.windows(2).all(|pair| pair[0] > pair[1] + 1.0), "{ratios:?}");
    }

    #[cfg(feature = "flip")]
    #[test]
    fn moving_a_disc_raises_flip() {
        let at = |x: f64| picture(&disc(DVec2::new(x, 32.0), 20.0));
        let errors = [0.0, 0.5, 2.0, 8.0].map(|shift| flip(&at(32.0 + shift), &at(32.0)).unwrap());
        assert!(errors[0].abs() < 1e-6 && errors.windows(2).all(|pair| pair[0] < pair[1]), "{errors:?}");
        let worst = flip(&flat([0, 0, 0, 255]), &flat([0; 4])).unwrap();
        assert!(worst > 0.9 && worst <= 1.0, "black against paper: {worst}");
    }

    #[cfg(not(feature = "flip"))]
    #[test]
    fn without_its_feature_flip_is_not_measured() {
        assert_eq!(flip(&flat([9; 4]), &flat([0; 4])), None);
    }
}
