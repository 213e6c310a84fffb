//! Gram matrices and their eigenvectors.

use super::lobes::{SPHERE, sphere};
use crate::compression::eigen::{Eigen, eigenvectors};
use crate::compression::gram::gram;
use proptest::prelude::*;
use silhouette_testing::Random;

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// `A v = l v`, unit vectors at right angles, falling values, signs as described.
fn check(matrix: &[f64], size: usize) -> Eigen {
    let eigen = eigenvectors(matrix.to_vec(), size);
    let scale = matrix.iter().fold(1e-300_f64, |largest, x| largest.max(x.abs())) * size as f64;
    for (i, (value, vector)) in eigen.values.iter().zip(&eigen.vectors).enumerate() {
        for (row, component) in matrix.chunks_exact(size).zip(vector) {
            assert!((dot(row, vector) - value * component).abs() <= 1e-13 * scale, "vector {i} of {matrix:?}");
        }
        for (j, other) in eigen.vectors.iter().enumerate() {
            assert!((dot(vector, other) - f64::from(u8::from(i == j))).abs() < 1e-12, "vectors {i} and {j}");
        }
        let largest = vector.iter().copied().fold(0.0_f64, |a, b| if b.abs() > a.abs() { b } else { a });
        assert!(largest > 0.0);
    }
    assert!(eigen.values.is_sorted_by(|a, b| a >= b));
    eigen
}

proptest! {
    #[test]
    fn vectors_are_turned_into_multiples_of_themselves(size in 1_usize..20, rank in 0_usize..20, seed: u64) {
        let mut random = Random::new(seed);
        let rows: Vec<Vec<f64>> = (0..rank).map(|_| (0..size).map(|_| random.signed()).collect()).collect();
        let entry = |i: usize, j: usize| rows.iter().map(|row| row[i] * row[j]).sum::<f64>();
        let matrix: Vec<f64> = (0..size * size).map(|index| entry(index / size, index % size)).collect();
        check(&matrix, size);
    }
}

#[test]
fn special_matrices_have_their_vectors() {
    let eigen = check(&[2.0, 1.0, 1.0, 2.0], 2);
    assert!((eigen.values[0] - 3.0).abs() < 1e-15 && (eigen.values[1] - 1.0).abs() < 1e-15);
    check(&[0.0; 9], 3);
    check(&[1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0], 3);
    check(&[1.0; 16], 4);
    check(&[1e-300; 4], 2);
    // What is no number ends, and does not panic.
    assert_eq!(eigenvectors(vec![f64::NAN; 9], 3).vectors.len(), 3);
}

#[test]
fn the_gram_matrix_is_the_sum_of_products() {
    let shares = sphere(SPHERE);
    let used: Vec<_> = (0..SPHERE.texels()).map(|texel| texel % 3 != 1).collect();
    for used in [None, Some(used.as_slice())] {
        let gram = gram(&shares, SPHERE, used);
        let value = |texel: usize, azimuth: u32| {
            let slice = 37 * 30;
            let (page, texel) = ((texel / slice) as u32, texel % slice);
            f64::from(shares[SPHERE.sample(page, azimuth, (texel % 37) as u32, (texel / 37) as u32)])
        };
        for (i, j) in [(0, 0), (5, 63), (63, 5), (40, 17)] {
            let texels = (0..SPHERE.texels() as usize).filter(|&texel| used.is_none_or(|used| used[texel]));
            let expected: f64 = texels.map(|texel| value(texel, i) * value(texel, j)).sum();
            let found = gram[(i * 64 + j) as usize];
            assert!((found - expected).abs() < 1e-12 * expected, "{found} {expected}");
        }
    }
}
