// Parameters at which a feature edge is bent: regular ones and those of silhouette points inside it, each once. All faces at the
// edge read the same. Twin: crates/smoothing/src/feature_samples.rs

#import "smoothing/frame.wgsl"

struct FeatureSampling {
    // Pieces of the two cubics; the second number is 0 where there is one cubic. No regular parameter for 1 and 0.
    pieces: vec2<u32>,
    // Silhouette points inside, no two at the same parameter: entries of `inner_points_at` from here on.
    points_at: u32,
    points: u32,
    // How many parameters there are in all.
    count: u32,
}

fn feature_sampling(feature: u32, coarse: bool) -> FeatureSampling {
    let at = settings.sampling_at + 3u * feature;
    let points_at = settings.inner_points_at + tables[settings.first_feature_points_at + feature];
    let points = state[at + 1u];
    if coarse {
        return FeatureSampling(vec2<u32>(1u, 0u), points_at, points, points);
    }
    return FeatureSampling(vec2<u32>(state[at] & 0xffffu, state[at] >> 16u), points_at, points, state[at + 2u]);
}

fn regular_count(pieces: vec2<u32>) -> u32 {
    return pieces.x + pieces.y - 1u;
}

// The regular parameters, ascending.
fn regular_parameter(pieces: vec2<u32>, index: u32) -> f32 {
    let piece = index + 1u;
    if pieces.y == 0u {
        return f32(piece) / f32(pieces.x);
    }
    if piece < pieces.x {
        return 0.5 * (f32(piece) / f32(pieces.x));
    }
    return 0.5 * (1.0 + f32(piece - pieces.x) / f32(pieces.y));
}

fn parameter_of(point: u32) -> f32 {
    return bitcast<f32>(state[settings.parameters_at + point]);
}

// Whether a silhouette point inside has this parameter.
fn is_at_point(points_at: u32, points: u32, u: f32) -> bool {
    for (var i = 0u; i < points; i++) {
        if parameter_of(state[points_at + i]) == u {
            return true;
        }
    }
    return false;
}

// How many parameters of a feature edge lie before u.
fn rank_of(feature: u32, u: f32, coarse: bool) -> u32 {
    let sampling = feature_sampling(feature, coarse);
    var rank = 0u;
    for (var i = 0u; i < sampling.points; i++) {
        rank += select(0u, 1u, parameter_of(state[sampling.points_at + i]) < u);
    }
    for (var i = 0u; i < regular_count(sampling.pieces); i++) {
        let regular = regular_parameter(sampling.pieces, i);
        if regular < u && !is_at_point(sampling.points_at, sampling.points, regular) {
            rank++;
        }
    }
    return rank;
}
