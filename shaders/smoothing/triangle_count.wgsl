// How many triangles and vertices a face becomes. Twin: crates/smoothing/src/remeshing.rs

#import "smoothing/segment_record.wgsl"
#import "smoothing/sides.wgsl"

// Of a silhouette triangle whose segment has some pieces.
fn count_silhouette(face: u32, lone: u32, pieces: u32, coarse: bool) -> vec2<u32> {
    let leaving = bent_side(3u * face + lone, true, coarse, 0u);
    let opposite = bent_side(3u * face + (lone + 1u) % 3u, false, coarse, 0u);
    let returning = bent_side(3u * face + (lone + 2u) % 3u, true, coarse, 0u);
    let own = own_vertices(leaving) + own_vertices(opposite) + own_vertices(returning);
    var added = vec2<u32>(0u, own + pieces - 1u);
    if is_plain_fan(leaving, returning) {
        added.x += pieces;
    } else {
        added += vec2<u32>(1u + leaving.silhouette_at + pieces + after_silhouette(returning), 1u);
    }
    if is_plain_strip(leaving, opposite, returning) {
        added.x += pieces + 1u;
    } else {
        let around = after_silhouette(leaving) + side_length(opposite) + returning.silhouette_at;
        added += vec2<u32>(around + pieces + 2u, 1u);
    }
    return added;
}

// Of a face without a silhouette.
fn count_bent(face: u32, coarse: bool) -> vec2<u32> {
    var bends = 0u;
    var bent_sides = 0u;
    for (var slot = 0u; slot < 3u; slot++) {
        let own = own_vertices(bent_side(3u * face + slot, false, coarse, 0u));
        bends += own;
        bent_sides += select(0u, 1u, own > 0u);
    }
    if bends == 0u {
        return vec2<u32>(1u, 0u);
    }
    return vec2<u32>(3u + bends, bends + select(0u, 1u, bent_sides > 1u));
}

// Of a face without feature edges: the face itself, or a fan and a strip.
fn count_plain(pieces: u32) -> vec2<u32> {
    return select(vec2<u32>(2u * pieces + 1u, pieces - 1u), vec2<u32>(1u, 0u), pieces == 0u);
}

// Of any face.
fn count_face(face: u32, word: u32, coarse: bool) -> vec2<u32> {
    if pieces_of(word) == 0u {
        return count_bent(face, coarse);
    }
    return count_silhouette(face, lone_of(word), select(pieces_of(word), 1u, coarse), coarse);
}
