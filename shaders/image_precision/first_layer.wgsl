// Draws every face as its id plus one, one byte per channel: integer formats cannot be multisampled.
// Twin: crates/image_precision/src/first_layer.rs

#import "shared/camera.wgsl"
#import "shared/mesh.wgsl"

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
