//! The whole procedure on meters whose truth is known, and on real ones.

use super::candidates::Candidate;
use super::meter::{Fault, Meter, Preparation, Sample};
use super::promise::SHARE;
use super::recommendation::Reason;
use super::text::text;
use super::views::{Purpose, ViewId};
use super::*;
use crate::cost::PrepareCost;
use crate::record::ArtefactRecord;
use crate::registry::{Entry, Registry};
use crate::runner::NamedMesh;
use crate::scene::Profile;
use silhouette_core::{NoProgress, PreparedMesh, shapes};
use silhouette_testing::gpu_or_skip;
use silhouette_testing::random::Random;
use std::sync::Arc;

/// A candidate as it really is.
#[derive(Clone, Copy)]
struct Truth {
    /// Usual time of a view.
    ms: f64,
    /// Usual error.
    error: f64,
    /// Share of views in which time and error are ten times that.
    bad: f64,
    /// Seconds to prepare it; not finite where it is refused.
    prepare_s: f64,
}

impl Truth {
    const fn new(ms: f64, error: f64) -> Self {
        Self { ms, error, bad: 0.0, prepare_s: 0.01 }
    }
}

/// What a calibration reports in place of what it measured: the model of costs that is to be caught where it is wrong.
#[derive(Clone, Copy)]
struct Model {
    ms: f64,
    error: f64,
}

const RIGHT: Model = Model { ms: 1.0, error: 1.0 };

/// A meter of known candidates, with a clock of its own.
struct Simulated {
    truths: Vec<Truth>,
    model: Model,
    seed: u64,
    /// Seconds that measuring a view takes.
    view_s: f64,
    clock_s: f64,
    prepared: Option<usize>,
}

impl Simulated {
    fn new(truths: &[Truth]) -> Self {
        Self { truths: truths.to_vec(), model: RIGHT, seed: 0, view_s: 0.02, clock_s: 0.0, prepared: None }
    }
}

impl Meter for Simulated {
    fn prepare(&mut self, candidate: usize, until_s: f64) -> Result<Preparation, Fault> {
        let Truth { prepare_s, .. } = self.truths[candidate];
        if !prepare_s.is_finite() {
            return Err(Fault::Refused("it is one-sided".to_owned()));
        }
        if self.clock_s + prepare_s > until_s {
            self.clock_s = self.clock_s.max(until_s);
            return Err(Fault::OutOfTime);
        }
        self.clock_s += prepare_s;
        self.prepared = Some(candidate);
        let cost = PrepareCost { prepare_ms: prepare_s * 1000.0, renderer_ms: 0.0, bytes: 30 };
        let artefact = ArtefactRecord { name: "topology".to_owned(), bytes: 20 };
        Ok(Preparation { cost, artefacts: vec![artefact], own_bytes: 10 })
    }

    fn sample(&mut self, candidate: usize, view: ViewId, _until_s: f64) -> Result<Sample, Fault> {
        assert_eq!(self.prepared, Some(candidate), "it is prepared first");
        self.clock_s += self.view_s;
        let Truth { ms, error, bad, .. } = self.truths[candidate];
        let stream = self.seed << 32 | (candidate as u64) << 24 | (view.purpose as u64) << 20 | u64::from(view.index);
        let mut random = Random::new(stream);
        let factor = if random.unit() < bad { 10.0 } else { 0.9 + 0.1 * random.unit() };
        let model = if view.purpose == Purpose::Check { RIGHT } else { self.model };
        let error = error * factor * model.error;
        Ok(Sample { ms: ms * factor * model.ms, errors: vec![error; Goal::Loops.metrics().len()] })
    }

    fn elapsed_s(&self) -> f64 {
        self.clock_s
    }
}

/// Candidates to go with simulated ones: their names are all that counts.
fn named(count: usize) -> Vec<Candidate> {
    let all = candidates(Goal::Loops, &Registry::builtin());
    let defaults: Vec<Candidate> = all.into_iter().filter(|candidate| candidate.changed.is_none()).collect();
    defaults[..count].to_vec()
}

