//! Confidence intervals by bootstrap: how much a median of times, or a mean of errors, owes to the frames that were measured.
//!
//! Frames that follow each other along a path are alike, and so is what disturbs them. Values drawn one by one would be taken for
//! independent, and intervals would come out too narrow. So runs of consecutive values are drawn, of about the cube root of their
//! number, from a circle that joins the last to the first: the circular block bootstrap (Politis and Romano 1992). Of several passes over
//! a path, passes are drawn first and runs within each: what disturbs a whole pass is one disturbance, however many frames it holds. An
//! interval reaches from the 2.5th to the 97.5th percentile of what [`RESAMPLES`] such series yield.
//!
//! Draws are the same in every process, so that intervals of errors are the same to the last bit wherever a cell is measured.

/// Number of series that are drawn.
pub const RESAMPLES: usize = 1000;

/// Where the draws begin.
const SEED: u64 = 0x5eed;

/// Lower and upper end of the 95 % interval of the median of values, those of each pass in the order of their measurement; `None` of no
/// value. With one value, both are that value. O([`RESAMPLES`] x n log n).
pub fn of_median(passes: &[Vec<f64>]) -> Option<[f64; 2]> {
    bootstrap(passes, |sample| {
        sample.sort_unstable_by(f64::total_cmp);
        let count = sample.len();
        (sample[(count - 1) / 2] + sample[count / 2]) * 0.5
    })
}

/// The same of the mean of values in the order of their measurement. O([`RESAMPLES`] x n).
pub fn of_mean(values: &[f64]) -> Option<[f64; 2]> {
    bootstrap(&[values.to_vec()], |sample| sample.iter().sum::<f64>() / sample.len() as f64)
}

/// Whether two intervals have a value in common.
pub fn overlap(one: [f64; 2], other: [f64; 2]) -> bool {
    one[0] <= other[1] && other[0] <= one[1]
}

fn bootstrap(passes: &[Vec<f64>], statistic: fn(&mut [f64]) -> f64) -> Option<[f64; 2]> {
    let passes: Vec<&Vec<f64>> = passes.iter().filter(|values| !values.is_empty()).collect();
    if passes.is_empty() {
        return None;
    }
    let mut random = fastrand::Rng::with_seed(SEED);
    let mut sample = Vec::with_capacity(passes.iter().map(|values| values.len()).sum());
    let mut drawn: Vec<f64> = (0..RESAMPLES)
        .map(|_| {
            sample.clear();
            for _ in 0..passes.len() {
                let values = passes[random.usize(..passes.len())];
                draw_runs(values, &mut random, &mut sample);
            }
            statistic(&mut sample)
        })
        .collect();
    drawn.sort_unstable_by(f64::total_cmp);
    let percentile = |share: f64| drawn[(share * (RESAMPLES - 1) as f64).round() as usize];
    Some([percentile(0.025), percentile(0.975)])
}

/// Appends as many values as there are, in runs from a circle of them.
fn draw_runs(values: &[f64], random: &mut fastrand::Rng, sample: &mut Vec<f64>) {
    let count = values.len();
    let longest = (count as f64).cbrt().round() as usize;
    let mut left = count;
    while left > 0 {
        let (first, run) = (random.usize(..count), longest.min(left));
        sample.extend((first..first + run).map(|at| values[at % count]));
        left -= run;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Independent values of a standard normal distribution, by the sum of twelve uniform ones.
    fn normal(random: &mut fastrand::Rng) -> f64 {
        (0..12).map(|_| random.f64()).sum::<f64>() - 6.0
    }

    #[test]
    fn intervals_hold_the_value_and_repeat_to_the_bit() {
        let values: Vec<f64> = (0..50).map(|at| f64::from(at * 7 % 50)).collect();
        let [low, high] = of_median(std::slice::from_ref(&values)).unwrap();
        assert!(low < 24.5 && 24.5 < high && low >= 0.0 && high <= 49.0, "{low} {high}");
        assert_eq!(
            of_mean(&values).map(|ends| ends.map(f64::to_bits)),
            of_mean(&values).map(|ends| ends.map(f64::to_bits))
        );
        assert_eq!((of_median(&[vec![3.0]]), of_mean(&[])), (Some([3.0, 3.0]), None));
        assert_eq!(of_median(&[vec![], vec![]]), None);
        assert_eq!(of_mean(&[2.0; 9]), Some([2.0, 2.0]));
    }

    /// Of many series, the intervals of about 95 % hold the true mean. The percentile method is known to fall a little short with few
    /// values.
    #[test]
    fn the_interval_holds_the_true_mean_as_often_as_it_says() {
        let mut random = fastrand::Rng::with_seed(7);
        let mut share = |count: usize| {
            let held = (0..400).filter(|_| {
                let values: Vec<f64> = (0..count).map(|_| normal(&mut random)).collect();
                let [low, high] = of_mean(&values).unwrap();
                low <= 0.0 && 0.0 <= high
            });
            held.count() as f64 / 400.0
        };
        let (many, few) = (share(60), share(6));
        assert!((0.88..=0.985).contains(&many), "{many}");
        assert!((0.72..0.88).contains(&few), "{few}");
    }

    /// What single draws would get wrong: values that drift say less about their mean than as many independent ones.
    #[test]
    fn values_that_drift_have_wider_intervals_than_the_same_in_any_order() {
        let mut random = fastrand::Rng::with_seed(3);
        let mut level = 0.0;
        let mut values: Vec<f64> = Vec::new();
        for _ in 0..200 {
            level = 0.9 * level + normal(&mut random);
            values.push(level);
        }
        let width = |values: &[f64]| of_mean(values).map(|[low, high]| high - low).unwrap();
        let drifting = width(&values);
        random.shuffle(&mut values);
        assert!(drifting > 1.4 * width(&values), "{drifting} {}", width(&values));
    }

    /// A disturbance of a whole pass is one disturbance: three passes that differ say little of a fourth, however many frames they hold.
    #[test]
    fn passes_that_differ_widen_the_interval_to_their_medians() {
        let mut random = fastrand::Rng::with_seed(5);
        let passes: Vec<Vec<f64>> =
            [10.0, 12.0, 15.0].map(|level| (0..100).map(|_| level + 0.1 * normal(&mut random)).collect()).to_vec();
        let [low, high] = of_median(&passes).unwrap();
        assert!(low < 10.1 && high > 14.9, "{low} {high}");
        let [low, high] = of_median(&[passes.concat()]).unwrap();
        assert!(low > 11.0 && high < 14.0, "taken for one pass: {low} {high}");
    }

    #[test]
    fn intervals_that_touch_overlap() {
        assert!(overlap([0.0, 1.0], [1.0, 2.0]) && overlap([0.0, 9.0], [1.0, 2.0]));
        assert!(!overlap([0.0, 1.0], [1.5, 2.0]) && !overlap([1.5, 2.0], [0.0, 1.0]));
    }
}
