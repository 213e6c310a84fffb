// What follows from an answer in each state of a search for borders. Twin: crates/texture/src/border_search.rs

#import "texture/border_states.wgsl"
#import "texture/expected_borders.wgsl"

// The state after an answer.
fn answer(probe: Probe) {
    let is_alike = is_shown(probe) == is_shown(search.last);
    switch search.state {
        case BEGINNING: { begin(probe); }
        case LOW: {
            search.low = probe;
            search.high = probe;
            if is_alike { ask(HIGH, min(guesses[search.next] + search.width, search.limit)); } else { widen(EARLIER, -1.0); }
        }
        case EARLIER: {
            if is_alike {
                search.low = probe;
                begin_alike(probe.angle);
            } else {
                search.high = probe;
                widen(EARLIER, -1.0);
            }
        }
        case HIGH: {
            if !is_alike {
                search.high = probe;
                begin_alike(search.low.angle);
            } else if probe.angle >= search.limit {
                begin_scan();
            } else {
                search.low = probe;
                widen(HIGH, 1.0);
            }
        }
        case ALIKE: {
            if is_alike { ask_alike(); } else { begin_scan(); }
        }
        case BISECTING: {
            if is_shown(probe) == is_shown(search.low) { search.low = probe; } else { search.high = probe; }
            ask_middle();
        }
        case AT_END: {
            search.beyond = probe;
            if is_alike { begin_alike(search.end); } else { begin_scan(); }
        }
        default: {
            search.low = search.last;
            search.high = probe;
            if is_alike {
                search.last = probe;
                ask_step_of_scan();
            } else {
                begin_bisecting();
            }
        }
    }
}

// The state before any answer; `middle` is how far away the object is shown at angle 0.
fn start_search(span: Span, middle: f32) {
    let margin = settings.tolerance * 0.5;
    search.grazed = HIDDEN;
    search.last = Probe(-1.0, HIDDEN);
    search.end = span.end - margin;
    if span.end - span.start <= settings.tolerance {
        search.state = DONE;
    } else if span.start > 0.0 {
        ask(BEGINNING, span.start + margin);
    } else {
        begin(Probe(0.0, middle));
    }
}

// With what is known where the span begins.
fn begin(first: Probe) {
    search.first = first;
    search.last = first;
    is_shown_first = is_shown(first);
    if expect_borders() {
        ask_guess();
    } else {
        begin_scan();
    }
}
