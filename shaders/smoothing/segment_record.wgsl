// What a frame knows of the silhouette segment of each face. Twin: crates/smoothing/src/silhouette_segments.rs

#import "smoothing/frame.wgsl"
#import "smoothing/hermite.wgsl"

// In a word: number of pieces, 0 without a segment; which corner differs from
// the others in visibility; whether it is concave.
fn segment_word(pieces: u32, lone: u32, concave: bool) -> u32 {
    return pieces | (lone << 8u) | select(0u, 1u << 10u, concave);
}

fn pieces_of(word: u32) -> u32 {
    return word & 0xffu;
}

fn lone_of(word: u32) -> u32 {
    return (word >> 8u) & 3u;
}

fn is_concave(word: u32) -> bool {
    return (word & (1u << 10u)) != 0u;
}

fn load_data(at: u32) -> vec3<f32> {
    return vec3<f32>(bitcast<f32>(state[at]), bitcast<f32>(state[at + 1u]), bitcast<f32>(state[at + 2u]));
}

fn store_data(at: u32, v: vec3<f32>) {
    state[at] = bitcast<u32>(v.x);
    state[at + 1u] = bitcast<u32>(v.y);
    state[at + 2u] = bitcast<u32>(v.z);
}

// Keeps the tangents of a face's segment, and the unit normal of its blocking plane or 0.
fn store_segment(face: u32, curve: Hermite, normal: vec3<f32>) {
    let at = settings.segment_data_at + 9u * face;
    store_data(at, curve.leaving);
    store_data(at + 3u, curve.arriving);
    store_data(at + 6u, normal);
}

// Where the first and the second silhouette point of a face lie among the vertices.
fn segment_ends(face: u32, lone: u32) -> vec2<u32> {
    let leaving = side_point_of(side_word(3u * face + lone));
    let returning = side_point_of(side_word(3u * face + (lone + 2u) % 3u));
    return vec2<u32>(point_vertex(leaving), point_vertex(returning));
}

fn load_segment(face: u32, lone: u32) -> Hermite {
    let ends = segment_ends(face, lone);
    let at = settings.segment_data_at + 9u * face;
    return Hermite(position_of(ends.x), position_of(ends.y), load_data(at), load_data(at + 3u));
}

fn blocking_normal(face: u32) -> vec3<f32> {
    return load_data(settings.segment_data_at + 9u * face + 6u);
}