fn request(max_error: f64, max_ms: Option<f64>) -> Request {
    let limit = ErrorLimit { metric: "differing_edges".to_owned(), max: max_error };
    Request { max_ms, ..Request::limited(Goal::Loops, limit).unwrap() }
}

/// Calibrates anew, and checks in 200 views.
fn answer(meter: &mut Simulated, request: &Request) -> (Recommendation, Option<Check>) {
    let candidates = named(meter.truths.len());
    let mut notebook = Notebook::default().arranged(&candidates);
    let mut measurer = Measurer::new(meter, &mut notebook);
    let found = recommend(&mut measurer, request, &candidates).unwrap();
    let check = check(&mut measurer, &found, 200).unwrap();
    (found, check)
}

/// The candidate's number of a finding.
fn number(finding: Option<&Finding>) -> Option<usize> {
    finding.map(|finding| finding.candidate)
}

#[test]
fn the_fastest_within_both_limits_is_promised_with_its_runner_up_and_the_next_step() {
    // Too wrong, too slow, right, the next one, and a more exact one.
    let truths =
        [(1.0, 0.9), (9.0, 0.01), (3.0, 0.1), (4.0, 0.1), (5.0, 0.02)].map(|(ms, error)| Truth::new(ms, error));
    let mut meter = Simulated::new(&truths);
    let (found, check) = answer(&mut meter, &request(0.2, Some(8.0)));
    assert_eq!([&found.chosen, &found.runner_up].map(|finding| number(finding.as_ref())), [Some(2), Some(3)]);
    let better = found.one_step_better.as_ref().unwrap();
    assert_eq!((better.better.candidate, better.choice.candidate), (4, 2));
    assert!(better.better.worst_error < 0.5 * better.choice.worst_error);
    let promise = found.chosen.as_ref().unwrap().promise.unwrap();
    assert_eq!((promise.views, promise.over), (124, 0));
    assert!(promise.confidence > 0.99 && promise.measured_error <= 0.1 && promise.measured_ms <= 3.0, "{promise:?}");
    let check = check.unwrap();
    assert!(check.is_kept() && check.within_both == 200, "{check:?}");
    let text = text(&found, "torus", Some(&check));
    for part in [
        "torus: loops with differing edges of at most 20 % in at most 8 ms",
        "99 % confidence",
        "124 of 124",
        "topology 20 bytes, the method's own data 10 bytes",
        "runner-up",
        "one better",
        "the promise is kept in 200",
    ] {
        assert!(text.contains(part), "{part}:\n{text}");
    }
}

#[test]
fn a_broken_model_of_costs_is_caught_by_the_check() {
    let truths = [Truth::new(5.0, 0.1), Truth::new(1.0, 0.3)];
    // Times a tenth of what they are: the slow one seems to keep to 2 ms.
    let tests =
        [(Model { ms: 0.1, error: 1.0 }, request(0.2, Some(2.0))), (Model { ms: 1.0, error: 0.5 }, request(0.2, None))];
    for (model, request) in tests {
        let (found, check) = answer(&mut Simulated { model, ..Simulated::new(&truths) }, &request);
        let check = check.expect("it recommends something");
        assert!(!check.is_kept() && check.within_both == 0, "{check:?}");
        assert_eq!(check.within_error == 0, model.error < 1.0, "{check:?}");
        let text = text(&found, "torus", Some(&check));
        assert!(text.contains("the promise is broken in 200 other views"), "{text}");
        // The right model promises nothing that it does not keep.
        let (_, check) = answer(&mut Simulated::new(&truths), &request);
        assert!(check.is_none_or(|check| check.is_kept()), "{check:?}");
    }
    // Without a limit, the time that is promised is the measured one, and as wrong.
    let (_, check) =
        answer(&mut Simulated { model: Model { ms: 0.1, error: 1.0 }, ..Simulated::new(&truths) }, &request(0.2, None));
    assert_eq!(check.map(|check| (check.within_error, check.within_ms)), Some((200, 0)));
}

