// Section III-D: on each side between a visible and an invisible vertex, the point at which the interpolated normal is
// perpendicular to the view. One invocation finds the point of a side that two faces share, so that both have the same.
// Twin: crates/smoothing/src/silhouette_points.rs

#import "shared/invocation.wgsl"
#import "smoothing/feature_curve.wgsl"
#import "smoothing/emerging_points.wgsl"

// An interpolated normal shorter than this has no direction.
const LEAST_NORMAL: f32 = 1e-6;

// A residual angle, in radians, that 32 bits do not improve.
const CONVERGED: f32 = 1e-7;

// The root of a function that is linear between two values of opposite signs.
fn linear_root(start: f32, end: f32) -> f32 {
    return select(0.5, clamp(start / (start - end), 0.0, 1.0), start != end);
}

// The root in [0, 1] of (1 - u)² a + u (1 - u) b + u² c, where a and c have opposite signs and an `a` of 0 counts as positive.
fn quadratic_root(a: f32, b: f32, c: f32) -> f32 {
    let size = max(max(abs(a), abs(b)), abs(c));
    if !(size > 0.0) {
        return 0.0;
    }
    let d = vec3<f32>(a, b, c) / size;
    let root = sqrt(max(d.y * d.y - 4.0 * d.x * d.z, 0.0));
    let q = -0.5 * (d.y + select(root, -root, d.y < 0.0));
    if q == 0.0 {
        return select(1.0, 0.0, a == 0.0);
    }
    let over = select(d.x, q, (q > 0.0) == (a < 0.0));
    let under = select(d.x + q, q + d.z, (q > 0.0) == (a < 0.0));
    return select(0.5, clamp(over / under, 0.0, 1.0), under != 0.0);
}

// Newton's method on (E - S(u)) . N(u), which is positive at 0 iff `begins_visible` and has the other sign at 1.
fn refined(start: f32, begins_visible: bool, n0: vec3<f32>, n1: vec3<f32>, curve: SideCurve) -> f32 {
    let turn = n1 - n0;
    var u = start;
    var low = 0.0;
    var high = 1.0;
    for (var step = 0u; step < settings.newton_steps; step++) {
        let toward = toward_viewer(side_point(curve, u));
        let normal = n0 + u * turn;
        let value = dot(toward, normal);
        if abs(value) <= CONVERGED * length(toward) {
            break;
        }
        if (value > 0.0) == begins_visible {
            low = u;
        } else {
            high = u;
        }
        let slope = dot(toward, turn) - dot(side_derivative(curve, u), normal);
        let next = u - value / slope;
        u = select(0.5 * (low + high), next, next > low && next < high);
    }
    return u;
}

// Finds the point between two shading vertices, of which one is visible.
fn find_point(point: u32, v0: u32, v1: u32) {
    let p0 = position_of(v0);
    let p1 = position_of(v1);
    let n0 = normal_of(v0);
    let n1 = normal_of(v1);
    let d0 = toward_viewer(p0);
    let d1 = toward_viewer(p1);
    // The bits decide, not what this stage's rounding makes of the same products.
    let visible = is_visible(v0);
    let a = select(min(dot(d0, n0), 0.0), max(dot(d0, n0), 0.0), visible);
    let c = select(max(dot(d1, n1), 0.0), min(dot(d1, n1), 0.0), visible);
    let feature = tables[settings.point_features_at + point];
    var curve: SideCurve;
    if feature == NONE {
        curve = unsplit(bridge(p0, p1, n0, n1));
    } else {
        curve = feature_curve(feature);
    }
    var root: f32;
    var u: f32;
    if settings.eye.w == 0.0 {
        root = linear_root(a, c);
        u = root;
    } else {
        root = refined(quadratic_root(a, dot(d0, n1) + dot(d1, n0), c), visible, n0, n1, curve);
        u = select(root, evened(root, a, c), settings.newton_steps > 0u);
    }
    var position = side_point(curve, u);
    var normal = mix(n0, n1, u);
    if u != root {
        normal = unit_or_zero(normal);
        let turned = across_view(normal, toward_viewer(position));
        if feature == NONE {
            position += way_beside(p1 - p0, n1 - n0, normal, turned);
        }
        normal = across_view(turned, toward_viewer(position));
    } else if length(normal) < LEAST_NORMAL {
        normal = cross(toward_viewer(position), p1 - p0);
    }
    state[settings.parameters_at + point] = bitcast<u32>(u);
    store_position(point_vertex(point), position);
    store_normal(point_vertex(point), unit_or_zero(normal));
}

@compute @workgroup_size(WORKGROUP)
fn find_points(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let point = element(id, groups);
    if point >= settings.points {
        return;
    }
    let half_edge = tables[settings.owners_at + point];
    let is_forward = runs_forward(side_word(half_edge));
    let begin = tables[half_edge];
    let end = tables[next_side(half_edge)];
    if is_visible(begin) != is_visible(end) {
        find_point(point, select(end, begin, is_forward), select(begin, end, is_forward));
    }
}
