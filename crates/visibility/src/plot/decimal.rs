//! Numbers as files print them: with at most three decimals.

use silhouette_core::glam::DVec2;

/// Decimals of coordinates: a thousandth of a millimetre or of a pixel, finer than any plotter's step.
const DECIMALS: usize = 3;
/// 10 to the power of the decimals.
const STEPS: f64 = 1000.0;

/// A point as it is printed, in steps of the last decimal. Points of equal steps are one point in the file.
pub fn printed(point: DVec2) -> [i64; 2] {
    // Saturates far beyond any page.
    (point * STEPS).to_array().map(|coordinate| coordinate.round() as i64)
}

/// The number that is printed for another one.
pub fn rounded(value: f64) -> f64 {
    (value * STEPS).round() / STEPS
}

/// Appends a number given in steps of the last decimal, without zeros at its end.
pub fn push_steps(steps: i64, text: &mut Vec<u8>) {
    if steps < 0 {
        text.push(b'-');
    }
    let steps = steps.unsigned_abs();
    let (whole, mut share) = (steps / STEPS as u64, steps % STEPS as u64);
    let mut digits = [0; 20];
    let mut at = digits.len();
    let mut rest = whole;
    while rest > 0 || at == digits.len() {
        at -= 1;
        digits[at] = b'0' + (rest % 10) as u8;
        rest /= 10;
    }
    text.extend(&digits[at..]);
    if share > 0 {
        text.push(b'.');
        for decimal in (0..DECIMALS as u32).rev() {
            let power = 10_u64.pow(decimal);
            text.push(b'0' + (share / power) as u8);
            share %= power;
            if share == 0 {
                break;
            }
        }
    }
}

/// Appends a number.
pub fn push_number(value: f64, text: &mut Vec<u8>) {
    push_steps((value * STEPS).round() as i64, text);
}

/// A number as text.
pub fn number(value: f64) -> String {
    let mut text = Vec::new();
    push_number(value, &mut text);
    String::from_utf8(text).expect("digits are ASCII")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_at_most_three_decimals() {
        for (value, expected) in [
            (0.0, "0"),
            (-0.0004, "0"),
            (1.0, "1"),
            (-1.5, "-1.5"),
            (0.0005, "0.001"),
            (12.34, "12.34"),
            (-0.07, "-0.07"),
            (210.001, "210.001"),
            (1e6, "1000000"),
        ] {
            assert_eq!(number(value), expected, "{value}");
            assert_eq!(expected.parse::<f64>().unwrap().abs().to_bits(), rounded(value).abs().to_bits());
        }
    }
}
