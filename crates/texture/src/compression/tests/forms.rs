//! The ratio that errors are stated in, fewer azimuths, blocks, and the table of all.

use super::lobes::{SPHERE, sphere, texture, to_bytes};
use crate::VolumeSize;
use crate::compression::{
    CompressionError, Form, blocks, compare, fewer_azimuths, interpolate_azimuths, psnr_db, shares,
};
use proptest::prelude::*;
use silhouette_testing::Random;
use std::f32::consts::TAU;

#[test]
fn the_ratio_falls_with_noise_and_is_what_it_says() {
    let reference = sphere(SPHERE);
    let with_noise = |amount: f32| {
        let mut random = Random::new(3);
        let noisy: Vec<_> = reference.iter().map(|share| share + amount * random.signed() as f32).collect();
        psnr_db(&reference, &noisy, SPHERE, None).unwrap()
    };
    assert!(with_noise(0.0).is_infinite());
    let ratios = [0.001, 0.01, 0.1].map(with_noise);
    // Uniform noise of -a to a has the mean square of a^2 / 3.
    for (ratio, amount) in ratios.into_iter().zip([0.001_f64, 0.01, 0.1]) {
        let expected = -10.0 * (amount * amount / 3.0).log10();
        assert!((ratio - expected).abs() < 0.1, "{ratio} {expected}");
    }
    let moved: Vec<_> = reference.iter().map(|share| share + 0.1).collect();
    assert!((psnr_db(&reference, &moved, SPHERE, None).unwrap() - 20.0).abs() < 1e-4);
    // Only used texels count.
    let mut used = vec![true; SPHERE.texels() as usize];
    let mut one_off = reference.clone();
    one_off[SPHERE.sample(1, 9, 5, 4)] += 0.5;
    assert!(psnr_db(&reference, &one_off, SPHERE, Some(&used)).unwrap().is_finite());
    used[SPHERE.texel(1, 5, 4)] = false;
    assert!(psnr_db(&reference, &one_off, SPHERE, Some(&used)).unwrap().is_infinite());
    assert!(psnr_db(&reference, &one_off[1..], SPHERE, None).is_err());
    assert!(psnr_db(&reference, &one_off, SPHERE, Some(&used[1..])).is_err());
}

fn waves(size: VolumeSize, wave: impl Fn(f32) -> f32) -> Vec<f32> {
    let values = (0..size.samples() as usize).map(|sample| {
        let azimuth = sample / (size.width * size.height) as usize % size.azimuths as usize;
        wave(azimuth as f32 / size.azimuths as f32)
    });
    values.collect()
}

#[test]
fn interpolation_goes_through_the_samples_and_round_the_circle() {
    let size = VolumeSize { width: 3, height: 2, azimuths: 5, pages: 2 };
    let mut random = Random::new(8);
    let values: Vec<_> = (0..size.samples()).map(|_| random.unit() as f32).collect();
    let finer = VolumeSize { azimuths: 15, ..size };
    let interpolated = interpolate_azimuths(&values, size, 15);
    let at = |page, azimuth: u32| values[size.sample(page, azimuth % 5, 2, 1)];
    for (page, azimuth) in [(0, 0), (0, 4), (1, 3)] {
        for (part, share) in [(0, 0.0), (1, 1.0 / 3.0), (2, 2.0 / 3.0)] {
            let expected = at(page, azimuth) * (1.0 - share) + at(page, azimuth + 1) * share;
            let found = interpolated[finer.sample(page, 3 * azimuth + part, 2, 1)];
            assert!((found - expected).abs() < 1e-6);
        }
    }
    assert_eq!(interpolate_azimuths(&values, size, 5), values);
}

#[test]
fn fewer_azimuths_keep_what_they_can_hold() {
    let size = VolumeSize { width: 5, height: 4, azimuths: 64, pages: 2 };
    let smooth = to_bytes(&waves(size, |turns| 0.4 + 0.1 * (TAU * turns).sin()));
    let error = |azimuths| {
        let fewer = fewer_azimuths(&texture(size, smooth.clone()), azimuths).unwrap().into_parts();
        assert_eq!(fewer.size, VolumeSize { azimuths, ..size });
        let back = interpolate_azimuths(&shares(&fewer.angles, fewer.size), fewer.size, 64);
        psnr_db(&shares(&smooth, size), &back, size, None).unwrap()
    };
    // As many as before: nothing is lost; then more and more.
    assert!(error(64).is_infinite());
    let errors = [63, 32, 16, 8, 4].map(error);
    assert!(errors.is_sorted_by(|a, b| a > b), "{errors:?}");
    // The best broken line leaves about amplitude / sqrt(2) * (2 pi / n)^2 / sqrt(720): at 16 less than 8 bits do, at 4 some 44 dB.
    assert!(errors[2] > 55.0 && errors[4] < 45.0, "{errors:?}");
    for asked in [2, 65] {
        let error = fewer_azimuths(&texture(size, smooth.clone()), asked).unwrap_err();
        assert_eq!(error, CompressionError::Azimuths { asked, azimuths: 64 });
    }
}