/// A candidate whose views exceed the limits just more often than promised is promised once in twenty calibrations at most.
#[test]
fn what_does_not_hold_is_hardly_ever_promised() {
    let bad = Truth { bad: 1.0 - SHARE + 0.001, ..Truth::new(1.0, 0.1) };
    let mut promised = 0_u32;
    for seed in 0..2000 {
        let (found, _) = answer(&mut Simulated { seed, ..Simulated::new(&[bad]) }, &request(0.2, None));
        promised += u32::from(found.chosen.is_some());
    }
    // Five percent, and three deviations of 2000 draws. Views of the race save it now and then from being examined.
    assert!(promised < 100 + 30, "{promised}");
    assert!(promised > 20, "an examination that nothing passes proves nothing: {promised}");
}

#[test]
fn a_candidate_that_fails_its_examination_gives_way_to_the_next() {
    let bad = Truth { bad: 0.2, ..Truth::new(1.0, 0.1) };
    let mut failed = 0;
    for seed in 0..50 {
        let mut meter = Simulated { seed, ..Simulated::new(&[bad, Truth::new(2.0, 0.1)]) };
        let (found, check) = answer(&mut meter, &request(0.2, Some(4.0)));
        assert_eq!(number(found.chosen.as_ref()), Some(1));
        assert!(check.unwrap().is_kept());
        if let Some(examined) = found.failed.first() {
            failed += 1;
            assert_eq!(examined.candidate, 0);
            let confidence = found.chosen.unwrap().promise.unwrap().confidence;
            let alone = promise::confidence(124, 0, 1);
            assert!(confidence < alone && confidence > 0.9, "two were examined: {confidence}");
        }
    }
    assert!(failed > 5, "some pass the race: {failed}");
}

#[test]
fn where_nothing_fits_the_nearest_are_named() {
    let truths = [(1.0, 0.9), (2.0, 0.5), (9.0, 0.1), (12.0, 0.1)].map(|(ms, error)| Truth::new(ms, error));
    let (found, check) = answer(&mut Simulated::new(&truths), &request(0.2, Some(4.0)));
    assert_eq!((&found.chosen, check), (&None, None));
    let nearest = [&found.least_error_in_time, &found.fastest_within_error].map(|finding| number(finding.as_ref()));
    assert_eq!(nearest, [Some(1), Some(2)]);
    let text = text(&found, "torus", None);
    assert!(text.contains("nothing fits") && text.contains("the least error in the time"), "{text}");
    // And where no error is small enough, nothing is named for it.
    let (found, _) = answer(&mut Simulated::new(&truths), &request(0.01, Some(4.0)));
    assert_eq!(number(found.fastest_within_error.as_ref()), None);
}

#[test]
fn the_calibration_keeps_to_its_time_and_says_what_it_left_out() {
    let slow = Truth { prepare_s: 500.0, ..Truth::new(0.1, 0.0) };
    let refused = Truth { prepare_s: f64::INFINITY, ..Truth::new(0.1, 0.0) };
    let middling = Truth { prepare_s: 1.5, ..Truth::new(1.0, 0.1) };
    let truths = [slow, refused, Truth::new(2.0, 0.1), middling];
    for seconds in [20.0, 5.0, 2.0] {
        let mut meter = Simulated { view_s: 0.05, ..Simulated::new(&truths) };
        let (found, _) = answer(&mut meter, &Request { seconds, ..request(0.2, None) });
        assert!(found.seconds <= seconds + 0.05, "{} of {seconds}", found.seconds);
        let reason = |candidate: usize| {
            let method = named(4)[candidate].method();
            found.not_measured.iter().find(|left_out| left_out.method == method).map(|left_out| left_out.reason.clone())
        };
        assert_eq!(reason(0), Some(Reason::SlowPreparation));
        assert_eq!(reason(1), Some(Reason::Refused("it is one-sided".to_owned())));
        // Its preparation takes longer than half a second of 20, and is taken up again in the end.
        assert_eq!(reason(3).is_none(), seconds > 15.0 - 1e-9, "{seconds}");
        let text = text(&found, "torus", None);
        assert!(text.contains("not tried") && text.contains("it is one-sided"), "{text}");
        // Fewer views are worth less, and the promise says so.
        let promise = found.chosen.unwrap().promise.unwrap();
        assert_eq!(promise.views == 124, seconds > 10.0, "{promise:?}");
        assert!((promise.confidence > 0.95) == (promise.views >= 59), "{promise:?}");
    }
    // Not even a view of the race.
    let (found, _) = answer(&mut Simulated::new(&[slow]), &request(0.2, None));
    assert!(found.measured.is_empty() && text(&found, "torus", None).contains("no method was measured"));
    // Few views to examine, or not even one: a choice without a promise.
    for view_s in [0.5, 6.0] {
        let mut meter = Simulated { view_s, ..Simulated::new(&[Truth::new(1.0, 0.1); 2]) };
        let (found, check) = answer(&mut meter, &Request { seconds: 5.0, ..request(0.2, None) });
        assert!(text(&found, "torus", None).contains("none, for lack of views"));
        assert!(found.chosen.is_some_and(|chosen| chosen.promise.is_none()) && check.is_none());
    }
}

