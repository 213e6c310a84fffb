//! Step 2: eigenvectors of a symmetric matrix, by Jacobi's rotations.
//!
//! C. G. J. Jacobi, "Über ein leichtes Verfahren, die in der Theorie der Säcularstörungen vorkommenden Gleichungen numerisch
//! aufzulösen", 1846. Matrices here have as many rows as a texel has azimuths. The crates for linear algebra were too much for that one job: `faer`
//! took 144 s of processor time to build, and its kernels differ in their last bits from one processor to another.

/// Sweeps after which rounding alone can keep rotations going. Ten are enough in practice.
const MAX_SWEEPS: usize = 60;

/// Eigenvalues, largest first, and their unit vectors in the same order.
pub(super) struct Eigen {
    pub(super) values: Vec<f64>,
    pub(super) vectors: Vec<Vec<f64>>,
}

/// Of a positive semidefinite symmetric matrix in `size` rows. Of each vector, the component that is largest in size, the first of
/// several, is positive. Accurate to the rounding of the matrix's trace. O(size^3) per sweep.
pub(super) fn eigenvectors(mut matrix: Vec<f64>, size: usize) -> Eigen {
    let trace: f64 = matrix.iter().step_by(size + 1).sum();
    let least = f64::EPSILON * trace / size as f64;
    // Rows of this one are the vectors.
    let mut vectors = vec![0.0; size * size];
    for row in 0..size {
        vectors[row * size + row] = 1.0;
    }
    for _ in 0..MAX_SWEEPS {
        let mut has_rotated = false;
        for p in 0..size {
            for q in p + 1..size {
                if let Some(rotation) = Rotation::of(&matrix, size, p, q, least) {
                    rotation.turn_columns(&mut matrix, size, p, q);
                    rotation.turn_rows(&mut matrix, size, p, q);
                    rotation.turn_rows(&mut vectors, size, p, q);
                    (matrix[p * size + q], matrix[q * size + p]) = (0.0, 0.0);
                    has_rotated = true;
                }
            }
        }
        if !has_rotated {
            break;
        }
    }

    let value = |index: usize| matrix[index * size + index];
    let mut order: Vec<_> = (0..size).collect();
    order.sort_by(|&a, &b| value(b).total_cmp(&value(a)));
    let signed = |index: &usize| {
        let vector = &vectors[index * size..][..size];
        let largest = vector.iter().fold(0.0_f64, |largest, &x| if x.abs() > largest.abs() { x } else { largest });
        vector.iter().map(|&x| if largest < 0.0 { -x } else { x }).collect()
    };
    Eigen { values: order.iter().map(|&index| value(index)).collect(), vectors: order.iter().map(signed).collect() }
}

/// A turn in the plane of two axes.
struct Rotation {
    cos: f64,
    sin: f64,
}

impl Rotation {
    /// The smaller of the turns that make the entry at `p`, `q` vanish; `None` where it is `least` or smaller in size.
    fn of(matrix: &[f64], size: usize, p: usize, q: usize, least: f64) -> Option<Self> {
        let (pp, qq, pq) = (matrix[p * size + p], matrix[q * size + q], matrix[p * size + q]);
        if pq.abs() <= least || !pq.is_finite() {
            return None;
        }
        let theta = (qq - pp) / (2.0 * pq);
        let tan = theta.signum() / (theta.abs() + theta.hypot(1.0));
        let cos = 1.0 / tan.hypot(1.0);
        Some(Self { cos, sin: tan * cos })
    }

    fn turn_rows(&self, matrix: &mut [f64], size: usize, p: usize, q: usize) {
        let (before, from_q) = matrix.split_at_mut(q * size);
        for (p, q) in before[p * size..][..size].iter_mut().zip(&mut from_q[..size]) {
            (*p, *q) = self.turned(*p, *q);
        }
    }

    fn turn_columns(&self, matrix: &mut [f64], size: usize, p: usize, q: usize) {
        for row in matrix.chunks_exact_mut(size) {
            (row[p], row[q]) = self.turned(row[p], row[q]);
        }
    }

    fn turned(&self, p: f64, q: f64) -> (f64, f64) {
        (self.cos * p - self.sin * q, self.sin * p + self.cos * q)
    }
}
