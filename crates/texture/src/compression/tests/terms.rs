//! Sums of terms.

use super::lobes::{SPHERE, sphere, texture, to_bytes};
use crate::compression::eigen::eigenvectors;
use crate::compression::gram::gram;
use crate::compression::{CompressionError, compress, expand, psnr_db, shares, stored_bytes};
use crate::{Angles, Terms, VolumeSize};
use silhouette_testing::{Random, with_threads};

fn terms_of(size: VolumeSize, angles: Angles, terms: u32, used: Option<&[bool]>) -> Terms {
    match compress(&texture(size, angles), terms, used).unwrap().into_parts().angles {
        Angles::Terms(terms) => terms,
        other => panic!("{other:?}"),
    }
}

/// The farthest that rounding weights can move a sample, and a little for 32-bit sums.
fn quantization_bound(terms: &Terms, azimuth: usize) -> f32 {
    let steps = terms.functions.iter().zip(&terms.scales);
    steps.map(|(function, scale)| scale / 510.0 * function[azimuth].abs()).sum::<f32>() + 4e-6
}

fn assert_within_quantization(size: VolumeSize, angles: &Angles, terms: &Terms) {
    let (before, after) = (shares(angles, size), expand(terms, size));
    for (sample, (before, after)) in before.iter().zip(&after).enumerate() {
        let azimuth = sample / (size.width * size.height) as usize % size.azimuths as usize;
        assert!((before - after).abs() <= quantization_bound(terms, azimuth), "sample {sample}: {before} {after}");
    }
}

/// Products of whole numbers, so that 8 bits hold them exactly.
fn of_rank_two(size: VolumeSize) -> Angles {
    let mut random = Random::new(11);
    let functions: Vec<[usize; 2]> = (0..size.azimuths).map(|_| [random.below(12), random.below(12)]).collect();
    let weights: Vec<[usize; 2]> = (0..size.texels()).map(|_| [random.below(12), random.below(11)]).collect();
    let mut angles = vec![0; size.samples() as usize];
    for page in 0..size.pages {
        for (azimuth, function) in functions.iter().enumerate() {
            for (y, x) in (0..size.height).flat_map(|y| (0..size.width).map(move |x| (y, x))) {
                let weight = weights[size.texel(page, x, y)];
                let value = weight[0] * function[0] + weight[1] * function[1];
                angles[size.sample(page, azimuth as u32, x, y)] = value as u8;
            }
        }
    }
    Angles::Unorm8(angles)
}

#[test]
fn as_many_terms_as_the_rank_lose_only_what_rounding_loses() {
    let size = VolumeSize { width: 9, height: 7, azimuths: 12, pages: 3 };
    let angles = of_rank_two(size);
    for count in [2, 3, 12] {
        let terms = terms_of(size, angles.clone(), count, None);
        assert_within_quantization(size, &angles, &terms);
        assert!(terms.scales[2..].iter().all(|&scale| scale < 1e-5), "{:?}", terms.scales);
    }
    // One is too few.
    let terms = terms_of(size, angles.clone(), 1, None);
    let (before, after) = (shares(&angles, size), expand(&terms, size));
    assert!(before.iter().zip(&after).any(|(a, b)| (a - b).abs() > 0.1));
}

#[test]
fn functions_are_orthonormal() {
    let terms = terms_of(SPHERE, to_bytes(&sphere(SPHERE)), 16, None);
    for (i, a) in terms.functions.iter().enumerate() {
        for (j, b) in terms.functions.iter().enumerate() {
            let product: f64 = a.iter().zip(b).map(|(&a, &b)| f64::from(a) * f64::from(b)).sum();
            assert!((product - f64::from(u8::from(i == j))).abs() < 1e-6, "{i} {j}: {product}");
        }
    }
}

/// No sum of so many terms is closer than the eigenvalues left out allow (Eckart and Young 1936), and ours come near.
#[test]
fn the_error_falls_with_each_term_and_nears_the_best_possible() {
    let angles = to_bytes(&sphere(SPHERE));
    let reference = shares(&angles, SPHERE);
    let values = eigenvectors(gram(&reference, SPHERE, None), 64).values;
    let mut last = 0.0;
    for count in [1, 2, 4, 8, 16] {
        let expanded = expand(&terms_of(SPHERE, angles.clone(), count, None), SPHERE);
        let found = psnr_db(&reference, &expanded, SPHERE, None).unwrap();
        let left: f64 = values[count as usize..].iter().sum();
        let best = -10.0 * (left / SPHERE.samples() as f64).log10();
        assert!(found <= best + 1e-3, "{count} terms: {found} dB, at most {best}");
        assert!(found >= best - 0.3 * f64::from(count), "{count} terms: {found} dB of {best}");
        assert!(found > last + 0.5, "{count} terms: {found} dB after {last}");
        last = found;
    }
}