#[test]
fn the_time_of_examinations_goes_to_the_options_while_nobody_keeps_the_limits() {
    let candidates = candidates(Goal::Loops, &Registry::builtin());
    let last = candidates.iter().rposition(|candidate| candidate.changed.is_some()).unwrap();
    // All views of the race take 0.7 of the time. Who does not keep the limits is near enough not to be dropped.
    let measured = |kept: &[usize]| {
        let error = |candidate| if kept.contains(&candidate) { 0.1 } else { 0.3 };
        let truths: Vec<Truth> = (0..candidates.len()).map(|candidate| Truth::new(1.0, error(candidate))).collect();
        let view_s = 20.0 * 0.7 / (race::VIEWS as usize * candidates.len()) as f64;
        let mut meter = Simulated { view_s, ..Simulated::new(&truths) };
        let mut notebook = Notebook::default().arranged(&candidates);
        let found = recommend(&mut Measurer::new(&mut meter, &mut notebook), &request(0.2, None), &candidates).unwrap();
        assert!(found.seconds <= 20.0 + 2.0 * view_s, "{}", found.seconds);
        (number(found.chosen.as_ref()), found.measured.iter().any(|finding| finding.candidate == last))
    };
    assert_eq!(measured(&[last]), (Some(last), true));
    assert_eq!(measured(&[0]), (Some(0), false), "where the first keeps them, it is examined instead");
}

#[test]
fn a_question_asked_again_is_answered_alike_from_the_notebook() {
    let truths = [Truth::new(1.0, 0.3), Truth::new(2.0, 0.1), Truth::new(3.0, 0.02)];
    let candidates = named(3);
    let mut notebook = Notebook::default().arranged(&candidates);
    let mut ask = |request: &Request| {
        let mut meter = Simulated { view_s: 0.1, ..Simulated::new(&truths) };
        let found = recommend(&mut Measurer::new(&mut meter, &mut notebook), request, &candidates).unwrap();
        (found.clone(), Recommendation { seconds: 0.0, views_measured: 0, ..found })
    };
    let (first, answer) = ask(&request(0.2, None));
    let (second, again) = ask(&request(0.2, None));
    assert_eq!((again, second.views_measured, second.seconds.to_bits()), (answer, 0, 0.0_f64.to_bits()));
    assert!(text(&second, "torus", None).contains("cached"));
    // Another limit finds the views of the race there, and examines another candidate.
    let (other, _) = ask(&request(0.05, None));
    assert_eq!([&first, &other].map(|found| number(found.chosen.as_ref())), [Some(1), Some(2)]);
    assert!(other.views_measured > 0 && other.views_measured < first.views_measured, "{}", other.views_measured);
}

fn mesh(shape: &str) -> NamedMesh {
    NamedMesh { name: shape.to_owned(), mesh: Arc::new(PreparedMesh::new(shapes::by_name(shape).unwrap())) }
}

fn small() -> Setting {
    Setting { size: [96, 96], ..Setting::from(&Profile::Quick.scene()) }
}

fn alone(name: &str, words: &[&str]) -> Vec<Candidate> {
    let registry = Registry::builtin();
    let entry = registry.find(name).unwrap().clone();
    let options = silhouette_core::method::OptionValues::parse(entry.info().options, words.iter().copied()).unwrap();
    vec![Candidate { entry, options, changed: None }]
}