/// Least squares leave less than what one would take at first, every second sample.
#[test]
fn fitted_azimuths_are_closer_than_samples_left_out() {
    let reference = shares(&to_bytes(&sphere(SPHERE)), SPHERE);
    let half = VolumeSize { azimuths: 16, ..SPHERE };
    let fitted = compare(&texture(SPHERE, to_bytes(&reference)), &[Form::Azimuths(16)], None).unwrap()[0].psnr_db;
    let slice = (SPHERE.width * SPHERE.height) as usize;
    let left: Vec<f32> = reference.chunks_exact(slice).step_by(4).flatten().copied().collect();
    let sampled = psnr_db(&reference, &interpolate_azimuths(&left, half, 64), SPHERE, None).unwrap();
    assert!(fitted > sampled, "{fitted} {sampled}");
}

proptest! {
    /// An independent decoder reads the same values, and no value is farther off than half a step between the block's own ends.
    #[test]
    fn blocks_are_those_of_the_format(
        values in prop::collection::vec(any::<u8>(), 3 * 16),
        floor in prop::sample::select(vec![0_u8, 100, 255]),
        spread in prop::sample::select(vec![0_u8, 1, 9, 255]),
    ) {
        let near = |value: u8| floor.saturating_add(value % (u16::from(spread) + 1) as u8);
        let values: Vec<u8> = values.into_iter().map(|value| if spread == 255 { value } else { near(value) }).collect();
        let size = VolumeSize { width: 4, height: 4, azimuths: 3, pages: 1 };
        let bytes = blocks::encode(&texture(size, crate::Angles::Unorm8(values.clone())), None).unwrap();
        prop_assert_eq!(bytes.len(), 24);
        let decoded = blocks::decode(&bytes, size);
        for slice in 0..3 {
            let mut oracle = [0; 16];
            bcdec_rs::bc4(&bytes[slice * 8..][..8], &mut oracle, 4, false);
            let range = 16 * slice..16 * slice + 16;
            let (least, most) = (values[range.clone()].iter().min().unwrap(), values[range.clone()].iter().max().unwrap());
            let mut sum = 0.0;
            for ((value, share), oracle) in values[range.clone()].iter().zip(&decoded[range]).zip(oracle) {
                prop_assert!((share * 255.0 - f32::from(oracle)).abs() <= 1.0, "{} {}", share * 255.0, oracle);
                sum += (share * 255.0 - f32::from(*value)).powi(2);
            }
            // The ends that the search begins with leave at most half a step each.
            let step = f32::from(most - least) / 7.0;
            prop_assert!(sum <= 16.0 * (step / 2.0).powi(2) + 1e-3, "{} {}", sum, step);
        }
    }
}

#[test]
fn blocks_leave_out_what_is_unused_and_round_sides_up() {
    let size = VolumeSize { width: 6, height: 5, azimuths: 3, pages: 2 };
    let used: Vec<_> = (0..size.texels()).map(|texel| texel % 2 == 0).collect();
    let mut random = Random::new(9);
    let values = (0..size.samples()).map(|sample| if sample % 2 == 0 { 90 } else { random.bits() as u8 }).collect();
    let texture = texture(size, crate::Angles::Unorm8(values));
    let bytes = blocks::encode(&texture, Some(&used)).unwrap();
    assert_eq!(bytes.len() as u64, blocks::encoded_bytes(size));
    assert_eq!(bytes.len(), 2 * 2 * 8 * 6);
    let ratio = |bytes: &[u8]| {
        let reference = shares(&texture.parts().angles, size);
        psnr_db(&reference, &blocks::decode(bytes, size), size, Some(&used)).unwrap()
    };
    assert!(ratio(&bytes).is_infinite());
    assert!(ratio(&blocks::encode(&texture, None).unwrap()).is_finite());
    assert!(blocks::encode(&texture, Some(&used[1..])).is_err());
}

#[test]
fn the_table_has_a_row_per_form() {
    let texture = texture(SPHERE, to_bytes(&sphere(SPHERE)));
    let forms = [
        Form::Unorm8,
        Form::Float16,
        Form::Terms(16),
        Form::Terms(4),
        Form::Azimuths(32),
        Form::Azimuths(16),
        Form::Blocks,
    ];
    let rows = compare(&texture, &forms, None).unwrap();
    let samples = SPHERE.samples();
    let texels = SPHERE.texels();
    let bytes: Vec<_> = rows.iter().map(|row| row.bytes).collect();
    let blocks = 10 * 8 * 8 * 64 * 2;
    let terms = |terms| terms * (texels + 4 * 66);
    assert_eq!(bytes, [samples, 2 * samples, terms(16), terms(4), samples / 2, samples / 4, blocks]);
    assert!(rows[0].psnr_db.is_infinite() && rows[1].psnr_db > 65.0, "{rows:?}");
    assert!(rows[2].psnr_db > rows[3].psnr_db && rows[4].psnr_db > rows[5].psnr_db, "{rows:?}");
    assert!(rows.iter().all(|row| row.psnr_db > 25.0), "{rows:?}");
    assert!(compare(&texture, &[Form::Terms(65)], None).is_err());
    assert_eq!(
        forms.map(|form| form.to_string()).join(", "),
        "8 bits, 16-bit floats, 16 terms, 4 terms, 32 azimuths, 16 azimuths, BC4 blocks"
    );
}