#[test]
fn texels_outside_charts_have_no_say() {
    let lobes = sphere(SPHERE);
    let used: Vec<_> = (0..SPHERE.texels()).map(|texel| texel % 4 != 2).collect();
    let mut random = Random::new(5);
    let (mut clean, mut noisy) = (lobes.clone(), lobes);
    for page in 0..SPHERE.pages {
        for azimuth in 0..SPHERE.azimuths {
            for (x, y) in (0..SPHERE.height).flat_map(|y| (0..SPHERE.width).map(move |x| (x, y))) {
                if !used[SPHERE.texel(page, x, y)] {
                    let sample = SPHERE.sample(page, azimuth, x, y);
                    (clean[sample], noisy[sample]) = (0.0, random.unit() as f32);
                }
            }
        }
    }
    let psnr = |angles: &Angles, used: Option<&[bool]>, count| {
        let terms = terms_of(SPHERE, angles.clone(), count, used);
        psnr_db(&shares(angles, SPHERE), &expand(&terms, SPHERE), SPHERE, Some(&used_or_all(used))).unwrap()
    };
    let (clean, noisy) = (to_bytes(&clean), to_bytes(&noisy));
    let masked = terms_of(SPHERE, noisy.clone(), 4, Some(&used));
    let other = terms_of(SPHERE, clean, 4, Some(&used));
    assert_eq!((&masked.functions, &masked.offsets, &masked.scales), (&other.functions, &other.offsets, &other.scales));
    // Without the mask, noise takes terms.
    let all = terms_of(SPHERE, noisy.clone(), 4, None);
    let error = |terms| psnr_db(&shares(&noisy, SPHERE), &expand(terms, SPHERE), SPHERE, Some(&used)).unwrap();
    assert!(error(&masked) > error(&all) + 3.0, "{} {}", error(&masked), error(&all));
    assert!(psnr(&noisy, None, 4) < psnr(&noisy, Some(&used), 4));

    let error = compress(&texture(SPHERE, noisy), 4, Some(&used[1..])).unwrap_err();
    assert!(matches!(error, CompressionError::Used(_)));
}

fn used_or_all(used: Option<&[bool]>) -> Vec<bool> {
    used.map_or(vec![true; SPHERE.texels() as usize], <[bool]>::to_vec)
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    let angles = to_bytes(&sphere(SPHERE));
    let run = |threads| {
        with_threads(threads, || {
            let terms = terms_of(SPHERE, angles.clone(), 8, None);
            let psnr = psnr_db(&shares(&angles, SPHERE), &expand(&terms, SPHERE), SPHERE, None).unwrap();
            let bits = |values: &[f32]| values.iter().map(|value| value.to_bits()).collect::<Vec<_>>();
            let functions: Vec<_> = terms.functions.iter().map(|function| bits(function)).collect();
            (functions, bits(&terms.offsets), bits(&terms.scales), terms.weights, psnr.to_bits())
        })
    };
    let one = run(1);
    assert!(one == run(2) && one == run(5));
}

#[test]
fn small_and_even_textures_compress() {
    let size = VolumeSize { width: 1, height: 1, azimuths: 3, pages: 1 };
    for angles in [vec![0, 0, 0], vec![10, 200, 30], vec![255; 3]] {
        let angles = Angles::Unorm8(angles);
        for count in 1..=3 {
            assert_within_quantization(size, &angles, &terms_of(size, angles.clone(), count, None));
        }
        // A term more than there are azimuths, or none; no texel in a chart.
        for asked in [0, 4] {
            let error = compress(&texture(size, angles.clone()), asked, None).unwrap_err();
            assert_eq!(error, CompressionError::Terms { asked, azimuths: 3 });
        }
        let none = terms_of(size, angles.clone(), 2, Some(&[false]));
        assert!(expand(&none, size).iter().all(|&share| share == 0.0));
    }
    let size = VolumeSize { width: 20, height: 13, azimuths: 16, pages: 1 };
    let even = Angles::Unorm8(vec![77; size.samples() as usize]);
    let terms = terms_of(size, even.clone(), 4, None);
    assert_within_quantization(size, &even, &terms);
    assert!(terms.functions[0].iter().all(|&value| (value - 0.25).abs() < 1e-6), "{:?}", terms.functions[0]);
    // Compressed again, it stays what it is.
    let again = terms_of(size, Angles::Terms(terms), 4, None);
    assert_within_quantization(size, &even, &again);
}

#[test]
fn sizes_are_those_stated() {
    let size = VolumeSize { width: 512, height: 512, azimuths: 64, pages: 1 };
    let weights = |terms: usize| Terms {
        functions: vec![vec![0.0; 64]; terms],
        offsets: vec![0.0; terms],
        scales: vec![0.0; terms],
        weights: vec![0; terms * size.texels() as usize],
    };
    let bytes = |terms| stored_bytes(&Angles::Terms(weights(terms)));
    assert_eq!([16, 8, 4].map(bytes), [4_198_528, 2_099_264, 1_049_632]);
}
