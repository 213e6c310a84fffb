//! The comparison of two runs, on folders as criterion leaves them.

mod changes;
mod table;

use changes::{Change, Ratio, read};
use std::fs;
use std::path::Path;
use table::{mark, table};

/// A benchmark as criterion leaves it: its median in nanoseconds, and the change of the median with its interval.
fn write(root: &Path, folder: &str, name: &str, now: f64, change: Option<[f64; 3]>) {
    let estimates = |[point, low, high]: [f64; 3]| {
        format!(
            "{{\"mean\":{{\"point_estimate\":7,\"standard_error\":0,\"confidence_interval\":{{\"confidence_level\":0.95,\
             \"lower_bound\":7,\"upper_bound\":7}}}},\"median\":{{\"point_estimate\":{point},\"standard_error\":0.1,\
             \"confidence_interval\":{{\"confidence_level\":0.95,\"lower_bound\":{low},\"upper_bound\":{high}}}}}}}"
        )
    };
    let put = |file: &str, text: String| {
        let path = root.join(folder).join(file);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    };
    put("new/benchmark.json", format!("{{\"group_id\":\"g\",\"full_id\":\"{name}\",\"throughput\":null}}"));
    put("new/estimates.json", estimates([now, now, now]));
    put("base/estimates.json", estimates([now, now, now]));
    if let Some(change) = change {
        put("change/estimates.json", estimates(change));
    }
}

fn samples(root: &Path) {
    write(root, "load/bunny", "load/bunny", 2e6, Some([0.01, -0.02, 0.03]));
    write(root, "extract/brute-force/blob_1", "extract/brute-force/blob:1", 1500.0, Some([0.5, 0.4, 0.6]));
    write(root, "extract/simd/blob_1", "extract/simd/blob:1", 80.0, Some([-0.2, -0.3, -0.1]));
    write(root, "extract/new/blob_1", "extract/new/blob:1", 80.0, None);
    fs::create_dir_all(root.join("report")).unwrap();
    fs::write(root.join("report/index.html"), "criterion's own").unwrap();
}

#[test]
fn the_largest_slow_down_comes_first_and_sure_changes_are_marked() {
    let folder = tempfile::tempdir().unwrap();
    samples(folder.path());
    let text = table(&read(folder.path()).unwrap(), &[]);
    let rows: Vec<Vec<&str>> = text.lines().map(|line| line.split_whitespace().collect()).collect();
    assert_eq!(
        rows[1],
        ["extract/brute-force/blob:1", "1.00", "us", "1.50", "us", "1.500", "1.400", "to", "1.600", "slower"]
    );
    assert_eq!(rows[2], ["load/bunny", "1.98", "ms", "2.00", "ms", "1.010", "0.980", "to", "1.030"]);
    assert_eq!(
        rows[3],
        ["extract/simd/blob:1", "100.00", "ns", "80.00", "ns", "0.800", "0.700", "to", "0.900", "faster"]
    );
    assert_eq!(text.lines().last(), Some("3 compared: 1 slower, 1 faster; 1 ran once"));
    assert_eq!(rows.len(), 5);
}

#[test]
fn filters_choose_by_name() {
    let folder = tempfile::tempdir().unwrap();
    samples(folder.path());
    let found = read(folder.path()).unwrap();
    let count = |filters: &[&str]| {
        let filters: Vec<String> = filters.iter().map(|&filter| filter.to_owned()).collect();
        table(&found, &filters).lines().count() - 2
    };
    assert_eq!([count(&[]), count(&["extract"]), count(&["load", "simd"]), count(&["none"])], [3, 2, 2, 0]);
}

#[test]
fn an_interval_that_holds_1_is_no_change_and_a_change_of_sign_is_seen() {
    let ratio = |median, interval| Ratio { median, interval };
    assert_eq!(mark(ratio(1.3, [0.999, 1.9])), "");
    assert_eq!(mark(ratio(1.3, [1.0, 1.9])), "", "its end is 1 itself");
    assert_eq!(mark(ratio(1.3, [1.001, 1.9])), "slower");
    assert_eq!(mark(ratio(0.7, [0.5, 0.999])), "faster");
    let change = |name: &str, median: f64| Change {
        name: name.to_owned(),
        now_ns: 1.0,
        ratio: Some(ratio(median, [median, median])),
    };
    let first =
        |one: f64, other: f64| table(&[change("a", one), change("b", other)], &[]).lines().nth(1).map(str::to_owned);
    assert!(first(1.2, 0.8).unwrap().starts_with("a ") && first(0.8, 1.2).unwrap().starts_with("b "));
}

#[test]
fn what_criterion_did_not_write_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let missing = read(&folder.path().join("none")).unwrap_err().to_string();
    assert!(missing.contains("none: ") && missing.contains("cargo bench"), "{missing}");
    samples(folder.path());
    fs::write(folder.path().join("load/bunny/change/estimates.json"), "{\"median\":").unwrap();
    let broken = read(folder.path()).unwrap_err().to_string();
    assert!(broken.contains("load/bunny/change/estimates.json"), "{broken}");
}
