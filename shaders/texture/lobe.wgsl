// Where the object is shown along a meridian, and the angle that stands for it. Twin: crates/texture/src/lobe.rs

const HALF_TURN: f32 = 3.14159265;
const MOST_BORDERS: u32 = 6u;
// Borders that a scan can find: one per step.
const BORDER_ROOM: u32 = 66u;

const EQUAL_AREA: u32 = 0u;
const LAST_EXIT: u32 = 1u;

// The borders of the meridian that is searched, ascending, in radians.
var<private> borders: array<f32, BORDER_ROOM>;
var<private> border_count: u32;
var<private> is_shown_first: bool;

struct Span {
    start: f32,
    end: f32,
}

// Devices may be wrong by 4096 units in the last place in `atan2` (and in `asin`, which is not used for that reason): more than
// borders are. Two numbers of which one is not 0; followed by a step of Newton's.
fn precise_atan2(y: f32, x: f32) -> f32 {
    let angle = atan2(y, x);
    return angle + (y * cos(angle) - x * sin(angle)) / (x * x + y * y);
}

// The angles at which directions enter a face, from the parts of its normal along the centre and across it.
fn span_of(along: f32, aside: f32) -> Span {
    if along < 0.0 {
        return Span(0.0, precise_atan2(-along, aside));
    }
    if along == 0.0 && aside == 0.0 {
        return Span(HALF_TURN, HALF_TURN);
    }
    return Span(clamp(precise_atan2(along, -aside), 0.0, HALF_TURN), HALF_TURN);
}

fn push_border(angle: f32) {
    if border_count < BORDER_ROOM {
        borders[border_count] = angle;
        border_count += 1u;
    }
}

// Leaves out the narrowest parts until `MOST_BORDERS` are left.
fn thin_borders() {
    while border_count > MOST_BORDERS {
        var narrowest = 0u;
        var width = borders[1] - borders[0];
        for (var at = 1u; at + 1u < border_count; at += 1u) {
            let other = borders[at + 1u] - borders[at];
            narrowest = select(narrowest, at, other < width);
            width = min(width, other);
        }
        border_count -= 2u;
        for (var at = narrowest; at < border_count; at += 1u) {
            borders[at] = borders[at + 2u];
        }
    }
}

fn end_of_part(index: u32, span: Span) -> f32 {
    if index == 0u {
        return span.start;
    }
    if index > border_count {
        return span.end;
    }
    return borders[index - 1u];
}

// Half of 1 - cos, without cancellation.
fn half_versine(angle: f32) -> f32 {
    let sine = sin(angle * 0.5);
    return sine * sine;
}

// The angle of the lobe's border, in radians.
fn lobe_angle(span: Span) -> f32 {
    var area = 0.0;
    var last = 0.0;
    var first = 0.0;
    let start_index = select(1u, 0u, is_shown_first);
    for (var index = start_index; index <= border_count; index += 2u) {
        let start = end_of_part(index, span);
        let end = end_of_part(index + 1u, span);
        area += half_versine(end) - half_versine(start);
        last = end;
        first = select(first, end, index == start_index && start <= 0.0);
    }
    if settings.lobe_rule == EQUAL_AREA {
        let share = clamp(area, 0.0, 1.0);
        return 2.0 * precise_atan2(sqrt(share), sqrt(1.0 - share));
    }
    return select(first, last, settings.lobe_rule == LAST_EXIT);
}
