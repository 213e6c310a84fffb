// Section III-D, second half: in each silhouette triangle the curve between its two points, how finely it is sampled, whether it
// is concave, and with that how many triangles the face becomes. Twin: crates/smoothing/src/silhouette_segments.rs

#import "shared/invocation.wgsl"
#import "smoothing/sampling.wgsl"
#import "smoothing/segment_record.wgsl"
#import "smoothing/triangle_count.wgsl"
#import "smoothing/sums.wgsl"

const SEGMENT_AS_PRINTED: u32 = 1u;

// The corner that differs from the two others in visibility; 3 if all are alike.
fn lone_corner(a: bool, b: bool, c: bool) -> u32 {
    if a == b {
        return select(2u, 3u, b == c);
    }
    return select(1u, 0u, b == c);
}

// A direction across both the normal and the view, on the side of `across`.
fn contour_direction(normal: vec3<f32>, view: vec3<f32>, across: vec3<f32>) -> vec3<f32> {
    let direction = cross(normal, view);
    return select(direction, -direction, dot(direction, across) < 0.0);
}

// The squared cosine of a direction and the chord in the image.
fn squared_cosine(direction: vec3<f32>, across: vec3<f32>) -> f32 {
    let cosine = dot(unit_or_zero(direction), unit_or_zero(across));
    return cosine * cosine;
}

fn segment_curve(start: u32, end: u32) -> Hermite {
    let p0 = position_of(start);
    let p1 = position_of(end);
    let in_space = bridge(p0, p1, normal_of(start), normal_of(end));
    if settings.segment_law == SEGMENT_AS_PRINTED {
        return in_space;
    }
    let chord = p1 - p0;
    let v0 = unit_or_zero(toward_viewer(p0));
    let v1 = unit_or_zero(toward_viewer(p1));
    let along = unit_or_zero(v0 + v1);
    let depth = dot(chord, along) * along;
    let across = chord - depth;
    let d0 = contour_direction(normal_of(start), v0, across);
    let d1 = contour_direction(normal_of(end), v1, across);
    let flat = hermite_along(vec3<f32>(0.0), across, d0, d1);
    // All of it up to 30 degrees between tangent and chord, nothing of it from 60 degrees on.
    let cosine = sqrt(min(squared_cosine(d0, across), squared_cosine(d1, across)));
    let share = smoothstep(0.5, sqrt(0.75), cosine);
    return Hermite(
        p0,
        p1,
        mix(in_space.leaving, flat.leaving + depth, share),
        mix(in_space.arriving, flat.arriving + depth, share),
    );
}

// Finds the segment of a silhouette triangle; yields its word.
fn find_segment(face: u32, lone: u32) -> u32 {
    let ends = segment_ends(face, lone);
    let curve = segment_curve(ends.x, ends.y);
    let n0 = normal_of(ends.x);
    let n1 = normal_of(ends.y);
    var pieces: u32;
    if settings.sampling_law == SAMPLING_AS_PRINTED {
        pieces = printed_segments(curve, n0, n1);
    } else {
        pieces = guaranteed_segments(curve);
    }
    // Section III-E: the plane holds the view.
    let chord = curve.end - curve.start;
    let toward = unit_or_zero(toward_viewer(hermite_point(curve, 0.5)));
    let normal = unit_or_zero(n0 + n1 - dot(n0 + n1, toward) * toward);
    let concave = dot(n0, chord) > 0.0 && dot(n1, chord) < 0.0 && any(normal != vec3<f32>(0.0));
    store_segment(face, curve, normal);
    return segment_word(pieces, lone, concave);
}

@compute @workgroup_size(WORKGROUP)
fn find_segments(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let face = element(id, groups);
    if face >= settings.faces {
        return;
    }
    let corners = vec3<u32>(tables[3u * face], tables[3u * face + 1u], tables[3u * face + 2u]);
    let lone = lone_corner(is_visible(corners.x), is_visible(corners.y), is_visible(corners.z));
    var word = 0u;
    if lone < 3u {
        word = find_segment(face, lone);
    }
    state[settings.segments_at + face] = word;
    if is_concave(word) {
        for (var slot = 0u; slot < 3u; slot++) {
            atomicStore(&at_concave[tables[settings.group_vertices_at + corners[slot]]], 1u);
        }
    }
    var counts = vec4<u32>(count_plain(pieces_of(word)), count_plain(min(pieces_of(word), 1u)));
    if has_feature(face) {
        counts = vec4<u32>(count_face(face, word, false), count_face(face, word, true));
    }
    sums[settings.features + face] = counts;
}
