// Every face as its number plus one, a byte a channel: formats of whole numbers have one sample a pixel. Twin: crates/image_precision/src/unoriented.rs

struct NumberedVertex {
    @invariant @builtin(position) position: vec4<f32>,
    @location(0) @interpolate(flat) number: u32,
}

@vertex
fn numbered_vertex(@builtin(vertex_index) index: u32) -> NumberedVertex {
    return NumberedVertex(clip_position(corner_position(index)), index / 3u + 1u);
}

@fragment
fn number_fragment(in: NumberedVertex) -> @location(0) vec4<f32> {
    return unpack4x8unorm(in.number);
}
