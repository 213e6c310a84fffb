// Section III-A, second half: the curves of feature edges, for meshes whose vertices move on the device. Which edges they are, and
// how these are chained, stays as it is at rest. Twin: crates/smoothing/src/feature_segments.rs

#import "shared/invocation.wgsl"
#import "shared/mesh.wgsl"
#import "smoothing/feature_curve.wgsl"

const TANGENTS_AS_PRINTED: u32 = 1u;
const PI: f32 = 3.14159265;
// Where an end alone speaks for an arc above this, it is left straight: 340 degrees.
const LARGEST_ARC: f32 = 5.9341195;

// The unit tangent at the second of three consecutive vertices.
fn polyline_tangent(before: vec3<f32>, at: vec3<f32>, after: vec3<f32>) -> vec3<f32> {
    let w0 = unit_or_zero(at - before);
    let w1 = unit_or_zero(after - at);
    var sum = w0 + w1;
    if settings.tangent_law != TANGENTS_AS_PRINTED {
        // Each over its squared length, times both lengths.
        sum = w0 * distance(at, after) + w1 * distance(before, at);
    }
    // Where the polyline turns back on itself, or two vertices coincide, an edge's own direction remains.
    let tangent = unit_or_zero(sum);
    return select(select(w1, w0, any(w0 != vec3<f32>(0.0))), tangent, any(tangent != vec3<f32>(0.0)));
}

// The tangent of the same circle at the other end of a chord.
fn reflected_tangent(tangent: vec3<f32>, chord: vec3<f32>) -> vec3<f32> {
    let along = unit_or_zero(chord);
    return select(2.0 * dot(tangent, along) * along - tangent, tangent, all(along == vec3<f32>(0.0)));
}

fn angle_between(a: vec3<f32>, b: vec3<f32>) -> f32 {
    return atan2(length(cross(a, b)), dot(a, b));
}

// The curve between two points along two unit tangents.
fn arc(start: vec3<f32>, end: vec3<f32>, t0: vec3<f32>, t1: vec3<f32>) -> SideCurve {
    let chord = end - start;
    let angles = vec2<f32>(angle_between(chord, t0), angle_between(chord, t1));
    let central = angles.x + angles.y;
    if !all(2.0 * angles <= vec2<f32>(LARGEST_ARC)) {
        return unsplit(hermite_along(start, end, vec3<f32>(0.0), vec3<f32>(0.0)));
    }
    let outward = unit_or_zero(t0 - t1);
    if !(central > PI) || all(outward == vec3<f32>(0.0)) {
        return unsplit(hermite_along(start, end, t0, t1));
    }
    let middle = start + 0.5 * chord + 0.5 * length(chord) * tan(0.25 * central) * outward;
    return SideCurve(hermite_along(start, middle, t0, chord), hermite_along(middle, end, chord, t1), true);
}

@compute @workgroup_size(WORKGROUP)
fn find_curves(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let feature = element(id, groups);
    if feature >= settings.features {
        return;
    }
    let at = settings.feature_ends_at + 4u * feature;
    let start = vertex_position(tables[at]);
    let end = vertex_position(tables[at + 1u]);
    let before = tables[at + 2u];
    let after = tables[at + 3u];
    if before == NONE && after == NONE {
        store_feature_curve(feature, unsplit(hermite_along(start, end, vec3<f32>(0.0), vec3<f32>(0.0))));
        return;
    }
    var t0 = vec3<f32>(0.0);
    var t1 = vec3<f32>(0.0);
    if before != NONE {
        t0 = polyline_tangent(vertex_position(before), start, end);
    }
    if after != NONE {
        t1 = polyline_tangent(start, end, vertex_position(after));
    }
    if before == NONE {
        t0 = reflected_tangent(t1, end - start);
    }
    if after == NONE {
        t1 = reflected_tangent(t0, end - start);
    }
    store_feature_curve(feature, arc(start, end, t0, t1));
}
