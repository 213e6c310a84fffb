//! Exact Euclidean distance transform of a mask.
//!
//! Paper: P. Felzenszwalb and D. Huttenlocher, "Distance Transforms of Sampled Functions", Theory of Computing 8, 2012.
//! Squared distances separate: one pass down the columns, one along the rows, each the lower envelope of parabolas.
//! Squared distances between pixels are whole numbers below 2^31, so the result is exact before its square root.

/// Distance, in pixels, from each pixel's centre to the centre of the nearest pixel that is set; infinite everywhere
/// where none is. `mask` is row by row, `width` columns wide. O(pixels).
///
/// # Panics
/// If `mask` is not a whole number of rows.
pub fn distance_transform(mask: &[bool], width: usize) -> Vec<f64> {
    if mask.is_empty() {
        return Vec::new();
    }
    assert!(width > 0 && mask.len().is_multiple_of(width), "{} pixels do not make rows of {width}", mask.len());
    let height = mask.len() / width;
    let mut squared: Vec<f64> = mask.iter().map(|&set| if set { 0.0 } else { f64::INFINITY }).collect();
    let mut envelope = Envelope::default();
    let mut line = vec![0.0; height];
    for x in 0..width {
        for y in 0..height {
            line[y] = squared[y * width + x];
        }
        envelope.lower(&mut line);
        for y in 0..height {
            squared[y * width + x] = line[y];
        }
    }
    for row in squared.chunks_exact_mut(width) {
        envelope.lower(row);
    }
    for value in &mut squared {
        *value = value.sqrt();
    }
    squared
}

/// The parabolas of the lower envelope from left to right; kept between lines as scratch.
#[derive(Default)]
struct Envelope {
    parabolas: Vec<Parabola>,
}

struct Parabola {
    apex: f64,
    height: f64,
    /// Where the parabola becomes the lowest.
    from: f64,
}

impl Envelope {
    /// Replaces `values[i]` by the minimum over `j` of `values[j] + (i - j)^2`.
    fn lower(&mut self, values: &mut [f64]) {
        self.parabolas.clear();
        for (at, &height) in values.iter().enumerate() {
            if height.is_infinite() {
                continue;
            }
            let apex = at as f64;
            let mut from = f64::NEG_INFINITY;
            while let Some(last) = self.parabolas.last() {
                from = crossing(last, apex, height);
                if from > last.from {
                    break;
                }
                self.parabolas.pop();
                from = f64::NEG_INFINITY;
            }
            self.parabolas.push(Parabola { apex, height, from });
        }
        let Some(last) = self.parabolas.len().checked_sub(1) else { return };
        let mut lowest = 0;
        for (at, value) in values.iter_mut().enumerate() {
            let at = at as f64;
            while lowest < last && self.parabolas[lowest + 1].from <= at {
                lowest += 1;
            }
            let Parabola { apex, height, .. } = self.parabolas[lowest];
            *value = height + (at - apex) * (at - apex);
        }
    }
}

/// Where a parabola with its apex further right meets `left`.
fn crossing(left: &Parabola, apex: f64, height: f64) -> f64 {
    ((height + apex * apex) - (left.height + left.apex * left.apex)) / (2.0 * (apex - left.apex))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn brute_force(mask: &[bool], width: usize) -> Vec<f64> {
        let position = |at: usize| ((at % width) as f64, (at / width) as f64);
        let to_nearest = |at: usize| {
            let (x, y) = position(at);
            let set = (0..mask.len()).filter(|&other| mask[other]).map(position);
            set.map(|(ox, oy)| (x - ox).powi(2) + (y - oy).powi(2)).fold(f64::INFINITY, f64::min).sqrt()
        };
        (0..mask.len()).map(to_nearest).collect()
    }

    proptest! {
        #[test]
        fn agrees_with_brute_force_to_the_bit(
            (width, mask) in (1_usize..24, 1_usize..24, 0.0_f64..1.0).prop_flat_map(|(width, height, density)| {
                (Just(width), proptest::collection::vec(proptest::bool::weighted(density * density), width * height))
            })
        ) {
            prop_assert_eq!(distance_transform(&mask, width), brute_force(&mask, width));
        }
    }

    #[test]
    fn nothing_set_is_infinitely_far() {
        assert!(distance_transform(&[false; 6], 3).iter().all(|distance| distance.is_infinite()));
        assert!(distance_transform(&[], 0).is_empty());
    }
}
