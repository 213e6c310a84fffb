//! [`Recommendation`] as text: the answer first, then what it rests on.

use super::Goal;
use super::check::Check;
use super::promise::{CONFIDENCE, SHARE};
use super::recommendation::{Better, Finding, NotMeasured, Promise, Reason, Recommendation};
use std::collections::BTreeMap;
use std::fmt::Write;

/// The answer for people, several lines. `mesh` is its name.
pub fn text(found: &Recommendation, mesh: &str, check: Option<&Check>) -> String {
    let mut text = format!("{mesh}: {} {}\n", found.request.goal.name(), limits(found));
    match &found.chosen {
        Some(chosen) => {
            let is_exact = chosen.exact && found.request.goal == Goal::Loops;
            let note = if is_exact { ", which is exact: all silhouette edges and no others in every view" } else { "" };
            row(&mut text, "use", &format!("{}{note}", name(chosen)));
            let none = || format!("none, for lack of views: {}; --seconds gives more", seen(chosen, found));
            row(&mut text, "promise", &chosen.promise.as_ref().map_or_else(none, |promise| promised(promise, found)));
            row(&mut text, "costs", &costs(chosen, found));
            row(&mut text, "builds", &builds(chosen));
        }
        None => nothing_fits(&mut text, found),
    }
    runner_up(&mut text, found);
    better(&mut text, found);
    for failed in &found.failed {
        row(
            &mut text,
            "examined",
            &format!("{}, which did not keep to the limits: {}", name(failed), seen(failed, found)),
        );
    }
    not_measured(&mut text, &found.not_measured);
    if !found.measured.is_empty() {
        row(&mut text, "measured", &measured(found));
    }
    if let Some(check) = check {
        row(&mut text, "check", &checked(check, found));
    }
    text
}

fn row(text: &mut String, label: &str, value: &str) {
    let _ = writeln!(text, "  {label:<11} {value}");
}

fn limits(found: &Recommendation) -> String {
    let metric = found.request.error();
    let error = format!("with {} of at most {}", metric.title, number(found.request.limit.max, metric.unit));
    match found.request.max_ms {
        Some(max_ms) => format!("{error} in at most {max_ms} ms per {}", found.unit_of_work()),
        None => error,
    }
}

/// The method with what is set.
fn name(finding: &Finding) -> String {
    match &finding.set {
        Some(set) => format!("{} --set {set}", finding.method),
        None => finding.method.clone(),
    }
}

fn promised(promise: &Promise, found: &Recommendation) -> String {
    let unit = found.request.error().unit;
    let Promise { views, over, confidence, measured_error, measured_ms, .. } = promise;
    let kept = views - over;
    let share = SHARE * 100.0;
    let more = if *confidence < CONFIDENCE { "; --seconds gives more views and confidence" } else { "" };
    format!(
        "kept in at least {share} % of views, with {:.0} % confidence: it was in {kept} of {views} views drawn after the choice; in \
         {share} % of them error {} and {} ms at most{more}",
        (confidence * 100.0).floor(),
        number(*measured_error, unit),
        rounded(*measured_ms)
    )
}

fn costs(finding: &Finding, found: &Recommendation) -> String {
    format!("{} ms per {} (median), {} ms once", rounded(finding.ms), found.unit_of_work(), rounded(once_ms(finding)))
}

/// Milliseconds until it can draw.
fn once_ms(finding: &Finding) -> f64 {
    finding.preparation.as_ref().map_or(0.0, |made| made.cost.prepare_ms + made.cost.renderer_ms)
}

fn builds(finding: &Finding) -> String {
    let Some(made) = &finding.preparation else { return "unknown".to_owned() };
    let mut parts: Vec<String> =
        made.artefacts.iter().map(|artefact| format!("{} {} bytes", artefact.name, artefact.bytes)).collect();
    parts.push(format!("the method's own data {} bytes", made.own_bytes));
    format!("{} bytes in main memory: {}", made.cost.bytes, parts.join(", "))
}

/// What was measured of something.
fn seen(finding: &Finding, found: &Recommendation) -> String {
    let error = number(finding.worst_error, found.request.error().unit);
    format!("error {error} and {} ms at most in {}", rounded(finding.worst_ms), views(finding.views))
}

fn nothing_fits(text: &mut String, found: &Recommendation) {
    if found.measured.is_empty() {
        return row(text, "nothing", "no method was measured; --seconds gives more time");
    }
    row(text, "nothing fits", "no method that was measured keeps to the limits; what comes closest:");
    if let Some(least) = &found.least_error_in_time {
        row(text, "error", &format!("{}: the least error in the time: {}", name(least), seen(least, found)));
    }
    match &found.fastest_within_error {
        Some(fastest) => {
            let what = "the fastest within the error in the views that it was chosen by";
            row(text, "time", &format!("{}: {what}: {}", name(fastest), seen(fastest, found)));
        }
        None => row(text, "time", "no method that was measured keeps to the error"),
    }
}

