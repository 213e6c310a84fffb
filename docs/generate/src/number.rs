//! Numbers as tables show them.

/// A time with two significant digits, which is what repeated measurements agree on; whole numbers from 10 on.
pub fn time(milliseconds: f64) -> String {
    significant(milliseconds, 2)
}

/// A number rounded to so many significant digits, without an exponent; at least all digits before the point.
pub fn significant(number: f64, digits: i32) -> String {
    if number == 0.0 || !number.is_finite() {
        return number.to_string();
    }
    let decimals = digits - 1 - number.abs().log10().floor() as i32;
    format!("{number:.*}", decimals.max(0) as usize)
}

/// A share in per cent with one decimal; `0` where that is all that is left of it.
pub fn percent(share: f64) -> String {
    one_decimal(100.0 * share)
}

/// A number with one decimal; `0` where that is all that is left of it.
pub fn one_decimal(number: f64) -> String {
    let shown = format!("{number:.1}");
    if shown == "0.0" || shown == "-0.0" { "0".to_owned() } else { shown }
}

/// A count in groups of three digits.
pub fn count(number: u64) -> String {
    let digits = number.to_string();
    if digits.len() < 5 {
        return digits;
    }
    let first = digits.len() % 3;
    let groups = (0..digits.len()).skip(first).step_by(3).map(|at| &digits[at..at + 3]);
    let lead = (first > 0).then_some(&digits[..first]);
    lead.into_iter().chain(groups).collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_shown_as_finely_as_they_are_known() {
        assert_eq!(
            [0.0065450, 0.0518575, 0.5734, 5.294, 80.04, 438.11].map(time),
            ["0.0065", "0.052", "0.57", "5.3", "80", "438"]
        );
        assert_eq!([0.0, 0.0004, 0.0005, 0.4395, 1.0].map(percent), ["0", "0", "0.1", "44.0", "100.0"]);
        assert_eq!(
            [0, 9999, 12_946, 1_111_216, 10_000_000].map(count),
            ["0", "9999", "12 946", "1 111 216", "10 000 000"]
        );
        assert_eq!(significant(0.0, 2), "0");
    }
}
