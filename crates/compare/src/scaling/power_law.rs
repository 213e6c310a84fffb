//! Least squares on logarithms.

/// `y = scale * x^exponent`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PowerLaw {
    /// Power of `x`: 1 where `y` grows as fast as `x`.
    pub exponent: f64,
    /// `y` at `x = 1`.
    pub scale: f64,
    /// Share of the variance of `log y` that the law explains, 0 to 1; 1 where `log y` does not vary.
    pub r2: f64,
}

impl PowerLaw {
    /// The law with the least sum of squared distances in `log y`, every point counting the same; `None` where there are
    /// fewer than two different `x`, or a coordinate is not finite and above 0. O(n).
    pub fn fit(points: &[[f64; 2]]) -> Option<Self> {
        if !points.iter().flatten().all(|value| value.is_finite() && *value > 0.0) {
            return None;
        }
        let count = points.len() as f64;
        let logs = || points.iter().map(|point| point.map(f64::ln));
        let [mean_x, mean_y] = [0, 1].map(|axis| logs().map(|log| log[axis]).sum::<f64>() / count);
        // Sums of products of deviations: the means are taken out first, so that nothing cancels.
        let [mut xx, mut xy, mut yy] = [0.0; 3];
        for [x, y] in logs().map(|[x, y]| [x - mean_x, y - mean_y]) {
            xx += x * x;
            xy += x * y;
            yy += y * y;
        }
        let first = points.first()?[0];
        if points.iter().all(|[x, _]| x.to_bits() == first.to_bits()) {
            return None;
        }
        let exponent = xy / xx;
        let r2 = if yy > 0.0 { (xy * xy / (xx * yy)).min(1.0) } else { 1.0 };
        Some(Self { exponent, scale: (mean_y - exponent * mean_x).exp(), r2 })
    }

    /// The law's `y` at an `x` above 0.
    pub fn at(&self, x: f64) -> f64 {
        self.scale * x.powf(self.exponent)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(y: impl Fn(f64) -> f64) -> Vec<[f64; 2]> {
        (0..12).map(|step| 1000.0 * 2.0_f64.powi(step)).map(|x| [x, y(x)]).collect()
    }

    #[test]
    fn an_exact_law_is_found() {
        for (exponent, scale) in [(1.0, 2e-6), (0.5, 3.0), (0.0, 7.0), (-0.25, 1.0)] {
            let law = PowerLaw::fit(&points(|x| scale * x.powf(exponent))).unwrap();
            assert!((law.exponent - exponent).abs() < 1e-12 && (law.scale / scale - 1.0).abs() < 1e-10, "{law:?}");
            assert!(exponent.abs() < 1e-9 || law.r2 > 1.0 - 1e-12, "{law:?}");
            assert!((law.at(5e5) / (scale * 5e5_f64.powf(exponent)) - 1.0).abs() < 1e-10);
        }
    }

    #[test]
    fn what_is_no_power_law_is_seen_to_be_none() {
        // Negative controls: the exponent follows a slower and a faster growth, and scatter lowers r2.
        let root = PowerLaw::fit(&points(f64::sqrt)).unwrap();
        let with_constant = PowerLaw::fit(&points(|x| 200.0 + x.sqrt())).unwrap();
        assert!(with_constant.exponent < root.exponent - 0.1 && with_constant.r2 < root.r2 - 0.01, "{with_constant:?}");
        let alternating = |x: f64| if x.log2().round() as i64 % 2 == 0 { 1.0 } else { 10.0 };
        let scattered = PowerLaw::fit(&points(alternating)).unwrap();
        assert!(scattered.r2 < 0.1, "{scattered:?}");
    }

    #[test]
    fn no_law_without_two_sizes_or_with_an_impossible_time() {
        assert_eq!(PowerLaw::fit(&[]), None);
        assert_eq!(PowerLaw::fit(&[[7.0, 1.0], [7.0, 2.0]]), None);
        assert_eq!(PowerLaw::fit(&[[7.0, 1.0], [8.0, 0.0]]), None);
        assert_eq!(PowerLaw::fit(&[[7.0, 1.0], [8.0, f64::NAN]]), None);
        assert_eq!(PowerLaw::fit(&[[7.0, 1.0], [f64::INFINITY, 1.0]]), None);
    }
}
