//! Which methods are worth their time: those that no other beats in both cost and error.

/// Indices of the points `[cost, error]` that no other point dominates, by cost, then error, then index. O(n log n).
///
/// A point dominates another where it is no worse in both and better in one; points that tie in both stay together.
/// Points with a NaN are never in the front and dominate nothing.
pub fn pareto_front(points: &[[f64; 2]]) -> Vec<usize> {
    let is_number = |&index: &usize| !points[index].iter().any(|value| value.is_nan());
    let mut order: Vec<usize> = (0..points.len()).filter(is_number).collect();
    // Adding 0 turns -0 into 0, from which `total_cmp` and the bits would differ.
    let key = |index: usize| points[index].map(|value| value + 0.0);
    let ties = |a: usize, b: usize| key(a).map(f64::to_bits) == key(b).map(f64::to_bits);
    order.sort_by(|&a, &b| {
        let ([cost_a, error_a], [cost_b, error_b]) = (key(a), key(b));
        cost_a.total_cmp(&cost_b).then(error_a.total_cmp(&error_b)).then(a.cmp(&b))
    });
    let mut front: Vec<usize> = Vec::new();
    for index in order {
        let beats_the_last = |&last: &usize| points[index][1] < points[last][1] || ties(index, last);
        if front.last().is_none_or(beats_the_last) {
            front.push(index);
        }
    }
    front
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn dominates(a: [f64; 2], b: [f64; 2]) -> bool {
        a[0] <= b[0] && a[1] <= b[1] && (a[0] < b[0] || a[1] < b[1])
    }

    fn brute_force(points: &[[f64; 2]]) -> Vec<usize> {
        let is_number = |point: &[f64; 2]| !point.iter().any(|value| value.is_nan());
        let in_front =
            |&index: &usize| is_number(&points[index]) && !points.iter().any(|&other| dominates(other, points[index]));
        (0..points.len()).filter(in_front).collect()
    }

    /// Few distinct values, so that ties are common.
    fn value() -> impl Strategy<Value = f64> {
        prop_oneof![
            8 => (0_i8..6).prop_map(f64::from),
            1 => Just(f64::NAN),
            1 => Just(-0.0),
            1 => Just(f64::INFINITY),
        ]
    }

    proptest! {
        #[test]
        fn equals_the_quadratic_definition(points in prop::collection::vec([value(), value()], 0..24)) {
            let front = pareto_front(&points);
            let sorted = front.windows(2).all(|pair| {
                points[pair[0]][0] <= points[pair[1]][0] && points[pair[0]][1] >= points[pair[1]][1]
            });
            prop_assert!(sorted);
            let mut by_index = front;
            by_index.sort_unstable();
            prop_assert_eq!(by_index, brute_force(&points));
        }
    }

    #[test]
    fn ties_stay_together_and_nan_stays_out() {
        let points = [[2.0, 1.0], [1.0, 2.0], [1.0, 2.0], [1.0, 3.0], [f64::NAN, 0.0], [3.0, 1.0]];
        assert_eq!(pareto_front(&points), [1, 2, 0]);
        assert!(pareto_front(&[]).is_empty());
    }
}
