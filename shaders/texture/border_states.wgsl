// The states of a search for borders: which angle is asked for next, and what follows from the answer. One answer per turn, so
// that rays are cast at a single place and invocations stay together. Twin: crates/texture/src/border_search.rs

const SCAN_STEP: f32 = HALF_TURN / 64.0;
const PROBE_STEP: f32 = HALF_TURN / 8.0;

const DONE: u32 = 0u;
const BEGINNING: u32 = 1u;
// Towards the border, from below and from above.
const LOW: u32 = 2u;
const EARLIER: u32 = 3u;
const HIGH: u32 = 4u;
// Between borders.
const ALIKE: u32 = 5u;
const BISECTING: u32 = 6u;
const AT_END: u32 = 7u;
const SCANNING: u32 = 8u;

struct Probe {
    angle: f32,
    // `HIDDEN` where the object is not shown.
    distance: f32,
}

struct Search {
    state: u32,
    is_scan: bool,
    // The angle that is asked for; at or below `last`, the answer is `last`.
    asked: f32,
    first: Probe,
    end: f32,
    // The last that is known before the next border.
    last: Probe,
    low: Probe,
    high: Probe,
    // Where the search goes on after the border.
    beyond: Probe,
    // Steps of equal size from `last`, or of a scan from `first`, to `goal`.
    step: f32,
    step_count: f32,
    goal: f32,
    // Which border is expected next, where the one after it begins to matter, and how far from it to look.
    next: u32,
    limit: f32,
    width: f32,
    scans: u32,
    grazed: f32,
}

var<private> search: Search;
// The borders that are expected, ascending.
var<private> guesses: array<f32, MOST_BORDERS>;
var<private> guess_count: u32;
var<private> slack: f32;

fn is_shown(probe: Probe) -> bool {
    return probe.distance >= 0.0;
}

fn ask(state: u32, angle: f32) {
    search.state = state;
    search.asked = angle;
}

fn graze(probe: Probe) {
    search.grazed = select(search.grazed, probe.distance, is_shown(probe));
}

fn ask_guess() {
    if search.next < guess_count {
        let guess = guesses[search.next];
        let is_last = search.next + 1u == guess_count;
        search.limit = search.end;
        if !is_last {
            search.limit = (guess + guesses[search.next + 1u]) * 0.5;
        }
        search.width = slack;
        ask(LOW, min(guess - slack, search.limit));
    } else {
        ask(AT_END, search.end);
    }
}

fn widen(state: u32, side: f32) {
    search.width *= 2.0;
    ask(state, min(guesses[search.next] + side * search.width, search.limit));
}

fn begin_scan() {
    search.is_scan = true;
    search.scans += 1u;
    border_count = 0u;
    search.last = search.first;
    search.step_count = max(ceil((search.end - search.first.angle) / SCAN_STEP), 1.0);
    search.step = 0.0;
    ask_step_of_scan();
}

fn ask_step_of_scan() {
    search.step += 1.0;
    if search.step > search.step_count {
        graze(search.last);
        search.state = DONE;
    } else {
        ask(SCANNING, search.first.angle + (search.end - search.first.angle) * (search.step / search.step_count));
    }
}

// Whether angles from `last` to `goal` are alike, before what lies at the goal is believed.
fn begin_alike(goal: f32) {
    search.goal = goal;
    search.step_count = max(ceil((goal - search.last.angle) / PROBE_STEP), 1.0);
    search.step = 0.0;
    ask_alike();
}

fn ask_alike() {
    search.step += 1.0;
    if search.step < search.step_count {
        ask(ALIKE, search.last.angle + (search.goal - search.last.angle) * (search.step / search.step_count));
    } else if search.next < guess_count {
        begin_bisecting();
    } else {
        graze(search.beyond);
        search.state = DONE;
    }
}

fn begin_bisecting() {
    search.beyond = search.high;
    ask_middle();
}

fn ask_middle() {
    if search.high.angle - search.low.angle > settings.tolerance {
        ask(BISECTING, (search.low.angle + search.high.angle) * 0.5);
        return;
    }
    push_border((search.low.angle + search.high.angle) * 0.5);
    graze(search.low);
    search.last = search.beyond;
    if search.is_scan {
        ask_step_of_scan();
    } else {
        search.next += 1u;
        ask_guess();
    }
}
