// Section III-E, adaptive sampling of feature segments: the points of one view at which each feature edge is bent. They are placed
// once, and all faces at the edge take them from there. Twin: crates/smoothing/src/feature_samples.rs

#import "shared/invocation.wgsl"
#import "smoothing/sampling.wgsl"
#import "smoothing/feature_curve.wgsl"
#import "smoothing/feature_sampling.wgsl"
#import "smoothing/sums.wgsl"

// Adds a silhouette point to a sorted list, unless one with its parameter is there; yields the length of the list.
fn insert_point(points_at: u32, points: u32, point: u32) -> u32 {
    let u = parameter_of(point);
    if is_at_point(points_at, points, u) {
        return points;
    }
    var at = points;
    while at > 0u && parameter_of(state[points_at + at - 1u]) > u {
        state[points_at + at] = state[points_at + at - 1u];
        at--;
    }
    state[points_at + at] = point;
    return points + 1u;
}

@compute @workgroup_size(WORKGROUP)
fn count_samples(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let feature = element(id, groups);
    if feature >= settings.features {
        return;
    }
    let first = tables[settings.first_feature_points_at + feature];
    let end = tables[settings.first_feature_points_at + feature + 1u];
    let points_at = settings.inner_points_at + first;
    var points = 0u;
    var any_visible = false;
    for (var i = first; i < end; i++) {
        let point = tables[settings.feature_points_at + i];
        let half_edge = tables[settings.owners_at + point];
        let begins_visible = is_visible(tables[half_edge]);
        let ends_visible = is_visible(tables[next_side(half_edge)]);
        any_visible |= begins_visible || ends_visible;
        let u = parameter_of(point);
        if begins_visible != ends_visible && u > 0.0 && u < 1.0 {
            points = insert_point(points_at, points, point);
        }
    }
    var pieces = vec2<u32>(1u, 0u);
    if any_visible {
        let curve = feature_curve(feature);
        pieces.x = guaranteed_segments(curve.first);
        if curve.is_split {
            pieces.y = guaranteed_segments(curve.second);
        }
    }
    var count = points;
    for (var i = 0u; i < regular_count(pieces); i++) {
        count += select(1u, 0u, is_at_point(points_at, points, regular_parameter(pieces, i)));
    }
    let at = settings.sampling_at + 3u * feature;
    state[at] = pieces.x | (pieces.y << 16u);
    state[at + 1u] = points;
    state[at + 2u] = count;
    sums[feature] = vec4<u32>(0u, count, 0u, points);
}

// Leaves each sample among the vertices, with its parameter in place of a normal.
@compute @workgroup_size(WORKGROUP)
fn place_samples(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let feature = element(id, groups);
    if feature >= settings.features {
        return;
    }
    let coarse = is_coarse();
    let sampling = feature_sampling(feature, coarse);
    let curve = feature_curve(feature);
    let first = point_vertex(settings.points) + sum_before(feature, coarse).y;
    var points = 0u;
    var regular = 0u;
    for (var i = 0u; i < sampling.count; i++) {
        var u = 2.0;
        var position = vec3<f32>(0.0);
        if points < sampling.points {
            let point = state[sampling.points_at + points];
            u = parameter_of(point);
            position = position_of(point_vertex(point));
        }
        var next = 2.0;
        if regular < regular_count(sampling.pieces) {
            next = regular_parameter(sampling.pieces, regular);
        }
        // A silhouette point at a regular parameter takes both places.
        points += select(0u, 1u, u <= next);
        regular += select(0u, 1u, next <= u);
        if next < u {
            u = next;
            position = side_point(curve, u);
        }
        store_position(first + i, position);
        store_normal(first + i, vec3<f32>(u, 0.0, 0.0));
    }
}
