//! Step 2: [`Change`]s become a table.

use crate::changes::{Change, Ratio};

/// What a change is called where its interval excludes 1.
pub fn mark(ratio: Ratio) -> &'static str {
    let [low, high] = ratio.interval;
    if low > 1.0 {
        "slower"
    } else if high < 1.0 {
        "faster"
    } else {
        ""
    }
}

/// The benchmarks whose names hold one of the filters, all where there is none: the largest slow-down first. What has run once is
/// counted below.
pub fn table(changes: &[Change], filters: &[String]) -> String {
    let is_wanted = |change: &&Change| filters.is_empty() || filters.iter().any(|filter| change.name.contains(filter));
    let wanted: Vec<&Change> = changes.iter().filter(is_wanted).collect();
    let mut compared: Vec<(&Change, Ratio)> =
        wanted.iter().filter_map(|change| change.ratio.map(|ratio| (*change, ratio))).collect();
    compared.sort_by(|(one, a), (other, b)| b.median.total_cmp(&a.median).then_with(|| one.name.cmp(&other.name)));
    let width = compared.iter().map(|(change, _)| change.name.chars().count()).max().unwrap_or(0).max(9);
    let mut text =
        format!("{:width$} {:>11} {:>11} {:>7}  {:>15}\n", "benchmark", "before", "now", "ratio", "interval");
    for (change, ratio) in &compared {
        let [low, high] = ratio.interval;
        let row = format!(
            "{:width$} {:>11} {:>11} {:>7.3}  {:>15}  {}",
            change.name,
            time(change.now_ns / ratio.median),
            time(change.now_ns),
            ratio.median,
            format!("{low:.3} to {high:.3}"),
            mark(*ratio)
        );
        text += row.trim_end();
        text.push('\n');
    }
    let marked = |what: &str| compared.iter().filter(|(_, ratio)| mark(*ratio) == what).count();
    text += &format!(
        "{} compared: {} slower, {} faster; {} ran once\n",
        compared.len(),
        marked("slower"),
        marked("faster"),
        wanted.len() - compared.len()
    );
    text
}

/// A time in a unit that suits it.
fn time(nanoseconds: f64) -> String {
    let units = [(1e9, "s"), (1e6, "ms"), (1e3, "us")];
    let (scale, unit) = units.into_iter().find(|(scale, _)| nanoseconds >= *scale).unwrap_or((1.0, "ns"));
    format!("{:.2} {unit}", nanoseconds / scale)
}
