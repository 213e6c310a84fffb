// Lines as wide as asked for, expanded in the image plane. Twin: crates/image_precision/src/screen.rs

#import "shared/camera.wgsl"
#import "shared/line_polygon.wgsl"
#import "shared/mesh.wgsl"
#import "image_precision/style.wgsl"
#import "image_precision/front_mark.wgsl"
#import "image_precision/ink.wgsl"

@group(2) @binding(0) var<storage, read> listed: array<u32>;

struct LineVertex {
    @builtin(position) position: vec4<f32>,
    @location(0) @interpolate(flat) level: u32,
}

fn line_vertex(vertex: u32, from_clip: vec4<f32>, to_clip: vec4<f32>) -> LineVertex {
    let shape = style.line.shape;
    let rim = style.line.rim[rim_point(vertex, shape)].xy;
    let point = line_point(vertex, from_clip, to_clip, shape, rim);
    return LineVertex(point.position, is_level(point.way));
}

@vertex
fn line_of_edge(@builtin(vertex_index) index: u32) -> LineVertex {
    let vertices = vertices_per_line(style.line.shape);
    let edge = listed[index / vertices];
    let corner = edge & ~FRONT;
    let a = corner_position(corner);
    let b = corner_position(next_corner(corner));
    // A back face lies to the right of its edges in the image, so that left is outwards; a front face, and a back face of a view
    // that mirrors, to the left.
    let swaps = ((edge & FRONT) != 0u) != (style.turned != 0u);
    let begin = clip_position(select(a, b, swaps));
    return line_vertex(index % vertices, begin, clip_position(select(b, a, swaps)));
}

// Lines given by pairs of vertices, one after another.
@vertex
fn line_of_pair(@builtin(vertex_index) index: u32) -> LineVertex {
    let vertices = vertices_per_line(style.line.shape);
    let pair = 2u * (index / vertices);
    let begin = clip_position(vertex_position(listed[pair]));
    return line_vertex(index % vertices, begin, clip_position(vertex_position(listed[pair + 1u])));
}

@fragment
fn textured_fragment(in: LineVertex) -> @location(0) vec4<f32> {
    if is_blank(in.level, in.position.xy) {
        discard;
    }
    return faded_ink(1.0 / in.position.w);
}
