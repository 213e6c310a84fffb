// The sides of a face, bent at the samples of a feature edge or at a silhouette point. Twin: crates/smoothing/src/remeshing.rs

#import "smoothing/frame.wgsl"
#import "smoothing/feature_sampling.wgsl"

// The vertices strictly inside a side, in the direction of its half-edge. Where the silhouette point falls on an end, that corner
// is among them.
struct Side {
    // Shading vertices at the ends.
    begin: u32,
    end: u32,
    // Whether the first is that at the beginning, and the last that at the end.
    leads: u32,
    trails: u32,
    // The others, in a row.
    first: u32,
    inner: u32,
    // Which of all is the face's silhouette point.
    silhouette_at: u32,
    // NONE, or the feature edge and whether the side runs as its parameters do.
    feature: u32,
    is_forward: bool,
    // The face's silhouette point, or NONE.
    point: u32,
}

fn side_length(side: Side) -> u32 {
    return side.leads + side.inner + side.trails;
}

fn side_vertex(side: Side, index: u32) -> u32 {
    if index < side.leads {
        return side.begin;
    }
    return select(side.first + index - side.leads, side.end, index - side.leads >= side.inner);
}

// Bends from the silhouette point on, beginning with it.
fn after_silhouette(side: Side) -> u32 {
    return side_length(side) - side.silhouette_at;
}

// The share of a parameter in the direction of the side.
fn share_of(side: Side, u: f32) -> f32 {
    return select(1.0 - u, u, side.is_forward);
}

// A side, with or without a silhouette point on it. `first` is the first vertex that it may take for itself.
fn bent_side(half_edge: u32, has_point: bool, coarse: bool, first: u32) -> Side {
    let word = side_word(half_edge);
    let point = side_point_of(word);
    let is_forward = runs_forward(word);
    let feature = tables[settings.point_features_at + point];
    var side = Side(tables[half_edge], tables[next_side(half_edge)], 0u, 0u, first, 0u, 0u, feature, is_forward, NONE);
    let u = parameter_of(point);
    let at_begin = has_point && select(u >= 1.0, u <= 0.0, is_forward);
    let at_end = has_point && select(u <= 0.0, u >= 1.0, is_forward);
    if has_point {
        side.point = point;
        side.leads = select(0u, 1u, at_begin);
        side.trails = select(0u, 1u, at_end);
    }
    if feature == NONE {
        // The point itself is the only bend, and both faces share it.
        side.first = point_vertex(point);
        side.inner = select(0u, 1u, has_point && !at_begin && !at_end);
        return side;
    }
    side.inner = feature_sampling(feature, coarse).count;
    if at_end {
        side.silhouette_at = side.inner;
    } else if has_point && !at_begin {
        let rank = rank_of(feature, u, coarse);
        side.silhouette_at = select(side.inner - 1u - rank, rank, is_forward);
    }
    return side;
}

// Whether a side of a face is a feature edge.
fn has_feature(face: u32) -> bool {
    return is_feature(side_word(3u * face) | side_word(3u * face + 1u) | side_word(3u * face + 2u));
}

// Vertices that a side takes for itself.
fn own_vertices(side: Side) -> u32 {
    return select(side.inner, 0u, side.feature == NONE);
}

// Whether the part of the lone corner is a fan from that corner, given the sides that leave it and return to it.
fn is_plain_fan(leaving: Side, returning: Side) -> bool {
    return leaving.silhouette_at == 0u && after_silhouette(returning) == 1u;
}

// Whether the part of the two other corners is a strip along their side.
fn is_plain_strip(leaving: Side, opposite: Side, returning: Side) -> bool {
    return after_silhouette(leaving) == 1u && side_length(opposite) == 0u && returning.silhouette_at == 0u;
}