/// The errors of a candidate in some views, by metric and view.
fn errors<M: Meter>(meter: &mut M, views: u32) -> Vec<Vec<f64>> {
    meter.prepare(0, f64::INFINITY).map_err(|fault| format!("{fault:?}")).unwrap();
    let view = |index| ViewId { purpose: Purpose::Choice, index };
    (0..views).map(|index| meter.sample(0, view(index), f64::INFINITY).unwrap().errors).collect()
}

/// Exact extractors differ in nothing; a tracker that searches few edges for new loops loses some on its way to a view.
#[test]
fn loops_are_judged_after_the_run_up() {
    let blob = mesh("blob:5000");
    let of = |name: &str, words: &[&str]| {
        let candidates = alone(name, words);
        let mut meter = LoopMeter::new(&blob, &candidates, small(), &NoProgress).unwrap();
        errors(&mut meter, 20)
    };
    assert!(of("tracking-exact", &[]).iter().flatten().all(|&error| error.to_bits() == 0));
    let lossy = of("tracking", &["concavity=1.6"]);
    let means = [0, 1, 2].map(|metric| lossy.iter().map(|errors| errors[metric]).sum::<f64>() / 20.0);
    assert!(means[1] > 0.001 && means[2] < 1e-12 && means[0] >= means[1], "{means:?}");
}

#[test]
fn pictures_are_judged_by_the_metrics_of_their_goal() {
    let Some(gpu) = gpu_or_skip("pictures_are_judged_by_the_metrics_of_their_goal") else { return };
    let [torus, ball] = ["torus", "icosphere:1"].map(mesh);
    let of = |goal: Goal, name: &str, words: &[&str]| {
        let candidates = alone(name, words);
        let shape = if goal == Goal::Lines { &torus } else { &ball };
        let meter = PictureMeter::new(shape, goal, &candidates, small(), gpu, &NoProgress);
        let found = errors(&mut meter.unwrap().unwrap(), 3);
        let place = goal.default_limit().place(goal).unwrap();
        assert!(found.iter().all(|errors| errors.len() == goal.metrics().len()));
        found.iter().map(|errors| errors[place]).fold(0.0, f64::max)
    };
    let exact = of(Goal::Lines, "brute-force-simd", &[]);
    let wide = of(Goal::Lines, "jump-flood", &["width=6"]);
    assert!(exact < 0.2 && wide > exact + 0.5, "{exact} {wide}");
    // A ball of few faces is not the round ball that smoothing makes of it.
    let [fine, round] = ["fine-mesh", "pn-triangles"].map(|name| of(Goal::Fill, name, &[]));
    assert!((0.0..0.3).contains(&fine) && round > fine + 0.5, "{fine} {round}");
    assert!(PictureMeter::new(&torus, Goal::Loops, &[], small(), gpu, &NoProgress).unwrap().is_none());
}

/// What a method of another crate can do decides, not where it comes from.
#[test]
fn a_registered_method_is_recommended_like_any_other() {
    let registry = Registry::default().with(Entry::of::<silhouette_extraction::BruteForce>().loops());
    let candidates = candidates(Goal::Loops, &registry);
    let torus = mesh("torus");
    let mut meter = LoopMeter::new(&torus, &candidates, small(), &NoProgress).unwrap();
    let mut notebook = Notebook::default().arranged(&candidates);
    let mut measurer = Measurer::new(&mut meter, &mut notebook);
    let found = recommend(&mut measurer, &Request::new(Goal::Loops), &candidates).unwrap();
    let chosen = found.chosen.as_ref().unwrap();
    assert_eq!((chosen.method.as_str(), &found.runner_up, &found.one_step_better), ("brute-force", &None, &None));
    let made = chosen.preparation.as_ref().unwrap();
    assert_eq!(made.artefacts.iter().map(|artefact| artefact.name.as_str()).collect::<Vec<_>>(), ["topology"]);
    assert_eq!(made.cost.bytes, made.own_bytes + made.artefacts[0].bytes);
    assert!(measurer.count() == 1 && check(&mut measurer, &found, 10).unwrap().unwrap().within_error == 10);
}
