//! The exact sign, and a faithful value, of a sum of products of three 32-bit floats, for the predicates that `robust` does
//! not offer.
//!
//! The product of two `f32` fits an `f64` exactly (48 bits of significand, exponents far from both ends); its product
//! with a third is the sum of two `f64` (a fused multiply-add yields the rounding error); sums of `f64` are kept as
//! Shewchuk's expansions (Adaptive Precision Floating-Point Arithmetic, 1997, section 2.4), whose sign is that of their
//! largest component.

use std::cmp::Ordering;

/// Most products that one sum may hold; each contributes two components.
const MAX_PRODUCTS: usize = 24;

/// A sum of `f64` without rounding error: components that do not overlap, in increasing magnitude, zeros included.
struct Expansion {
    components: [f64; 2 * MAX_PRODUCTS],
    len: usize,
}

impl Expansion {
    /// Shewchuk's GROW-EXPANSION.
    fn add(&mut self, term: f64) {
        let mut carry = term;
        for component in &mut self.components[..self.len] {
            let sum = carry + *component;
            let virtual_component = sum - carry;
            let error = (carry - (sum - virtual_component)) + (*component - virtual_component);
            *component = error;
            carry = sum;
        }
        self.components[self.len] = carry;
        self.len += 1;
    }

    fn sign(&self) -> Ordering {
        let largest = self.components[..self.len].iter().rev().copied().find(|&component| component != 0.0);
        largest.unwrap_or(0.0).partial_cmp(&0.0).unwrap_or(Ordering::Equal)
    }
}

/// Exact sign of `sum of sign_i * x_i * y_i * z_i`, `sign_i` being 1 or -1. At most [`MAX_PRODUCTS`] finite products.
pub(crate) fn sign_of_products(products: impl IntoIterator<Item = (f64, [f32; 3])>) -> Ordering {
    expand(products).sign()
}

/// The same sum, rounded: relative error at most `2^-50`, and zero only where the sum is exactly zero.
pub(crate) fn sum_of_products(products: impl IntoIterator<Item = (f64, [f32; 3])>) -> f64 {
    let sum = expand(products);
    // Components do not overlap, so each is smaller than the last bit of the next: adding upwards rounds once in effect.
    sum.components[..sum.len].iter().sum()
}

fn expand(products: impl IntoIterator<Item = (f64, [f32; 3])>) -> Expansion {
    let mut sum = Expansion { components: [0.0; 2 * MAX_PRODUCTS], len: 0 };
    for (sign, [x, y, z]) in products {
        let (pair, z) = (sign * f64::from(x) * f64::from(y), f64::from(z));
        let product = pair * z;
        sum.add(pair.mul_add(z, -product));
        sum.add(product);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cancellation_is_exact() {
        let big = f32::MAX;
        let tiny = f32::from_bits(1);
        let terms = [(1.0, [big, big, big]), (1.0, [tiny, tiny, tiny]), (-1.0, [big, big, big])];
        assert_eq!(sign_of_products(terms), Ordering::Greater);
        assert_eq!(sign_of_products([terms[0], terms[2]]), Ordering::Equal);
        let next = f32::from_bits(1.0_f32.to_bits() + 1);
        assert_eq!(sign_of_products([(1.0, [1.0, next, next]), (-1.0, [next, next, next])]), Ordering::Less);
        assert_eq!(sign_of_products([]), Ordering::Equal);
        let value = sum_of_products(terms);
        assert!((value / f64::from(tiny).powi(3) - 1.0).abs() < 1e-12, "{value}");
        assert!(sum_of_products([terms[0], terms[2]]) == 0.0);
    }
}
