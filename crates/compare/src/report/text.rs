//! Numbers as people read them.

use super::measure::Measure;
use crate::metrics::table::MetricSpec;

/// What stands where there is no number.
pub(super) const NONE: &str = "–";

/// A metric's value without its unit; shares are shown in per cent, as the head of the table says.
pub(super) fn metric_text(metric: &MetricSpec, value: f64) -> String {
    in_unit(metric.unit, value)
}

/// The unit of a metric as the head of a table says it.
pub(super) fn shown_unit(unit: &str) -> &str {
    if unit == "share" { "%" } else { unit }
}

/// A measure's value with its unit.
pub(super) fn measured(measure: &Measure, value: f64) -> String {
    format!("{} {}", in_unit(measure.unit, value), shown_unit(measure.unit))
}

/// A value without its unit, to two decimals; of what is below a tenth two digits, as far as four decimals go.
pub(super) fn in_unit(unit: &str, value: f64) -> String {
    let value = if unit == "share" { value * 100.0 } else { value };
    let decimals = match value.abs() {
        size if size == 0.0 || size >= 0.1 => 2,
        size if size >= 0.01 => 3,
        _ => 4,
    };
    format!("{value:.decimals$}")
}

/// A time without its unit.
pub(super) fn milliseconds(value: f64) -> String {
    if value < 10.0 { format!("{value:.2}") } else { format!("{value:.1}") }
}

/// An interval, `1.20–1.40`; nothing where its ends read alike.
pub(super) fn interval(ends: Option<[f64; 2]>, text: impl Fn(f64) -> String) -> Option<String> {
    let [low, high] = ends?.map(text);
    (low != high).then(|| format!("{low}–{high}"))
}

/// A ratio or another number that may be missing.
pub(super) fn optional(value: Option<f64>, text: impl Fn(f64) -> String) -> String {
    value.map_or_else(|| NONE.to_owned(), text)
}

/// A phrase of a method's guide as a sentence that begins with `opening`; nothing where the method says nothing. Names lose their
/// backquotes.
pub(super) fn said(opening: &str, phrase: &str) -> Option<String> {
    (!phrase.is_empty()).then(|| format!("{opening} {}.", phrase.replace('`', "")))
}

/// Bytes in millions.
pub(super) fn megabytes(bytes: u64) -> String {
    format!("{:.2}", bytes as f64 / 1e6)
}

/// A count with thin spaces between groups of three digits.
pub(super) fn grouped(count: usize) -> String {
    let digits = count.to_string();
    let head = digits.len() % 3;
    let groups = digits.as_bytes()[head..].chunks(3).map(|group| String::from_utf8_lossy(group).into_owned());
    let first = (head > 0).then(|| digits[..head].to_owned());
    first.into_iter().chain(groups).collect::<Vec<_>>().join("\u{202f}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_are_grouped() {
        assert_eq!([7, 123, 1234, 1_234_567].map(grouped), ["7", "123", "1\u{202f}234", "1\u{202f}234\u{202f}567"]);
    }

    #[test]
    fn a_phrase_becomes_a_sentence() {
        assert_eq!(said("Choose it when", "`a` is small"), Some("Choose it when a is small.".to_owned()));
        assert_eq!(said("Choose it when", ""), None);
    }

    #[test]
    fn shares_are_shown_in_per_cent() {
        assert_eq!((in_unit("share", 0.125), in_unit("px", 0.125)), ("12.50".to_owned(), "0.12".to_owned()));
        assert_eq!((shown_unit("share"), shown_unit("px")), ("%", "px"));
        assert_eq!([0.0, 0.1, 0.0123, 0.00123].map(|value| in_unit("px", value)), ["0.00", "0.10", "0.012", "0.0012"]);
        assert_eq!(interval(Some([1.0, 12.25]), milliseconds), Some("1.00–12.2".to_owned()));
        assert_eq!((interval(Some([1.0, 1.001]), milliseconds), interval(None, milliseconds)), (None, None));
        assert_eq!(optional(None, milliseconds), NONE);
    }
}