/// The runner-up, its time beside that of the choice in the views that both were chosen by: what is measured later is measured on a
/// machine that may be busier.
fn runner_up(text: &mut String, found: &Recommendation) {
    let Some((other, chosen)) = found.runner_up.as_ref().zip(found.chosen.as_ref()) else { return };
    let in_race = |finding: &Finding| found.measured.iter().find(|raced| raced.candidate == finding.candidate);
    let times = in_race(other).zip(in_race(chosen)).map_or(f64::NAN, |(other, chosen)| other.ms / chosen.ms);
    let standing = match &other.promise {
        Some(promise) => format!("promised as well, by {}", views(promise.views)),
        None => format!("not promised: {}", seen(other, found)),
    };
    let once = rounded(once_ms(other));
    row(text, "runner-up", &format!("{}, {times:.2} times the time, {once} ms once; {standing}", name(other)));
}

fn better(text: &mut String, found: &Recommendation) {
    if found.chosen.is_none() {
        return;
    }
    let Some(Better { better, choice }) = &found.one_step_better else {
        return row(text, "one better", "nothing that was measured errs less");
    };
    let unit = found.request.error().unit;
    let [less, more] = [better, choice].map(|finding| number(finding.worst_error, unit));
    let times = better.ms / choice.ms.max(f64::MIN_POSITIVE);
    let (views, once) = (views(better.views), costs(better, found));
    let line =
        format!("{}: error {less} in place of {more} for {times:.1} times the time, in {views}; {once}", name(better));
    row(text, "one better", &line);
}

/// One row per reason, the methods of each in one list, and of options only their number.
fn not_measured(text: &mut String, all: &[NotMeasured]) {
    let mut by_reason: BTreeMap<&str, BTreeMap<&str, (bool, usize)>> = BTreeMap::new();
    for NotMeasured { method, set, reason } in all {
        let reason = match reason {
            // The method's defaults have a row.
            Reason::AsItsDefaults => continue,
            Reason::SlowPreparation => "preparing takes too long for the calibration; --seconds gives more",
            Reason::NoTime => "for lack of time; --seconds gives more",
            Reason::Refused(reason) => reason,
        };
        let (default, settings) = by_reason.entry(reason).or_default().entry(method).or_default();
        *default |= set.is_none();
        *settings += usize::from(set.is_some());
    }
    for (reason, methods) in by_reason {
        let name = |(method, (default, settings)): (&&str, &(bool, usize))| match (default, settings) {
            (true, _) => (*method).to_owned(),
            (false, 1) => format!("{method} with another setting"),
            (false, settings) => format!("{method} with {settings} other settings"),
        };
        let names: Vec<String> = methods.iter().map(name).collect();
        row(text, "not tried", &format!("{}: {reason}", names.join(", ")));
    }
}

fn measured(found: &Recommendation) -> String {
    let candidates = found.measured.len();
    let methods = if candidates == 1 { "method with its options" } else { "methods with options" };
    let what = format!("{candidates} {methods} in views from all around");
    match found.views_measured {
        0 => format!("{what}, all of them earlier (cached)"),
        count => format!("{what}: {} in {:.1} s", views(count), found.seconds),
    }
}

fn checked(check: &Check, found: &Recommendation) -> String {
    let Check { views, within_error, within_ms, within_both, worst_error, worst_ms } = check;
    let share = |within: &u32| format!("{:.1} %", 100.0 * f64::from(*within) / f64::from(*views));
    let verdict = match (check.is_kept(), check.is_refuted()) {
        (true, _) => "kept",
        (false, true) => "broken",
        (false, false) => "neither kept nor refuted",
    };
    let others = if *views == 1 { "1 other view".to_owned() } else { format!("{views} other views") };
    format!(
        "the promise is {verdict} in {others}: {} within the error (worst {}), {} within the time (worst {} ms), {} within both",
        share(within_error),
        number(*worst_error, found.request.error().unit),
        share(within_ms),
        rounded(*worst_ms),
        share(within_both)
    )
}

fn views(count: u32) -> String {
    if count == 1 { "1 view".to_owned() } else { format!("{count} views") }
}

/// A value with its unit, where that is one.
fn number(value: f64, unit: &str) -> String {
    match unit {
        "share" => format!("{} %", rounded(value * 100.0)),
        unit => format!("{} {unit}", rounded(value)),
    }
}

/// Three significant digits.
fn rounded(value: f64) -> String {
    let text: f64 = format!("{value:.2e}").parse().unwrap_or(value);
    text.to_string()
}

impl Recommendation {
    /// What a time is measured per.
    pub fn unit_of_work(&self) -> &'static str {
        match self.request.goal {
            Goal::Lines | Goal::Fill => "frame",
            Goal::Loops => "extraction",
        }
    }
}
