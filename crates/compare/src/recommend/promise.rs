//! Step 5: how sure a promise is, by counting alone.
//!
//! A promise says that at least [`SHARE`] of all views keep to the limits. Let `n` views be drawn independently, of which `k` do not
//! keep to them. If the promise were wrong, each view would fail with a probability above `1 - SHARE`, and so few failures would occur
//! with a probability of at most `doubt(n, k)`, the binomial distribution's lower tail. Nothing is assumed about how errors or
//! times are distributed. For `k = 0` the largest of `n` values bounds the quantile with confidence `1 - SHARE^n`: Wilks,
//! "Determination of Sample Sizes for Setting Tolerance Limits", Annals of Mathematical Statistics, 1941; 59 views for 95 %.
//!
//! Several candidates may be examined until one keeps to the limits; each could do so by luck. The m-th may exceed them only so often
//! that its doubt is at most a share `1 / m` of what the aim leaves, and the doubts of all that were examined add up (Bonferroni): the
//! confidence stated for the second is below the aim, however well it did.

use super::choice::VIEWS;

/// Share of all views that keep to the limits.
pub const SHARE: f64 = 0.95;

/// Confidence that is aimed at.
pub const CONFIDENCE: f64 = 0.95;

/// Confidence below which nothing is promised: a promise is to be kept more likely than not.
pub const LEAST_CONFIDENCE: f64 = 0.5;

/// The largest probability with which at most `over` of `views` independent views exceed the limits although less than [`SHARE`] of
/// all views keep to them: 1 where all may exceed. O(over).
pub fn doubt(views: u32, over: u32) -> f64 {
    if over >= views {
        return 1.0;
    }
    // Each summand follows from the one before; in logarithms the first does not vanish for many views.
    let odds = ((1.0 - SHARE) / SHARE).ln();
    let mut summand = f64::from(views) * SHARE.ln();
    let mut sum = summand.exp();
    for k in 1..=over {
        summand += odds + (f64::from(views - k + 1) / f64::from(k)).ln();
        sum += summand.exp();
    }
    sum.min(1.0)
}

/// Confidence in a promise that `over` of `views` views exceeded, after `examined` candidates, itself included: 0 to 1. Those before it
/// could have been promised by luck in as many as [`VIEWS`] views. O(over + examined).
pub fn confidence(views: u32, over: u32, examined: u32) -> f64 {
    let by_luck = |earlier: u32| allowed(VIEWS, earlier).map_or(0.0, |over| doubt(VIEWS, over));
    (1.0 - doubt(views, over) - (1..examined).map(by_luck).sum::<f64>()).max(0.0)
}

/// How many of `views` views may at most exceed the limits, for the candidate that is the `examined`-th; `None` where there are too few
/// views for any. O(result²).
pub fn allowed(views: u32, examined: u32) -> Option<u32> {
    let most = (1.0 - CONFIDENCE) / f64::from(examined.max(1));
    (0..views).take_while(|&over| doubt(views, over) <= most).last()
}

/// How many of `views` views may exceed a promise whose time is found out from the same views: as many as are [`allowed`], or as do
/// exceed its error.
pub fn rank(views: u32, over: u32, examined: u32) -> u32 {
    allowed(views, examined).unwrap_or(0).max(over)
}

/// The value that all but `rank` of some views keep to; `None` where there are no more. O(n log n).
pub fn exceeded_by(values: impl IntoIterator<Item = f64>, rank: u32) -> Option<f64> {
    let mut sorted: Vec<f64> = values.into_iter().collect();
    sorted.sort_by(|one, other| other.total_cmp(one));
    sorted.get(rank as usize).copied()
}

/// The value that [`SHARE`] of all views keep to with [`CONFIDENCE`], from some independent ones: the largest, or a lower one where
/// there are more than enough. Of too few, the largest; `None` of none. O(n log n).
pub fn bound(values: impl IntoIterator<Item = f64>, examined: u32) -> Option<f64> {
    let values: Vec<f64> = values.into_iter().collect();
    let views = u32::try_from(values.len()).unwrap_or(u32::MAX);
    exceeded_by(values, rank(views, 0, examined))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The textbook's numbers of views for 95 % with 95 % confidence.
    #[test]
    fn as_many_views_as_wilks_says() {
        assert_eq!(
            [58, 59, 92, 93, 123, 124, 153].map(|views| allowed(views, 1)),
            [None, Some(0), Some(0), Some(1), Some(1), Some(2), Some(3)]
        );
        assert_eq!([1, 2, 3, 4].map(|examined| allowed(VIEWS, examined)), [Some(2), Some(1), Some(1), Some(0)]);
        assert_eq!([71, 72].map(|views| allowed(views, 2)), [None, Some(0)], "two examined candidates take more");
        assert!((confidence(59, 0, 1) - (1.0 - 0.95_f64.powi(59))).abs() < 1e-12);
    }

    #[test]
    fn doubt_is_the_tail_of_the_binomial_distribution() {
        let choose = |n: u32, k: u32| (0..k).map(|i| f64::from(n - i) / f64::from(i + 1)).product::<f64>();
        for views in [1, 5, 20, 60] {
            for over in 0..views {
                let term = |k: u32| choose(views, k) * 0.05_f64.powi(k as i32) * 0.95_f64.powi((views - k) as i32);
                let expected: f64 = (0..=over).map(term).sum();
                assert!((doubt(views, over) - expected).abs() < 1e-10, "{views} {over}");
            }
        }
        assert_eq!([doubt(0, 0), doubt(3, 3)].map(f64::to_bits), [1.0_f64; 2].map(f64::to_bits));
        assert!(doubt(1_000_000, 10) < 1e-300, "no view is lost to underflow");
    }

    #[test]
    fn the_doubts_of_all_that_were_examined_add_up() {
        let alone = confidence(VIEWS, 0, 1);
        assert!((alone - (1.0 - 0.95_f64.powi(124))).abs() < 1e-12);
        assert!((confidence(VIEWS, 0, 2) - (alone - doubt(VIEWS, 2))).abs() < 1e-12, "the first could exceed twice");
        let spent: f64 = (1..=10).map(|m| doubt(VIEWS, allowed(VIEWS, m).unwrap())).sum();
        assert!((1.0 - spent - confidence(VIEWS, allowed(VIEWS, 10).unwrap(), 10)).abs() < 1e-12);
        assert!(confidence(VIEWS, 0, 1000) >= 0.0);
    }

    #[test]
    fn a_bound_leaves_out_no_more_than_it_may() {
        let values = |count: u32| (1..=count).map(f64::from);
        assert_eq!(bound(values(59), 1), Some(59.0));
        assert_eq!(bound(values(124), 1), Some(122.0));
        assert_eq!(bound(values(10), 1), Some(10.0));
        assert_eq!(bound([], 1), None);
    }
}
